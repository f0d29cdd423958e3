//! Frames that the follower gets wrong or leaves early, and the acceptance criteria:
//! `cargo run --release -p seamwright-simulation --example joint_gates FRAMES FIRST_SEED`.

#![allow(missing_docs)]
use seamwright_simulation::acceptance::Limit;
use seamwright_simulation::camera_simulator::acceptance::{follow, joint_gates};
use seamwright_simulation::camera_simulator::scene::{Kind, scene};
use seamwright_vision::joint::{End, Follower, Options};
use std::ops::Range;
use std::time::Instant;

fn main() {
    let mut numbers = std::env::args().skip(1).filter_map(|n| n.parse::<u64>().ok());
    let (frames, first) = (numbers.next().unwrap_or(50), numbers.next().unwrap_or(1000));
    let only = std::env::args().nth(3);
    if let Some(name) = only {
        Kind::ALL.into_iter().filter(|k| k.name() == name).for_each(|kind| show(kind, first));
        return;
    }
    let table = joint_gates(first..first + frames, |kind, seed, o| {
        let wrong = o.errors.iter().filter(|(e, sure)| *sure && *e > 2.0).count() + o.phantom;
        let sure = o.errors.iter().filter(|(_, sure)| *sure).count();
        let untold = match kind {
            Kind::End => o.end != End::JointEnd,
            Kind::Loop => o.end != End::Closed,
            Kind::Blank => o.end != End::Lost,
            _ => false,
        };
        let early = o.reach < 0.95 && !matches!(kind, Kind::Blank | Kind::OnlyScratches);
        if wrong > 0 || early || untold || o.end_error.is_some_and(|e| e > 3.0) {
            let (name, rows) = (kind.name(), o.errors.len());
            println!(
                "{name} {seed}: {wrong} wrong of {sure} sure of {rows}, reach {:.2}, {:?}, end off {:?}",
                o.reach, o.end, o.end_error
            );
        }
    });
    let all = times(Kind::ALL, first..first + frames.min(100), 512);
    let (median, most, longer) = (all[all.len() / 2], all[all.len() * 99 / 100], all.iter().filter(|ms| **ms > 1.0));
    println!("{} frames: median {median:.3} ms, 99 % {most:.3} ms, {} over 1 ms", all.len(), longer.count());
    // The same joints, larger: time by number of pixels.
    for size in [256, 512, 1024, 2048] {
        let clear = times([Kind::Clear], first..first + frames.min(15), size);
        let ms = clear[clear.len() / 2];
        println!("clear, {size} x {size}: median {ms:.3} ms, {:.2} ns a pixel", ms * 1e6 / (size * size) as f64);
    }
    for gate in table.rows {
        let (sign, limit) = match gate.limit {
            Limit::Most(limit) => ("<=", limit),
            Limit::Least(limit) => (">=", limit),
        };
        let kept = if gate.is_kept() { "kept" } else { "not kept" };
        println!("| {} | {} | {:.3} {} | {sign} {limit} | {kept} |", gate.frames, gate.what, gate.value, gate.unit);
    }
}

/// Returns the times of frames of these kinds and seeds, ms, the best of three each, sorted.
fn times(kinds: impl IntoIterator<Item = Kind>, seeds: Range<u64>, size: usize) -> Vec<f64> {
    let mut follower = Follower::new(Options::default());
    let mut times: Vec<f64> = Vec::new();
    for (kind, seed) in kinds.into_iter().flat_map(|k| seeds.clone().map(move |s| (k, s))) {
        let scene = scene(kind, seed, size);
        let Ok(frame) = scene.image.frame() else { continue };
        let mut run = || {
            let from = Instant::now();
            follower.follow(&frame, &scene.start);
            from.elapsed().as_secs_f64() * 1e3
        };
        times.push((0..3).map(|_| run()).fold(f64::INFINITY, f64::min));
    }
    times.sort_by(f64::total_cmp);
    times
}

/// Prints the errors of one frame's confident rows.
fn show(kind: Kind, seed: u64) {
    let scene = scene(kind, seed, 512);
    let outcome = follow(&mut Follower::new(Options::default()), &scene);
    println!(
        "width {:.1} cnr {:.1} tacks {:?} end {:?}",
        scene.truth.width, scene.truth.cnr, scene.truth.tacks, scene.truth.end
    );
    let Ok(frame) = scene.image.frame() else { return };
    let mut follower = Follower::new(Options::default());
    let joint = follower.follow(&frame, &scene.start);
    println!("{:?}", joint.rows.iter().step_by(joint.rows.len().div_ceil(8).max(1)).collect::<Vec<_>>());
    for (i, (error, sure)) in outcome.errors.iter().enumerate() {
        println!("{i} {error:.2} {}", if *sure { "sure" } else { "" });
    }
}
