use super::carrier::Wanted;
use super::head_requests::{HeadRequests, Step, Why};
use super::leading_head::{LeadingHead, TorchOffset};
use super::live_beam::{BeamSummary, LiveBeam};
use super::seam::Seam;
use crate::executive::{Seen, Tracked};
use arrayvec::ArrayVec;
use glam::{DVec3, Vec3Swizzles as _};
use seamwright_machine::{Joints, Machine};
use seamwright_message::{Language, Message};
use seamwright_program::TorchPath;
use seamwright_tracking::actuator::{Alarm, Lag};
use seamwright_tracking::beam::DeviationRecord;
use seamwright_tracking::lead::{Estimate, SeamFrame, Sight};
use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};

/// An alarm of tracking, at its first occurrence.
///
/// As JSON, `alarm` and `cause` are English text, and `code` and `arguments` are the alarm as data.
#[derive(Debug, Clone, PartialEq)]
pub struct AlarmAt {
    /// Path length of the torch, mm.
    pub at_mm: f64,
    /// The alarm.
    pub alarm: Message,
    /// Cause, if known: of a blind sensor, or of stored deviations that do not fit.
    pub cause: Option<Message>,
}

impl AlarmAt {
    /// Returns the words of [`AlarmAt::message`].
    #[must_use]
    pub fn text(&self) -> String {
        self.message().to_string()
    }

    /// Returns the alarm with its cause.
    #[must_use]
    pub fn message(&self) -> Message {
        let Some(cause) = &self.cause else { return self.alarm.clone() };
        Message::new("cell-alarm-with-cause").message("alarm", self.alarm.clone()).message("cause", cause.clone())
    }
}

impl Serialize for AlarmAt {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Self { at_mm, alarm, cause } = self;
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("at_mm", at_mm)?;
        map.serialize_entry("alarm", &alarm.in_language(Language::English))?;
        if let Some(cause) = cause {
            map.serialize_entry("cause", &cause.in_language(Language::English))?;
        }
        map.serialize_entry("code", &alarm.code)?;
        map.serialize_entry("arguments", &alarm.named_arguments())?;
        map.end()
    }
}

pub(super) enum Guide<'a> {
    /// A sensor ahead of the torch.
    Leading(Box<LeadingHead>),
    Beam(Box<LiveBeam<'a>>),
}

pub(super) struct HeadOrders {
    pub(super) wanted: Wanted,
    pub(super) requests: HeadRequests,
    /// Alarm that the head reports for the first time.
    pub(super) news: Option<Alarm>,
}

/// One head guided along its seam.
pub(crate) struct LiveHead<'a> {
    /// Counted from 0.
    number: usize,
    seam: &'a Seam,
    guide: Guide<'a>,
    path: &'a dyn TorchPath,
    /// Offset of the torch from the planned path, by the encoders: along, lateral, height; and from its line by the
    /// weave.
    off: DVec3,
    swing: DVec3,
    weaves: bool,
    estimate: Option<Estimate>,
    deflection_mm: f64,
    stopped_mm: Option<f64>,
    alarms: ArrayVec<(f64, Alarm, Option<Why>), { Alarm::ALL.len() }>,
}

/// Report of a guide on its head at the end.
#[derive(Debug, Clone)]
pub struct HeadReport {
    /// Maximum used share of the limits of corrections: stroke, speed, acceleration, jerk.
    pub used: [f64; 4],
    /// Position at which the torch was stopped before the end, mm.
    pub stopped_mm: Option<f64>,
    /// Alarms reported during the pass.
    pub alarms: Vec<AlarmAt>,
    /// Corrections by the beam, if one corrected.
    pub beam: Option<BeamSummary>,
    /// Deviations found by the beam, by the path length of the pass.
    pub found: Option<DeviationRecord>,
}

impl<'a> LiveHead<'a> {
    pub(super) fn new(number: usize, path: &'a dyn TorchPath, seam: &'a Seam, guide: Guide<'a>) -> Self {
        Self {
            number,
            seam,
            guide,
            path,
            off: DVec3::ZERO,
            swing: DVec3::ZERO,
            weaves: false,
            estimate: None,
            deflection_mm: 0.0,
            stopped_mm: None,
            alarms: ArrayVec::new(),
        }
    }

    /// Returns the distance before the seam from which the torch finds its start reliably, mm, and the maximum
    /// approach speed, mm/s; `None` without a leading sensor.
    pub(super) fn sighting_mm(&self) -> Option<(f64, f64)> {
        match &self.guide {
            Guide::Leading(leading) => Some(leading.sighting_mm()),
            Guide::Beam(_) => None,
        }
    }

    /// Returns the time for which a beam looks at the start of the seam, with the torch at rest there, s; `None`
    /// without a beam.
    pub(super) fn look_s(&self) -> Option<f64> {
        match &self.guide {
            Guide::Beam(beam) => Some(beam.look_s()),
            Guide::Leading(_) => None,
        }
    }

    /// Checks whether the weld may start. Errors: the alarm that prevents it.
    pub(super) fn ready(&mut self, s: f64) -> Result<(), Alarm> {
        let Guide::Beam(beam) = &self.guide else { return Ok(()) };
        let Err((alarm, cause)) = beam.ready() else { return Ok(()) };
        self.tell(s, alarm, cause);
        Err(alarm)
    }

    pub(super) fn frame(&self, s: f64) -> SeamFrame {
        (self.seam.frame)(s)
    }

    /// Runs one cycle: returns the required offset of the torch, and its maximum feed override in the next.
    pub(super) fn cycle(&mut self, seen: &Seen<'_>, step: &Step) -> HeadOrders {
        let frame = self.frame(step.s);
        let left = if self.seam.round_mm.is_some() { f64::INFINITY } else { self.seam.length_mm - step.s };
        let (wanted, requests, estimate) = match &mut self.guide {
            Guide::Leading(leading) => {
                if let Some(measured) = &seen.reports.sensors.measured[self.number] {
                    leading.take(measured, seen.t_s);
                }
                // The reports are those of the last period, unless the torch lags: then it is where it is now.
                let torch_mm = step.lag.torch_mm;
                let lags = step.lag != Lag::none(step.s) && self.weaves;
                let swing = if lags { swing_at(self.path, torch_mm, &(self.seam.frame)(torch_mm)) } else { self.swing };
                let (correction, swing) = (self.off.yz(), swing.yz());
                leading.cycle(left, step, frame, TorchOffset { correction, swing })
            }
            Guide::Beam(beam) => {
                if let Some(picture) = &seen.picture {
                    beam.take(picture, seen.t_s);
                }
                beam.cycle(left, step, frame, self.off)
            }
        };
        (self.estimate, self.deflection_mm) = (Some(estimate), requests.deflection_mm);
        let news = requests.alarm.and_then(|(alarm, why)| self.tell(step.s, alarm, why).then_some(alarm));
        HeadOrders { wanted, requests, news }
    }

    /// Records an alarm at `s`, at its first occurrence only. Returns true for the first.
    pub(super) fn tell(&mut self, s: f64, alarm: Alarm, why: Option<Why>) -> bool {
        let news = self.alarms.iter().all(|(_, known, _)| *known != alarm);
        if news {
            // The array has room for each alarm once.
            self.alarms.try_push((s, alarm, why)).unwrap_or_default();
        }
        news
    }

    /// Updates the offset of the torch from the encoders after the drives' step to `s`. The torch weaves while it is
    /// on its path.
    pub(super) fn feel(&mut self, machine: &Machine, s: f64, q: &Joints, weaves: bool) {
        let tip = machine.forward_of(self.number, q).ahead(self.path.drawn_back()).point;
        let frame = self.frame(s);
        self.weaves = weaves;
        self.swing = if weaves { swing_at(self.path, s, &frame) } else { DVec3::ZERO };
        self.off = frame.components(tip - frame.point) - self.swing;
    }

    /// Sets the position at which the torch was stopped before the end of the pass; `None` if it continues.
    pub(super) fn stopped(&mut self, s: Option<f64>) {
        self.stopped_mm = s;
    }

    /// Returns the current estimate and correction.
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

    /// Returns the deviations of the seam that the beam has found so far, by the path length of the pass.
    pub(super) fn found(&self) -> Option<DeviationRecord> {
        match &self.guide {
            Guide::Leading(_) => None,
            Guide::Beam(beam) => beam.found(),
        }
    }

    pub(super) fn report(&self) -> HeadReport {
        let (used, beam) = match &self.guide {
            Guide::Leading(leading) => (leading.used(), None),
            Guide::Beam(beam) => (beam.used(), Some(beam.summary())),
        };
        let requests = self.alarms.iter().map(|(at_mm, alarm, why)| AlarmAt {
            at_mm: *at_mm,
            alarm: alarm.message(),
            cause: why.map(|why| why.message()),
        });
        HeadReport { used, stopped_mm: self.stopped_mm, alarms: requests.collect(), beam, found: self.found() }
    }
}

/// Returns the offset of the torch from its line at `s` by the weave: along, lateral, height.
#[must_use]
pub fn swing_at(path: &dyn TorchPath, s: f64, frame: &SeamFrame) -> DVec3 {
    frame.components(path.weave().map_or(DVec3::ZERO, |weave| weave.swing(s.clamp(0.0, path.length()))))
}
