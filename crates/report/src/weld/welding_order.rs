use crate::{Language, OrderDrawing, OrderedLine, Words as _};
use glam::DVec3;
use seamwright_message::Message;
use seamwright_program::{Pass, Role, TorchPath};
use seamwright_weld::Welding;

/// Number of drawn segments per pass.
const PLACES: i32 = 96;

/// Directions towards the viewer from which the order may be drawn.
const VIEWS: [(DVec3, &str); 6] = [
    (DVec3::Z, "report-seen-from-above"),
    (DVec3::NEG_Z, "report-seen-from-below"),
    (DVec3::X, "report-seen-from-plus-x"),
    (DVec3::NEG_X, "report-seen-from-minus-x"),
    (DVec3::Y, "report-seen-from-plus-y"),
    (DVec3::NEG_Y, "report-seen-from-minus-y"),
];

/// Draws the passes of a weld in their order, without weaves, from the side that most faces look to. Returns `None` for
/// a weld in one pass.
pub(crate) fn order(welding: &Welding, language: Language) -> Option<OrderDrawing> {
    let passes = &welding.program.value.passes;
    if passes.len() < 2 {
        return None;
    }
    let paths: Vec<_> = (0..passes.len()).map(|i| welding.path(i)).collect();
    let at = |i: usize, k: i32| paths[i].length() * f64::from(k) / f64::from(PLACES);
    let tips: Vec<Vec<DVec3>> =
        (0..paths.len()).map(|i| (0..=PLACES).map(|k| paths[i].line_point(at(i, k))).collect()).collect();
    let faces = (0..paths.len()).flat_map(|i| (0..PLACES).map(move |k| (i, k)));
    let mean: DVec3 = faces.map(|(i, k)| paths[i].face(at(i, k))).sum();
    // Equal views: the first one wins.
    let nearer = |a: (DVec3, &'static str), b: (DVec3, &'static str)| {
        if mean.dot(b.0) > mean.dot(a.0) + 1e-6 * mean.length() { b } else { a }
    };
    let (out, view) = VIEWS.into_iter().fold(VIEWS[0], nearer);
    let right = if out.x.abs() > 0.5 { DVec3::Y } else { DVec3::X };
    let up = out.cross(right);
    let flat = |p: DVec3| [p.dot(right), p.dot(up)];
    // Each number lies towards the middle of its seam.
    let middle = |copy: usize| {
        let Some(seam) = &welding.seam else {
            let all = tips.iter().flatten();
            return flat(all.clone().sum::<DVec3>() / all.count() as f64);
        };
        let places = (0..PLACES).map(|k| seam.at(seam.length() * f64::from(k) / f64::from(PLACES)).point);
        let middle = places.sum::<DVec3>() / f64::from(PLACES);
        flat(welding.program.value.copy_in_work(copy).transform_point3(middle))
    };
    let tack = |pass: &Pass| pass.role == Some(Role::Tack);
    let mut key = vec![language.words("report-order-key")];
    if passes.iter().any(tack) {
        key.push(language.words("report-order-key-tacks"));
    }
    let line = |(pass, tips): (&Pass, &Vec<DVec3>)| OrderedLine {
        points: tips.iter().map(|p| flat(*p)).collect(),
        middle: middle(pass.copy),
        outside: tack(pass),
        colour: if tack(pass) { 2 } else { 1 },
    };
    let title = Message::new("report-chart-order").count("n", passes.len()).message("view", Message::new(view));
    Some(OrderDrawing {
        language,
        title: title.in_language(language),
        key: language.sentences(&key),
        lines: passes.iter().zip(&tips).map(line).collect(),
    })
}
