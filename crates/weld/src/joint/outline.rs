use super::SeamJoint;
use super::section::Section;
use glam::DVec2;
use seamwright_program::{Member, Preparation};
use std::f64::consts::TAU;

/// Thickness of a part that the preparation does not give, as a part of the groove's size.
const UNKNOWN: f64 = 0.7;
/// Extent of the drawn parts beyond the groove, as a part of its size.
const BEYOND: f64 = 1.0;

impl SeamJoint {
    /// Outlines of the first and the second part around a section, for drawing, mm. Their thickness is that of the
    /// preparation (or a suitable one); they are cut off beside the groove.
    pub fn parts(&self, section: &Section) -> [Vec<DVec2>; 2] {
        let (sin, cos) = (0.5 * section.dihedral).sin_cos();
        let along = [DVec2::new(sin, cos), DVec2::new(-sin, cos)];
        let out = [DVec2::new(-cos, sin), DVec2::new(cos, sin)];
        let edges = [&section.first, &section.second];
        let size = edges.iter().flat_map(|e| e.iter()).map(|p| p.length()).fold(0.0, f64::max);
        let far = |i: usize| {
            let reach = edges[i].iter().map(|p| p.dot(along[i])).fold(0.0, f64::max);
            reach + BEYOND * size
        };
        // A part whose edge is prepared: from its root along its edge, out along its surface and back inside.
        let prepared = |i: usize, thickness: f64| {
            let toe = edges[i].last().copied().unwrap_or_default();
            let surface = toe - toe.dot(along[i]) * along[i];
            let end = surface + far(i) * along[i];
            let mut outline = edges[i].clone();
            outline.extend([end, end - thickness * out[i]]);
            outline
        };
        // A part with the other on its face.
        let through = |i: usize, under: f64| {
            let (end, back) = (far(i) * along[i], -(under + 0.6 * size) * along[i]);
            let inside = UNKNOWN * size * out[i];
            vec![end, back, back - inside, end - inside]
        };
        let round = |radius: f64, centre: DVec2| {
            (0..96).map(|k| centre + radius * DVec2::from_angle(TAU * f64::from(k) / 96.0)).collect::<Vec<_>>()
        };
        let sides = |member: Member, prepared: Vec<DVec2>, other: Vec<DVec2>| match member {
            Member::First => [prepared, other],
            Member::Second => [other, prepared],
        };
        let index = |member: Member| usize::from(member == Member::Second);
        match &self.joint().preparation {
            Preparation::Square(p) => [0, 1].map(|i| prepared(i, p.thickness_mm.get())),
            Preparation::SingleV(p) => [0, 1].map(|i| prepared(i, p.thickness_mm.get())),
            Preparation::Bevel(p) => [0, 1].map(|i| prepared(i, p.thickness_mm.get())),
            Preparation::U(p) => [0, 1].map(|i| prepared(i, p.thickness_mm.get())),
            Preparation::J(p) => [0, 1].map(|i| prepared(i, p.thickness_mm.get())),
            Preparation::FlareV(p) => {
                let r = p.radius_mm.get();
                [round(r, DVec2::new(r, -r)), round(r, DVec2::new(-r, -r))]
            }
            Preparation::FlareBevel(p) => {
                let (i, r) = (index(p.round), p.radius_mm.get());
                let centre = r * (out[1 - i] - along[1 - i]);
                sides(p.round, round(r, centre), through(1 - i, r))
            }
            Preparation::TBevel(p) => {
                let (i, t) = (index(p.prepared), p.thickness_mm.get());
                sides(p.prepared, prepared(i, t), through(1 - i, t / section.dihedral.sin()))
            }
            Preparation::TJ(p) => {
                let (i, t) = (index(p.prepared), p.thickness_mm.get());
                sides(p.prepared, prepared(i, t), through(1 - i, t / section.dihedral.sin()))
            }
            Preparation::Fillet(p) => {
                let (i, t) = (index(p.prepared), UNKNOWN * size);
                let lift = section.gap * along[i];
                let foot = lift - t / section.dihedral.sin() * along[1 - i];
                let end = far(i) * along[i];
                sides(p.prepared, vec![foot, lift, end, end - t * out[i]], through(1 - i, t / section.dihedral.sin()))
            }
        }
    }

    /// Rotation (rad, counter-clockwise) that draws a section as in a handbook: a butt joint with its face up,
    /// otherwise the second part's face level with its outside up.
    pub fn upright(&self, section: &Section) -> f64 {
        if self.joint().preparation.is_butt() { 0.0 } else { std::f64::consts::FRAC_PI_2 - 0.5 * section.dihedral }
    }
}
