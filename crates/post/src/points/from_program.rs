use crate::control::{Control, Dialect};
use crate::part_program::{Arc, ChannelKind, Event, Level, Move, MoveRows, PartProgram, Path, What};
use glam::DVec3;
use seamwright_document::{Direction, Finite};
use seamwright_machine::{Joints, Machine};
use seamwright_program::{Along, ArcThrough, Pass, PointEvent, PointSpan, Points, tip_way};

/// Whether a pass goes into a part program block by block: its points are axis positions, and the control supports
/// every way between them. The others are cut from the planned motion.
pub(crate) fn is_posted_as_it_stands(control: &Control, pass: &Pass) -> bool {
    let Some(points) = &pass.points else { return false };
    let columns = points.known_columns();
    let place = |row: &[Finite]| {
        let of = |name: &str| columns.axes.iter().find(|(axis, _)| axis == name).map_or(0.0, |(_, i)| row[*i].get());
        DVec3::new(of("x"), of("y"), of("z"))
    };
    let mut here = place(&points.start);
    let mut can = |span: &PointSpan| {
        let start = here;
        here = span.points.last().map_or(here, |row| place(row));
        match span.along {
            Along::Rapid | Along::Line => true,
            Along::Arc => arc(span, start, here).is_some_and(|arc| can_arc(control.dialect, &arc)),
            Along::Cubic => control.dialect == Dialect::Pmac,
            Along::Spline | Along::Taught => false,
        }
    };
    columns.pose == 0 && points.spans.iter().all(&mut can)
}

/// LinuxCNC and grblHAL have arcs in the planes of two axes, PMAC any, a Sinumerik any that does not climb.
fn can_arc(dialect: Dialect, arc: &ArcThrough) -> bool {
    let upright = arc.axis.abs().max_element() > 1.0 - UPRIGHT;
    match dialect {
        Dialect::Pmac => true,
        Dialect::Sinumerik => upright || arc.rise.abs() < 1e-9,
        Dialect::Linuxcnc | Dialect::Grblhal => upright,
    }
}

/// Maximum deviation of an arc's axis from that of a plane of two axes to count as along it: positions have rounded
/// coordinates.
const UPRIGHT: f64 = 1e-12;

/// The arc of a span with these start and end points.
fn arc(span: &PointSpan, start: DVec3, end: DVec3) -> Option<ArcThrough> {
    ArcThrough::new(start, span.via_mm?.get(), end, span.normal.map(Direction::unit))
}

/// Axis positions at start and end of a pass through them.
pub(crate) fn ends(machine: &Machine, pass: &Pass) -> Option<(Joints, Joints)> {
    let points = pass.points.as_ref()?;
    let columns = points.known_columns();
    let at = |row: &[Finite]| {
        let mut q = machine.home();
        for (name, column) in &columns.axes {
            if let Some(i) = machine.axis(name) {
                q[i] = machine.axes[i].from_file(row[*column].get());
            }
        }
        q
    };
    Some((at(&points.start), at(points.rows().last()?)))
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Part {
    /// Events and values at its start: `all` values, or only those that changed.
    Begin {
        all: bool,
    },
    Blocks,
    /// Events after its end.
    End,
}

/// Steps of `pass` as it stands, appended to `program`; `here` is the row that the control is at, and is left where they
/// end.
pub(crate) fn steps(
    machine: &Machine,
    control: &Control,
    pass: &Pass,
    program: &mut PartProgram,
    here: &mut Vec<f64>,
    part: Part,
) {
    let Some(points) = &pass.points else { return };
    let columns = points.known_columns();
    let mut channels: Vec<(usize, usize)> = Vec::new();
    for (name, column) in columns.axes.iter().chain(&columns.process) {
        channels.extend(control.channel(name).map(|channel| (channel, *column)));
    }
    let home = machine.home();
    let mut base = here.clone();
    for (i, axis) in machine.axes.iter().enumerate() {
        base[i] = axis.to_file(home[i]);
    }
    let mut writer = Steps { machine, points, channels, base, number: columns.number, timed: columns.timed, program };
    match part {
        Part::Begin { all } => return writer.begin(here, all),
        Part::End => return writer.events(points.count()),
        Part::Blocks => {}
    }
    let mut reached = 0;
    for span in &points.spans {
        for (k, point) in span.points.iter().enumerate() {
            let row = writer.row(point);
            writer.block(span, k, MoveRows { from: here, to: &row });
            *here = row;
            reached += 1;
            if reached < points.count() {
                writer.events(reached);
            }
        }
    }
}

struct Steps<'a> {
    machine: &'a Machine,
    points: &'a Points,
    /// Channels with their columns.
    channels: Vec<(usize, usize)>,
    /// Values of the other channels.
    base: Vec<f64>,
    number: Option<usize>,
    timed: bool,
    program: &'a mut PartProgram,
}

impl Steps<'_> {
    fn row(&self, point: &[Finite]) -> Vec<f64> {
        let mut row = self.base.clone();
        self.channels.iter().for_each(|(channel, column)| row[*channel] = point[*column].get());
        row
    }

    fn begin(&mut self, here: &mut Vec<f64>, all: bool) {
        self.events(0);
        let first = self.row(&self.points.start);
        for channel in self.program.axes()..first.len() {
            let told = all && self.channels.iter().any(|(told, _)| *told == channel);
            if told || (first[channel] - here[channel]).abs() > 0.0 {
                self.program.push(What::Set { channel: channel as u16, value: first[channel], at_once: true });
            }
        }
        *here = first;
    }

    fn events(&mut self, after: usize) {
        for event in self.points.events.iter().filter(|event| event.after == after) {
            let event = event_of(event);
            self.program.steps.extend(event.map(|event| crate::part_program::Step {
                line: 0,
                number: None,
                what: What::Event { event, at_once: true },
            }));
        }
    }

    fn block(&mut self, span: &PointSpan, k: usize, rows: MoveRows) {
        let MoveRows { from, to } = rows;
        let point = &span.points[k];
        let path = match span.along {
            Along::Rapid => Path::Rapid,
            Along::Arc => self.arc(span, rows).map_or(Path::Line, |arc| {
                self.program.arcs.push(arc);
                Path::Arc(self.program.arcs.len() as u32 - 1)
            }),
            Along::Cubic => {
                let mut speeds = vec![0.0; to.len()];
                let places = self.channels.iter().filter(|(channel, _)| *channel < self.program.axes());
                for ((channel, _), speed) in places.zip(&span.speeds[k + 1]) {
                    speeds[*channel] = speed.get();
                }
                Path::Hermite(self.program.add_row(&speeds))
            }
            Along::Line | Along::Spline | Along::Taught => Path::Line,
        };
        for channel in self.program.axes()..to.len() {
            let stepped = self.program.channels[channel].kind == ChannelKind::Stepped;
            if stepped && (to[channel] - from[channel]).abs() > 0.0 {
                // Without motion the value is set at once.
                let axes = self.program.axes();
                let at_once = from[..axes] == to[..axes];
                self.program.push(What::Set { channel: channel as u16, value: to[channel], at_once });
            }
        }
        let last = point[point.len() - 1].get();
        let seconds = match path {
            Path::Rapid => 0.0,
            _ if self.timed => last,
            _ => self.way(path, rows) / last,
        };
        let number = self.number.map(|column| point[column].get() as u32).filter(|n| *n > 0);
        let row = self.program.add_row(to);
        let m = Move { path, row, seconds, level: Level::Joint, exact_stop: span.stops };
        self.program.steps.push(crate::part_program::Step { line: 0, number, what: What::Move(m) });
    }

    /// Way of the tip in a block, mm.
    fn way(&self, path: Path, rows: MoveRows) -> f64 {
        let MoveRows { from, to } = rows;
        let arc = match path {
            Path::Arc(i) => Some(self.program.arcs[i as usize]),
            _ => None,
        };
        tip_way(|f| {
            let mut q = Joints::default();
            for (i, axis) in self.machine.axes.iter().enumerate() {
                q[i] = axis.from_file(from[i] + f * (to[i] - from[i]));
            }
            if let Some(arc) = arc {
                let xyz = self.program.xyz();
                let [a, b] = [from, to].map(|row| xyz.of(row));
                xyz.put(&mut q, arc.at(a, b, f));
            }
            self.machine.forward(&q).point
        })
    }

    fn arc(&self, span: &PointSpan, rows: MoveRows) -> Option<Arc> {
        let [start, end] = [rows.from, rows.to].map(|row| self.program.xyz().of(row));
        let arc = arc(span, start, end)?;
        let axis = [DVec3::X, DVec3::Y, DVec3::Z].into_iter().find(|n| arc.axis.dot(*n).abs() > 1.0 - UPRIGHT);
        let normal = axis.map_or(arc.axis, |n| n * arc.axis.dot(n).signum());
        Some(Arc { centre: arc.centre, normal, sweep: arc.sweep })
    }
}

pub(crate) fn event_of(event: &PointEvent) -> Option<Event> {
    Some(match event {
        PointEvent { gas: Some(on), .. } => Event::Gas(*on),
        PointEvent { wire: Some(on), .. } => Event::Wire(*on),
        PointEvent { output: Some(number), on: Some(on), .. } => Event::Output(*number, *on),
        PointEvent { message: Some(text), .. } => Event::Message(text.as_str().into()),
        PointEvent { call: Some(name), .. } => Event::Call(name.as_str().into()),
        _ => return None,
    })
}
