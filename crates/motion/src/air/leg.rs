use seamwright_machine::{Course, Joints, Machine};

/// All axes from one set of positions to another at once, straight in axis space, from rest to rest as fast as the
/// slowest axis can: full acceleration, full speed, full deceleration.
#[derive(Debug, Clone, PartialEq)]
pub struct Leg {
    from: Joints,
    to: Joints,
    /// Highest speed and acceleration of the part that is done, 1/s and 1/s^2.
    speed: f64,
    acceleration: f64,
    duration: f64,
}

impl Leg {
    /// The leg on `machine`.
    pub fn new(machine: &Machine, from: &Joints, to: &Joints) -> Self {
        let least = |limit: fn(&seamwright_machine::Axis) -> f64| {
            let parts = machine.axes.iter().zip(from.iter().zip(to)).map(|(a, (p, q))| limit(a) / (p - q).abs());
            parts.fold(f64::INFINITY, f64::min)
        };
        let (speed, acceleration) = (least(|a| a.max_speed), least(|a| a.max_acceleration));
        // Short legs never reach the full speed.
        let speed = speed.min(acceleration.sqrt());
        let duration = if speed.is_finite() { 1.0 / speed + speed / acceleration } else { 0.0 };
        Self { from: *from, to: *to, speed, acceleration, duration }
    }

    /// Time from rest to rest, s.
    pub fn duration(&self) -> f64 {
        self.duration
    }

    /// Where it begins.
    pub fn start(&self) -> &Joints {
        &self.from
    }

    /// Where it ends.
    pub fn end(&self) -> &Joints {
        &self.to
    }

    /// Positions at time `t` (s) from its start, mm or rad.
    pub fn at_time(&self, t: f64) -> Joints {
        // At rest the ends themselves, without rounding.
        if t >= self.duration { self.to } else { self.at(self.part(t).0) }
    }

    /// The part that is done at time `t`, its speed (1/s) and acceleration (1/s^2).
    fn part(&self, t: f64) -> (f64, f64, f64) {
        let (v, a, left) = (self.speed, self.acceleration, self.duration - t);
        let ramp = v / a;
        if left <= 0.0 || self.duration <= 0.0 {
            (1.0, 0.0, 0.0)
        } else if t <= 0.0 {
            (0.0, 0.0, 0.0)
        } else if t < ramp {
            (0.5 * a * t * t, a * t, a)
        } else if left < ramp {
            (1.0 - 0.5 * a * left * left, a * left, -a)
        } else {
            (v * (t - 0.5 * ramp), v, 0.0)
        }
    }

    /// Speeds and accelerations at time `t` (s) from its start, mm or rad per s and s^2.
    pub fn rates(&self, t: f64) -> (Joints, Joints) {
        let (_, speed, acceleration) = self.part(t);
        let times = |f: f64| std::array::from_fn(|i| f * (self.to[i] - self.from[i]));
        (times(speed), times(acceleration))
    }
}

/// The part that is done, from 0 to 1.
impl Course for Leg {
    fn range(&self) -> (f64, f64) {
        (0.0, 1.0)
    }

    fn at(&self, s: f64) -> Joints {
        std::array::from_fn(|i| self.from[i] + s * (self.to[i] - self.from[i]))
    }

    fn greatest_rates(&self, _from: f64, _to: f64) -> Joints {
        std::array::from_fn(|i| (self.to[i] - self.from[i]).abs())
    }
}

/// Legs one after the other, at rest between them.
#[derive(Debug, Clone, PartialEq)]
pub struct AirMove {
    /// The legs.
    pub legs: Vec<Leg>,
    /// True if the first leg takes the torch straight back from the end of a weld.
    pub retracts: bool,
    /// True if the last leg brings it straight down to the start of the next.
    pub approaches: bool,
}

impl AirMove {
    /// The move through `points`, with neither retract nor approach.
    pub fn new(machine: &Machine, points: &[Joints]) -> Self {
        let legs = points.windows(2).map(|w| Leg::new(machine, &w[0], &w[1])).collect();
        Self { legs, retracts: false, approaches: false }
    }

    /// Time from rest to rest, s.
    pub fn duration(&self) -> f64 {
        self.legs.iter().map(Leg::duration).sum()
    }

    /// The leg at time `t` (s) from its start and the time since that leg's start; none if there is no leg.
    pub fn leg(&self, t: f64) -> Option<(&Leg, f64)> {
        let mut begun = 0.0;
        for leg in &self.legs {
            if t < begun + leg.duration {
                return Some((leg, t - begun));
            }
            begun += leg.duration;
        }
        self.legs.last().map(|leg| (leg, leg.duration))
    }

    /// Number of set-points, one a period from its start to its end.
    pub fn count(&self, period: f64) -> u64 {
        if self.legs.is_empty() { 0 } else { (self.duration() / period - 1e-9).ceil().max(0.0) as u64 + 1 }
    }
}
