use super::beam::BeamHead;
use super::carrier::Carrier;
use super::error::OffLine;
use super::head_truth::HeadTruth;
use super::leading::Leading;
use super::live_beam::LiveBeam;
use super::live_head::Guide;
use super::pass_sensors::PassSensors;
use super::scenario::Seam;
use super::simulated_sensors::{SimulatedHead, SimulatedSensor};
use super::{Along, Displacement, Distortion, Error, LiveHead, Placement, World};
use arrayvec::ArrayVec;
use glam::DVec3;
use seamwright_geometry::Pose;
use seamwright_machine::{AxisSet, Machine};
use seamwright_motion::PassMotion;
use seamwright_program::{Pass, TorchPath};
use seamwright_tracking::actuator::HeadTracking;
use seamwright_tracking::beam::{BeamReplay, BeamTracking, DeviationRecord, Replay};
use seamwright_tracking::lead::OwnCurve;

/// Number of positions along a pass at which sensors and axes are checked before the weld.
pub(super) const PLACES: u32 = 120;
/// Distance needed to know a position on the seam before the torch arrives, beyond the sensor's lead, mm.
pub(crate) const SIGHTING_MM: f64 = 6.0;

/// One pass of a weld, with the hidden true positions of its seams.
pub(crate) struct PassScene<'a> {
    path: &'a dyn TorchPath,
    pass: &'a Pass,
    distortion: Option<&'a Distortion>,
    whole: Whole,
    /// One seam for each torch that welds.
    seams: Vec<Seam>,
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
    pub(crate) fn new(
        path: &'a dyn TorchPath,
        pass: &'a Pass,
        distortion: Option<&'a Distortion>,
        whole: Whole,
    ) -> Self {
        let mut seams = vec![Seam::along(path)];
        if path.second(0.0).is_some() {
            seams.push(Seam::along(&Second(path)));
        }
        Self { path, pass, distortion, whole, seams }
    }

    pub(super) fn pass(&self) -> &'a Pass {
        self.pass
    }

    /// Converts deviations found by a beam from the path length of the pass to that of its seam.
    pub(super) fn on_seam(&self, found: &DeviationRecord) -> DeviationRecord {
        self.along(&self.seams[0]).on_seam(found)
    }

    /// Returns the devices that guide the heads of the pass, and the carrier that corrects them.
    ///
    /// # Errors
    /// A machine whose sensors do not lead and whose beam does not look; axes that cannot correct.
    pub(crate) fn correction<'b>(&self, machine: &'b Machine, planned: &PassMotion) -> Result<Correction<'b>, Error> {
        let sensors = PassSensors::of(machine, planned, &self.seams)?;
        let at = |i: u32| f64::from(i) / f64::from(PLACES);
        let frames = |i: u32| self.seams.iter().map(|seam| (seam.frame)(seam.length_mm * at(i))).collect();
        let places = (0..=PLACES).map(|i| (planned.path.at(planned.path.length() * at(i)), frames(i)));
        let held: AxisSet = self.pass.spare_axes.hold.keys().filter_map(|name| machine.axis(name)).collect();
        let carrier = Carrier::new(machine, held, &places.collect::<Vec<_>>())?;
        Ok(Correction { sensors, carrier })
    }

    /// Returns the corrected heads of the pass. If there are `stored` deviations of the seam, they replace the beam's
    /// view.
    ///
    /// # Errors
    /// Invalid settings, such as too short a lead; stored deviations that do not cover the pass.
    pub(crate) fn heads<'b>(
        &'b self,
        machine: &'b Machine,
        planned: &PassMotion,
        correction: &Correction<'_>,
        stored: Option<&DeviationRecord>,
    ) -> Result<ArrayVec<LiveHead<'b>, 2>, Error> {
        self.check_plain(machine, planned)?;
        let heads = self.seams.iter().enumerate().map(|(number, seam)| {
            let guide = self.guide(machine, number, seam, correction, stored)?;
            Ok(LiveHead::new(number, self.path, seam, guide))
        });
        heads.collect()
    }

    /// Returns the simulated devices that see the joint of each head.
    pub(crate) fn simulated_heads<'b>(
        &'b self,
        correction: &Correction<'_>,
        seed: u64,
    ) -> ArrayVec<SimulatedHead<'b>, 2> {
        let simulated_heads = self.seams.iter().enumerate().map(|(number, seam)| {
            let own = seed.wrapping_mul(8).wrapping_add(number as u64);
            let eye = match &correction.sensors {
                PassSensors::Leading(leading) => SimulatedSensor::leading(leading[number].model(), own),
                PassSensors::Beam(eye) => SimulatedSensor::beam(eye.camera.noise_mm, eye.camera.latency_s, own),
            };
            SimulatedHead::new(number, self.world(number, seam, seed), eye)
        });
        simulated_heads.collect()
    }

    /// Returns the true positions of each head's weld and joint.
    ///
    /// # Errors
    /// A torch that does not follow the seam's line.
    pub(crate) fn truths<'b>(
        &'b self,
        machine: &Machine,
        planned: &PassMotion,
        seed: u64,
    ) -> Result<ArrayVec<HeadTruth<'b>, 2>, Error> {
        self.check_plain(machine, planned)?;
        let truths = self.seams.iter().enumerate();
        let truth = |(number, seam)| HeadTruth::new(number, self.path, self.world(number, seam, seed), machine);
        Ok(truths.map(truth).collect())
    }

    /// Checks that the torch follows the seam's line or swings about it: without blends, and without weaving by two
    /// torches or a beam.
    fn check_plain(&self, machine: &Machine, planned: &PassMotion) -> Result<(), Error> {
        let what = if self.path.weave().is_some() && (self.seams.len() > 1 || machine.deflection.is_some()) {
            if self.seams.len() > 1 { OffLine::TwoTorches } else { OffLine::Beam }
        } else if !planned.path.blends().is_empty() {
            OffLine::Blends
        } else {
            return Ok(());
        };
        Err(Error::OffLine { pass: self.pass.name.clone(), what })
    }

    fn world<'b>(&self, number: usize, seam: &'b Seam, seed: u64) -> World<'b> {
        let along = self.along(seam);
        let (displacement, placement) = match self.distortion {
            Some(distortion) => {
                let displacement = distortion.displacement(number, self.whole.length_mm, seam.round_mm, seed);
                (displacement, distortion.placement(self.whole.middle))
            }
            None => (Displacement::default(), Placement::RIGHT),
        };
        let ends_mm = seam.round_mm.is_none().then_some((0.0, seam.length_mm));
        World { taught: &*seam.frame, displacement, placement, along, ends_mm }
    }

    fn guide<'b>(
        &self,
        machine: &Machine,
        number: usize,
        seam: &'b Seam,
        correction: &Correction<'_>,
        stored: Option<&DeviationRecord>,
    ) -> Result<Guide<'b>, Error> {
        let limits = correction.carrier.limits();
        let cycle_s = machine.servo_period_s;
        match &correction.sensors {
            PassSensors::Leading(leading) => {
                let sensor = leading[number];
                let (lead_mm, (_, fastest)) = (sensor.lead_mm, self.pass.speeds());
                let settings = sensor.model().settings(cycle_s, fastest);
                let own = OwnCurve::of(lead_mm, -lead_mm - SIGHTING_MM, self.path.length(), &seam.frame);
                let head = HeadTracking::new(settings, own, [limits; 2])?;
                Ok(Guide::Leading(Box::new(Leading::new(head))))
            }
            PassSensors::Beam(eye) => {
                let settings = eye.settings(cycle_s, self.pass);
                let deflection = eye.beam;
                let head = match stored {
                    Some(stored) => {
                        let stored = self.along(seam).of_pass(stored);
                        let replay = Replay::new(stored, 0.0, seam.length_mm, settings.noise_mm)?;
                        let how = eye.replay_settings(cycle_s);
                        BeamHead::Replay(Box::new(BeamReplay::new(how, replay, &*seam.frame, deflection, limits)?))
                    }
                    None => {
                        BeamHead::Tracking(Box::new(BeamTracking::new(settings, &*seam.frame, deflection, limits)?))
                    }
                };
                let live = LiveBeam::new(head, eye, seam, cycle_s, limits);
                Ok(Guide::Beam(Box::new(live)))
            }
        }
    }

    /// Returns the position of this pass on its seam.
    fn along(&self, seam: &Seam) -> Along {
        Along { begin_mm: self.pass.begin_mm.get(), reverse: self.pass.reverse, round_mm: seam.round_mm }
    }
}

/// Devices that guide the heads of a pass, and the carrier that moves them off their planned paths.
pub(crate) struct Correction<'a> {
    sensors: PassSensors<'a>,
    pub(crate) carrier: Carrier<'a>,
}

/// The second torch's path, by path length of the first.
struct Second<'a>(&'a dyn TorchPath);

impl TorchPath for Second<'_> {
    fn length(&self) -> f64 {
        self.0.length()
    }

    fn pose(&self, s: f64) -> Pose {
        self.0.second(s).unwrap_or_else(|| self.0.pose(s))
    }
}
