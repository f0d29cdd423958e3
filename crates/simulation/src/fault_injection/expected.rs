use super::case::{Case, Situation};
use crate::devices::fault::{Device, FaultKind};
use seamwright_executive::{Alarm, Mode};

/// Required result of a permanent fault.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Expected {
    /// Mode some seconds later.
    pub mode: Mode,
    /// First alarm, if any.
    pub alarm: Option<Alarm>,
}

/// Returns the required result of a case: written by hand from the purpose of the alarms, not from the code.
pub fn expected(case: Case) -> Expected {
    use Situation as S;
    let s = case.situation;
    // Mode without the fault: a transient situation is over by then.
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
        // A cell needs drives that answer.
        (Device::Drives, FaultKind::Wrong) if powered => fault(Alarm::FollowingError),
        (Device::Drives, FaultKind::Wrong) => nothing,
        (Device::Drives, _) => fault(Alarm::DrivesSilent),
        (Device::Source, FaultKind::Slow) => nothing,
        // If extinction is not confirmed, treat the arc as lit.
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
        // Reported off while lit, the arc is lost; reported on while off, it is stuck on.
        (Device::Source, FaultKind::Wrong) if lit => fault(Alarm::ArcLost),
        (Device::Source, FaultKind::Wrong) => fault(Alarm::ProcessStuckOn),
        // Sensors are needed only in a pass, and short gaps are bridged. A dry run is held like a weld: it would miss
        // the joint too.
        (Device::Sensors, FaultKind::Slow | FaultKind::Reboot | FaultKind::Reconnect) => nothing,
        (Device::Sensors, _) if s == S::DryRun || s.welds() && s != S::Crater => hold(Alarm::Tracking),
        (Device::Sensors, _) => nothing,
        // Late set-points stop the cell.
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
