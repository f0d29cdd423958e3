use glam::{DMat2, DVec2, DVec3};

/// Spacing of the precomputed views, mm; linear interpolation between them.
const STEP_MM: f64 = 1.0;

/// Torch frame at a station of the nominal seam.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SeamFrame {
    /// Origin, mm.
    pub point: DVec3,
    /// Unit direction of welding.
    pub along: DVec3,
    /// Unit direction of lateral corrections, perpendicular to `along`.
    pub lateral: DVec3,
    /// Unit direction of height corrections, perpendicular to both, out of the work.
    pub height: DVec3,
}

impl SeamFrame {
    /// Returns the components of a displacement: along, lateral, height.
    #[must_use]
    pub fn components(&self, displacement: DVec3) -> DVec3 {
        DVec3::new(displacement.dot(self.along), displacement.dot(self.lateral), displacement.dot(self.height))
    }
}

/// View of the nominal seam from a sensor ahead of the torch along its tangent.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct View {
    /// Path length of the observed station, mm.
    pub place_mm: f64,
    /// Nominal seam in the sensor's plane with the slide at zero, mm; a curved seam lies beside its tangent.
    pub offset: DVec2,
    /// Transforms offsets in the sensor's plane to deviations in the frame of the observed station.
    pub to_seam: DMat2,
}

/// Views of the nominal seam by path length of the torch. On radius R a sensor L ahead sees the seam's own curve, about
/// L^2/2R, and deviations rotated by the angle between both stations.
#[derive(Debug, Clone, PartialEq)]
pub struct OwnCurve {
    from_mm: f64,
    views: Vec<View>,
    lead_mm: f64,
}

impl OwnCurve {
    /// Creates the view of a straight seam, without offset and rotation.
    #[must_use]
    pub fn straight(lead_mm: f64) -> Self {
        Self { from_mm: 0.0, views: Vec::new(), lead_mm }
    }

    /// Creates the views of the seam given by `frame`, with the torch from `from_mm` to `to_mm`. Calls `frame` up to
    /// two look-ahead distances further. A seam that has not crossed the sensor's plane by then counts as seen there.
    #[must_use]
    pub fn of(lead_mm: f64, from_mm: f64, to_mm: f64, frame: impl Fn(f64) -> SeamFrame) -> Self {
        let count = ((to_mm - from_mm) / STEP_MM).ceil().clamp(1.0, 1e7) as usize;
        let view = |i: usize| view(lead_mm, from_mm + i as f64 * STEP_MM, &frame);
        Self { from_mm, views: (0..=count).map(view).collect(), lead_mm }
    }

    /// Returns the view with the torch at `s_mm`; beyond the ends, offset and rotation are those of the end.
    #[must_use]
    pub fn at(&self, s_mm: f64) -> View {
        let along = ((s_mm - self.from_mm) / STEP_MM).clamp(0.0, self.views.len().saturating_sub(1) as f64);
        let i = (along as usize).min(self.views.len().saturating_sub(2));
        let (Some(a), Some(b)) = (self.views.get(i), self.views.get(i + 1)) else {
            return View { place_mm: s_mm + self.lead_mm, offset: DVec2::ZERO, to_seam: DMat2::IDENTITY };
        };
        let part = along - i as f64;
        // Beyond the ends the observed station still moves with the torch.
        let ahead = |k: usize, v: &View| v.place_mm - (self.from_mm + (i + k) as f64 * STEP_MM);
        View {
            place_mm: s_mm + ahead(0, a) + part * (ahead(1, b) - ahead(0, a)),
            offset: a.offset.lerp(b.offset, part),
            to_seam: a.to_seam * (1.0 - part) + b.to_seam * part,
        }
    }
}

fn view(lead: f64, s: f64, frame: &impl Fn(f64) -> SeamFrame) -> View {
    let here = frame(s);
    let way = |place: f64| (frame(place).point - here.point).dot(here.along);
    // Finds the first crossing of the sensor's plane: bracketing in steps, then bisection.
    let mut high = s + lead;
    while way(high) < lead && high < s + 2.0 * lead {
        high += lead / 16.0;
    }
    let mut low = high - lead;
    for _ in 0..50 {
        let middle = 0.5 * (low + high);
        if way(middle) < lead { low = middle } else { high = middle }
    }
    let place_mm = 0.5 * (low + high);
    let there = frame(place_mm);
    let off = there.point - here.point;
    let seen = |axis: DVec3| DVec2::new(axis.dot(there.lateral), axis.dot(there.height));
    View {
        place_mm,
        offset: DVec2::new(off.dot(here.lateral), off.dot(here.height)),
        to_seam: DMat2::from_cols(seen(here.lateral), seen(here.height)),
    }
}

#[cfg(test)]
impl SeamFrame {
    /// Returns the frame on a circle in the xy plane, lateral towards its centre.
    pub(crate) fn on_circle(radius: f64, s: f64) -> Self {
        let (sin, cos) = (s / radius).sin_cos();
        Self {
            point: DVec3::new(radius * sin, radius * (1.0 - cos), 0.0),
            along: DVec3::new(cos, sin, 0.0),
            lateral: DVec3::new(-sin, cos, 0.0),
            height: DVec3::Z,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Compares the views on a circle with their closed form.
    #[test]
    fn of_a_circle() {
        for radius in [50.0, 500.0, -120.0] {
            let frame = |s: f64| SeamFrame::on_circle(radius, s);
            let own = OwnCurve::of(20.0, -10.0, 100.0, frame);
            let turn = (20.0 / radius).asin();
            for i in 0..1100 {
                let s = -10.0 + 0.1 * f64::from(i);
                let view = own.at(s);
                assert!((view.place_mm - s - radius * turn).abs() < 1e-9, "{view:?}");
                let sagitta = radius * (1.0 - turn.cos());
                assert!(view.offset.distance(DVec2::new(sagitta, 0.0)) < 1e-9, "{view:?}");
                assert!((view.to_seam.x_axis.x - turn.cos()).abs() < 1e-9 && view.to_seam.y_axis == DVec2::Y);
            }
            assert!((own.at(150.0).place_mm - 150.0 - radius * turn).abs() < 1e-9);
        }
        // L^2/2R for L = 20 mm and R = 500 mm.
        assert!((20.0f64.powi(2) / (2.0 * 500.0) - 0.4).abs() < 1e-12);
    }

    #[test]
    fn of_a_straight_seam() {
        let view = OwnCurve::straight(20.0).at(7.0);
        assert_eq!(view, View { place_mm: 27.0, offset: DVec2::ZERO, to_seam: DMat2::IDENTITY });
    }
}
