//! Jogging of axes from a page.

use super::client::Client;
use crate::refusal::{Lack, lack};
use crate::wire::JogOf;
use glam::{DAffine3, DMat3, DQuat, DVec3};
use seamwright_executive::{Ask, REDUCED_MM_S, REDUCED_RAD_S};
use seamwright_geometry::Pose;
use seamwright_machine::{Joints, MAX_AXES, Machine, Target};
use seamwright_message::{Message, Unit};
use seamwright_motion::jog::{self, TipFrame};

/// Maximum step of a key, mm or degrees.
const MAX_STEP: f64 = 10.0;
/// Maximum step of a turn about the tip, degrees. Axes move to the target of a step on a common straight line: over 1
/// degree the tip of a torch of 500 mm then leaves its place by less than 0.02 mm.
const MAX_TURN_STEP: f64 = 1.0;
/// Maximum miss of the torch's direction after a turn, rad; beyond it the machine lacks axes for it.
const TURN_ERROR: f64 = 1e-6;
/// Minimum step that counts as motion, mm or degrees.
const MIN_STEP: f64 = 1e-4;
/// Speeds below this part of the maximum count as zero: they would be invisible, yet hold the control token forever.
const DEAD_BAND: f64 = 1e-3;

/// Returns the frame called `name` in the work frame with the axes at `q`: `work`, `base`, `tool` or a user frame.
pub(super) fn frame(machine: &Machine, name: &str, q: &Joints) -> Result<DAffine3, Message> {
    match name {
        "work" => Ok(DAffine3::IDENTITY),
        "base" => Ok(base(machine, q)),
        "tool" => {
            let axes = [DVec3::X, DVec3::Y, DVec3::Z].map(|axis| TipFrame::Torch.to_work(machine, q, axis));
            let matrix3 = DMat3::from_cols(axes[0], axes[1], axes[2]);
            Ok(DAffine3 { matrix3, translation: machine.forward(q).point })
        }
        _ => match machine.user_frame(name) {
            Some(frame) => Ok(base(machine, q) * frame.in_base),
            None => {
                let own = machine.user_frames.iter().map(|frame| frame.name.as_str());
                let known: Vec<&str> = ["work", "base", "tool"].into_iter().chain(own).collect();
                Err(Message::new("server-no-frame").text("name", name).text("allowed", known.join(", ")))
            }
        },
    }
}

/// The base frame in the work frame with the axes at `q`.
pub(super) fn base(machine: &Machine, q: &Joints) -> DAffine3 {
    machine.base_frame(&machine.link_frames(q))
}

impl Client {
    /// Checks that the page may jog, and pauses teaching by camera.
    fn may_jog(&mut self, seq: u32, moves: bool) -> Result<(), Lack> {
        self.allowed("jog")?;
        if seq <= self.jogs {
            return Err(lack(
                "replayed",
                Message::new("server-replayed").number("n", f64::from(seq), 0).number("last", f64::from(self.jogs), 0),
            ));
        }
        self.jogs = seq;
        if !self.panel.cell.hub.controls(self.station, moves) {
            return Err(lack("control", Message::new("server-no-control")));
        }
        if moves { self.panel.teaching.pause("hand") } else { Ok(()) }
    }

    pub(super) fn jog(&mut self, seq: u32, of: JogOf, frame: Option<&str>, speeds: &[f64]) -> Result<(), Lack> {
        let moves = speeds.iter().any(|v| v.abs() >= DEAD_BAND);
        self.may_jog(seq, moves)?;
        self.held = None;
        let part = |v: f64| if v.is_finite() && v.abs() >= DEAD_BAND { v.clamp(-1.0, 1.0) } else { 0.0 };
        let command = if !moves {
            jog::Command::Rest
        } else if of == JogOf::Joints {
            let machine =
                self.panel.cell.hub.machine().ok_or_else(|| lack("work", Message::new("server-no-machine")))?;
            let mut all: Joints = [0.0; MAX_AXES];
            for ((speed, axis), v) in all.iter_mut().zip(&machine.axes).zip(speeds) {
                *speed = part(*v) * axis.max_speed;
            }
            jog::Command::Speeds(all)
        } else {
            let at = |i: usize| speeds.get(i).map_or(0.0, |v| part(*v));
            let parts = DVec3::new(at(0), at(1), at(2)).clamp_length_max(1.0);
            let (frame, parts) = self.directed(frame.unwrap_or("work"), parts)?;
            match of {
                JogOf::Turn => jog::Command::Turn { frame, velocity: REDUCED_RAD_S * parts },
                _ => jog::Command::Tip { frame, velocity: REDUCED_MM_S * parts },
            }
        };
        self.send(seq, Ask::Jog(command));
        Ok(())
    }

    /// Returns a vector of the frame called `name` as the cell takes it: in the torch's frame, which turns with it, or in
    /// the work frame.
    fn directed(&self, name: &str, v: DVec3) -> Result<(TipFrame, DVec3), Lack> {
        match name {
            "work" => Ok((TipFrame::Work, v)),
            "tool" => Ok((TipFrame::Torch, v)),
            _ => {
                let (machine, q) = self.positions()?;
                let frame = frame(&machine, name, &q).map_err(|message| lack("value", message))?;
                Ok((TipFrame::Work, frame.transform_vector3(v)))
            }
        }
    }

    /// The machine and the set-points of its axes.
    fn positions(&self) -> Result<(std::sync::Arc<Machine>, Joints), Lack> {
        let hub = &self.panel.cell.hub;
        let known = hub.machine().zip(hub.set_points());
        known.ok_or_else(|| lack("references", Message::new("server-positions-unknown")))
    }

    /// Moves to the target of the first step since the key was released.
    pub(super) fn step(
        &mut self,
        seq: u32,
        of: JogOf,
        frame: Option<&str>,
        (index, by): (u32, f64),
    ) -> Result<(), Lack> {
        // A zero step does not hold the control token.
        self.may_jog(seq, by.abs() >= MIN_STEP)?;
        let target = match self.held {
            Some(target) => target,
            None => self.stepped(of, frame.unwrap_or("work"), index as usize, by)?,
        };
        self.held = Some(target);
        self.send(seq, Ask::Jog(jog::Command::To(target)));
        Ok(())
    }

    /// Returns the target of a step from the set-points.
    fn stepped(&self, of: JogOf, name: &str, index: usize, by: f64) -> Result<Joints, Lack> {
        let max = if of == JogOf::Turn { MAX_TURN_STEP } else { MAX_STEP };
        if !(-max..=max).contains(&by) {
            return Err(lack(
                "value",
                Message::new("server-step-range").value("value", by, Unit::One).value("max", max, Unit::One),
            ));
        }
        let (machine, mut q) = self.positions()?;
        if of == JogOf::Joints {
            let axis = machine.axes.get(index).ok_or_else(|| lack("value", Message::new("server-no-such-axis")))?;
            q[index] += axis.from_file(by);
            if let Some((low, high)) = axis.range {
                q[index] = q[index].clamp(low, high);
            }
            return Ok(q);
        }
        let axis = [DVec3::X, DVec3::Y, DVec3::Z].get(index).copied();
        let axis = axis.ok_or_else(|| lack("value", Message::new("server-tip-directions")))?;
        let along = frame(&machine, name, &q).map_err(|message| lack("value", message))?.transform_vector3(axis);
        let (mut pose, mut across) = (machine.forward(&q), machine.across(&q));
        if of == JogOf::Turn {
            let turn = DQuat::from_axis_angle(along.normalize_or(DVec3::Z), by.to_radians());
            (pose, across) = (Pose { direction: turn * pose.direction, ..pose }, turn * across);
        } else {
            pose.point += by * along;
        }
        let target = Target { across: machine.has_free_roll().then_some(across), ..Target::from(pose) };
        let there = machine.inverse_near(target, &q).map_err(|e| lack("motion", e.message()))?;
        if of == JogOf::Turn && (there.attitude_error > TURN_ERROR || turns_nothing(&q, &there.joints)) {
            return Err(lack("motion", Message::new("server-no-turn")));
        }
        Ok(there.joints)
    }

    pub(super) fn go(&mut self, seq: u32, axes: &[f64]) -> Result<(), Lack> {
        self.may_jog(seq, true)?;
        self.held = None;
        let machine = self.panel.cell.hub.machine().ok_or_else(|| lack("work", Message::new("server-no-machine")))?;
        if axes.len() != machine.axes.len() {
            return Err(lack(
                "value",
                Message::new("server-axis-count").count("n", axes.len()).count("allowed", machine.axes.len()),
            ));
        }
        let target = machine.joints_from_file(axes);
        self.send(seq, Ask::Jog(jog::Command::To(target)));
        Ok(())
    }
}

/// True if no axis moves: the machine has none for the turn.
fn turns_nothing(from: &Joints, to: &Joints) -> bool {
    from.iter().zip(to).all(|(a, b)| (a - b).abs() < 1e-9)
}
