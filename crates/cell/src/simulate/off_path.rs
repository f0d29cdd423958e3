use seamwright_machine::{Joints, MAX_AXES, Machine};
use seamwright_tracking::actuator::RESERVE;

/// By how much the axes are off their planned positions, so that it never jumps: it follows corrections; where there is
/// none any more it comes to rest for good; and it goes back to nothing when it shall. Each within what plans leave to
/// corrections of every axis' speed, acceleration and, on the way back, jerk.
#[derive(Debug)]
pub(super) struct OffPath {
    period: f64,
    /// Speed, acceleration and jerk of each axis.
    limits: [[f64; 3]; MAX_AXES],
    by: Joints,
    /// How fast it changes.
    rate: Joints,
    /// Corrections cannot be carried out any more.
    lost: bool,
    /// What it goes back from, and how fast that was changing; time gone and time in all, s.
    back: Option<(Joints, Joints, f64, f64)>,
    /// The last set-point and its speed.
    last: Option<(Joints, Joints)>,
}

impl OffPath {
    pub(super) fn new(machine: &Machine) -> Self {
        let mut limits = [[f64::INFINITY; 3]; MAX_AXES];
        for (limits, axis) in limits.iter_mut().zip(&machine.axes) {
            *limits = [axis.max_speed, axis.max_acceleration, axis.jerk()].map(|most| RESERVE * most);
        }
        let none = [0.0; MAX_AXES];
        Self { period: machine.servo_period_s, limits, by: none, rate: none, lost: false, back: None, last: None }
    }

    /// A cycle with the positions that a correction of the planned ones `q` leads to, if there are any; false when there are
    /// none, then and from then on.
    pub(super) fn follow(&mut self, q: &Joints, corrected: impl FnOnce() -> Option<Joints>) -> bool {
        let found = if self.lost { None } else { corrected() };
        self.lost = found.is_none();
        for i in 0..MAX_AXES {
            let next = match &found {
                Some(found) => found[i] - q[i],
                None => {
                    let brake = self.limits[i][1] * self.period;
                    self.by[i] + (self.rate[i] - self.rate[i].clamp(-brake, brake)) * self.period
                }
            };
            (self.by[i], self.rate[i]) = (next, (next - self.by[i]) / self.period);
        }
        !self.lost
    }

    /// The planned positions `q`, off by so much.
    pub(super) fn positions(&self, q: &Joints) -> Joints {
        std::array::from_fn(|i| q[i] + self.by[i])
    }

    /// From here on it goes back to nothing, from how fast it changes now to rest.
    pub(super) fn begin_return(&mut self) {
        // Over T the quintic from rest to rest has by powers of T a speed of 15/8, an acceleration of 10/sqrt(3), a jerk of 60;
        // that of the speed at the start at most 1, 4 and 36 times it. Each has half of a limit.
        let time = |i: usize| {
            let [speed, acceleration, jerk] = self.limits[i].map(|limit| 0.5 * limit);
            let (by, rate) = (self.by[i].abs(), self.rate[i].abs());
            let way = (1.875 * by / speed).max((5.7736 * by / acceleration).sqrt()).max((60.0 * by / jerk).cbrt());
            way.max(4.0 * rate / acceleration).max((36.0 * rate / jerk).sqrt())
        };
        let whole = (0..MAX_AXES).map(time).fold(0.0, f64::max);
        self.back = Some((self.by, self.rate, 0.0, whole));
    }

    /// A cycle of that; false when it is over.
    pub(super) fn returns(&mut self) -> bool {
        let Some((from, rate, gone, whole)) = &mut self.back else { return false };
        if *gone >= *whole {
            return false;
        }
        *gone += self.period;
        let u = (*gone / *whole).min(1.0);
        let left = 1.0 - u * u * u * (10.0 - 15.0 * u + 6.0 * u * u);
        let on = u * (1.0 - u * u * (6.0 - 8.0 * u + 3.0 * u * u)) * *whole;
        self.by = std::array::from_fn(|i| left * from[i] + on * rate[i]);
        true
    }

    /// Speeds and accelerations of a set-point, by differences: what comes on top of a plan has no others.
    pub(super) fn rates(&mut self, q: &Joints) -> (Joints, Joints) {
        let (before, speed) = self.last.unwrap_or((*q, [0.0; MAX_AXES]));
        let v: Joints = std::array::from_fn(|i| (q[i] - before[i]) / self.period);
        let a: Joints = std::array::from_fn(|i| (v[i] - speed[i]) / self.period);
        self.last = Some((*q, v));
        (v, a)
    }
}
