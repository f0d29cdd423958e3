use super::SeamJoint;
use super::section::{Place, Section};
use glam::DVec2;
use seamwright_document::NonNegative;
use seamwright_program::{Fillet, InsertKind, Joint, Lap, Member, Preparation, TBevel, TDoubleBevel, TJ, WeldedSide};
use std::f64::consts::TAU;

/// Thickness of a part that the preparation does not give, as a part of the groove's size.
const UNKNOWN: f64 = 0.7;
/// Width of the head of a T, J or Y on the inside as a part of its stem, and its height as a part of the stem's, as drawn.
const HEAD: f64 = 2.2;
const HEAD_HEIGHT: f64 = 0.4;
/// Extent of the drawn parts beyond the groove, as a part of its size.
const BEYOND: f64 = 1.0;

impl SeamJoint {
    /// Outlines of the metal around a section, for drawing, mm: the first and the second part, the weld on the other side
    /// and the backing, if they are there. The parts' thickness is that of the preparation (or a suitable one); they are
    /// cut off beside the groove.
    pub fn metal(&self, section: &Section) -> Vec<Vec<DVec2>> {
        let more = self.other_weld(section).into_iter().chain(self.backing(section));
        self.parts(section).into_iter().chain(more).collect()
    }

    fn parts(&self, section: &Section) -> [Vec<DVec2>; 2] {
        let (sin, cos) = (0.5 * section.dihedral).sin_cos();
        let along = [DVec2::new(sin, cos), DVec2::new(-sin, cos)];
        let out = [DVec2::new(-cos, sin), DVec2::new(cos, sin)];
        let edges = [&section.first, &section.second];
        let size = edges.iter().flat_map(|e| e.iter()).map(|p| p.length()).fold(0.0, f64::max);
        let far = |i: usize| {
            let reach = edges[i].iter().map(|p| p.dot(along[i])).fold(0.0, f64::max);
            reach + BEYOND * size
        };
        let thickness = self.joint().preparation.thickness_mm().unwrap_or(UNKNOWN * size);
        // A part whose edge is prepared: from its root along its edge, out along its surface, back inside, and along the
        // preparation of its other side.
        let prepared = |i: usize| {
            let toe = edges[i].last().copied().unwrap_or_default();
            let surface = toe - toe.dot(along[i]) * along[i];
            let end = surface + far(i) * along[i];
            let mut outline = edges[i].clone();
            outline.extend([end, end - thickness * out[i]]);
            outline.extend(self.far_edge(section, i));
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
        let joint = self.joint();
        match &joint.preparation {
            Preparation::FlareV(p) => {
                let r = p.radius_mm.get();
                [round(r, DVec2::new(r, -r)), round(r, DVec2::new(-r, -r))]
            }
            Preparation::FlareBevel(p) => {
                let (i, r) = (index(p.round), p.radius_mm.get());
                let centre = r * (out[1 - i] - along[1 - i]);
                sides(p.round, round(r, centre), through(1 - i, r))
            }
            Preparation::TBevel(TBevel { prepared: member, .. })
            | Preparation::TDoubleBevel(TDoubleBevel { prepared: member, .. })
            | Preparation::TJ(TJ { prepared: member, .. }) => {
                let i = index(*member);
                sides(*member, prepared(i), through(1 - i, thickness / section.dihedral.sin()))
            }
            Preparation::Fillet(Fillet { prepared: member, .. }) | Preparation::Lap(Lap { prepared: member, .. }) => {
                let i = index(*member);
                let t = if let Preparation::Lap(_) = joint.preparation { far(i) } else { UNKNOWN * size };
                let lift = section.gap * along[i];
                let foot = lift - t / section.dihedral.sin() * along[1 - i];
                let top = if let Preparation::Lap(p) = &joint.preparation { p.thickness_mm.get() } else { far(i) };
                let end = (section.gap + top) * along[i];
                sides(*member, vec![foot, lift, end, end - t * out[i]], through(1 - i, t / section.dihedral.sin()))
            }
            _ => [0, 1].map(prepared),
        }
    }

    /// The edge of part `i` on the side that is not welded, from its surface to the root, mm: empty where only one side is
    /// prepared. Where the root was gouged away it ends at the gouge's depth.
    fn far_edge(&self, section: &Section, i: usize) -> Vec<DVec2> {
        let joint = self.joint();
        let is_back = joint.side == WeldedSide::Back;
        let side = if is_back { WeldedSide::Face } else { WeldedSide::Back };
        let other = Joint { side, gouge: None, cap_mm: NonNegative::default(), ..joint.clone() };
        let edge = [&section.first, &section.second][i];
        let root = edge.first().copied().unwrap_or_default();
        if let Preparation::TDoubleBevel(p) = &joint.preparation {
            return far_bevel(p, other.side, root, section.dihedral);
        }
        if !joint.preparation.is_butt() || !(is_back || joint.preparation.is_double()) {
            return Vec::new();
        }
        let place = Place { dihedral: TAU - section.dihedral, gap: section.gap, mismatch: 0.0 };
        let Ok(beyond) = Section::new(&other, place) else { return Vec::new() };
        let depth = joint.preparation.thickness_mm().unwrap_or_default() / (0.5 * section.dihedral).sin();
        let edge = [&beyond.first, &beyond.second][i];
        // Seen from the other side it is upside down.
        let points: Vec<DVec2> = edge.iter().rev().map(|p| DVec2::new(p.x, -depth - p.y)).collect();
        let within = points.partition_point(|p| p.y < root.y);
        let mut points_below = points[..within].to_vec();
        if let (Some(last), Some(next)) = (points_below.last().copied(), points.get(within)) {
            points_below.push(last + (next - last) * ((root.y - last.y) / (next.y - last.y)));
        }
        points_below
    }

    /// Outline of the weld on the other side; `None` before there is one.
    fn other_weld(&self, section: &Section) -> Option<Vec<DVec2>> {
        let joint = self.joint();
        if joint.side == WeldedSide::Face || !joint.preparation.is_butt() {
            return None;
        }
        let [first, second] = [0, 1].map(|i| self.far_edge(section, i));
        // The gouge's bottom lies in the weld.
        let bottom = section.first.first().into_iter().chain(section.second.first()).copied();
        Some(first.into_iter().chain(bottom).chain(second.into_iter().rev()).collect())
    }

    /// Outline of the backing behind a section; `None` without one.
    fn backing(&self, section: &Section) -> Option<Vec<DVec2>> {
        let joint = self.joint();
        let backing = joint.backing?;
        let (width, thickness) = (backing.width_mm.get(), backing.thickness_mm.get());
        let wall = joint.preparation.thickness_mm()?;
        let (sin, cos) = (0.5 * section.dihedral).sin_cos();
        if joint.preparation.is_butt() {
            let level = -wall / sin;
            let half = 0.5 * width;
            let corner = |x: f64, y: f64| DVec2::new(x, y + x.abs() * cos / sin);
            let top = [corner(-half, level), DVec2::new(0.0, level), corner(half, level)];
            return Some(top.into_iter().chain(top.into_iter().rev().map(|p| p - thickness * DVec2::Y)).collect());
        }
        let i = match &joint.preparation {
            Preparation::TBevel(p) => usize::from(p.prepared == Member::Second),
            Preparation::TJ(p) => usize::from(p.prepared == Member::Second),
            _ => return None,
        };
        let along = [DVec2::new(sin, cos), DVec2::new(-sin, cos)];
        let out = [DVec2::new(-cos, sin), DVec2::new(cos, sin)];
        let foot = -wall / section.dihedral.sin() * along[1 - i];
        let (up, down) = (width * along[i], -thickness * out[i]);
        Some(vec![foot, foot + up, foot + up + down, foot + down])
    }

    /// Outline of the consumable insert in a section before it is fused, mm, schematic for its kind; `None` without one.
    pub fn insert(&self, section: &Section) -> Option<Vec<DVec2>> {
        let insert = self.joint().insert?;
        let (half, height) = (0.5 * insert.width_mm.get(), insert.height_mm.get());
        let root = section.root();
        let head = HEAD_HEIGHT * height;
        let points: &[(f64, f64)] = match insert.kind {
            InsertKind::Ring | InsertKind::Rectangular => &[(-half, 0.0), (half, 0.0), (half, height), (-half, height)],
            InsertKind::InvertedT => &[
                (-HEAD * half, -head),
                (HEAD * half, -head),
                (HEAD * half, 0.0),
                (half, 0.0),
                (half, height),
                (-half, height),
                (-half, 0.0),
                (-HEAD * half, 0.0),
            ],
            InsertKind::J => &[
                (-half, -head),
                (HEAD * half, -head),
                (HEAD * half, 0.0),
                (half, 0.0),
                (half, height),
                (-half, height),
            ],
            InsertKind::Y => &[
                (-HEAD * half, -head),
                (0.0, -0.5 * head),
                (HEAD * half, -head),
                (half, 0.0),
                (half, height),
                (-half, height),
                (-half, 0.0),
            ],
        };
        Some(points.iter().map(|(x, y)| root + DVec2::new(*x, *y)).collect())
    }

    /// Rotation (rad, counter-clockwise) that draws a section as in a handbook: a butt joint with its face up,
    /// otherwise the second part's face level with its outside up.
    pub fn upright(&self, section: &Section) -> f64 {
        if self.joint().preparation.is_butt() { 0.0 } else { std::f64::consts::FRAC_PI_2 - 0.5 * section.dihedral }
    }
}

/// The bevel on the other side of an edge that stands on a face, from the surface to `root`.
fn far_bevel(p: &TDoubleBevel, side: WeldedSide, root: DVec2, dihedral: f64) -> Vec<DVec2> {
    let (sin, cos) = (0.5 * dihedral).sin_cos();
    let along = [DVec2::new(sin, cos), DVec2::new(-sin, cos)];
    let out = [DVec2::new(-cos, sin), DVec2::new(cos, sin)];
    let i = usize::from(p.prepared == Member::Second);
    let degrees = if side == WeldedSide::Back { p.back_angle_deg.unwrap_or(p.angle_deg) } else { p.angle_deg };
    let rise = DVec2::from_angle(degrees.get().to_radians());
    let direction = rise.y * out[1 - i] - rise.x * along[1 - i];
    let inside = -p.thickness_mm.get() - root.dot(out[i]);
    let way = inside / direction.dot(out[i]);
    if way > 0.0 { vec![root + way * direction, root] } else { Vec::new() }
}
