//! Orthographic projections of points in space.

use std::f64::consts::FRAC_1_SQRT_2;

/// Elevation of the viewer of the pictorial view, rad.
const ELEVATION: f64 = 20.0 / 180.0 * std::f64::consts::PI;

/// A viewing direction. Front, side and top are arranged in first-angle projection (ISO 5456-2, method E). Each shows
/// the object of the front view rolled over, away from the viewer.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Projection {
    /// Looking along +y: x to the right, z up.
    Front,
    /// From the left, looking along +x: y to the left, z up.
    Side,
    /// From above, looking along -z: x to the right, y up.
    Top,
    /// From the front, the right and 20° above. An isometric view would look along the plane of a torch at 45° and draw
    /// it on top of its seam.
    Pictorial,
}

impl Projection {
    /// Returns the point's coordinates in the view, right and up.
    pub(crate) fn project(self, [x, y, z]: [f64; 3]) -> (f64, f64) {
        match self {
            Self::Front => (x, z),
            Self::Side => (-y, z),
            Self::Top => (x, y),
            Self::Pictorial => {
                let (sin, cos) = ELEVATION.sin_cos();
                (FRAC_1_SQRT_2 * (x + y), FRAC_1_SQRT_2 * sin * (y - x) + cos * z)
            }
        }
    }

    /// Returns the unit vector towards the viewer.
    pub(crate) fn toward(self) -> [f64; 3] {
        let unit = |i: usize| self.project(std::array::from_fn(|k| if k == i { 1.0 } else { 0.0 }));
        let (right, up): (Vec<f64>, Vec<f64>) = (0..3).map(unit).unzip();
        std::array::from_fn(|i| {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            right[j] * up[k] - right[k] * up[j]
        })
    }

    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Front => "report-view-front",
            Self::Side => "report-view-side",
            Self::Top => "report-view-top",
            Self::Pictorial => "report-view-pictorial",
        }
    }

    /// Returns names of the axes to the right and up, with the sign of the first.
    pub(crate) fn axes(self) -> Option<(&'static str, &'static str, f64)> {
        match self {
            Self::Front => Some(("x", "z", 1.0)),
            Self::Side => Some(("y", "z", -1.0)),
            Self::Top => Some(("x", "y", 1.0)),
            Self::Pictorial => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn apply(m: Projection, v: [f64; 3]) -> [f64; 2] {
        let (a, b) = m.project(v);
        [a, b]
    }

    /// The viewing direction is the negative of right × up: a viewer sees right-handed axes.
    #[test]
    fn views_look_where_they_say() {
        let unit = |i: usize| std::array::from_fn::<f64, 3, _>(|k| if k == i { 1.0 } else { 0.0 });
        let (sin, cos) = ELEVATION.sin_cos();
        let level = cos * FRAC_1_SQRT_2;
        for (view, sight) in [
            (Projection::Front, [0.0, 1.0, 0.0]),
            (Projection::Side, [1.0, 0.0, 0.0]),
            (Projection::Top, [0.0, 0.0, -1.0]),
            (Projection::Pictorial, [-level, level, -sin]),
        ] {
            let right: [f64; 3] = std::array::from_fn(|i| apply(view, unit(i))[0]);
            let up: [f64; 3] = std::array::from_fn(|i| apply(view, unit(i))[1]);
            for (i, along) in sight.iter().enumerate() {
                let (j, k) = ((i + 1) % 3, (i + 2) % 3);
                let towards = up[j] * right[k] - up[k] * right[j];
                assert!((towards - along).abs() < 1e-12, "{view:?}");
                assert!((view.toward()[i] + along).abs() < 1e-12, "{view:?}");
            }
        }
    }
}
