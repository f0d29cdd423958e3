use seamwright_machine::{AxisLimits, Joints, MAX_AXES, Machine};
use seamwright_tracking::actuator::RESERVE;

/// Offset of the axes from their planned positions, without jumps. It follows corrections. Without corrections, or if
/// everything is to rest, it comes to rest; from there it returns to corrections or to zero. It stays within the
/// share of every axis' speed, acceleration and, on the way back, jerk that plans leave to corrections.
#[derive(Debug)]
pub(super) struct PathOffset {
    period: f64,
    limits: [AxisLimits; MAX_AXES],
    by: Joints,
    rate: Joints,
    /// Corrections cannot be carried out until the offset is at rest.
    lost: bool,
    /// The offset was braked: the next corrections are approached from there.
    braked: bool,
    /// Current correction; `None` if it was unknown in the last cycle.
    base: Option<Joints>,
    way: Option<Way>,
    /// The last set-point and its speed.
    last: Option<(Joints, Joints)>,
}

/// Transition to the corrections: a quintic.
#[derive(Debug, Clone, Copy)]
struct Way {
    /// Remaining offset at the start, and its rate of change.
    from: Joints,
    rate: Joints,
    /// Elapsed and total time, s.
    gone: f64,
    whole: f64,
}

const NONE: Joints = [0.0; MAX_AXES];

impl PathOffset {
    pub(super) fn new(machine: &Machine) -> Self {
        let mut limits = [AxisLimits::NONE; MAX_AXES];
        limits.iter_mut().zip(&machine.axes).for_each(|(limits, axis)| *limits = axis.limits().scaled(RESERVE));
        Self {
            period: machine.servo_period_s,
            limits,
            by: NONE,
            rate: NONE,
            lost: false,
            braked: false,
            base: None,
            way: None,
            last: None,
        }
    }

    /// Runs a cycle with the positions of a correction of the planned ones `q`. Returns false without them, then
    /// and until the offset was at rest.
    pub(super) fn follow(&mut self, q: &Joints, corrected: impl FnOnce() -> Option<Joints>) -> bool {
        let found = if self.lost { None } else { corrected() };
        match found {
            Some(found) => self.go_on(std::array::from_fn(|i| found[i] - q[i])),
            None => {
                self.base = None;
                self.brake();
            }
        }
        self.lost = found.is_none();
        !self.lost
    }

    /// Runs a cycle of braking; returns true at rest. Stores the correction that would be followed.
    pub(super) fn rest(&mut self, q: &Joints, corrected: impl FnOnce() -> Option<Joints>) -> bool {
        self.base = corrected().map(|found| std::array::from_fn(|i| found[i] - q[i]));
        self.brake();
        let rests = self.rate.iter().all(|rate| *rate == 0.0);
        self.lost &= !rests;
        rests
    }

    fn brake(&mut self) {
        for i in 0..MAX_AXES {
            let brake = self.limits[i].acceleration * self.period;
            let rate = self.rate[i] - self.rate[i].clamp(-brake, brake);
            (self.by[i], self.rate[i]) = (self.by[i] + rate * self.period, rate);
        }
        self.braked = true;
    }

    /// Runs a cycle with corrections, or on the transition to them.
    fn go_on(&mut self, base: Joints) {
        let before = self.base.replace(base);
        if self.braked {
            let Some(before) = before else {
                // The rate of change is known in the next cycle.
                return self.brake();
            };
            self.braked = false;
            self.begin_way(&before, &std::array::from_fn(|i| (base[i] - before[i]) / self.period));
        }
        let left = self.left();
        for i in 0..MAX_AXES {
            let next = base[i] + left[i];
            (self.by[i], self.rate[i]) = (next, (next - self.by[i]) / self.period);
        }
    }

    /// Returns the planned positions `q` plus the offset.
    pub(super) fn positions(&self, q: &Joints) -> Joints {
        std::array::from_fn(|i| q[i] + self.by[i])
    }

    /// Starts a transition to the corrections, which were `base` in the last cycle and change at `speed`.
    fn begin_way(&mut self, base: &Joints, speed: &Joints) {
        let from: Joints = std::array::from_fn(|i| self.by[i] - base[i]);
        let rate: Joints = std::array::from_fn(|i| self.rate[i] - speed[i]);
        // A quintic from rest to rest over T has, by powers of T, a maximum speed of 15/8, acceleration of 10/sqrt(3)
        // and jerk of 60. The quintic of the initial speed has at most 1, 4 and 36 times that speed. Each gets half
        // of a limit.
        let time = |i: usize| {
            let AxisLimits { speed, acceleration, jerk } = self.limits[i].scaled(0.5);
            let (by, rate) = (from[i].abs(), rate[i].abs());
            let way = (1.875 * by / speed).max((5.7736 * by / acceleration).sqrt()).max((60.0 * by / jerk).cbrt());
            way.max(4.0 * rate / acceleration).max((36.0 * rate / jerk).sqrt())
        };
        let whole = (0..MAX_AXES).map(time).fold(0.0, f64::max);
        self.way = Some(Way { from, rate, gone: 0.0, whole });
    }

    /// Advances the transition by a cycle and returns its remaining offset.
    fn left(&mut self) -> Joints {
        let Some(Way { from, rate, gone, whole }) = &mut self.way else { return NONE };
        *gone += self.period;
        if *gone >= *whole {
            self.way = None;
            return NONE;
        }
        let u = *gone / *whole;
        let left = 1.0 - u * u * u * (10.0 - 15.0 * u + 6.0 * u * u);
        let on = u * (1.0 - u * u * (6.0 - 8.0 * u + 3.0 * u * u)) * *whole;
        std::array::from_fn(|i| left * from[i] + on * rate[i])
    }

    /// Starts the return to zero, from the current rate of change to rest.
    pub(super) fn begin_return(&mut self) {
        (self.base, self.braked) = (Some(NONE), false);
        self.begin_way(&NONE, &NONE);
    }

    /// Runs a cycle of the return; returns false when it is over.
    pub(super) fn returns(&mut self) -> bool {
        if self.way.is_none() && self.rests_on_plan() {
            return false;
        }
        self.go_on(NONE);
        true
    }

    fn rests_on_plan(&self) -> bool {
        self.by.iter().chain(&self.rate).all(|value| *value == 0.0)
    }

    /// Returns speeds and accelerations of a set-point by differences; an offset on top of a plan has no others.
    pub(super) fn rates(&mut self, q: &Joints) -> (Joints, Joints) {
        let (before, speed) = self.last.unwrap_or((*q, NONE));
        let v: Joints = std::array::from_fn(|i| (q[i] - before[i]) / self.period);
        let a: Joints = std::array::from_fn(|i| (v[i] - speed[i]) / self.period);
        self.last = Some((*q, v));
        (v, a)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand_pcg::Pcg64Mcg;
    use rand_pcg::rand_core::{Rng as _, SeedableRng as _};
    use seamwright_machine::shipped;

    /// Corrections wander, rest now and then, are lost, return and end. By differences, the offset keeps the speed
    /// and acceleration left to corrections; the return ends at rest on the plan.
    #[test]
    fn it_never_steps() {
        let machine = Machine::read("m", shipped("saddle-4axis").unwrap().text).unwrap();
        let period = machine.servo_period_s;
        let q = machine.home();
        for seed in 0..200 {
            let mut random = Pcg64Mcg::seed_from_u64(seed);
            let mut within =
                |low: f64, high: f64| low + (high - low) * (random.next_u64() >> 11) as f64 / (1u64 << 53) as f64;
            let mut off = PathOffset::new(&machine);
            let (mut places, mut wanted, mut speed) = (vec![NONE; 3], NONE, NONE);
            let mut mode = 0;
            for cycle in 0..3000 {
                if within(0.0, 1.0) < 0.004 {
                    mode = within(0.0, 4.0) as u32;
                }
                // The requested correction moves with a quarter of the limits.
                for i in 0..machine.axes.len() {
                    let AxisLimits { speed: most, acceleration: brisk, .. } = off.limits[i].scaled(0.25);
                    speed[i] = (speed[i] + brisk * period * within(-1.0, 1.0)).clamp(-most, most);
                    wanted[i] += speed[i] * period;
                }
                let found: Joints = std::array::from_fn(|i| q[i] + wanted[i]);
                match mode {
                    0 | 1 => drop(off.follow(&q, || Some(found))),
                    2 => drop(off.rest(&q, || Some(found))),
                    _ => drop(off.follow(&q, || None)),
                }
                places.push(off.by);
                let n = places.len();
                for (i, AxisLimits { speed: most, acceleration: brisk, .. }) in
                    off.limits.iter().enumerate().take(machine.axes.len())
                {
                    let p = |k: usize| places[n - 1 - k][i];
                    let v = (p(0) - p(1)) / period;
                    let a = (p(0) - 2.0 * p(1) + p(2)) / (period * period);
                    assert!(v.abs() <= *most && a.abs() <= brisk * (1.0 + 1e-6), "{seed} {cycle} {i}: {v} {a} {mode}");
                }
            }
            off.begin_return();
            let cycles = std::iter::repeat_with(|| off.returns()).take(100_000).take_while(|goes| *goes).count();
            assert!(cycles < 100_000 && off.rests_on_plan());
        }
    }
}
