//! Acceptance tests of joint detection on simulated frames: rows of a table, each with its upper or lower limit.

use super::scene::{Kind, Scene, scene};
use crate::acceptance::{Gate, Limit, Table};
use glam::DVec2;
use seamwright_vision::joint::{CONFIDENT, End, Follower, Options, State};
use std::ops::Range;

/// Pixels to a side of the frames.
const SIZE: usize = 512;
/// A midline farther off than this is wrong, pixels.
const WRONG: f64 = 2.0;

/// A row follows the midline if it is at most this share of the joint's width off, or not wrong. Confident rows have
/// limits of their own.
const ON_IT: f64 = 0.25;

/// Result of the follower on one frame.
#[derive(Debug, Clone, PartialEq)]
pub struct Outcome {
    /// Distances of seen rows from the midline outside of tacks, pixels, and whether the row was confident.
    pub errors: Vec<(f64, bool)>,
    /// Confident rows where there is no joint at all.
    pub phantom: usize,
    /// Share of the midline's visible points that was followed.
    pub reach: f64,
    /// Distance of the last row from the end of the joint, if it ends.
    pub end_error: Option<f64>,
    /// Reason for the end.
    pub end: End,
}

/// Follows the joint of a scene.
#[must_use]
pub fn follow(follower: &mut Follower, scene: &Scene) -> Outcome {
    let truth = &scene.truth;
    // The size of a scene's image always matches its pixels.
    let Ok(frame) = scene.image.frame() else {
        return Outcome { errors: Vec::new(), phantom: 0, reach: 0.0, end_error: None, end: End::Lost };
    };
    let joint = follower.follow(&frame, &scene.start);
    let mut outcome = Outcome { errors: Vec::new(), phantom: 0, reach: 0.0, end_error: None, end: joint.end };
    let place = |x: f32, y: f32| DVec2::new(f64::from(x), f64::from(y));
    let mut reached = 0;
    for row in joint.rows.iter().filter(|r| r.state == State::Seen) {
        let (at, confident) = (place(row.x, row.y), row.confidence >= CONFIDENT);
        if truth.midline.is_empty() {
            outcome.phantom += usize::from(confident);
            continue;
        }
        if truth.tacks.iter().any(|(middle, radius)| middle.distance(at) < radius + 2.0) {
            continue;
        }
        let (error, nearest) = distance(&truth.midline, at);
        if error <= WRONG.max(ON_IT * truth.width) {
            reached = reached.max(nearest);
        }
        outcome.errors.push((error, confident));
    }
    // The midline of a wide joint continues beyond the rim.
    let inside =
        |p: &&DVec2| p.min_element() >= 0.0 && p.x <= frame.width() as f64 - 1.0 && p.y <= frame.height() as f64 - 1.0;
    let shown = truth.midline.iter().zip(&truth.shown).enumerate().filter(|(_, (p, shown))| **shown && inside(p));
    let (passed, count) =
        shown.fold((0u32, 0u32), |(passed, count), (i, _)| (passed + u32::from(i <= reached), count + 1));
    outcome.reach = f64::from(passed) / f64::from(count.max(1));
    outcome.end_error = truth.end.zip(joint.rows.last()).map(|(end, last)| end.distance(place(last.x, last.y)));
    outcome
}

/// Distance to a polyline and the number of its nearest point.
fn distance(line: &[DVec2], at: DVec2) -> (f64, usize) {
    let nearest = line.iter().enumerate().min_by(|a, b| a.1.distance_squared(at).total_cmp(&b.1.distance_squared(at)));
    let Some((i, _)) = nearest else { return (f64::INFINITY, 0) };
    let near = &line[i.saturating_sub(1)..(i + 2).min(line.len())];
    let to = near.windows(2).map(|p| {
        let along = p[1] - p[0];
        let u = ((at - p[0]).dot(along) / along.length_squared().max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
        (p[0] + u * along).distance(at)
    });
    (to.fold(f64::INFINITY, f64::min), i)
}

/// Runs the frames of these seeds of each kind, calls `done` for each, and returns the table of limits.
#[must_use]
pub fn joint_gates(seeds: Range<u64>, mut done: impl FnMut(Kind, u64, &Outcome)) -> Table {
    let mut follower = Follower::new(Options::default());
    let mut rows = Vec::new();
    let mut all = (0usize, 0usize);
    for kind in Kind::ALL {
        let outcomes: Vec<Outcome> = seeds
            .clone()
            .map(|seed| {
                let outcome = follow(&mut follower, &scene(kind, seed, SIZE));
                done(kind, seed, &outcome);
                outcome
            })
            .collect();
        for outcome in &outcomes {
            let confident = outcome.errors.iter().filter(|(_, c)| *c);
            all.0 += outcome.phantom + confident.clone().filter(|(e, _)| *e > WRONG).count();
            all.1 += outcome.phantom + confident.count();
        }
        gates_of(kind, &outcomes, &mut rows);
    }
    let value = 100.0 * all.0 as f64 / all.1.max(1) as f64;
    rows.push(Gate::at_most("all", "confident rows off by more than 2 px", value, 0.01, "%"));
    Table { title: "The joint in a frame".to_owned(), rows }
}

fn gates_of(kind: Kind, outcomes: &[Outcome], rows: &mut Vec<Gate>) {
    let mut gate =
        |what, value, limit, unit| rows.push(Gate { frames: kind.name().to_owned(), what, value, limit, unit });
    let count = |test: &dyn Fn(&Outcome) -> bool| outcomes.iter().filter(|o| test(o)).count() as f64;
    if matches!(kind, Kind::Blank | Kind::OnlyScratches) {
        gate("confident rows", outcomes.iter().map(|o| o.phantom).sum::<usize>() as f64, Limit::Most(0.0), "");
        if kind == Kind::Blank {
            gate("frames that end otherwise than lost", count(&|o| o.end != End::Lost), Limit::Most(0.0), "");
        }
        return;
    }
    let mut confident: Vec<f64> = outcomes.iter().flat_map(|o| &o.errors).filter(|e| e.1).map(|e| e.0).collect();
    confident.sort_by(f64::total_cmp);
    let seen = outcomes.iter().map(|o| o.errors.len()).sum::<usize>();
    let quantile = |q: f64| confident.get((q * confident.len() as f64) as usize).copied().unwrap_or(f64::INFINITY);
    // Without rows the value is infinite: a limit without measurements is not kept.
    let rms = match confident.len() {
        0 => f64::INFINITY,
        n => (confident.iter().map(|e| e * e).sum::<f64>() / n as f64).sqrt(),
    };
    let wrong = confident.iter().filter(|e| **e > WRONG).count();
    gate(
        "confident rows off by more than 2 px",
        100.0 * wrong as f64 / confident.len().max(1) as f64,
        Limit::Most(0.01),
        "%",
    );
    if kind == Kind::Shadow {
        return;
    }
    if kind == Kind::Faint {
        gate("95 % of confident rows", quantile(0.95), Limit::Most(1.0), "px");
        gate("rows kept confident", 100.0 * confident.len() as f64 / seen.max(1) as f64, Limit::Least(80.0), "%");
    } else {
        gate("RMS of confident rows", rms, Limit::Most(0.3), "px");
        gate("99 % of confident rows", quantile(0.99), Limit::Most(1.0), "px");
    }
    if kind != Kind::Faint {
        gate("frames lost before 95 % of the joint", count(&|o| o.reach < 0.95), Limit::Most(0.0), "");
    }
    match kind {
        Kind::Loop => gate("frames not closed", count(&|o| o.end != End::Closed), Limit::Most(0.0), ""),
        Kind::End => {
            gate("frames without the end told", count(&|o| o.end != End::JointEnd), Limit::Most(0.0), "");
            gate(
                "maximum end error",
                outcomes.iter().filter_map(|o| o.end_error).reduce(f64::max).unwrap_or(f64::INFINITY),
                Limit::Most(3.0),
                "px",
            );
        }
        _ => {}
    }
}
