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

impl State {
    /// At rest.
    pub fn at_rest(q: &Joints) -> Self {
        Self { q: *q, ..Self::default() }
    }

    /// Position, speed and acceleration of one axis.
    pub(super) fn axis(&self, i: usize) -> (f64, f64, f64) {
        (self.q[i], self.speed[i], self.acceleration[i])
    }

    /// True if all speeds and accelerations are 0.
    pub fn rests(&self) -> bool {
        self.speed.iter().chain(&self.acceleration).all(|x| *x == 0.0)
    }
}
