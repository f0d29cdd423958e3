use super::carrier::Wanted;
use super::leading::Leading;
use super::live_beam::{BeamSample, BeamSummary, LiveBeam};
use super::scenario::Seam;
use crate::executive::{Seen, Tracked};
use arrayvec::ArrayVec;
use glam::{DVec2, DVec3};
use seamwright_machine::{Joints, Machine};
use seamwright_program::TorchPath;
use seamwright_tracking::actuator::{Alarm, Cause};
use seamwright_tracking::beam::{Beam, DeviationRecord, Misfit};
use seamwright_tracking::lead::{Estimate, SeamFrame, Sight};
use serde::Serialize;

/// What one head did at one instant, lateral and height in the torch's frame, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HeadSample {
    /// Where the joint truly is, from the planned path.
    pub seam: DVec2,
    /// By how much the weld is off the planned path: torch and deflection together.
    pub correction: DVec2,
    /// How far the weld is from the joint. A beam has no height: 0.
    pub miss: DVec2,
    /// What the beam did, if the pass is corrected by one.
    pub beam: Option<BeamSample>,
    /// What tracking made of it.
    pub tracked: Option<Tracked>,
}

/// An alarm of tracking, at its first place.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct AlarmAt {
    /// Path length of the torch, mm.
    pub at_mm: f64,
    /// In words.
    pub alarm: &'static str,
    /// Why, if that is known: of a blind sensor, of stored deviations that do not fit.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cause: Option<String>,
}

impl AlarmAt {
    /// What was told, in words.
    #[must_use]
    pub fn text(&self) -> String {
        self.cause.as_ref().map_or_else(|| self.alarm.to_owned(), |cause| format!("{}: {cause}", self.alarm))
    }
}

/// How far one head's weld lies from its joint; mm.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct HeadSummary {
    /// Name of the head.
    pub head: String,
    /// 99 % of the weld lie within this distance of the joint, lateral and height together; of a beam lateral.
    pub miss_p99_mm: f64,
    /// All of it does.
    pub miss_most_mm: f64,
    /// The same of a weld that keeps to the planned path: 99 % of it, and all.
    pub untracked_p99_mm: f64,
    /// All of it.
    pub untracked_most_mm: f64,
    /// True of a beam, which has no height: distances are lateral.
    pub lateral_only: bool,
    /// True if the pass was tracked.
    pub tracked: bool,
    /// The greatest part of what corrections may do that was used: way, speed, acceleration, jerk.
    pub used: Option<[f64; 4]>,
    /// Where the torch was stopped before the end.
    pub stopped_mm: Option<f64>,
    /// What was told on the way.
    pub alarms: Vec<AlarmAt>,
    /// How the beam corrected, if one did.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub beam: Option<BeamSummary>,
    /// What the beam found of the seam, by path length from the start of the weld.
    #[serde(skip)]
    pub deviations: Option<DeviationRecord>,
}

/// One cycle of a head.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Step {
    /// s.
    pub(crate) t: f64,
    /// Path length of the torch's set-point, mm.
    pub(crate) s: f64,
    /// Along the seam, mm/s.
    pub(crate) speed: f64,
    /// True while the arc or beam is on.
    pub(crate) welds: bool,
}

/// Why something is wrong.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Why {
    /// The sensor.
    Sensor(Cause),
    /// What is stored does not fit.
    Misfit(Misfit),
    /// The joint was not seen before the weld.
    NotSeen,
}

impl Why {
    fn text(&self) -> String {
        match self {
            Self::Sensor(cause) => cause.name().to_owned(),
            Self::NotSeen => "it was not seen before the weld".to_owned(),
            Self::Misfit(misfit) => {
                // What comes before it is the alarm's own name.
                let text = misfit.to_string();
                text.split_once(": ").map_or(text.clone(), |(_, rest)| rest.to_owned())
            }
        }
    }
}

/// What a head has to say in a cycle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Told {
    /// Greatest part of its speed that the torch may have next.
    pub(super) pace: f64,
    /// The worst that is wrong, and why.
    pub(super) alarm: Option<(Alarm, Option<Why>)>,
    /// What the beam does, and by how much it is deflected, mm.
    pub(super) beam: Beam,
    pub(super) deflection_mm: f64,
}

impl Told {
    pub(super) const NOTHING: Self = Self { pace: 1.0, alarm: None, beam: Beam::Weld, deflection_mm: 0.0 };
}

/// What guides a head.
pub(super) enum Guide<'a> {
    /// A sensor ahead of the torch.
    Leading(Box<Leading>),
    /// The beam itself.
    Beam(Box<LiveBeam<'a>>),
}

/// Orders for a head in a cycle.
pub(super) struct HeadOrders {
    pub(super) wanted: Wanted,
    pub(super) told: Told,
    /// An alarm that it tells for the first time.
    pub(super) news: Option<Alarm>,
}

/// One head that is guided along its seam.
pub(crate) struct LiveHead<'a> {
    /// Counted from 0.
    number: usize,
    seam: &'a Seam,
    guide: Guide<'a>,
    path: &'a dyn TorchPath,
    /// By how much the torch is off the planned path, as the encoders say: along, lateral, height; and off its line by its
    /// weave.
    off: DVec3,
    swing: DVec3,
    estimate: Option<Estimate>,
    deflection_mm: f64,
    stopped_mm: Option<f64>,
    alarms: ArrayVec<(f64, Alarm, Option<Why>), { Alarm::ALL.len() }>,
}

/// What a guide has to say of a head at the end.
#[derive(Debug, Clone)]
pub(crate) struct HeadReport {
    pub(crate) used: [f64; 4],
    pub(crate) stopped_mm: Option<f64>,
    pub(crate) alarms: Vec<AlarmAt>,
    pub(crate) beam: Option<BeamSummary>,
    /// By the path length of the pass.
    pub(crate) found: Option<DeviationRecord>,
}

impl<'a> LiveHead<'a> {
    pub(super) fn new(number: usize, (path, seam): (&'a dyn TorchPath, &'a Seam), guide: Guide<'a>) -> Self {
        Self {
            number,
            seam,
            guide,
            path,
            off: DVec3::ZERO,
            swing: DVec3::ZERO,
            estimate: None,
            deflection_mm: 0.0,
            stopped_mm: None,
            alarms: ArrayVec::new(),
        }
    }

    /// How far before the seam the torch must begin to be sure of its start, mm; none if no sensor leads it.
    pub(super) fn sighting_mm(&self) -> Option<(f64, f64)> {
        match &self.guide {
            Guide::Leading(leading) => Some(leading.sighting_mm()),
            Guide::Beam(_) => None,
        }
    }

    /// How long the start of the seam is looked at with the torch at rest there, s; none without a beam that looks.
    pub(super) fn look_s(&self) -> Option<f64> {
        match &self.guide {
            Guide::Beam(beam) => Some(beam.look_s()),
            Guide::Leading(_) => None,
        }
    }

    /// The weld may begin.
    ///
    /// # Errors
    /// What is wrong if not.
    pub(super) fn ready(&mut self, s: f64) -> Result<(), Alarm> {
        let Guide::Beam(beam) = &self.guide else { return Ok(()) };
        let Err((alarm, cause)) = beam.ready() else { return Ok(()) };
        self.tell(s, alarm, cause);
        Err(alarm)
    }

    /// The planned frame of the torch.
    pub(super) fn frame(&self, s: f64) -> SeamFrame {
        (self.seam.frame)(s)
    }

    /// One cycle: where the torch is to be, and the greatest part of its speed that it may have next.
    pub(super) fn cycle(&mut self, seen: &Seen<'_>, step: &Step) -> HeadOrders {
        let frame = self.frame(step.s);
        let left = if self.seam.round_mm.is_some() { f64::INFINITY } else { self.seam.length_mm - step.s };
        let (wanted, told, estimate) = match &mut self.guide {
            Guide::Leading(leading) => {
                if let Some(measured) = &seen.reports.sensors.measured[self.number] {
                    leading.take(measured, seen.t_s);
                }
                let off = (lateral_and_height(self.off), lateral_and_height(self.swing));
                leading.cycle(left, step, frame, off)
            }
            Guide::Beam(beam) => {
                if let Some(picture) = &seen.picture {
                    beam.take(picture, seen.t_s);
                }
                beam.cycle(left, step, frame, self.off)
            }
        };
        (self.estimate, self.deflection_mm) = (Some(estimate), told.deflection_mm);
        let news = told.alarm.and_then(|(alarm, why)| self.tell(step.s, alarm, why).then_some(alarm));
        HeadOrders { wanted, told, news }
    }

    /// Something to be told at `s`; only its first place is: true then.
    pub(super) fn tell(&mut self, s: f64, alarm: Alarm, why: Option<Why>) -> bool {
        let news = self.alarms.iter().all(|(_, known, _)| *known != alarm);
        if news {
            // There is room for each of them once.
            self.alarms.try_push((s, alarm, why)).unwrap_or_default();
        }
        news
    }

    /// Where the torch is after the drives' step to `s`, as their encoders say; it weaves while it is on its path.
    pub(super) fn feel(&mut self, machine: &Machine, s: f64, q: &Joints, weaves: bool) {
        let tip = machine.forward_of(self.number, q).point;
        let frame = self.frame(s);
        self.swing = if weaves { swing_at(self.path, s, &frame) } else { DVec3::ZERO };
        self.off = seen_in(tip - frame.point, &frame) - self.swing;
    }

    /// The torch was stopped here before the end of the pass, or goes on.
    pub(super) fn stopped(&mut self, s: Option<f64>) {
        self.stopped_mm = s;
    }

    /// What is known and done now.
    pub(super) fn tracked(&self) -> Option<Tracked> {
        let Estimate { value, sigma_mm, sight } = self.estimate?;
        let noise = match &self.guide {
            Guide::Leading(leading) => leading.noise_mm(),
            Guide::Beam(beam) => beam.noise_mm(),
        };
        let sure = matches!(sight, Sight::Seen | Sight::Bridged);
        let confidence = if sure { (noise / sigma_mm).clamp(0.0, 1.0) } else { 0.0 };
        Some(Tracked {
            deviation_mm: value.to_array(),
            correction_mm: [self.off.y + self.deflection_mm, self.off.z],
            sigma_mm,
            confidence,
            sight,
        })
    }

    /// What the beam has found of the seam so far, by the path length of the pass.
    pub(super) fn found(&self) -> Option<DeviationRecord> {
        match &self.guide {
            Guide::Leading(_) => None,
            Guide::Beam(beam) => beam.found(),
        }
    }

    /// What there is to say of it.
    pub(super) fn report(&self) -> HeadReport {
        let (used, beam) = match &self.guide {
            Guide::Leading(leading) => (leading.used(), None),
            Guide::Beam(beam) => (beam.used(), Some(beam.summary())),
        };
        let told = self.alarms.iter().map(|(at_mm, alarm, why)| AlarmAt {
            at_mm: *at_mm,
            alarm: alarm.name(),
            cause: why.map(|why| why.text()),
        });
        HeadReport { used, stopped_mm: self.stopped_mm, alarms: told.collect(), beam, found: self.found() }
    }
}

/// How far the weave takes the torch off its line at `s`: along, lateral, height.
pub(super) fn swing_at(path: &dyn TorchPath, s: f64, frame: &SeamFrame) -> DVec3 {
    seen_in(path.swing(s.clamp(0.0, path.length())).unwrap_or_default(), frame)
}

/// Along, lateral and height of a way.
pub(super) fn seen_in(way: DVec3, frame: &SeamFrame) -> DVec3 {
    DVec3::new(way.dot(frame.along), way.dot(frame.lateral), way.dot(frame.height))
}

pub(super) fn lateral_and_height(off: DVec3) -> DVec2 {
    DVec2::new(off.y, off.z)
}
