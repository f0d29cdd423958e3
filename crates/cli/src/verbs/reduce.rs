//! Taught points to lines and arcs whose ends are points (EBW-2004).

pub(super) mod plot;

use super::positive;
use crate::args::reduce::{MethodArg, ReduceArgs};
use crate::refusals::{in_file, unreadable};
use crate::rows::{Cell, Rows, print_json};
use glam::DVec3;
use seamwright_geometry::reduce::{MAX_COORDINATE_MM, Method, Reduction, Shape, Span, Tolerances, reduce};
use seamwright_message::{Message, Unit};
use seamwright_project::csv::CsvReader;
use seamwright_project::failure::Failure;
use seamwright_project::files;
use seamwright_report::format_number;
use serde_json::{Value, json};
use std::fs::File;
use std::io::{self, BufRead, BufReader, Write as _};

const PLACE: [&str; 3] = ["x_mm", "y_mm", "z_mm"];

const COLUMNS: [&str; 11] =
    ["kind", "first", "last", "cx_mm", "cy_mm", "cz_mm", "radius_mm", "nx", "ny", "nz", "max_error_mm"];

pub(crate) fn run(args: &ReduceArgs) -> Result<(), Failure> {
    let tolerance = positive("--tolerance-mm", args.tolerance_mm)?;
    let axis_tolerance = positive("--axis-tolerance", args.axis_tolerance.unwrap_or(tolerance))?;
    let source = args.points.display().to_string();
    let input: Box<dyn BufRead> = match source.as_str() {
        "-" => Box::new(io::stdin().lock()),
        _ => Box::new(BufReader::new(File::open(&args.points).map_err(|e| unreadable(&source, &e))?)),
    };
    let (points, axes) = read(&source, input)?;
    let method = match args.method {
        MethodArg::Greedy => Method::Greedy,
        MethodArg::Fewest => Method::Fewest,
    };
    let tolerances = Tolerances { path_mm: tolerance, columns: axis_tolerance };
    let reduction = reduce(&points, &axes, tolerances, method).map_err(|e| Failure::input(in_file(&source, &e)))?;
    if let Some(path) = &args.svg {
        files::write(path, &plot::draw(&points, &reduction.spans))?;
    }
    if args.json { print(points.len(), &reduction) } else { rows(points.len(), &reduction) }
}

/// Points, and the further columns.
fn read(source: &str, input: impl BufRead) -> Result<(Vec<DVec3>, Vec<Vec<f64>>), Failure> {
    let (mut reader, others) = CsvReader::open_with_others(source, input, &PLACE)?;
    let (mut points, mut axes) = (Vec::new(), vec![Vec::new(); others.len()]);
    while let Some(row) = reader.row() {
        let row = row.map_err(|failure| cured(failure, "cli-cure-line-or-column"))?;
        let point = DVec3::new(row[0], row[1], row[2]);
        axes.iter_mut().zip(&row[3..]).for_each(|(column, value)| column.push(*value));
        let far = |(_, value): &(&str, f64)| value.abs() > MAX_COORDINATE_MM;
        if let Some((name, value)) = PLACE.into_iter().zip(point.to_array()).find(far) {
            let allowed = format!("-{MAX_COORDINATE_MM:e} to {MAX_COORDINATE_MM:e}");
            let error = reader.error(name, &value.to_string(), Message::new("cli-too-far-away"), allowed);
            return Err(cured(error, "cli-cure-line-in-mm"));
        }
        points.push(point);
    }
    if points.len() < 2 {
        let found = Message::new("cli-points-found").count("points", points.len());
        let error = Failure::refused(in_file(source, found), Message::new("cli-at-least-two"));
        return Err(cured(error, "cli-cure-line-per-point"));
    }
    Ok((points, axes))
}

fn cured(failure: Failure, cure: &'static str) -> Failure {
    match failure {
        Failure::Input(message) => {
            let cure = Message::new("project-cure").message("cure", Message::new(cure));
            Failure::Input(Message::new("cli-with-cure").message("failure", message).message("cure", cure))
        }
        other => other,
    }
}

fn greatest(spans: &[Span]) -> f64 {
    spans.iter().map(|s| s.max_error).fold(0.0, f64::max)
}

fn is_line(span: &&Span) -> bool {
    span.shape == Shape::Line
}

/// A row a span; a summary to standard error.
fn rows(points: usize, reduction: &Reduction) -> Result<(), Failure> {
    let mut rows = Rows::new(COLUMNS.map(str::to_owned).into(), false);
    for span in &reduction.spans {
        let mut cells = [Cell::Empty; 11];
        cells[0] = Cell::Text("line");
        cells[1] = Cell::Count(span.first as u64);
        cells[2] = Cell::Count(span.last as u64);
        if let Shape::Arc { centre, radius, normal } = span.shape {
            cells[0] = Cell::Text("arc");
            let numbers = [centre.x, centre.y, centre.z, radius, normal.x, normal.y, normal.z];
            cells[3..10].copy_from_slice(&numbers.map(Cell::Number));
        }
        cells[10] = Cell::Number(span.max_error);
        rows.row(&cells)?;
    }
    rows.finish()?;
    let spans = &reduction.spans;
    let lines = spans.iter().filter(is_line).count();
    let summary = Message::new("cli-reduced").count("points", points).number("lines", lines as f64, 0);
    let summary = summary.number("arcs", (spans.len() - lines) as f64, 0).number("min", reduction.at_least as f64, 0);
    let error = format_number(greatest(spans), 4).parse().unwrap_or_default();
    // Errors are ignored: standard error may be closed.
    let _ = writeln!(io::stderr(), "{}", summary.value("error", error, Unit::Mm));
    Ok(())
}

fn print(points: usize, reduction: &Reduction) -> Result<(), Failure> {
    let spans = &reduction.spans;
    let listed = |span: &Span| -> Value {
        let (kind, arc) = match span.shape {
            Shape::Line => {
                ("line", [Value::Null, Value::Null, Value::Null, Value::Null, Value::Null, Value::Null, Value::Null])
            }
            Shape::Arc { centre: c, radius, normal: n } => {
                ("arc", [c.x, c.y, c.z, radius, n.x, n.y, n.z].map(|v| Value::from(v + 0.0)))
            }
        };
        let ends = [Value::from(kind), span.first.into(), span.last.into()];
        let cells = ends.into_iter().chain(arc).chain([span.max_error.into()]);
        COLUMNS.into_iter().map(str::to_owned).zip(cells).collect::<serde_json::Map<_, _>>().into()
    };
    print_json(&json!({
        "points": points,
        "lines": spans.iter().filter(is_line).count(),
        "arcs": spans.len() - spans.iter().filter(is_line).count(),
        "at_least": reduction.at_least,
        "greatest_error_mm": greatest(spans),
        "spans": spans.iter().map(listed).collect::<Vec<Value>>(),
    }))
}
