//! Set-points along points of any number, planned as they are read.

use super::{period, positive};
use crate::args::follow::{CornerArg, FollowArgs};
use crate::refusals::{in_file, not_allowed, unreadable};
use crate::rows::{Cell, Rows};
use glam::DVec3;
use seamwright_geometry::Pose;
use seamwright_machine::{Clamped, Joints, Machine, Surroundings};
use seamwright_message::{Message, Unit};
use seamwright_motion::speed_profile::{ProfilePoint, ProfileStream};
use seamwright_motion::taught::{Corner, TaughtPath};
use seamwright_program::{Finding, PathRange};
use seamwright_project::csv::CsvReader;
use seamwright_project::failure::Failure;
use seamwright_project::load;
use std::cell::RefCell;
use std::fs::File;
use std::io::{self, BufRead, BufReader, Write as _};

/// Plausible speeds, mm/s.
const SPEEDS: std::ops::RangeInclusive<f64> = 1e-4..=1e6;
const PLACE: [&str; 3] = ["x_mm", "y_mm", "z_mm"];
const POSE: [&str; 6] = ["x_mm", "y_mm", "z_mm", "ax", "ay", "az"];
/// Columns of `seam`: the bisector points from the joint to the torch.
const SEAM: [&str; 6] = ["x_mm", "y_mm", "z_mm", "bx", "by", "bz"];
/// Distance between clearance checks: mm, or degrees of a rotary axis.
const LOOKED_AT: f64 = 1.0;
/// Maximum step in which the way of the tip is measured, s.
const MEASURED_S: f64 = 0.01;

pub(crate) fn run(args: &FollowArgs) -> Result<(), Failure> {
    let machine = load::machine(&args.machine)?;
    let period = period(args.period_ms, &machine)?;
    let speed = args.speed_mm_s;
    if !SPEEDS.contains(&speed) {
        let plausible = Message::new("document-between").text("min", format!("{:e}", SPEEDS.start()));
        let plausible = plausible.text("max", format!("{:e}", SPEEDS.end()));
        return Err(not_allowed("--speed-mm-s", speed, plausible));
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
        _ => Box::new(BufReader::new(File::open(&args.points).map_err(|e| unreadable(&source, &e))?)),
    };
    let failed = RefCell::new(None);
    let around = Surroundings::new(&machine, &Clamped::default())
        .map_err(|e| Failure::input(in_file(&args.machine, Message::outside(&e))))?;
    let points = Points::open(&machine, &around, &source, input, &failed)?;
    let mut path = TaughtPath::new(&machine, points, speed, corner, tolerance);
    if path.is_empty() {
        return Err(failed.take().unwrap_or_else(|| {
            let message = in_file(&source, Message::new("cli-follow-too-few"));
            Failure::refused(message, Message::new("cli-at-least-two"))
        }));
    }
    let mut columns: Vec<String> = ["t_s", "s_mm"].map(str::to_owned).into();
    columns.extend(machine.axes.iter().map(|a| a.name.clone()));
    columns.push("speed_mm_s".to_owned());
    let mut rows = Rows::new(columns, args.json);
    let profile = ProfileStream::new(path, window).map_err(|e| Failure::input(in_file(&source, &e)))?;
    play(&machine, &source, profile, Playback { speed_mm_s: speed, period_s: period }, &mut rows)?;
    rows.finish()?;
    failed.take().map_or(Ok(()), Err)
}

/// Requested speed along the points, and period of the set-points.
#[derive(Clone, Copy)]
struct Playback {
    speed_mm_s: f64,
    period_s: f64,
}

/// Writes a row a period, until the first one at or after the end; then a summary to standard error.
fn play<I: Iterator<Item = Joints>>(
    machine: &Machine,
    source: &str,
    mut profile: ProfileStream<TaughtPath<'_, I>>,
    playback: Playback,
    rows: &mut Rows,
) -> Result<(), Failure> {
    let Playback { speed_mm_s: speed, period_s: period } = playback;
    let mut cells = Vec::new();
    let (mut way, mut last, mut fastest) = (0.0, 0.0, 0.0f64);
    for k in 0u64.. {
        let t = k as f64 * period;
        let parts = if k > 0 { (period / MEASURED_S).ceil() } else { 0.0 };
        let step = period / parts.max(1.0);
        let mut point = if k > 0 { None } else { tip(&mut profile, source, 0.0)?.0 };
        for part in 1..=parts as u64 {
            // The tip's way is the integral of its speed, by Simpson's rule.
            let at = t - period + part as f64 * step;
            let between = tip(&mut profile, source, at - 0.5 * step)?.1;
            let now;
            (point, now) = tip(&mut profile, source, if part == parts as u64 { t } else { at })?;
            way += step / 6.0 * (last + 4.0 * between + now);
            (last, fastest) = (now, fastest.max(now));
            if point.is_none() {
                break;
            }
        }
        let q = profile.path().position(point.unwrap_or_else(|| profile.end()).s);
        cells.clear();
        cells.extend([Cell::Number(t), Cell::Number(way)]);
        cells.extend(machine.axes.iter().zip(&q).map(|(axis, q)| Cell::Number(axis.to_file(*q))));
        cells.push(Cell::Number(if point.is_some() { last } else { 0.0 }));
        rows.row(&cells)?;
        if point.is_none() {
            break;
        }
    }
    let done = Message::new("cli-follow-done")
        .quantity("time", profile.duration().unwrap_or_default(), Unit::S, 3)
        .quantity("way", way, Unit::Mm, 3)
        .quantity("speed", fastest, Unit::MmPerS, 3);
    let slower = Message::new("cli-follow-slower").value("speed", speed, Unit::MmPerS);
    let stops = Message::new("cli-follow-stops").count("stops", profile.stops());
    let slower = (fastest < 0.99 * speed).then_some(slower);
    let stops = (profile.stops() > 0).then_some(stops);
    let all = std::iter::once(done).chain(slower).chain(stops);
    // Errors are ignored: standard error may be closed.
    let _ = writeln!(io::stderr(), "{}", all.map(|part| part.to_string()).collect::<Vec<_>>().join("; "));
    Ok(())
}

/// State of the speed profile at time `t`, and the tip's speed then (mm/s).
fn tip<I: Iterator<Item = Joints>>(
    profile: &mut ProfileStream<TaughtPath<'_, I>>,
    source: &str,
    t: f64,
) -> Result<(Option<ProfilePoint>, f64), Failure> {
    let point = profile.at(t).map_err(|e| Failure::input(in_file(source, &e)))?;
    Ok((point, point.map_or(0.0, |p| profile.path().tip_rate(p.s) * p.v)))
}

/// Axis positions of the rows of a file, each nearest to the one before; ends at the first invalid row.
struct Points<'a, R> {
    machine: &'a Machine,
    reader: CsvReader<R>,
    /// Whether rows are axis positions, points, or points with directions.
    kind: Kind,
    near: Joints,
    around: &'a Surroundings<'a>,
    /// Axis positions at the last clearance check.
    clear: Option<Joints>,
    failed: &'a RefCell<Option<Failure>>,
}

#[derive(Clone, Copy, PartialEq)]
enum Kind {
    Axes,
    Poses,
    Seam,
    Places,
}

impl<'a, R: BufRead> Points<'a, R> {
    fn open(
        machine: &'a Machine,
        around: &'a Surroundings<'a>,
        source: &str,
        input: R,
        failed: &'a RefCell<Option<Failure>>,
    ) -> Result<Self, Failure> {
        let axes: Vec<&str> = machine.axes.iter().map(|a| a.name.as_str()).collect();
        let (reader, set) = CsvReader::open(source, input, &[&axes, &POSE, &SEAM, &PLACE])?;
        let kind = [Kind::Axes, Kind::Poses, Kind::Seam, Kind::Places][set];
        Ok(Self { machine, reader, kind, near: machine.home(), around, clear: None, failed })
    }

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
                Kind::Seam => -DVec3::new(values[3], values[4], values[5]).normalize_or_zero(),
                _ => DVec3::NEG_Z,
            };
            let pose = Pose { point: DVec3::new(values[0], values[1], values[2]), direction };
            if direction == DVec3::ZERO {
                let name = if self.kind == Kind::Seam { "bx,by,bz" } else { "ax,ay,az" };
                return Some(Err(self.reader.error(
                    name,
                    "0,0,0",
                    Message::new("cli-no-length"),
                    Message::new("cli-direction"),
                )));
            }
            match machine.inverse_near(pose, &self.near) {
                Ok(solution) => {
                    q = solution.joints;
                    None
                }
                Err(reason) => Some(reason.message()),
            }
        };
        let problem = problem
            .or_else(|| machine.outside(&q).map(|v| machine.range_error(&v).message()))
            .or_else(|| self.too_near(&q));
        self.near = q;
        Some(problem.map_or(Ok(q), |message| Err(self.unreachable(message))))
    }

    /// Reports a part of the machine that comes too near to something else. The straight way of the axes to `q` is
    /// checked at every mm or degree.
    fn too_near(&mut self, q: &Joints) -> Option<Message> {
        let from = self.clear.unwrap_or(*q);
        let axes = self.machine.axes.iter().zip(from.iter().zip(q));
        let far = axes.map(|(axis, (a, b))| (axis.to_file(*b) - axis.to_file(*a)).abs()).fold(0.0, f64::max);
        if self.clear.is_some() && far < LOOKED_AT {
            return None;
        }
        let steps = (far / LOOKED_AT).ceil().max(1.0);
        self.clear = Some(*q);
        (1..=steps as u64).find_map(|k| {
            let part = k as f64 / steps;
            let at: Joints = std::array::from_fn(|i| from[i] + part * (q[i] - from[i]));
            if self.around.is_clear(&at) {
                return None;
            }
            let nearest = self.around.nearest(&at, self.around.greatest_least_mm() + 1.0);
            let bodies = nearest.map(|(watch, _)| self.around.bodies(watch));
            let too_near = |(first, second): (Message, Message)| {
                Message::new("cli-follow-too-near").message("first", first).message("second", second)
            };
            Some(bodies.map_or(Message::new("cli-follow-something-too-near"), too_near))
        })
    }

    fn unreachable(&self, why: Message) -> Failure {
        let message = Message::new("cli-follow-point").text("line", self.reader.line().to_string()).message("why", why);
        let cure = Message::new("cli-cure-follow");
        Failure::Findings(vec![Finding::error("reach", message, 1, PathRange::at(0.0), cure)])
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
