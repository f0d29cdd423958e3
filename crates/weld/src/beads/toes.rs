//! Angles at the toes of beads.
//!
//! The weld toe angle alpha of ISO 5817 (no. 505) lies between the surface beyond the toe and the face of the bead,
//! through the air: 180 degrees if flush. The contact angle of the metal is 180 degrees less alpha.
//!
//! **Model.** The cap is a parabola from toe to toe, as in `shape.rs`: its face rises by 4 heights per width at a toe.
//! Beads side by side add a wave of arcs. Their crests are as high as a bead's parabola and their mean is the layer's, so
//! an arc over the pitch d with its crest delta over the mean falls by `12 delta / d` at the valley. At 2/3 of a width
//! the valleys are full and delta is 0. Below the cap the surface beyond the toe is the wall of the groove.
//!
//! **Where it fails.** The toes are those of flat position: gravity turns the face of a bead on a slope
//! ([`Inclination::sag`](seamwright_program::Inclination::sag)). Cold beads are steeper than their area and width say, as
//! they do not wet to the toe; undercut is not in the model.

use super::shape::{LayerShape, Level};
use crate::joint::Section;
use glam::DVec2;
use std::f64::consts::{PI, TAU};

/// Weld toe angles of a bead, rad.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Toes {
    /// On the side of the second part.
    pub second: f64,
    /// On the side of the first part.
    pub first: f64,
    /// The part of these angles at the parts that the convexity of the face takes: a flat face would have more by this.
    pub(crate) convexity: f64,
}

impl Toes {
    /// The smaller one.
    pub fn min(&self) -> f64 {
        self.second.min(self.first)
    }

    pub(super) fn towards(&self, other: &Self, part: f64) -> Self {
        let between = |a: f64, b: f64| a + (b - a) * part;
        Self {
            second: between(self.second, other.second),
            first: between(self.first, other.first),
            convexity: between(self.convexity, other.convexity),
        }
    }
}

/// Toe angles of a layer: at both parts, and between its beads.
#[derive(Debug, Clone, Copy)]
pub(super) struct LayerToes {
    parts: Toes,
    valley: f64,
}

impl LayerToes {
    /// The toes of a layer of `count` beads up to `high`.
    pub(super) fn new(section: &Section, shape: &LayerShape, high: &Level, count: usize, spacing: f64) -> Self {
        let wave = shape.wave(count, spacing);
        let face = (shape.crown() + wave).atan();
        let (across, up) = (section.across(), section.up);
        let (rise, run) = face.sin_cos();
        let [first, second] = section.beyond(high.height);
        // Counter-clockwise through the air: from the first part to the face, from the face to the second part.
        let turn = |from: DVec2, to: DVec2| from.perp_dot(to).atan2(from.dot(to)).rem_euclid(TAU);
        let parts = Toes {
            first: turn(first, rise * up - run * across),
            second: turn(rise * up + run * across, second),
            convexity: face,
        };
        Self { parts, valley: PI - 2.0 * wave.atan() }
    }

    /// Those of bead `index` of `count`, counted from the second part.
    pub(super) fn of(&self, index: usize, count: usize) -> Toes {
        Toes {
            second: if index == 0 { self.parts.second } else { self.valley },
            first: if index + 1 == count { self.parts.first } else { self.valley },
            convexity: self.parts.convexity,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::findings::BeadPlace;
    use super::super::tests::try_plan;
    use super::super::{BeadAt, BeadPlan};
    use crate::joint::Section;
    use seamwright_program::{FilletOrButt, QualityLevel};

    fn joint(normal: &str, joint: &str, beads: &str) -> (BeadPlan, Section, Vec<String>) {
        let text = format!(
            "[seam.line]\nstart_mm = [0, 0, 0]\nend_mm = [100, 0, 0]\nfirst_normal = {normal}\nsecond_normal = [0, 0, 1]\n\
             [joint]\n{joint}\n[beads]\nstation_mm = 50\n{beads}\n"
        );
        let planned = try_plan(&text).unwrap_or_else(|e| panic!("{e}: {text}"));
        let found = planned.plan.findings(&planned.runs, |b| BeadPlace { pass: b + 1, before_mm: 0.0 });
        let codes = found.iter().map(|f| f.message.code.to_string()).collect();
        let section = planned.joint.section(&planned.seam.at(50.0)).unwrap();
        (planned.plan, section, codes)
    }

    fn cap(plan: &BeadPlan) -> BeadAt {
        *plan.at_station(1).last().unwrap()
    }

    const BUTT: &str = "[0, 0, 1]";
    const TEE: &str = "[0, -1, 0]";

    #[test]
    fn a_cap_alone_is_a_parabola_from_toe_to_toe() {
        for height in [0.0, 1.0, 2.5] {
            let preparation = "preparation.single_v = { thickness_mm = 5, angle_deg = 60, root_gap_mm = 2 }";
            let (plan, section, _) =
                joint(BUTT, &format!("cap_mm = {height}\n{preparation}"), "fill = { area_mm2 = 35, layer_mm = 6 }");
            let toes = cap(&plan).toes;
            let expected = 180.0 - (4.0 * height / section.chord()).atan().to_degrees();
            assert!((toes.first.to_degrees() - expected).abs() < 1e-6, "{height} {toes:?} {expected}");
            assert!((toes.second - toes.first).abs() < 1e-9);
            // The outline, which is drawn by other code, leaves the toe in this direction.
            let outline = section.outlines(&plan.in_order(&section, 50.0)).pop().unwrap();
            let at = outline.iter().position(|p| p.distance(section.toes()[0]) < 1e-6).unwrap();
            let face = outline[at + 1] - outline[at];
            assert!((180.0 - face.y.atan2(-face.x).to_degrees() - expected).abs() < 0.5, "{face} {expected}");
        }
    }

    #[test]
    fn a_mitre_fillet_has_135_degrees_and_a_convex_one_less() {
        for (convexity, leg) in [(0.0, 6.0), (1.0, 6.0), (1.5, 5.0)] {
            let preparation = format!("cap_mm = {convexity}\npreparation.fillet = {{ leg_mm = {leg} }}");
            let (plan, _, codes) = joint(TEE, &preparation, "fill = { area_mm2 = 18, layer_mm = 4 }");
            let expected = 135.0 - (4.0 * convexity / (leg * 2.0_f64.sqrt())).atan().to_degrees();
            assert!((cap(&plan).toes.min().to_degrees() - expected).abs() < 1e-6, "{convexity} {expected}");
            let is_steep = expected < QualityLevel::C.min_toe_deg(FilletOrButt::Fillet);
            assert_eq!(codes.iter().any(|code| code == "weld-bead-toe-steep"), is_steep, "{expected} {codes:?}");
        }
    }

    #[test]
    fn beads_side_by_side_meet_in_valleys_that_fill_at_two_thirds() {
        let preparation = "cap_mm = 1\npreparation.single_v = { thickness_mm = 16, angle_deg = 60, root_gap_mm = 2 }";
        let valley = |spacing: f64| {
            let beads = format!("spacing_to_width = {spacing}\nfill = {{ area_mm2 = 16 }}");
            let (plan, ..) = joint(BUTT, preparation, &beads);
            let bead = plan.at_station(1)[plan.count() - 2];
            assert!(bead.index > 0);
            bead.toes.first.to_degrees()
        };
        assert!((valley(0.6) - 180.0).abs() < 1e-9 && (valley(2.0 / 3.0) - 180.0).abs() < 1e-6);
        let deeper = [0.68, 0.7, 0.74].map(valley);
        assert!(deeper.is_sorted_by(|a, b| a > b) && deeper[0] < 178.0 && deeper[2] > 90.0, "{deeper:?}");
    }

    #[test]
    fn below_the_cap_the_wall_stands_over_the_toe() {
        let preparation = "preparation.single_v = { thickness_mm = 20, angle_deg = 50, root_gap_mm = 2 }";
        let (plan, ..) = joint(BUTT, preparation, "fill = { area_mm2 = 20 }");
        let first = plan.at_station(1)[0];
        // A flat face to a wall 25 degrees off the vertical.
        assert!((first.toes.first.to_degrees() - 115.0).abs() < 1e-6, "{first:?}");
    }
}
