//! The page of a study.

use super::columns::Columns;
use super::figures::Figure;
use super::open::Study;
use super::summary::{FigureSummary, IndexSummary, StudySummary, SweepSummary, sorted};
use crate::output::words;
use seamwright_message::{Catalogue, Language, Message};
use seamwright_project::failure::Failure;
use seamwright_report::{
    Axis, Block, Chart, Drawing as _, Page, Series, Style, Table, Tile, Tornado, TornadoRow, Verdict, format_number,
};
use std::path::Path;

/// Significant digits of figures in the report.
const DIGITS: usize = 4;
/// Classes of a histogram.
const BINS: usize = 24;
/// Means that differ by less than this part of their size along a sweep have no curve.
const NOISE: f64 = 1e-6;

pub(crate) fn page(study: &Study, summary: &StudySummary, parquet: &Path) -> Result<Page, Failure> {
    let columns = Columns::open(study, parquet)?;
    let language = Language::of_process();
    let mut blocks = vec![Block::Tiles(tiles(summary))];
    if summary.nominal.status != "weldable" {
        blocks.push(Block::Paragraph(words("study-nominal-blocked")));
    }
    if !summary.findings.is_empty() {
        blocks.extend([Block::Heading(words("study-findings")), Block::Table(findings(summary))]);
    }
    blocks.extend([Block::Heading(words("study-figures")), Block::Table(figures(study, summary))]);
    blocks.extend([Block::Heading(words("study-quantities")), Block::Table(quantities(summary))]);
    for (i, figure) in study.figures.iter().enumerate() {
        let Some(found) = summary.figures.iter().find(|found| found.name == figure.name) else { continue };
        if found.deviation > 0.0 {
            blocks.push(Block::Heading(label(study, figure)));
            blocks.push(histogram(study, figure, &columns.figure(i)?));
            blocks.extend(tornado(study, figure, found));
        }
    }
    for sweep in &summary.sweeps {
        blocks.extend(curves(study, sweep));
    }
    let verdict = Message::new("study-verdict").text("percent", percent(summary.weldable.estimate));
    let verdict = verdict.number("draws", summary.draws as f64, 0).in_language(language);
    Ok(Page {
        language,
        title: if summary.title.is_empty() { words("study-title") } else { summary.title.clone() },
        subtitle: format!("{}, {}", summary.job, summary.machine),
        meta: Vec::new(),
        verdict: Some(Verdict { ok: summary.weldable.estimate >= 1.0, text: verdict }),
        blocks,
    })
}

fn percent(value: f64) -> String {
    format_number(100.0 * value, 3)
}

fn number(value: f64) -> String {
    format_number(value, DIGITS)
}

fn interval(low: f64, high: f64) -> String {
    format!("{} – {}", percent(low), percent(high))
}

/// Name of a figure in the language of the process.
fn label(study: &Study, figure: &Figure) -> String {
    figure.label(&study.loaded.machine).in_language(Language::of_process())
}

fn axis(study: &Study, figure: &Figure) -> Axis {
    Axis::new(label(study, figure), Catalogue::of(Language::of_process()).symbol(figure.unit))
}

fn tiles(summary: &StudySummary) -> Vec<Tile> {
    let weldable = summary.weldable;
    let note = Message::new("study-weldable-interval").text("low", percent(weldable.low));
    let note = note.text("high", percent(weldable.high)).in_language(Language::of_process());
    let draws = Tile { label: words("study-draws"), value: summary.draws.to_string(), ..Tile::default() };
    let value = percent(weldable.estimate);
    vec![draws, Tile { label: words("study-weldable"), value, unit: "%".into(), note, severity: None }]
}

fn findings(summary: &StudySummary) -> Table {
    let row = |finding: &super::summary::FindingSummary| {
        let p = finding.probability;
        vec![finding.code.clone(), finding.draws.to_string(), percent(p.estimate), interval(p.low, p.high)]
    };
    Table {
        caption: words("study-findings-caption"),
        head: ["study-code", "study-draws", "study-probability", "study-interval"].map(words).to_vec(),
        rows: summary.findings.iter().map(row).collect(),
        numeric: vec![false, true, true, true],
        sortable: true,
    }
}

fn figures(study: &Study, summary: &StudySummary) -> Table {
    let row = |found: &FigureSummary| {
        let figure = study.figures.iter().find(|figure| figure.name == found.name);
        let name = figure.map_or_else(|| found.name.clone(), |figure| label(study, figure));
        let unit = figure.map_or(String::new(), |f| Catalogue::of(Language::of_process()).symbol(f.unit));
        let mut cells = vec![name, unit, found.draws.to_string(), found.nominal.map_or(String::new(), number)];
        cells.extend(found.statistics().map(number));
        cells
    };
    let head =
        [&["study-figure", "study-unit", "study-draws", "study-nominal"], &FigureSummary::STATISTICS[..]].concat();
    Table {
        caption: words("study-figures-caption"),
        head: head.iter().copied().map(words).collect(),
        rows: summary.figures.iter().map(row).collect(),
        numeric: (0..head.len()).map(|i| i > 1).collect(),
        sortable: false,
    }
}

fn quantities(summary: &StudySummary) -> Table {
    let row = |q: &super::summary::QuantitySummary| {
        let mut cells = vec![q.name.clone(), q.varies.clone()];
        cells.extend([q.nominal, q.mean, q.deviation, q.min, q.max].map(number));
        cells
    };
    let head =
        ["study-quantity", "study-varies", "study-nominal", "study-mean", "study-deviation", "study-min", "study-max"];
    Table {
        caption: words("study-quantities-caption"),
        head: head.map(words).to_vec(),
        rows: summary.quantities.iter().map(row).collect(),
        numeric: (0..head.len()).map(|i| i > 1).collect(),
        sortable: false,
    }
}

/// The outline of the bars of a histogram.
fn histogram(study: &Study, figure: &Figure, values: &[f64]) -> Block {
    let values = sorted(values.iter().copied());
    let (low, high) = (values.first().copied().unwrap_or(0.0), values.last().copied().unwrap_or(1.0));
    let width = (high - low) / BINS as f64;
    let mut counts = [0u64; BINS];
    for value in &values {
        counts[(((value - low) / width) as usize).min(BINS - 1)] += 1;
    }
    let part = |count: u64| 100.0 * count as f64 / values.len() as f64;
    let mut outline = vec![(low, 0.0)];
    for (i, count) in counts.iter().enumerate() {
        let edge = |i: usize| low + width * i as f64;
        outline.extend([(edge(i), part(*count)), (edge(i + 1), part(*count))]);
    }
    outline.push((high, 0.0));
    let language = Language::of_process();
    let title = Message::new("study-histogram").text("figure", label(study, figure)).in_language(language);
    let chart = Chart {
        language,
        title,
        x: axis(study, figure),
        y: Axis::new(words("study-density"), ""),
        series: vec![Series::line("", outline)],
        ..Chart::default()
    };
    let caption = Message::new("study-histogram-caption").number("bins", BINS as f64, 0).in_language(language);
    Block::Figure { svg: chart.to_svg(), caption }
}

fn tornado(study: &Study, figure: &Figure, found: &FigureSummary) -> Option<Block> {
    let language = Language::of_process();
    let nominal = found.nominal?;
    let index = |quantity: &str| found.indices.iter().find(|index| index.quantity == quantity);
    let note = |index: &IndexSummary| {
        let i = index.index;
        format!("S {} % ({})", percent(i.estimate), interval(i.low, i.high))
    };
    let mut rows: Vec<TornadoRow> = found
        .swings
        .iter()
        .map(|swing| TornadoRow {
            name: swing.quantity.clone(),
            at_low: swing.at_low,
            at_high: swing.at_high,
            note: index(&swing.quantity).map_or(String::new(), note),
        })
        .collect();
    let size = |row: &TornadoRow| {
        let ends = [row.at_low, row.at_high].map(|end| end.unwrap_or(nominal)).map(|end| end - nominal);
        ends[0].max(ends[1]).max(0.0) - ends[0].min(ends[1]).min(0.0)
    };
    rows.sort_by(|a, b| size(b).total_cmp(&size(a)));
    let title = Message::new("study-tornado").text("figure", label(study, figure)).in_language(language);
    let tornado = Tornado { language, title, axis: axis(study, figure), nominal, rows };
    Some(Block::Figure { svg: tornado.to_svg(), caption: words("study-tornado-caption") })
}

/// Results over the values of a sweep.
fn curves(study: &Study, sweep: &SweepSummary) -> Vec<Block> {
    let language = Language::of_process();
    let chart = |name: String, y: Axis, series: Vec<Series>, caption: String| {
        let title = Message::new("study-sweep").text("figure", name).text("quantity", &sweep.quantity);
        let x = Axis::new(sweep.quantity.clone(), "");
        let chart = Chart { language, title: title.in_language(language), x, y, series, ..Chart::default() };
        Block::Figure { svg: chart.to_svg(), caption }
    };
    let weldable = |of: fn(&super::summary::SweepPoint) -> f64| {
        sweep.points.iter().map(|point| (point.value, 100.0 * of(point))).collect::<Vec<_>>()
    };
    let dashed = |points: Vec<(f64, f64)>, code| Series::line(words(code), points).styled(Style::Dashed).coloured(0);
    let probability = vec![
        Series::line(words("study-mean"), weldable(|p| p.weldable.estimate)),
        dashed(weldable(|p| p.weldable.low), "study-interval"),
        dashed(weldable(|p| p.weldable.high), "study-interval"),
    ];
    let mut blocks = vec![Block::Page(sweep.quantity.clone())];
    let caption = format!("{}; {}", words("study-probability"), words("study-interval"));
    blocks.push(chart(words("study-weldable"), Axis::new(words("study-weldable"), "%"), probability, caption));
    for figure in &study.figures {
        let of = |part: fn(&super::summary::SweepFigure) -> f64| {
            let at = |point: &super::summary::SweepPoint| {
                let found = point.figures.iter().find(|found| found.name == figure.name)?;
                Some((point.value, part(found)))
            };
            sweep.points.iter().filter_map(at).collect::<Vec<_>>()
        };
        let mean = of(|f| f.mean);
        let (low, high) = mean.iter().fold((f64::MAX, f64::MIN), |(low, high), (_, y)| (low.min(*y), high.max(*y)));
        if high - low > NOISE * high.abs() {
            let series = vec![
                Series::line(words("study-mean"), mean),
                dashed(of(|f| f.p05), "study-p05"),
                dashed(of(|f| f.p95), "study-p95"),
            ];
            blocks.push(chart(label(study, figure), axis(study, figure), series, words("study-sweep-caption")));
        }
    }
    blocks
}
