use super::sensor::sensor;
use super::solid::{rows, solid};
use crate::wire::{AxisView, ConditionView, FrameView, JointView, MachineView, UserFrameView, ZoneView};
use glam::{DQuat, DVec3};
use seamwright_executive::{REDUCED_MM_S, REDUCED_RAD_S};
use seamwright_geometry::Pose;
use seamwright_machine::{AxisKind, Joints, Machine, Target, ZoneKind};
use seamwright_motion::jog::TipFrame;

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
        tool: rows(&machine.tool_frame(&Joints::default())),
        up: machine.up.to_array(),
        jog_mm_s: REDUCED_MM_S,
        jog_deg_s: REDUCED_RAD_S.to_degrees(),
        turns: turns(machine),
        arm: machine.arm_configuration(&machine.home()).is_some(),
        user_frames: user_frames(machine),
        joints: joints(machine),
        sensors: machine.sensors.iter().map(sensor).collect(),
        beam: machine.deflection.is_some(),
        beam_mm: machine.deflection.map(|d| d.pivot_mm),
    }
}

/// Returns the user frames.
pub(crate) fn user_frames(machine: &Machine) -> Vec<UserFrameView> {
    let frames = machine.user_frames.iter();
    frames.map(|f| UserFrameView { name: f.name.clone(), frame: rows(&f.in_base) }).collect()
}

/// Angle of a trial turn about the tip, rad, and maximum miss of the torch's direction if the machine can turn so.
const TRIAL_TURN: f64 = 0.02;
const TRIAL_MISS: f64 = 1e-6;

/// Returns about which axes of the tool frame the torch can be turned about its tip.
fn turns(machine: &Machine) -> [bool; 3] {
    let home = machine.home();
    let start = machine.forward(&home);
    let tried = |about: DVec3| {
        let turn = DQuat::from_axis_angle(TipFrame::Torch.to_work(machine, &home, about), TRIAL_TURN);
        let target = Target::from(Pose { direction: turn * start.direction, ..start });
        machine.inverse_near(target, &home).is_ok_and(|found| {
            let moved = machine.forward(&found.joints);
            found.attitude_error < TRIAL_MISS && moved.point.distance(start.point) < 1e-3
        })
    };
    [tried(DVec3::X), tried(DVec3::Y), machine.has_free_roll()]
}

fn joints(machine: &Machine) -> Vec<Option<JointView>> {
    let view = |link| {
        let joint = machine.links.joint(link)?;
        let (direction, at) = (joint.direction.to_array(), joint.at.to_array());
        Some(JointView { on: joint.on, axis: joint.axis, direction, at })
    };
    (0..machine.links.count()).map(view).collect()
}

/// Returns the axes, in the units of their file.
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

#[cfg(test)]
mod tests {
    use super::machine_view;
    use glam::{DAffine3, DQuat, DVec3};

    /// An arm turns its torch about all axes of the tool frame, five axes about two, a plane machine about none.
    #[test]
    fn turns_about_the_tip_are_those_that_the_axes_can_make() {
        let turns = |name: &str| {
            let shipped = SHIPPED.iter().find(|s| s.name == name).unwrap();
            machine_view(&Machine::read("m.toml", shipped.text).unwrap()).turns
        };
        for arm in ["ur10e", "irb-2600", "kr-16-positioner", "irb-2600-rail", "iiwa-14"] {
            assert_eq!(turns(arm), [true; 3], "{arm}");
        }
        assert_eq!(turns("torch-5axis"), [true, true, false]);
        assert_eq!(turns("ellipse-xy"), [false; 3]);
    }

    use seamwright_machine::{AxisKind, Joints, Machine, SHIPPED};

    /// Joints of the view move the links to the same poses as the machine.
    #[test]
    fn joints_move_the_links_as_the_machine_does() {
        for shipped in SHIPPED {
            let machine = Machine::read("m.toml", shipped.text).unwrap();
            let view = machine_view(&machine);
            assert_eq!(view.joints.len(), machine.links.count());
            for n in 0..50 {
                let mut q = Joints::default();
                let axes = q.iter_mut().take(machine.axes.len()).enumerate();
                axes.for_each(|(i, q)| *q = 3.0 * f64::from(n).mul_add(1.7, i as f64 * 0.9).sin());
                let wanted = machine.links.motion(&q);
                let mut frames: Vec<DAffine3> = Vec::new();
                for joint in &view.joints {
                    let frame = joint.as_ref().map_or(DAffine3::IDENTITY, |j| {
                        let (direction, at) = (DVec3::from(j.direction), DVec3::from(j.at));
                        frames[j.on]
                            * if machine.axes[j.axis].kind == AxisKind::Linear {
                                DAffine3::from_translation(q[j.axis] * direction)
                            } else {
                                let turn = DQuat::from_axis_angle(direction, q[j.axis]);
                                DAffine3::from_rotation_translation(turn, at - turn * at)
                            }
                    });
                    frames.push(frame);
                }
                let same = frames.iter().zip(&wanted).all(|(a, b)| a.abs_diff_eq(*b, 1e-9));
                assert!(same, "{}", shipped.name);
            }
        }
    }

    /// The electron-beam machine's picture has a width of 512 pixels of 0.1 mm, around the point where the beam meets
    /// the work.
    #[test]
    fn a_camera_sees_a_square_of_the_work() {
        let beam = SHIPPED.iter().find(|s| s.name == "ebw-7axis").unwrap();
        let view = machine_view(&Machine::read("m.toml", beam.text).unwrap());
        assert_eq!(view.beam_mm, Some(260.0));
        let field = &view.sensors[0].field;
        let corners: Vec<DVec3> = field.iter().map(|p| DVec3::from(*p)).collect();
        for (i, corner) in corners.iter().enumerate() {
            assert!((corner.distance(corners[(i + 1) % 4]) - 51.1).abs() < 1e-6, "{field:?}");
            assert!(corner.z.abs() < 1e-6 && corner.x.abs() < 26.0 && corner.y.abs() < 26.0, "{field:?}");
        }
    }
}
