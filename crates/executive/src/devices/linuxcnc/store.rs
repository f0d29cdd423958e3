//! Store of set-points in the drives, controlled to a constant level.

use seamwright_machine::MAX_AXES;
use seamwright_servo::SetPoint;
use std::f64::consts::TAU;

/// Cycles to replace a missing set-point during motion: as slowly as supervision forgets a missed one. Meanwhile the
/// speed drops by at most a fiftieth.
const REFILLS: u32 = 100;
/// Level samples per decision.
const JUDGED: u32 = 8;

/// Positions of all axes.
pub(super) type Positions = [f64; MAX_AXES];

/// Decides in each cycle how many positions go to the drives: zero, one or more, so that they have `level` in store.
///
/// During motion slowing down yields a missing position. The positions sent lie on the path between the last two
/// set-points, delayed by up to one period. Then one more is sent. At rest the same position is sent again.
#[derive(Debug, Clone)]
pub(super) struct Store {
    level: u32,
    period_s: f64,
    /// Last set-points; `None` before the first cycle.
    last: Option<[SetPoint; MAX_AXES]>,
    /// Cycles elapsed in the current replacement.
    refills: u32,
    /// Sum and number of the level samples since the last decision.
    seen: (u32, u32),
    /// Number of the last position sent, and that at the last change of the level.
    sent: u32,
    changed: u32,
}

impl Store {
    /// Creates the store; the period is `period_s`.
    pub(super) fn new(level: u32, period_s: f64) -> Self {
        Self { level, period_s, last: None, refills: 0, seen: (0, 0), sent: 0, changed: 0 }
    }

    pub(super) fn last(&self) -> [SetPoint; MAX_AXES] {
        self.last.unwrap_or_default()
    }

    /// Reports the level at the time when the position with this number became active.
    pub(super) fn seen(&mut self, number: u32, level: u32) {
        // Samples from before the last change of the level are outdated.
        if number.wrapping_sub(self.changed) as i32 >= 0 {
            self.seen = (self.seen.0 + level, self.seen.1 + 1);
        }
    }

    /// Returns the number of set-points missing in store (negative: too many), or 0 until there are enough samples.
    fn missing(&mut self) -> i32 {
        let (sum, count) = self.seen;
        if count < JUDGED {
            return 0;
        }
        self.seen = (0, 0);
        // A quarter of a period is about the transfer time of a line.
        (f64::from(self.level) - f64::from(sum) / f64::from(count) + 0.25).floor() as i32
    }

    /// Sends the positions of this cycle: `send` gets each position with its number.
    pub(super) fn feed(&mut self, set: &[SetPoint; MAX_AXES], mut send: impl FnMut(u32, &Positions)) {
        let here = set.map(|set| set.position);
        let last = self.last.replace(*set);
        let (more, late) = match last {
            None => (self.level as i32, 0.0),
            Some(last) if *set == last && set.iter().all(|set| set.velocity == 0.0) => {
                self.refills = 0;
                (self.missing(), 0.0)
            }
            Some(_) => {
                let missing = self.refills == 0 && self.missing() > 0;
                self.refills += u32::from(missing || self.refills > 0);
                let part = f64::from(self.refills) / f64::from(REFILLS);
                // The rate of the delay starts and ends at zero.
                let late = part - (TAU * part).sin() / TAU;
                let full = self.refills == REFILLS;
                self.refills = if full { 0 } else { self.refills };
                (i32::from(full), late)
            }
        };
        let mut out = |positions: &Positions| {
            self.sent = self.sent.wrapping_add(1);
            send(self.sent, positions);
        };
        if late > 0.0 {
            out(&between(self.period_s, &last.unwrap_or(*set), set, 1.0 - late));
        } else if more >= 0 {
            out(&here);
        }
        (0..more).for_each(|_| out(&here));
        if more != 0 {
            self.changed = self.sent;
        }
    }
}

/// Positions at the fraction `u` of a period of `t` s between two set-points: the cubic with their velocities.
fn between(t: f64, a: &[SetPoint; MAX_AXES], b: &[SetPoint; MAX_AXES], u: f64) -> Positions {
    let mut positions = Positions::default();
    for (p, (a, b)) in positions.iter_mut().zip(a.iter().zip(b)) {
        let step = b.position - a.position;
        let (from, to) = (a.velocity * t - step, step - b.velocity * t);
        *p = a.position + step * u + u * (1.0 - u) * (from * (1.0 - u) + to * u);
    }
    positions
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::VecDeque;

    const T: f64 = 1e-3;

    /// One axis on a path with three derivatives, at rest before and after.
    fn path(t: f64) -> SetPoint {
        // 50 (w t - sin w t), which begins and ends at rest.
        let w = 2.0;
        let turn = |t: f64| 50.0 * (w * t - (w * t).sin());
        if t <= 0.0 || t >= TAU / w {
            return SetPoint { position: turn(t.clamp(0.0, TAU / w)), velocity: 0.0, acceleration: 0.0 };
        }
        let velocity = 50.0 * w * (1.0 - (w * t).cos());
        SetPoint { position: turn(t), velocity, acceleration: 50.0 * w * w * (w * t).sin() }
    }

    /// HAL model: takes one position a period, in some periods two or none; the store sees its level late.
    struct Drives {
        queue: VecDeque<(u32, f64)>,
        taken: Vec<f64>,
        samples: VecDeque<(u32, u32)>,
        underruns: u32,
    }

    impl Drives {
        fn period(&mut self) {
            match self.queue.pop_front() {
                Some((number, position)) => {
                    self.taken.push(position);
                    self.samples.push_back((number, self.queue.len() as u32));
                }
                None => self.underruns += 1,
            }
        }
    }

    /// Runs from rest over the path to rest; `misses` marks the missed cycles.
    fn run(level: u32, cycles: u32, misses: impl Fn(u32) -> bool) -> (Store, Drives) {
        let mut store = Store::new(level, T);
        let mut drives = Drives { queue: VecDeque::new(), taken: Vec::new(), samples: VecDeque::new(), underruns: 0 };
        let mut t = -0.5;
        for cycle in 0..cycles {
            if !misses(cycle) {
                let mut set = [SetPoint::default(); MAX_AXES];
                set[0] = path(t);
                t += T;
                store.feed(&set, |number, positions| drives.queue.push_back((number, positions[0])));
            }
            drives.period();
            // Samples come in batches of ten.
            if cycle % 10 == 9 {
                drives.samples.drain(..).for_each(|(number, level)| store.seen(number, level));
            }
        }
        (store, drives)
    }

    #[test]
    fn undisturbed_it_is_a_pure_delay() {
        for level in [2, 10, 50] {
            let (_, drives) = run(level, 4000, |_| false);
            assert_eq!((drives.underruns, drives.queue.len() as u32), (0, level));
            for (k, taken) in drives.taken.iter().enumerate() {
                let set = path(-0.5 + T * (k as f64 - f64::from(level))).position;
                assert!((taken - set).abs() < 1e-9, "{k}: {taken} {set}");
            }
        }
    }

    /// Missed cycles empty the store, which refills on the path at nearly full speed and without a step.
    #[test]
    fn missed_cycles_are_made_up_for() {
        let mut state = 3u64;
        for case in 0..300u64 {
            let mut next = |n: u64| {
                state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
                (state >> 33) % n
            };
            let level = 4 + next(20) as u32;
            let misses = 1 + next(u64::from(level) - 2) as u32;
            let begin = 400 + next(3000) as u32;
            let (_, drives) = run(level, 6500, |cycle| (begin..begin + misses).contains(&cycle));
            assert_eq!(drives.underruns, 0, "case {case}");
            let stock = drives.queue.len() as i32 - level as i32;
            assert!(stock.abs() <= 1, "case {case}: {stock}");
            let steps: Vec<f64> = drives.taken.windows(2).map(|w| w[1] - w[0]).collect();
            let bends: Vec<f64> = steps.windows(2).map(|w| w[1] - w[0]).collect();
            // At most 200 mm/s, and 200 mm/s² of the path plus the part from slowing down.
            let extremes =
                |all: &[f64]| all.iter().fold((0.0f64, 0.0f64), |(low, high), x| (low.min(*x), high.max(*x)));
            let (low, high) = extremes(&steps);
            assert!(low >= -1e-8 && high <= 0.2 + 1e-9, "case {case}: {low} {high}");
            let (low, high) = extremes(&bends);
            assert!(low.min(-high) >= -1e-6 * (200.0 + 140.0), "case {case}: {low} {high}");
            assert!((drives.taken.last().unwrap() - path(9.0).position).abs() < 1e-9);
        }
    }

    /// Surplus set-points are removed at rest.
    #[test]
    fn too_many_go_at_rest() {
        let mut store = Store::new(10, T);
        let set = [SetPoint::default(); MAX_AXES];
        let (mut queue, mut counts) = (VecDeque::new(), Vec::new());
        for cycle in 0..3000 {
            store.feed(&set, |number, _| queue.push_back(number));
            // HAL stops for a while.
            if !(100..107).contains(&cycle) {
                let number: u32 = queue.pop_front().unwrap();
                store.seen(number, queue.len() as u32);
            }
            counts.push(queue.len());
        }
        assert_eq!(counts.iter().max(), Some(&17));
        assert!(counts[2900..].iter().all(|count| (10..=11).contains(count)), "{:?}", &counts[2900..]);
    }
}
