//! A program taken apart for editing: every pass, span, point and event knows where in the document it came from, so that
//! its comments, layout and expressions go with it.

use crate::pass::Pass;
use crate::points::{Along, Columns, PointEvent, PointSpan, Points};
use crate::program::Program;
use crate::span::Span;
use glam::DVec3;
use seamwright_document::{Direction, Document, DocumentError, Finite, Point};
use seamwright_message::{Message, Unit};

/// Largest coordinate of a point, mm.
const FARTHEST_MM: f64 = 1e7;

/// A program being edited.
#[derive(Debug)]
pub(super) struct Draft<'a> {
    /// The program as it was.
    pub(super) file: &'a Document<Program>,
    /// The program without its passes.
    pub(super) head: Program,
    pub(super) passes: Vec<PassDraft>,
    /// True if numbers change that this edit does not touch: variables.
    pub(super) is_recomputed: bool,
}

/// A pass with its original index among the document's passes.
#[derive(Debug, Clone)]
pub(super) struct PassDraft {
    /// Without points and spans.
    pub(super) pass: Pass,
    pub(super) body: Body,
    pub(super) from: Option<usize>,
}

#[derive(Debug, Clone)]
pub(super) enum Body {
    Seam(Vec<SeamSpan>),
    Points(Box<PointsDraft>),
}

#[derive(Debug, Clone)]
pub(super) struct SeamSpan {
    pub(super) span: Span,
    pub(super) from: Option<usize>,
}

#[derive(Debug, Clone)]
pub(super) struct PointsDraft {
    pub(super) columns: Vec<String>,
    pub(super) arc: bool,
    pub(super) stepped: Vec<String>,
    pub(super) start: Row,
    pub(super) spans: Vec<RowSpan>,
    pub(super) events: Vec<EventDraft>,
}

/// A point: a number a column. `from` counts the points of the pass it came from, 0 the start.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Row {
    pub(super) numbers: Vec<f64>,
    /// Of a cubic: the speeds at which it is reached.
    pub(super) speeds: Vec<f64>,
    pub(super) from: Option<usize>,
}

/// A run of points.
#[derive(Debug, Clone)]
pub(super) struct RowSpan {
    pub(super) along: Along,
    pub(super) stops: bool,
    pub(super) via: Option<DVec3>,
    pub(super) normal: Option<Direction>,
    /// Of a cubic: the speeds at its start.
    pub(super) begin_speeds: Vec<f64>,
    pub(super) rows: Vec<Row>,
    pub(super) from: Option<usize>,
}

/// Range of points of a pass, both ends included; point 0 is the start.
#[derive(Debug, Clone, Copy)]
pub(super) struct PointRange {
    pub(super) from: usize,
    pub(super) to: usize,
}

#[derive(Debug, Clone)]
pub(super) struct EventDraft {
    pub(super) event: PointEvent,
    pub(super) from: Option<usize>,
}

/// Allowed numbers of passes, spans, points or events.
pub(super) fn from_to(min: usize, max: usize) -> Message {
    Message::new("document-between").number("min", min as f64, 0).number("max", max as f64, 0)
}

/// The fault of an edit of points in a pass, counted from 1, that runs along the seam.
pub(super) fn along_seam(pass: usize) -> Message {
    Message::new("program-pass-along-seam").pass("pass", pass)
}

/// The fault of an edit along the seam in a pass, counted from 1, through points.
pub(super) fn through_points(pass: usize) -> Message {
    Message::new("program-pass-has-points").pass("pass", pass)
}

fn plain(numbers: &[Finite]) -> Vec<f64> {
    numbers.iter().map(|n| n.get()).collect()
}

fn finite(numbers: &[f64]) -> Option<Vec<Finite>> {
    numbers.iter().map(|n| Finite::new(*n)).collect()
}

impl<'a> Draft<'a> {
    pub(super) fn new(file: &'a Document<Program>) -> Self {
        let passes = file.value.passes.iter().enumerate().map(|(i, pass)| PassDraft::new(pass, Some(i)));
        Self {
            file,
            head: Program { passes: Vec::new(), ..file.value.clone() },
            passes: passes.collect(),
            is_recomputed: false,
        }
    }

    /// The program as it is to be.
    pub(super) fn program(&self) -> Result<Program, DocumentError> {
        let passes = self.passes.iter().map(PassDraft::pass).collect::<Option<Vec<Pass>>>().ok_or_else(|| {
            let allowed = Message::new("program-positions-within").value("max", FARTHEST_MM, Unit::Mm);
            self.wrong(Message::new("program-number-not-finite"), allowed)
        })?;
        Ok(Program { passes, ..self.head.clone() })
    }

    /// An error at the passes.
    pub(super) fn wrong(&self, message: impl Into<Message>, allowed: impl Into<Message>) -> DocumentError {
        self.file.error_at("passes", message, allowed)
    }

    /// An error at a pass, counted from 1.
    pub(super) fn wrong_in(
        &self,
        pass: usize,
        message: impl Into<Message>,
        allowed: impl Into<Message>,
    ) -> DocumentError {
        self.file.error_at(&format!("passes[{}]", pass.saturating_sub(1)), message, allowed)
    }

    /// The index of a pass counted from 1.
    pub(super) fn index(&self, pass: usize) -> Result<usize, DocumentError> {
        let count = self.passes.len();
        if (1..=count).contains(&pass) {
            return Ok(pass - 1);
        }
        Err(self.wrong(Message::new("program-no-pass").pass("pass", pass), from_to(1, count)))
    }

    /// The passes meant, from 1: one, or all of them.
    pub(super) fn numbers(&self, pass: Option<usize>) -> Result<Vec<usize>, DocumentError> {
        match pass {
            Some(pass) => self.index(pass).map(|i| vec![i + 1]),
            None => Ok((1..=self.passes.len()).collect()),
        }
    }

    /// A pass counted from 1.
    pub(super) fn pass(&mut self, pass: usize) -> Result<&mut PassDraft, DocumentError> {
        let i = self.index(pass)?;
        Ok(&mut self.passes[i])
    }

    /// The points of a pass counted from 1.
    pub(super) fn points(&mut self, pass: usize) -> Result<&mut PointsDraft, DocumentError> {
        let i = self.index(pass)?;
        let error = self.wrong_in(pass, along_seam(pass), Message::new("program-pass-through-points"));
        match &mut self.passes[i].body {
            Body::Points(points) => Ok(points),
            Body::Seam(_) => Err(error),
        }
    }

    /// A range of points within a pass, `least` or later; all of them if no range is given.
    pub(super) fn range(
        &mut self,
        pass: usize,
        points: Option<[usize; 2]>,
        least: usize,
    ) -> Result<PointRange, DocumentError> {
        let count = self.points(pass)?.count();
        let [from, to] = points.unwrap_or([least, count]);
        if least <= from && from <= to && to <= count {
            return Ok(PointRange { from, to });
        }
        let message = Message::new("program-no-points").number("from", from as f64, 0).number("to", to as f64, 0);
        let allowed = Message::new("program-range-in-order").number("min", least as f64, 0);
        Err(self.wrong_in(pass, message, allowed.number("max", count as f64, 0)))
    }
}

impl PassDraft {
    pub(super) fn new(pass: &Pass, from: Option<usize>) -> Self {
        let spans = pass.spans.iter().enumerate();
        let body = match &pass.points {
            Some(points) => Body::Points(Box::new(PointsDraft::new(points))),
            None => Body::Seam(spans.map(|(i, span)| SeamSpan { span: span.clone(), from: Some(i) }).collect()),
        };
        Self { pass: Pass { points: None, spans: Vec::new(), ..pass.clone() }, body, from }
    }

    /// The pass; `None` if a number is not finite.
    pub(super) fn pass(&self) -> Option<Pass> {
        let mut pass = self.pass.clone();
        match &self.body {
            Body::Seam(spans) => pass.spans = spans.iter().map(|span| span.span.clone()).collect(),
            Body::Points(points) => pass.points = Some(points.points()?),
        }
        Some(pass)
    }
}

impl PointsDraft {
    fn new(points: &Points) -> Self {
        let mut next = 0;
        let mut row = |numbers: &Vec<Finite>| {
            next += 1;
            Row { numbers: plain(numbers), speeds: Vec::new(), from: Some(next - 1) }
        };
        let start = row(&points.start);
        let spans = points.spans.iter().enumerate().map(|(i, span)| {
            let mut new = RowSpan {
                along: span.along,
                stops: span.stops,
                via: span.via_mm.map(Point::get),
                normal: span.normal,
                begin_speeds: Vec::new(),
                rows: span.points.iter().map(&mut row).collect(),
                from: Some(i),
            };
            new.set_speeds(span.speeds.iter().map(|speeds| plain(speeds)).collect());
            new
        });
        let spans = spans.collect();
        let events = points.events.iter().enumerate();
        Self {
            columns: points.columns.clone(),
            arc: points.arc,
            stepped: points.stepped.clone(),
            start,
            spans,
            events: events.map(|(i, event)| EventDraft { event: event.clone(), from: Some(i) }).collect(),
        }
    }

    fn points(&self) -> Option<Points> {
        let spans = self.spans.iter().map(|span| {
            Some(PointSpan {
                points: span.rows.iter().map(|row| finite(&row.numbers)).collect::<Option<_>>()?,
                ..span.head()?
            })
        });
        Some(Points { start: finite(&self.start.numbers)?, spans: spans.collect::<Option<_>>()?, ..self.head() })
    }

    /// Without points.
    pub(super) fn head(&self) -> Points {
        Points {
            columns: self.columns.clone(),
            arc: self.arc,
            stepped: self.stepped.clone(),
            start: Vec::new(),
            events: self.events.iter().map(|event| event.event.clone()).collect(),
            spans: Vec::new(),
        }
    }

    /// Number of points after the start.
    pub(super) fn count(&self) -> usize {
        self.spans.iter().map(|span| span.rows.len()).sum()
    }

    /// All points, the start first.
    pub(super) fn rows(&self) -> impl Iterator<Item = &Row> {
        std::iter::once(&self.start).chain(self.spans.iter().flat_map(|span| &span.rows))
    }

    pub(super) fn rows_mut(&mut self) -> impl Iterator<Item = &mut Row> {
        std::iter::once(&mut self.start).chain(self.spans.iter_mut().flat_map(|span| &mut span.rows))
    }

    /// The span of a point after the start, and its index in it. The point must exist.
    pub(super) fn place(&self, point: usize) -> (usize, usize) {
        let mut left = point.saturating_sub(1);
        for (i, span) in self.spans.iter().enumerate() {
            if left < span.rows.len() {
                return (i, left);
            }
            left -= span.rows.len();
        }
        (self.spans.len(), left)
    }

    pub(super) fn known(&self) -> Columns {
        self.head().known_columns()
    }

    pub(super) fn column(&self, name: &str) -> Option<usize> {
        self.columns.iter().position(|c| c == name)
    }

    /// Columns of the positions between which there are lines and arcs: the tip's, or those of axes x, y and z.
    pub(super) fn places(&self) -> Option<[usize; 3]> {
        let names = if self.known().pose > 0 { ["x_mm", "y_mm", "z_mm"] } else { ["x", "y", "z"] };
        let [x, y, z] = names.map(|name| self.column(name));
        Some([x?, y?, z?])
    }

    /// Columns whose numbers are of the way to a point and not of the point: time or speed, block number, stepped values.
    pub(super) fn way_columns(&self) -> Vec<usize> {
        let mut columns: Vec<usize> = self.stepped.iter().filter_map(|name| self.column(name)).collect();
        columns.extend(self.column(crate::points::NUMBER_COLUMN));
        columns.push(self.columns.len() - 1);
        columns
    }

    pub(super) fn timed(&self) -> bool {
        self.columns.last().is_some_and(|name| name == crate::points::TIME_COLUMN)
    }
}

impl RowSpan {
    /// Without points.
    pub(super) fn head(&self) -> Option<PointSpan> {
        let via_mm = match self.via {
            Some(via) => Some(Point::new(via)?),
            None => None,
        };
        let speeds = self.all_speeds().iter().map(|speeds| finite(speeds)).collect::<Option<_>>()?;
        let (along, stops, normal) = (self.along, self.stops, self.normal);
        Some(PointSpan { along, stops, via_mm, normal, speeds, points: Vec::new() })
    }
}

impl Row {
    pub(super) fn new(numbers: Vec<f64>) -> Self {
        Self { numbers, speeds: Vec::new(), from: None }
    }

    /// Time or speed.
    pub(super) fn pace(&mut self) -> &mut f64 {
        let last = self.numbers.len() - 1;
        &mut self.numbers[last]
    }

    pub(super) fn place(&self, columns: [usize; 3]) -> DVec3 {
        DVec3::from_array(columns.map(|i| self.numbers[i]))
    }

    pub(super) fn set_place(&mut self, columns: [usize; 3], place: DVec3) {
        columns.into_iter().zip(place.to_array()).for_each(|(i, value)| self.numbers[i] = value);
    }
}
