//! Devices that see the joint ahead of the torches: sensors that lead them, or the beam that welds.

use super::beam_head::LATENCY_VARIATION_S;
use super::error::Error;
use super::seam::Seam;
use glam::{DVec2, DVec3};
use seamwright_geometry::HeightTable;
use seamwright_machine::{BeamDeflection, Joints, Machine, Sensor, Sight};
use seamwright_motion::PassMotion;
use seamwright_program::Pass;
use seamwright_tracking::beam::{ReplaySettings, Settings};
use seamwright_tracking::lead::{self, SeamFrame};

/// Number of positions along a pass at which sensors and axes are checked before the weld.
pub const PLACES: u32 = 120;
/// Half of the field of view of a stripe sensor, mm.
pub const FIELD_MM: f64 = 10.0;
/// Share of its maximum lead that a sensor must keep along a pass.
const LEAD_KEPT: f64 = 0.9;
/// Rim of a picture that is not evaluated, mm.
const RIM_MM: f64 = 1.6;

/// Devices that see the joint of each head of a pass.
#[derive(Debug, Clone)]
pub enum PassSensors<'a> {
    /// Stripe sensors ahead of the torches.
    Leading(Vec<LeadingSensor>),
    /// The beam, in interruptions of the weld.
    Beam(BeamCamera<'a>),
}

/// Stripe sensor ahead of a torch.
#[derive(Debug, Clone, Copy)]
pub struct LeadingSensor {
    /// Distance from the torch, mm.
    pub lead_mm: f64,
    /// Time between exposures, s.
    pub period_s: f64,
    /// Time from exposure to arrival, s.
    pub latency_s: f64,
    /// Standard deviation of the noise, mm.
    pub noise_mm: f64,
    /// Half of the field of view, mm.
    pub field_mm: f64,
}

impl LeadingSensor {
    /// Returns the tracking settings for such a sensor, with cycles of `cycle_s` and up to `speed_mm_s`.
    #[must_use]
    pub fn settings(&self, cycle_s: f64, speed_mm_s: f64) -> lead::Settings {
        let late = 1.5 * self.period_s;
        lead::Settings {
            cycle_s,
            period_s: self.period_s,
            age_s: [(self.latency_s - late).max(0.0), self.latency_s + late],
            field_mm: DVec2::splat(self.field_mm),
            noise_mm: self.noise_mm,
            ..lead::Settings::usual(self.lead_mm, speed_mm_s)
        }
    }
}

/// Camera that looks through the beam.
#[derive(Debug, Clone, Copy)]
pub struct BeamCamera<'a> {
    /// The camera.
    pub camera: &'a Sensor,
    pub(super) beam: BeamDeflection,
    /// Distance from the middle of the picture to the nearest side, less the rim, mm.
    reach_mm: f64,
}

impl<'a> PassSensors<'a> {
    /// Returns the beam's camera of a machine with a beam, otherwise the sensors that lead its heads along these seams.
    /// Errors: [`Error::NoCamera`], [`Error::NoSensor`], [`Error::NotLeading`].
    pub(super) fn of(machine: &'a Machine, planned: &PassMotion, seams: &[Seam]) -> Result<Self, Error> {
        if let Some(beam) = machine.deflection {
            return Ok(Self::Beam(BeamCamera::of(machine, beam)?));
        }
        let sensors = seams.iter().enumerate().map(|(number, seam)| leading(machine, planned, number, seam));
        Ok(Self::Leading(sensors.collect::<Result<_, _>>()?))
    }
}

impl<'a> BeamCamera<'a> {
    fn of(machine: &'a Machine, beam: BeamDeflection) -> Result<Self, Error> {
        let none = || Error::NoCamera { machine: machine.name.clone() };
        let (camera, table) = machine.cameras().next().ok_or_else(none)?;
        Ok(Self { camera, beam, reach_mm: half_mm(camera, table).ok_or_else(none)? - RIM_MM })
    }

    /// Returns the tracking settings for the speeds of `pass`, with cycles of `cycle_s`.
    pub(super) fn settings(&self, cycle_s: f64, pass: &Pass) -> Settings {
        let (slow, fast) = pass.speeds();
        Settings {
            period_s: self.camera.period_s,
            age_s: [0.0, self.oldest_s()],
            cycle_s,
            speed_mm_s: [slow, fast],
            reach_mm: DVec2::splat(self.reach_mm),
            noise_mm: self.camera.noise_mm,
            ..Settings::usual(fast)
        }
    }

    /// Returns the maximum age of a picture at its arrival, s.
    fn oldest_s(&self) -> f64 {
        self.camera.latency_s + 1.5 * LATENCY_VARIATION_S
    }

    /// Returns the settings for replays of stored deviations.
    pub(super) fn replay_settings(&self, cycle_s: f64) -> ReplaySettings {
        ReplaySettings { period_s: self.camera.period_s, oldest_s: self.oldest_s(), cycle_s, ..ReplaySettings::USUAL }
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
fn leading(machine: &Machine, planned: &PassMotion, number: usize, seam: &Seam) -> Result<LeadingSensor, Error> {
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
            Ok(LeadingSensor {
                lead_mm: 0.5 * (least + most),
                period_s: sensor.period_s,
                latency_s: sensor.latency_s,
                noise_mm: sensor.noise_mm,
                field_mm: FIELD_MM,
            })
        }
        Some((least, most, sensor)) => {
            let (sensor, ahead_mm) = (sensor.name.clone(), [least, most]);
            Err(Error::NotLeading { machine: machine_name, sensor, head, ahead_mm })
        }
        None => Err(Error::NoSensor { machine: machine_name, head }),
    }
}
