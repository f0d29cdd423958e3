//! Speeds, process values and block numbers over ranges.

use super::draft::{Body, Draft, PointRange, PointsDraft, SeamSpan, along_seam, through_points};
use super::report::Report;
use crate::path_length::is_beyond;
use crate::points::NUMBER_COLUMN;
use crate::process::ProcessValue;
use crate::span_value::{Ramp, SpanValue};
use schemars::JsonSchema;
use seamwright_document::{DocumentError, Finite, NonNegative, Positive};
use seamwright_message::{Message, Unit};
use serde::{Deserialize, Serialize};

/// Makes the travel faster or slower: speeds times the factor, times divided by it. Rapids stay.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ScaleSpeed {
    /// The pass, from 1; all if missing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pass: Option<usize>,
    /// The first and last point, the ways to which are meant, of a pass through points; all if missing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub points: Option<[usize; 2]>,
    /// Path lengths from the start of a pass along the seam, mm; all of it if missing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub s_mm: Option<[NonNegative; 2]>,
    /// 2 is twice as fast.
    pub factor: Positive,
}

/// Sets a process value over a range: a number, or a ramp from its begin to its end. Through points a ramp goes by time
/// or, with speeds, by the distance of the points.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SetProcess {
    /// The pass, from 1.
    pub pass: usize,
    /// The first and last point of a pass through points; all if missing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub points: Option<[usize; 2]>,
    /// Path lengths from the start of a pass along the seam, mm; all of it if missing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub s_mm: Option<[NonNegative; 2]>,
    /// Name of the value; along the seam a new one is set over the whole pass.
    pub name: String,
    /// The value.
    pub value: ProcessValue,
}

/// Numbers the points after the start of a pass, or of all passes through points on and on, in column `n`, which is made
/// if it is missing.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Renumber {
    /// The pass, from 1; all if missing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pass: Option<usize>,
    /// Number of the first point.
    pub start: usize,
    /// From one number to the next.
    pub step: usize,
}

impl Draft<'_> {
    /// Indices of the spans of a pass along the seam that lie in a range of its path length, split where it ends.
    fn seam_range(
        &mut self,
        pass: usize,
        s_mm: Option<[NonNegative; 2]>,
    ) -> Result<std::ops::Range<usize>, DocumentError> {
        let length = self.pass(pass)?.pass().map_or(0.0, |pass| pass.length());
        let [from, to] = s_mm.map_or([0.0, length], |s| s.map(NonNegative::get));
        if !is_beyond(to, from) || is_beyond(to, length) {
            let message = Message::new("program-no-range").value("from", from, Unit::Mm).value("to", to, Unit::Mm);
            let allowed = Message::new("program-range-in-order").value("min", 0.0, Unit::Mm);
            return Err(self.wrong_in(pass, message, allowed.value("max", length, Unit::Mm)));
        }
        let there = self.pass(pass)?;
        for s in [from, to] {
            // At the end of a span there is no span to split.
            let _ = there.split(s);
        }
        let Body::Seam(spans) = &there.body else { return Ok(0..0) };
        let inside = |span: &SeamSpan| {
            let middle = 0.5 * (span.span.from_mm.get() + span.span.to_mm.get());
            from < middle && middle < to
        };
        let first = spans.iter().position(inside).unwrap_or(0);
        Ok(first..first + spans.iter().filter(|span| inside(span)).count())
    }

    /// Refuses a range of the other kind of pass.
    fn check_range(
        &mut self,
        pass: usize,
        points: Option<[usize; 2]>,
        s_mm: Option<[NonNegative; 2]>,
    ) -> Result<bool, DocumentError> {
        let through = matches!(self.pass(pass)?.body, Body::Points(_));
        if (through && s_mm.is_some()) || (!through && points.is_some()) {
            let (message, allowed) = if through {
                (through_points(pass), "program-range-of-points")
            } else {
                (along_seam(pass), "program-range-of-seam")
            };
            return Err(self.wrong_in(pass, message, Message::new(allowed)));
        }
        Ok(through)
    }
}

impl ScaleSpeed {
    pub(super) fn apply(&self, draft: &mut Draft) -> Result<Report, DocumentError> {
        if self.pass.is_none() && (self.points.is_some() || self.s_mm.is_some()) {
            let message = Message::new("program-range-without-pass");
            return Err(draft.wrong(message, Message::new("program-pass-with-range")));
        }
        let factor = self.factor.get();
        let mut report = Report::new(Message::new("program-edit-speed").value("factor", factor, Unit::One));
        for pass in draft.numbers(self.pass)? {
            if draft.check_range(pass, self.points, self.s_mm)? {
                let range = draft.range(pass, self.points, 1)?;
                let points = draft.points(pass)?;
                let timed = points.timed();
                points.scale_cubics(range, factor);
                for row in points.rows_mut().skip(range.from).take(range.to + 1 - range.from) {
                    let pace = row.pace();
                    *pace = if timed { *pace / factor } else { *pace * factor };
                }
                report = report.points(pass, range.from, range.to);
            } else {
                let range = draft.seam_range(pass, self.s_mm)?;
                report = report.spans(pass, range.start + 1, range.end);
                if !draft.scale_seam(pass, range, factor)? {
                    let message = Message::new("program-speed-not-positive");
                    return Err(draft.wrong_in(pass, message, Message::new("program-other-factor")));
                }
            }
        }
        Ok(report)
    }
}

impl Draft<'_> {
    /// Scales the speeds of spans along the seam; false if one would be invalid.
    fn scale_seam(&mut self, pass: usize, range: std::ops::Range<usize>, by: f64) -> Result<bool, DocumentError> {
        let Body::Seam(spans) = &mut self.pass(pass)?.body else { return Ok(false) };
        for span in &mut spans[range] {
            let scaled = |v: Positive| Positive::new(v.get() * by);
            let new = match span.span.speed_mm_s {
                SpanValue::Steady(v) => scaled(v).map(SpanValue::Steady),
                SpanValue::Ramp(Ramp { from, to }) => {
                    scaled(from).zip(scaled(to)).map(|(from, to)| SpanValue::Ramp(Ramp { from, to }))
                }
            };
            let Some(new) = new else { return Ok(false) };
            span.span.speed_mm_s = new;
        }
        Ok(true)
    }
}

impl SetProcess {
    pub(super) fn apply(&self, draft: &mut Draft) -> Result<Report, DocumentError> {
        let words = Message::new("program-edit-process").pass("pass", self.pass).key("name", &self.name);
        if draft.check_range(self.pass, self.points, self.s_mm)? {
            let range = draft.range(self.pass, self.points, 0)?;
            let known = draft.points(self.pass)?.known().process;
            let Some((_, column)) = known.iter().find(|(name, _)| *name == self.name) else {
                let names: Vec<&str> = known.iter().map(|(name, _)| name.as_str()).collect();
                let path = format!("passes[{}].points.columns", self.pass - 1);
                return Err(draft.file.unknown_name(&path, &self.name, &names));
            };
            draft.points(self.pass)?.set_process(range, *column, self.value);
            return Ok(Report::new(words).points(self.pass, range.from, range.to));
        }
        let range = draft.seam_range(self.pass, self.s_mm)?;
        let Body::Seam(spans) = &mut draft.pass(self.pass)?.body else { return Ok(Report::new(words)) };
        let spans = &mut spans[range.clone()];
        let ends = (spans[0].span.from_mm.get(), spans[spans.len() - 1].span.to_mm.get());
        for span in spans {
            let part = |s: f64| (s - ends.0) / (ends.1 - ends.0);
            let at = |s: f64| Finite::new(self.value.at(part(s))).unwrap_or_default();
            let (from, to) = (at(span.span.from_mm.get()), at(span.span.to_mm.get()));
            let value = if self.value.is_ramp() { SpanValue::Ramp(Ramp { from, to }) } else { self.value };
            span.span.process.insert(self.name.clone(), value);
        }
        Ok(Report::new(words).spans(self.pass, range.start + 1, range.end))
    }
}

impl PointsDraft {
    fn set_process(&mut self, range: PointRange, column: usize, value: ProcessValue) {
        let PointRange { from, to } = range;
        let lengths = self.lengths();
        let whole: f64 = lengths[from..to].iter().sum();
        let mut done = 0.0;
        for (i, row) in self.rows_mut().enumerate().skip(from).take(to + 1 - from) {
            if i > from {
                done += lengths[i - 1];
            }
            let part = if i == to && to > from { 1.0 } else { done / whole.max(f64::MIN_POSITIVE) };
            row.numbers[column] = value.at(part);
        }
    }

    /// Weight of each way in a ramp: its time, or the distance of its ends; all equal without times or positions.
    fn lengths(&self) -> Vec<f64> {
        let rows: Vec<_> = self.rows().collect();
        let each = rows.windows(2).map(|pair| match self.places() {
            _ if self.timed() => pair[1].numbers.last().copied().unwrap_or_default(),
            Some(columns) => (pair[1].place(columns) - pair[0].place(columns)).length(),
            None => 1.0,
        });
        let lengths: Vec<f64> = each.collect();
        if lengths.iter().sum::<f64>() > 0.0 { lengths } else { vec![1.0; lengths.len()] }
    }

    /// Makes the column of block numbers, if it is missing; its index.
    fn number_column(&mut self) -> usize {
        if let Some(column) = self.column(NUMBER_COLUMN) {
            return column;
        }
        let column = self.columns.len() - 1;
        self.columns.insert(column, NUMBER_COLUMN.to_owned());
        self.rows_mut().for_each(|row| row.numbers.insert(column, 0.0));
        column
    }
}

impl Renumber {
    pub(super) fn apply(&self, draft: &mut Draft) -> Result<Report, DocumentError> {
        let mut report = Report::new(Message::new("program-edit-numbered"));
        let mut next = self.start;
        for pass in draft.numbers(self.pass)? {
            if self.pass.is_none() && matches!(draft.pass(pass)?.body, Body::Seam(_)) {
                continue;
            }
            let points = draft.points(pass)?;
            let column = points.number_column();
            let count = points.count();
            for row in points.rows_mut().skip(1) {
                row.numbers[column] = next as f64;
                next = next.saturating_add(self.step);
            }
            report = report.points(pass, 1, count);
        }
        if report.touched.is_empty() {
            return Err(draft.wrong(Message::new("program-no-points-pass"), Message::new("program-with-points")));
        }
        Ok(report)
    }
}
