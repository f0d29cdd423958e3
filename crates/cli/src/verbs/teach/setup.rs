use crate::args::teach::TeachArgs;
use crate::refusals::{between, not_allowed, of_option};
use crate::verbs::positive;
use glam::DVec3;
use seamwright_geometry::HeightTable;
use seamwright_machine::{Machine, Sensor};
use seamwright_message::Message;
use seamwright_project::failure::Failure;
use seamwright_teaching::{self as teaching, CameraPose, JointFollower, SeamLine, Settings};
use std::ops::RangeInclusive;

/// Minimum and maximum step from frame to frame, mm: longer ones leave the frame.
pub(super) const STEPS_MM: RangeInclusive<f64> = 1.0..=100.0;

pub(super) fn within(name: &str, value: f64, allowed: RangeInclusive<f64>) -> Result<f64, Failure> {
    if allowed.contains(&value) {
        return Ok(value);
    }
    Err(not_allowed(name, value, between(*allowed.start(), *allowed.end())))
}

pub(super) fn camera<'a>(args: &TeachArgs, machine: &'a Machine) -> Result<(&'a Sensor, &'a HeightTable), Failure> {
    let cameras: Vec<_> = machine.cameras().collect();
    let names = || cameras.iter().map(|(s, _)| s.name.as_str()).collect::<Vec<_>>().join(", ");
    let refuse = |message: Message| {
        let allowed =
            if cameras.is_empty() { Message::new("cli-teach-camera-machine") } else { Message::verbatim(names()) };
        Err(Failure::refused(message, allowed))
    };
    let fault = |code| Message::new(code).text("machine", &machine.name);
    match (&args.sensor, cameras.as_slice()) {
        (Some(name), _) => match cameras.iter().find(|(s, _)| &s.name == name) {
            Some(found) => Ok(*found),
            None => refuse(of_option(format!("--sensor {name}"), fault("cli-teach-no-such-camera"))),
        },
        (None, [one]) => Ok(*one),
        (None, []) => refuse(fault("cli-teach-no-camera")),
        (None, _) => refuse(fault("cli-teach-several-cameras")),
    }
}

/// Settings of the joint following along this seam.
pub(super) fn settings(args: &TeachArgs, nominal: &SeamLine) -> Result<Settings, Failure> {
    Ok(teaching::settings(nominal, within("--step-mm", args.step_mm, STEPS_MM)?))
}

pub(super) fn follower(args: &TeachArgs, table: &HeightTable) -> Result<JointFollower, Failure> {
    Ok(teaching::follower(table, positive("--longest-tack-mm", args.longest_tack_mm)?)?)
}

/// Start of the joint following: at `point`, in the direction of the nominal seam nearby unless the command line gives
/// another.
pub(super) fn start(args: &TeachArgs, nominal: &SeamLine, point: DVec3) -> Result<CameraPose, Failure> {
    let vector = |name: &str, given: &Option<Vec<f64>>| match given.as_deref() {
        None => Ok(None),
        Some([x, y, z]) => Ok(Some(DVec3::new(*x, *y, *z))),
        Some(other) => {
            let fault = Message::new("cli-teach-numbers").count("n", other.len());
            Err(Failure::refused(of_option(name, fault), Message::new("cli-teach-three-numbers")))
        }
    };
    let point = vector("--start", &args.start)?.unwrap_or(point);
    let far = || {
        let start = format!("({:.3}, {:.3}, {:.3})", point.x, point.y, point.z);
        let message = Message::new("cli-teach-start-off-seam").text("start", start);
        Failure::refused(message, Message::new("cli-teach-start-near"))
    };
    let begin = teaching::start(nominal, point).ok_or_else(far)?;
    let along = match vector("--direction", &args.direction)? {
        Some(way) => way.try_normalize().ok_or_else(|| {
            let message = of_option("--direction", Message::new("cli-direction-without-length"));
            Failure::refused(message, Message::new("cli-three-finite-numbers"))
        })?,
        None => begin.along,
    };
    Ok(CameraPose { along, ..begin })
}
