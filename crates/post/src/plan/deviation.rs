//! Deviation of a block from the plan.

use super::block::{Block, Shape};
use super::block_cutter::{CHECKS, Cutter};
use super::options::BRIEFEST_S;
use crate::even_speed::EvenSpeed;
use crate::part_program::Level;
use seamwright_geometry::Pose;
use seamwright_machine::Joints;
use seamwright_program::PathRange;

/// Maximum lead or lag of a block against the plan, as a multiple of the chord tolerance: along the seam, or along a
/// weaving tip's way.
const LAG: f64 = 20.0;
/// Usable part of the speed's tolerance in the parts that are compared.
const SPEED_USED: f64 = 0.9;
/// Largest deviation of the torch's attitude within a block, rad.
const ATTITUDE: f64 = 0.1 * std::f64::consts::PI / 180.0;

impl Cutter<'_> {
    /// True if a block that ends at `b` keeps to tolerance, timing and torch attitude at `checks` stations within it,
    /// and is not too long.
    pub(super) fn good(&self, a: &Block, b: &Block, checks: usize) -> bool {
        if b.duration > self.cutting.longest_s {
            return false;
        }
        // The order of the checks finds bad blocks early.
        let n = checks.next_power_of_two();
        let stride = (3 * n / 8) | 1;
        let near = (1..n).map(|i| ((i * stride) % n) as f64 / n as f64).all(|f| {
            let [chord, lag, attitude] = self.deviation(a, b, f);
            chord <= self.tolerance && lag <= LAG * self.tolerance && attitude <= ATTITUDE
        });
        near && self.is_even(a, b) && self.keeps_speed(a, b, if n > CHECKS { n } else { EvenSpeed::parts(b.duration) })
    }

    /// Maximum distance from the planned path within a block, mm.
    pub(super) fn chord_error(&self, a: &Block, b: &Block) -> f64 {
        (1..CHECKS).map(|k| self.deviation(a, b, k as f64 / CHECKS as f64)[0]).fold(0.0, f64::max)
    }

    /// True if the tip keeps to its planned speed in each of `parts` of the block, or the block is too brief to be cut.
    fn keeps_speed(&self, a: &Block, b: &Block, parts: usize) -> bool {
        let allowed = SPEED_USED * self.cutting.speed;
        if b.duration <= BRIEFEST_S || allowed.is_infinite() {
            return true;
        }
        let begin = self.motion.profile.time(a.s);
        let at = |k: usize| k as f64 / parts as f64;
        let mut before = self.interpolated(a, b, 0.0).1.point;
        (0..parts).all(|k| {
            let here = self.interpolated(a, b, at(k + 1)).1.point;
            let way = before.distance(here);
            before = here;
            let times = [at(k), at(k + 1)].map(|f| begin + f * b.duration);
            self.even.deviation(times, way).is_none_or(|off| off <= allowed)
        })
    }

    /// True if process values go evenly enough within the block.
    fn is_even(&self, a: &Block, b: &Block) -> bool {
        let Some(course) = self.cutting.course else { return true };
        let begin = self.motion.profile.time(a.s);
        course.is_even(a.s..b.s, |f| self.motion.profile.at(begin + f * b.duration, &mut 0).s)
    }

    /// Axes and pose that the control passes through at the part `f` of a block.
    fn interpolated(&self, a: &Block, b: &Block, f: f64) -> (Joints, Pose) {
        let (mut q, mut tip) = b.part(a, f);
        if let Shape::Arc(arc) = b.shape {
            tip = arc.at(self.place(a), self.place(b), f);
            if self.cutting.level == Level::Joint {
                self.cutting.xyz.iter().zip(tip.to_array()).for_each(|(i, p)| i.iter().for_each(|i| q[*i] = p));
            }
        }
        let pose = self.machine.forward(&q);
        match self.cutting.level {
            Level::Joint => (q, pose),
            Level::Tip => (q, Pose { point: tip, ..pose }),
        }
    }

    /// Distance from the planned path (mm), lead or lag along it (mm) and attitude deviation (rad) at the part `f` of a
    /// block.
    fn deviation(&self, a: &Block, b: &Block, f: f64) -> [f64; 3] {
        let (q, passed) = self.interpolated(a, b, f);
        let planned = self.motion.profile.at(self.motion.profile.time(a.s) + f * b.duration, &mut 0).s;
        let s = self.path.foot(passed.point, planned, PathRange { from_mm: a.s, to_mm: b.s });
        let there = self.motion.path.at(s);
        // Compared with the reached position, so that a missing freedom is not a chord error.
        let reached = self.machine.forward(&there);
        let mut chord = (passed.point - reached.point).length();
        let mut attitude = (passed.direction - reached.direction).length();
        if self.cutting.second {
            let (passed, reached) = (self.machine.forward_of(1, &q), self.machine.forward_of(1, &there));
            chord = chord.max((passed.point - reached.point).length());
            attitude = attitude.max((passed.direction - reached.direction).length());
        }
        [chord, (s - planned).abs() * self.path.tip_rate(planned), 2.0 * (0.5 * attitude).min(1.0).asin()]
    }
}
