use std::collections::VecDeque;

/// Joints of an arm.
pub const MAX_JOINTS: usize = 12;

/// Positions of joints in the units of the protocol, which is rad or degrees.
pub type JointPositions = [f64; MAX_JOINTS];

/// How a simulated arm follows its set-points.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Servo {
    /// Dead time from a set-point until the servo takes it, s.
    pub delay_s: f64,
    /// Time constant of the servo, s: a lag of first order.
    pub lag_s: f64,
}

impl Servo {
    /// `servoj` of a Universal Robots arm with its shortest look-ahead: 34 ms from the set-point to the report, as users
    /// measured it (Universal_Robots_Client_Library, number 86 of its discussions). A period of 2 ms until the program
    /// reads a set-point, and half of one for which it holds, are part of it.
    pub const UNIVERSAL_ROBOTS: Self = Self { delay_s: 0.021, lag_s: 0.01 };
}

/// The joints of a simulated arm.
#[derive(Debug, Clone)]
pub struct Arm {
    servo: Servo,
    positions: JointPositions,
    /// Set-points that the dead time holds back, with the times at which they count.
    coming: VecDeque<(f64, JointPositions)>,
    goal: JointPositions,
    time_s: f64,
    held: bool,
}

impl Arm {
    /// Creates an arm at rest.
    #[must_use]
    pub fn new(servo: Servo, positions: JointPositions) -> Self {
        Self { servo, positions, coming: VecDeque::new(), goal: positions, time_s: 0.0, held: true }
    }

    /// Returns the positions.
    #[must_use]
    pub fn positions(&self) -> &JointPositions {
        &self.positions
    }

    /// Gives a set-point at time `t_s`.
    pub fn follow(&mut self, goal: &JointPositions, t_s: f64) {
        self.held = false;
        self.coming.push_back((t_s + self.servo.delay_s, *goal));
    }

    /// Stops the arm where it is.
    pub fn hold(&mut self) {
        self.coming.clear();
        (self.goal, self.held) = (self.positions, true);
    }

    /// Lets time pass until `t_s`.
    pub fn advance(&mut self, t_s: f64) {
        while self.coming.front().is_some_and(|(due_s, _)| *due_s <= t_s) {
            let Some((due_s, goal)) = self.coming.pop_front() else { break };
            self.approach(due_s);
            self.goal = goal;
        }
        self.approach(t_s);
    }

    fn approach(&mut self, t_s: f64) {
        let passed_s = (t_s - self.time_s).max(0.0);
        self.time_s = self.time_s.max(t_s);
        let left = if self.servo.lag_s > 0.0 { (-passed_s / self.servo.lag_s).exp() } else { 0.0 };
        if !self.held {
            let goal = self.goal;
            self.positions.iter_mut().zip(goal).for_each(|(q, goal)| *q = goal + (*q - goal) * left);
        }
    }
}
