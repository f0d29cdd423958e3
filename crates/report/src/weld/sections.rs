use crate::{Gallery, Language, SectionDrawing, format_number};
use glam::DVec2;
use seamwright_program::Role;
use seamwright_weld::{BeadPlan, SeamCurve, SeamJoint};

/// Cross-sections of the joint at path lengths `places` (mm), with its beads if they are planned; places without a
/// groove are left out.
pub fn sections(
    (seam, joint): (&SeamCurve, &SeamJoint),
    beads: Option<&BeadPlan>,
    places: &[f64],
    language: Language,
) -> Gallery {
    let drawing = |s: &f64| section((seam, joint), beads, *s, language);
    Gallery { language, title: String::new(), sections: places.iter().filter_map(drawing).collect() }
}

fn section(
    (seam, joint): (&SeamCurve, &SeamJoint),
    beads: Option<&BeadPlan>,
    s: f64,
    language: Language,
) -> Option<SectionDrawing> {
    let point = seam.at(s);
    let section = joint.section(&point)?;
    let turn = DVec2::from_angle(joint.upright(&section));
    let place = |p: &DVec2| turn.rotate(*p).to_array();
    let outline = |points: Vec<DVec2>| points.iter().map(place).collect::<Vec<_>>();
    let here = beads.map(|plan| (plan, plan.in_order(&section, s)));
    let colour = |role: Role| match role {
        Role::Root | Role::Tack => 2,
        Role::Fill => 1,
        Role::Cap | Role::Cosmetic => 3,
    };
    let number = |phi: f64| format_number(phi.to_degrees().rem_euclid(360.0), 4);
    let angle = point.phi.map(|phi| format!(", {}", language.fill("{0} deg", &[&number(phi)])));
    let cap = if section.cap > 0.0 { format!(" + {}", format_number(section.cap, 3)) } else { String::new() };
    Some(SectionDrawing {
        title: language.fill("s = {0} mm", &[&format_number(s, 5)]) + &angle.unwrap_or_default(),
        note: language.fill(
            "dihedral {0} deg, area {1} mm²",
            &[&format_number(point.dihedral.to_degrees(), 4), &(format_number(section.area(), 4) + &cap)],
        ),
        parts: joint.parts(&section).map(outline).to_vec(),
        groove: outline(section.first.iter().chain(section.second.iter().rev()).copied().collect()),
        beads: here
            .iter()
            .flat_map(|(plan, all)| {
                all.iter().map(|bead| (outline(section.outline(bead)), colour(plan.layers[bead.layer].role)))
            })
            .collect(),
        torches: here
            .iter()
            .flat_map(|(_, all)| all.iter())
            .map(|bead| {
                let back = DVec2::new(bead.lean.sin(), bead.lean.cos());
                (place(&bead.tip), place(&back))
            })
            .collect(),
    })
}
