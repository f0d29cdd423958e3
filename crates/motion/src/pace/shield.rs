use super::course::{Course, State};
use super::timed::{AxisLimits, Limits, Pacing, Rates, Timed};

/// Part of the machine's limits up to which a course is accepted where it is checked. Laws use a little less by
/// themselves; what is left covers what happens between the places.
const ACCEPTED: f64 = 0.9995;
/// Places checked in the shortest time in which an axis can come from rest to its greatest acceleration or speed.
const PLACES: f64 = 32.0;
/// Steps of Newton's method for the time at which a border is crossed: start and curve are good.
const CROSSING_STEPS: usize = 3;

/// What a course violates first.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Breach {
    /// Time from the start of the course, s.
    pub(crate) t: f64,
    /// The segment in which it does.
    pub(crate) segment: usize,
    /// True for the jerk, false for speed or acceleration.
    pub(crate) jerk: bool,
}

/// Says whether all axes stay within their limits all along a course.
#[derive(Debug, Clone)]
pub(crate) struct Shield {
    pub(crate) limits: Limits,
    /// Time between places checked, s.
    spacing: f64,
    /// Greatest first and second derivative of a pace, where axes do not limit them.
    most: (f64, f64),
}

/// Values that one quantity may have.
pub(crate) type Interval = (f64, f64);

impl Shield {
    pub(crate) fn new(limits: Limits, period: f64) -> Self {
        let time = |l: &AxisLimits| {
            let of_jerk = if l.jerk.is_finite() { l.acceleration / l.jerk } else { f64::INFINITY };
            of_jerk.min(l.speed / l.acceleration)
        };
        let shortest = limits.0.iter().map(time).fold(f64::INFINITY, f64::min);
        let spacing = (shortest / PLACES).clamp(period / 8.0, 4.0 * period);
        // From standing to full pace in sixteen periods where nothing else limits it.
        Self { limits, spacing, most: (1.0 / (8.0 * period), 1.0 / (64.0 * period * period)) }
    }

    /// Checks a course until it is steady: at places close together, at both ends of its
    /// segments and on both sides of each of the law's borders. Steady at |phi| <= 1 is within what the law itself
    /// keeps.
    pub(crate) fn check<L: Timed + ?Sized>(&self, law: &L, course: &Course) -> Result<(), Breach> {
        let mut state = course.start;
        let mut t = 0.0;
        for (i, segment) in course.segments.iter().enumerate() {
            self.check_segment(law, state, segment.d2, segment.duration)
                .map_err(|b| Breach { t: t + b.t, segment: i, ..b })?;
            state = state.after(segment.duration, segment.d2);
            t += segment.duration;
        }
        Ok(())
    }

    fn check_segment<L: Timed + ?Sized>(&self, law: &L, start: State, d2: f64, duration: f64) -> Result<(), Breach> {
        let count = (duration / self.spacing).ceil().max(1.0);
        let step = duration / count;
        let mut now = start.after(0.0, d2);
        self.check_at(law, now, now.pace.phi < 0.0, 0.0)?;
        for k in 1..=count as u32 {
            let t = step * f64::from(k);
            let next = start.after(t, d2);
            self.check_borders(law, now, next, step, t - step)?;
            self.check_at(law, next, next.pace.phi > 0.0, t)?;
            now = next;
        }
        Ok(())
    }

    /// Checks both sides of the borders that the law crosses between two states `step` apart. Where it turns round
    /// between them the law's acceleration and jerk count for nothing, being multiplied by squares of the pace.
    fn check_borders<L: Timed + ?Sized>(
        &self,
        law: &L,
        now: State,
        next: State,
        step: f64,
        t: f64,
    ) -> Result<(), Breach> {
        if now.pace.phi * next.pace.phi < 0.0 {
            return Ok(());
        }
        let forward = next.theta > now.theta;
        let mut border = law.next_border(now.theta, forward);
        while border != next.theta && (border < next.theta) == forward && border.is_finite() {
            let mut dt = step * (border - now.theta) / (next.theta - now.theta);
            let mut at = now.after(dt, next.pace.d2);
            for _ in 0..CROSSING_STEPS {
                let to = dt + (border - at.theta) / at.pace.phi;
                // Newton's method only helps while it stays between the two.
                if !(to >= 0.0 && to <= step) {
                    break;
                }
                dt = to;
                at = now.after(dt, next.pace.d2);
            }
            at.theta = border;
            self.check_at(law, at, true, t + dt)?;
            self.check_at(law, at, false, t + dt)?;
            border = law.next_border(border, forward);
        }
        Ok(())
    }

    fn check_at<L: Timed + ?Sized>(&self, law: &L, state: State, before: bool, t: f64) -> Result<(), Breach> {
        let rates = law.at(state.theta, before);
        for (i, l) in self.limits.0.iter().enumerate() {
            let (v, a, j) = state.pace.played(rates.v[i], rates.a[i], rates.j[i]);
            let slow = v.abs() <= ACCEPTED * l.speed && a.abs() <= ACCEPTED * l.acceleration;
            let smooth = j.abs() <= ACCEPTED * l.jerk;
            if !(slow && smooth) {
                return Err(Breach { t, segment: 0, jerk: slow });
            }
        }
        Ok(())
    }

    /// Second derivatives of the pace that every axis' jerk allows at this instant (empty if the first is above the
    /// second).
    pub(crate) fn jerks(&self, rates: &Rates, pace: Pacing) -> Interval {
        let still = Pacing { d2: 0.0, ..pace };
        let mut range = (-self.most.1, self.most.1);
        for (i, l) in self.limits.0.iter().enumerate().filter(|(_, l)| l.jerk.is_finite()) {
            narrow(&mut range, still.played(rates.v[i], rates.a[i], rates.j[i]).2, rates.v[i], ACCEPTED * l.jerk);
        }
        range
    }

    /// First derivatives of the pace that every axis' acceleration allows at pace `phi`.
    pub(crate) fn accelerations(&self, rates: &Rates, phi: f64) -> Interval {
        let mut range = (-self.most.0, self.most.0);
        for (i, l) in self.limits.0.iter().enumerate() {
            narrow(&mut range, rates.a[i] * phi * phi, rates.v[i], ACCEPTED * l.acceleration);
        }
        range
    }

    /// The second derivative of a pace that every axis' jerk allows where the law's own acceleration and jerk are zero.
    pub(crate) fn strength(&self, rates: &Rates) -> f64 {
        let of_axis = |(i, l): (usize, &AxisLimits)| ACCEPTED * l.jerk / rates.v[i].abs();
        self.limits.0.iter().enumerate().map(of_axis).fold(self.most.1, f64::min)
    }
}

/// Narrows a range of x to |fixed + slope x| <= limit.
fn narrow(range: &mut Interval, fixed: f64, slope: f64, limit: f64) {
    if slope.abs() > 0.0 {
        let (a, b) = ((limit - fixed) / slope, (-limit - fixed) / slope);
        range.0 = range.0.max(a.min(b));
        range.1 = range.1.min(a.max(b));
    }
}
