use super::limits::SlideLimits;
use crate::lead::Error;

/// Maximum averaging window of set-points, s; half of it is the lag that previews compensate.
const LONGEST_MEAN_S: f64 = 0.04;
/// Maximum number of cycles in the averaging window.
const ROOM: usize = 160;
/// Gain with which small errors are corrected, 1/s.
const GAIN: f64 = 100.0;
/// Fraction of the acceleration planned for correcting errors; the rest follows the target.
const CATCH_UP: f64 = 0.9;
/// Fraction of a limit that set-points use, to absorb rounding.
const ROUNDING: f64 = 1.0 - 1e-9;

/// One axis of a cross slide: set-points that follow a target within the limits of stroke, speed, acceleration and
/// jerk.
///
/// A target within the limits is followed exactly, [`Self::lag_s`] late; any other is caught up with as fast as they
/// allow. The follower keeps speed and acceleration. The mean of its last positions exceeds neither, and its jerk is at
/// most twice that acceleration divided by the window.
#[derive(Debug, Clone)]
pub struct Slide {
    limits: SlideLimits,
    cycle_s: f64,
    /// Acceleration reduced so that the mean keeps the jerk limit, mm/s^2.
    acceleration: f64,
    target: f64,
    position: f64,
    velocity: f64,
    last: [f64; ROOM],
    cycles: usize,
    next: usize,
}

impl Slide {
    /// Creates a slide at rest in its middle.
    ///
    /// # Errors
    /// [`Error::Value`] for invalid limits, and for a cycle outside 0.25 to 40 ms.
    pub fn new(limits: SlideLimits, cycle_s: f64) -> Result<Self, Error> {
        limits.check()?;
        if !(LONGEST_MEAN_S / ROOM as f64..=LONGEST_MEAN_S).contains(&cycle_s) {
            return Err(Error::not_between("cycle_s", cycle_s, [0.00025, 0.04]));
        }
        let mean_s = (2.0 * limits.motion.acceleration / limits.motion.jerk).min(LONGEST_MEAN_S);
        let cycles = ((mean_s / cycle_s).floor() as usize).clamp(1, ROOM);
        // A mean over n cycles changes per cycle by 1/n of the change in acceleration.
        let kept = 0.5 * limits.motion.jerk * cycles as f64 * cycle_s;
        let acceleration = limits.motion.acceleration.min(kept) * ROUNDING;
        let rest = (0.0, 0.0, 0.0);
        let (target, position, velocity) = rest;
        Ok(Self { limits, cycle_s, acceleration, target, position, velocity, last: [0.0; ROOM], cycles, next: 0 })
    }

    /// Returns the limits.
    #[must_use]
    pub fn limits(&self) -> &SlideLimits {
        &self.limits
    }

    /// Returns the acceleration in use, mm/s^2; below its limit where the jerk limit requires it.
    #[must_use]
    pub fn acceleration(&self) -> f64 {
        self.acceleration
    }

    /// Returns the lag of set-points behind targets, s.
    #[must_use]
    pub fn lag_s(&self) -> f64 {
        0.5 * (self.cycles - 1) as f64 * self.cycle_s
    }

    /// Returns the set-point of the next cycle towards `target`, mm.
    pub fn step(&mut self, target: f64) -> f64 {
        let (dt, limits) = (self.cycle_s, self.limits);
        let stroke = limits.stroke_mm * ROUNDING;
        let target = if target.is_finite() { target.clamp(-stroke, stroke) } else { self.target };
        let rate = ((target - self.target) / dt).clamp(-limits.motion.speed, limits.motion.speed);
        let wanted = rate + self.catch_up(self.target - self.position);
        self.target = target;
        let change = self.acceleration * dt;
        // Keeps the speed low enough to stop before the end of the stroke, a cycle early.
        let room = |to_end: f64| self.fastest_to_rest(to_end);
        let speed = limits.motion.speed * ROUNDING;
        let low = -room(self.position + stroke).min(speed);
        let high = room(stroke - self.position).min(speed);
        let velocity = wanted.clamp(low, high);
        self.velocity = velocity.clamp(self.velocity - change, self.velocity + change);
        self.position += self.velocity * dt;
        self.mean()
    }

    /// Returns the set-point of the next cycle, mm, braking at full acceleration; at rest it is constant.
    pub fn brake(&mut self) -> f64 {
        let change = self.acceleration * self.cycle_s;
        self.velocity -= self.velocity.clamp(-change, change);
        self.position += self.velocity * self.cycle_s;
        self.target = self.position;
        self.mean()
    }

    fn mean(&mut self) -> f64 {
        self.last[self.next] = self.position;
        self.next = (self.next + 1) % self.cycles;
        self.last[..self.cycles].iter().sum::<f64>() / self.cycles as f64
    }

    /// Returns the speed that corrects an error: proportional while small, then limited by braking.
    fn catch_up(&self, error: f64) -> f64 {
        let a = CATCH_UP * self.acceleration;
        let small = a / (GAIN * GAIN);
        let size = error.abs();
        let speed = if size < small { GAIN * size } else { (2.0 * a * (size - 0.5 * small)).sqrt() };
        speed.copysign(error)
    }

    /// Returns the maximum speed in the next cycle that leaves room to brake in steps: v dt (1 + 2 + ... ) <= room.
    fn fastest_to_rest(&self, room: f64) -> f64 {
        let step = self.acceleration * self.cycle_s;
        // v dt + v^2 / 2a + v dt / 2 <= room, solved for v.
        let b = 1.5 * step;
        ((b * b + 2.0 * self.acceleration * room.max(0.0)).sqrt() - b).max(0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use seamwright_machine::AxisLimits;
    use seamwright_testkit::Random;

    const CYCLE: f64 = 1e-3;
    const MOTION: AxisLimits = AxisLimits { speed: 50.0, acceleration: 1000.0, jerk: 20_000.0 };

    fn limits(random: &mut Random) -> SlideLimits {
        let mut scale = |middle: f64| middle * 10f64.powf(0.7 * random.within(-1.0, 1.0));
        let stroke_mm = scale(8.0);
        let motion = AxisLimits { speed: scale(40.0), acceleration: scale(800.0), jerk: scale(20_000.0) };
        SlideLimits { stroke_mm, motion }
    }

    /// Differences of set-points keep all limits for any target.
    #[test]
    fn limits_hold() {
        let mut random = Random::new(1);
        for case in 0..150 {
            let limits = limits(&mut random);
            let mut slide = Slide::new(limits, CYCLE).unwrap();
            let (mut p, mut target, mut rate, mut braked) = ([0.0; 4], 0.0, 0.0, 0u32);
            for cycle in 0..4000 {
                match random.below(200) {
                    0 => target = 1.5 * limits.stroke_mm * random.within(-1.0, 1.0),
                    1 => rate = 2.0 * limits.motion.speed * random.within(-1.0, 1.0),
                    2 => rate = 0.0,
                    _ => target += rate * CYCLE + 1e-3 * random.within(-1.0, 1.0),
                }
                braked = if random.one_in(400) { 100 } else { braked.max(1) - 1 };
                p = [p[1], p[2], p[3], if braked > 0 { slide.brake() } else { slide.step(target) }];
                let v = |i: usize| (p[i + 1] - p[i]) / CYCLE;
                let a = |i: usize| (v(i + 1) - v(i)) / CYCLE;
                assert!(p[3].abs() <= limits.stroke_mm, "{case} {cycle}: {} of {}", p[3], limits.stroke_mm);
                let AxisLimits { speed, acceleration, jerk } = limits.motion;
                assert!(v(2).abs() <= speed * (1.0 + 1e-6), "{case} {cycle}");
                assert!(a(1).abs() <= acceleration * (1.0 + 1e-6), "{case} {cycle}");
                assert!(((a(1) - a(0)) / CYCLE).abs() <= jerk * (1.0 + 1e-6) + 1e-3, "{case} {cycle}");
            }
        }
    }

    /// A braked slide stands exactly still after the time that acceleration and averaging need.
    #[test]
    fn what_is_braked_rests() {
        let limits = SlideLimits { stroke_mm: 50.0, motion: MOTION };
        let mut slide = Slide::new(limits, CYCLE).unwrap();
        for _ in 0..300 {
            slide.step(40.0);
        }
        let needed = ((50.0 / slide.acceleration() + 2.0 * slide.lag_s()) / CYCLE) as usize + 2;
        let places: Vec<f64> = (0..2 * needed).map(|_| slide.brake()).collect();
        assert!(places[0] < places[needed] && places[needed] < 40.0);
        assert!(places[needed..].windows(2).all(|p| p[0].to_bits() == p[1].to_bits()), "{:?}", &places[needed..]);
    }

    /// A target within the limits is followed with the lag, exactly except for the averaging of a curve.
    #[test]
    fn what_can_be_followed_is() {
        let limits = SlideLimits { stroke_mm: 15.0, motion: MOTION };
        for hz in [0.5, 1.0, 2.0] {
            let w = std::f64::consts::TAU * hz;
            let target = |t: f64| (w * t).sin() + 0.5 * (0.3 * w * t).cos() - 0.5;
            let mut slide = Slide::new(limits, CYCLE).unwrap();
            let lag = slide.lag_s();
            // Mean of a sine over the window, less its middle.
            let bias = 1.2 * (w * lag).powi(2) / 6.0 + 1e-6;
            for i in 0..5000 {
                let t = f64::from(i) * CYCLE;
                let off = (slide.step(target(t)) - target(t - lag)).abs();
                assert!(t < 0.5 || off < bias, "{hz} Hz at {t}: {off}, {bias}");
            }
        }
    }

    /// A step response has negligible overshoot and takes little more than the minimum time.
    #[test]
    fn steps_are_fast() {
        let limits = SlideLimits { stroke_mm: 15.0, motion: MOTION };
        for step in [0.1, 1.0, 5.0] {
            let mut slide = Slide::new(limits, CYCLE).unwrap();
            let a = slide.acceleration();
            let shortest = 2.0 * (step / a).sqrt() + step / MOTION.speed + 2.0 * slide.lag_s();
            let places: Vec<f64> = (0..2000).map(|_| slide.step(step)).collect();
            let most = places.iter().copied().fold(0.0, f64::max);
            assert!(most < step + 0.02, "{step}: {most}");
            let last = places.iter().rposition(|p| (p - step).abs() > 0.02 * step).unwrap() as f64 * CYCLE;
            assert!(last < 1.4 * shortest + 0.04, "{step}: {last} s, {shortest} s");
        }
    }

    #[test]
    fn what_cannot_be_is_refused() {
        let good = SlideLimits { stroke_mm: 15.0, motion: MOTION };
        let bad = [
            ("stroke_mm", SlideLimits { stroke_mm: 0.0, ..good }, CYCLE),
            ("speed", SlideLimits { motion: AxisLimits { speed: -1.0, ..MOTION }, ..good }, CYCLE),
            ("acceleration", SlideLimits { motion: AxisLimits { acceleration: f64::NAN, ..MOTION }, ..good }, CYCLE),
            ("jerk", SlideLimits { motion: AxisLimits { jerk: f64::INFINITY, ..MOTION }, ..good }, CYCLE),
            ("cycle_s", good, 0.0),
        ];
        for (name, limits, cycle) in bad {
            assert!(matches!(Slide::new(limits, cycle), Err(Error::Value { key, .. }) if key == name), "{name}");
        }
    }
}
