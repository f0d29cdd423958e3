//! True position of a seam.

use crate::disturbance::uniform;
use glam::{DQuat, DVec3};
use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::SeedableRng;
use seamwright_teaching::{SeamLine, Station};
use std::f64::consts::TAU;

/// Number of waves of the bend over the length of the seam.
const WAVES: usize = 3;

/// Placement error and bending of a part; the seed determines their directions.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Distortion {
    /// Shift of the part, mm.
    pub shift_mm: f64,
    /// Rotation about the middle of the seam, rad.
    pub turn: f64,
    /// Maximum bending of the seam, across and out of the surface together, mm.
    pub bend_mm: f64,
}

impl Distortion {
    /// Returns the actual seam of a nominal one.
    pub fn of(&self, nominal: &SeamLine, seed: u64) -> SeamLine {
        let mut random = Pcg64Mcg::seed_from_u64(seed ^ 0x5eed_0fd1_5707_1010);
        let shift = self.shift_mm * direction(&mut random);
        let turn = DQuat::from_axis_angle(direction(&mut random), self.turn);
        let bend = [Bend::new(&mut random, nominal), Bend::new(&mut random, nominal)];
        let stations = nominal.stations();
        let middle = stations.iter().map(|s| s.point).sum::<DVec3>() / stations.len() as f64;
        let actual = |(i, way): (usize, &f64)| {
            let station = &stations[i];
            let (_, along) = nominal.at(*way);
            let across = station.normal.cross(along).normalize_or_zero();
            let [a, b] =
                [bend[0].at(*way), bend[1].at(*way)].map(|b| b * self.bend_mm * std::f64::consts::FRAC_1_SQRT_2);
            let bent = station.point + a * across + b * station.normal;
            Station { point: middle + turn * (bent - middle) + shift, normal: turn * station.normal }
        };
        SeamLine::through(nominal.ways().iter().enumerate().map(actual).collect(), nominal.is_closed())
    }
}

/// A smooth wave by path length, within -1 and 1; periodic on a closed seam.
struct Bend {
    waves: [(f64, f64, f64); WAVES],
    sum: f64,
}

impl Bend {
    fn new(random: &mut Pcg64Mcg, seam: &SeamLine) -> Self {
        let waves: [(f64, f64, f64); WAVES] = std::array::from_fn(|k| {
            let turns = if seam.is_closed() { (k + 1) as f64 } else { k as f64 + 0.3 + 0.7 * uniform(random) };
            let size = (0.3 + uniform(random)) / (k + 1) as f64;
            (TAU * turns / seam.length(), TAU * uniform(random), size)
        });
        Self { waves, sum: waves.iter().map(|w| w.2).sum() }
    }

    fn at(&self, way: f64) -> f64 {
        self.waves.iter().map(|(rate, phase, size)| size * (rate * way + phase).sin()).sum::<f64>() / self.sum
    }
}

fn direction(random: &mut Pcg64Mcg) -> DVec3 {
    let z = 2.0 * uniform(random) - 1.0;
    let (sin, cos) = (TAU * uniform(random)).sin_cos();
    let r = (1.0 - z * z).sqrt();
    DVec3::new(r * cos, r * sin, z)
}
