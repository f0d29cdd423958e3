use super::carrier::Wanted;
use super::scenario::Seam;
use super::sensor::Sensor;
use super::tally::{Tally, Watch};
use super::{SensorModel, World};
use crate::Sample;
use glam::DVec2;
use seamwright_machine::{Joints, Machine};
use seamwright_tracking::actuator::{Alarm, Cause, HeadTracking, SlideLimits};
use seamwright_tracking::lead::{Moment, SeamFrame, Sight};
use serde::Serialize;

/// What one head did at one instant, lateral and height in the torch's frame, mm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HeadSample {
    /// Where the joint truly is, from the planned path.
    pub seam: DVec2,
    /// By how much the torch is off the planned path.
    pub correction: DVec2,
    /// How far the weld is from the joint.
    pub miss: DVec2,
    /// What tracking made of it: standard deviation (mm; infinite where nothing is known) and how it is known.
    pub known: Option<(f64, Sight)>,
}

/// An alarm of tracking, at its first place.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct AlarmAt {
    /// Path length of the torch, mm.
    pub at_mm: f64,
    /// In words.
    pub alarm: &'static str,
    /// Why the sensor is blind, if it is.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cause: Option<&'static str>,
}

impl AlarmAt {
    fn new((at_mm, alarm, cause): &(f64, Alarm, Option<Cause>)) -> Self {
        Self { at_mm: *at_mm, alarm: alarm.name(), cause: cause.map(Cause::name) }
    }

    /// What was told, in words.
    #[must_use]
    pub fn text(&self) -> String {
        self.cause.map_or_else(|| self.alarm.to_owned(), |cause| format!("{}: {cause}", self.alarm))
    }
}

/// How far one head's weld lies from its joint; mm.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct HeadSummary {
    /// Name of the head.
    pub head: String,
    /// 99 % of the weld lie within this distance of the joint, lateral and height together.
    pub miss_p99_mm: f64,
    /// All of it does.
    pub miss_most_mm: f64,
    /// The same of a weld that keeps to the planned path: 99 % of it, and all.
    pub untracked_p99_mm: f64,
    /// All of it.
    pub untracked_most_mm: f64,
    /// True if the pass was tracked.
    pub tracked: bool,
    /// The greatest part of what corrections may do that was used: way, speed, acceleration, jerk.
    pub used: Option<[f64; 4]>,
    /// Where the torch was stopped before the end.
    pub stopped_mm: Option<f64>,
    /// What was told on the way.
    pub alarms: Vec<AlarmAt>,
}

/// One head at work on a seam that lies elsewhere.
pub(crate) struct LiveHead<'a> {
    /// Counted from 0.
    pub(crate) number: usize,
    seam: &'a Seam,
    world: World<'a>,
    tracking: Option<Tracking>,
    tracked: Tally,
    untracked: Tally,
    stopped_mm: Option<f64>,
    alarms: Vec<(f64, Alarm, Option<Cause>)>,
    last_s: Option<f64>,
}

struct Tracking {
    sensor: Sensor,
    head: Box<HeadTracking>,
    watch: [Watch; 2],
    /// By how much the torch is off the planned path, as the encoders say.
    correction: DVec2,
    known: (f64, Sight),
}

impl<'a> LiveHead<'a> {
    pub(super) fn new(
        number: usize,
        seam: &'a Seam,
        world: World<'a>,
        tracking: Option<(SensorModel, HeadTracking)>,
        seed: u64,
    ) -> Self {
        let tracking = tracking.map(|(model, head)| Tracking {
            sensor: Sensor::new(model, seed.wrapping_mul(8).wrapping_add(number as u64)),
            watch: head.limits().map(|l: SlideLimits| Watch::new(l, head.settings().cycle_s)),
            head: Box::new(head),
            correction: DVec2::ZERO,
            known: (f64::INFINITY, Sight::Unseen),
        });
        let (tracked, untracked) = (Tally::default(), Tally::default());
        Self { number, seam, world, tracking, tracked, untracked, stopped_mm: None, alarms: Vec::new(), last_s: None }
    }

    /// How far before the seam the torch must begin to be sure of its start, mm; none if it is not tracked.
    pub(crate) fn sighting_mm(&self) -> Option<(f64, f64)> {
        let settings = self.tracking.as_ref()?.head.settings();
        Some((settings.lead_mm + super::pass_scene::SIGHTING_MM, settings.speed_mm_s))
    }

    /// The planned frame of the torch.
    pub(crate) fn frame(&self, s: f64) -> SeamFrame {
        (self.seam.frame)(s)
    }

    /// One cycle at time `t` with the torch at `s` going along at `speed`: where the torch is to be, and the greatest
    /// part of its speed that it may have next.
    pub(crate) fn cycle(&mut self, t: f64, s: f64, speed: f64) -> (Wanted, f64) {
        let frame = self.frame(s);
        let Some(tracking) = &mut self.tracking else { return ((frame, DVec2::ZERO), 1.0) };
        tracking.sensor.look(&self.world, t, s, tracking.correction);
        while let Some(arrived) = tracking.sensor.arrived(t) {
            if let Some(measured) = arrived {
                tracking.head.take(&measured, t);
            }
        }
        let orders = tracking.head.cycle(Moment { t_s: t, s_mm: s, slide: tracking.correction }, speed);
        tracking.watch[0].add(orders.slide.x);
        tracking.watch[1].add(orders.slide.y);
        tracking.known = (orders.estimate.sigma_mm, orders.estimate.sight);
        let mut alarm = orders.alarm;
        // Beyond the end there is no joint to be seen, and none is needed; the last frame on it is a period before.
        let left = self.world.ends_mm.map_or(f64::INFINITY, |(_, end)| end - s);
        let settings = tracking.head.settings();
        let last = 3.0 * settings.period_s * settings.speed_mm_s;
        if (left < settings.lead_mm && alarm == Some(Alarm::Blind)) || (left < last && alarm == Some(Alarm::Coasting)) {
            alarm = None;
        }
        let wanted = (frame, orders.slide);
        // Before the seam nothing can be known of it.
        if s <= 0.0 {
            return (wanted, 1.0);
        }
        if let Some(alarm) = alarm {
            self.tell(s, alarm, orders.cause);
        }
        (wanted, orders.pace)
    }

    fn tell(&mut self, s: f64, alarm: Alarm, cause: Option<Cause>) {
        if self.alarms.iter().all(|(_, known, _)| *known != alarm) {
            self.alarms.push((s, alarm, cause));
        }
    }

    /// The axes cannot carry out what was wanted at `s`.
    pub(crate) fn out_of_reach(&mut self, s: f64) {
        self.tell(s, Alarm::StrokeEnd, None);
    }

    /// Where the torch truly is after the drives' step.
    pub(crate) fn feel(&mut self, machine: &Machine, s: f64, true_q: &Joints) {
        let frame = self.frame(s);
        let off = machine.forward_of(self.number, true_q).point - frame.point;
        if let Some(tracking) = &mut self.tracking {
            tracking.correction = DVec2::new(off.dot(frame.lateral), off.dot(frame.height));
        }
    }

    /// The torch was stopped here before the end of the pass.
    pub(crate) fn stopped(&mut self, s: f64) {
        self.stopped_mm = Some(s);
    }

    /// Where weld and joint are at a sample; none before the torch travels along the seam.
    pub(crate) fn measure(&mut self, machine: &Machine, sample: &Sample) -> Option<HeadSample> {
        let s = sample.set.law.s;
        if !(s.is_finite() && self.world.has(s)) {
            return None;
        }
        let frame = self.frame(s);
        let off = machine.forward_of(self.number, &sample.q).point - frame.point;
        let (joint, _) = self.world.crossing(s, off.dot(frame.along), s)?;
        let (planned, _) = self.world.crossing(s, 0.0, s)?;
        let correction = DVec2::new(off.dot(frame.lateral), off.dot(frame.height));
        let miss = correction - joint;
        if sample.travels() {
            let way = s - self.last_s.unwrap_or(s);
            self.last_s = Some(s);
            if way > 0.0 {
                self.tracked.add(miss, way);
                self.untracked.add(-planned, way);
            }
        }
        Some(HeadSample { seam: joint, correction, miss, known: self.tracking.as_ref().map(|t| t.known) })
    }

    pub(crate) fn finish(mut self, machine: &Machine) -> HeadSummary {
        let [miss_p99_mm, miss_most_mm] = [0.99, 1.0].map(|part| self.tracked.quantile(part));
        let [untracked_p99_mm, untracked_most_mm] = [0.99, 1.0].map(|part| self.untracked.quantile(part));
        let used = self.tracking.as_ref().map(|t| std::array::from_fn(|i| t.watch[0].used[i].max(t.watch[1].used[i])));
        HeadSummary {
            head: machine.heads[self.number].name.clone(),
            miss_p99_mm,
            miss_most_mm,
            untracked_p99_mm,
            untracked_most_mm,
            tracked: used.is_some(),
            used,
            stopped_mm: self.stopped_mm,
            alarms: self.alarms.iter().map(AlarmAt::new).collect(),
        }
    }
}
