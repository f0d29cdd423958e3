use super::error::JogError;
use super::state::{AxisState, State};
use rsruckig::prelude::*;
use seamwright_machine::{Axis, AxisLimits, Joints, MAX_AXES, Machine};

/// Margin of the soft ends inside the range, mm or rad, so that rounding never puts an axis beyond.
pub(super) const ROOM: f64 = 1e-7;

/// Approximate maximum duration of a motion, s: Ruckig refuses more than 7,600 s.
const LONGEST_S: f64 = 3000.0;

/// Synchronised motion of all axes from any state to rest at a target, within every axis' speed, acceleration, jerk and
/// range. The target can be replaced at any time. Uses Ruckig's algorithm (`rsruckig`).
///
/// The library never receives values that are not finite, or infinite limits, which it would take for a lower order.
/// Its results are checked against the ranges, which it does not know: if the synchronised motion would leave a range,
/// each axis takes its own minimum time.
#[derive(Debug)]
pub struct PointToPoint {
    limits: Vec<AxisLimits>,
    /// Minimum and maximum position of each axis; infinite on a continuous one.
    pub(super) ranges: Vec<(f64, f64)>,
    ruckig: Ruckig<0, IgnoreErrorHandler>,
    input: InputParameter<0>,
    trajectory: Trajectory<0>,
    goes_on: bool,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Goal {
    /// To rest at a position, no faster than a speed greater than 0.
    Position {
        at: f64,
        speed: f64,
    },
    Speed(f64),
}

impl PointToPoint {
    /// For a machine's axes.
    pub fn new(machine: &Machine) -> Self {
        let limits: Vec<AxisLimits> = machine.axes.iter().map(Axis::limits).collect();
        let ranges = machine.axes.iter().map(|axis| axis.range.unwrap_or((f64::NEG_INFINITY, f64::INFINITY))).collect();
        let axes = Some(limits.len());
        let mut input = InputParameter::new(axes);
        for (i, limits) in limits.iter().enumerate() {
            input.max_acceleration[i] = limits.acceleration;
            input.max_jerk[i] = limits.jerk;
        }
        input.per_dof_control_interface = Some(DataArrayOrVec::new(axes, ControlInterface::Position));
        let (ruckig, trajectory) = (Ruckig::new(axes, 1e-3), Trajectory::new(axes));
        Self { limits, ranges, ruckig, input, trajectory, goes_on: false }
    }

    /// Limits of the axes.
    pub fn limits(&self) -> &[AxisLimits] {
        &self.limits
    }

    /// Plans from `from` to rest at `target`, at up to the fraction `override_share` (above 0, up to 1) of the axes'
    /// speeds. No allocation, unless the library finds no motion.
    ///
    /// # Errors
    /// [`JogError::NoMotion`]; the previous plan is then lost.
    pub fn plan(&mut self, from: &State, target: &Joints, override_share: f64) -> Result<(), JogError> {
        let mut goals = [Goal::Speed(0.0); MAX_AXES];
        for (i, (limits, (low, high))) in self.limits.iter().zip(&self.ranges).enumerate() {
            // A range narrower than its margins yields a single point.
            let (low, high) = (low + ROOM, (high - ROOM).max(low + ROOM));
            goals[i] = Goal::Position { at: target[i].clamp(low, high), speed: override_share * limits.speed };
        }
        for synchronization in [Synchronization::Time, Synchronization::None] {
            if self.plan_goals(from, &goals, synchronization).is_ok() && self.stays_in_range(from) {
                return Ok(());
            }
        }
        Err(JogError::NoMotion)
    }

    /// Plans to one goal per axis without checking ranges.
    pub(super) fn plan_goals(
        &mut self,
        from: &State,
        goals: &[Goal; MAX_AXES],
        synchronization: Synchronization,
    ) -> Result<(), JogError> {
        let input = &mut self.input;
        input.synchronization = synchronization;
        self.goes_on = goals.iter().any(|g| matches!(g, Goal::Speed(v) if *v != 0.0));
        let mut finite = true;
        for (i, limits) in self.limits.iter().enumerate() {
            let AxisState { q, speed: v, acceleration: a } = from.axis(i);
            let (interface, at, speed, to) = match goals[i] {
                Goal::Position { at, speed } => (ControlInterface::Position, at, speed, 0.0),
                Goal::Speed(v) => (ControlInterface::Velocity, q, limits.speed, v),
            };
            finite &= [q, v, a, at, to].iter().all(|x| x.is_finite()) && speed > 0.0 && speed.is_finite();
            input.current_position[i] = q;
            input.current_velocity[i] = v;
            input.current_acceleration[i] = a;
            input.target_position[i] = at;
            input.target_velocity[i] = to;
            input.max_velocity[i] = speed;
            if let Some(interfaces) = &mut input.per_dof_control_interface {
                interfaces[i] = interface;
            }
        }
        if !finite {
            return Err(JogError::NoMotion);
        }
        // The library reports ignored errors in its result.
        match self.ruckig.calculate(input, &mut self.trajectory) {
            Ok(RuckigResult::Working | RuckigResult::Finished) => Ok(()),
            _ => Err(JogError::NoMotion),
        }
    }

    /// True if no axis moves farther beyond its range than it is already. Not valid for speeds as goals, for which the
    /// library's extremes are wrong.
    fn stays_in_range(&mut self, from: &State) -> bool {
        let reach = self.trajectory.get_position_extrema();
        let mut ends = self.ranges.iter().zip(from.q.iter().zip(reach.iter()));
        ends.all(|((low, high), (q, reach))| reach.min >= low.min(*q) && reach.max <= high.max(*q))
    }

    /// Duration of the planned motion, s.
    pub fn duration(&self) -> f64 {
        self.trajectory.get_duration()
    }

    /// The state at time `t` (s) from the start of the planned motion; at rest after its end.
    pub fn at(&self, t: f64) -> State {
        let mut state = State::default();
        let set = |i: usize, t: f64, p: f64, v: f64, a: f64, j: f64| {
            state.q[i] = p + t * (v + t * (a / 2.0 + t * j / 6.0));
            state.speed[i] = v + t * (a + t * j / 2.0);
            state.acceleration[i] = a + t * j;
        };
        let t = if self.goes_on { t } else { t.min(self.duration()) };
        self.trajectory.state_to_integrate_from(t, &mut 0, set);
        state
    }
}

impl Goal {
    /// Goal of an axis at `q` that moves at speed `wanted` up to the end of its range, slowing down in time.
    pub(super) fn jog(limits: &AxisLimits, range: (f64, f64), q: f64, wanted: f64) -> Self {
        let end = if wanted > 0.0 { range.1 - ROOM } else { range.0 + ROOM };
        let speed = wanted.abs();
        if speed < 1e-6 * limits.speed || (end - q) * wanted.signum() <= ROOM {
            return Self::Speed(0.0);
        }
        if end.is_infinite() {
            return Self::Speed(wanted);
        }
        // Far ends at low speeds take too long for the library: uses a nearer position, to be replaced in time.
        let farthest = speed * LONGEST_S;
        Self::Position { at: if (end - q).abs() > farthest { q + farthest.copysign(wanted) } else { end }, speed }
    }

    /// After this time goals of [`Goal::jog`] must be renewed, s.
    pub(super) const RENEW_S: f64 = 0.5 * LONGEST_S;
}
