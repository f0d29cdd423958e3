use super::case::{Case, Situation};
use crate::devices::{Device, FaultKind};
use crate::executive::{Alarm, Mode};

/// What must follow from a fault that lasts.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Expected {
    /// The mode some seconds later.
    pub mode: Mode,
    /// The alarm that comes first, if any.
    pub alarm: Option<Alarm>,
}

/// What must follow from a case: written down by hand from what the alarms are for, not from the code.
pub fn expected(case: Case) -> Expected {
    use Situation as S;
    let s = case.situation;
    // Where the cell would be without the fault: a situation that passes by itself is over by then.
    let undisturbed = match s {
        S::Off => Mode::Off,
        S::Idle => Mode::Idle,
        S::Homing | S::Ready => Mode::Ready,
        S::Jog => Mode::Jog,
        S::DryRun => Mode::DryRun,
        S::Approach | S::Preflow | S::Strike | S::Travel | S::Crater => Mode::Weld,
        S::Hold => Mode::Hold,
        S::Fault => Mode::Fault,
    };
    let powered = !matches!(s, S::Off | S::Fault);
    let nothing = Expected { mode: undisturbed, alarm: None };
    let fault = |alarm| Expected { mode: Mode::Fault, alarm: Some(alarm) };
    let hold = |alarm| Expected { mode: Mode::Hold, alarm: Some(alarm) };
    let told = |alarm| Expected { mode: undisturbed, alarm: Some(alarm) };
    let lit = matches!(s, S::Strike | S::Travel | S::Crater);
    let moves = matches!(s, S::Homing | S::Jog | S::DryRun) || s.welds();
    match (case.device, case.kind) {
        // Without drives that answer there is no cell.
        (Device::Drives, FaultKind::Wrong) if powered => fault(Alarm::FollowingError),
        (Device::Drives, FaultKind::Wrong) => nothing,
        (Device::Drives, _) => fault(Alarm::DrivesSilent),
        (Device::Source, FaultKind::Slow) => nothing,
        // An arc of which nobody says that it went out may burn.
        (Device::Source, FaultKind::Silent | FaultKind::Disconnect | FaultKind::Reboot | FaultKind::Reconnect)
            if lit =>
        {
            fault(Alarm::SourceSilent)
        }
        (Device::Source, FaultKind::Silent | FaultKind::Disconnect | FaultKind::Reboot | FaultKind::Reconnect)
            if s.welds() =>
        {
            hold(Alarm::SourceSilent)
        }
        (Device::Source, FaultKind::Silent | FaultKind::Disconnect | FaultKind::Reconnect) => nothing,
        (Device::Source, FaultKind::Reboot) => told(Alarm::SourceRestarted),
        // An arc that is said to be out is lost; said to be on when it must be off, it is stuck.
        (Device::Source, FaultKind::Wrong) if lit => fault(Alarm::ArcLost),
        (Device::Source, FaultKind::Wrong) => fault(Alarm::ProcessStuckOn),
        // Nobody needs them beside a pass, and short gaps are bridged. A dry run is held as a weld is: it misses the joint too.
        (Device::Sensors, FaultKind::Slow | FaultKind::Reboot | FaultKind::Reconnect) => nothing,
        (Device::Sensors, _) if s == S::DryRun || s.welds() && s != S::Crater => hold(Alarm::Tracking),
        (Device::Sensors, _) => nothing,
        // Set-points that come too late are none.
        (Device::Cycle, _) if powered => fault(Alarm::Overrun),
        (Device::Cycle, _) => told(Alarm::Overrun),
        (Device::Inputs, FaultKind::Slow) => nothing,
        (Device::Inputs, FaultKind::Wrong) => match case.which {
            0 if powered => fault(Alarm::Interlock),
            1 if moves => fault(Alarm::Interlock),
            2 if s.welds() => hold(Alarm::Interlock),
            _ => nothing,
        },
        (Device::Inputs, _) if powered => fault(Alarm::InputsSilent),
        (Device::Inputs, FaultKind::Reboot) => told(Alarm::InputsRestarted),
        (Device::Inputs, _) => nothing,
    }
}
