use super::displacement::Displacement;
use super::distortion::Distortion;
use super::head_truth::HeadTruth;
use super::simulated_sensors::{SimulatedHead, SimulatedSensor};
use super::world::{Placement, World};
use crate::error::Error;
use arrayvec::ArrayVec;
use glam::DVec3;
use seamwright_executive::tracking::{Correction, PLACES, PassSeams, PassSensors, Seam};
use seamwright_machine::Machine;
use seamwright_motion::PassMotion;
use seamwright_program::{Pass, TorchPath};

/// One pass of a weld, with the hidden true positions of its seams.
#[derive(Clone, Copy)]
pub(crate) struct PassScene<'a> {
    pub(crate) seams: &'a PassSeams<'a>,
    pub(crate) distortion: Option<&'a Distortion>,
    pub(crate) whole: Whole,
}

/// The whole weld; all its passes bend and turn together with it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Whole {
    /// Centre of the part's rotation, mm.
    middle: DVec3,
    /// Length of the longest pass, mm.
    length_mm: f64,
}

impl Whole {
    /// Creates it from these passes; the middle is that of the longest.
    pub(crate) fn of(passes: &[(&dyn TorchPath, &Pass)]) -> Self {
        let longest = passes.iter().map(|(path, _)| *path).max_by(|a, b| a.length().total_cmp(&b.length()));
        let Some(path) = longest else { return Self { middle: DVec3::ZERO, length_mm: 0.0 } };
        let seam = Seam::along(path);
        let way = seam.round_mm.unwrap_or(seam.length_mm);
        let places = (0..PLACES).map(|i| (seam.frame)(way * f64::from(i) / f64::from(PLACES)).point);
        Self { middle: places.sum::<DVec3>() / f64::from(PLACES), length_mm: seam.length_mm }
    }
}

impl<'a> PassScene<'a> {
    pub(crate) fn simulated_heads(self, correction: &Correction<'_>, seed: u64) -> ArrayVec<SimulatedHead<'a>, 2> {
        let simulated_heads = self.seams.seams().iter().enumerate().map(|(number, seam)| {
            let own = seed.wrapping_mul(8).wrapping_add(number as u64);
            let eye = match &correction.sensors {
                PassSensors::Leading(leading) => SimulatedSensor::leading(&leading[number], own),
                PassSensors::Beam(eye) => SimulatedSensor::beam(eye.camera.noise_mm, eye.camera.latency_s, own),
            };
            SimulatedHead::new(number, self.world(number, seam, seed), self.seams.path().drawn_back(), eye)
        });
        simulated_heads.collect()
    }

    /// Returns the true positions of each head's weld and joint. Errors: a torch that does not follow the seam's line.
    pub(crate) fn truths(
        self,
        machine: &Machine,
        planned: &PassMotion,
        seed: u64,
    ) -> Result<ArrayVec<HeadTruth<'a>, 2>, Error> {
        self.seams.check_plain(machine, planned)?;
        let truths = self.seams.seams().iter().enumerate();
        let truth = |(number, seam)| HeadTruth::new(number, self.seams.path(), self.world(number, seam, seed), machine);
        Ok(truths.map(truth).collect())
    }

    fn world(self, number: usize, seam: &'a Seam, seed: u64) -> World<'a> {
        let (displacement, placement) = match self.distortion {
            Some(distortion) => {
                let displacement = distortion.displacement(number, self.whole.length_mm, seam.round_mm, seed);
                (displacement, distortion.placement(self.whole.middle))
            }
            None => (Displacement::default(), Placement::RIGHT),
        };
        let ends_mm = seam.round_mm.is_none().then_some((0.0, seam.length_mm));
        World { taught: &*seam.frame, displacement, placement, along: self.seams.position(seam), ends_mm }
    }
}
