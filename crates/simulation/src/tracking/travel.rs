/// A stretch of the torch's way.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Leg {
    /// Moves to this path length, mm, at this speed, mm/s; also backwards.
    To(f64, f64),
    /// Rests for this time, s.
    Hold(f64),
}

/// Acceleration along the seam, mm/s^2.
const ACCELERATION: f64 = 1000.0;

/// Travel of the torch along the seam, cycle by cycle, at constant acceleration and deceleration. It stops only at
/// reversals, holds and the end.
#[derive(Debug)]
pub(super) struct Travel<'a> {
    legs: &'a [Leg],
    leg: usize,
    held_s: f64,
    pub(super) s: f64,
    /// mm/s, negative backwards.
    pub(super) speed: f64,
}

impl<'a> Travel<'a> {
    pub(super) fn new(from_mm: f64, legs: &'a [Leg]) -> Self {
        Self { legs, leg: 0, held_s: 0.0, s: from_mm, speed: 0.0 }
    }

    /// Runs one cycle at up to `feed_override` of the speed; returns false at the end of the way, or after a stop.
    pub(super) fn step(&mut self, feed_override: f64, cycle_s: f64) -> bool {
        match self.legs.get(self.leg) {
            None => false,
            Some(Leg::Hold(time)) => {
                self.held_s += cycle_s;
                self.speed = 0.0;
                if self.held_s >= *time {
                    (self.leg, self.held_s) = (self.leg + 1, 0.0);
                }
                true
            }
            Some(Leg::To(to, speed)) => {
                let sense = (to - self.s).signum();
                let left = (to - self.s).abs();
                let goes_on =
                    matches!(self.legs.get(self.leg + 1), Some(Leg::To(next, _)) if (next - to) * sense > 0.0);
                // Maximum speed from which the torch can stop at the end of the leg, half a cycle early.
                let stop = (2.0 * ACCELERATION * left).sqrt() - 0.5 * ACCELERATION * cycle_s;
                let most = if goes_on { f64::INFINITY } else { stop.max(0.1 * ACCELERATION * cycle_s) };
                let wanted = sense * (speed * feed_override).min(most);
                let change = ACCELERATION * cycle_s;
                self.speed = wanted.clamp(self.speed - change, self.speed + change);
                let step = self.speed * cycle_s;
                if step * sense >= left {
                    self.leg += 1;
                    if !goes_on {
                        (self.s, self.speed) = (*to, 0.0);
                        return true;
                    }
                }
                self.s += step;
                feed_override > 0.0 || self.speed != 0.0
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn there_and_back() {
        let legs =
            [Leg::To(50.0, 20.0), Leg::To(100.0, 80.0), Leg::Hold(0.5), Leg::To(70.0, 20.0), Leg::To(120.0, 40.0)];
        let mut travel = Travel::new(-5.0, &legs);
        let (mut last, mut most, mut least, mut cycles) = ((-5.0, 0.0), f64::NEG_INFINITY, 100.0f64, 0);
        let mut turned = false;
        while travel.step(1.0, 1e-3) {
            cycles += 1;
            assert!((travel.speed - last.1).abs() <= 1.0 + 1e-9 || travel.speed == 0.0 && last.1.abs() < 5.0);
            assert!(travel.s - last.0 <= 0.0801 && travel.speed <= 80.0 + 1e-9);
            most = most.max(travel.s);
            turned |= (most - 100.0).abs() < 1e-9;
            if turned && cycles < 6000 {
                least = least.min(travel.s);
            }
            last = (travel.s, travel.speed);
        }
        assert!((travel.s - 120.0).abs() < 1e-9 && turned && (least - 70.0).abs() < 1e-9, "{} {least}", travel.s);
        let stopped = [Leg::To(100.0, 20.0)];
        let mut travel = Travel::new(0.0, &stopped);
        (0..1000).for_each(|_| assert!(travel.step(1.0, 1e-3)));
        assert!((0..1000).any(|_| !travel.step(0.0, 1e-3)), "a stop ends it");
        assert!(travel.s < 21.0);
    }
}
