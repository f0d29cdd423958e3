use glam::{DQuat, DVec3};
use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::SeedableRng;
use seamwright_executive::tracking::Seam;
use seamwright_machine::{AxisLimits, BeamDeflection, Machine};
use seamwright_motion::PassMotion;
use seamwright_program::TorchPath;
use seamwright_teaching::{SeamLine, Station};
use seamwright_tracking::actuator::SlideLimits;
use std::f64::consts::TAU;

/// A pass to be welded by beam.
pub struct BeamScene<'a> {
    /// Machine whose axes carry the gun.
    pub machine: &'a Machine,
    /// The planned pass.
    pub motion: &'a PassMotion,
    /// The taught seam by the pass's path length.
    pub taught: Seam,
    /// True position of the seam.
    pub actual: SeamLine,
    /// Limits of the beam's deflection.
    pub deflection: BeamDeflection,
    /// Limits of the gun's offset by the axes, in the torch's frame.
    pub axes: SlideLimits,
}

impl<'a> BeamScene<'a> {
    /// Creates the scene of a planned pass on its torch's path. The beam is deflected by up to 2 mm; the axes carry
    /// the gun by up to 5 mm more, slowly.
    #[must_use]
    pub fn new(machine: &'a Machine, path: &dyn TorchPath, motion: &'a PassMotion, actual: SeamLine) -> Self {
        Self {
            machine,
            motion,
            taught: Seam::along(path),
            actual,
            deflection: BeamDeflection { range_mm: 2.0, speed: 2000.0, latency_s: 75e-6, pivot_mm: 260.0 },
            axes: SlideLimits { stroke_mm: 5.0, motion: AxisLimits { speed: 5.0, acceleration: 30.0, jerk: 300.0 } },
        }
    }

    /// Returns the lateral distances of the taught seam from the actual one, mm, every half millimetre. A machine
    /// without errors would miss by these without correction.
    #[must_use]
    pub fn uncorrected(&self) -> Vec<f64> {
        let count = (2.0 * self.taught.length_mm).floor() as u32;
        let miss = |i: u32| {
            let frame = (self.taught.frame)(0.5 * f64::from(i));
            Some((frame.point - self.actual.foot(frame.point)?.at.point).dot(frame.lateral).abs())
        };
        (0..=count).filter_map(miss).collect()
    }
}

/// Shift (mm), turn (degrees) and ovality (mm, over the diameter) of a misplaced part.
pub const PLACED_WRONG: [f64; 3] = [2.0, 0.5, 1.0];

/// Creates a seam whose part is shifted, turned about the middle of the seam and out of round by [`PLACED_WRONG`].
/// The seed determines the directions; the shift is mostly across the seam. The ovality moves the seam across and out
/// of the surface, a wave every `wave_mm`.
#[must_use]
pub fn placed_wrong(nominal: &SeamLine, wave_mm: f64, seed: u64) -> SeamLine {
    let [shift_mm, turn_deg, oval_mm] = PLACED_WRONG;
    let mut random = Pcg64Mcg::seed_from_u64(seed ^ 0x5eed_0fbe_a300_0001);
    let mut number = || 2.0 * crate::disturbance::uniform(&mut random) - 1.0;
    let mut direction = || DVec3::new(number(), number(), number()).normalize_or(DVec3::X);
    let (middle_station, along) = nominal.at(0.5 * nominal.length());
    let across = middle_station.normal.cross(along);
    let shift = shift_mm * (direction() + 1.5 * across).normalize_or(across);
    let turn = DQuat::from_axis_angle(direction(), turn_deg.to_radians());
    let phase = TAU * number();
    let stations = nominal.stations();
    let middle = stations.iter().map(|s| s.point).sum::<DVec3>() / stations.len() as f64;
    let moved = |(station, way): (&Station, &f64)| {
        let (_, along) = nominal.at(*way);
        let across = station.normal.cross(along).normalize_or_zero();
        let (sin, cos) = (TAU * way / wave_mm + phase).sin_cos();
        let bent = station.point + 0.5 * oval_mm * (sin * across + cos * station.normal);
        Station { point: middle + turn * (bent - middle) + shift, normal: turn * station.normal }
    };
    SeamLine::through(stations.iter().zip(nominal.ways()).map(moved).collect(), nominal.is_closed())
}
