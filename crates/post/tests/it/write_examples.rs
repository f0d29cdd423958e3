//! Every example in every dialect that fits its machine: the text is the planned motion and takes as long. The tip
//! stays within the tolerance on every way of the control from row to row.

use crate::text;

use crate::common::{Planned, passes, ways};
use seamwright_post::{
    Control, Dialect, Event, Feed, Interpolation, Level, Options, PartProgram, Path, ReadOptions, What, WriteOptions,
    read, verify, write,
};
use seamwright_program::PathRange;

const TOLERANCE: f64 = 0.01;

fn variants(dialect: Dialect) -> Vec<Options> {
    let of = |interpolation| Options { tolerance_mm: TOLERANCE, interpolation, ..Options::default() };
    match dialect {
        Dialect::Pmac => vec![of(Interpolation::Pvt), of(Interpolation::Spline1), of(Interpolation::Linear)],
        Dialect::Sinumerik => vec![of(Interpolation::Linear), of(Interpolation::Poly)],
        _ => vec![of(Interpolation::Linear)],
    }
}

/// The tip's maximum distance from the planned path, and the times of all passes against the plan's.
fn follows(planned: &Planned, program: &PartProgram, head: usize) -> f64 {
    let mut worst = 0.0f64;
    for (range, motion) in passes(program).into_iter().zip(&planned.motion.passes) {
        let path = motion.tip_path(&planned.machine);
        let welds = range.clone().find(|i| is_arc(&program.steps[*i].what, true)).unwrap();
        let ends = range.clone().find(|i| *i > welds && is_arc(&program.steps[*i].what, false)).unwrap();
        let dwells: f64 =
            program.steps[welds..ends].iter().map(|step| if let What::Dwell(s) = step.what { s } else { 0.0 }).sum();
        let mut time = 0.0;
        let mut last = 0.0;
        for (step, way) in ways(program, range).iter().filter(|(i, _)| (welds..ends).contains(i)) {
            let checks = if matches!(way.step.path, Path::Arc(_) | Path::Hermite(_) | Path::Curve(_)) { 64 } else { 5 };
            for k in 0..=checks {
                let f = f64::from(k) / f64::from(checks);
                let tip = way.tip(&planned.machine, head, f);
                let s = motion.profile.at(time + f * way.step.seconds, &mut 0).s;
                let away = if head == 0 {
                    let foot = path.foot(tip, s, PathRange::up_to(path.length()));
                    tip.distance(planned.machine.forward(&motion.path.at(foot)).point)
                } else {
                    let near = (-20..=20).map(|k| (s + 0.01 * f64::from(k)).clamp(0.0, path.length()));
                    near.map(|s| tip.distance(planned.machine.forward_of(head, &motion.path.at(s)).point))
                        .fold(f64::INFINITY, f64::min)
                };
                assert!(away < 1.0, "step {step}: {away}");
                worst = worst.max(away);
            }
            time += way.step.seconds;
            last = f64::max(last, way.step.seconds);
        }
        assert!((time / motion.profile.duration() - 1.0).abs() < 1e-5, "{time} {}", motion.profile.duration());
        assert!(((time + dwells) / motion.arc_on_s() - 1.0).abs() < 1e-3, "{dwells}");
    }
    worst
}

/// The crate's own proof: read back by its reader, the same blocks, within tolerance of the plan.
fn proven(planned: &Planned, control: &Control, program: &PartProgram, options: &Options, feed: Feed) {
    let written = write(control, program, &WriteOptions { feed, ..WriteOptions::default() }).unwrap();
    let start = vec![0.0; control.channels.len()];
    let read_options = ReadOptions { level: options.level, ..ReadOptions::default() };
    let back = read(control, "p", &written, &read_options).unwrap_or_else(|e| panic!("{e}"));
    let of = planned.within(control, options);
    let proof = verify(program, &back.program, &start, of).unwrap_or_else(|wrong| panic!("{wrong:?}"));
    assert_eq!(proof.passes.len(), planned.motion.passes.len());
    for pass in &proof.passes {
        assert!(pass.tip_mm <= TOLERANCE + 1e-5 && pass.time_percent.abs() < 0.1, "{pass:?}");
    }
}

/// Each difference from the request is found: a position, a feed, an output, a missing block.
#[test]
fn a_wrong_text_is_no_proof() {
    let planned = Planned::example("saddle");
    let control = Control::new(&planned.machine, Dialect::Linuxcnc).unwrap();
    let options = Options::default();
    let program = planned.program(&control, &options).unwrap();
    let written = write(&control, &program, &WriteOptions::default()).unwrap();
    let start = vec![0.0; control.channels.len()];
    let of = planned.within(&control, &options);
    let judged =
        |text: &str| verify(&program, &read(&control, "p", text, &ReadOptions::default()).unwrap().program, &start, of);
    assert!(judged(&written).is_ok());
    let lines: Vec<&str> = written.lines().collect();
    let block = lines.iter().rposition(|line| line.starts_with("G1 ")).unwrap() - 20;
    let changed = |line: &str| {
        let mut lines = lines.clone();
        lines[block] = line;
        lines.join("\n")
    };
    let (head, feed) = lines[block].rsplit_once(" F").unwrap();
    assert!(judged(&changed("")).is_err());
    assert!(judged(&changed(&format!("{head} F{}", 1.01 * feed.parse::<f64>().unwrap()))).is_err());
    let (word, rest) = lines[block].split_once(' ').unwrap();
    let (place, rest) = rest.split_once(' ').unwrap();
    let moved = format!("{word} {}{} {rest}", &place[..1], place[1..].parse::<f64>().unwrap() + 0.002);
    assert!(judged(&changed(&moved)).is_err(), "{moved}");
    assert!(judged(&written.replace("M65 P0 (arc off)", "")).is_err());
    assert!(judged(&written.replace("M64 P1 (gas on)", "")).is_err());
    // A coarser program than was allowed.
    let strict = seamwright_post::Planned { tolerance_mm: 1e-4, ..of };
    let back = read(&control, "p", &written, &ReadOptions::default()).unwrap();
    assert!(
        verify(&program, &back.program, &start, strict).unwrap_err()[0].to_string().contains("leaves the planned path")
    );
}

/// Inside blocks, too, the tip has the planned speed, within the requested bound. The proof has the deviation there,
/// not only that of whole blocks. Speeds here are differences over a thousandth of a block.
#[test]
fn inside_blocks_the_tip_keeps_its_speed() {
    const BOUND: f64 = 0.5;
    for (name, tolerance_mm) in
        [("head-nozzle", TOLERANCE), ("head-nozzle", 0.2), ("saddle", 0.1), ("trunnion-saddle", 0.1)]
    {
        let planned = Planned::example(name);
        for dialect in [Dialect::Linuxcnc, Dialect::Grblhal, Dialect::Sinumerik, Dialect::Pmac] {
            let Ok(control) = Control::new(&planned.machine, dialect) else { continue };
            for options in variants(dialect) {
                let options = Options { tolerance_mm, speed_percent: BOUND, ..options };
                let program = planned.program(&control, &options).unwrap();
                let found = speed_inside(&planned, &program);
                assert!(found <= BOUND, "{name}, {tolerance_mm} mm, {options:?}: {found} %");
                let written = write(&control, &program, &WriteOptions::default()).unwrap();
                let back = read(&control, "p", &written, &ReadOptions::default()).unwrap();
                let (of, start) = (planned.within(&control, &options), vec![0.0; control.channels.len()]);
                let proof = verify(&program, &back.program, &start, of).unwrap();
                let told = proof.passes[0].speed_inside_percent;
                assert!(told >= 0.9 * found - 0.02, "{name}, {options:?}: {told} of {found} %");
                let worst = told.max(proof.passes[0].speed_percent);
                assert!(proof.lines()[1].contains(&format!("speed {worst:.2} %")), "{:?}", proof.lines());
                let strict = seamwright_post::Planned { speed_percent: 0.5 * found, ..of };
                if found > 0.05 {
                    let wrong = verify(&program, &back.program, &start, strict).unwrap_err();
                    assert!(wrong[0].to_string().contains("speed inside a block"), "{wrong:?}");
                }
            }
        }
    }
}

/// Maximum deviation of the tip's speed from the planned one inside blocks longer than 10 ms, percent. Compared between
/// the acceleration and deceleration phases of the only pass.
fn speed_inside(planned: &Planned, program: &PartProgram) -> f64 {
    let (range, motion) = (passes(program).remove(0), &planned.motion.passes[0]);
    let band = motion.profile.report();
    let welds = range.clone().find(|i| is_arc(&program.steps[*i].what, true)).unwrap();
    let ends = range.clone().find(|i| *i > welds && is_arc(&program.steps[*i].what, false)).unwrap();
    let (mut time, mut worst) = (0.0, 0.0f64);
    for (_, way) in ways(program, range).iter().filter(|(i, _)| (welds..ends).contains(i)) {
        let seconds = way.step.seconds;
        for k in (0..24).filter(|_| seconds > 0.01) {
            let f = (f64::from(k) + 0.5) / 24.0;
            let h = 5e-4;
            let p = motion.profile.at(time + f * seconds, &mut 0);
            if p.s < band.run_up_end + 0.5 || p.s > band.run_down_start - 0.5 {
                continue;
            }
            let [before, after] = [f - h, f + h].map(|f| way.tip(&planned.machine, 0, f));
            let speed = before.distance(after) / (2.0 * h * seconds);
            worst = worst.max((speed / motion.tip_speed(&planned.machine, p) - 1.0).abs());
        }
        time += seconds;
    }
    100.0 * worst
}

fn is_arc(what: &What, on: bool) -> bool {
    matches!(what, What::Event { event: Event::Arc(is), .. } if *is == on)
}

/// Written and read back: the same rows, the same times.
fn reads_back(control: &Control, program: &PartProgram, feed: Feed) -> usize {
    let options = WriteOptions { machine: "m".to_owned(), feed, rounding_mm: 0.001, remarks: Vec::new() };
    let written = write(control, program, &options).unwrap();
    let read = text::read(control, &written);
    let all = ways(program, 0..program.steps.len());
    let mut rows: Vec<(&[f64], f64)> = Vec::new();
    let mut dwells = 0.0;
    for step in &program.steps {
        match step.what {
            What::Move(m) => rows.push((program.row(m.row), m.seconds)),
            What::Dwell(s) => dwells += s,
            _ => {}
        }
    }
    assert!((read.dwells / dwells - 1.0).abs() < 1e-9 || dwells == 0.0);
    // Rapid moves to where it is already are not written.
    let mut k = 0;
    let mut most = 0.0f64;
    for (row, seconds) in rows {
        let axes = program.axes();
        let there = k > 0 && read.rows[k - 1][..axes] == row[..axes];
        if seconds == 0.0 && there {
            continue;
        }
        assert_eq!(read.rows[k][..axes], row[..axes], "move {k}");
        most = most.max((read.times[k] / seconds - 1.0).abs());
        assert!(
            seconds == 0.0 || (read.times[k] / seconds - 1.0).abs() < 1e-4,
            "{} {seconds} move {k} {:?} {feed:?}",
            read.times[k],
            control.dialect
        );
        k += 1;
    }
    assert_eq!(k, read.rows.len());
    assert!(read.lines < 40 * passes(program).len() + 4 * all.len(), "{} lines", read.lines);
    k
}

/// An example; of a seam that is welded in many passes a sixth, of a thick girth a thin one.
fn job(name: &str) -> String {
    let path = format!("{}/../../examples/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(path).unwrap();
    let changes: &[(&str, &str)] = match name {
        "thick-saddle" => &[("overlap_mm = 20", "end_phi_deg = 80")],
        "hillside" => &[("overlap_mm = 10", "end_phi_deg = 150")],
        "narrow-gap-girth" => &[("radius_mm = 1200", "radius_mm = 450"), ("thickness_mm = 60", "thickness_mm = 16")],
        _ => &[],
    };
    changes.iter().fold(text, |text, (whole, part)| {
        assert!(text.contains(whole), "{whole}");
        text.replace(whole, part)
    })
}

fn check(name: &str) {
    let planned = Planned::job(&job(name));
    let mut fits = 0;
    for dialect in Dialect::ALL {
        let Ok(control) = Control::new(&planned.machine, dialect) else { continue };
        for options in variants(dialect) {
            let program = planned.program(&control, &options).unwrap();
            let heads = planned.machine.heads.len();
            let worst = (0..heads).map(|head| follows(&planned, &program, head)).fold(0.0, f64::max);
            assert!(worst <= TOLERANCE + 2e-5, "{name} {dialect:?} {options:?}: {worst}");
            if options.interpolation == Interpolation::Poly && control.decimal_comma {
                let error = write(&control, &program, &WriteOptions::default()).unwrap_err().to_string();
                assert!(error.contains("decimal commas"), "{error}");
                continue;
            }
            // The reader of these tests knows no polynomials.
            if options.interpolation != Interpolation::Poly {
                let moves = reads_back(&control, &program, Feed::InverseTime);
                assert_eq!(moves, reads_back(&control, &program, Feed::PerMinute));
                println!("{name} {dialect:?} {:?}: {moves} moves, {worst:.5} mm", options.interpolation);
            }
            for feed in [Feed::InverseTime, Feed::PerMinute] {
                proven(&planned, &control, &program, &options, feed);
            }
            fits += 1;
        }
    }
    let least = if name == "t-joint" { 1 } else { 3 };
    assert!(fits >= least, "{name}: {fits}");
}

macro_rules! examples {
    ($($test:ident $name:literal),* $(,)?) => { $( #[test] fn $test() { check($name); } )* };
}

examples!(
    ellipse "ellipse", head_nozzle "head-nozzle", hillside "hillside", knuckle_nozzle "knuckle-nozzle",
    narrow_gap_girth "narrow-gap-girth",
    oblique_girth "oblique-girth", radiator "radiator", saddle "saddle", set_in_nozzle "set-in-nozzle",
    t_joint "t-joint", taught_saddle "taught-saddle", thick_saddle "thick-saddle", trunnion_saddle "trunnion-saddle",
    tube_plate "tube-plate", weave "weave", y_branch "y-branch",
);

/// At tip level the words are the tip's positions.
#[test]
fn tip_level() {
    let planned = Planned::example("trunnion-saddle");
    for dialect in Dialect::ALL {
        let control = Control::new(&planned.machine, dialect).unwrap();
        for options in variants(dialect) {
            let options = Options { level: Level::Tip, ..options };
            let program = planned.program(&control, &options).unwrap();
            let worst = follows(&planned, &program, 0);
            assert!(worst <= TOLERANCE + 2e-5, "{dialect:?} {options:?}: {worst}");
            if options.interpolation == Interpolation::Poly {
                proven(&planned, &control, &program, &options, Feed::InverseTime);
            } else {
                println!(
                    "{dialect:?} {:?}: {}",
                    options.interpolation,
                    reads_back(&control, &program, Feed::InverseTime)
                );
            }
        }
    }
}
