//! Jogging of axes from a page.

use super::client::Client;
use crate::refusal::{Lack, lack};
use crate::wire::JogOf;
use glam::DVec3;
use seamwright_executive::{Ask, REDUCED_MM_S};
use seamwright_machine::{Joints, MAX_AXES};
use seamwright_message::{Message, Unit};
use seamwright_motion::jog::{self, TipFrame};

/// Maximum step of a key, mm or degrees.
const MAX_STEP: f64 = 10.0;
/// Minimum step that counts as motion, mm or degrees.
const MIN_STEP: f64 = 1e-4;
/// Speeds below this part of the maximum count as zero: they would be invisible, yet hold the control token forever.
const DEAD_BAND: f64 = 1e-3;

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

    pub(super) fn jog(&mut self, seq: u32, of: JogOf, speeds: &[f64]) -> Result<(), Lack> {
        let moves = speeds.iter().any(|v| v.abs() >= DEAD_BAND);
        self.may_jog(seq, moves)?;
        self.held = None;
        let part = |v: f64| if v.is_finite() && v.abs() >= DEAD_BAND { v.clamp(-1.0, 1.0) } else { 0.0 };
        let command = match of {
            _ if !moves => jog::Command::Rest,
            JogOf::Joints => {
                let machine =
                    self.panel.cell.hub.machine().ok_or_else(|| lack("work", Message::new("server-no-machine")))?;
                let mut all: Joints = [0.0; MAX_AXES];
                for ((speed, axis), v) in all.iter_mut().zip(&machine.axes).zip(speeds) {
                    *speed = part(*v) * axis.max_speed;
                }
                jog::Command::Speeds(all)
            }
            JogOf::Tip => {
                let at = |i: usize| speeds.get(i).map_or(0.0, |v| part(*v));
                let velocity = REDUCED_MM_S * DVec3::new(at(0), at(1), at(2)).clamp_length_max(1.0);
                jog::Command::Tip { frame: TipFrame::Work, velocity }
            }
        };
        self.send(seq, Ask::Jog(command));
        Ok(())
    }

    /// Moves to the target of the first step since the key was released.
    pub(super) fn step(&mut self, seq: u32, of: JogOf, index: u32, by: f64) -> Result<(), Lack> {
        // A zero step does not hold the control token.
        self.may_jog(seq, by.abs() >= MIN_STEP)?;
        let target = match self.held {
            Some(target) => target,
            None => self.stepped(of, index as usize, by)?,
        };
        self.held = Some(target);
        self.send(seq, Ask::Jog(jog::Command::To(target)));
        Ok(())
    }

    /// Returns the target of a step from the set-points.
    fn stepped(&self, of: JogOf, index: usize, by: f64) -> Result<Joints, Lack> {
        if !(-MAX_STEP..=MAX_STEP).contains(&by) {
            return Err(lack(
                "value",
                Message::new("server-step-range").value("value", by, Unit::One).value("max", MAX_STEP, Unit::One),
            ));
        }
        let hub = &self.panel.cell.hub;
        let known = hub.machine().zip(hub.set_points());
        let (machine, mut q) = known.ok_or_else(|| lack("references", Message::new("server-positions-unknown")))?;
        match of {
            JogOf::Joints => {
                let axis = machine.axes.get(index).ok_or_else(|| lack("value", Message::new("server-no-such-axis")))?;
                q[index] += axis.from_file(by);
                if let Some((low, high)) = axis.range {
                    q[index] = q[index].clamp(low, high);
                }
                Ok(q)
            }
            JogOf::Tip if index < 3 => {
                let mut pose = machine.forward(&q);
                pose.point[index] += by;
                let there = machine.inverse_near(pose, &q).map_err(|e| lack("motion", e.message()))?;
                Ok(there.joints)
            }
            JogOf::Tip => Err(lack("value", Message::new("server-tip-directions"))),
        }
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
