use super::World;
use super::carrier::Wanted;
use super::leading::Leading;
use super::live_beam::{BeamSample, BeamSummary, LiveBeam};
use super::scenario::Seam;
use super::tally::Tally;
use crate::Sample;
use glam::{DVec2, DVec3};
use seamwright_machine::{Joints, Machine};
use seamwright_program::TorchPath;
use seamwright_tracking::actuator::Alarm;
use seamwright_tracking::beam::DeviationRecord;
use seamwright_tracking::lead::{SeamFrame, Sight};
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
    /// What tracking made of it: standard deviation (mm; infinite where nothing is known) and how it is known.
    pub known: Option<(f64, Sight)>,
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

/// What a head has to say in a cycle.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Told {
    /// Greatest part of its speed that the torch may have next.
    pub(super) pace: f64,
    /// The worst that is wrong, and why.
    pub(super) alarm: Option<(Alarm, Option<String>)>,
}

impl Told {
    pub(super) const NOTHING: Self = Self { pace: 1.0, alarm: None };
}

/// What guides a head.
pub(super) enum Guide<'a> {
    /// A sensor ahead of the torch.
    Leading(Box<Leading>),
    /// The beam itself.
    Beam(Box<LiveBeam<'a>>),
}

/// One head at work on a seam that lies elsewhere.
pub(crate) struct LiveHead<'a> {
    /// Counted from 0.
    pub(crate) number: usize,
    seam: &'a Seam,
    world: World<'a>,
    guide: Option<Guide<'a>>,
    /// A beam, to which height does nothing.
    is_beam: bool,
    path: &'a dyn TorchPath,
    /// By how much the torch is off the planned path, as the encoders say: along, lateral, height; and off its line by its
    /// weave.
    off: DVec3,
    swing: DVec3,
    tracked: Tally,
    untracked: Tally,
    stopped_mm: Option<f64>,
    alarms: Vec<AlarmAt>,
    last_s: Option<f64>,
}

impl<'a> LiveHead<'a> {
    pub(super) fn new(
        (number, is_beam): (usize, bool),
        (path, seam): (&'a dyn TorchPath, &'a Seam),
        world: World<'a>,
        guide: Option<Guide<'a>>,
    ) -> Self {
        let (tracked, untracked) = (Tally::default(), Tally::default());
        let (off, swing, alarms) = (DVec3::ZERO, DVec3::ZERO, Vec::new());
        Self {
            number,
            seam,
            world,
            guide,
            is_beam,
            path,
            off,
            swing,
            tracked,
            untracked,
            stopped_mm: None,
            alarms,
            last_s: None,
        }
    }

    /// How far before the seam the torch must begin to be sure of its start, mm; none if no sensor leads it.
    pub(crate) fn sighting_mm(&self) -> Option<(f64, f64)> {
        match &self.guide {
            Some(Guide::Leading(leading)) => Some(leading.sighting_mm()),
            _ => None,
        }
    }

    /// How long the start of the seam is looked at with the torch at rest there, s; none without a beam that looks.
    pub(crate) fn look_s(&self) -> Option<f64> {
        match &self.guide {
            Some(Guide::Beam(beam)) => Some(beam.look_s()),
            _ => None,
        }
    }

    /// True if the weld may begin; tells what is wrong if not.
    pub(crate) fn is_ready(&mut self) -> bool {
        let Some(Guide::Beam(beam)) = &self.guide else { return true };
        let Err((alarm, cause)) = beam.ready() else { return true };
        self.tell(0.0, alarm.name(), cause);
        false
    }

    /// The planned frame of the torch.
    pub(crate) fn frame(&self, s: f64) -> SeamFrame {
        (self.seam.frame)(s)
    }

    /// One cycle: where the torch is to be, and the greatest part of its speed that it may have next.
    pub(crate) fn cycle(&mut self, step: &Step) -> (Wanted, f64) {
        let frame = self.frame(step.s);
        let (wanted, told) = match &mut self.guide {
            None => return ((frame, DVec2::ZERO), 1.0),
            Some(Guide::Leading(leading)) => {
                let off = (lateral_and_height(self.off), lateral_and_height(self.swing));
                leading.cycle(&self.world, step, frame, off)
            }
            Some(Guide::Beam(beam)) => beam.cycle(&self.world, step, frame, self.off),
        };
        if let Some((alarm, cause)) = told.alarm {
            self.tell(step.s, alarm.name(), cause);
        }
        (wanted, told.pace)
    }

    /// Something to be told at `s`; only its first place is.
    pub(crate) fn tell(&mut self, s: f64, alarm: &'static str, cause: Option<String>) {
        if self.alarms.iter().all(|known| known.alarm != alarm) {
            self.alarms.push(AlarmAt { at_mm: s, alarm, cause });
        }
    }

    /// The axes cannot carry out what was wanted at `s`.
    pub(crate) fn out_of_reach(&mut self, s: f64) {
        self.tell(s, Alarm::StrokeEnd.name(), None);
    }

    /// Where the torch truly is after the drives' step to `s` in the cycle at `t`; it weaves while it is on its path.
    pub(crate) fn feel(&mut self, machine: &Machine, (t, s): (f64, f64), true_q: &Joints, weaves: bool) {
        let tip = machine.forward_of(self.number, true_q).point;
        let frame = self.frame(s);
        self.swing = if weaves { seen(self.swings(s), &frame) } else { DVec3::ZERO };
        self.off = seen(tip - frame.point, &frame) - self.swing;
        if let Some(Guide::Beam(beam)) = &mut self.guide {
            beam.feel(t, s, true_q, tip);
        }
    }

    /// How far the weave takes the torch off its line at `s`.
    fn swings(&self, s: f64) -> DVec3 {
        self.path.swing(s.clamp(0.0, self.path.length())).unwrap_or_default()
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
        let tip = machine.forward_of(self.number, &sample.q).point;
        let off = seen(tip - self.swings(s) - frame.point, &frame);
        let (joint, _) = self.world.crossing(s, off.x, s)?;
        let (planned, _) = self.world.crossing(s, 0.0, s)?;
        let mut correction = lateral_and_height(off);
        let (known, beam) = match &self.guide {
            None => (None, None),
            Some(Guide::Leading(leading)) => (Some(leading.known()), None),
            Some(Guide::Beam(beam)) => {
                correction.x += beam.lands(joint.y - off.z);
                (Some(beam.known()), Some(beam.sample()))
            }
        };
        let counts = if self.is_beam { DVec2::X } else { DVec2::ONE };
        let miss = (correction - joint) * counts;
        // While the beam looks it does not weld.
        if sample.travels() && beam.is_none_or(|beam| beam.welds) {
            let way = s - self.last_s.unwrap_or(s);
            self.last_s = Some(s);
            if way > 0.0 {
                self.tracked.add(miss, way);
                self.untracked.add(-planned * counts, way);
            }
        }
        Some(HeadSample { seam: joint, correction, miss, beam, known })
    }

    pub(crate) fn finish(mut self, machine: &Machine) -> HeadSummary {
        let [miss_p99_mm, miss_most_mm] = [0.99, 1.0].map(|part| self.tracked.quantile(part));
        let [untracked_p99_mm, untracked_most_mm] = [0.99, 1.0].map(|part| self.untracked.quantile(part));
        let (used, beam, found) = match self.guide {
            None => (None, None, None),
            Some(Guide::Leading(leading)) => (Some(leading.used()), None, None),
            Some(Guide::Beam(beam)) => {
                let used = beam.used();
                let (summary, found) = beam.finish();
                (Some(used), Some(summary), found)
            }
        };
        HeadSummary {
            head: machine.heads[self.number].name.clone(),
            miss_p99_mm,
            miss_most_mm,
            untracked_p99_mm,
            untracked_most_mm,
            lateral_only: self.is_beam,
            tracked: used.is_some(),
            used,
            stopped_mm: self.stopped_mm,
            alarms: self.alarms,
            beam,
            deviations: found.map(|found| self.world.along.on_seam(&found)),
        }
    }
}

/// Along, lateral and height of a way.
fn seen(way: DVec3, frame: &SeamFrame) -> DVec3 {
    DVec3::new(way.dot(frame.along), way.dot(frame.lateral), way.dot(frame.height))
}

fn lateral_and_height(off: DVec3) -> DVec2 {
    DVec2::new(off.y, off.z)
}
