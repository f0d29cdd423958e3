use seamwright_machine::Joints;

/// Positions, speeds and accelerations of all axes: mm or rad, and s.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct State {
    /// Positions.
    pub q: Joints,
    /// Speeds.
    pub speed: Joints,
    /// Accelerations.
    pub acceleration: Joints,
}

/// Position, speed and acceleration of one axis, or along a line: mm or rad, and s.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct AxisState {
    pub(super) q: f64,
    pub(super) speed: f64,
    pub(super) acceleration: f64,
}

impl AxisState {
    /// The state after `t` (s) with constant `jerk`.
    pub(super) fn after(self, t: f64, jerk: f64) -> Self {
        let Self { q, speed, acceleration } = self;
        Self {
            q: q + t * (speed + t * (acceleration / 2.0 + t * jerk / 6.0)),
            speed: speed + t * (acceleration + t * jerk / 2.0),
            acceleration: acceleration + t * jerk,
        }
    }
}

impl State {
    /// At rest.
    pub fn at_rest(q: &Joints) -> Self {
        Self { q: *q, ..Self::default() }
    }

    pub(super) fn axis(&self, i: usize) -> AxisState {
        AxisState { q: self.q[i], speed: self.speed[i], acceleration: self.acceleration[i] }
    }

    /// True if all speeds and accelerations are 0.
    pub fn rests(&self) -> bool {
        self.speed.iter().chain(&self.acceleration).all(|x| *x == 0.0)
    }
}
