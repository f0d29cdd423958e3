use seamwright_machine::Machine;
use seamwright_motion::PassMotion;

/// Slowest planned speed that is compared, as a part of the pass' fastest: below it the tip (nearly) stands still.
const SLOWEST: f64 = 0.2;
/// Most parts of a block whose speed is compared, and the shortest, s: in shorter ones the six decimals would show.
const MAX_PARTS: f64 = 16.0;
const PART_S: f64 = 1e-3;

/// Compares ways of the tip with the planned ones of the same times, between the acceleration and deceleration phases:
/// in these the speed changes by much within any block.
#[derive(Debug)]
pub(crate) struct EvenSpeed<'a> {
    machine: &'a Machine,
    motion: &'a PassMotion,
    /// Times of the travel between the acceleration and deceleration phases, s.
    steady: Vec<[f64; 2]>,
    /// Slowest speed that is compared, mm/s.
    slowest: f64,
}

impl<'a> EvenSpeed<'a> {
    /// Leaves out `margin` s next to the acceleration and deceleration phases: times read from a text are off by its
    /// digits.
    pub(crate) fn new(machine: &'a Machine, motion: &'a PassMotion, margin: f64) -> Self {
        let (_, fastest) = motion.tip_band(machine);
        let profile = &motion.profile;
        let legs = profile.legs();
        let steady =
            legs.iter().map(|leg| [profile.time(leg.run_up_end) + margin, profile.time(leg.run_down_start) - margin]);
        Self { machine, motion, steady: steady.collect(), slowest: SLOWEST * fastest }
    }

    /// Parts of a block of `seconds` whose speed is compared: the same in the plan of a post and in its proof.
    pub(crate) fn parts(seconds: f64) -> usize {
        (seconds / PART_S).floor().clamp(1.0, MAX_PARTS) as usize
    }

    /// Relative deviation of the tip's mean speed from the planned one, for a straight way of `way` mm between two
    /// `times` (s). `None` in the acceleration and deceleration phases, or where it (nearly) stands still.
    pub(crate) fn deviation(&self, times: [f64; 2], way: f64) -> Option<f64> {
        let [begin, end] = times;
        let leg = self.steady.partition_point(|steady| steady[1] < end);
        self.steady.get(leg).filter(|steady| steady[0] <= begin && begin < end)?;
        let tip = |t: f64| self.machine.forward(&self.motion.path.at(self.motion.profile.at(t, &mut 0).s)).point;
        let planned = tip(begin).distance(tip(end));
        (planned > self.slowest * (end - begin)).then(|| (way / planned - 1.0).abs())
    }
}
