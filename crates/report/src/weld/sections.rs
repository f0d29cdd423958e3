use crate::number::{Significant as _, quantity};
use crate::{DrawnBead, Gallery, Language, SectionDrawing};
use glam::DVec2;
use seamwright_message::{Message, Unit};
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
    let message = Message::new("report-section-torch")
        .significant("work", work.to_degrees(), Unit::Deg, 3)
        .significant("travel", travel.to_degrees(), Unit::Deg, 3);
    Some(message.in_language(language))
}

/// Returns the toe angles (rad) of the last layer on the second and the first part.
fn cap_toes(plan: &BeadPlan, beads: &[BeadAt]) -> Option<[f64; 2]> {
    let last = beads.iter().map(|bead| bead.layer).max()?;
    let count = plan.layers[last].beads;
    let at = |index: usize| beads.iter().find(|bead| bead.layer == last && bead.index == index);
    Some([at(0)?.toes.second, at(count - 1)?.toes.first])
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
    let at = Message::new("report-at").significant("s", s, Unit::Mm, 5);
    // Rounded, or a zero of the start would be shown with its rounding error.
    let degrees = |phi: f64| ((phi.to_degrees() * 1e6).round() / 1e6).rem_euclid(360.0);
    let angle = |phi: f64| quantity(degrees(phi), Unit::Deg, 4).in_language(language);
    let note = Message::new("report-section-note").significant("dihedral", point.dihedral.to_degrees(), Unit::Deg, 4);
    let area = |unit| quantity(section.area(), unit, 4);
    let note = match section.cap > 0.0 {
        true => {
            let sum = Message::new("report-area-with-cap").message("groove", area(Unit::One));
            note.message("area", sum.significant("cap", section.cap, Unit::Mm2, 3))
        }
        false => note.message("area", area(Unit::Mm2)),
    };
    let toes = here.as_ref().and_then(|(plan, beads)| cap_toes(plan, beads));
    let toes = toes.map_or_else(String::new, |[second, first]| {
        let message = Message::new("report-section-toes")
            .significant("second", second.to_degrees(), Unit::Deg, 3)
            .significant("first", first.to_degrees(), Unit::Deg, 3);
        message.in_language(language)
    });
    Some(SectionDrawing {
        title: at.in_language(language) + &point.phi.map_or_else(String::new, |phi| format!(", {}", angle(phi))),
        note: note.in_language(language) + &toes,
        parts: joint.metal(&section).into_iter().map(outline).collect(),
        groove: outline(section.first.iter().chain(section.second.iter().rev()).copied().collect()),
        beads: here
            .iter()
            .flat_map(|(plan, all)| {
                let drawn = section.outlines(all).into_iter().zip(all);
                let drawn = drawn.map(|(line, bead)| DrawnBead {
                    number: plan.number(bead),
                    outline: outline(line),
                    colour: colour(plan.layers[bead.layer].role),
                });
                drawn.collect::<Vec<_>>()
            })
            .collect(),
        insert: joint.insert(&section).map_or_else(Vec::new, outline),
        torch_note: torch_note(welding, s, language).unwrap_or_default(),
        torches: torches(welding, here.as_ref(), s)
            .iter()
            .map(|torch| (place(&torch.tip), place(&DVec2::new(torch.lean.sin(), torch.lean.cos()))))
            .collect(),
    })
}
