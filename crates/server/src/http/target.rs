//! Typed targets of motion by hand: found, and the motion to them computed in advance. Nothing moves here.

use super::answer::{Answer, Refused};
use super::jog::frame;
use super::panel::{Panel, Shared};
use crate::view::arm_view;
use crate::wire::{TargetAnswer, TargetText, TipTarget};
use axum::Json;
use axum::extract::State;
use glam::{DAffine3, DQuat, DVec3};
use seamwright_geometry::Pose;
use seamwright_machine::{Joints, Machine, Target};
use seamwright_message::Message;
use seamwright_motion::jog::{Halt, JogError};

/// Number of positions of the motion that are drawn and searched for the nearest pair.
const SAMPLES: usize = 60;
/// Maximum coordinate of a target, mm.
const FARTHEST_MM: f64 = 1e5;

pub(super) async fn check(State(panel): Shared, Json(asked): Json<TargetText>) -> Answer<TargetAnswer> {
    panel.run(|panel| &panel.drawing, move |panel| answer(panel, &asked)).await.map(Json)
}

fn answer(panel: &Panel, asked: &TargetText) -> Result<TargetAnswer, Refused> {
    let hub = &panel.cell.hub;
    let known = hub.machine().zip(hub.set_points());
    let (machine, start) = known.ok_or_else(|| Refused::input(Message::new("server-positions-unknown")))?;
    let (target, tilt_error_deg) = match (&asked.axes, &asked.tip) {
        (Some(axes), None) => (typed_axes(&machine, axes)?, 0.0),
        (None, Some(tip)) => match placed_tip(&machine, tip, &start)? {
            Ok(found) => found,
            Err(reason) => return Ok(unreached(reason)),
        },
        _ => return Err(Refused::input(Message::new("server-target-one"))),
    };
    let around = hub.around();
    let foreseen = match &around {
        Some(around) => around.foresee(&start, &target, SAMPLES),
        None => seamwright_executive::foresee(&machine, None, &start, &target, SAMPLES),
    };
    let foreseen = match foreseen {
        Ok(foreseen) => foreseen,
        Err(error) => return Ok(unreached(error.message())),
    };
    let in_file = |q: &Joints| machine.axes.iter().zip(q).map(|(axis, q)| axis.to_file(*q)).collect::<Vec<f64>>();
    let room = |near: &crate::wire::NearView| near.distance_mm - near.least_mm;
    let near = foreseen.way.iter().filter_map(|q| around.as_ref()?.near(q));
    Ok(TargetAnswer {
        axes: in_file(&target),
        refused: foreseen.halt.map(|halt| halted(&machine, halt).into()),
        stops: foreseen.halt.and(foreseen.way.last()).map(in_file),
        time_s: foreseen.time_s,
        nearest: near.min_by(|a, b| room(a).total_cmp(&room(b))),
        tips: foreseen.way.iter().map(|q| machine.forward(q).point.to_array()).collect(),
        tilt_error_deg,
        arm: arm_view(&machine, &target),
    })
}

fn unreached(reason: Message) -> TargetAnswer {
    TargetAnswer {
        axes: Vec::new(),
        refused: Some(reason.into()),
        stops: None,
        time_s: 0.0,
        nearest: None,
        tips: Vec::new(),
        tilt_error_deg: 0.0,
        arm: None,
    }
}

/// Reason for an end before the target. The pair that is too near is that of [`TargetAnswer::nearest`].
fn halted(machine: &Machine, halt: Halt) -> Message {
    match halt {
        Halt::Limit(axis) => {
            let name = machine.axes.get(axis).map_or("", |axis| axis.name.as_str());
            Message::new("server-target-limit").axis("axis", name)
        }
        Halt::TooNear(_) => Message::new("server-target-near"),
        Halt::NotEnabled | Halt::Silent | Halt::NoMotion => JogError::NoMotion.message(),
    }
}

fn typed_axes(machine: &Machine, axes: &[f64]) -> Result<Joints, Refused> {
    if axes.len() != machine.axes.len() {
        let message = Message::new("server-axis-count").count("n", axes.len()).count("allowed", machine.axes.len());
        return Err(message.into());
    }
    Ok(machine.joints_from_file(axes))
}

/// Positions that bring the tip to a place, the nearest to `start` within all ranges, and the angle (degrees) by which the
/// torch's direction misses the wanted one; or the reason for a place out of reach.
fn placed_tip(machine: &Machine, tip: &TipTarget, start: &Joints) -> Result<Result<(Joints, f64), Message>, Refused> {
    if tip.point.iter().any(|v| !v.is_finite() || v.abs() > FARTHEST_MM) {
        return Err(Message::new("server-target-far").into());
    }
    let frame = frame(machine, &tip.frame, start)?;
    let present = machine.tool_frame(start);
    let turn = match tip.turn {
        Some(_) if !machine.has_free_roll() => return Err(Message::new("server-target-turn").into()),
        Some(wxyz) => rotation(&frame, wxyz)?,
        None => DQuat::from_mat3(&present.matrix3),
    };
    let point = frame.transform_point3(DVec3::from_array(tip.point));
    let across = machine.has_free_roll().then(|| turn * DVec3::X);
    // Without an orientation the direction stays exactly.
    let direction = if tip.turn.is_some() { turn * DVec3::Z } else { machine.forward(start).direction };
    let target = Target { across, ..Target::from(Pose { point, direction }) };
    Ok(match machine.reach(target, start) {
        Ok(found) => {
            let nearest = found
                .iter()
                .min_by(|a, b| travel_s(machine, start, &a.joints).total_cmp(&travel_s(machine, start, &b.joints)));
            nearest.map(|one| (one.joints, one.attitude_error.to_degrees())).ok_or_else(Message::default)
        }
        Err(reason) => Err(reason.message()),
    })
}

/// Time of the slowest axis between two positions at its highest speed, s.
fn travel_s(machine: &Machine, from: &Joints, to: &Joints) -> f64 {
    let axes = machine.axes.iter().zip(from.iter().zip(to));
    axes.map(|(axis, (a, b))| (a - b).abs() / axis.max_speed).fold(0.0, f64::max)
}

/// The rotation of `frame` with the quaternion w, x, y, z in it.
fn rotation(frame: &DAffine3, [w, x, y, z]: [f64; 4]) -> Result<DQuat, Refused> {
    let given = DQuat::from_xyzw(x, y, z, w);
    if !given.is_finite() || (given.length() - 1.0).abs() > 1e-2 {
        return Err(Message::new("server-target-quaternion").into());
    }
    Ok(DQuat::from_mat3(&frame.matrix3) * given.normalize())
}
