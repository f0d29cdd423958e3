//! Random programs of points written for every control, read back and made programs again: equal in effect.

use seamwright_document::{Document, Positive};
use seamwright_machine::{Machine, shipped};
use seamwright_post::{
    Control, Dialect, Event, PartProgram, ReadOptions, Segment, What, WriteOptions, play, points_part_program, read,
    to_program, write,
};
use seamwright_program::Program;
use seamwright_testkit::{Random, cases};
use std::f64::consts::TAU;
use std::fmt::Write as _;

/// A number with six decimals, as part programs have them.
fn between(random: &mut Random, low: f64, high: f64) -> f64 {
    (random.within(low, high) * 1e6).round() / 1e6
}

/// A random program of points of the axes x, y, z and two rotary ones, as a document.
fn program(random: &mut Random, dialect: Dialect, machine: &str, rotary: [&str; 2], process: [&str; 2]) -> String {
    let mut text = format!("schema = 1\ntitle = \"random\"\nmachine = \"{machine}\"\n");
    let numbered = dialect == Dialect::Sinumerik && random.yes();
    let mut here = [0.0; 7];
    let mut number = 0.0;
    for pass in 0..=random.below(3) {
        let arc = random.below(4) > 0;
        let _ =
            write!(text, "[[passes]]\nname = \"pass {pass}\"\non_limit = \"slow\"\ncorner = {{ blend_mm = 0.1 }}\n");
        let preflow = if random.yes() { between(random, 0.1, 2.0) } else { 0.0 };
        let delay = if arc && random.yes() { between(random, 0.1, 2.0) } else { 0.0 };
        let _ = write!(text, "sequence = {{ preflow_s = {preflow}, travel_delay_s = {delay} }}\n[passes.points]\n");
        let n = if numbered { ", \"n\"" } else { "" };
        let names = format!(
            "\"x\", \"y\", \"z\", \"{}\", \"{}\", \"{}\", \"{}\"",
            rotary[0], rotary[1], process[0], process[1]
        );
        let _ = writeln!(text, "columns = [{names}{n}, \"time_s\"]\narc = {arc}");
        if dialect != Dialect::Sinumerik {
            let _ = writeln!(text, "stepped = [\"{}\", \"{}\"]", process[0], process[1]);
        }
        let row = |values: &[f64; 7], number: f64, seconds: f64| {
            let mut numbers: Vec<String> = values.iter().map(f64::to_string).collect();
            numbers.extend(numbered.then(|| number.to_string()));
            numbers.push(seconds.to_string());
            format!("[{}]", numbers.join(", "))
        };
        let _ = writeln!(text, "start = {}", row(&here, 0.0, 0.0));
        let _ = writeln!(text, "events = [{{ after = 0, output = {}, on = {} }}]", 5 + pass, random.yes());
        // With the arc off there is at least one rapid move, which distinguishes the pass from one with the arc.
        let spans = 1 + random.below(6);
        for span in 0..spans {
            let mut next = here;
            for (i, value) in next.iter_mut().enumerate() {
                if random.below(3) > 0 {
                    *value = if i < 5 { between(random, -80.0, 80.0) } else { between(random, 0.0, 300.0) };
                }
            }
            // Passes that only rest are the rests of others.
            if span == 0 {
                next[0] = ((here[0] + between(random, 0.1, 20.0)) * 1e6).round() / 1e6;
            }
            let seconds = between(random, 0.05, 20.0);
            number += 1.0;
            let kind = random.below(if dialect == Dialect::Pmac { 5 } else { 4 });
            let stops = kind != 0 && random.below(5) == 0;
            match kind {
                0 if span == 0 && !arc || dialect != Dialect::Sinumerik => {
                    next[5..].copy_from_slice(&here[5..]);
                    let _ = writeln!(
                        text,
                        "[[passes.points.spans]]\nalong = \"rapid\"\npoints = [{}]",
                        row(&next, number, 0.0)
                    );
                }
                1 | 2 => {
                    // A circle or helix in one of the planes, or anywhere if the control can.
                    let plane = random.below(3);
                    let (u, v) = ((plane + 1) % 3, (plane + 2) % 3);
                    let (radius, from) = (between(random, 0.5, 60.0), TAU * random.unit());
                    let sweep = (0.02 + 0.96 * random.unit()) * 6.0 * if random.yes() { 1.0 } else { -1.0 };
                    let rise = if random.yes() { between(random, -20.0, 20.0) } else { 0.0 };
                    let at = |f: f64| {
                        let mut p = [here[0], here[1], here[2]];
                        p[u] += radius * ((from + f * sweep).cos() - from.cos());
                        p[v] += radius * ((from + f * sweep).sin() - from.sin());
                        p[plane] += f * rise;
                        p.map(|x| (x * 1e6).round() / 1e6)
                    };
                    let (via, end) = (at(0.5), at(1.0));
                    next[..3].copy_from_slice(&end);
                    let mut normal = [0.0; 3];
                    normal[plane] = 1.0;
                    let _ = writeln!(
                        text,
                        "[[passes.points.spans]]\nalong = \"arc\"\nvia_mm = {via:?}\nnormal = {normal:?}\npoints = [{}]",
                        row(&next, number, seconds)
                    );
                }
                4 => {
                    let speeds = |random: &mut Random| {
                        let v: Vec<String> = (0..5).map(|_| between(random, -5.0, 5.0).to_string()).collect();
                        format!("[{}]", v.join(", "))
                    };
                    // Begins and ends at rest, so that blocks beside it fit.
                    let _ = writeln!(
                        text,
                        "[[passes.points.spans]]\nalong = \"cubic\"\nspeeds = [[0, 0, 0, 0, 0], {}, [0, 0, 0, 0, 0]]\npoints = [{}, {}]",
                        speeds(random),
                        row(&next, number, (seconds * 1e3).round() / 1e3),
                        row(&here, number, (seconds * 1e3).round() / 1e3 + 1.0)
                    );
                    next = here;
                }
                _ => {
                    let _ = writeln!(
                        text,
                        "[[passes.points.spans]]\nalong = \"line\"\nstops = {stops}\npoints = [{}]",
                        row(&next, number, seconds)
                    );
                }
            }
            here = next;
        }
    }
    text
}

/// A block: how long it takes, and the segments it consists of.
type Block = (f64, Vec<Segment>);

/// Everything that takes time or goes somewhere; rests with the same values next to each other are one.
fn blocks(program: &PartProgram, start: &[f64]) -> Vec<Block> {
    let mut all: Vec<Block> = Vec::new();
    for segment in play(program, start).into_iter().filter(|s| s.seconds > 0.0 || s.start() != s.end()) {
        let rests = |s: &Segment| s.start() == s.end();
        match all.last_mut() {
            Some((time, parts)) if rests(&segment) && rests(&parts[0]) && parts[0].end() == segment.end() => {
                *time += segment.seconds;
            }
            _ => all.push((segment.seconds, vec![segment])),
        }
    }
    all
}

fn outputs(control: &Control, program: &PartProgram) -> Vec<Event> {
    let event = |what: &What| match what {
        What::Event { event: Event::Arc(_), .. } if !control.switches_arc() => None,
        What::Event { event, .. } => Some(event.clone()),
        _ => None,
    };
    let mut all: Vec<Event> = program.steps.iter().filter_map(|s| event(&s.what)).collect();
    all.dedup();
    // Outputs that are off are switched off at the start of every pass.
    let mut on = false;
    all.retain(|event| !matches!(event, Event::Arc(arc) if std::mem::replace(&mut on, *arc) == *arc));
    all
}

/// Maximum difference of two plays, sampled at the same parts of the same blocks: an arc may be two in the second.
fn difference(a: &[Block], b: &[Block], about: &str) -> f64 {
    let (mut one, mut other, mut most) = (Vec::new(), Vec::new(), 0.0f64);
    let mut rest = b.iter();
    for (seconds, segments) in a {
        let mut parts: Vec<&Block> = Vec::new();
        let time = |parts: &[&Block]| parts.iter().map(|b| b.0).sum::<f64>();
        while parts.is_empty() || time(&parts) < seconds - 1e-6 * (1.0 + seconds) {
            parts.push(rest.next().unwrap_or_else(|| panic!("too few blocks: {about}")));
        }
        let whole = time(&parts);
        assert!((whole - seconds).abs() < 1e-7 * (1.0 + whole), "{whole} {seconds}\n{about}");
        for f in [0.0, 0.11, 0.37, 0.73, 0.94, 1.0] {
            segments[0].at(f, &mut one);
            let (mut t, mut k) = (f * whole, 0);
            while k + 1 < parts.len() && t > parts[k].0 {
                t -= parts[k].0;
                k += 1;
            }
            parts[k].1[0].at(if whole > 0.0 { t / parts[k].0 } else { f }, &mut other);
            let here = one.iter().zip(&other).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max);
            assert!(here < 1e-6, "{here:e} at {f} of a block: {one:?} {other:?}\n{about}");
            most = most.max(here);
        }
    }
    assert!(rest.next().is_none(), "too many blocks: {about}");
    most
}

fn round_trip(dialect: Dialect, name: &str, rotary: [&str; 2], process: [&str; 2]) {
    let machine = Machine::read(name, shipped(name).unwrap().text).unwrap();
    let control = Control::new(&machine, dialect).unwrap();
    let mut start = vec![0.0; control.channels.len()];
    for (i, axis) in machine.axes.iter().enumerate() {
        start[i] = axis.to_file(axis.home);
    }
    let mut random = Random::new(dialect as u8);
    let (mut compared, mut worst) = (0, 0.0f64);
    for case in 0..cases(250) {
        let text = program(&mut random, dialect, name, rotary, process);
        let program: Document<Program> = Program::read("p.toml", &text).unwrap_or_else(|e| panic!("{e}\n{text}"));
        let Some(part) = points_part_program(&machine, &control, &program.value) else {
            panic!("case {case} is not posted as it stands\n{text}")
        };
        let written = write(&control, &part, &WriteOptions::default());
        let written = written.unwrap_or_else(|e| panic!("case {case}: {e}\n{text}"));
        let options = ReadOptions { start: Some(start.clone()), ..ReadOptions::default() };
        let back = read(&control, "p", &written, &options).unwrap_or_else(|e| panic!("case {case}: {e}\n{written}"));
        let again = to_program(&machine, &control, &back.program, &start, name, Positive::new(0.1).unwrap());
        let again = match again {
            Ok(again) => again,
            Err(_) => continue,
        };
        let toml = again.to_toml().unwrap();
        let again = Program::read("q.toml", &toml).unwrap_or_else(|e| panic!("case {case}: {e}\n{written}")).value;
        let part_again = points_part_program(&machine, &control, &again);
        let part_again = part_again.unwrap_or_else(|| panic!("case {case}: not as it stands any more\n{toml}"));
        let (a, b) = (blocks(&part, &start), blocks(&part_again, &start));
        worst = worst.max(difference(&a, &b, &format!("case {case}\n{text}\n{written}\n{toml}")));
        assert_eq!(outputs(&control, &part), outputs(&control, &part_again), "case {case}\n{written}\n{toml}");
        compared += 1;
    }
    assert!(compared > cases(250) * 9 / 10 && worst < 1e-6, "{compared} {worst}");
}

#[test]
fn sinumerik() {
    round_trip(Dialect::Sinumerik, "ebw-7axis", ["u", "w"], ["beam_a", "focus_a"]);
}

#[test]
fn linuxcnc() {
    round_trip(Dialect::Linuxcnc, "table-tilting-xyzac", ["a", "c"], ["current_a", "voltage_v"]);
}

#[test]
fn grblhal() {
    round_trip(Dialect::Grblhal, "table-tilting-xyzac", ["a", "c"], ["current_a", "voltage_v"]);
}

#[test]
fn pmac() {
    round_trip(Dialect::Pmac, "table-tilting-xyzac", ["a", "c"], ["current_a", "voltage_v"]);
}
