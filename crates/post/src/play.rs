//! A part program as its control plays it: where every channel is at every time, by the control's own rules.

use crate::part_program::{Arc, ChannelKind, Event, Level, Move, MoveRows, PartProgram, Path, What, Xyz};
use crate::polynomial::{Evenly, Polynomial};

/// Part of a played program with a uniform motion or rest.
#[derive(Debug, Clone)]
pub struct Segment {
    /// Time at its start, s; rapid moves take none.
    pub begin: f64,
    /// Duration, s.
    pub seconds: f64,
    /// Index of the step it belongs to.
    pub step: usize,
    /// Whether the arc is on.
    pub arc: bool,
    /// Level of interpolation; `None` at rest.
    pub level: Option<Level>,
    from: Vec<f64>,
    to: Vec<f64>,
    way: Way,
}

#[derive(Debug, Clone)]
enum Way {
    Even,
    Arc(Arc, Xyz),
    /// Cubics of the axes with these speeds per s at both ends.
    Cubic(Vec<f64>, Vec<f64>),
    /// Polynomials of the axes, evenly by their way.
    Curve(Vec<Polynomial>, Box<Evenly>),
}

impl Segment {
    /// All channels at the part `f` of the segment, into `row`.
    pub fn at(&self, f: f64, row: &mut Vec<f64>) {
        row.clear();
        row.extend(self.from.iter().zip(&self.to).map(|(a, b)| a + f * (b - a)));
        match &self.way {
            Way::Even => {}
            Way::Arc(arc, xyz) => {
                let [a, b] = [&self.from, &self.to].map(|row| xyz.of(row));
                xyz.put(row, arc.at(a, b, f));
            }
            Way::Curve(axes, evenly) => {
                let u = evenly.parameter(f);
                row.iter_mut().zip(axes).for_each(|(value, axis)| *value = axis.at(u));
            }
            Way::Cubic(v0, v1) => {
                for (i, (v0, v1)) in v0.iter().zip(v1).enumerate() {
                    let (a, rise) = (self.from[i], self.to[i] - self.from[i]);
                    let (m0, m1) = (v0 * self.seconds, v1 * self.seconds);
                    row[i] = a + f * (m0 + f * (3.0 * rise - 2.0 * m0 - m1 + f * (m0 + m1 - 2.0 * rise)));
                }
            }
        }
    }

    /// True if it moves an axis, or lets time pass by a feed.
    pub fn is_move(&self) -> bool {
        self.level.is_some()
    }

    /// Speeds of the axes at the part `f` of the segment, per s, where it is a cubic or a curve.
    pub(crate) fn speeds(&self, f: f64) -> Option<Vec<f64>> {
        match &self.way {
            Way::Even | Way::Arc(..) => None,
            Way::Cubic(begin, end) => {
                let chord = |i: usize| (self.to[i] - self.from[i]) / self.seconds;
                let weights = [6.0 * f * (1.0 - f), (1.0 - f) * (1.0 - 3.0 * f), f * (3.0 * f - 2.0)];
                let speed =
                    |(i, (v0, v1)): (usize, (&f64, &f64))| weights[0] * chord(i) + weights[1] * v0 + weights[2] * v1;
                Some(begin.iter().zip(end).enumerate().map(speed).collect())
            }
            Way::Curve(axes, evenly) => {
                // At a station where all slopes are 0 the way bends back: its direction is that of the station next to
                // it.
                let inward = if f < 0.5 { 1e-7 } else { -1e-7 };
                let mut u = evenly.parameter(f);
                if evenly.length() > 0.0 && evenly.speed(u) <= 1e-9 * evenly.length() {
                    u += inward;
                }
                let rate = if evenly.length() > 0.0 { evenly.length() / evenly.speed(u) } else { 1.0 };
                Some(axes.iter().map(|axis| axis.slope(u) * rate / self.seconds).collect())
            }
        }
    }

    /// Channels at its end.
    pub fn end(&self) -> &[f64] {
        &self.to
    }

    /// Channels at its start.
    pub fn start(&self) -> &[f64] {
        &self.from
    }
}

/// Plays `program` from the row `start` on. Moves of the spline are given as their cubics, with the two that the
/// control adds.
pub fn play(program: &PartProgram, start: &[f64]) -> Vec<Segment> {
    let mut player = Player {
        program,
        axes: program.axes(),
        now: 0.0,
        here: start.to_vec(),
        speeds: vec![0.0; program.axes()],
        arc: false,
        pending: Vec::new(),
        segments: Vec::new(),
    };
    let mut i = 0;
    while i < program.steps.len() {
        i += player.step(i);
    }
    player.segments
}

struct Player<'a> {
    program: &'a PartProgram,
    axes: usize,
    now: f64,
    here: Vec<f64>,
    /// Speeds that the last cubic left the axes with.
    speeds: Vec<f64>,
    arc: bool,
    /// Settings that wait for the next move.
    pending: Vec<&'a What>,
    segments: Vec<Segment>,
}

impl<'a> Player<'a> {
    /// Plays step `i` and gives the number of steps it took.
    fn step(&mut self, i: usize) -> usize {
        let what = &self.program.steps[i].what;
        match what {
            What::Move(m) => {
                std::mem::take(&mut self.pending).into_iter().for_each(|what| self.set(what));
                if m.path == Path::Spline {
                    return self.spline(i);
                }
                self.one(i, m);
            }
            What::Dwell(seconds) => {
                self.add(i, *seconds, None, self.here.clone(), Way::Even);
                self.speeds.fill(0.0);
            }
            What::Set { at_once, .. } | What::Event { at_once, .. } => {
                if *at_once {
                    self.set(what);
                } else {
                    self.pending.push(what);
                }
            }
            What::Pass(_) | What::Comment(_) => {}
        }
        1
    }

    fn set(&mut self, what: &What) {
        match what {
            What::Set { channel, value, .. } => self.here[usize::from(*channel)] = *value,
            What::Event { event: Event::Arc(on), .. } => self.arc = *on,
            _ => {}
        }
    }

    fn one(&mut self, i: usize, m: &Move) {
        let to = self.program.row(m.row).to_vec();
        let way = match m.path {
            Path::Arc(arc) => Way::Arc(self.program.arcs[arc as usize], self.program.xyz()),
            Path::Hermite(row) => {
                let end = self.program.row(row)[..self.axes].to_vec();
                Way::Cubic(std::mem::replace(&mut self.speeds, end.clone()), end)
            }
            Path::Curve(curve) => {
                let curve = self.program.curves[curve as usize];
                let rows = MoveRows { from: &self.here, to: &to };
                let axes = (0..self.axes).map(|channel| self.program.polynomial(curve, channel, rows)).collect();
                Way::Curve(axes, Box::new(self.program.evenly(curve, rows)))
            }
            Path::Rapid | Path::Line | Path::Spline => Way::Even,
        };
        if !matches!(m.path, Path::Hermite(_)) {
            self.speeds.fill(0.0);
        }
        self.add(i, m.seconds, Some(m.level), to, way);
    }

    fn add(&mut self, step: usize, seconds: f64, level: Option<Level>, to: Vec<f64>, way: Way) {
        let mut from = std::mem::replace(&mut self.here, to.clone());
        // Stepped values change at the start.
        for (k, channel) in self.program.channels.iter().enumerate() {
            if channel.kind == ChannelKind::Stepped {
                from[k] = to[k];
            }
        }
        self.segments.push(Segment { begin: self.now, seconds, step, arc: self.arc, level, from, to, way });
        self.now += seconds;
    }

    /// The run of spline moves from step `i` on, as cubics, and the number of steps that it takes: a uniform B-spline whose first and last control points count
    /// three times, so that it takes two times more than there are moves.
    fn spline(&mut self, i: usize) -> usize {
        // Settings made with a motion do not interrupt it: the rows have them.
        let mut moves: Vec<(usize, Move)> = Vec::new();
        let mut steps = 0;
        for (k, step) in self.program.steps.iter().enumerate().skip(i) {
            match &step.what {
                What::Move(m) if m.path == Path::Spline && goes_on(&moves, m) => {
                    moves.push((k, *m));
                    steps = k + 1 - i;
                }
                What::Set { at_once: false, .. } | What::Comment(_) => {}
                _ => break,
            }
        }
        let time = moves[0].1.seconds;
        let count = moves.len();
        let rows: Vec<&[f64]> = moves.iter().map(|(_, m)| self.program.row(m.row)).collect();
        let first = self.here.clone();
        let control = |k: i64| -> &[f64] {
            let k = k.clamp(0, count as i64);
            if k == 0 { &first } else { rows[k as usize - 1] }
        };
        let last = count as i64;
        let mut segments = Vec::new();
        for k in -1..=last {
            let knot = |k: i64| -> (Vec<f64>, Vec<f64>) {
                let (a, b, c) = (control(k - 1), control(k), control(k + 1));
                let place = a.iter().zip(b).zip(c).map(|((a, b), c)| (a + 4.0 * b + c) / 6.0).collect();
                let speed = a.iter().zip(c).take(self.axes).map(|(a, c)| (c - a) / (2.0 * time)).collect();
                (place, speed)
            };
            let ((_, v0), (mut to, v1)) = (knot(k), knot(k + 1));
            // Process values have those of the move that is under way.
            to[self.axes..].copy_from_slice(&control(k + 1)[self.axes..]);
            segments.push((moves[k.clamp(0, last - 1) as usize].0, to, Way::Cubic(v0, v1)));
        }
        for (step, to, way) in segments {
            self.add(step, time, Some(moves[0].1.level), to, way);
        }
        self.speeds.fill(0.0);
        steps
    }
}

/// Whether a spline continues with `next`: its times are equal.
fn goes_on(moves: &[(usize, Move)], next: &Move) -> bool {
    moves.first().is_none_or(|(_, first)| (first.seconds - next.seconds).abs() <= 1e-9 * first.seconds)
}
