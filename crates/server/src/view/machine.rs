use super::solid::{rows, solid};
use crate::wire::{AxisView, ConditionView, FrameView, MachineView, ZoneView};
use seamwright_cell::executive::REDUCED_MM_S;
use seamwright_machine::{AxisKind, Machine, ZoneKind};

/// The machine of the cell.
pub(crate) fn machine_view(machine: &Machine) -> MachineView {
    let conditions = machine.interlocks.iter();
    let zones = machine.solids.zones.iter().map(|zone| ZoneView {
        name: zone.name.clone(),
        permitted: zone.kind == ZoneKind::Permitted,
        solids: zone.solids.iter().map(|s| solid(s, zone.link)).collect(),
    });
    let frames = machine.links.named().iter();
    let torch = &machine.heads[0].name;
    MachineView {
        name: machine.name.clone(),
        title: machine.title.clone(),
        simulated: machine.devices.is_empty(),
        period_s: machine.servo_period_s,
        axes: axes(machine),
        conditions: conditions
            .map(|c| ConditionView { name: c.name.clone(), level: c.level.name().to_owned() })
            .collect(),
        solids: machine.solids.solids.iter().map(|(link, s)| solid(s, *link)).collect(),
        zones: zones.collect(),
        frames: frames.map(|f| FrameView { name: f.name.clone(), link: f.link, frame: rows(&f.zero) }).collect(),
        base: machine.links.base(),
        torch: machine.links.frame(torch).map_or(0, |f| f.link),
        up: machine.up.to_array(),
        jog_mm_s: REDUCED_MM_S,
        sensors: machine.sensors.iter().map(|s| s.name.clone()).collect(),
        beam: machine.deflection.is_some(),
    }
}

/// Its axes, as their file says them.
pub(super) fn axes(machine: &Machine) -> Vec<AxisView> {
    let view = |axis: &seamwright_machine::Axis| AxisView {
        name: axis.name.clone(),
        unit: if axis.kind == AxisKind::Rotary { "deg" } else { "mm" }.to_owned(),
        range: axis.range.map(|(from, to)| (axis.to_file(from), axis.to_file(to))),
        home: axis.to_file(axis.home),
        max_speed: axis.to_file(axis.max_speed),
    };
    machine.axes.iter().map(view).collect()
}
