use super::measure::measure;
use crate::drives::Drives;
use crate::summary::{Summary, Tally};
use crate::tracking::{HeadSummary, LiveHead};
use crate::{Error, Sample};
use seamwright_machine::{Joints, Machine};
use seamwright_motion::{SetPoint, WeldMotion};
use seamwright_program::{Pass, TorchPath};

/// A simulated cell at work: its drives, what was seen last, and what is counted.
pub(super) struct SimulatedCell<'a, F> {
    machine: &'a Machine,
    passes: &'a [(&'a dyn TorchPath, &'a Pass)],
    motion: &'a WeldMotion,
    seed: u64,
    drives: Drives,
    tallies: Vec<Tally>,
    last: Option<Sample>,
    /// When the pass has begun, s.
    begun: f64,
    count: u64,
    observer: F,
}

impl<'a, F> SimulatedCell<'a, F> {
    pub(super) fn new(
        machine: &'a Machine,
        passes: &'a [(&'a dyn TorchPath, &'a Pass)],
        motion: &'a WeldMotion,
        seed: u64,
        observer: F,
    ) -> Result<Self, Error> {
        let tallies = motion.passes.iter().map(|p| Tally::new(machine.axes.len(), p)).collect();
        let drives = Drives::new(machine, seed)?;
        Ok(Self { machine, passes, motion, seed, drives, tallies, last: None, begun: 0.0, count: 0, observer })
    }

    /// Set-points shown so far.
    pub(super) fn count(&self) -> u64 {
        self.count
    }

    /// One period with a set-point of pass `pass` (from 1; 0 in the air) and the axes' speeds and accelerations in it;
    /// `heads` know where the seam truly is.
    pub(super) fn show<E: From<Error>>(
        &mut self,
        pass: usize,
        set: SetPoint,
        rates: &(Joints, Joints),
        heads: &mut [LiveHead<'_>],
    ) -> Result<(), E>
    where
        F: FnMut(&Sample) -> Result<(), E>,
    {
        let axes = self.machine.axes.len();
        let mut sample = Sample { pass, set, ..Sample::nowhere() };
        if self.last.is_none() {
            self.drives.settle_at(&set.q[..axes]);
        }
        for i in 0..axes {
            let order =
                seamwright_servo::SetPoint { position: set.q[i], velocity: rates.0[i], acceleration: rates.1[i] };
            let state = self.drives.step(i, order);
            sample.q[i] = state.position;
            sample.following_error[i] = state.following_error;
            sample.current[i] = state.current;
        }
        if pass > 0 {
            self.measure_weld(&mut sample, rates, heads);
        }
        self.count += 1;
        self.last = Some(sample);
        (self.observer)(&sample)
    }

    fn measure_weld(&mut self, sample: &mut Sample, rates: &(Joints, Joints), heads: &mut [LiveHead<'_>]) {
        let (machine, pass) = (self.machine, sample.pass);
        let planned = &self.motion.passes[pass - 1];
        measure(machine, self.passes[pass - 1].0, planned, sample);
        let mut worst = None;
        for head in heads.iter_mut() {
            let seen = head.measure(machine, sample);
            sample.heads[head.number] = seen;
            worst = seen.map(|s| s.miss.length()).into_iter().chain(worst).reduce(f64::max);
        }
        // The seam is where it truly is.
        sample.path_error = worst.unwrap_or(sample.path_error);
        match self.last.filter(|l| l.pass == pass) {
            Some(last) => {
                let way = |from: f64, to: f64| (to - from) * planned.path.speed_rate(machine, 0.5 * (from + to));
                sample.tip_speed = way(last.tip_s, sample.tip_s) / machine.servo_period_s;
                sample.planned_speed = way(last.set.law.s, sample.set.law.s) / machine.servo_period_s;
            }
            None => {
                self.begun = sample.set.t;
                (sample.tip_speed, sample.planned_speed) = (0.0, 0.0);
            }
        }
        self.tallies[pass - 1].add(sample, rates, sample.set.t - self.begun);
    }

    /// True positions of the axes; none before anything has been shown.
    pub(super) fn positions(&self) -> Option<&Joints> {
        self.last.as_ref().map(|sample| &sample.q)
    }

    /// What was counted, with what each pass' heads have to say.
    pub(super) fn finish(self, heads: Vec<Vec<HeadSummary>>) -> Vec<Summary> {
        let passes = self.tallies.into_iter().zip(&self.motion.passes).zip(heads);
        passes.map(|((tally, pass), heads)| Summary { heads, ..tally.finish(self.machine, pass, self.seed) }).collect()
    }
}
