//! Set-points of the cycle, played at the times for which a control takes its own.

use seamwright_machine::{Joints, MAX_AXES};
use seamwright_servo::SetPoint;

/// Set-points that are kept: the largest store and the longest latency at the shortest period (0.25 ms), with reserve.
const KEPT: usize = 2048;
/// Correction of the playback's rate per set-point of a wrong store, as a fraction: as fast as supervision forgets a
/// missed cycle ([`crate::executive::Slack`]).
const GAIN: f64 = 0.01;
/// Maximum deviation of the playback's rate, as a fraction: a missed cycle slows the torch down by this.
const MAX_RATE_CHANGE: f64 = 0.02;
/// Maximum change of the playback's rate in a second, 1/s: 40 ms to the full deviation, so that axes feel no step.
const MAX_RATE_SLEW: f64 = 0.5;

/// Positions and speeds at a place of the playback, mm or rad, by axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Played {
    pub(super) positions: Joints,
    pub(super) velocities: Joints,
}

/// Result of a step of the playback.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Sampled {
    /// Positions on the path, and their place in set-points.
    OnPath(Joints, f64),
    /// Set-points are missing: the axes brake.
    Brakes(Joints),
    /// Set-points are missing, and the axes have come to rest.
    Stands(Joints),
}

/// Plays the set-points of the cycle with `level` of them in store.
///
/// Between two set-points it follows the cubic of their positions and speeds, so that neither position nor speed
/// steps. Its rate keeps the store: after missed cycles the torch is slower by at most [`MAX_RATE_CHANGE`] until the
/// store is full again. Without set-points all axes brake together along their last direction.
#[derive(Debug, Clone)]
pub(super) struct Playback {
    period_s: f64,
    level: f64,
    accelerations: Joints,
    kept: Box<[[SetPoint; MAX_AXES]]>,
    /// Number of the newest and of the oldest usable set-point.
    newest: u64,
    oldest: u64,
    /// Time at which the newest one arrived, s.
    arrived_s: f64,
    /// Number of set-points up to the newest that rest at one position.
    resting: u64,
    /// Current place, in set-points, and its time, s.
    place: f64,
    time_s: f64,
    rate: f64,
    /// The store is filled for the first time.
    is_filling: bool,
    /// Start of the braking, s.
    brakes_since_s: Option<f64>,
}

impl Playback {
    /// Creates the playback of set-points every `period_s` s; `accelerations` are those of the axes when they brake.
    pub(super) fn new(period_s: f64, level: u32, accelerations: Joints) -> Self {
        Self {
            period_s,
            level: f64::from(level),
            accelerations,
            kept: vec![[SetPoint::default(); MAX_AXES]; KEPT].into_boxed_slice(),
            newest: 0,
            oldest: 0,
            arrived_s: 0.0,
            resting: 0,
            place: 0.0,
            time_s: 0.0,
            rate: 1.0,
            is_filling: true,
            brakes_since_s: None,
        }
    }

    fn at_number(&self, number: u64) -> &[SetPoint; MAX_AXES] {
        &self.kept[(number % KEPT as u64) as usize]
    }

    /// Takes set-point `number`, which arrived at `at_s`. Numbers count up by 1; a gap forgets the earlier ones.
    pub(super) fn take(&mut self, number: u64, set: &[SetPoint; MAX_AXES], at_s: f64) {
        let follows = number == self.newest + 1 && self.newest > 0;
        let is_at_rest = set.iter().all(|set| set.velocity == 0.0);
        let is_same = |(a, b): (&SetPoint, &SetPoint)| a.position.total_cmp(&b.position).is_eq();
        let stays = follows && self.at_number(self.newest).iter().zip(set).all(is_same);
        self.resting = match (is_at_rest, stays) {
            (false, _) => 0,
            (true, true) => self.resting + 1,
            (true, false) => 1,
        };
        if !follows {
            self.oldest = number;
        }
        self.oldest = self.oldest.max((number + 1).saturating_sub(KEPT as u64));
        self.kept[(number % KEPT as u64) as usize] = *set;
        (self.newest, self.arrived_s) = (number, at_s);
    }

    /// Forgets all set-points before the newest one.
    pub(super) fn forget(&mut self) {
        self.oldest = self.newest;
    }

    /// Starts anew at time `t_s`, at a set-point at rest: the oldest one, or a later one with the store filled.
    pub(super) fn restart(&mut self, t_s: f64) {
        let oldest = self.oldest as f64;
        (self.place, self.time_s, self.rate) = (oldest.max(self.newest as f64 - self.level), t_s, 1.0);
        (self.is_filling, self.brakes_since_s) = (true, None);
    }

    /// Advances to `t_s`, by at most `max_step_s`, and returns the positions there.
    pub(super) fn sample(&mut self, t_s: f64, max_step_s: f64) -> Sampled {
        let step_s = (t_s - self.time_s).clamp(0.0, max_step_s);
        self.time_s = t_s;
        if let Some(since_s) = self.brakes_since_s {
            return self.brake(t_s - since_s);
        }
        // The next set-point is due a period after the last one; later it is not expected any more.
        let head = self.newest as f64 + ((t_s - self.arrived_s) / self.period_s).clamp(-self.level, 1.0);
        let goal = head - self.level;
        let rests_between = |place: f64| self.resting as f64 > self.newest as f64 - place.floor();
        let was_filling = self.is_filling;
        self.is_filling &= self.place > goal;
        if self.is_filling {
            // The first set-points rest.
        } else if was_filling {
            // The store was full at some time since the last step.
            self.place = goal.min(self.newest as f64);
        } else if rests_between(self.place.min(goal)) && goal >= self.oldest as f64 {
            // All positions between here and there are equal.
            (self.place, self.rate) = (goal, 1.0);
        } else {
            self.place += self.rate * step_s / self.period_s;
            let wanted = 1.0 + (GAIN * (goal - self.place)).clamp(-MAX_RATE_CHANGE, MAX_RATE_CHANGE);
            let slew = MAX_RATE_SLEW * step_s;
            self.rate += (wanted - self.rate).clamp(-slew, slew);
        }
        let beyond = self.place - self.newest as f64;
        if beyond > 0.0 {
            self.place = self.newest as f64;
            if self.resting == 0 {
                let beyond_s = beyond * self.period_s / self.rate;
                self.brakes_since_s = Some(t_s - beyond_s);
                return self.brake(beyond_s);
            }
        }
        Sampled::OnPath(self.at(self.place).map_or([0.0; MAX_AXES], |played| played.positions), self.place)
    }

    /// Returns positions `t_s` s after the start of braking: all axes along the tangent, each within its acceleration.
    fn brake(&self, t_s: f64) -> Sampled {
        let last = self.at_number(self.newest);
        let times =
            last.iter().zip(self.accelerations).map(|(set, a)| if a > 0.0 { set.velocity.abs() / a } else { 0.0 });
        let whole_s = times.fold(self.period_s, f64::max);
        let t = t_s.clamp(0.0, whole_s);
        let by_s = t - 0.5 * t * t / whole_s;
        let positions = last.map(|set| set.position + set.velocity * by_s);
        if t < whole_s { Sampled::Brakes(positions) } else { Sampled::Stands(positions) }
    }

    /// Returns positions and speeds at `place`; `None` outside the kept set-points.
    pub(super) fn at(&self, place: f64) -> Option<Played> {
        if !(self.oldest as f64..=self.newest as f64).contains(&place) || self.newest == 0 {
            return None;
        }
        let before = place.floor() as u64;
        let (a, b) = (self.at_number(before), self.at_number((before + 1).min(self.newest)));
        let (t, u) = (self.period_s, place - before as f64);
        let mut played = Played { positions: [0.0; MAX_AXES], velocities: [0.0; MAX_AXES] };
        for i in 0..MAX_AXES {
            let step = b[i].position - a[i].position;
            // Deviations of the ends' speeds from the mean: the cubic is the line plus these.
            let (from, to) = (a[i].velocity * t - step, step - b[i].velocity * t);
            played.positions[i] = a[i].position + step * u + u * (1.0 - u) * (from * (1.0 - u) + to * u);
            let slope = step + (1.0 - 2.0 * u) * (from * (1.0 - u) + to * u) + u * (1.0 - u) * (to - from);
            played.velocities[i] = slope / t;
        }
        Some(played)
    }

    /// Returns the current place.
    pub(super) fn place(&self) -> f64 {
        self.place
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use seamwright_testkit::Random;
    use std::f64::consts::TAU;

    const T: f64 = 1e-3;
    const ACCELERATION: f64 = 2000.0;

    fn playback(level: u32) -> Playback {
        Playback::new(T, level, [ACCELERATION; MAX_AXES])
    }

    /// 50 (w t - sin w t): rests before 0 and after a turn.
    fn path(t: f64) -> SetPoint {
        let w = 2.0;
        let angle = (w * t).clamp(0.0, TAU);
        let moves = w * t > 0.0 && w * t < TAU;
        let velocity = if moves { 50.0 * w * (1.0 - angle.cos()) } else { 0.0 };
        SetPoint { position: 50.0 * (angle - angle.sin()), velocity, acceleration: 0.0 }
    }

    fn sets(t: f64) -> [SetPoint; MAX_AXES] {
        let mut set = [SetPoint::default(); MAX_AXES];
        set[0] = path(t);
        set
    }

    /// At every rate of the control the samples are the path, one constant delay later.
    #[test]
    fn samples_are_the_path_delayed() {
        for control_s in [2e-3, 4e-3, 8e-3, 12e-3, 0.7e-3] {
            for level in [2, 10, 50] {
                let mut playback = playback(level);
                let (mut next_s, mut t0) = (0.0, 0.0);
                let mut worst = 0.0f64;
                for k in 1..4500u64 {
                    let now_s = T * k as f64;
                    playback.take(k, &sets(now_s - 0.5), now_s);
                    if k == 1 {
                        playback.restart(now_s);
                    }
                    while next_s < now_s + T - 1e-12 {
                        if next_s >= now_s {
                            match playback.sample(next_s, 0.03) {
                                Sampled::OnPath(q, _) => {
                                    let t = next_s - 0.5 - T * f64::from(level);
                                    worst = worst.max((q[0] - path(t).position).abs());
                                }
                                other => panic!("{other:?}"),
                            }
                        }
                        t0 += 1.0;
                        next_s = control_s * t0;
                    }
                }
                assert!(worst < 1e-6, "{control_s} {level}: {worst}");
            }
        }
    }

    /// Motion that begins while the store fills: the path is late by the store, or a little more, and never leaps.
    #[test]
    fn a_store_that_fills_under_way() {
        for control_s in [2e-3, 4e-3, 12e-3] {
            let mut playback = playback(5);
            for k in 1..1000u64 {
                // At rest until the store is started; then it moves at once.
                let now_s = T * k as f64;
                playback.take(k, &sets(now_s - 0.1), now_s);
                if k == 99 {
                    playback.forget();
                    playback.restart(now_s);
                }
                let ticks = (now_s / control_s).round();
                if k > 100 && (now_s - ticks * control_s).abs() < 1e-9 {
                    match playback.sample(now_s, 0.03) {
                        Sampled::OnPath(_, place) => {
                            let late = k as f64 - place;
                            assert!((4.9..6.0).contains(&late) || place <= 100.0, "{control_s} {k}: {late}");
                        }
                        other => panic!("{control_s} {k}: {other:?}"),
                    }
                }
            }
        }
    }

    /// Missed and late cycles: no underrun, and neither position nor speed steps.
    #[test]
    fn missed_cycles_are_made_up_for() {
        let mut random = Random::new(7);
        for case in 0..60 {
            let level = 6 + random.below(10) as u32;
            let mut playback = playback(level);
            let missed_at = 900 + random.below(2000) as u64;
            let missed = 1 + random.below(level as usize - 4) as u64;
            let mut samples = Vec::new();
            let mut number = 0;
            for tick in 1..6000u64 {
                let now_s = T * tick as f64;
                if !(missed_at..missed_at + missed).contains(&tick) {
                    number += 1;
                    // Up to 0.2 ms late.
                    playback.take(number, &sets(T * number as f64 - 0.5), now_s + 2e-4 * random.within(0.0, 1.0));
                    if number == 1 {
                        playback.restart(now_s);
                    }
                }
                if tick % 2 == 0 {
                    match playback.sample(now_s + 5e-4, 0.03) {
                        Sampled::OnPath(q, _) => samples.push(q[0]),
                        other => panic!("{case} {tick}: {other:?}"),
                    }
                }
            }
            let speeds: Vec<f64> = samples.windows(2).map(|w| (w[1] - w[0]) / (2.0 * T)).collect();
            let (low, high) = speeds.iter().fold((0.0f64, 0.0f64), |(a, b), v| (a.min(*v), b.max(*v)));
            // At most 200 mm/s on the path.
            assert!(low > -0.1 && high < 200.0 * 1.03, "{case}: {low} {high}");
            let jumps = speeds.windows(2).map(|w| (w[1] - w[0]).abs()).fold(0.0, f64::max);
            // 200 mm/s² of the path in 2 ms, and 1/s of the speed by the change of the rate.
            assert!(jumps < 2.0 * T * (200.0 + 2.0 * 0.5 * 200.0), "{case}: {jumps}");
            assert!((samples.last().unwrap() - path(9.0).position).abs() < 1e-9);
        }
    }

    /// Without set-points the axes brake along their direction, at their acceleration, and stand.
    #[test]
    fn without_set_points_axes_brake() {
        let mut playback = playback(4);
        for k in 1..=1800u64 {
            playback.take(k, &sets(T * k as f64 - 0.5), T * k as f64);
            if k == 1 {
                playback.restart(T);
            }
            playback.sample(T * k as f64, 0.03);
        }
        let mut positions = Vec::new();
        let mut stands = false;
        for tick in 1801..2500u64 {
            match playback.sample(T * tick as f64, 0.03) {
                Sampled::OnPath(q, _) | Sampled::Brakes(q) => positions.push(q[0]),
                Sampled::Stands(q) => {
                    positions.push(q[0]);
                    stands = true;
                }
            }
        }
        assert!(stands);
        let speeds: Vec<f64> = positions.windows(2).map(|w| (w[1] - w[0]) / T).collect();
        let changes = speeds.windows(2).map(|w| (w[1] - w[0]).abs() / T).fold(0.0, f64::max);
        assert!(changes < ACCELERATION * 1.05, "{changes}");
        assert!(speeds[0] > 50.0 && speeds.last().unwrap().abs() < 1e-12);
    }

    /// The speed of a place is the derivative of its position.
    #[test]
    fn speeds_are_derivatives() {
        let mut playback = playback(4);
        for k in 1..=1500u64 {
            playback.take(k, &sets(T * k as f64 - 0.2), T * k as f64);
        }
        for i in 0..1000 {
            let place = 300.0 + 1.173 * f64::from(i);
            let h = 1e-4;
            let at = |p: f64| playback.at(p).unwrap().positions[0];
            let slope = (at(place + h) - at(place - h)) / (2.0 * h * T);
            assert!((playback.at(place).unwrap().velocities[0] - slope).abs() < 1e-2, "{place}");
        }
    }
}
