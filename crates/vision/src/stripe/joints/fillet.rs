use super::{Support, View, ramp, turn};
use crate::stripe::{Feature, Features, NoFeatures, Quantity, Segment};
use std::f64::consts::PI;

/// Angles between the faces, degrees; half the confidence at these, none [`MARGIN_DEG`] beyond.
const ANGLES_DEG: [f64; 2] = [60.0, 120.0];
const MARGIN_DEG: f64 = 6.0;

/// Columns or rows that an end may be off the corner without being a gap: the stripe's width rounds it.
const ROUNDED: f64 = 3.0;

/// Part of the columns that each face must have for no, and for full confidence.
const FACE: [f64; 2] = [0.04, 0.1];

impl View<'_> {
    /// Two faces that meet in a valley and are all there is.
    pub(super) fn fillet(&mut self) -> Result<Features, NoFeatures> {
        let pairs = self.segments.windows(2).filter(|w| turn(&w[0].line, &w[1].line) > 0.6);
        let length = |w: &&[Segment]| w[0].length() + w[1].length();
        let pair = pairs.max_by(|a, b| length(a).total_cmp(&length(b))).ok_or(NoFeatures::NoCorner)?;
        let (a, b) = (pair[0], pair[1]);
        let angle = PI - turn(&a.line, &b.line);
        let degrees = angle.to_degrees();
        let inside = (degrees - ANGLES_DEG[0]).min(ANGLES_DEG[1] - degrees);
        let at = a.line.meets(&b.line).ok_or(NoFeatures::NoCorner)?;
        if inside < -MARGIN_DEG {
            return Err(NoFeatures::NoCorner);
        }
        // Nothing else that is straight and goes elsewhere: shoulders would make it a groove.
        let grain = self.grain();
        let on = |s: &Segment, line: &Segment| {
            let off = s.ends.map(|e| line.line.off(e).abs());
            off[0].max(off[1]) < 3.0 * line.within(grain) && turn(&s.line, &line.line).abs() < 0.12
        };
        let other = |s: &&Segment| !on(s, &a) && !on(s, &b);
        let columns = |s: &Segment| f64::from(s.columns.1 - s.columns.0);
        let elsewhere: f64 = self.segments.iter().filter(other).map(columns).sum();
        let total: f64 = self.segments.iter().map(columns).sum();
        let alone = ramp(elsewhere / total, 0.25, 0.1);
        let share = self.share(self.samples(), &[a, b]);
        if alone <= 0.0 || share < 0.5 {
            return Err(NoFeatures::NoCorner);
        }
        let gap = self.fillet_gap(&a, &b, at);
        let shorter = columns(&a).min(columns(&b)) / f64::from(self.profile.columns() as u32);
        let margin = alone * ramp(inside, -MARGIN_DEG, MARGIN_DEG / 2.0) * ramp(shorter, FACE[0], FACE[1]);
        let support = Support { share, segments: &[a, b], margin };
        Ok(self.features(&[(Feature::Joint, at)], &[(Quantity::Gap, gap), (Quantity::Angle, angle)], &support))
    }

    /// Distance of the end of one face from the other face: 0 if both reach the corner.
    fn fillet_gap(&mut self, a: &Segment, b: &Segment, at: glam::DVec2) -> f64 {
        let rounded = ROUNDED * self.grain();
        // The line that does not stop goes on past the corner, in the shadow of the other's end.
        let left = self.edge(a, b.columns.0.max(a.columns.1));
        let right = self.edge(b, a.columns.1.min(b.columns.0));
        let short = |edge: Option<super::Edge>, s: &Segment, sign: f64| {
            edge.map_or(0.0, |e| sign * (at - e.at).dot(s.line.along))
        };
        let (short_a, short_b) = (short(left, a, 1.0), short(right, b, -1.0));
        let sine = turn(&a.line, &b.line).sin();
        let (most, least) = (short_a.max(short_b), short_a.min(short_b));
        if most > rounded && least < rounded { most * sine } else { 0.0 }
    }
}
