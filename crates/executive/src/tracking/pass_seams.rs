use super::beam_head::BeamHead;
use super::carrier::Carrier;
use super::error::{Error, OffLine};
use super::leading_head::{LeadingHead, SIGHTING_MM};
use super::live_beam::LiveBeam;
use super::live_head::{Guide, LiveHead};
use super::pass_sensors::{PLACES, PassSensors};
use super::seam::{PassPosition, Seam};
use arrayvec::ArrayVec;
use seamwright_geometry::Pose;
use seamwright_machine::{AxisSet, Machine};
use seamwright_motion::PassMotion;
use seamwright_program::{Pass, TorchPath};
use seamwright_tracking::actuator::HeadTracking;
use seamwright_tracking::beam::{BeamReplay, BeamTracking, DeviationRecord, Replay};
use seamwright_tracking::lead::OwnCurve;

/// The taught seams of one pass, one for each torch that welds.
pub struct PassSeams<'a> {
    path: &'a dyn TorchPath,
    pass: &'a Pass,
    seams: Vec<Seam>,
}

impl<'a> PassSeams<'a> {
    /// Samples the seams of `pass` along the path of its torches.
    #[must_use]
    pub fn new(path: &'a dyn TorchPath, pass: &'a Pass) -> Self {
        let mut seams = vec![Seam::along(path)];
        if path.second(0.0).is_some() {
            seams.push(Seam::along(&Second(path)));
        }
        Self { path, pass, seams }
    }

    /// Returns the path of the first torch.
    #[must_use]
    pub fn path(&self) -> &'a dyn TorchPath {
        self.path
    }

    /// Returns the seam of each torch that welds.
    #[must_use]
    pub fn seams(&self) -> &[Seam] {
        &self.seams
    }

    pub(super) fn pass(&self) -> &'a Pass {
        self.pass
    }

    /// Converts deviations found by a beam from the path length of the pass to that of its seam.
    pub(super) fn on_seam(&self, found: &DeviationRecord) -> DeviationRecord {
        self.position(&self.seams[0]).on_seam(found)
    }

    /// Returns the devices that guide the heads of the pass, and the carrier that corrects them.
    ///
    /// # Errors
    /// A machine whose sensors do not lead and whose beam does not look; axes that cannot correct.
    pub fn correction<'b>(&self, machine: &'b Machine, planned: &PassMotion) -> Result<Correction<'b>, Error> {
        let sensors = PassSensors::of(machine, planned, &self.seams)?;
        let at = |i: u32| f64::from(i) / f64::from(PLACES);
        let frames = |i: u32| self.seams.iter().map(|seam| (seam.frame)(seam.length_mm * at(i))).collect();
        let places = (0..=PLACES).map(|i| (planned.path.at(planned.path.length() * at(i)), frames(i)));
        let held: AxisSet = self.pass.spare_axes.hold.keys().filter_map(|name| machine.axis(name)).collect();
        let carrier = Carrier::new(machine, held, &places.collect::<Vec<_>>())?;
        Ok(Correction { sensors, carrier })
    }

    /// Returns the corrected heads of the pass. If there are `stored` deviations of the seam, they replace the beam's
    /// view. Errors: invalid settings, such as too short a lead; stored deviations that do not cover the pass.
    pub(super) fn heads<'b>(
        &'b self,
        machine: &'b Machine,
        planned: &PassMotion,
        correction: &Correction<'_>,
        stored: Option<&DeviationRecord>,
    ) -> Result<ArrayVec<LiveHead<'b>, 2>, Error> {
        self.check_plain(machine, planned)?;
        let heads = self.seams.iter().enumerate().map(|(number, seam)| {
            Ok(LiveHead::new(number, self.path, seam, self.guide(machine, number, seam, correction, stored)?))
        });
        heads.collect()
    }

    /// Checks that the pass can be tracked.
    ///
    /// # Errors
    /// Those of [`PassSeams::correction`]; invalid settings, such as too short a lead; stored deviations that do not
    /// cover the pass.
    pub fn check_tracking(
        &self,
        machine: &Machine,
        planned: &PassMotion,
        stored: Option<&DeviationRecord>,
    ) -> Result<(), Error> {
        self.heads(machine, planned, &self.correction(machine, planned)?, stored).map(drop)
    }

    /// Checks that the torch follows the seam's line or swings about it: without blends, and without weaving by two
    /// torches or a beam.
    ///
    /// # Errors
    /// [`Error::OffLine`].
    pub fn check_plain(&self, machine: &Machine, planned: &PassMotion) -> Result<(), Error> {
        let what = if self.path.weave().is_some() && (self.seams.len() > 1 || machine.deflection.is_some()) {
            if self.seams.len() > 1 { OffLine::TwoTorches } else { OffLine::Beam }
        } else if !planned.path.blends().is_empty() {
            OffLine::Blends
        } else {
            return Ok(());
        };
        Err(Error::OffLine { pass: self.pass.name.clone(), what })
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
                let settings = sensor.settings(cycle_s, fastest);
                let own = OwnCurve::of(lead_mm, -lead_mm - SIGHTING_MM, self.path.length(), &seam.frame);
                Ok(Guide::Leading(Box::new(LeadingHead::new(HeadTracking::new(settings, own, [limits; 2])?))))
            }
            PassSensors::Beam(eye) => {
                let settings = eye.settings(cycle_s, self.pass);
                let deflection = eye.beam;
                let head = match stored {
                    Some(stored) => {
                        let stored = self.position(seam).of_pass(stored);
                        let replay = Replay::new(stored, 0.0, seam.length_mm, settings.noise_mm)?;
                        let how = eye.replay_settings(cycle_s);
                        BeamHead::Replay(Box::new(BeamReplay::new(how, replay, &*seam.frame, deflection, limits)?))
                    }
                    None => {
                        BeamHead::Tracking(Box::new(BeamTracking::new(settings, &*seam.frame, deflection, limits)?))
                    }
                };
                Ok(Guide::Beam(Box::new(LiveBeam::new(head, eye, seam, cycle_s, limits))))
            }
        }
    }

    /// Returns the position of this pass on its seam.
    #[must_use]
    pub fn position(&self, seam: &Seam) -> PassPosition {
        PassPosition { begin_mm: self.pass.begin_mm.get(), reverse: self.pass.reverse, round_mm: seam.round_mm }
    }
}

/// Devices that guide the heads of a pass, and the carrier that moves them off their planned paths.
pub struct Correction<'a> {
    /// Devices that see the joint of each head.
    pub sensors: PassSensors<'a>,
    pub(super) carrier: Carrier<'a>,
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
