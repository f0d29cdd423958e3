use super::table::{Along, Row, Table};
use crate::args::ExportArg;
use seamwright_machine::Joints;
use seamwright_motion::fine::{CoarseSpline, Knot, Segment};
use seamwright_program::ArcTime;
use seamwright_project::failure::Failure;
use std::collections::VecDeque;

/// Coarse points at rest that lead a B-spline in and out: (2 - sqrt 3)^24 of a period's way, 2e-14, is left of the
/// motion's effect on them.
const REST: u32 = 24;

/// Joins coarse set-points by the spline and writes fine ones, or writes the data by which another control joins them.
pub(super) struct TwoLevel<'a> {
    table: Table<'a>,
    spline: CoarseSpline,
    /// Of the coarse set-points, s.
    period: f64,
    fine: f64,
    /// Fine periods in a coarse one.
    parts: u32,
    export: Option<ExportArg>,
    /// Set-points whose knots are yet to come.
    waiting: VecDeque<Along>,
    before: Option<(Along, Knot)>,
    last: Option<(Along, Joints)>,
    /// Index of the next knot; below 0 while leading in.
    next: i64,
}

impl<'a> TwoLevel<'a> {
    /// Writes to `table`; coarse set-points come `parts` periods of `fine` (s) apart.
    pub(super) fn new(table: Table<'a>, fine: f64, parts: u32, export: Option<ExportArg>) -> Self {
        let (waiting, before, last, period) = (VecDeque::new(), None, None, fine * f64::from(parts));
        Self { table, spline: CoarseSpline::new(period), period, fine, parts, export, waiting, before, last, next: 0 }
    }

    /// Takes the next coarse set-point.
    pub(super) fn point(&mut self, along: Along, q: &Joints) -> Result<(), Failure> {
        if self.last.is_none() && self.export == Some(ExportArg::Spline1) {
            self.next = -i64::from(REST);
            self.rest(along, q)?;
        }
        self.last = Some((along, *q));
        self.push(along, q)
    }

    /// Writes the remaining rows.
    pub(super) fn finish(mut self) -> Result<Table<'a>, Failure> {
        if let (Some((along, q)), Some(ExportArg::Spline1)) = (self.last, self.export) {
            self.rest(along, &q)?;
        }
        while let Some(knot) = self.spline.finish() {
            self.knot(&knot)?;
        }
        if let (Some((along, knot)), None) = (self.before, self.export) {
            self.table.row(&Row { t: self.time(self.next - 1, 0), along, q: knot.q, speeds: None, phase: None })?;
        }
        Ok(self.table)
    }

    /// At rest in `q`, the arc off.
    fn rest(&mut self, along: Along, q: &Joints) -> Result<(), Failure> {
        (0..REST).try_for_each(|_| self.push(Along { speed: 0.0, arc: None, ..along }, q))
    }

    fn push(&mut self, along: Along, q: &Joints) -> Result<(), Failure> {
        self.waiting.push_back(along);
        self.spline.push(q).map_or(Ok(()), |knot| self.knot(&knot))
    }

    fn knot(&mut self, knot: &Knot) -> Result<(), Failure> {
        let Some(along) = self.waiting.pop_front() else { return Ok(()) };
        let k = self.next;
        self.next += 1;
        let row = |q, speeds| Row { t: k as f64 * self.period, along, q, speeds, phase: None };
        match self.export {
            Some(ExportArg::Spline1) => self.table.row(&row(knot.control_point(self.period), None)),
            Some(ExportArg::Pvt) => self.table.row(&row(knot.q, Some(knot.v))),
            None => self.fine(along, knot, k),
        }
    }

    /// Fine set-points from the knot before to this one, without it.
    fn fine(&mut self, along: Along, knot: &Knot, k: i64) -> Result<(), Failure> {
        let Some((from, before)) = self.before.replace((along, *knot)) else { return Ok(()) };
        let segment = Segment::new(&before, knot, self.period);
        for j in 0..self.parts {
            let part = f64::from(j) / f64::from(self.parts);
            let along = between(&from, &along, self.period, part);
            let t = self.time(k - 1, j);
            self.table.row(&Row { t, along, q: segment.at(part).q, speeds: None, phase: None })?;
        }
        Ok(())
    }

    /// Of fine set-point `j` after knot `k`.
    fn time(&self, k: i64, j: u32) -> f64 {
        (k * i64::from(self.parts) + i64::from(j)) as f64 * self.fine
    }
}

/// Path length and speed at a part of the period: the cubic with those of both ends; at rest between two passes. The
/// arc has the state of the coarse point before, but its clock goes on.
fn between(from: &Along, to: &Along, period: f64, part: f64) -> Along {
    let later = |arc: ArcTime| ArcTime {
        since_on_s: arc.since_on_s + part * period,
        until_off_s: arc.until_off_s - part * period,
    };
    let from = &Along { arc: from.arc.map(later), ..*from };
    if from.pass != to.pass || !from.s.is_finite() {
        return *from;
    }
    let (way, v0, v1) = (to.s - from.s, from.speed * period, to.speed * period);
    let (c2, c3) = (3.0 * way - 2.0 * v0 - v1, v0 + v1 - 2.0 * way);
    let s = from.s + part * (v0 + part * (c2 + part * c3));
    Along { s, speed: (v0 + part * (2.0 * c2 + 3.0 * part * c3)) / period, ..*from }
}
