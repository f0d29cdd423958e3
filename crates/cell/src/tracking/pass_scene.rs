use super::carrier::Carrier;
use super::scenario::Seam;
use super::{Along, Displacement, Distortion, Error, LiveHead, Placement, SensorModel, World};
use glam::DVec3;
use seamwright_geometry::Pose;
use seamwright_machine::{Joints, Machine, Sensor, Sight};
use seamwright_motion::PassMotion;
use seamwright_program::{Pass, TorchPath};
use seamwright_tracking::actuator::HeadTracking;
use seamwright_tracking::lead::{OwnCurve, SeamFrame};

/// Places along a pass at which sensors and axes are looked at before it is welded.
const PLACES: u32 = 120;
/// Part of its greatest lead that a sensor must keep along a pass.
const LEAD_KEPT: f64 = 0.9;
/// What is needed for a place on the seam to be known before the torch is there, beside the sensor's lead, mm.
pub(crate) const SIGHTING_MM: f64 = 6.0;

/// One pass of a weld, with what is hidden: where its seams truly are.
pub(crate) struct PassScene<'a> {
    path: &'a dyn TorchPath,
    pass: &'a Pass,
    distortion: Option<&'a Distortion>,
    whole: Whole,
    /// One for each torch that welds.
    seams: Vec<Seam>,
}

/// The whole weld, which all its passes are bent and turned with.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Whole {
    /// About it the part is turned, mm.
    middle: DVec3,
    /// Of the longest pass, mm.
    length_mm: f64,
}

impl Whole {
    /// Of these passes: the middle is that of the longest.
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
        (path, pass): (&'a dyn TorchPath, &'a Pass),
        distortion: Option<&'a Distortion>,
        whole: Whole,
    ) -> Self {
        let mut seams = vec![Seam::along(path)];
        if path.second(0.0).is_some() {
            seams.push(Seam::along(&Second(path)));
        }
        Self { path, pass, distortion, whole, seams }
    }

    /// What corrects the heads that weld it.
    ///
    /// # Errors
    /// A machine whose sensors do not lead; axes that cannot correct.
    pub(crate) fn carrier<'b>(&self, machine: &'b Machine, planned: &PassMotion) -> Result<Carrier<'b>, Error> {
        for (number, seam) in self.seams.iter().enumerate() {
            leading(machine, planned, number, seam)?;
        }
        let at = |i: u32| f64::from(i) / f64::from(PLACES);
        let frames = |i: u32| self.seams.iter().map(|seam| (seam.frame)(seam.length_mm * at(i))).collect();
        let places = (0..=PLACES).map(|i| (planned.path.at(planned.path.length() * at(i)), frames(i)));
        Carrier::new(machine, &places.collect::<Vec<_>>())
    }

    /// The heads that weld it, with their sensors if `carrier` corrects them.
    ///
    /// # Errors
    /// A machine whose sensors do not lead, or whose axes cannot correct; settings that cannot work, as too short a lead.
    pub(crate) fn heads<'b>(
        &'b self,
        machine: &'b Machine,
        planned: &PassMotion,
        carrier: Option<&Carrier<'_>>,
        seed: u64,
    ) -> Result<Vec<LiveHead<'b>>, Error> {
        self.check_plain(planned)?;
        let heads = self.seams.iter().enumerate();
        let live = heads.map(|(number, seam)| {
            let world = self.world(number, seam, seed);
            let tracking = match carrier {
                Some(carrier) => Some(self.tracking(machine, planned, (number, seam), carrier)?),
                None => None,
            };
            Ok(LiveHead::new(number, seam, world, tracking, seed))
        });
        live.collect()
    }

    /// The torch goes along the seam's line: neither weave nor blends lead it off.
    fn check_plain(&self, planned: &PassMotion) -> Result<(), Error> {
        let what = if self.path.swing(0.0).is_some() {
            "weaves"
        } else if !planned.path.blends().is_empty() {
            "goes round corners in blends"
        } else {
            return Ok(());
        };
        Err(Error::OffLine { pass: self.pass.name.clone(), what })
    }

    fn world<'b>(&self, number: usize, seam: &'b Seam, seed: u64) -> World<'b> {
        let along = Along { begin_mm: self.pass.begin_mm.get(), reverse: self.pass.reverse, round_mm: seam.round_mm };
        let (displacement, placement) = match self.distortion {
            Some(distortion) => {
                let length = (self.whole.length_mm, seam.round_mm);
                (distortion.displacement(number, length, seed), distortion.placement(self.whole.middle))
            }
            None => (Displacement::default(), Placement::RIGHT),
        };
        let ends_mm = seam.round_mm.is_none().then_some((0.0, seam.length_mm));
        World { taught: &*seam.frame, displacement, placement, along, ends_mm }
    }

    fn tracking(
        &self,
        machine: &Machine,
        planned: &PassMotion,
        (number, seam): (usize, &Seam),
        carrier: &Carrier<'_>,
    ) -> Result<(SensorModel, HeadTracking), Error> {
        let (sensor, lead_mm) = leading(machine, planned, number, seam)?;
        let model = SensorModel {
            period_s: sensor.period_s,
            latency_s: sensor.latency_s,
            noise_mm: sensor.noise_mm,
            ..SensorModel::usual(lead_mm)
        };
        let (_, fastest) = self.pass.speeds();
        let settings = model.settings(machine.servo_period_s, fastest);
        let own = OwnCurve::of(lead_mm, -lead_mm - SIGHTING_MM, self.path.length(), &seam.frame);
        Ok((model, HeadTracking::new(settings, own, [carrier.limits(); 2])?))
    }
}

fn places<'a>(planned: &'a PassMotion, seam: &'a Seam) -> impl Iterator<Item = (Joints, SeamFrame)> + 'a {
    let at = |i: u32| f64::from(i) / f64::from(PLACES);
    (0..=PLACES).map(move |i| (planned.path.at(planned.path.length() * at(i)), (seam.frame)(seam.length_mm * at(i))))
}

/// The stripe sensor that leads head `number` all along the pass, and by how much, mm.
fn leading<'a>(
    machine: &'a Machine,
    planned: &PassMotion,
    number: usize,
    seam: &Seam,
) -> Result<(&'a Sensor, f64), Error> {
    let mut best: Option<(f64, f64, &Sensor)> = None;
    for sensor in machine.sensors.iter().filter(|s| matches!(s.sight, Sight::Stripe(_))) {
        let lead = |(q, frame): (Joints, SeamFrame)| {
            let at = machine.sensor_frame(sensor, &q).translation - machine.forward_of(number, &q).point;
            let ahead = at.dot(frame.along);
            // One that looks at another torch's joint is not meant.
            if (at - ahead * frame.along).length() > ahead.abs() { f64::NEG_INFINITY } else { ahead }
        };
        let ends = places(planned, seam).map(lead);
        let (least, most) = ends.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), l| (l.min(low), l.max(high)));
        if best.is_none_or(|(other, _, _)| least > other) {
            best = Some((least, most, sensor));
        }
    }
    let (machine_name, head) = (machine.name.clone(), number + 1);
    match best {
        Some((least, most, sensor)) if least > 0.0 && least >= LEAD_KEPT * most => {
            // Two heads have one each: that of the other is beside the joint.
            Ok((sensor, 0.5 * (least + most)))
        }
        Some((least, most, sensor)) => {
            let (sensor, ahead_mm) = (sensor.name.clone(), [least, most]);
            Err(Error::NotLeading { machine: machine_name, sensor, head, ahead_mm })
        }
        None => Err(Error::NoSensor { machine: machine_name, head }),
    }
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
