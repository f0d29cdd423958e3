use crate::wire::{BeadView, SectionView};
use glam::DVec2;
use seamwright_weld::{BeadAt, Layer, SeamCurve, SeamJoint, Welding};
use std::f64::consts::FRAC_PI_2;

/// Number of positions along the seam.
const PLACES: u32 = 9;

/// Returns cross-sections of the joint at positions along the seam, the first at its start; empty without a joint.
pub(crate) fn sections(welding: &Welding) -> Vec<SectionView> {
    let (Some(seam), Some(joint)) = (&welding.seam, &welding.joint) else { return Vec::new() };
    // On a closed seam the end is the start.
    let step =
        if seam.all_round() { seam.length() / f64::from(PLACES) } else { seam.weld_length() / f64::from(PLACES - 1) };
    let at = |i| section(welding, seam, joint, f64::from(i) * step);
    (0..PLACES).filter_map(at).collect()
}

fn section(welding: &Welding, seam: &SeamCurve, joint: &SeamJoint, s: f64) -> Option<SectionView> {
    let point = seam.at(s);
    let section = joint.section(&point)?;
    let (root_gap_mm, mismatch_mm) = joint.fit_up(s);
    let turn = DVec2::from_angle(joint.upright(&section));
    let place = |p: &DVec2| turn.rotate(*p).to_array().map(micrometres);
    let outline = |points: &[DVec2]| points.iter().map(place).collect::<Vec<_>>();
    let beads = welding.plan.as_ref().map_or(Vec::new(), |plan| {
        let work = |bead: &BeadAt| welding.torch_angles(Some(plan.layers[bead.layer].role), s).map_or(0.0, |of| of.0);
        let bead = |(bead, line): (&BeadAt, Vec<DVec2>)| BeadView {
            name: name(&plan.layers[bead.layer], bead),
            role: plan.layers[bead.layer].role.name().to_owned(),
            area_mm2: bead.area,
            outline: outline(&line),
            tip: place(&bead.tip),
            back: turn.rotate(DVec2::from_angle(FRAC_PI_2 - bead.lean - work(bead))).to_array(),
        };
        let beads = plan.in_order(&section, s);
        beads.iter().zip(section.outlines(&beads)).map(bead).collect()
    });
    Some(SectionView {
        s_mm: s,
        dihedral_deg: section.dihedral.to_degrees(),
        root_gap_mm,
        mismatch_mm,
        area_mm2: section.area(),
        cap_mm2: section.cap,
        parts: joint.metal(&section).iter().map(|part| outline(part)).collect(),
        edges: [outline(&section.first), outline(&section.second)],
        beads,
    })
}

fn name(layer: &Layer, bead: &BeadAt) -> String {
    match layer.beads {
        1 => format!("{} {}", layer.role.name(), bead.layer + 1),
        _ => format!("{} {}.{}", layer.role.name(), bead.layer + 1, bead.index + 1),
    }
}

/// Rounds to 0.001 mm, below visible detail.
fn micrometres(mm: f64) -> f64 {
    (mm * 1e3).round() / 1e3
}
