use super::hill_climb::climb;
use super::random::Random;
use super::voxels::{self, Volume};
use crate::chain::Joints;
use crate::machine::Machine;
use glam::DVec3;
use seamwright_geometry::angle_between;
use serde::Serialize;

pub(super) const LOOKED_AT: u32 = 20_000;

/// Number of climbs to each side of a box, from the farthest samples.
const CLIMBS: usize = 24;

/// Workspace of a head's tip and range of its torch attitude.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Reach {
    /// Lowest and highest corner of the box around all tips in the work frame, mm.
    pub work_box_mm: [[f64; 3]; 2],
    /// The same in the base frame, mm.
    pub base_box_mm: [[f64; 3]; 2],
    /// Part of space, plane or line reached by the tip in the work frame.
    pub volume: Volume,
    /// Maximum angle of the torch from its direction at home, in the work frame, degrees.
    pub tilt_deg: f64,
}

pub(super) fn find(machine: &Machine, seed: u64, step: &mut dyn FnMut()) -> Reach {
    let mut random = Random::new(seed, 5);
    let home = machine.forward(&machine.home()).direction;
    let mut samples: Vec<(Joints, DVec3)> = Vec::new();
    for k in 0..LOOKED_AT {
        step();
        let q = if k == 0 { machine.home() } else { random.joints(machine) };
        samples.push((q, machine.forward(&q).point));
    }
    let tilt = |q: &Joints| angle_between(machine.forward(q).direction, home);
    let tilt_deg = highest(machine, &samples, tilt).to_degrees();
    let work = |q: &Joints| machine.forward(q).point;
    let base = |q: &Joints| {
        let frames = machine.link_frames(q);
        machine.base_frame(&frames).inverse().transform_point3(machine.forward(q).point)
    };
    let (work_box, base_box) = (boxed(machine, &samples, work), boxed(machine, &samples, base));
    let volume = voxels::volume(machine, &samples, work_box, &mut random, step);
    Reach { work_box_mm: work_box.map(|c| c.to_array()), base_box_mm: base_box.map(|c| c.to_array()), volume, tilt_deg }
}

/// The box around all positions of `point`.
fn boxed(machine: &Machine, samples: &[(Joints, DVec3)], point: impl Fn(&Joints) -> DVec3) -> [DVec3; 2] {
    [-1.0, 1.0].map(|sense| {
        let side = |i: usize| sense * highest(machine, samples, |q| sense * point(q)[i]);
        DVec3::new(side(0), side(1), side(2))
    })
}

fn highest(machine: &Machine, samples: &[(Joints, DVec3)], height: impl Fn(&Joints) -> f64) -> f64 {
    let mut heights: Vec<(f64, usize)> = samples.iter().enumerate().map(|(i, s)| (height(&s.0), i)).collect();
    let starts = CLIMBS.min(heights.len() - 1);
    heights.select_nth_unstable_by(starts, |a, b| b.0.total_cmp(&a.0));
    let climbed = heights[..=starts].iter().map(|(_, i)| climb(machine, &samples[*i].0, f64::INFINITY, &height).1);
    climbed.fold(f64::NEG_INFINITY, f64::max)
}
