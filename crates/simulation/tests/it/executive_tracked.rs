//! Tracking under the executive: holds, going back, failing sensors, on a displaced part.

use crate::common::{SADDLE, Script, Tracked, When, at, down, held, in_mode, limit_use, up, weld};
use seamwright_executive::{Alarm, Ask, Mode, Note, Reaction};
use seamwright_motion::Phase;
use seamwright_simulation::Sample;
use seamwright_simulation::devices::{Device, Fault, FaultKind, When as FaultTime};

/// Fifty degrees of the saddle.
fn part() -> Tracked {
    let job = SADDLE
        .replace("overlap_mm = 20", "end_phi_deg = 70")
        .replace("preflow_s = 0.5 ", "overlap_mm = 6\npreflow_s = 0.5 ");
    Tracked::new(&job)
}

fn ends<'a>(mut lines: Vec<(When<'a>, Ask)>) -> Vec<(When<'a>, Ask)> {
    lines.push((Box::new(|c| c.mode == Mode::Ready && c.t > 40.0), Ask::Override(1.0)));
    lines.extend(down());
    lines
}

/// Plays a script to its end: nothing is refused, the program is not left, and set-points of all axes keep speed,
/// acceleration and jerk.
fn play<'a>(part: &Tracked, faults: &[Fault], lines: Vec<(When<'a>, Ask)>) -> (Script<'a>, Vec<Sample>) {
    let mut script = Script::new(ends(lines));
    let (samples, left) = part.play(faults, &mut script);
    assert_eq!((left, script.refused()), (None, vec![]), "{:?}", script.notes);
    let used = limit_use(&part.planned.machine, &samples);
    assert!(used[0].0 <= 1.001 && used[1].0 <= 1.001 && used[2].0 <= 1.01, "{used:?}");
    (script, samples)
}

/// A hold, a way back and a resume with overlap. The correction belongs to the position, no set-point steps, held
/// axes stand still, and the whole weld lies in the joint.
#[test]
fn what_is_held_keeps_its_corrections() {
    let part = part();
    let mut lines: Vec<(When<'_>, Ask)> = up().into_iter().chain(weld()).collect();
    lines.push((at(60.0), Ask::Hold));
    // Waits some seconds.
    let waited = std::cell::Cell::new(0);
    lines.push((Box::new(move |c| waited.replace(waited.get() + 1) > 5000 && c.mode == Mode::Hold), Ask::Arm));
    lines.push((held(), Ask::Resume));
    lines.push((at(110.0), Ask::Hold));
    lines.push((held(), Ask::Reverse));
    lines.push((Box::new(|c| c.mode == Mode::Hold && c.place.s_mm < 90.0), Ask::Hold));
    lines.push((held(), Ask::Arm));
    lines.push((held(), Ask::Resume));
    let (script, samples) = play(&part, &[], lines);
    // The part is shifted along its seam too: the joint ends before the plan.
    let length = part.planned.motion.passes[0].path.length();
    let early = |n: &Note| matches!(n, Note::Alarm(r) if r.reaction != Reaction::Tell || r.place.s_mm < length - 3.0);
    assert!(!script.notes.iter().any(early), "{:?}", script.notes);
    let welded: Vec<&Sample> = samples.iter().filter(|s| s.travels()).collect();
    assert!((welded.last().unwrap().set.profile.s - length).abs() < 0.1);
    let head = |s: &Sample| s.heads[0].unwrap();
    for s in &welded {
        assert!(head(s).miss.length() < 0.06 || s.set.profile.s < 0.5, "{}: {:?}", s.set.profile.s, head(s));
        assert!(head(s).seam.length() > 0.5);
    }
    // Stretches welded twice, and gone back along without the process, have one correction.
    let mut first: Vec<Option<glam::DVec2>> = vec![None; 3000];
    let mut again = 0;
    for s in samples.iter().filter(|s| s.pass == 1 && s.set.profile.s > 1.0) {
        let correction = head(s).correction;
        let cell = &mut first[(10.0 * s.set.profile.s) as usize];
        again += usize::from(cell.is_some());
        assert!(cell.get_or_insert(correction).distance(correction) < 0.05, "{}: {correction}", s.set.profile.s);
    }
    assert!(again > 5000, "{again}");
    // In a hold of some seconds nothing moves after a moment.
    let rests = samples.windows(500).filter(|w| {
        // The crater is filled.
        let held = w.iter().all(|s| s.mode == Mode::Hold && s.pass == 1 && s.set.phase == Phase::Transfer);
        held && w.iter().all(|s| s.set.profile.s.to_bits() == w[0].set.profile.s.to_bits())
    });
    let mut stands = 0;
    for w in rests {
        stands += 1;
        assert!(w[400..].iter().all(|s| s.set.q.map(f64::to_bits) == w[499].set.q.map(f64::to_bits)));
    }
    assert!(stands > 100, "{stands}");
}

/// A sensor falls silent. The alarm names the cause; the torch slows down, then holds with the process off at once.
/// After the repair the torch goes back past the position of the loss, and the weld is finished in the joint.
#[test]
fn a_sensor_that_falls_silent_and_is_mended() {
    let part = part();
    let (at, lasts_s) = (30.0, 20.0);
    let silent = Fault { device: Device::Sensors, kind: FaultKind::Silent, when: FaultTime::At(at), lasts_s, which: 0 };
    let mut lines: Vec<(When<'_>, Ask)> = up().into_iter().chain(weld()).collect();
    lines.push((Box::new(move |c| c.mode == Mode::Hold && c.t > at + lasts_s), Ask::Acknowledge));
    lines.push((held(), Ask::Reverse));
    lines.push((Box::new(|c| c.mode == Mode::Hold && c.place.s_mm < 30.0), Ask::Hold));
    lines.push((held(), Ask::Arm));
    lines.push((held(), Ask::Resume));
    let (script, samples) = play(&part, &[silent], lines);
    let alarms: Vec<_> =
        script.notes.iter().filter_map(|n| if let Note::Alarm(r) = n { Some(*r) } else { None }).collect();
    assert!(alarms.iter().all(|r| r.alarm == Alarm::Tracking), "{alarms:?}");
    let stop = alarms.iter().find(|r| r.reaction == Reaction::ProcessOff).unwrap();
    assert!(alarms[0].reaction == Reaction::Tell && alarms[0].place.s_mm < stop.place.s_mm - 20.0, "{alarms:?}");
    assert_eq!(seamwright_executive::tracking::trouble(stop.detail).unwrap().code, "tracking-joint-lost");
    let after = script.cycles.iter().filter(|c| c.t > stop.t + 1e-9 && c.mode == Mode::Hold);
    assert!(after.clone().count() > 1000 && after.clone().all(|c| !c.on), "off at once");
    let again = samples.iter().filter(|s| s.travels() && s.set.t > at + lasts_s);
    let (mut count, mut worst) = (0, 0.0f64);
    for s in again {
        (count, worst) = (count + 1, worst.max(s.heads[0].unwrap().miss.length()));
    }
    assert!(count > 5000 && worst < 0.1, "{count} {worst}");
}

#[test]
fn a_dry_run_follows_the_joint() {
    let part = part();
    let mut lines = up();
    lines.push((in_mode(Mode::Ready), Ask::StartDryRun));
    let (script, samples) = play(&part, &[], lines);
    assert!(script.cycles.iter().all(|c| !c.on));
    let along: Vec<&Sample> = samples.iter().filter(|s| s.pass == 1 && s.set.profile.s > 1.0).collect();
    let off = along.iter().map(|s| s.heads[0].unwrap().miss.length()).fold(0.0, f64::max);
    assert!(along.len() > 10_000 && off < 0.1, "{off}");
}
