use super::block::{Block, Shape};
use super::knots::{Knots, Timed};
use super::thinning::keep_points;
use super::{MachineAxes, Numbers, PointPath, Row};
use glam::DVec3;
use seamwright_document::{Direction, Document, DocumentError, Finite, NonNegative, Positive};
use seamwright_message::Message;
use seamwright_program::{
    Along, ArcThrough, Columns, Pass, PointSpan, Points, ProcessValue, Program, Span, SpanValue, tip_way,
};
use std::sync::Arc;

/// Way of the tip in rapid moves of poses, mm/s: the axes' limits bring it down.
const RAPID_MM_S: f64 = 100.0;
/// Minimum duration of a block, s; shorter ones are left out.
const SHORTEST_S: f64 = 1e-9;
/// Times of a spline's points are found anew by its pieces' lengths, at most so often ...
const ROUNDS: usize = 30;
/// ... until each piece takes as long as it should within this part.
const IN_TIME: f64 = 1e-4;

impl PointPath {
    /// The path of pass `number` (counted from 0) of `program`, which goes through points; `machine` gets the machine's
    /// axes if the points are axis positions.
    ///
    /// # Errors
    /// With the key's address: axes that the machine does not have, an arc through three points on a line, a pass
    /// without any motion.
    pub fn new(
        program: &Document<Program>,
        number: usize,
        points: &Points,
        machine: &dyn Fn() -> Result<Arc<dyn MachineAxes>, DocumentError>,
    ) -> Result<Self, DocumentError> {
        let path = format!("passes[{number}].points");
        let pass = &program.value.passes[number];
        let columns = points.known_columns();
        let (numbers, reader) = if columns.pose > 0 {
            (Numbers::Poses(program.value.copy_in_work(pass.copy)), Reader::poses(points, &columns))
        } else {
            let machine = machine()?;
            let reader = Reader::axes(program, &path, &columns, machine.as_ref())?;
            (Numbers::Axes(machine), reader)
        };
        let builder = Builder { program, path: &path, pass, columns: &columns, numbers: &numbers, reader: &reader };
        let mut timed = builder.blocks(points)?;
        let seconds: f64 = timed.iter().map(|t| t.seconds).sum();
        let way: f64 = timed.iter().map(|t| builder.way(&t.block)).sum();
        if seconds <= SHORTEST_S {
            let message = Message::new("weld-pass-without-motion");
            let allowed = Message::new("weld-allowed-point-elsewhere");
            return Err(program.error_at(&format!("{path}.spans"), message, allowed));
        }
        let pace = if way > 0.0 { way / seconds } else { 1.0 };
        let mut reached = vec![0.0; points.count() + 1];
        let (mut at, mut point) = (0.0, 0);
        for t in &mut timed {
            (t.block.from, t.block.to) = (at, at + pace * t.seconds);
            reached[point + 1..=t.point].fill(t.block.to);
            (at, point) = (t.block.to, t.point);
        }
        reached[point + 1..].fill(at);
        let spans = spans(points, &columns, &reached, pace);
        let blocks = timed.into_iter().map(|t| t.block).collect();
        Ok(Self { blocks, numbers, spans, reached })
    }
}

/// Turns the numbers of a point into a row.
struct Reader {
    /// Index of the row's numbers among the columns, and their factor.
    from: Vec<(usize, f64)>,
    /// Values of numbers without a column.
    rest: Row,
    /// Highest speed of each number where it is an axis.
    fastest: Option<Row>,
    /// Indices of x, y and z among the row's numbers.
    places: [Option<usize>; 3],
    /// Index in the row of each of `from`.
    to: Vec<usize>,
}

impl Reader {
    fn poses(points: &Points, columns: &Columns) -> Self {
        let at = |name: &str| points.columns.iter().position(|c| c == name).unwrap_or(0);
        let names = &seamwright_program::POSE_COLUMNS[..columns.pose];
        let mut rest = Row::default();
        rest[5] = -1.0;
        let mut order: Vec<(usize, usize)> = names.iter().enumerate().map(|(i, name)| (at(name), i)).collect();
        order.sort_unstable();
        Self {
            from: order.iter().map(|(column, _)| (*column, 1.0)).collect(),
            to: order.iter().map(|(_, to)| *to).collect(),
            rest,
            fastest: None,
            places: [0, 1, 2].map(Some),
        }
    }

    fn axes(
        program: &Document<Program>,
        path: &str,
        columns: &Columns,
        machine: &dyn MachineAxes,
    ) -> Result<Self, DocumentError> {
        let axes = machine.axes();
        let mut reader = Self {
            from: Vec::new(),
            to: Vec::new(),
            rest: std::array::from_fn(|i| axes.get(i).map_or(0.0, |a| a.home)),
            fastest: Some(std::array::from_fn(|i| axes.get(i).map_or(f64::INFINITY, |a| a.max_speed))),
            places: ["x", "y", "z"].map(|name| axes.iter().position(|a| a.name == name)),
        };
        for (name, column) in &columns.axes {
            let Some(i) = axes.iter().position(|a| &a.name == name) else {
                let names: Vec<&str> = axes.iter().map(|a| a.name.as_str()).collect();
                return Err(program.unknown_name(&format!("{path}.columns[{column}]"), name, &names));
            };
            reader.from.push((*column, if axes[i].rotary { 1f64.to_radians() } else { 1.0 }));
            reader.to.push(i);
        }
        Ok(reader)
    }

    fn row(&self, point: &[Finite]) -> Row {
        let mut row = self.rest;
        for ((column, factor), to) in self.from.iter().zip(&self.to) {
            row[*to] = factor * point[*column].get();
        }
        row
    }

    /// Speeds of the row's numbers from those of the position's columns.
    fn speeds(&self, speeds: &[Finite]) -> Row {
        let mut row = Row::default();
        for ((speed, (_, factor)), to) in speeds.iter().zip(&self.from).zip(&self.to) {
            row[*to] = factor * speed.get();
        }
        row
    }

    fn place(&self, row: &Row) -> DVec3 {
        DVec3::from_array(self.places.map(|i| i.map_or(0.0, |i| row[i])))
    }
}

struct Builder<'a> {
    program: &'a Document<Program>,
    path: &'a str,
    pass: &'a Pass,
    columns: &'a Columns,
    numbers: &'a Numbers,
    reader: &'a Reader,
}

impl Builder<'_> {
    fn blocks(&self, points: &Points) -> Result<Vec<Timed>, DocumentError> {
        let mut here = self.reader.row(&points.start);
        let mut done = 0;
        let mut blocks = Vec::new();
        for (i, span) in points.spans.iter().enumerate() {
            let rows: Vec<Row> = span.points.iter().map(|p| self.reader.row(p)).collect();
            let new = match span.along {
                Along::Rapid | Along::Line => self.lines(span, &here, &rows),
                Along::Arc => vec![self.arc(i, span, &here, &rows[0])?],
                Along::Spline | Along::Taught => self.spline(span, &here, &rows),
                Along::Cubic => self.cubics(span, &here, &rows),
            };
            blocks.extend(new.into_iter().map(|t| Timed { point: done + t.point, ..t }));
            done += rows.len();
            here = rows[rows.len() - 1];
        }
        blocks.retain(|t| t.seconds > SHORTEST_S);
        Ok(blocks)
    }

    fn lines(&self, span: &PointSpan, here: &Row, rows: &[Row]) -> Vec<Timed> {
        let starts = std::iter::once(here).chain(rows);
        starts.zip(rows).enumerate().map(|(k, (start, end))| self.timed(span, k, start, end, Shape::Line)).collect()
    }

    fn arc(&self, i: usize, span: &PointSpan, here: &Row, end: &Row) -> Result<Timed, DocumentError> {
        let [start, stop] = [here, end].map(|row| self.reader.place(row));
        let via = span.via_mm.map_or(start, seamwright_document::Point::get);
        let Some(arc) = ArcThrough::new(start, via, stop, span.normal.map(Direction::unit)) else {
            let at = format!("{}.spans[{i}].via_mm", self.path);
            let message = Message::new("weld-arc-points-in-line");
            return Err(self.program.error_at(&at, message, Message::new("weld-allowed-arc-points")));
        };
        Ok(self.timed(span, 0, here, end, Shape::Arc(arc, self.reader.places)))
    }

    /// The way to point `k` of a span.
    fn timed(&self, span: &PointSpan, k: usize, start: &Row, end: &Row, shape: Shape) -> Timed {
        let (from, to, stops) = (0.0, 0.0, span.stops);
        let block = Block { from, to, start: *start, end: *end, shape, stops, is_continued: false };
        let seconds = self.seconds(&block, &span.points[k], span.along);
        Timed { block, seconds, point: k + 1 }
    }

    /// Duration of the way to `point`, s.
    fn seconds(&self, block: &Block, point: &[Finite], along: Along) -> f64 {
        let last = point[point.len() - 1].get();
        match (along, &self.reader.fastest) {
            (Along::Rapid, Some(fastest)) => {
                let times = fastest.iter().zip(block.start.iter().zip(&block.end)).map(|(v, (a, b))| (b - a).abs() / v);
                times.fold(0.0, f64::max)
            }
            (Along::Rapid, None) => self.way(block) / RAPID_MM_S,
            _ if self.columns.timed => last,
            _ => self.way(block) / last,
        }
    }

    /// Length of the tip's way, mm.
    fn way(&self, block: &Block) -> f64 {
        tip_way(|f| self.numbers.pose(&block.at(f)).point)
    }

    /// Cubics in time with given speeds.
    fn cubics(&self, span: &PointSpan, here: &Row, rows: &[Row]) -> Vec<Timed> {
        let speeds: Vec<Row> = span.speeds.iter().map(|speeds| self.reader.speeds(speeds)).collect();
        let each = std::iter::once(here).chain(rows).zip(rows).zip(&span.points).enumerate();
        each.map(|(k, ((start, end), point))| {
            let seconds = point[point.len() - 1].get();
            let slopes = [speeds[k], speeds[k + 1]].map(|row| row.map(|speed| speed * seconds));
            self.timed(span, k, start, end, Shape::Cubic(Box::new(slopes)))
        })
        .collect()
    }

    /// The cubic spline through the points of a span, by time; of recorded ones through those that are needed.
    fn spline(&self, span: &PointSpan, here: &Row, rows: &[Row]) -> Vec<Timed> {
        let mut knots = self.knots(span, here, rows);
        let mut pieces = knots.pieces();
        if self.columns.timed {
            return pieces;
        }
        // The speed is given: a piece takes as much longer than its chords as it is longer.
        for _ in 0..ROUNDS {
            let ways: Vec<f64> = pieces.iter().map(|piece| self.way(&piece.block)).collect();
            if knots.retime(&ways) <= IN_TIME {
                break;
            }
            pieces = knots.pieces();
        }
        pieces
    }

    /// Knots of a span's spline, timed by its chords.
    fn knots(&self, span: &PointSpan, here: &Row, rows: &[Row]) -> Knots {
        let rows: Vec<Row> = std::iter::once(*here).chain(rows.iter().copied()).collect();
        let (mut at, mut ways) = (vec![0.0], vec![0.0]);
        for k in 0..span.points.len() {
            let chord = self.timed(span, k, &rows[k], &rows[k + 1], Shape::Line);
            at.push(at[k] + chord.seconds.max(SHORTEST_S));
            ways.push(ways[k] + self.way(&chord.block));
        }
        let points = match span.along {
            Along::Taught => keep_points(&at, &rows, &self.near()),
            _ => (0..rows.len()).collect(),
        };
        let chord = |gap: &[usize]| (at[gap[1]] - at[gap[0]], ways[gap[1]] - ways[gap[0]]);
        Knots {
            chords: points.windows(2).map(chord).collect(),
            rows: points.iter().map(|&i| rows[i]).collect(),
            at: points.iter().map(|&i| at[i]).collect(),
            stops: span.stops,
            points,
        }
    }

    /// Maximum deviation of numbers from a recorded point: half the pass' tolerance, rotary axes and directions as much
    /// at 100 mm.
    fn near(&self) -> Row {
        let half = 0.5 * self.pass.tolerance.path_mm.get();
        let linear = |i: usize| match &self.numbers {
            Numbers::Axes(machine) => machine.axes().get(i).is_none_or(|a| !a.rotary),
            Numbers::Poses(_) => i < 3,
        };
        std::array::from_fn(|i| if linear(i) { half } else { half / 100.0 })
    }
}

/// The pass' spans: process values from point to point. Points between which all values are constant are one span.
fn spans(points: &Points, columns: &Columns, reached: &[f64], pace: f64) -> Vec<Span> {
    let rows: Vec<&[Finite]> = points.rows().collect();
    let mut spans: Vec<Span> = Vec::new();
    for (i, ends) in rows.windows(2).enumerate() {
        let (Some(from), Some(to)) = (NonNegative::new(reached[i]), Positive::new(reached[i + 1])) else { continue };
        if to.get() <= from.get() {
            continue;
        }
        let process = points.process_between(columns, ends[0], ends[1]);
        match spans.last_mut() {
            Some(last) if last.process == process && !process.values().any(ProcessValue::is_ramp) => last.to_mm = to,
            _ => {
                let speed = Positive::new(pace).unwrap_or(Positive::HALF);
                spans.push(Span { from_mm: from, to_mm: to, speed_mm_s: SpanValue::Steady(speed), process });
            }
        }
    }
    spans
}
