use super::arm;
use super::certificate::{certificate, used};
use super::clearance::near;
use super::finding_position::Standing;
use super::machine::axes;
use super::section::sections;
use super::solid::solid;
use crate::wire::{FindingView, NearView, PassView, PathPoint, SolidView, WorkView};
use seamwright_machine::{Machine, Surroundings};
use seamwright_motion::transfer::Leg;
use seamwright_motion::{PassClearance, PassMotion, WeldMotion};
use seamwright_program::{ArcTime, Finding, Pass, TorchPath};
use seamwright_project::load::Loaded;

/// Number of samples of a pass, and of a transfer move.
const SAMPLES: usize = 400;
const AIR_SAMPLES: usize = 40;
/// Distance from the start within which the end of a pass closes it, mm.
const CLOSED_MM: f64 = 1e-3;

/// Returns a planned job. If it cannot be planned, returns findings and the passes as the job requests them.
pub(crate) fn work_view(id: u64, job: &str, loaded: &Loaded, planned: Result<&WeldMotion, &[Finding]>) -> WorkView {
    let program = &loaded.welding.program.value;
    let machine = &loaded.machine;
    let values = program.process_values();
    let motion = planned.ok();
    let findings = planned.map_or_else(|findings| findings, |m| &m.findings);
    let (part, fixtures) = clamped_views(loaded);
    // The plan needed them, so they exist.
    let around = loaded.surroundings().ok();
    let mut standing = Standing::new(loaded, motion, around.as_ref());
    WorkView {
        id,
        job: job.to_owned(),
        title: program.title.clone(),
        machine: machine.name.clone(),
        axes: axes(machine),
        passes: (program.passes.iter().enumerate())
            .map(|(i, pass)| {
                let path = loaded.welding.path(i);
                let planned = motion.and_then(|m| m.passes.get(i));
                let length = planned.map_or(path.length(), |planned| planned.path.length());
                let points_mm = points(pass, &path, length);
                let spans = spans(pass, &points_mm, length);
                let clearance = motion.and_then(|m| m.clearance.get(i)?.as_ref());
                let view = match planned {
                    Some(planned) => pass_view(machine, pass, planned, around.as_ref().zip(clearance), &values),
                    None => asked_view(pass, &path, &values),
                };
                PassView { spans, points_mm, ..view }
            })
            .collect(),
        values,
        air: motion.map_or(Vec::new(), |m| m.transfers.iter().map(|a| air(machine, a)).collect()),
        air_s: motion
            .map_or(Vec::new(), |m| m.transfers.iter().map(|a| a.legs.iter().map(Leg::duration).sum()).collect()),
        part,
        fixtures,
        sections: sections(&loaded.welding),
        findings: findings.iter().map(|f| finding(f, &mut standing)).collect(),
        good: motion.is_some() && findings.iter().all(|f| f.allowed),
        time_s: motion.map_or(0.0, WeldMotion::total_s),
        from: None,
        tracked: 0,
        distortion: None,
    }
}

/// Returns part and fixtures, on the work's link.
pub(crate) fn clamped_views(loaded: &Loaded) -> (Vec<SolidView>, Vec<SolidView>) {
    let link = loaded.machine.links.frame("work").map_or(0, |f| f.link);
    let views = |solids: &[seamwright_clearance::Solid]| solids.iter().map(|s| solid(s, link)).collect();
    (views(&loaded.clamped.part), views(&loaded.clamped.fixtures))
}

/// Minimum distance at path length `s`, mm, interpolated linearly between samples; `None` beyond the cut-off.
fn clearance_at(clearance: &PassClearance, s: f64) -> Option<f64> {
    let found = &clearance.found;
    let after = found.partition_point(|at| at.0 < s).min(found.len().checked_sub(1)?);
    let (a, b) = (found[after.saturating_sub(1)], found[after]);
    let part = if b.0 > a.0 { ((s - a.0) / (b.0 - a.0)).clamp(0.0, 1.0) } else { 1.0 };
    Some(a.1 + part * (b.1 - a.1)).filter(|mm| *mm < clearance.cutoff_mm)
}

/// Returns the position of the minimum distance on a pass, and the pair.
fn nearest(around: &Surroundings<'_>, clearance: &PassClearance, planned: &PassMotion) -> Option<(f64, NearView)> {
    let (s, _) = clearance.found.iter().min_by(|a, b| a.1.total_cmp(&b.1))?;
    Some((*s, near(around, &planned.path.at(*s), clearance.cutoff_mm)?))
}

/// Returns the path lengths at which a pass of this length reaches its points, mm.
fn points(pass: &Pass, path: &dyn TorchPath, length: f64) -> Vec<f64> {
    let Some(points) = &pass.points else { return Vec::new() };
    (0..=points.count()).map(|i| path.points().and_then(|points| points.reached(i)).unwrap_or(length)).collect()
}

/// Returns start and end of the spans of a pass of this length with its points at `points_mm`, mm.
fn spans(pass: &Pass, points_mm: &[f64], length: f64) -> Vec<[f64; 2]> {
    let Some(points) = &pass.points else {
        return pass.spans.iter().map(|span| [span.from_mm.get(), span.to_mm.get().min(length)]).collect();
    };
    let mut count = 0;
    let runs = points.spans.iter().map(|run| {
        let from = count;
        count += run.points.len();
        [from, count].map(|i| points_mm.get(i).copied().unwrap_or(length))
    });
    runs.collect()
}

fn pass_view(
    machine: &Machine,
    pass: &Pass,
    planned: &PassMotion,
    clearance: Option<(&Surroundings<'_>, &PassClearance)>,
    values: &[String],
) -> PassView {
    let length = planned.path.length();
    let path: Vec<PathPoint> = (0..=SAMPLES)
        .map(|i| {
            let s = length * i as f64 / SAMPLES as f64;
            let q = planned.path.at(s);
            let tip = machine.forward(&q);
            let profile = planned.profile.at(planned.profile.time(s), &mut 0);
            PathPoint {
                s_mm: s,
                tip: tip.point.to_array(),
                torch: (-tip.direction).to_array(),
                speed_mm_s: planned.tip_speed(machine, profile),
                used: used(machine, planned, profile),
                axes: machine.axes.iter().zip(q).map(|(axis, q)| axis.to_file(q)).collect(),
                values: process(pass, values, s),
                clearance_mm: clearance.and_then(|(_, clearance)| clearance_at(clearance, s)),
            }
        })
        .collect();
    let samples: Vec<_> = (0..=SAMPLES).map(|i| length * i as f64 / SAMPLES as f64).collect();
    let positions: Vec<_> = samples.iter().map(|s| planned.path.at(*s)).collect();
    let (nearest_at_mm, nearest) = clearance.and_then(|(around, c)| nearest(around, c, planned)).unzip();
    PassView {
        time_s: planned.total_s(),
        certificate: Some(certificate(machine, pass, planned)),
        nearest,
        nearest_at_mm,
        arm: arm::along(machine, samples.iter().copied().zip(&positions)),
        ..named_view(pass, path)
    }
}

/// Returns a pass as the job requests it, without a motion.
fn asked_view(pass: &Pass, path: &dyn TorchPath, values: &[String]) -> PassView {
    let sample = |i| {
        let s = path.length() * i as f64 / SAMPLES as f64;
        let tip = path.pose(s);
        PathPoint {
            s_mm: s,
            tip: tip.point.to_array(),
            torch: (-tip.direction).to_array(),
            speed_mm_s: Some(pass.speed_at(s)).filter(|v| v.is_finite()).unwrap_or_default(),
            used: Vec::new(),
            axes: Vec::new(),
            values: process(pass, values, s),
            clearance_mm: None,
        }
    };
    named_view(pass, (0..=SAMPLES).map(sample).collect())
}

fn named_view(pass: &Pass, path: Vec<PathPoint>) -> PassView {
    let ends = path.first().zip(path.last()).map(|(a, b)| [a.tip, b.tip].map(glam::DVec3::from_array));
    PassView {
        name: pass.name.clone(),
        role: pass.known_role().map_or(String::new(), |role| role.name().to_owned()),
        length_mm: path.last().map_or(0.0, |end| end.s_mm),
        overlap_mm: pass.sequence.overlap_mm.get(),
        speed_mm_s: path.get(SAMPLES / 2).map_or(0.0, |p| p.speed_mm_s),
        closed: ends.is_some_and(|[a, b]| a.distance(b) < CLOSED_MM),
        path,
        ..PassView::default()
    }
}

fn process(pass: &Pass, values: &[String], s: f64) -> Vec<Option<f64>> {
    let asked = values.iter().map(|name| pass.process_at(name, s, ArcTime::TRAVEL));
    asked.map(|v| v.filter(|v| v.is_finite())).collect()
}

fn air(machine: &Machine, way: &seamwright_motion::transfer::TransferMove) -> Vec<[f64; 3]> {
    let legs = way
        .legs
        .iter()
        .flat_map(|leg| (0..=AIR_SAMPLES).map(move |i| leg.at_time(leg.duration() * i as f64 / AIR_SAMPLES as f64)));
    legs.map(|q| machine.forward(&q).point.to_array()).collect()
}

fn finding(f: &Finding, standing: &mut Standing<'_>) -> FindingView {
    let (axes, nearest) = standing.at(f);
    FindingView {
        axes,
        nearest,
        kind: f.kind.to_string(),
        message: (&f.message).into(),
        pass: f.pass as u32,
        from_mm: f.from_mm,
        to_mm: f.to_mm,
        cure: f.cure.as_ref().map(Into::into),
        allowed: f.allowed,
    }
}
