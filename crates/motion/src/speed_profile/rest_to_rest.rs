use serde::{Deserialize, Serialize};

/// A parameter `tau` of a piece of path from rest to rest, regular at rest.
///
/// A start from rest with constant jerk has `s ~ t^3`, so the squared speed by path length goes with the power 4/3
/// and its second derivative is unbounded at rest. With `u = u0 + L (x^3 - x^4 / 2)`, `x = tau / L`, over the
/// acceleration phase `tau` in [0, L] (mirrored over the deceleration phase) the squared speed `b = (dtau/dt)^2` is
/// positive at rest. A constant `b` there is a start with constant jerk and zero acceleration. Between the phases
/// `du/dtau` is 1; the map is twice continuously differentiable with a bounded third derivative, which jumps at `tau =
/// L`.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(crate) struct RestToRest {
    pub(crate) from: f64,
    pub(crate) to: f64,
    /// Widths of acceleration and deceleration phase in `tau`; half of each in `u`.
    up: f64,
    down: f64,
}

impl RestToRest {
    /// The map of [`from`, `to`] with its first `up` and last `down` as acceleration and deceleration phase, together
    /// at most the whole range; the identity if both are 0.
    pub(crate) fn new(from: f64, to: f64, up: f64, down: f64) -> Self {
        Self { from, to, up: 2.0 * up, down: 2.0 * down }
    }

    pub(crate) fn length(&self) -> f64 {
        self.to - self.from + 0.5 * (self.up + self.down)
    }

    /// Values of `tau` at which the map's third derivative jumps.
    pub(crate) fn borders(&self) -> [f64; 2] {
        [self.up, self.length() - self.down]
    }

    /// `u` and its first three derivatives by `tau`; at a border, those of the side before or after it.
    pub(crate) fn at(&self, tau: f64, before: bool) -> [f64; 4] {
        let end = self.length();
        let zone = |x: f64, l: f64| {
            [
                l * x * x * x * (1.0 - 0.5 * x),
                x * x * (3.0 - 2.0 * x),
                6.0 * x * (1.0 - x) / l,
                (6.0 - 12.0 * x) / (l * l),
            ]
        };
        if self.up > 0.0 && (tau < self.up || (tau <= self.up && before)) {
            let [u, d1, d2, d3] = zone((tau / self.up).clamp(0.0, 1.0), self.up);
            return [(self.from + u).min(self.to), d1, d2, d3];
        }
        if self.down > 0.0 && (tau > end - self.down || (tau >= end - self.down && !before)) {
            let [u, d1, d2, d3] = zone(((end - tau) / self.down).clamp(0.0, 1.0), self.down);
            return [(self.to - u).max(self.from), d1, -d2, d3];
        }
        [(self.from + tau - 0.5 * self.up).min(self.to), 1.0, 0.0, 0.0]
    }

    pub(crate) fn tau(&self, u: f64) -> f64 {
        let (ahead, behind) = (u - self.from, self.to - u);
        if ahead < 0.5 * self.up {
            self.up * inverse(ahead / self.up)
        } else if behind < 0.5 * self.down {
            self.length() - self.down * inverse(behind / self.down)
        } else {
            ahead + 0.5 * self.up
        }
    }
}

/// `x` in [0, 1] with `x^3 - x^4 / 2 = y`, y in [0, 1/2]: Newton's method, kept between bounds.
fn inverse(y: f64) -> f64 {
    if y <= 0.0 {
        return 0.0;
    }
    let (mut low, mut high) = (0.0, 1.0);
    let mut x = y.cbrt().min(1.0);
    for _ in 0..60 {
        let f = x * x * x * (1.0 - 0.5 * x) - y;
        (low, high) = if f > 0.0 { (low, x) } else { (x, high) };
        let newton = x - f / (x * x * (3.0 - 2.0 * x));
        let next = if newton > low && newton < high { newton } else { 0.5 * (low + high) };
        if (next - x).abs() <= 1e-16 * next {
            return next;
        }
        x = next;
    }
    x
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn derivatives_are_those_of_the_map_and_the_ends_are_met() {
        let map = RestToRest::new(2.0, 12.0, 3.0, 1.5);
        assert!((map.at(0.0, false)[0] - 2.0).abs() < 1e-15 && (map.at(map.length(), true)[0] - 12.0).abs() < 1e-15);
        let h = 1e-5;
        for i in 1..1000 {
            let tau = map.length() * f64::from(i) / 1000.0;
            let [u, ..] = map.at(tau, false);
            assert!((map.tau(u) - tau).abs() < 1e-9, "{tau}");
            if map.borders().iter().any(|b| (b - tau).abs() < 2.0 * h) {
                continue;
            }
            let (low, high) = (map.at(tau - h, false), map.at(tau + h, false));
            for k in 0..3 {
                assert!(((high[k] - low[k]) / (2.0 * h) - map.at(tau, false)[k + 1]).abs() < 1e-6, "{tau} {k}");
            }
        }
        for border in map.borders() {
            let (a, b) = (map.at(border, true), map.at(border, false));
            assert!((0..3).all(|k| (a[k] - b[k]).abs() < 1e-12));
        }
    }
}
