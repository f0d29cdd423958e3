//! Passes through points: a table of poses or axis positions with times and process values, as part programs and taught
//! programs have them.

use crate::process::{ProcessValues, check_process_name};
use crate::span_value::{Ramp, SpanValue};
use schemars::JsonSchema;
use seamwright_document::{Bound, Direction, Document, DocumentError, Finite, Point};
use seamwright_message::{Message, Unit, named_enum};
use serde::{Deserialize, Serialize};

/// The columns of a pose: torch tip in the seam's frame (that of `placement`), mm, and the direction in which wire or beam points.
pub const POSE_COLUMNS: [&str; 6] = ["x_mm", "y_mm", "z_mm", "ax", "ay", "az"];
/// Time from the point before, s.
pub const TIME_COLUMN: &str = "time_s";
/// Mean speed of the torch tip on the way from the point before, mm/s.
pub const SPEED_COLUMN: &str = "speed_mm_s";
/// Block number.
pub const NUMBER_COLUMN: &str = "n";

/// The points that a pass goes through.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Points {
    /// Meaning of the numbers of a point, in this order: `x_mm`, `y_mm`, `z_mm` (and `ax`, `ay`, `az`) of the torch in
    /// the seam's frame, or names of the machine's axes (mm or degrees; the others stay at home); names of process
    /// values; `n` for a block number; `time_s` or `speed_mm_s` from the point before.
    pub columns: Vec<String>,
    /// Whether arc or beam is on.
    #[serde(default = "yes", skip_serializing_if = "is_yes")]
    pub arc: bool,
    /// Process values that have a point's value all the way to it, and not only when they reach it.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub stepped: Vec<String>,
    /// Start of the pass; its time or speed is 0.
    pub start: Vec<Finite>,
    /// Outputs and messages on the way.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub events: Vec<PointEvent>,
    /// Runs of points reached in the same way, in order.
    pub spans: Vec<PointSpan>,
}

/// A run of points reached in the same way.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PointSpan {
    /// The way to each of its points.
    pub along: Along,
    /// Whether the torch stops at each of its points.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub stops: bool,
    /// The point that an arc goes through on its way, mm: tip, or axes x, y and z.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub via_mm: Option<Point>,
    /// Axis of a helix: the arc turns about it through the projections of its points, and goes along it evenly.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub normal: Option<Direction>,
    /// Speeds of a cubic at its begin and at each of its points: a number per s for each column that says the place.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub speeds: Vec<Vec<Finite>>,
    /// The points: a number for each column.
    pub points: Vec<Vec<Finite>>,
}

named_enum! {
    /// Path to a point from the one before.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
    #[serde(rename_all = "snake_case")]
    pub enum Along {
        /// Every axis as fast as it can, arriving together; times and speeds are 0.
        Rapid => "rapid",
        /// Straight.
        Line => "line",
        /// An arc through `via_mm` to the span's one point.
        Arc => "arc",
        /// A cubic spline through the points of the span, from the one before it.
        Spline => "spline",
        /// A cubic in time to each point, with the speeds given (PMAC's PVT).
        Cubic => "cubic",
        /// Points recorded by hand or by a camera: a spline that leaves out those within the tolerance of the pass.
        Taught => "taught",
    }
}

/// Something switched or reported when a point is reached. Exactly one of its keys beside `after`, but for `on`, which goes
/// with `output`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PointEvent {
    /// Points reached before: 0 at the start.
    #[serde(default)]
    pub after: usize,
    /// Shielding gas on or off.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub gas: Option<bool>,
    /// Wire feeder on or off.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub wire: Option<bool>,
    /// Number of a digital output, switched as `on` says.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub output: Option<u16>,
    /// Whether `output` is on.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub on: Option<bool>,
    /// Words for the operator.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub message: Option<String>,
    /// A code of the machine's own, by its name in the machine file.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub call: Option<String>,
}

/// Whether a column has a meaning of its own, the block number aside.
fn known(name: &str) -> bool {
    [TIME_COLUMN, SPEED_COLUMN].contains(&name) || POSE_COLUMNS.contains(&name)
}

fn yes() -> bool {
    true
}

fn is_yes(value: &bool) -> bool {
    *value
}

/// Meaning of the columns of points.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Columns {
    /// Number of columns that are tip coordinates: 0 (the points are axis positions), 3 or 6.
    pub pose: usize,
    /// Names of the axes with their columns, if the points are axis positions. Which names are axes only the machine
    /// knows: names without a unit.
    pub axes: Vec<(String, usize)>,
    /// Names of the process values with their columns.
    pub process: Vec<(String, usize)>,
    /// Column of the block number.
    pub number: Option<usize>,
    /// The last column is a time and not a speed.
    pub timed: bool,
}

impl Points {
    /// Number of points after the start.
    pub fn count(&self) -> usize {
        self.spans.iter().map(|span| span.points.len()).sum()
    }

    /// Process values on the way between two points next to each other: ramps, or steady where they do not change or
    /// are stepped.
    pub fn process_between(&self, columns: &Columns, before: &[Finite], after: &[Finite]) -> ProcessValues {
        let value = |(name, column): &(String, usize)| {
            let (from, to) = (before[*column], after[*column]);
            let steady = self.stepped.contains(name) || from == to;
            let value = if steady { SpanValue::Steady(to) } else { SpanValue::Ramp(Ramp { from, to }) };
            (name.clone(), value)
        };
        columns.process.iter().map(value).collect()
    }

    /// All points in order, the start first.
    pub fn rows(&self) -> impl Iterator<Item = &[Finite]> {
        std::iter::once(&self.start).chain(self.spans.iter().flat_map(|span| &span.points)).map(Vec::as_slice)
    }

    /// Meaning of its columns; they were checked when the program was read.
    pub fn known_columns(&self) -> Columns {
        let at = |name: &str| self.columns.iter().position(|c| c == name);
        let pose = POSE_COLUMNS.iter().take_while(|name| at(name).is_some()).count();
        let number = at(NUMBER_COLUMN);
        let others = self.columns.iter().enumerate().filter(|(i, name)| !known(name) && Some(*i) != number);
        let (process, axes) = others.map(|(i, name)| (name.clone(), i)).partition(|(name, _)| name.contains('_'));
        Columns { pose, axes, process, number, timed: at(TIME_COLUMN).is_some() }
    }

    /// Checks the points at `path` of a file: columns, and every point.
    ///
    /// # Errors
    /// The first thing wrong, with its address.
    pub fn check<T>(&self, file: &Document<T>, path: &str) -> Result<(), DocumentError> {
        self.check_columns(file, path)?;
        let columns = self.known_columns();
        self.check_row(file, &format!("{path}.start"), &self.start, &columns, None)?;
        if self.count() == 0 {
            let allowed = Message::new("program-at-least-one-point");
            return Err(file.error_at(&format!("{path}.spans"), Message::new("program-pass-without-points"), allowed));
        }
        for (i, span) in self.spans.iter().enumerate() {
            let at = |key: &str| format!("{path}.spans[{i}].{key}");
            self.check_span(file, &at, span, &columns)?;
            for (k, row) in span.points.iter().enumerate() {
                self.check_row(file, &at(&format!("points[{k}]")), row, &columns, Some(span.along))?;
            }
        }
        self.check_bounds(file, path)?;
        for (i, event) in self.events.iter().enumerate() {
            event.check(file, &format!("{path}.events[{i}]"), self.count())?;
        }
        Ok(())
    }

    /// Refuses numbers beyond the bound of their column's unit.
    fn check_bounds<T>(&self, file: &Document<T>, path: &str) -> Result<(), DocumentError> {
        for (i, name) in self.columns.iter().enumerate() {
            let Some(bound) = Bound::of_column(name) else { continue };
            let refused = |at: &str, row: &[Finite]| {
                let message = Message::new("program-value-out-of-bounds").key("column", name);
                let message = message.value("value", row[i].get(), Unit::One);
                Err(file.error_at(&format!("{at}[{i}]"), message, bound.allowed()))
            };
            if !bound.allows(self.start[i].get()) {
                return refused(&format!("{path}.start"), &self.start);
            }
            for (k, span) in self.spans.iter().enumerate() {
                if let Some(row) = span.points.iter().position(|row| !bound.allows(row[i].get())) {
                    return refused(&format!("{path}.spans[{k}].points[{row}]"), &span.points[row]);
                }
            }
        }
        Ok(())
    }

    fn check_columns<T>(&self, file: &Document<T>, path: &str) -> Result<(), DocumentError> {
        let at = |i: usize| format!("{path}.columns[{i}]");
        for (i, name) in self.columns.iter().enumerate() {
            if self.columns[..i].contains(name) {
                let message = Message::new("program-column-twice").key("column", name);
                return Err(file.error_at(&at(i), message, Message::new("program-each-column-once")));
            }
            if name.contains('_') && !known(name) {
                check_process_name(file, &at(i), name)?;
            }
        }
        for (i, name) in self.stepped.iter().enumerate() {
            let process: Vec<&str> =
                self.columns.iter().map(String::as_str).filter(|c| c.contains('_') && !known(c)).collect();
            if !process.contains(&name.as_str()) {
                return Err(file.unknown_name(&format!("{path}.stepped[{i}]"), name, &process));
            }
        }
        let has = |name: &&str| self.columns.iter().any(|c| c == name);
        let last = self.columns.last().map_or("", String::as_str);
        if has(&TIME_COLUMN) == has(&SPEED_COLUMN) || ![TIME_COLUMN, SPEED_COLUMN].contains(&last) {
            let message = Message::new("program-last-column");
            return Err(file.error_at(&format!("{path}.columns"), message, Message::new("program-time-or-speed-last")));
        }
        let columns = self.known_columns();
        let poses = POSE_COLUMNS.iter().filter(|name| has(name)).count();
        let complete = [0, 3, 6].contains(&poses) && poses == columns.pose;
        if !complete || (poses == 0) == columns.axes.is_empty() {
            let message = Message::new("program-columns-without-position");
            return Err(file.error_at(&format!("{path}.columns"), message, Message::new("program-position-columns")));
        }
        Ok(())
    }

    fn check_span<T>(
        &self,
        file: &Document<T>,
        at: &dyn Fn(&str) -> String,
        span: &PointSpan,
        columns: &Columns,
    ) -> Result<(), DocumentError> {
        if span.points.is_empty() {
            let message = Message::new("program-span-without-points");
            return Err(file.error_at(&at("points"), message, Message::new("program-at-least-one")));
        }
        self.check_speeds(file, at, span, columns)?;
        if span.along == Along::Arc {
            let has = |name: &str| columns.axes.iter().any(|(axis, _)| axis == name);
            if span.via_mm.is_none() || span.points.len() != 1 {
                let message = Message::new("program-arc-in-span");
                return Err(file.error_at(&at("along"), message, Message::new("program-one-arc-per-span")));
            }
            if columns.pose == 0 && ["x", "y", "z"].iter().filter(|name| has(name)).count() < 2 {
                let message = Message::new("program-arc-of-axes");
                return Err(file.error_at(&at("along"), message, "line, rapid, spline, cubic, taught"));
            }
        } else if span.via_mm.is_some() || span.normal.is_some() {
            let key = if span.via_mm.is_some() { "via_mm" } else { "normal" };
            let allowed = Message::new("program-arc-or-leave-out");
            return Err(file.error_at(&at(key), Message::new("program-only-arcs"), allowed));
        }
        Ok(())
    }

    fn check_speeds<T>(
        &self,
        file: &Document<T>,
        at: &dyn Fn(&str) -> String,
        span: &PointSpan,
        columns: &Columns,
    ) -> Result<(), DocumentError> {
        let places = columns.pose + columns.axes.len();
        let wanted = if span.along == Along::Cubic { span.points.len() + 1 } else { 0 };
        if span.speeds.len() != wanted {
            let message = Message::new("program-speed-rows").count("rows", span.speeds.len());
            return Err(file.error_at(&at("speeds"), message, Message::new("program-cubic-speeds")));
        }
        if wanted > 0 && !columns.timed {
            let message = Message::new("program-cubic-needs-times");
            return Err(file.error_at(&at("along"), message, Message::new("program-time-last")));
        }
        match span.speeds.iter().position(|row| row.len() != places) {
            Some(k) => {
                let message = Message::new("program-speeds-for-columns").count("speeds", span.speeds[k].len());
                let message = message.count("columns", places);
                Err(file.error_at(&at(&format!("speeds[{k}]")), message, Message::new("program-one-for-each")))
            }
            None => Ok(()),
        }
    }

    /// Checks a point; `along` is `None` for the start.
    fn check_row<T>(
        &self,
        file: &Document<T>,
        path: &str,
        row: &[Finite],
        columns: &Columns,
        along: Option<Along>,
    ) -> Result<(), DocumentError> {
        if row.len() != self.columns.len() {
            let (message, allowed) = numbers_for_columns(row.len(), &self.columns);
            return Err(file.error_at(path, message, allowed));
        }
        let wrong = |i: usize, allowed| {
            let message = Message::new("program-value-not-allowed").key("column", self.columns[i].as_str());
            let message = message.value("value", row[i].get(), Unit::One);
            Err(file.error_at(&format!("{path}[{i}]"), message, Message::new(allowed)))
        };
        let last = row.len() - 1;
        let pace = row[last].get();
        let stands = matches!(along, None | Some(Along::Rapid));
        if stands && pace != 0.0 {
            return wrong(last, "program-pace-zero");
        }
        if !stands && pace <= 0.0 {
            return wrong(last, "document-positive-number");
        }
        if let Some((_, i)) = columns.process.iter().find(|(_, i)| row[*i].get() < 0.0) {
            return wrong(*i, "document-non-negative-number");
        }
        if let Some(i) = columns.number.filter(|i| {
            let n = row[*i].get();
            n < 0.0 || n.fract() != 0.0 || n > 1e9
        }) {
            return wrong(i, "program-block-number");
        }
        if columns.pose == 6 && (3..6).all(|k| row[self.column(POSE_COLUMNS[k])].get().abs() < 1e-12) {
            return wrong(self.column("ax"), "program-direction-columns");
        }
        Ok(())
    }

    /// Index of a column that is there.
    fn column(&self, name: &str) -> usize {
        self.columns.iter().position(|c| c == name).unwrap_or(0)
    }
}

/// Fault and allowed values of a row of `found` numbers that are not one for each of `columns`.
pub(crate) fn numbers_for_columns(found: usize, columns: &[String]) -> (Message, Message) {
    let message = Message::new("program-numbers-for-columns").count("numbers", found).count("columns", columns.len());
    (message, Message::new("program-one-for-each-of").text("columns", columns.join(", ")))
}

impl PointEvent {
    fn check<T>(&self, file: &Document<T>, path: &str, points: usize) -> Result<(), DocumentError> {
        if self.after > points {
            let message = Message::new("program-event-after-end");
            let allowed = Message::new("program-start-to-last-point").number("max", points as f64, 0);
            return Err(file.error_at(&format!("{path}.after"), message, allowed));
        }
        let given = [
            self.gas.is_some(),
            self.wire.is_some(),
            self.output.is_some(),
            self.message.is_some(),
            self.call.is_some(),
        ];
        if given.iter().filter(|given| **given).count() != 1 || self.on.is_some() != self.output.is_some() {
            return Err(file.error_at(path, Message::new("program-event-several"), Message::new("program-event-keys")));
        }
        Ok(())
    }
}
