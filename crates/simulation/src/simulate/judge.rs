use super::measure::measure;
use crate::sample::Sample;
use crate::summary::{Summary, Tally};
use crate::tracking::head_truth::HeadTruth;
use arrayvec::ArrayVec;
use seamwright_executive::tracking::Tracking;
use seamwright_executive::{Cycle, ProcessState};
use seamwright_machine::{Joints, Machine};
use seamwright_motion::feed_override::RunPhase;
use seamwright_motion::{Phase, ProfilePoint, SetPoint, WeldMotion};
use seamwright_program::{Pass, TorchPath};

/// Evaluates a simulated weld cycle by cycle from the true positions.
pub struct Judge<'a> {
    machine: &'a Machine,
    passes: &'a [(&'a dyn TorchPath, &'a Pass)],
    motion: &'a WeldMotion,
    seed: u64,
    tallies: Vec<Tally>,
    /// The heads of each pass, if its joint may differ from the plan.
    heads: Vec<ArrayVec<HeadTruth<'a>, 2>>,
    last: Option<Sample>,
    /// Passes that have started.
    begun: Vec<bool>,
}

impl<'a> Judge<'a> {
    pub(super) fn new(
        machine: &'a Machine,
        passes: &'a [(&'a dyn TorchPath, &'a Pass)],
        motion: &'a WeldMotion,
        heads: Vec<ArrayVec<HeadTruth<'a>, 2>>,
        seed: u64,
    ) -> Self {
        let tallies = motion.passes.iter().map(|p| Tally::new(machine, p)).collect();
        let begun = vec![false; motion.passes.len()];
        Self { machine, passes, motion, seed, tallies, heads, last: None, begun }
    }

    /// Returns the true state of a cycle.
    pub fn sample(&mut self, cycle: &Cycle<'_>) -> Sample {
        let axes = self.machine.axes.len();
        let drives = &cycle.reports.drives;
        let mut q: Joints = std::array::from_fn(|i| cycle.orders.set[i].position);
        let truth = cycle.reports.truth.unwrap_or(drives.position);
        // Without power, or without references, the axes do not follow set-points.
        let known = drives.referenced.count_ones() as usize == axes && !cycle.orders.home;
        let follows = drives.powered && known;
        if !follows {
            q[..axes].copy_from_slice(&truth[..axes]);
        }
        let phase = phase(cycle);
        let profile = ProfilePoint { s: cycle.place.s_mm, v: cycle.speed, a: f64::NAN, j: f64::NAN };
        let mut sample = Sample::nowhere();
        sample.set = SetPoint { t: cycle.t - self.machine.servo_period_s, phase, q, ..sample.set };
        sample.q[..axes].copy_from_slice(&truth[..axes]);
        sample.current[..axes].copy_from_slice(&drives.current[..axes]);
        if follows {
            sample.following_error[..axes].copy_from_slice(&drives.following_error[..axes]);
        }
        sample.mode = cycle.mode;
        if phase.arc() {
            sample.values = cycle.orders.process.values.map(|value| if value.is_finite() { value } else { 0.0 });
        }
        if cycle.phase.is_some() && (1..=self.passes.len()).contains(&cycle.place.pass) {
            (sample.pass, sample.set.profile) = (cycle.place.pass, profile);
            self.begun[sample.pass - 1] = true;
            self.measure_weld(&mut sample, cycle);
        }
        self.last = Some(sample);
        sample
    }

    fn measure_weld(&mut self, sample: &mut Sample, cycle: &Cycle<'_>) {
        let (machine, pass) = (self.machine, sample.pass);
        let planned = &self.motion.passes[pass - 1];
        measure(machine, self.passes[pass - 1].0, planned, sample);
        let mut worst = None;
        for head in &mut self.heads[pass - 1] {
            let seen = head.measure(machine, sample, cycle.tracked[head.number], &cycle.orders.seam);
            sample.heads[head.number] = seen;
            worst = seen.map(|s| s.miss.length()).into_iter().chain(worst).reduce(f64::max);
        }
        // Measure against the true seam.
        sample.path_error = worst.unwrap_or(sample.path_error);
        (sample.tip_speed, sample.planned_speed) = (0.0, 0.0);
        if let Some(last) = self.last.filter(|l| l.pass == pass) {
            let way = |from: f64, to: f64| (to - from) * planned.path.speed_rate(machine, 0.5 * (from + to));
            sample.tip_speed = way(last.tip_s, sample.tip_s) / machine.servo_period_s;
            sample.planned_speed = way(last.set.profile.s, sample.set.profile.s) / machine.servo_period_s;
        }
        let set = &cycle.orders.set;
        let rates = (std::array::from_fn(|i| set[i].velocity), std::array::from_fn(|i| set[i].acceleration));
        self.tallies[pass - 1].add(sample, &rates);
    }

    /// Returns the summaries of the passes, with the reports of `tracking`.
    pub fn summaries(self, tracking: Option<&Tracking<'_>>) -> Vec<Summary> {
        let reports = |i| tracking.map_or_else(Vec::new, |tracking| tracking.reports(i));
        let Self { machine, seed, .. } = self;
        let passes = self.tallies.into_iter().zip(self.heads).zip(self.begun).enumerate();
        let mut summaries = Vec::new();
        for (i, ((tally, heads), begun)) in passes {
            let mut told = reports(i).into_iter();
            let all = heads.into_iter().map(|head| (head, told.next()));
            // A pass that has not started has no results.
            let heads = all.filter(|(_, told)| begun || told.is_some()).map(|(head, told)| head.finish(machine, told));
            summaries.push(Summary { heads: heads.collect(), ..tally.finish(machine, seed) });
        }
        summaries
    }
}

fn phase(cycle: &Cycle<'_>) -> Phase {
    let burns = cycle.reports.source.burning && cycle.process != ProcessState::Off;
    match cycle.phase {
        Some(RunPhase::TravelDelay) if burns => Phase::TravelDelay,
        Some(RunPhase::Preflow | RunPhase::TravelDelay) => Phase::Preflow,
        Some(RunPhase::Travel) if burns => Phase::Travel,
        Some(RunPhase::Crater) if burns => Phase::Crater,
        Some(RunPhase::Crater | RunPhase::Postflow) => Phase::Postflow,
        Some(RunPhase::Travel | RunPhase::Held | RunPhase::RunOut | RunPhase::Move | RunPhase::Ended) | None => {
            Phase::Transfer
        }
    }
}
