use seamwright_machine::{Joints, MAX_AXES, Machine};
use seamwright_tracking::actuator::RESERVE;

/// By how much the axes are off their planned positions, so that it never jumps: it follows corrections; it comes to rest
/// where there are none or everything shall rest; from there it goes back to corrections, or to nothing. Each within what plans leave
/// to corrections of every axis' speed, acceleration and, on the way back, jerk.
#[derive(Debug)]
pub(super) struct OffPath {
    period: f64,
    /// Speed, acceleration and jerk of each axis.
    limits: [[f64; 3]; MAX_AXES],
    by: Joints,
    /// How fast it changes.
    rate: Joints,
    /// Corrections cannot be carried out any more, until it rests.
    lost: bool,
    /// It has been braked: what is followed next is gone to from there.
    braked: bool,
    /// What is corrected; none if that was not known in the last cycle.
    base: Option<Joints>,
    way: Option<Way>,
    /// The last set-point and its speed.
    last: Option<(Joints, Joints)>,
}

/// On the way from somewhere to what is followed: a quintic.
#[derive(Debug, Clone, Copy)]
struct Way {
    /// What is left at the start, and how fast that changes.
    from: Joints,
    rate: Joints,
    /// Time gone and time in all, s.
    gone: f64,
    whole: f64,
}

const NONE: Joints = [0.0; MAX_AXES];

impl OffPath {
    pub(super) fn new(machine: &Machine) -> Self {
        let mut limits = [[f64::INFINITY; 3]; MAX_AXES];
        for (limits, axis) in limits.iter_mut().zip(&machine.axes) {
            *limits = [axis.max_speed, axis.max_acceleration, axis.jerk()].map(|most| RESERVE * most);
        }
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

    /// A cycle with the positions that a correction of the planned ones `q` leads to, if there are any; false when there are
    /// none, then and until it was at rest.
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

    /// A cycle on the way to rest where it is; true when it is there. What would be followed is kept in mind.
    pub(super) fn rest(&mut self, q: &Joints, corrected: impl FnOnce() -> Option<Joints>) -> bool {
        self.base = corrected().map(|found| std::array::from_fn(|i| found[i] - q[i]));
        self.brake();
        let rests = self.rate.iter().all(|rate| *rate == 0.0);
        self.lost &= !rests;
        rests
    }

    fn brake(&mut self) {
        for i in 0..MAX_AXES {
            let brake = self.limits[i][1] * self.period;
            let rate = self.rate[i] - self.rate[i].clamp(-brake, brake);
            (self.by[i], self.rate[i]) = (self.by[i] + rate * self.period, rate);
        }
        self.braked = true;
    }

    /// A cycle with what is corrected, or on the way to that.
    fn go_on(&mut self, base: Joints) {
        let before = self.base.replace(base);
        if self.braked {
            let Some(before) = before else {
                // How fast it changes is known in the next cycle.
                return self.brake();
            };
            self.braked = false;
            let speed = std::array::from_fn(|i| (base[i] - before[i]) / self.period);
            self.begin_way(&before, &speed);
        }
        let left = self.left();
        for i in 0..MAX_AXES {
            let next = base[i] + left[i];
            (self.by[i], self.rate[i]) = (next, (next - self.by[i]) / self.period);
        }
    }

    /// The planned positions `q`, off by so much.
    pub(super) fn positions(&self, q: &Joints) -> Joints {
        std::array::from_fn(|i| q[i] + self.by[i])
    }

    /// From here on it goes to what is followed, which was there in the last cycle and changes so fast.
    fn begin_way(&mut self, base: &Joints, speed: &Joints) {
        let from: Joints = std::array::from_fn(|i| self.by[i] - base[i]);
        let rate: Joints = std::array::from_fn(|i| self.rate[i] - speed[i]);
        // Over T the quintic from rest to rest has by powers of T a speed of 15/8, an acceleration of 10/sqrt(3), a jerk of 60;
        // that of the speed at the start at most 1, 4 and 36 times it. Each has half of a limit.
        let time = |i: usize| {
            let [speed, acceleration, jerk] = self.limits[i].map(|limit| 0.5 * limit);
            let (by, rate) = (from[i].abs(), rate[i].abs());
            let way = (1.875 * by / speed).max((5.7736 * by / acceleration).sqrt()).max((60.0 * by / jerk).cbrt());
            way.max(4.0 * rate / acceleration).max((36.0 * rate / jerk).sqrt())
        };
        let whole = (0..MAX_AXES).map(time).fold(0.0, f64::max);
        self.way = Some(Way { from, rate, gone: 0.0, whole });
    }

    /// What is left of that way a cycle on.
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

    /// From here on it goes back to nothing, from how fast it changes now to rest.
    pub(super) fn begin_return(&mut self) {
        (self.base, self.braked) = (Some(NONE), false);
        self.begin_way(&NONE, &NONE);
    }

    /// A cycle of that; false when it is over.
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

    /// Speeds and accelerations of a set-point, by differences: what comes on top of a plan has no others.
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
    use crate::eyes::Random;
    use seamwright_machine::shipped;

    /// Corrections that wander, rest now and then, are lost and come again, and end: no set-point has more than what is left to
    /// corrections of speed and acceleration, by differences, beyond what was asked; at rest nothing moves.
    #[test]
    fn it_never_steps() {
        let machine = Machine::read("m", shipped("saddle-4axis").unwrap().text).unwrap();
        let period = machine.servo_period_s;
        let q = machine.home();
        for seed in 0..200 {
            let mut random = Random::new(seed);
            let mut off = OffPath::new(&machine);
            let (mut places, mut wanted, mut speed) = (vec![NONE; 3], NONE, NONE);
            let mut mode = 0;
            for cycle in 0..3000 {
                if random.chance(0.004) {
                    mode = (random.within(0.0, 4.0)) as u32;
                }
                // What is asked moves with a quarter of the limits.
                for i in 0..machine.axes.len() {
                    let [most, brisk, _] = off.limits[i].map(|limit| 0.25 * limit);
                    speed[i] = (speed[i] + brisk * period * random.within(-1.0, 1.0)).clamp(-most, most);
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
                for (i, [most, brisk, _]) in off.limits.iter().enumerate().take(machine.axes.len()) {
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
