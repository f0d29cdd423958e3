use super::job_limits::{spark, threads, time_limit};
use crate::args::study::StudyArgs;
use crate::labels::{columns, padded};
use crate::progress::Progress;
use crate::refusals::{between, not_allowed};
use crate::rows::print_either;
use seamwright_message::Message;
use seamwright_project::failure::Failure;
use seamwright_report::format_number;
use seamwright_schedule::{FigureSummary, Overrides, Study, StudyRun, StudySummary};
use seamwright_study::MAX_DRAWS;
use std::path::PathBuf;

/// Significant digits of figures.
const DIGITS: usize = 4;

pub(crate) fn run(args: &StudyArgs) -> Result<(), Failure> {
    let (limit, threads) = (time_limit(&args.planning)?, threads(args.jobs)?);
    if let Some(draws) = args.draws.filter(|draws| !(1..=MAX_DRAWS).contains(draws)) {
        return Err(not_allowed("--draws", draws, between(1.0, MAX_DRAWS as f64)));
    }
    let spark = spark(&args.cluster)?;
    let study = Study::open(&args.study, Overrides { draws: args.draws, seed: args.seed })?;
    let run = StudyRun { study: &study, output: &args.output, threads, spark: spark.as_ref(), limit, cancel: None };
    let bar = Progress::with_rate("cli-progress-draws", run.plans());
    let (summary, files) = run.run(&|progress| bar.at(progress.done))?;
    drop(bar);
    print_either(args.json, &summary, || text(&summary, &files))?;
    if summary.weldable.estimate > 0.0 { Ok(()) } else { Err(Failure::Printed) }
}

fn text(summary: &StudySummary, files: &[PathBuf]) -> String {
    let done = Message::new("cli-study-done").number("draws", summary.draws as f64, 0).text("job", &summary.job);
    let done = done.text("machine", &summary.machine).number("kept", summary.kept as f64, 0);
    let percent = |value: f64| format_number(100.0 * value, 3);
    let weldable = summary.weldable;
    let weldable = Message::new("cli-study-weldable")
        .text("percent", percent(weldable.estimate))
        .text("low", percent(weldable.low))
        .text("high", percent(weldable.high));
    let mut lines = vec![done.to_string(), weldable.to_string()];
    if summary.nominal.status != "weldable" {
        lines.push(Message::new("study-nominal-blocked").to_string());
    }
    if let Some(error) = &summary.first_error {
        lines.push(Message::new("cli-study-first-error").text("error", error).to_string());
    }
    lines.push(String::new());
    lines.extend(figures(summary));
    if !summary.findings.is_empty() {
        lines.push(String::new());
        lines.extend(findings(summary));
    }
    lines.push(String::new());
    lines.extend(files.iter().map(|file| file.display().to_string()));
    lines.join("\n") + "\n"
}

fn words(codes: &[&'static str]) -> Vec<String> {
    codes.iter().map(|code| Message::new(code).to_string()).collect()
}

fn figures(summary: &StudySummary) -> Vec<String> {
    let head = [&["study-figure", "study-nominal"], &FigureSummary::STATISTICS[..], &["study-cause"]].concat();
    let number = |value: f64| format_number(value, DIGITS);
    let row = |figure: &FigureSummary| {
        let mut cells = vec![figure.name.clone(), figure.nominal.map_or(String::new(), number)];
        cells.extend(figure.statistics().map(number));
        cells.push(main_cause(figure));
        cells
    };
    table(std::iter::once(words(&head)).chain(summary.figures.iter().map(row)).collect())
}

/// The quantity that explains the most of the variance.
fn main_cause(figure: &FigureSummary) -> String {
    let most = figure.indices.iter().max_by(|a, b| a.index.estimate.total_cmp(&b.index.estimate));
    let shown = most.filter(|most| most.index.low > 0.0);
    shown.map_or(String::new(), |most| format!("{} {} %", most.quantity, format_number(100.0 * most.index.estimate, 2)))
}

fn findings(summary: &StudySummary) -> Vec<String> {
    let percent = |value: f64| format_number(100.0 * value, 3);
    let row = |finding: &seamwright_schedule::FindingSummary| {
        let probability = finding.probability;
        let interval = format!("{} – {}", percent(probability.low), percent(probability.high));
        vec![finding.code.clone(), finding.draws.to_string(), percent(probability.estimate), interval]
    };
    let head = words(&["study-code", "study-draws", "study-probability", "study-interval"]);
    table(std::iter::once(head).chain(summary.findings.iter().map(row)).collect())
}

/// Lines with the cells of each column below each other.
fn table(rows: Vec<Vec<String>>) -> Vec<String> {
    let count = rows.first().map_or(0, Vec::len);
    let width = |i: usize| rows.iter().map(|row| columns(&row[i])).max().unwrap_or(0) + 2;
    let widths: Vec<usize> = (0..count).map(width).collect();
    let line = |row: Vec<String>| row.iter().zip(&widths).map(|(cell, width)| padded(cell, *width)).collect::<String>();
    rows.into_iter().map(|row| line(row).trim_end().to_owned()).collect()
}
