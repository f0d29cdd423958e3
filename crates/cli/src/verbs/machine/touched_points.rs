//! Tables of touched points.

use crate::refusals::at_most;
use glam::DVec3;
use seamwright_machine::{Joints, Machine};
use seamwright_message::{Message, Unit};
use seamwright_project::failure::Failure;
use seamwright_project::files;
use std::io::Read;
use std::path::Path;

#[derive(Debug, Clone, PartialEq)]
pub(super) struct Touched {
    /// Line in the file, from 1.
    pub(super) line: usize,
    /// In the work frame, mm.
    pub(super) point: DVec3,
    /// Feature that was touched; empty if the file has no such column.
    pub(super) feature: String,
    /// Nominal position of the point, mm; zero if the method does not need it.
    pub(super) nominal: DVec3,
}

/// Inputs of a method beside the points.
pub(super) struct Wanted {
    /// Names in the column `feature`; empty if the column is not used.
    pub(super) features: &'static [&'static str],
    /// False if the first of the features is meant where the column is missing.
    pub(super) feature_needed: bool,
    /// The nominal points are needed.
    pub(super) nominal: bool,
}

const POINT: [&str; 3] = ["x_mm", "y_mm", "z_mm"];
const NOMINAL: [&str; 3] = ["nx_mm", "ny_mm", "nz_mm"];
/// Maximum number of points of one table.
const MAX_POINTS: usize = 10_000;
/// Farthest coordinate, mm, as in job files.
const FARTHEST_MM: f64 = 1e7;

/// Reads the table in the file `path`, or from standard input if that is `-`.
pub(super) fn read(path: &Path, machine: &Machine, wanted: &Wanted) -> Result<Vec<Touched>, Failure> {
    if path == Path::new("-") {
        let mut text = String::new();
        std::io::stdin().lock().read_to_string(&mut text)?;
        return parse(&Message::new("cli-standard-input").to_string(), &text, machine, wanted);
    }
    parse(&path.display().to_string(), &files::read(path)?, machine, wanted)
}

fn parse(file: &str, text: &str, machine: &Machine, wanted: &Wanted) -> Result<Vec<Touched>, Failure> {
    let mut lines = text.lines().enumerate().map(|(i, line)| (i + 1, fields(line)));
    let header = lines.next().map(|l| l.1).unwrap_or_default();
    let table = Table { file, header, machine, wanted };
    let places = table.places()?;
    let mut touched = Vec::new();
    for (line, fields) in lines.filter(|(_, fields)| fields.iter().any(|f| !f.is_empty())) {
        if touched.len() == MAX_POINTS {
            let allowed = at_most(MAX_POINTS as f64, Unit::One);
            return Err(table.wrong(line, Message::new("cli-too-many-points"), allowed));
        }
        touched.push(table.row(line, &fields, &places)?);
    }
    Ok(touched)
}

fn fields(line: &str) -> Vec<&str> {
    line.trim_start_matches('\u{feff}').split(',').map(|f| f.trim().trim_matches('"')).collect()
}

struct Table<'a> {
    file: &'a str,
    header: Vec<&'a str>,
    machine: &'a Machine,
    wanted: &'a Wanted,
}

/// Indices of the columns read, with their names.
struct Places<'a> {
    /// Of the point, or of the axes.
    point: Vec<(usize, &'a str)>,
    by_axes: bool,
    feature: Option<usize>,
    nominal: Vec<(usize, &'a str)>,
}

impl<'a> Table<'a> {
    fn wrong(&self, line: usize, fault: Message, allowed: impl Into<Message>) -> Failure {
        let message = Message::new("cli-at-line").text("file", self.file).text("line", line.to_string());
        Failure::refused(message.message("fault", fault), allowed)
    }

    fn column(&self, name: &str) -> Option<usize> {
        self.header.iter().position(|h| *h == name)
    }

    fn columns<'n>(&self, names: &[&'n str]) -> Result<Vec<(usize, &'n str)>, &'n str> {
        names.iter().map(|name| self.column(name).map(|c| (c, *name)).ok_or(*name)).collect()
    }

    fn places(&self) -> Result<Places<'a>, Failure> {
        let axes: Vec<&str> = self.machine.axes.iter().map(|a| a.name.as_str()).collect();
        let missing = |name: &str, allowed: Message| {
            let fault = Message::new("cli-no-column").key("column", name).text("header", self.header.join(","));
            self.wrong(1, fault, allowed)
        };
        let (point, by_axes) = match (self.columns(&POINT), self.columns(&axes)) {
            (Ok(point), _) => (point, false),
            (_, Ok(axes)) => (axes, true),
            (Err(name), _) => {
                let allowed = Message::new("cli-touched-header").text("columns", POINT.join(","));
                return Err(missing(name, allowed.text("axes", axes.join(","))));
            }
        };
        let feature = if self.wanted.features.is_empty() { None } else { self.column("feature") };
        if feature.is_none() && self.wanted.feature_needed {
            let allowed = Message::new("cli-touched-feature-column").text("features", self.wanted.features.join(", "));
            return Err(missing("feature", allowed));
        }
        let nominal = if self.wanted.nominal { self.columns(&NOMINAL) } else { Ok(Vec::new()) };
        let nominal = nominal.map_err(|name| {
            missing(name, Message::new("cli-touched-nominal-columns").text("columns", NOMINAL.join(",")))
        })?;
        Ok(Places { point, by_axes, feature, nominal })
    }

    fn row(&self, line: usize, fields: &[&str], places: &Places) -> Result<Touched, Failure> {
        let numbers = |columns: &[(usize, &str)]| -> Result<Vec<f64>, Failure> {
            columns.iter().map(|(column, name)| self.number(line, name, fields.get(*column).copied())).collect()
        };
        let point = numbers(&places.point)?;
        let point = if places.by_axes { self.tip(&point) } else { DVec3::from_slice(&point) };
        let nominal = numbers(&places.nominal)?;
        let feature = match places.feature {
            Some(column) => fields.get(column).copied().unwrap_or_default(),
            None => self.wanted.features.first().copied().unwrap_or_default(),
        };
        if !self.wanted.features.is_empty() && !self.wanted.features.contains(&feature) {
            let fault = Message::new("cli-touched-unknown-feature").text("feature", feature);
            return Err(self.wrong(line, fault, self.wanted.features.join(", ")));
        }
        let nominal = if nominal.is_empty() { DVec3::ZERO } else { DVec3::from_slice(&nominal) };
        Ok(Touched { line, point, feature: feature.to_owned(), nominal })
    }

    fn number(&self, line: usize, name: &str, field: Option<&str>) -> Result<f64, Failure> {
        let field = field.unwrap_or_default();
        let value = field.parse().ok().filter(|v: &f64| v.abs() <= FARTHEST_MM);
        value.ok_or_else(|| {
            let fault = Message::new("cli-touched-not-a-number").key("column", name).text("value", field);
            self.wrong(line, fault, Message::new("cli-finite-up-to").text("max", "1e7"))
        })
    }

    /// The torch tip in the work frame at axis positions as in files.
    fn tip(&self, values: &[f64]) -> DVec3 {
        let mut q = Joints::default();
        for ((q, axis), value) in q.iter_mut().zip(&self.machine.axes).zip(values) {
            *q = axis.from_file(*value);
        }
        self.machine.forward(&q).point
    }
}
