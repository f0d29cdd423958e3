use super::MachineDrawing;
use super::tables::{axes, measure, number, reach, results, singular, small, structure, unit};
use crate::{Block, Finding, Language, Page, Severity, Tile, Verdict, format_number};
use seamwright_machine::check::{Check, HeadCheck, Remark};

/// Renders the check of a machine file as one self-contained HTML page; `file` is its name, `source` its text, `date`
/// that of the page.
pub fn check_page(check: &Check, drawing: &MachineDrawing, file: &str, source: &str, date: &str) -> String {
    let mut blocks = vec![Block::Tiles(tiles(check))];
    if !check.failures.is_empty() {
        blocks.push(Block::Heading("Failed tests".to_owned()));
        blocks.push(Block::Findings(check.failures.iter().map(|f| failure(f.to_string())).collect()));
    }
    blocks.push(Block::Heading("Axes".to_owned()));
    blocks.push(Block::Figure {
        svg: drawing.to_svg(),
        caption: "The machine at home, seen in its base frame, in first-angle projection. Arrows show the positive sense of what each axis moves: of the torch on the tool side, of the work on the work side; turns follow the right hand. Symbols that would cover each other stand side by side.".to_owned(),
    });
    blocks.push(Block::Table(axes(check)));
    blocks.push(Block::Heading("Remarks".to_owned()));
    blocks.push(match check.remarks.is_empty() {
        true => Block::Paragraph("None: limits, ranges and drives are of a usual size and fit together.".to_owned()),
        false => Block::Findings(check.remarks.iter().map(|r| remark(r, file)).collect()),
    });
    blocks.push(Block::Heading("Kinematics".to_owned()));
    blocks.push(Block::Table(structure(check)));
    blocks.push(Block::Table(results(check)));
    blocks.push(Block::Heading("Singular places".to_owned()));
    for head in &check.heads {
        blocks.extend(singular_blocks(check, head));
    }
    blocks.push(Block::Heading("Reach".to_owned()));
    blocks.push(Block::Table(reach(check)));
    blocks.extend(check.heads.iter().map(|h| Block::Paragraph(reach_words(h))));
    blocks.push(Block::Heading("Machine file".to_owned()));
    blocks.push(Block::Code { caption: file.to_owned(), text: source.to_owned() });
    Page {
        language: Language::English,
        title: check.title.clone(),
        subtitle: "Check of the machine file".to_owned(),
        meta: vec![
            ("Machine".to_owned(), check.name.clone()),
            ("File".to_owned(), file.to_owned()),
            ("Date".to_owned(), date.to_owned()),
            ("Made by".to_owned(), format!("Seamwright {}, seed {}", env!("CARGO_PKG_VERSION"), check.seed)),
        ],
        verdict: Some(Verdict { ok: check.passed, text: verdict(check) }),
        blocks,
    }
    .render()
}

fn verdict(check: &Check) -> String {
    let remarks = match check.remarks.len() {
        0 => "no remarks".to_owned(),
        1 => "1 remark".to_owned(),
        n => format!("{n} remarks"),
    };
    match check.passed {
        true => format!(
            "Every pose comes back from its own positions, and the Jacobian agrees with differences; {remarks}."
        ),
        false => {
            format!("{}; {remarks}.", check.failures.iter().map(ToString::to_string).collect::<Vec<_>>().join("; "))
        }
    }
}

fn tiles(check: &Check) -> Vec<Tile> {
    let tile = |label: &str, value: String, unit: &str, note: String| Tile {
        label: label.to_owned(),
        value,
        unit: unit.to_owned(),
        note,
        ..Tile::default()
    };
    let worst = |f: fn(&HeadCheck) -> f64| check.heads.iter().map(f).fold(0.0, f64::max);
    let rotary = check.axes.iter().filter(|a| a.kind == "rotary").count();
    let places: usize = check.heads.iter().map(|h| h.singular.places.len()).sum();
    let mut remarks = tile("Remarks", check.remarks.len().to_string(), "", "values that are not usual".to_owned());
    remarks.severity = (!check.remarks.is_empty()).then_some(Severity::Warning);
    vec![
        tile(
            "Axes",
            check.axes.len().to_string(),
            "",
            format!("{rotary} rotary, {} linear", check.axes.len() - rotary),
        ),
        tile(
            "Round trip, tip",
            small(worst(|h| h.round_trip.point_mm)),
            "mm",
            format!("worst of {} random poses a head", check.heads.first().map_or(0, |h| h.round_trip.poses)),
        ),
        tile("Jacobian", small(worst(|h| h.jacobian.relative)), "", "worst difference, as a part".to_owned()),
        tile("Singular places", places.to_string(), "", "inside the ranges".to_owned()),
        remarks,
    ]
}

fn failure(text: String) -> Finding {
    Finding { severity: Severity::Error, text, place: String::new(), cure: String::new() }
}

fn remark(r: &Remark, file: &str) -> Finding {
    let value = if r.value.is_empty() { String::new() } else { format!(" = {}", r.value) };
    Finding {
        severity: Severity::Warning,
        text: format!("{}{value}: {}", r.key, r.why),
        place: if r.line > 0 { format!("{file}, line {}", r.line) } else { file.to_owned() },
        cure: r.cure.to_string(),
    }
}

fn singular_blocks(check: &Check, head: &HeadCheck) -> Vec<Block> {
    let s = &head.singular;
    let typical = format!(
        "A typical weld is {} mm/s round a bend of {} mm, in which the torch turns by {} deg/s.",
        number(s.typical.0),
        number(s.typical.1),
        format_number((s.typical.0 / s.typical.1).to_degrees(), 3)
    );
    let fast = match s.too_fast > 0.0 {
        true => format!(
            " In {} % of the ranges some typical weld asks more of a rotary axis than it can do.",
            format_number(100.0 * s.too_fast, 2)
        ),
        false => " Every typical weld is within the speed of the rotary axes, all over the ranges.".to_owned(),
    };
    if !s.places.is_empty() {
        return vec![Block::Table(singular(check, head)), Block::Paragraph(typical + &fast)];
    }
    let at = check.axes.iter().zip(&s.worst_at).map(|(a, v)| format!("{} {} {}", a.name, format_number(*v, 4), a.unit));
    let text = format!(
        "Head {}: none inside the ranges. The least well conditioned place is {} (conditioning {}; {} at the best place). {typical}{fast}",
        head.name,
        at.collect::<Vec<_>>().join(", "),
        format_number(s.conditioning.1, 2),
        format_number(s.conditioning.0, 2)
    );
    vec![Block::Paragraph(text)]
}

fn reach_words(h: &HeadCheck) -> String {
    let what = match h.reach.volume.dimensions {
        3 => "volume",
        2 => "area",
        _ => "length",
    };
    let part = format_number(100.0 * h.reach.volume.part_of_box, 3);
    format!(
        "Head {}: {what} reached by the tip in the work frame: {}, {part} % of its box. The torch stands up to {} degrees off where it points at home, seen from the work.",
        h.name,
        measure(h),
        format_number(h.reach.tilt_deg, 4)
    )
}

/// Renders the check as plain text.
pub fn check_text(check: &Check) -> String {
    use std::fmt::Write;
    let mut text = format!("{}\n", check.title);
    // Writing to a String cannot fail.
    let mut line = |name: &str, what: String| {
        let _ = writeln!(text, "  {name:<12} {what}");
    };
    line("result", if check.passed { "passed".to_owned() } else { "FAILED".to_owned() });
    check.failures.iter().for_each(|f| line("failed", f.to_string()));
    for h in &check.heads {
        let r = &h.round_trip;
        line("head", h.name.clone());
        line("  inverse", h.structure.to_string());
        line(
            "  round trip",
            format!(
                "{} poses: tip {} mm, direction {} deg, axes {} mm or deg; {} near singular",
                r.poses,
                small(r.point_mm),
                small(r.direction_deg),
                small(r.axes_mm_or_deg),
                r.near_singular
            ),
        );
        line("  Jacobian", format!("{} of a column from differences", small(h.jacobian.relative)));
        for p in &h.singular.places {
            let margin = p.margin.as_ref().map_or_else(String::new, |(by, axis)| {
                let unit = p.at.first().map_or("", |a| unit(check, &a.0));
                let (speed, radius) = h.singular.typical;
                format!(
                    "; nearer than {} {unit} {axis} is too slow for {speed} mm/s on {radius} mm",
                    format_number(*by, 3)
                )
            });
            line("  singular", p.sentence(|name| unit(check, name)).to_string() + &margin);
        }
        if h.singular.places.is_empty() {
            line("  singular", "no place inside the ranges".to_owned());
        }
        let [low, high] = h.reach.work_box_mm;
        let side = |i: usize| format!("{:.0} to {:.0}", low[i] + 0.0, high[i] + 0.0);
        line("  reach", format!("x {}, y {}, z {} mm in the work frame", side(0), side(1), side(2)));
        line("", format!("{}; up to {} deg from home", measure(h), format_number(h.reach.tilt_deg, 4)));
    }
    if let Some(r) = &check.pair {
        line(
            "both heads",
            format!(
                "{} poses: tips {} mm, directions {} deg; {} with slides off centre have no way",
                r.poses,
                small(r.point_mm),
                small(r.direction_deg),
                r.off_centre
            ),
        );
    }
    for r in &check.remarks {
        let value = if r.value.is_empty() { String::new() } else { format!(" = {}", r.value) };
        let place = if r.line > 0 { format!("line {}: ", r.line) } else { String::new() };
        line("remark", format!("{place}{}{value}: {}", r.key, r.why));
        line("", format!("cure: {}", r.cure));
    }
    text
}
