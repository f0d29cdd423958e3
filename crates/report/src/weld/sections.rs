use crate::Phrases as _;
use crate::{Gallery, Language, SectionDrawing, format_number};
use glam::DVec2;
use seamwright_program::Role;
use seamwright_weld::{BeadAt, BeadPlan, Section, Welding};

/// Draws cross-sections of the joint at path lengths `places` (mm), with planned beads and the torch in each of them.
/// Omits stations without a groove.
pub fn sections(welding: &Welding, places: &[f64], language: Language) -> Gallery {
    let drawing = |s: &f64| section(welding, *s, language);
    Gallery { language, title: String::new(), sections: places.iter().filter_map(drawing).collect() }
}

/// Target of the torch in a section, and the angle of its body from the bisector, rad.
struct Torch {
    tip: DVec2,
    lean: f64,
}

/// Returns the torch in each bead, or at the seam without planned beads.
fn torches(welding: &Welding, here: Option<&(&BeadPlan, Vec<BeadAt>)>, s: f64) -> Vec<Torch> {
    let work = |role| welding.torch_angles(role, s).map(|(work, _)| work);
    match here {
        Some((plan, beads)) => beads
            .iter()
            .filter_map(|bead| {
                let lean = bead.lean + work(Some(plan.layers[bead.layer].role))?;
                Some(Torch { tip: bead.tip, lean })
            })
            .collect(),
        None => work(None).map(|lean| Torch { tip: DVec2::ZERO, lean }).into_iter().collect(),
    }
}

/// Describes the torch angles of the weld's first pass other than a tack.
fn torch_note(welding: &Welding, s: f64, language: Language) -> Option<String> {
    let roles = [None, Some(Role::Root), Some(Role::Fill), Some(Role::Cap)];
    let (work, travel) = roles.into_iter().find_map(|role| welding.torch_angles(role, s))?;
    let degrees = [work, travel].map(|angle| format_number(angle.to_degrees(), 3));
    Some(language.fill("torch: work angle {0} deg, travel angle {1} deg", &[&degrees[0], &degrees[1]]))
}

fn section(welding: &Welding, s: f64, language: Language) -> Option<SectionDrawing> {
    let (seam, joint) = (welding.seam.as_ref()?, welding.joint.as_ref()?);
    let point = seam.at(s);
    let section: Section = joint.section(&point)?;
    let turn = DVec2::from_angle(joint.upright(&section));
    let place = |p: &DVec2| turn.rotate(*p).to_array();
    let outline = |points: Vec<DVec2>| points.iter().map(place).collect::<Vec<_>>();
    let here = welding.plan.as_ref().map(|plan| (plan, plan.in_order(&section, s)));
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
        torch_note: torch_note(welding, s, language).unwrap_or_default(),
        torches: torches(welding, here.as_ref(), s)
            .iter()
            .map(|torch| (place(&torch.tip), place(&DVec2::new(torch.lean.sin(), torch.lean.cos()))))
            .collect(),
    })
}
