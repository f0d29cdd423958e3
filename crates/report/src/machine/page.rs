use super::MachineDrawing;
use super::tables::{axes, measure, reach, results, singular, structure};
use crate::block::{figure, paragraph, sections, tile};
use crate::number::{Significant as _, significant, small};
use crate::{Block, Finding, Language, Page, Severity, Tile, Verdict, Words as _};
use seamwright_machine::check::{Check, HeadCheck, Remark};
use seamwright_message::{Message, Unit};

/// Renders the check of a machine file as one self-contained HTML page in this language; `file` is its name, `source`
/// its text, `date` that of the page.
pub fn check_page(
    check: &Check,
    drawing: &MachineDrawing,
    file: &str,
    source: &str,
    date: &str,
    language: Language,
) -> String {
    let singular = check.heads.iter().flat_map(|head| singular_blocks(check, head, language)).collect();
    let failed = failures(check, language).into_iter().map(failure).collect::<Vec<_>>();
    let remarks = match check.remarks.is_empty() {
        true => paragraph("report-check-no-remarks", language),
        false => Block::Findings(check.remarks.iter().map(|r| remark(r, file, language)).collect()),
    };
    let machine = figure(drawing, "report-check-caption-machine", language);
    let reached = check.heads.iter().map(|h| Block::Paragraph(reach_words(h, language)));
    let parts = [
        ("report-check-heading-failed", if failed.is_empty() { vec![] } else { vec![Block::Findings(failed)] }),
        ("report-heading-axes", vec![machine, axes(check, language)]),
        ("report-check-remarks", vec![remarks]),
        ("report-check-heading-kinematics", vec![structure(check, language), results(check, language)]),
        ("report-check-singular", singular),
        ("report-check-heading-reach", std::iter::once(reach(check, language)).chain(reached).collect()),
        ("report-check-heading-file", vec![Block::Code { caption: file.to_owned(), text: source.to_owned() }]),
    ];
    let mut blocks = vec![Block::Tiles(tiles(check, language))];
    blocks.extend(sections(parts, language));
    let made_by = Message::new("report-check-made-by")
        .text("version", env!("CARGO_PKG_VERSION"))
        .text("seed", check.seed.to_string())
        .in_language(language);
    Page {
        language,
        title: check.title.clone(),
        subtitle: language.words("report-check-subtitle"),
        meta: language.named_values([
            ("report-meta-machine", check.name.clone()),
            ("report-column-file", file.to_owned()),
            ("report-column-date", date.to_owned()),
            ("report-meta-made-by", made_by),
        ]),
        verdict: Some(Verdict { ok: check.passed, text: verdict(check, language) }),
        blocks,
    }
    .render()
}

fn failures(check: &Check, language: Language) -> Vec<String> {
    check.failures.iter().map(|failure| failure.in_language(language)).collect()
}

fn verdict(check: &Check, language: Language) -> String {
    let message = match check.passed {
        true => Message::new("report-check-passed"),
        false => Message::new("report-check-failed").text("failures", failures(check, language).join("; ")),
    };
    let remarks = Message::new("report-check-remark-count").count("n", check.remarks.len());
    message.message("remarks", remarks).in_language(language)
}

fn tiles(check: &Check, language: Language) -> Vec<Tile> {
    let tile =
        |label, value: String, unit, note: Message| tile(language, label, unit, value, note.in_language(language));
    let count = |label, count: usize, note| tile(label, count.to_string(), Unit::One, note);
    let worst = |f: fn(&HeadCheck) -> f64| small(check.heads.iter().map(f).fold(0.0, f64::max), language);
    let rotary = check.axes.iter().filter(|a| a.kind == "rotary").count();
    let axes = Message::new("report-check-axis-count").count("rotary", rotary);
    let axes = axes.count("linear", check.axes.len() - rotary);
    let poses = check.heads.first().map_or(0, |h| h.round_trip.poses);
    let poses = Message::new("report-check-tip-error-note").count("n", poses as usize);
    let jacobian = Message::new("report-check-jacobian-note");
    let places: usize = check.heads.iter().map(|h| h.singular.places.len()).sum();
    let severity = (!check.remarks.is_empty()).then_some(Severity::Warning);
    let remarks = count("report-check-remarks", check.remarks.len(), Message::new("report-check-remarks-note"));
    vec![
        count("report-heading-axes", check.axes.len(), axes),
        tile("report-check-tip-error", worst(|h| h.round_trip.point_mm), Unit::Mm, poses),
        tile("report-check-jacobian", worst(|h| h.jacobian.relative), Unit::One, jacobian),
        count("report-check-singular", places, Message::new("report-check-singular-note")),
        Tile { severity, ..remarks },
    ]
}

fn failure(text: String) -> Finding {
    Finding { severity: Severity::Error, text, place: String::new(), cure: String::new() }
}

fn remark_text(r: &Remark, language: Language) -> String {
    let message = match r.value.is_empty() {
        true => Message::new("report-check-remark").key("key", &r.key),
        false => Message::new("report-check-remark-value").key("key", &r.key).text("value", &r.value),
    };
    message.message("why", r.why.clone()).in_language(language)
}

fn remark(r: &Remark, file: &str, language: Language) -> Finding {
    let line = || Message::new("report-check-line").text("file", file).text("line", r.line.to_string());
    Finding {
        severity: Severity::Warning,
        text: remark_text(r, language),
        place: if r.line > 0 { line().in_language(language) } else { file.to_owned() },
        cure: r.cure.in_language(language),
    }
}

fn singular_blocks(check: &Check, head: &HeadCheck, language: Language) -> Vec<Block> {
    let s = &head.singular;
    let rate = (s.typical.0 / s.typical.1).to_degrees();
    let typical = Message::new("report-check-typical")
        .significant("speed", s.typical.0, Unit::MmPerS, 5)
        .significant("radius", s.typical.1, Unit::Mm, 5)
        .significant("rate", rate, Unit::DegPerS, 3)
        .in_language(language);
    let fast = match s.too_fast > 0.0 {
        true => Message::new("report-check-too-fast").significant("part", 100.0 * s.too_fast, Unit::Percent, 2),
        false => Message::new("report-check-fast-enough"),
    };
    let fast = fast.in_language(language);
    if !s.places.is_empty() {
        let text = language.sentences(&[typical, fast]);
        return vec![singular(check, head, language), Block::Paragraph(text)];
    }
    let at = check.axes.iter().zip(&s.worst_at).map(|(a, v)| {
        let unit = Unit::from_symbol(a.unit).unwrap_or(Unit::One);
        let position = Message::new("report-check-position").axis("axis", &a.name);
        position.significant("position", *v, unit, 4).in_language(language)
    });
    let text = Message::new("report-check-no-singular")
        .text("head", &head.name)
        .text("position", at.collect::<Vec<_>>().join(", "))
        .text("worst", significant(s.conditioning.1, 2, language))
        .text("best", significant(s.conditioning.0, 2, language))
        .in_language(language);
    vec![Block::Paragraph(language.sentences(&[text, typical, fast]))]
}

fn reach_words(h: &HeadCheck, language: Language) -> String {
    let kind = match h.reach.volume.dimensions {
        3 => "volume",
        2 => "area",
        _ => "length",
    };
    Message::new("report-check-reach")
        .text("head", &h.name)
        .text("kind", kind)
        .message("size", measure(h))
        .significant("part", 100.0 * h.reach.volume.part_of_box, Unit::Percent, 3)
        .significant("tilt", h.reach.tilt_deg, Unit::Deg, 4)
        .in_language(language)
}

/// Lines of text: a label and a description.
struct Lines {
    text: String,
    language: Language,
}

impl Lines {
    fn line(&mut self, indent: &str, label: &'static str, what: &str) {
        let label = format!("{indent}{}", self.language.words(label));
        self.text += &format!("  {label:<12} {what}\n");
    }

    fn message(&mut self, indent: &str, label: &'static str, what: &Message) {
        let what = what.in_language(self.language);
        self.line(indent, label, &what);
    }
}

/// Renders the check as plain text in this language.
pub fn check_text(check: &Check, language: Language) -> String {
    let mut lines = Lines { text: format!("{}\n", check.title), language };
    let result = if check.passed { "report-check-result-passed" } else { "report-check-result-failed" };
    lines.message("", "report-check-text-result", &Message::new(result));
    failures(check, language).iter().for_each(|f| lines.line("", "report-check-text-failure", f));
    check.heads.iter().for_each(|head| head_lines(check, head, &mut lines));
    if let Some(r) = &check.pair {
        let pair = Message::new("report-check-text-pair")
            .count("n", r.poses as usize)
            .text("tip", small_in(r.point_mm, Unit::Mm, language))
            .text("direction", small_in(r.direction_deg, Unit::Deg, language))
            .count("off", r.off_centre as usize);
        lines.message("", "report-check-both-heads", &pair);
    }
    for r in &check.remarks {
        let text = remark_text(r, language);
        let line = || Message::new("report-check-text-line").text("line", r.line.to_string()).text("remark", &text);
        let text = if r.line > 0 { line().in_language(language) } else { text };
        lines.line("", "report-check-text-remark", &text);
        let cure = Message::new("report-check-text-cure").message("cure", r.cure.clone());
        lines.message("", "", &cure);
    }
    lines.text
}

fn small_in(value: f64, unit: Unit, language: Language) -> String {
    format!("{} {}", small(value, language), language.symbol(unit))
}

fn head_lines(check: &Check, h: &HeadCheck, lines: &mut Lines) {
    let language = lines.language;
    let r = &h.round_trip;
    lines.line("", "report-check-text-head", &h.name);
    lines.line("  ", "report-check-text-inverse", &h.structure.in_language(language));
    let errors = Message::new("report-check-text-errors")
        .count("n", r.poses as usize)
        .text("tip", small_in(r.point_mm, Unit::Mm, language))
        .text("direction", small_in(r.direction_deg, Unit::Deg, language))
        .text("axes", small(r.axes_mm_or_deg, language))
        .count("near", r.near_singular as usize);
    lines.message("  ", "report-check-text-round-trip", &errors);
    let jacobian = Message::new("report-check-text-jacobian").text("difference", small(h.jacobian.relative, language));
    lines.message("  ", "report-check-jacobian", &jacobian);
    for p in &h.singular.places {
        let place = super::tables::place(check, p, language);
        let text = match &p.margin {
            Some((by, axis)) => {
                let (speed, radius) = h.singular.typical;
                let unit = p.at.first().map_or(Unit::One, |a| super::tables::unit(check, &a.0));
                Message::new("report-check-text-margin")
                    .text("place", place)
                    .significant("distance", *by, unit, 3)
                    .axis("axis", axis)
                    .value("speed", speed, Unit::MmPerS)
                    .value("radius", radius, Unit::Mm)
                    .in_language(language)
            }
            None => place,
        };
        lines.line("  ", "report-check-text-singular", &text);
    }
    if h.singular.places.is_empty() {
        lines.message("  ", "report-check-text-singular", &Message::new("report-check-text-no-singular"));
    }
    let [low, high] = h.reach.work_box_mm;
    let side = |i: usize| Message::new("report-range").number("from", low[i], 0).number("to", high[i], 0);
    let sides = Message::new("report-check-text-box").message("x", side(0)).message("y", side(1)).message("z", side(2));
    lines.message("  ", "report-check-text-reach", &sides);
    let tilt = Message::new("report-check-text-tilt").message("size", measure(h));
    let tilt = tilt.significant("tilt", h.reach.tilt_deg, Unit::Deg, 4);
    lines.message("", "", &tilt);
}
