use crate::chebyshev::{NODES, Series, nodes};
use crate::curve::Curve;
use crate::error::Error;

/// Accuracy used where the caller has no reason for another, mm.
pub const DEFAULT_ACCURACY_MM: f64 = 1e-12;

/// Parts of the length in the table that finds a panel.
const PARTS: usize = 256;

/// Smallest panel as a part of the domain: below it the curve has a corner, not a bend.
const SMALLEST_PANEL: f64 = 1e-9;

/// A curve together with its arc length and the inverse of it.
///
/// The domain is cut into panels, at the curve's breaks first of all. On each, `|dp/du|` is a Chebyshev series whose
/// integral is the arc length, and the inverse, parameter by arc length, is a second series obtained by Newton's method
/// at the nodes. Panels are halved until both hold the accuracy at check points between the nodes.
///
/// Lengths count from the start of the curve's domain. On a closed curve `s` and `u` may take any value; they repeat
/// with the curve.
///
/// # Guarantees
///
/// For `accuracy_mm` not below the rounding of the curve's own evaluation:
///
/// - `|length_at(u) - true arc length| <= accuracy_mm` over the whole curve;
/// - `|length_at(parameter(s)) - s| <= accuracy_mm`.
///
/// # Examples
///
/// One turn of a helix, by length:
///
/// ```
/// use glam::DVec3;
/// use seamwright_geometry::{ByLength, Curve, DEFAULT_ACCURACY_MM, Helix, Tube};
///
/// let tube = Tube::new(DVec3::ZERO, DVec3::Z, DVec3::X, 40.0)?;
/// let helix = ByLength::new(Helix::new(tube, 12.0, 1.0)?, DEFAULT_ACCURACY_MM)?;
/// // A third of the length climbs by a third of the pitch.
/// let point = helix.curve().point(helix.parameter(helix.length() / 3.0));
/// assert!((point.z - 4.0).abs() < 1e-9);
/// # Ok::<(), seamwright_geometry::Error>(())
/// ```
#[derive(Debug, Clone)]
pub struct ByLength<C> {
    curve: C,
    panels: Vec<Panel>,
    /// The first panel that reaches into each of [`PARTS`] equal parts of the length, so that a panel is found without
    /// a search.
    first: Vec<u32>,
    length: f64,
}

#[derive(Debug, Clone)]
struct Panel {
    u0: f64,
    u_half: f64,
    s0: f64,
    s_half: f64,
    /// Arc length from the panel's start, by the panel's parameter in [-1, 1].
    length: Series,
    /// Parameter less the panel's middle, by the panel's arc length in [-1, 1].
    parameter: Series,
}

impl<C: Curve> ByLength<C> {
    /// Measures `curve` to `accuracy_mm`. An accuracy finer than the rounding of the length itself is relaxed to
    /// that.
    ///
    /// # Errors
    /// [`Error::ArcLength`] if the curve has a corner outside its breaks, or its derivative is not finite.
    pub fn new(curve: C, accuracy_mm: f64) -> Result<Self, Error> {
        let (start, end) = curve.domain();
        let rough: f64 = (0..64).map(|i| curve.speed(start + (end - start) * (f64::from(i) + 0.5) / 64.0)).sum();
        let accuracy = accuracy_mm.max(8.0 * f64::EPSILON * rough * (end - start) / 64.0);
        let mut panels = Vec::new();
        // Compensated sum of the panels' lengths.
        let (mut length, mut lost) = (0.0, 0.0);
        let hair = SMALLEST_PANEL * (end - start);
        let mut edges = vec![start];
        edges.extend(curve.breaks().into_iter().filter(|u| *u > start + hair && *u < end - hair));
        edges.push(end);
        let mut todo: Vec<(f64, f64)> = edges.windows(2).rev().map(|w| (w[0], w[1])).collect();
        while let Some((a, b)) = todo.pop() {
            if let Some((panel, panel_length)) = Panel::fit(&curve, a, b, length, accuracy) {
                panels.push(panel);
                let add = panel_length - lost;
                let sum = length + add;
                lost = (sum - length) - add;
                length = sum;
            } else if b - a <= SMALLEST_PANEL * (end - start) || rough.is_nan() {
                return Err(Error::ArcLength { accuracy_mm, at: a });
            } else {
                let middle = 0.5 * (a + b);
                todo.push((middle, b));
                todo.push((a, middle));
            }
        }
        let part = |i: usize| length * i as f64 / PARTS as f64;
        let first = (0..PARTS).map(|i| panels.partition_point(|p| p.s0 <= part(i)).saturating_sub(1) as u32);
        let first = first.collect();
        Ok(Self { curve, panels, first, length })
    }

    /// Returns the curve itself.
    pub fn curve(&self) -> &C {
        &self.curve
    }

    /// Returns the curve's length, mm.
    pub fn length(&self) -> f64 {
        self.length
    }

    /// Returns the arc length from the start of the domain to parameter `u`, mm. Its inverse is
    /// [`ByLength::parameter`].
    pub fn length_at(&self, u: f64) -> f64 {
        let (start, end) = self.curve.domain();
        let turns = if self.curve.closed() { ((u - start) / (end - start)).floor() } else { 0.0 };
        let u = u - turns * (end - start);
        let i = self.panels.partition_point(|p| p.u0 <= u).saturating_sub(1);
        let p = &self.panels[i];
        turns * self.length + p.s0 + p.length.at((u - p.u0) / p.u_half - 1.0)
    }

    /// Returns the parameter at arc length `s` (mm) from the start of the domain. To evaluate the curve there, pass it
    /// to [`Curve::jet`].
    pub fn parameter(&self, s: f64) -> f64 {
        let (start, end) = self.curve.domain();
        let outside = !(0.0..=self.length).contains(&s);
        let turns = if outside && self.curve.closed() { (s / self.length).floor() } else { 0.0 };
        let s = s - turns * self.length;
        let p = &self.panels[self.panel_at(s)];
        // Rounding must not lead to the other side of a break.
        let u = p.u0 + p.u_half + p.parameter.at((s - p.s0) / p.s_half - 1.0);
        let within = !outside || self.curve.closed();
        turns * (end - start) + if within { u.clamp(p.u0, p.u0 + 2.0 * p.u_half) } else { u }
    }
}

impl<C> ByLength<C> {
    /// The panel that holds arc length `s` in [0, length].
    fn panel_at(&self, s: f64) -> usize {
        let part = (s / self.length * PARTS as f64).clamp(0.0, (PARTS - 1) as f64) as usize;
        let mut i = self.first[part] as usize;
        while self.panels.get(i + 1).is_some_and(|next| next.s0 <= s) {
            i += 1;
        }
        i
    }
}

impl Panel {
    /// The panel over [a, b] and its length, or nothing if it is too long for the accuracy.
    fn fit(curve: &dyn Curve, a: f64, b: f64, s0: f64, accuracy: f64) -> Option<(Self, f64)> {
        let u_half = 0.5 * (b - a);
        let speeds: [f64; NODES] = std::array::from_fn(|j| u_half * curve.speed(a + u_half * (1.0 + nodes()[j])));
        let speed = Series::fit(&speeds);
        // Rounding of the speeds themselves cannot be fitted away.
        let scale = speeds.iter().fold(0.0, |m: f64, v| m.max(*v));
        if speed.tail().is_nan() || speed.tail() > (0.1 * accuracy).max(30.0 * f64::EPSILON * scale) {
            return None;
        }
        let length = speed.integral();
        let total = length.at(1.0);
        let s_half = 0.5 * total;
        // Newton's method for length(x) = s at the nodes, starting from the linear estimate.
        let invert = |s: f64| {
            let mut x = s / s_half - 1.0;
            for _ in 0..12 {
                let step = (length.at(x) - s) / speed.at(x);
                x = (x - step).clamp(-1.0, 1.0);
                if step.abs() < 1e-16 {
                    break;
                }
            }
            u_half * x
        };
        let parameter = Series::fit(&std::array::from_fn(|j| invert(s_half * (1.0 + nodes()[j]))));
        let fits = (0..=2 * NODES).all(|i| {
            let y = i as f64 / NODES as f64 - 1.0;
            let x = parameter.at(y) / u_half;
            (length.at(x) - s_half * (1.0 + y)).abs() <= (0.5 * accuracy).max(8.0 * f64::EPSILON * scale)
        });
        fits.then_some((Self { u0: a, u_half, s0, s_half, length, parameter }, total))
    }
}
