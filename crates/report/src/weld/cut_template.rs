//! Template of a tube's cut end, unrolled at true size, to wrap around the tube.

use crate::text::printable;
use crate::{Language, Words as _};
use maud::{PreEscaped, html};
use seamwright_message::{Message, Unit};
use seamwright_weld::{Cut, Unrolled};
use std::fmt::Write;

/// Free space around the drawing, mm.
const MARGIN_MM: f64 = 12.0;
/// Distance of the template's square edge above the cut's highest point, mm.
const ABOVE_MM: f64 = 20.0;
/// Caption of each side.
const OUTSIDE: &str = "report-cut-outside";
const INSIDE: &str = "report-cut-inside";
/// Spacing of the upright lines, degrees.
const EVERY_DEG: u32 = 30;

/// Draws the template at true size (its units are mm): outside and, if known, inside, each with the cut below and a
/// square edge above. Heights at the left count from the tube's origin.
pub(crate) fn template(cut: &Cut, language: Language) -> String {
    let sides = [Some((OUTSIDE, &cut.outside)), cut.inside.as_ref().map(|inside| (INSIDE, inside))];
    let mut body = String::new();
    let (mut width, mut y) = (0.0f64, MARGIN_MM);
    for (caption, side) in sides.into_iter().flatten() {
        width = width.max(side.points.last().map_or(0.0, |p| p.around));
        y = draw(&mut body, Message::new(caption), side, y, language) + MARGIN_MM;
    }
    let (w, h) = (mm(width + 2.0 * MARGIN_MM), mm(y));
    let element = html! {
        svg xmlns="http://www.w3.org/2000/svg" viewBox=(format!("0 0 {w} {h}")) width=(format!("{w}mm"))
            height=(format!("{h}mm")) class="plot" role="img" aria-label=(language.words("report-chart-cut")) {
            "\n"
            rect width=(w) height=(h) fill="#fff" {}
            "\n" (PreEscaped(body))
        }
    };
    printable(element.0 + "\n")
}

/// Draws one side from `top` on, below its caption with its lengths; returns its lower end.
fn draw(body: &mut String, caption: Message, side: &Unrolled, top: f64, language: Language) -> f64 {
    let heights = side.points.iter().map(|p| p.height);
    let (low, high) = heights.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), z| (l.min(z), h.max(z)));
    let length = side.points.last().map_or(0.0, |p| p.around);
    let edge = high + ABOVE_MM;
    let (head, left) = (top + 6.0, MARGIN_MM);
    let at = |around: f64, height: f64| format!("{},{}", mm(left + around), mm(head + edge - height));
    let mut outline = format!("M{} L{}", at(0.0, edge), at(length, edge));
    for p in side.points.iter().rev() {
        let _ = write!(outline, " L{}", at(p.around, p.height));
    }
    let mut upright = String::new();
    for p in side.points.iter().filter(|p| is_drawn(p.phi)) {
        let _ = write!(upright, "M{} L{} ", at(p.around, edge), at(p.around, p.height));
        let angle = format!("{:.0}\u{b0}", p.phi.to_degrees());
        *body += &html! {
            text x=(mm(left + p.around)) y=(mm(head - 1.0)) style="font:2.6px sans-serif;fill:#000" text-anchor="middle" {
                (angle)
            }
            "\n"
        }
        .0;
    }
    let caption = caption
        .value("radius", side.radius, Unit::Mm)
        .quantity("around", length, Unit::Mm, 2)
        .number("from", low, 2)
        .quantity("to", high, Unit::Mm, 2)
        .quantity("edge", edge, Unit::Mm, 2);
    *body += &html! {
        text x=(mm(left)) y=(mm(top)) style="font:3.2px sans-serif;fill:#000" { (caption.in_language(language)) }
        "\n"
        path d=(upright.trim_end()) fill="none" stroke="#888" stroke-width="0.1" {}
        "\n"
        path d={ (outline) " Z" } fill="none" stroke="#000" stroke-width="0.25" {}
    }
    .0;
    head + edge - low
}

/// Returns whether `phi` is a multiple of [`EVERY_DEG`].
fn is_drawn(phi: f64) -> bool {
    let turns = phi.to_degrees() / f64::from(EVERY_DEG);
    (turns - turns.round()).abs() < 1e-9
}

/// Formats a length to a thousandth.
fn mm(value: f64) -> String {
    format!("{value:.3}")
}
