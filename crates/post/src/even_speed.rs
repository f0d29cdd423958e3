use seamwright_machine::Machine;
use seamwright_motion::{Leg, PassMotion};

/// The tip's speed tells nothing where the plan is slower than this part of the pass' fastest: it (nearly) stands still.
const SLOWEST: f64 = 0.2;

/// Compares ways of the tip with the planned ones of the same times, between run-up and run-down: in these the speed
/// changes by much within any block.
#[derive(Debug)]
pub(crate) struct EvenSpeed<'a> {
    machine: &'a Machine,
    motion: &'a PassMotion,
    legs: Vec<Leg>,
    /// Slowest speed that is compared, mm/s.
    slowest: f64,
}

impl<'a> EvenSpeed<'a> {
    pub(crate) fn new(machine: &'a Machine, motion: &'a PassMotion) -> Self {
        let (_, fastest) = motion.tip_band(machine);
        Self { machine, motion, legs: motion.law.legs(), slowest: SLOWEST * fastest }
    }

    /// The deviation of the tip's mean speed from the planned one, as a part of it, if it goes `way` mm straight on
    /// between two `times` of the travel, s. None in run-up and run-down, or where it (nearly) stands still.
    pub(crate) fn deviation(&self, times: [f64; 2], way: f64) -> Option<f64> {
        let seconds = times[1] - times[0];
        let law = &self.motion.law;
        let [from, to] = times.map(|t| law.at(t, &mut 0).s);
        let leg = self.legs.partition_point(|leg| leg.to <= from);
        let leg = self.legs.get(leg).filter(|leg| from >= leg.run_up_end && to <= leg.run_down_start)?;
        // A leg without anything between has its run-down where its run-up ends.
        if leg.run_up_end >= leg.run_down_start || seconds <= 0.0 {
            return None;
        }
        let [a, b] = [from, to].map(|s| self.machine.forward(&self.motion.path.at(s)).point);
        let planned = a.distance(b);
        (planned > self.slowest * seconds).then(|| (way / planned - 1.0).abs())
    }
}
