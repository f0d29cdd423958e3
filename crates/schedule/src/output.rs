//! Result files of a schedule: CSV and Parquet with a line for each row, the load of the machines, and the report.

use crate::columns::{Column, Kind, ResultFiles, Value};
use crate::job_text::Templates;
use crate::machine_load::{MachineLoad, Task, machine_load};
use crate::plan_row::{RowResult, Status};
use crate::run::{Schedule, Summary};
use crate::table::Row;
use seamwright_message::{Catalogue, Language, Message, Unit};
use seamwright_project::failure::Failure;
use seamwright_project::files;
use seamwright_report::{Block, Drawing as _, Gantt, GanttBar, GanttRow, Page, Table, Tile, Verdict, format_number};
use std::collections::BTreeMap;

/// Rows in the report; all are in the other files.
const MAX_ROWS: usize = 2000;
/// Decimals of numbers in the CSV file.
const DECIMALS: usize = 3;
/// Parts in the picture of the machines' load.
const MAX_PARTS: usize = 2000;

/// The result of a row.
pub(crate) type ResultOf<'a> = dyn Fn(&Row, &mut Templates) -> Result<RowResult, Failure> + 'a;

/// Sums over all rows and their counts.
#[derive(Debug, Default)]
struct Totals {
    parts: u64,
    passes: u64,
    total_s: f64,
    arc_s: f64,
    wire_kg: f64,
    gas_l: f64,
    energy_kj: f64,
    cost: f64,
    findings: BTreeMap<String, usize>,
}

/// Writes all files.
pub(crate) fn write(schedule: &Schedule, result_of: &ResultOf) -> Result<Summary, Failure> {
    let (mut summary, mut totals, mut tasks, mut shown) =
        (Summary::default(), Totals::default(), Vec::new(), Vec::new());
    let csv_path = schedule.output.join("schedule.csv");
    let parquet_path = schedule.output.join("schedule.parquet");
    let mut templates = Templates::default();
    let columns: Vec<Column> = COLUMNS.iter().map(|(name, kind)| Column::new(*name, *kind)).collect();
    let files = ResultFiles { name: "schedule", csv: &csv_path, parquet: &parquet_path, decimals: Some(DECIMALS) };
    files.write(columns, &mut |rows| {
        schedule.table.each(&mut |row| {
            let result = result_of(&row, &mut templates)?;
            let program = schedule.program(&row.name).filter(|_| result.status == Status::Weldable);
            rows.push(values(&row, &result, program))?;
            summary.rows += 1;
            summary.weldable += u64::from(result.status == Status::Weldable);
            totals.add(&row, &result);
            tasks.extend((0..row.count).map(|_| Task {
                name: row.name.clone(),
                setup_s: 60.0 * row.setup_min,
                times: result.times.clone(),
            }));
            if shown.len() < MAX_ROWS {
                shown.push((row, result));
            }
            Ok(true)
        })
    })?;
    let loads = machine_load(tasks);
    let load_path = schedule.output.join("machines.csv");
    files::write(&load_path, &load_table(&loads))?;
    let report_path = schedule.output.join("report.html");
    files::write(&report_path, &page(schedule, &summary, &totals, &shown, &loads).render())?;
    summary.files = vec![csv_path, parquet_path, load_path, report_path];
    Ok(summary)
}

impl Totals {
    fn add(&mut self, row: &Row, result: &RowResult) {
        for (code, n) in &result.findings {
            *self.findings.entry(code.clone()).or_default() += n;
        }
        if result.status != Status::Weldable {
            return;
        }
        let count = f64::from(row.count);
        self.parts += u64::from(row.count);
        self.passes += u64::from(row.count) * result.passes as u64;
        self.total_s += count * result.total_s;
        self.arc_s += count * result.arc_s;
        self.wire_kg += count * result.wire_kg.unwrap_or(0.0);
        self.gas_l += count * result.gas_l.unwrap_or(0.0);
        self.energy_kj += count * result.energy_kj.unwrap_or(0.0);
        self.cost += count * result.cost.unwrap_or(0.0);
    }
}

/// Columns of the result files.
const COLUMNS: [(&str, Kind); 20] = [
    ("row", Kind::Whole),
    ("name", Kind::Text),
    ("status", Kind::Text),
    ("machine", Kind::Text),
    ("template", Kind::Text),
    ("count", Kind::Whole),
    ("setup_min", Kind::Number),
    ("passes", Kind::Whole),
    ("length_mm", Kind::Number),
    ("total_s", Kind::Number),
    ("arc_s", Kind::Number),
    ("wire_kg", Kind::Number),
    ("gas_l", Kind::Number),
    ("energy_kj", Kind::Number),
    ("cost", Kind::Number),
    ("clearance_mm", Kind::Number),
    ("blocking", Kind::Whole),
    ("findings", Kind::Text),
    ("program", Kind::Text),
    ("error", Kind::Text),
];

/// Values in the order of [`COLUMNS`].
fn values(row: &Row, result: &RowResult, program: Option<String>) -> Vec<Value> {
    let planned = |value: f64| Value::Number((result.passes > 0).then_some(value));
    vec![
        Value::Whole(row.number as i64),
        Value::Text(row.name.clone()),
        Value::Text(result.status.word().to_owned()),
        Value::Text(result.machine.clone()),
        Value::Text(row.template.clone()),
        Value::Whole(i64::from(row.count)),
        Value::Number(Some(row.setup_min)),
        Value::Whole(result.passes as i64),
        planned(result.length_mm),
        planned(result.total_s),
        planned(result.arc_s),
        Value::Number(result.wire_kg),
        Value::Number(result.gas_l),
        Value::Number(result.energy_kj),
        Value::Number(result.cost),
        Value::Number(result.clearance_mm),
        Value::Whole(result.blocking as i64),
        Value::Text(findings_text(&result.findings)),
        Value::Text(program.unwrap_or_default()),
        Value::Text(result.error.clone().unwrap_or_default()),
    ]
}

pub(crate) fn findings_text(findings: &BTreeMap<String, usize>) -> String {
    findings.iter().map(|(code, n)| format!("{code} {n}")).collect::<Vec<_>>().join("; ")
}

fn load_table(loads: &[MachineLoad]) -> String {
    let mut text = "machine,part,setup_from_s,weld_from_s,end_s\n".to_owned();
    for load in loads {
        for part in &load.parts {
            text += &format!("{},{},{:.1},{:.1},{:.1}\n", load.machine, part.name, part.from_s, part.weld_s, part.to_s);
        }
    }
    text
}

/// Words of a code in the language of the process.
pub(crate) fn words(code: &'static str) -> String {
    Message::new(code).in_language(Language::of_process())
}

/// Significant digits of figures in the report.
const DIGITS: usize = 3;

fn hours(seconds: f64) -> String {
    format_number(seconds / 3600.0, DIGITS)
}

fn page(
    schedule: &Schedule,
    summary: &Summary,
    totals: &Totals,
    shown: &[(Row, RowResult)],
    loads: &[MachineLoad],
) -> Page {
    let language = Language::of_process();
    let tile = |code: &'static str, value: String, unit: Unit| Tile {
        label: words(code),
        value,
        unit: Catalogue::of(language).symbol(unit),
        ..Tile::default()
    };
    let end = loads.iter().map(|load| load.end_s).fold(0.0, f64::max);
    let counted = |code: &'static str, value: u64| tile(code, value.to_string(), Unit::One);
    let mut tiles = vec![
        counted("schedule-parts", totals.parts),
        counted("schedule-passes", totals.passes),
        tile("schedule-time", hours(totals.total_s), Unit::H),
        tile("schedule-arc-time", hours(totals.arc_s), Unit::H),
        tile("schedule-end", hours(end), Unit::H),
    ];
    // Without a figure in the jobs a sum is 0.
    let sums = [
        ("schedule-wire", totals.wire_kg, Unit::Kg),
        ("schedule-gas", totals.gas_l / 1000.0, Unit::M3),
        ("schedule-energy", totals.energy_kj / 3600.0, Unit::KiloWh),
    ];
    let known = sums.into_iter().filter(|(_, sum, _)| *sum > 0.0);
    tiles.extend(known.map(|(code, sum, unit)| tile(code, format_number(sum, DIGITS), unit)));
    let mut blocks = vec![Block::Tiles(tiles), Block::Heading(words("schedule-machines"))];
    let parts: usize = loads.iter().map(|load| load.parts.len()).sum();
    if parts <= MAX_PARTS && parts > 0 {
        let caption = words("schedule-load-caption");
        blocks.push(Block::Figure { svg: gantt(loads).to_svg(), caption });
    }
    blocks.push(Block::Table(load_of_machines(loads)));
    blocks.push(Block::Page(words("schedule-rows")));
    blocks.push(Block::Table(table_of_rows(shown)));
    if summary.rows as usize > shown.len() {
        blocks.push(Block::Paragraph(
            Message::new("schedule-more-rows")
                .number("rows", (summary.rows as usize - shown.len()) as f64, 0)
                .in_language(language),
        ));
    }
    if !totals.findings.is_empty() {
        blocks.push(Block::Heading(words("schedule-findings")));
        blocks.push(Block::Table(Table {
            caption: words("schedule-findings-caption"),
            head: vec![words("schedule-code"), words("schedule-number")],
            rows: totals.findings.iter().map(|(code, n)| vec![code.clone(), n.to_string()]).collect(),
            numeric: vec![false, true],
            sortable: true,
        }));
    }
    let verdict = Message::new("schedule-verdict").number("weldable", summary.weldable as f64, 0);
    let verdict = verdict.number("rows", summary.rows as f64, 0).in_language(language);
    Page {
        language,
        title: words("schedule-title"),
        subtitle: schedule.table.path().display().to_string(),
        meta: Vec::new(),
        verdict: Some(Verdict { ok: summary.weldable == summary.rows, text: verdict }),
        blocks,
    }
}

fn gantt(loads: &[MachineLoad]) -> Gantt {
    let bars = |load: &MachineLoad| {
        let bar = |part: &crate::machine_load::Occupation| GanttBar {
            name: part.name.clone(),
            from_h: part.from_s / 3600.0,
            begin_h: part.weld_s / 3600.0,
            to_h: part.to_s / 3600.0,
        };
        load.parts.iter().map(bar).collect()
    };
    let row = |load: &MachineLoad| GanttRow { name: load.machine.clone(), bars: bars(load) };
    Gantt { language: Language::of_process(), title: words("schedule-load"), rows: loads.iter().map(row).collect() }
}

fn load_of_machines(loads: &[MachineLoad]) -> Table {
    let row = |load: &MachineLoad| {
        let weld: f64 = load.parts.iter().map(|part| part.to_s - part.weld_s).sum();
        let setup: f64 = load.parts.iter().map(|part| part.weld_s - part.from_s).sum();
        vec![load.machine.clone(), load.parts.len().to_string(), hours(weld), hours(setup), hours(load.end_s)]
    };
    let head = ["schedule-machine", "schedule-parts", "schedule-weld-h", "schedule-setup-h", "schedule-end-h"];
    Table {
        caption: words("schedule-machines-caption"),
        head: head.map(words).to_vec(),
        rows: loads.iter().map(row).collect(),
        numeric: vec![false, true, true, true, true],
        sortable: true,
    }
}

fn table_of_rows(shown: &[(Row, RowResult)]) -> Table {
    let some = |value: Option<f64>| value.map_or(String::new(), |v| format_number(v, DIGITS));
    let row = |(row, result): &(Row, RowResult)| {
        let planned = |value: f64| (result.passes > 0).then_some(value);
        let why = result.error.clone().unwrap_or_else(|| findings_text(&result.findings));
        vec![
            row.number.to_string(),
            row.name.clone(),
            status_words(result.status),
            result.machine.clone(),
            row.count.to_string(),
            result.passes.to_string(),
            some(planned(result.total_s / 60.0)),
            some(planned(result.arc_s / 60.0)),
            some(result.wire_kg),
            some(result.clearance_mm),
            why,
        ]
    };
    let head = [
        "schedule-row",
        "schedule-name",
        "schedule-status",
        "schedule-machine",
        "schedule-parts",
        "schedule-passes",
        "schedule-time-min",
        "schedule-arc-min",
        "schedule-wire-kg",
        "schedule-clearance-mm",
        "schedule-findings",
    ];
    Table {
        caption: words("schedule-rows-caption"),
        head: head.map(words).to_vec(),
        rows: shown.iter().map(row).collect(),
        numeric: vec![true, false, false, false, true, true, true, true, true, true, false],
        sortable: true,
    }
}

pub(crate) fn status_words(status: Status) -> String {
    words(match status {
        Status::Weldable => "schedule-status-weldable",
        Status::NotWeldable => "schedule-status-not-weldable",
        Status::OutOfTime => "schedule-status-out-of-time",
        Status::Invalid => "schedule-status-invalid",
        Status::Failed => "schedule-status-failed",
    })
}
