//! Devices that see the joint ahead of the torches: sensors that lead them, or the beam that welds.

use super::beam::UnderWay;
use super::pass_scene::PLACES;
use super::scenario::Seam;
use super::{Error, SensorModel};
use glam::{DVec2, DVec3};
use seamwright_geometry::HeightTable;
use seamwright_machine::{BeamDeflection, Joints, Machine, Sensor, Sight};
use seamwright_motion::PassMotion;
use seamwright_program::Pass;
use seamwright_tracking::beam::{ReplaySettings, Settings};
use seamwright_tracking::lead::SeamFrame;

/// Share of its maximum lead that a sensor must keep along a pass.
const LEAD_KEPT: f64 = 0.9;
/// Rim of a picture that is not evaluated, mm.
const RIM_MM: f64 = 1.6;

/// Devices that see the joint of each head of a pass.
#[derive(Debug, Clone)]
pub(super) enum PassSensors<'a> {
    /// Stripe sensors ahead of the torches.
    Leading(Vec<LeadingSensor<'a>>),
    /// The beam, in interruptions of the weld.
    Beam(BeamCamera<'a>),
}

/// Stripe sensor ahead of a torch.
#[derive(Debug, Clone, Copy)]
pub(super) struct LeadingSensor<'a> {
    sensor: &'a Sensor,
    /// Distance from the torch, mm.
    pub(super) lead_mm: f64,
}

impl LeadingSensor<'_> {
    /// Returns the model of the sensor, as its file describes it.
    pub(super) fn model(&self) -> SensorModel {
        SensorModel {
            period_s: self.sensor.period_s,
            latency_s: self.sensor.latency_s,
            noise_mm: self.sensor.noise_mm,
            ..SensorModel::usual(self.lead_mm)
        }
    }
}

/// Camera that looks through the beam.
#[derive(Debug, Clone, Copy)]
pub(super) struct BeamCamera<'a> {
    pub(super) camera: &'a Sensor,
    pub(super) beam: BeamDeflection,
    /// Distance from the middle of the picture to the nearest side, less the rim, mm.
    reach_mm: f64,
}

impl<'a> PassSensors<'a> {
    /// Returns the beam's camera of a machine with a beam, otherwise the sensors that lead its heads along these
    /// seams.
    ///
    /// # Errors
    /// [`Error::NoCamera`], [`Error::NoSensor`], [`Error::NotLeading`].
    pub(super) fn of(machine: &'a Machine, planned: &PassMotion, seams: &[Seam]) -> Result<Self, Error> {
        if let Some(beam) = machine.deflection {
            return Ok(Self::Beam(BeamCamera::of(machine, beam)?));
        }
        let heads = seams.iter().enumerate();
        let sensors = heads.map(|(number, seam)| leading(machine, planned, number, seam));
        Ok(Self::Leading(sensors.collect::<Result<_, _>>()?))
    }
}

impl<'a> BeamCamera<'a> {
    fn of(machine: &'a Machine, beam: BeamDeflection) -> Result<Self, Error> {
        let cameras = machine.sensors.iter().filter_map(|sensor| match &sensor.sight {
            Sight::Camera(camera) => Some((sensor, &camera.table)),
            Sight::Stripe(_) => None,
        });
        let none = || Error::NoCamera { machine: machine.name.clone() };
        let (camera, table) = cameras.into_iter().next().ok_or_else(none)?;
        Ok(Self { camera, beam, reach_mm: half_mm(camera, table).ok_or_else(none)? - RIM_MM })
    }

    /// Returns the tracking settings for the speeds of `pass`, with cycles of `cycle_s`.
    pub(super) fn settings(&self, cycle_s: f64, pass: &Pass) -> Settings {
        let (slow, fast) = pass.speeds();
        Settings {
            period_s: self.camera.period_s,
            age_s: [0.0, UnderWay::oldest_s(self.camera.latency_s)],
            cycle_s,
            speed_mm_s: [slow, fast],
            reach_mm: DVec2::splat(self.reach_mm),
            noise_mm: self.camera.noise_mm,
            ..Settings::usual(fast)
        }
    }

    /// Returns the settings for replays of stored deviations.
    pub(super) fn replay_settings(&self, cycle_s: f64) -> ReplaySettings {
        ReplaySettings {
            period_s: self.camera.period_s,
            oldest_s: UnderWay::oldest_s(self.camera.latency_s),
            cycle_s,
            ..ReplaySettings::USUAL
        }
    }
}

/// Half the width or height of a camera's picture on the work, whichever is smaller, mm.
fn half_mm(camera: &Sensor, table: &HeightTable) -> Option<f64> {
    let size = DVec2::from_array(camera.size_px.map(|n| n as f64));
    let place = |part: DVec2| table.to_point(part * (size - 1.0), 0.0).ok();
    let middle: DVec3 = place(DVec2::splat(0.5))?;
    let sides = [DVec2::new(1.0, 0.5), DVec2::new(0.5, 1.0)].map(|side| Some(place(side)?.distance(middle)));
    Some(sides[0]?.min(sides[1]?))
}

fn places<'a>(planned: &'a PassMotion, seam: &'a Seam) -> impl Iterator<Item = (Joints, SeamFrame)> + 'a {
    let at = |i: u32| f64::from(i) / f64::from(PLACES);
    (0..=PLACES).map(move |i| (planned.path.at(planned.path.length() * at(i)), (seam.frame)(seam.length_mm * at(i))))
}

/// Returns the stripe sensor that leads head `number` along the whole pass.
fn leading<'a>(
    machine: &'a Machine,
    planned: &PassMotion,
    number: usize,
    seam: &Seam,
) -> Result<LeadingSensor<'a>, Error> {
    let mut best: Option<(f64, f64, &Sensor)> = None;
    for sensor in machine.sensors.iter().filter(|s| matches!(s.sight, Sight::Stripe(_))) {
        let lead = |(q, frame): (Joints, SeamFrame)| {
            let at = machine.sensor_frame(sensor, &q).translation - machine.forward_of(number, &q).point;
            let ahead = at.dot(frame.along);
            // Excludes sensors that look at another torch's joint.
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
            // Each of two heads has its own sensor: that of the other head is beside the joint.
            Ok(LeadingSensor { sensor, lead_mm: 0.5 * (least + most) })
        }
        Some((least, most, sensor)) => {
            let (sensor, ahead_mm) = (sensor.name.clone(), [least, most]);
            Err(Error::NotLeading { machine: machine_name, sensor, head, ahead_mm })
        }
        None => Err(Error::NoSensor { machine: machine_name, head }),
    }
}
