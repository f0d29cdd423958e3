//! Set-points along points of any number, planned as they are read.

use super::positive;
use crate::args::follow::{CornerArg, FollowArgs};
use crate::csv::CsvReader;
use crate::failure::Failure;
use crate::load;
use crate::rows::{Cell, Rows};
use glam::DVec3;
use seamwright_geometry::Pose;
use seamwright_machine::{Joints, Machine};
use seamwright_motion::law::{LawPoint, LawStream};
use seamwright_motion::taught::{Corner, TaughtPath};
use seamwright_program::Finding;
use std::cell::RefCell;
use std::fs::File;
use std::io::{self, BufRead, BufReader, Write as _};

/// Speeds that somebody could mean, mm/s.
const SPEEDS: std::ops::RangeInclusive<f64> = 1e-4..=1e6;
const PLACE: [&str; 3] = ["x_mm", "y_mm", "z_mm"];
const POSE: [&str; 6] = ["x_mm", "y_mm", "z_mm", "ax", "ay", "az"];

pub(crate) fn run(args: &FollowArgs) -> Result<(), Failure> {
    let machine = load::machine(&args.machine)?;
    let period = match args.period_ms {
        Some(ms) => positive("--period-ms", ms)? * 1e-3,
        None => machine.servo_period_s,
    };
    let speed = args.speed_mm_s;
    if !SPEEDS.contains(&speed) {
        let (least, most) = (SPEEDS.start(), SPEEDS.end());
        return Err(Failure::Input(format!("--speed-mm-s {speed}: not allowed\n   allowed: {least:e} to {most:e}")));
    }
    let window = positive("--window-s", args.window_s)?;
    let tolerance = positive("--tolerance-mm", args.tolerance_mm)?;
    let corner = match args.corner {
        CornerArg::Stop => Corner::Stop,
        CornerArg::Blend => Corner::Blend(positive("--corner-mm", args.corner_mm)?),
    };
    let source = args.points.display().to_string();
    let input: Box<dyn BufRead> = match source.as_str() {
        "-" => Box::new(io::stdin().lock()),
        _ => Box::new(BufReader::new(
            File::open(&args.points).map_err(|e| Failure::Input(format!("{source}: cannot be read: {e}")))?,
        )),
    };
    let failed = RefCell::new(None);
    let points = Points::open(&machine, &source, input, &failed)?;
    let mut path = TaughtPath::new(&machine, points, speed, corner, tolerance);
    if path.is_empty() {
        return Err(failed.take().unwrap_or_else(|| {
            Failure::Input(format!("{source}: fewer than two different points\n   allowed: at least two"))
        }));
    }
    let mut columns: Vec<String> = ["t_s", "s_mm"].map(str::to_owned).into();
    columns.extend(machine.axes.iter().map(|a| a.name.clone()));
    columns.push("speed_mm_s".to_owned());
    let mut rows = Rows::new(columns, args.json)?;
    let law = LawStream::new(path, window).map_err(|e| Failure::Input(format!("{source}: {e}")))?;
    play(&machine, &source, law, (speed, period), &mut rows)?;
    rows.finish()?;
    failed.take().map_or(Ok(()), Err)
}

/// Writes a row a period, until the first one at or after the end; then a summary to standard error.
fn play<I: Iterator<Item = Joints>>(
    machine: &Machine,
    source: &str,
    mut law: LawStream<TaughtPath<'_, I>>,
    (speed, period): (f64, f64),
    rows: &mut Rows,
) -> Result<(), Failure> {
    let mut cells = Vec::new();
    let (mut way, mut last, mut fastest) = (0.0, 0.0, 0.0f64);
    for k in 0u64.. {
        let t = k as f64 * period;
        // The tip's way is the integral of its speed, by Simpson's rule.
        let between = if k > 0 { tip(&mut law, source, t - 0.5 * period)?.1 } else { 0.0 };
        let (point, now) = tip(&mut law, source, t)?;
        way += period / 6.0 * (last + 4.0 * between + now);
        (last, fastest) = (now, fastest.max(now));
        let q = law.path().position(point.unwrap_or_else(|| law.end()).s);
        cells.clear();
        cells.extend([Cell::Number(t), Cell::Number(way)]);
        cells.extend(machine.axes.iter().zip(&q).map(|(axis, q)| Cell::Number(axis.to_file(*q))));
        cells.push(Cell::Number(now));
        rows.row(&cells)?;
        if point.is_none() {
            break;
        }
    }
    let mut told = format!("{:.3} s, {way:.3} mm, fastest {fastest:.3} mm/s", law.duration().unwrap_or_default());
    if fastest < 0.999 * speed {
        told +=
            &format!("; the {speed} mm/s asked for are never reached: the axes' limits or the way's length forbid it");
    }
    if law.stops() > 0 {
        told += &format!("; {} stops to plan ahead: a longer --window-s would avoid them", law.stops());
    }
    // Nothing can be done if standard error is closed.
    let _ = writeln!(io::stderr(), "{told}");
    Ok(())
}

/// The law at time `t`, and how fast the tip is then (mm/s).
fn tip<I: Iterator<Item = Joints>>(
    law: &mut LawStream<TaughtPath<'_, I>>,
    source: &str,
    t: f64,
) -> Result<(Option<LawPoint>, f64), Failure> {
    let point = law.at(t).map_err(|e| Failure::Input(format!("{source}: {e}")))?;
    Ok((point, point.map_or(0.0, |p| law.path().tip_rate(p.s) * p.v)))
}

/// Axis positions of the rows of a file, each nearest to the one before; ends at the first that is no good.
struct Points<'a, R> {
    machine: &'a Machine,
    reader: CsvReader<R>,
    /// Whether rows are axis positions, places, or places with directions.
    kind: Kind,
    near: Joints,
    failed: &'a RefCell<Option<Failure>>,
}

#[derive(Clone, Copy, PartialEq)]
enum Kind {
    Axes,
    Poses,
    Places,
}

impl<'a, R: BufRead> Points<'a, R> {
    fn open(
        machine: &'a Machine,
        source: &str,
        input: R,
        failed: &'a RefCell<Option<Failure>>,
    ) -> Result<Self, Failure> {
        let axes: Vec<&str> = machine.axes.iter().map(|a| a.name.as_str()).collect();
        let (reader, set) = CsvReader::open(source, input, &[&axes, &POSE, &PLACE])?;
        let kind = [Kind::Axes, Kind::Poses, Kind::Places][set];
        Ok(Self { machine, reader, kind, near: machine.home(), failed })
    }

    /// The next row's positions.
    fn row(&mut self) -> Option<Result<Joints, Failure>> {
        let values = match self.reader.row()? {
            Ok(values) => values,
            Err(failure) => return Some(Err(failure)),
        };
        let machine = self.machine;
        let mut q = Joints::default();
        let problem = if self.kind == Kind::Axes {
            for ((q, axis), value) in q.iter_mut().zip(&machine.axes).zip(values) {
                *q = axis.from_file(*value);
            }
            None
        } else {
            let direction = match self.kind {
                Kind::Poses => DVec3::new(values[3], values[4], values[5]).normalize_or_zero(),
                _ => DVec3::NEG_Z,
            };
            let pose = Pose { point: DVec3::new(values[0], values[1], values[2]), direction };
            match machine.inverse_near(pose, &self.near) {
                _ if direction == DVec3::ZERO => Some("the direction has no length".to_owned()),
                Ok(solution) => {
                    q = solution.joints;
                    None
                }
                Err(reason) => Some(reason.to_string()),
            }
        };
        let problem = problem.or_else(|| machine.outside(&q).map(|v| machine.range_error(&v).to_string()));
        self.near = q;
        Some(problem.map_or(Ok(q), |message| Err(self.unreachable(&message))))
    }

    fn unreachable(&self, message: &str) -> Failure {
        Failure::Findings(vec![Finding {
            kind: "reach",
            message: format!("the point in line {}: {message}", self.reader.line()),
            pass: 1,
            from_mm: 0.0,
            to_mm: 0.0,
            cure: "change the points, the placement of the work or the machine; the motion ends before this point"
                .to_owned(),
            allowed: false,
        }])
    }
}

impl<R: BufRead> Iterator for Points<'_, R> {
    type Item = Joints;

    fn next(&mut self) -> Option<Joints> {
        if self.failed.borrow().is_some() {
            return None;
        }
        match self.row()? {
            Ok(q) => Some(q),
            Err(failure) => {
                self.failed.replace(Some(failure));
                None
            }
        }
    }
}
