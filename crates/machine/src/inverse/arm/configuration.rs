use super::{Arm, MEET_MM, Tail};
use crate::chain::{Joints, Turn};
use glam::{DAffine3, DVec3};
use serde::Serialize;
use std::f64::consts::TAU;

/// Side of the first axis on which the wrist is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Shoulder {
    /// On the side of the positions with all axes at zero.
    Front,
    /// The arm reaches over its base backwards.
    Back,
}

/// Side of the line from shoulder to wrist on which the elbow is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Elbow {
    /// On the side away from the base, with the wrist in front.
    Up,
    /// Below.
    Down,
}

/// Sign of the fifth axis' angle from the alignment of its neighbours.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum WristSide {
    /// Positive.
    NoFlip,
    /// Negative.
    Flip,
}

/// Configuration of an arm: together with the torch's frame, and the arm angle of a seven-axis arm, it determines all
/// positions.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize)]
pub struct ArmConfiguration {
    /// Side of the wrist; of a seven-axis arm the side on which the second axis passes the line to the wrist.
    pub shoulder: Shoulder,
    /// Side of the elbow.
    pub elbow: Elbow,
    /// Side of the fifth axis.
    pub wrist: WristSide,
    /// Whole turns of each axis from its position within (-180, 180] degrees, without the redundant axis.
    pub turns: [i32; 6],
}

impl ArmConfiguration {
    /// Number of the branch, 0 to 7, without turns.
    pub fn branch(&self) -> u8 {
        let bits = [self.shoulder == Shoulder::Back, self.elbow == Elbow::Down, self.wrist == WristSide::Flip];
        bits.into_iter().fold(0, |number, bit| 2 * number + u8::from(bit))
    }
}

/// Distances of an arm from its singularities; at 0 it has lost a freedom.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct ArmMargins {
    /// Distance of the wrist from the plane through the first axis and across its links, mm: at 0 axis 1 is fixed.
    pub shoulder_mm: f64,
    /// The same as a fraction of the mean length of upper arm and forearm, at most 1.
    pub shoulder: f64,
    /// Sine of the angle between upper arm and forearm.
    pub elbow: f64,
    /// Sine of the angle between the last axis and the axis aligned with it in the singularity.
    pub wrist: f64,
}

impl ArmMargins {
    /// The smallest of the three, 0 to 1.
    pub fn min(&self) -> f64 {
        self.shoulder.min(self.elbow).min(self.wrist)
    }
}

/// Signed distances from the singularities: their signs are the configuration.
struct Signed {
    forward_mm: f64,
    elbow: f64,
    wrist: f64,
}

impl Arm {
    /// Configuration at positions `q`; `base` is the base frame, seen as the arm's axes, with all axes at zero.
    pub(crate) fn configuration(&self, q: &Joints, base: &DAffine3) -> ArmConfiguration {
        let signed = self.signed(q);
        ArmConfiguration {
            shoulder: if signed.forward_mm >= 0.0 { Shoulder::Front } else { Shoulder::Back },
            elbow: if signed.elbow * self.sense_upwards(base) >= 0.0 { Elbow::Up } else { Elbow::Down },
            wrist: if signed.wrist >= 0.0 { WristSide::NoFlip } else { WristSide::Flip },
            turns: self.axes.map(|axis| turns(q[axis])),
        }
    }

    /// 1 if the first axis points from the base to the shoulder, -1 if it points back (KUKA counts it clockwise).
    fn sense_upwards(&self, base: &DAffine3) -> f64 {
        let height_mm = (self.links.origin - base.translation).dot(self.upright);
        if height_mm.abs() > MEET_MM {
            return height_mm.signum();
        }
        // The shoulder is at the base's height.
        base.transform_vector3(DVec3::Z).dot(self.upright).signum()
    }

    /// Distances from the singularities at positions `q`.
    pub(crate) fn margins(&self, q: &Joints) -> ArmMargins {
        let signed = self.signed(q);
        let shoulder_mm = signed.forward_mm.abs();
        ArmMargins {
            shoulder_mm,
            shoulder: (2.0 * shoulder_mm / self.links.length()).min(1.0),
            elbow: signed.elbow.abs(),
            wrist: signed.wrist.abs(),
        }
    }

    fn signed(&self, q: &Joints) -> Signed {
        let bend = match &self.tail {
            Tail::Wrist(wrist) => wrist.bend(q[self.axes[4]]),
            Tail::Parallel(tail) => Turn::by(q[self.axes[4]]).and(tail.straight(self.normal).back()).angle(),
        };
        // Angle of the elbow from the stretched links; negative about the second axis is along the first one if y is.
        let elbow = Turn::by(self.third * q[self.axes[2]]).and(self.links.in_line().back());
        let up = self.links.y.dot(self.upright).signum();
        Signed {
            forward_mm: self.forward.dot(self.centre_at(q) - self.base),
            elbow: -up * elbow.sin(),
            wrist: bend.sin(),
        }
    }
}

/// Whole turns of a position from the one within (-180, 180] degrees.
pub(super) fn turns(position: f64) -> i32 {
    ((position - 1e-12) / TAU).round() as i32
}
