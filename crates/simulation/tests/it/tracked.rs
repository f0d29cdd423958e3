//! Jobs with displaced parts, welded on simulated machines with tracking and without.

use crate::common::{limit_use, simulated};
use seamwright_executive::tracking::RESERVE;
use seamwright_machine::{Clamped, Machine, Surroundings, shipped};
use seamwright_motion::WeldMotion;
use seamwright_program::{Pass, Tolerance, TorchPath};
use seamwright_simulation::tracking::Distortion;
use seamwright_simulation::tracking::acceptance::cross_talk;
use seamwright_simulation::{Conditions, Error, Sample, Summary};
use seamwright_tracking::beam::DeviationRecord;
use seamwright_weld::Welding;

struct Weld {
    machine: Machine,
    summary: Summary,
    summaries: Vec<Summary>,
    samples: Vec<Sample>,
}

fn weld(job: &str, distortion: &str, tracking: bool, seed: u64) -> Result<Weld, Error> {
    welds(job, distortion, tracking, seed, 1)
}

/// Welds the job's passes `times` times, one after the other.
fn welds(job: &str, distortion: &str, tracking: bool, seed: u64, times: usize) -> Result<Weld, Error> {
    replayed(job, distortion, tracking, seed, times, None)
}

/// Welds the same, corrected by the stored deviations, if there are any.
fn replayed(
    job: &str,
    distortion: &str,
    tracking: bool,
    seed: u64,
    times: usize,
    replay: Option<&DeviationRecord>,
) -> Result<Weld, Error> {
    let welding = Welding::read("job.toml", job).unwrap();
    let program = &welding.program.value;
    let machine = Machine::read("m.toml", shipped(&program.machine).unwrap().text).unwrap();
    let distortion = Distortion::read("d.toml", distortion).unwrap();
    let paths: Vec<_> = (0..program.passes.len()).map(|i| welding.path(i)).collect();
    let once = paths.iter().zip(&program.passes).map(|(path, pass)| (path as &dyn TorchPath, pass));
    let passes: Vec<(&dyn TorchPath, &Pass)> = std::iter::repeat_n(once, times).flatten().collect();
    let solid = welding.clamped(&|_| Err(std::io::ErrorKind::NotFound.into())).unwrap();
    let around = Surroundings::new(&machine, &solid).unwrap();
    let conditions =
        Conditions { seed, distortion: Some(&distortion), tracking, replay, around: Some(&around), faults: &[] };
    let (_, summaries, samples) = simulated(&machine, &passes, conditions)?;
    Ok(Weld { machine, summary: summaries[0].clone(), summaries, samples })
}

const SADDLE: &str = include_str!("../../../../examples/saddle.toml");
const T_JOINT: &str = include_str!("../../../../examples/t-joint.toml");
const MISPLACED: &str = include_str!("../../../../examples/distortions/misplaced.toml");

fn keeps_speed_and_acceleration(weld: &Weld) {
    let used = limit_use(&weld.machine, &weld.samples);
    assert!(used[0].0 <= 1.0 && used[1].0 <= 1.0, "{used:?}");
}

/// The jerk of set-points of tracked passes, with the moves before and after them, stays within every axis' limit.
#[test]
fn jerk_stays_within_its_limit() {
    let bent = "schema = 1\n[[displacement]]\nhead = 1\nbend = { most_mm = 2 }\n[[displacement]]\nhead = 2\nshift = { lateral_mm = 1 }\n";
    for (name, job, distortion) in
        [("saddle", SADDLE, MISPLACED), ("t-joint", T_JOINT, bent), ("half-ring", HALF_RING, HALF_RING_MISPLACED)]
    {
        let weld = weld(job, distortion, true, 1).unwrap();
        let begins: Vec<f64> = weld.samples.windows(2).filter(|w| w[0].pass != w[1].pass).map(|w| w[1].set.t).collect();
        let [.., worst] = limit_use(&weld.machine, &weld.samples);
        println!("{name}: {worst:?}, passes change at {begins:?}");
        assert!(worst.0 <= 1.0, "{name}: {worst:?}");
    }
}

/// A saddle that is misplaced by 2 mm and half a degree, oval and wavy, on a machine without a cross slide. Its own
/// axes bring the weld into the joint, and every set-point of every axis is within its limits.
#[test]
fn a_misplaced_saddle_over_the_machines_axes() {
    let tracked = weld(SADDLE, MISPLACED, true, 1).unwrap();
    let plain = weld(SADDLE, MISPLACED, false, 1).unwrap();
    let [head] = &tracked.summary.heads[..] else { panic!("{:?}", tracked.summary.heads) };
    let [other] = &plain.summary.heads[..] else { panic!() };
    assert!(head.tracked && head.stopped_mm.is_none() && head.alarms.is_empty(), "{head:?}");
    assert!(head.miss_p99_mm < 0.05, "{head:?}");
    assert!(!other.tracked && other.miss_p99_mm > 2.0, "{other:?}");
    // The tracked weld's figures for a weld without tracking match that weld.
    assert!((head.untracked_p99_mm - other.miss_p99_mm).abs() < 0.02, "{head:?} {other:?}");
    assert!(plain.summary.path_error_mm.max > 2.0 && tracked.summary.path_error_mm.max < 0.3);
    keeps_speed_and_acceleration(&tracked);
}

/// On a part that lies a little back, an open seam ends before the plan does: no alarm. An end unseen over more than
/// a tack is an alarm.
#[test]
fn the_end_of_an_open_seam_is_no_alarm() {
    let job = include_str!("../../../../examples/first-weld.toml");
    let distortions = (0..12u32).map(|seed| {
        let part = |k: u32| f64::from((seed * 7 + k * 5) % 13) / 4.0 - 1.5;
        let (x, y, z, angle) = (part(0), part(1), part(2), 0.1 * f64::from(seed % 5));
        format!("schema = 1\n[placement]\nshift_mm = [{x}, {y}, {z}]\nturn = [1, 2, -1]\nangle_deg = {angle}\n")
    });
    for (seed, distortion) in (1..).zip(std::iter::once(MISPLACED.to_owned()).chain(distortions)) {
        let weld = weld(job, &distortion, true, seed).unwrap();
        let head = &weld.summary.heads[0];
        assert!(head.alarms.is_empty() && head.miss_p99_mm < 0.05, "{distortion}: {head:?}");
    }
    let hidden = "schema = 1\ntacks_mm = [[230, 270]]\n[placement]\nshift_mm = [1, 0, 0]\n";
    let head = weld(job, hidden, true, 1).unwrap().summary.heads[0].clone();
    assert!(head.alarms.iter().any(|alarm| alarm.alarm.code == "tracking-coasting"), "{head:?}");
}

/// Two fillets that are displaced in different ways, each followed by its own cross slide; the same seed gives the
/// same weld.
#[test]
fn two_fillets_with_their_own_slides() {
    let apart = "schema = 1\n[[displacement]]\nhead = 1\nramp = { from_mm = 0, to_mm = 800, by = { lateral_mm = 2, height_mm = -0.5 } }\n\
                 [[displacement]]\nhead = 2\nwave = { length_mm = 300, by = { lateral_mm = 0.8, height_mm = 0.3 } }\n";
    let first = weld(T_JOINT, apart, true, 3).unwrap();
    assert_eq!(first.summary.heads.len(), 2);
    for head in &first.summary.heads {
        assert!(head.miss_p99_mm < 0.05 && head.untracked_p99_mm > 0.7, "{head:?}");
        assert!(head.stopped_mm.is_none() && head.used.unwrap().iter().all(|used| *used <= 1.0001), "{head:?}");
    }
    keeps_speed_and_acceleration(&first);
    let second = weld(T_JOINT, apart, true, 3).unwrap();
    assert_eq!(format!("{:?}", first.summary), format!("{:?}", second.summary));
    assert_eq!(first.samples.len(), second.samples.len());
}

/// Two passes, each tracked: between them the axes return to the plan, and no set-point jumps. The second sees the
/// same part and is as good as the first.
#[test]
fn two_passes_without_a_jump() {
    let far = "schema = 1\n[placement]\nshift_mm = [1, -1.5, 1]\nturn = [0, 0, 1]\nangle_deg = 0.3\n\
               [[displacement]]\nbend = { most_mm = 1 }\n";
    let weld = welds(SADDLE, far, true, 4, 2).unwrap();
    keeps_speed_and_acceleration(&weld);
    let [first, second] = &weld.summaries[..] else { panic!() };
    let (first, second) = (&first.heads[0], &second.heads[0]);
    assert!(first.miss_p99_mm < 0.05 && second.miss_p99_mm < 0.05, "{first:?} {second:?}");
    assert!((first.untracked_p99_mm - second.untracked_p99_mm).abs() < 1e-9, "{first:?} {second:?}");
    assert!(weld.summaries.iter().all(|s| s.findings(&Tolerance::default(), 1).iter().all(|f| f.allowed)));
}

/// Two heads whose fillets drift apart by more than the slides reach: slowed down, then stopped, without a jump. The
/// weld fails, and the next pass is not welded.
#[test]
fn heads_that_drift_too_far_apart_stop() {
    let apart = "schema = 1\n[[displacement]]\nhead = 1\nramp = { from_mm = 100, to_mm = 1100, by = { lateral_mm = 16 } }\n\
                 [[displacement]]\nhead = 2\nramp = { from_mm = 100, to_mm = 1100, by = { lateral_mm = 16 } }\n";
    let weld = welds(T_JOINT, apart, true, 2, 2).unwrap();
    let [first, second] = &weld.summaries[..] else { panic!() };
    let stopped = first.heads[0].stopped_mm.expect("stopped");
    assert!((500.0..1100.0).contains(&stopped), "{first:?}");
    let told = |what: &str| first.heads.iter().any(|head| head.alarms.iter().any(|a| a.alarm.code == what));
    assert!(told("tracking-near-stroke-end") && told("tracking-stroke-end"), "{first:?}");
    assert!(first.heads.iter().all(|head| head.miss_most_mm < 0.3), "{:?}", first.heads);
    keeps_speed_and_acceleration(&weld);
    assert!(first.findings(&Tolerance::default(), 1).iter().any(|f| f.kind == "stopped" && !f.allowed));
    assert!(second.heads.is_empty() && weld.samples.iter().all(|s| s.pass < 2));
}

#[test]
fn a_joint_that_is_never_seen() {
    let weld = weld(SADDLE, "schema = 1\n[placement]\nshift_mm = [0, 0, 14]\n", true, 1).unwrap();
    let head = &weld.summary.heads[0];
    assert!(head.stopped_mm.is_some_and(|at| at < 50.0), "{head:?}");
    assert!(
        head.alarms.iter().any(|a| a.alarm.code == "tracking-blind")
            && head.alarms.iter().any(|a| a.alarm.code == "tracking-joint-lost")
    );
}

/// A part displaced by more than the slides reach: the gantry that carries them takes over the common part.
#[test]
fn axes_take_over_from_slides_near_their_ends() {
    let far = "schema = 1\n[placement]\nshift_mm = [0, 10, 0]\n\
               [[displacement]]\nwave = { length_mm = 600, by = { lateral_mm = 0.5 } }\n";
    let weld = weld(T_JOINT, far, true, 5).unwrap();
    let y = weld.machine.axis("y").unwrap();
    let moved = weld.samples.iter().filter(|s| s.arc()).map(|s| s.set.q[y]).fold(0.0, |m: f64, y| m.max(y.abs()));
    assert!(moved > 1.0, "{moved}");
    for head in &weld.summary.heads {
        assert!(head.miss_p99_mm < 0.05 && head.untracked_p99_mm > 9.0 && head.stopped_mm.is_none(), "{head:?}");
    }
    keeps_speed_and_acceleration(&weld);
}

/// One head's corrections hardly affect the other, although the carrier of both takes its part.
#[test]
fn heads_do_not_disturb_each_other() {
    let welding = Welding::read("job.toml", T_JOINT).unwrap();
    let machine = Machine::read("m.toml", shipped("dual-laser-10axis").unwrap().text).unwrap();
    let planned_on = machine.with_reserve(RESERVE);
    let around = Surroundings::new(&planned_on, &Clamped::default()).unwrap();
    let path = welding.path(0);
    let passes: [(&dyn TorchPath, &Pass); 1] = [(&path, &welding.program.value.passes[0])];
    let motion = WeldMotion::plan(&planned_on, &around, &passes, 30.0).unwrap();
    let gate = cross_talk(&machine, &passes, &motion, 1).unwrap();
    assert!(gate.is_kept(), "{gate:?}");
}

/// A seam without displacement is welded within its sensor's noise.
#[test]
fn a_part_that_lies_right() {
    let still = weld(SADDLE, "schema = 1\n", true, 2).unwrap();
    let head = &still.summary.heads[0];
    assert!(head.untracked_most_mm < 1e-6 && head.miss_p99_mm < 0.03, "{head:?}");
}

/// A joint that leaves the reach of the machine's correction: the weld stops, and reports the cause.
#[test]
fn what_cannot_be_reached_stops_the_weld() {
    let far = "schema = 1\n[[displacement]]\nwave = { length_mm = 1600, by = { lateral_mm = 12 } }\n";
    let weld = weld(SADDLE, far, true, 1).unwrap();
    let head = &weld.summary.heads[0];
    assert!((100.0..400.0).contains(&head.stopped_mm.expect("stopped")), "{head:?}");
    assert!(head.alarms.iter().any(|a| a.alarm.code == "tracking-stroke-end"), "{head:?}");
    assert!(head.miss_most_mm < 0.5, "{head:?}");
    keeps_speed_and_acceleration(&weld);
    let after = weld.samples.iter().skip_while(|s| !s.arc()).skip_while(|s| s.arc());
    assert!(after.clone().count() > 0 && after.clone().all(|s| !s.arc()), "the arc is off for good");
}

/// A machine without a leading sensor cannot track, and reports the missing key.
#[test]
fn a_machine_that_cannot_see_ahead() {
    let Err(error) = weld(include_str!("../../../../examples/ellipse.toml"), "schema = 1\n", true, 1) else { panic!() };
    assert!(error.to_string().contains("[sensors.<name>]"), "{error}");
}

const HALF_RING: &str = include_str!("../../../../examples/half-ring.toml");
const HALF_RING_MISPLACED: &str = include_str!("../../../../examples/distortions/half-ring.toml");

/// Returns the lateral offset of pass `pass` from the planned line, by path length on the seam, mm.
fn course(weld: &Weld, pass: usize, begin_mm: f64) -> Vec<(f64, f64)> {
    let samples = weld.samples.iter().filter(|s| s.pass == pass && s.travels()).step_by(20);
    samples.filter_map(|s| Some((begin_mm + s.set.profile.s, s.heads[0]?.correction.x))).collect()
}

/// An electron beam looks ahead while it welds a half-ring displaced by 2 mm. Its cosmetic pass, started elsewhere
/// and faster, lies within 0.02 mm of the first one without tracking.
#[test]
fn a_beam_tracks_and_its_cosmetic_pass_replays() {
    let weld = weld(HALF_RING, HALF_RING_MISPLACED, true, 1).unwrap();
    let [first, second] = &weld.summaries[..] else { panic!("{:?}", weld.summaries) };
    for (summary, replays) in [(first, false), (second, true)] {
        let [head] = &summary.heads[..] else { panic!("{summary:?}") };
        let beam = head.beam.as_ref().unwrap();
        assert!(head.tracked && head.lateral_only && beam.replayed == replays, "{head:?}");
        assert!(head.untracked_p99_mm > 1.5 && head.miss_p99_mm < 0.05 && head.stopped_mm.is_none(), "{head:?}");
        assert!(beam.longest_away_ms <= 5.0 && beam.deflected_mm <= beam.range_mm, "{beam:?}");
        assert!(summary.findings(&Tolerance::default(), 1).iter().all(|f| f.allowed), "{summary:?}");
    }
    let (first, second) = (&first.heads[0], &second.heads[0]);
    assert!((1.5..1.72).contains(&first.beam.as_ref().unwrap().away_percent));
    assert!(second.beam.as_ref().unwrap().fit.is_some_and(|fit| fit.points >= 12 && fit.within_mm < 0.15));
    assert!(first.deviations.is_some() && second.deviations.is_none());
    let (tracked, again) = (course(&weld, 1, 0.0), course(&weld, 2, 20.0));
    for (s, lateral) in again {
        let after = tracked.partition_point(|p| p.0 < s).clamp(1, tracked.len() - 1);
        let (a, b) = (tracked[after - 1], tracked[after]);
        let there = a.1 + (s - a.0) / (b.0 - a.0) * (b.1 - a.1);
        assert!((lateral - there).abs() < 0.02 || s > b.0, "{s}: {lateral} {there}");
    }
    keeps_speed_and_acceleration(&weld);
}

/// An axis that the job holds stands still while a beam tracks too; the others bring the weld into the joint.
#[test]
fn held_axes_stand_still_while_a_pass_is_tracked() {
    let held = HALF_RING.replace("position = \"flat\"", "hold = { u = 90 }\nposition = \"flat\"");
    let weld = weld(&held, HALF_RING_MISPLACED, true, 1).unwrap();
    let u = weld.machine.axis("u").unwrap();
    let mut positions = weld.samples.iter().filter(|s| s.travels()).map(|s| s.set.q[u]);
    let first = positions.next().unwrap();
    assert!((first.to_degrees() - 90.0).abs() < 1e-9, "{first}");
    assert!(positions.all(|u| (u - first).abs() < 1e-12));
    let head = &weld.summary.heads[0];
    assert!(head.tracked && head.untracked_p99_mm > 1.5 && head.miss_p99_mm < 0.05, "{head:?}");
}

/// Deviations found by a beam correct another weld of the same part. For a part moved since, they are refused before
/// the beam is on. An invisible joint is refused too.
#[test]
fn stored_deviations_that_fit_and_that_do_not() {
    let found = weld(HALF_RING, HALF_RING_MISPLACED, true, 1).unwrap();
    let record = found.summaries[0].heads[0].deviations.clone().unwrap();
    let record = DeviationRecord::from_csv("stored", &record.to_csv()).unwrap();
    let again = replayed(HALF_RING, HALF_RING_MISPLACED, true, 2, 1, Some(&record)).unwrap();
    for summary in &again.summaries {
        let head = &summary.heads[0];
        assert!(head.miss_p99_mm < 0.05 && head.beam.as_ref().unwrap().replayed, "{head:?}");
    }
    let moved = format!("{HALF_RING_MISPLACED}\n[[displacement]]\nshift = {{ lateral_mm = 0.4 }}\n");
    let hidden = format!("{HALF_RING_MISPLACED}\n").replace("[[150, 155]]", "[[0, 100]]");
    for (distortion, replay, says) in [(moved, Some(&record), "0.4"), (hidden, None, "not seen before the weld")] {
        let weld = replayed(HALF_RING, &distortion, true, 3, 1, replay).unwrap();
        let head = &weld.summaries[0].heads[0];
        assert_eq!(head.stopped_mm, Some(0.0), "{head:?}");
        assert!(head.alarms.iter().any(|a| a.text().contains(says)), "{head:?}");
        assert!(weld.samples.iter().all(|s| !s.arc()), "the beam is never on");
        let findings = weld.summaries[0].findings(&Tolerance::default(), 1);
        assert!(findings.iter().any(|f| f.kind == "stopped" && !f.allowed), "{findings:?}");
    }
}

/// A post blocks the move back to see the start: the move ends before it, and this is reported.
#[test]
fn the_move_to_see_the_start_keeps_clear() {
    let post = "\n[[fixtures]]\nname = \"post\"\nshape.cylinder = { radius_mm = 10, length_mm = 200 }\n\
                at = { move_mm = [290, 68, -120] }\n";
    let open = SADDLE.replace("overlap_mm = 20 ", "end_phi_deg = 180 ");
    let job = format!("{open}{post}");
    let free = weld(&open, "schema = 1\n", true, 1).unwrap();
    assert!(free.summary.heads[0].alarms.is_empty(), "{:?}", free.summary.heads);
    let near = weld(&job, "schema = 1\n", true, 1).unwrap();
    let told = &near.summary.heads[0].alarms[0];
    assert!(told.alarm.code == "cell-sighting-cut-short" && told.text().contains("post"), "{told:?}");
    let back = |weld: &Weld| {
        let start = weld.samples.iter().position(Sample::arc).unwrap();
        let tip = |q| weld.machine.forward(q).point;
        let first = tip(&weld.samples[start].set.q);
        // The approach from home reaches the start first.
        let there = weld.samples.iter().position(|s| tip(&s.set.q).distance(first) < 0.1).unwrap();
        weld.samples[there..start].iter().map(|s| tip(&s.set.q).distance(first)).fold(0.0, f64::max)
    };
    assert!(back(&near) < back(&free) - 1.0, "{} {}", back(&near), back(&free));
}

/// A torch that weaves 4 mm wide is tracked: its line lies in the joint, and the weave swings about it.
#[test]
fn a_woven_pass_is_tracked() {
    let weave = "[weld.weave]\nfigure = \"sine\"\nwidth_mm = 4\nfrequency_hz = 1\nfade_mm = 5\n";
    let job = format!("{SADDLE}\n{weave}");
    let tracked = weld(&job, MISPLACED, true, 1).unwrap();
    let head = &tracked.summary.heads[0];
    assert!(head.miss_p99_mm < 0.05 && head.untracked_p99_mm > 2.0, "{head:?}");
    assert!(head.stopped_mm.is_none() && head.alarms.is_empty(), "{head:?}");
    let used = limit_use(&tracked.machine, &tracked.samples);
    assert!(used.iter().all(|used| used.0 <= 1.0), "{used:?}");
    // The weave swings on top of the correction, 2 mm to each side.
    let welding = Welding::read("job.toml", &job).unwrap();
    let path = welding.path(0);
    let mut widest = 0.0f64;
    for sample in tracked.samples.iter().filter(|s| s.travels()).step_by(50) {
        let (s, head) = (sample.set.profile.s, sample.heads[0].unwrap());
        let swing = path.weave().unwrap().swing(s);
        let off = tracked.machine.forward(&sample.q).point - path.line(s).0 - swing;
        assert!((off.length() - head.correction.length()).abs() < 0.1, "{s}: {off} {}", head.correction);
        widest = widest.max(swing.length());
    }
    assert!((widest - 2.0).abs() < 0.05, "{widest}");
}
