//! Passes through points as paths: by tip poses, or by positions of a machine's axes.
//!
//! Between points the numbers of a pass (axes or poses) follow a line, an arc or a cubic of the path's parameter. The
//! parameter counts the planned time, multiplied by the tip's mean speed (`ThroughPoints`). So the speed profile
//! gets one requested speed for the whole pass, blends at corners keep the times of the blocks, and a tip that stands
//! still or turns back while the axes continue needs no special treatment.

mod block;
mod build;
mod knots;
mod thinning;

use block::Block;
use glam::{DAffine3, DVec3};
use seamwright_geometry::Pose;
use seamwright_program::{AxisPositions, Span, ThroughPoints, TorchPath};
use std::fmt;
use std::sync::Arc;

/// The axes of a machine, as points given by axis positions need them.
pub trait MachineAxes: fmt::Debug + Send + Sync {
    /// The axes in the machine file's order.
    fn axes(&self) -> Vec<MachineAxis>;

    /// Torch tip and direction in the work frame at axis positions, mm or rad.
    fn torch(&self, positions: &AxisPositions) -> Pose;

    /// Wire between the torch's contact tip and its tip, mm, if the machine's file has it.
    fn stick_out(&self) -> Option<f64> {
        None
    }
}

/// An axis of a machine.
#[derive(Debug, Clone, PartialEq)]
pub struct MachineAxis {
    /// Name in the machine file.
    pub name: String,
    /// True if it is in degrees in files.
    pub rotary: bool,
    /// Position after homing, mm or rad.
    pub home: f64,
    /// Highest speed, mm/s or rad/s.
    pub max_speed: f64,
}

/// Numbers at a point: axis positions (mm or rad), or tip (mm) and direction.
pub(crate) type Row = AxisPositions;

/// The path of a pass through points. Its parameter counts the planned time, times the mean speed of the tip over the
/// whole pass: so the whole is as long as the tip's way, and where the pass is given by a speed the parameter is the
/// path length.
#[derive(Debug, Clone)]
pub struct PointPath {
    blocks: Vec<Block>,
    /// Machine and frame of the numbers: axes of a machine, or poses in a frame that this maps to the work frame.
    numbers: Numbers,
    /// The pass' spans as one along a seam has them: process values by path length.
    spans: Vec<Span>,
    /// Path length at each point, the start first, mm.
    reached: Vec<f64>,
}

#[derive(Debug, Clone)]
pub(crate) enum Numbers {
    Axes(Arc<dyn MachineAxes>),
    Poses(DAffine3),
}

impl Numbers {
    pub(crate) fn pose(&self, row: &Row) -> Pose {
        match self {
            Self::Axes(machine) => machine.torch(row),
            Self::Poses(frame) => Pose {
                point: frame.transform_point3(DVec3::new(row[0], row[1], row[2])),
                direction: frame.transform_vector3(DVec3::new(row[3], row[4], row[5]).normalize_or(DVec3::NEG_Z)),
            },
        }
    }
}

impl PointPath {
    /// Speed and process values by the parameter.
    pub fn spans(&self) -> &[Span] {
        &self.spans
    }

    /// The block at `s`: the later one where two meet.
    fn block(&self, s: f64) -> &Block {
        &self.blocks[self.blocks.partition_point(|b| b.from <= s).saturating_sub(1)]
    }

    fn row(&self, s: f64) -> Row {
        let block = self.block(s);
        block.at(((s - block.from) / (block.to - block.from)).clamp(0.0, 1.0))
    }
}

/// Half the way over which rates are differences, as a part of the path.
const HALF: f64 = 1e-6;

impl TorchPath for PointPath {
    fn length(&self) -> f64 {
        self.blocks.last().map_or(0.0, |b| b.to)
    }

    fn pose(&self, s: f64) -> Pose {
        self.numbers.pose(&self.row(s))
    }

    fn rate(&self, s: f64) -> f64 {
        // Within the block: its ends may be corners.
        let block = self.block(s);
        let h = (HALF * self.length()).min(0.25 * (block.to - block.from));
        let (a, b) = ((s - h).max(block.from), (s + h).min(block.to));
        let at = |s: f64| self.numbers.pose(&block.at((s - block.from) / (block.to - block.from))).point;
        at(a).distance(at(b)) / (b - a)
    }

    fn points(&self) -> Option<&dyn ThroughPoints> {
        Some(self)
    }

    /// At a standstill of the tip the tangent is the torch's direction.
    fn line(&self, s: f64) -> (DVec3, DVec3) {
        let h = HALF * self.length();
        let (a, b, here) = (self.pose((s - h).max(0.0)), self.pose((s + h).min(self.length())), self.pose(s));
        (here.point, (b.point - a.point).try_normalize().unwrap_or(here.direction))
    }

    fn knots(&self) -> Vec<f64> {
        self.blocks.iter().skip(1).map(|b| b.from).collect()
    }

    /// A spline has no bends inside.
    fn bends(&self) -> Vec<f64> {
        self.blocks.windows(2).filter(|w| !w[1].is_continued).map(|w| w[1].from).collect()
    }
}

impl ThroughPoints for PointPath {
    fn reached(&self, points: usize) -> Option<f64> {
        self.reached.get(points).copied()
    }

    fn stops(&self) -> Vec<f64> {
        self.blocks.windows(2).filter(|w| w[0].stops).map(|w| w[1].from).collect()
    }

    fn axes(&self, s: f64) -> Option<AxisPositions> {
        matches!(self.numbers, Numbers::Axes(_)).then(|| self.row(s))
    }
}
