//! Part programs from elsewhere in each dialect: their text, and features that a control lacks.

use crate::text;

use crate::common::{self, Planned};
use glam::DVec3;
use seamwright_machine::{Machine, shipped};
use seamwright_post::{
    Arc, Control, Dialect, Error, Event, Feed, Interpolation, Level, Move, Options, PartProgram, Path, What,
    WriteOptions, write,
};
use seamwright_program::ArcTime;
use std::f64::consts::{FRAC_PI_2, TAU};

fn machine(name: &str, more: &str) -> Machine {
    let text = shipped(name).unwrap().text;
    // Without the file's own settings of controls.
    let text = text.split("\n[controls.").next().unwrap();
    Machine::read("m", &format!("{text}\n{more}")).unwrap()
}

/// A program in the making, its rows by changes.
struct Maker {
    program: PartProgram,
    row: Vec<f64>,
}

impl Maker {
    fn new(control: &Control) -> Self {
        let program = PartProgram::new("Two passes by hand", control.channels.clone());
        Self { row: vec![0.0; control.channels.len()], program }
    }

    fn go(&mut self, path: Path, seconds: f64, changes: &[(&str, f64)]) -> &mut Self {
        self.go_at(Level::Joint, path, seconds, changes, false)
    }

    fn go_at(&mut self, level: Level, path: Path, seconds: f64, changes: &[(&str, f64)], stop: bool) -> &mut Self {
        for (name, value) in changes {
            self.row[self.program.channels.iter().position(|c| c.name == *name).unwrap()] = *value;
        }
        let row = self.program.add_row(&self.row);
        self.program.push(What::Move(Move { path, row, seconds, level, exact_stop: stop }));
        self
    }

    fn arc(&mut self, centre: [f64; 3], normal: DVec3, sweep: f64) -> Path {
        self.program.arcs.push(Arc { centre: DVec3::from_array(centre), normal, sweep });
        Path::Arc(self.program.arcs.len() as u32 - 1)
    }

    fn push(&mut self, what: What) -> &mut Self {
        self.program.push(what);
        self
    }

    fn event(&mut self, event: Event, at_once: bool) -> &mut Self {
        self.push(What::Event { event, at_once })
    }

    fn set(&mut self, name: &str, value: f64, at_once: bool) -> &mut Self {
        let channel = self.program.channels.iter().position(|c| c.name == name).unwrap();
        self.push(What::Set { channel: channel as u16, value, at_once })
    }
}

/// Two passes with all that the dialect has.
fn two_passes(control: &Control) -> PartProgram {
    let mut m = Maker::new(control);
    let pmac = control.dialect == Dialect::Pmac;
    m.push(What::Comment("made by hand".into())).event(Event::Message("clamp the part".into()), true);
    m.push(What::Pass("root".into()));
    m.go(Path::Rapid, 0.0, &[("x", 10.0), ("y", 0.0), ("z", 50.0)]);
    m.go(Path::Line, 5.0, &[("z", 0.0)]);
    m.event(Event::Gas(true), true).push(What::Comment("preflow".into())).push(What::Dwell(0.5));
    m.set("current_a", 180.5, false).event(Event::Arc(true), false);
    let arc = m.arc([0.0, 0.0, 0.0], DVec3::Z, FRAC_PI_2);
    m.go(arc, 3.0, &[("x", 0.0), ("y", 10.0), ("c", 90.0)]);
    m.set("current_a", 170.0, false);
    let helix = m.arc([0.0, 10.0, 5.0], DVec3::NEG_Y, FRAC_PI_2);
    m.go_at(Level::Joint, helix, 4.0, &[("x", 5.0), ("y", 12.0), ("z", 5.0)], true);
    m.go(Path::Line, 1.25, &[("x", 6.000_000_5), ("c", 91.0)]);
    if pmac {
        let speeds = m.program.add_row(&m.row.iter().map(|_| 0.0).collect::<Vec<f64>>());
        m.go(Path::Hermite(speeds), 0.25, &[("x", 6.5), ("a", -1.0)]);
        m.go(Path::Spline, 0.02, &[("x", 6.6)]).go(Path::Spline, 0.02, &[("x", 6.9)]).go(
            Path::Spline,
            0.02,
            &[("x", 7.0)],
        );
    }
    m.event(Event::Arc(false), true).set("current_a", 0.0, true).push(What::Dwell(2.0)).event(Event::Gas(false), true);
    m.go(Path::Line, 5.0, &[("z", 50.0)]);
    m.push(What::Pass("cap (last)".into()));
    m.go(Path::Rapid, 0.0, &[("x", 10.0), ("y", -0.5)]);
    m.event(Event::Output(3, true), true).event(Event::Output(3, false), false);
    m.go(Path::Line, 2.0, &[("x", 20.0)]).go(Path::Line, 2.0, &[("x", 30.0), ("c", 0.0)]);
    m.program
}

#[test]
fn small_programs_look_as_they_should() {
    let machine = machine("table-tilting-xyzac", "");
    for (dialect, file) in [
        (Dialect::Sinumerik, "two_passes.mpf"),
        (Dialect::Linuxcnc, "two_passes.ngc"),
        (Dialect::Grblhal, "two_passes.gcode"),
        (Dialect::Pmac, "two_passes.pmc"),
    ] {
        let control = Control::new(&machine, dialect).unwrap();
        let program = two_passes(&control);
        let options = WriteOptions { machine: machine.title.clone(), rounding_mm: 0.001, ..WriteOptions::default() };
        let written = write(&control, &program, &options).unwrap();
        let path = format!("{}/tests/data/{file}", env!("CARGO_MANIFEST_DIR"));
        if std::env::var_os("SEAMWRIGHT_BLESS").is_some() {
            std::fs::write(&path, &written).unwrap();
        }
        let kept = std::fs::read_to_string(&path).unwrap().replace("{version}", env!("CARGO_PKG_VERSION"));
        assert_eq!(written, kept, "{path}");
        text::read(&control, &written);
        // Feeds along the way: the same times.
        let per_minute = write(&control, &program, &WriteOptions { feed: Feed::PerMinute, ..options }).unwrap();
        let times = |text: &str| text::read(&control, text).times;
        let pairs: Vec<(f64, f64)> = times(&written).into_iter().zip(times(&per_minute)).collect();
        assert!(pairs.iter().all(|(a, b)| (a - b).abs() < 1e-4 * a.max(1e-9)), "{pairs:?}");
    }
}

/// The program of EBW-2004, Fig. 1: decimal commas, process values that go along with the axes.
#[test]
fn the_electron_beam_welder_s_program() {
    let controls = "[controls.sinumerik]\n\
                    axes = { v = \"VG\", q = \"QG\", u = \"V\", w = \"W\" }\n\
                    process = { beam_ma = \"CW\", focus_ma = \"CF\" }\n\
                    decimal_comma = true\n\
                    header = \"FGROUP(X,Y,Z,QG,VG,W,V)\"\n";
    let control = Control::new(&machine("ebw-7axis", controls), Dialect::Sinumerik).unwrap();
    let mut m = Maker::new(&control);
    m.go(Path::Rapid, 0.0, &[("z", 10.0)]);
    m.set("focus_ma", 4.0, true).set("beam_ma", 0.0, true);
    m.row[control.channel("focus_ma").unwrap()] = 4.0;
    m.go(Path::Line, 3.0, &[("z", 19.2), ("w", 20.89), ("focus_ma", 6.0), ("beam_ma", 0.2)]);
    m.go(Path::Line, 3.0, &[("w", 41.78), ("beam_ma", 12.0)]);
    let written = write(&control, &m.program, &WriteOptions::default()).unwrap();
    let code: Vec<&str> = written.lines().filter(|line| !line.starts_with(';')).collect();
    assert_eq!(
        code,
        [
            "FGROUP(X,Y,Z,QG,VG,W,V)",
            "N10 G0 X=0 Y=0 Z=10 VG=0 QG=0 V=0 W=0 CW=0 CF=0",
            "N20 PRESETON(CF,4)",
            "N30 PRESETON(CW,0)",
            "N40 G93 G1 Z=19,2 W=20,89 CW=0,2 CF=6 F=20",
            "N50 G1 W=41,78 CW=12 F=20",
            "N60 G94",
            "N70 M30",
        ]
    );
}

/// Process values that the control interpolates: even in each block's time within half a percent of their span.
#[test]
fn interpolated_values_need_no_steps() {
    let job = std::fs::read_to_string(format!("{}/../../examples/weave.toml", env!("CARGO_MANIFEST_DIR"))).unwrap();
    let stepped = Planned::job(&job);
    let process = "\n[controls.sinumerik]\nprocess = { current_a = \"CA\" }\n";
    let planned = Planned::on(&job, |text| format!("{}{process}", text.split("\n[controls.").next().unwrap()));
    let control = Control::new(&planned.machine, Dialect::Sinumerik).unwrap();
    let program = planned.program(&control, &Options::default()).unwrap();
    let current = control.channel("current_a").unwrap();
    let pass = &planned.welding.program.value.passes[0];
    let motion = &planned.motion.passes[0];
    let sets = |program: &PartProgram, i: usize| {
        program
            .steps
            .iter()
            .filter(|s| matches!(s.what, What::Set { channel, .. } if usize::from(channel) == i))
            .count()
    };
    assert_eq!(sets(&program, current), 2, "set before the arc and after it");
    let plain = Control::new(&stepped.machine, Dialect::Sinumerik).unwrap();
    assert!(sets(&stepped.program(&plain, &Options::default()).unwrap(), plain.channel("current_a").unwrap()) > 100);
    // Against the planned values, at every station within every block.
    let (mut time, mut worst, mut on) = (0.0, 0.0f64, false);
    let begin =
        program.steps.iter().position(|s| matches!(s.what, What::Event { event: Event::Arc(true), .. })).unwrap();
    let off = |s: &seamwright_post::Step| matches!(s.what, What::Event { event: Event::Arc(false), .. });
    let end = begin + program.steps[begin..].iter().position(off).unwrap();
    for (i, way) in common::ways(&program, 0..program.steps.len()) {
        if !(begin..end).contains(&i) {
            continue;
        }
        let moves = way.at(1.0)[..program.axes()] != way.at(0.0)[..program.axes()];
        on |= moves;
        if !on || !moves {
            continue;
        }
        for k in 0..=16 {
            let f = f64::from(k) / 16.0;
            let s = motion.profile.at(time + f * way.step.seconds, &mut 0).s;
            worst = worst.max((way.at(f)[current] - pass.process_at("current_a", s, ArcTime::TRAVEL).unwrap()).abs());
        }
        time += way.step.seconds;
    }
    assert!((time / motion.profile.duration() - 1.0).abs() < 1e-6);
    // The weave's sides have 20 A less.
    assert!(worst < 0.006 * 20.0, "{worst} A");
    text::read(&control, &write(&control, &program, &WriteOptions::default()).unwrap());
}

#[test]
fn what_a_control_cannot_take_is_said_with_step_pass_and_cure() {
    let xyzac = machine("table-tilting-xyzac", "");
    let refused = |dialect: Dialect, make: &dyn Fn(&mut Maker)| {
        let control = Control::new(&xyzac, dialect).unwrap();
        let mut m = Maker::new(&control);
        m.push(What::Pass("root".into())).go(Path::Rapid, 0.0, &[("x", 1.0)]);
        make(&mut m);
        let error = write(&control, &m.program, &WriteOptions::default()).unwrap_err();
        assert!(matches!(error, Error::Unwritable { step: 3, .. }), "{error:?}");
        let error = error.to_string();
        assert!(error.starts_with("step 3 of pass \"root\": ") && error.contains("; "), "{error}");
        error
    };
    let slanted = |m: &mut Maker| {
        let arc = m.arc([0.0, 0.0, 1.0], DVec3::new(1.0, 0.0, 1.0).normalize(), 1.0);
        m.go(arc, 1.0, &[("x", 0.0), ("y", 1.0)]);
    };
    for dialect in [Dialect::Linuxcnc, Dialect::Grblhal] {
        assert!(refused(dialect, &slanted).contains("outside the planes"));
    }
    for dialect in [Dialect::Linuxcnc, Dialect::Grblhal, Dialect::Sinumerik] {
        let hermite = |m: &mut Maker| {
            let path = Path::Hermite(m.program.add_row(&m.row.clone()));
            m.go(path, 1.0, &[("x", 2.0)]);
        };
        assert!(refused(dialect, &hermite).contains("only PMAC"));
        assert!(refused(dialect, &|m| _ = m.go(Path::Spline, 1.0, &[("x", 2.0)])).contains("only PMAC"));
    }
    for dialect in Dialect::ALL {
        assert!(refused(dialect, &|m| _ = m.go(Path::Line, 0.0, &[("x", 2.0)])).contains("takes 0 s"));
        assert!(refused(dialect, &|m| _ = m.event(Event::Call("flip".into()), true)).contains("flip"));
        assert!(refused(dialect, &|m| _ = m.event(Event::Wire(true), true)).contains("wire on"));
    }
    let turns = |m: &mut Maker| {
        let arc = m.arc([0.0, 0.0, 0.0], DVec3::Z, 2.5 * TAU);
        m.go(arc, 1.0, &[("x", -1.0)]);
    };
    assert!(refused(Dialect::Pmac, &turns).contains("more than a turn"));
    let wide = machine("dual-laser-10axis", "");
    for dialect in [Dialect::Linuxcnc, Dialect::Grblhal, Dialect::Pmac] {
        assert!(matches!(Control::new(&wide, dialect), Err(Error::NoLetter { .. })));
    }
    let control = Control::new(&xyzac, Dialect::Grblhal).unwrap();
    let other = PartProgram::new("", Control::new(&wide, Dialect::Sinumerik).unwrap().channels);
    assert!(matches!(write(&control, &other, &WriteOptions::default()), Err(Error::Unwritable { .. })));
}

/// Full turns of arcs are counted as each control counts them.
#[test]
fn arcs_of_several_turns() {
    let machine = machine("table-tilting-xyzac", "");
    for (dialect, word) in [(Dialect::Linuxcnc, "P3"), (Dialect::Grblhal, "P3"), (Dialect::Sinumerik, "TURN=2")] {
        let control = Control::new(&machine, dialect).unwrap();
        let mut m = Maker::new(&control);
        m.go(Path::Rapid, 0.0, &[("x", 1.0)]);
        let arc = m.arc([0.0, 0.0, 0.0], DVec3::NEG_Z, 2.5 * TAU);
        m.go(arc, 1.0, &[("x", -1.0), ("z", 3.0)]);
        let arc = m.arc([0.0, 0.0, 0.0], DVec3::Z, TAU);
        m.go(arc, 1.0, &[]);
        let written = write(&control, &m.program, &WriteOptions::default()).unwrap();
        let lines: Vec<&str> = written.lines().filter(|l| l.contains("G2 ") || l.contains("G3 ")).collect();
        assert!(lines[0].contains(word) && lines[0].contains("G2 "), "{lines:?}");
        assert!(lines[1].contains("G3 ") && !lines[1].contains("TURN") && !lines[1].contains('P'), "{lines:?}");
    }
}

/// If the control can change levels, passes are welded at tip level and transfer moves are made by the axes.
#[test]
fn passes_at_tip_level() {
    let job = std::fs::read_to_string(format!("{}/../../tests/data/passes.toml", env!("CARGO_MANIFEST_DIR"))).unwrap();
    let tip = Options { level: Level::Tip, ..Options::default() };
    let switched = "\n[controls.linuxcnc]\nkinematics_output = 3\n";
    let planned = Planned::on(&job, |text| format!("{}{switched}", text.split("\n[controls.").next().unwrap()));
    for (dialect, on, off) in [
        (Dialect::Sinumerik, "TRAORI", "TRAFOOF"),
        (Dialect::Linuxcnc, "M68 E3 Q1 (words are the tip from here)\nM66 E0 L0", "M68 E3 Q0"),
    ] {
        let control = Control::new(&planned.machine, dialect).unwrap();
        let program = planned.program(&control, &tip).unwrap();
        let written = write(&control, &program, &WriteOptions::default()).unwrap();
        assert_eq!(written.matches(on).count(), 4, "{dialect:?}");
        assert!(written.matches(off).count() >= 4, "{dialect:?}");
        // Every sub-program starts with all axes, on the level of its transfer moves.
        text::read(&control, &written);
    }
    let control = Control::new(&planned.machine, Dialect::Grblhal).unwrap();
    assert!(matches!(planned.program(&control, &tip), Err(Error::TipPasses)));
}

/// Own lines at start and end, own codes, and a spindle word that is a process value.
#[test]
fn templates_codes_and_spindles() {
    let controls = "[controls.grblhal]\n\
                    process = { current_a = \"S\" }\n\
                    header = \"(for {machine}: {title})\\nG21 G90\"\n\
                    footer = \"M30\"\n\
                    [controls.linuxcnc]\n\
                    codes = { M101 = \"gas_on\", M102 = \"gas_off\", M110 = \"flip\" }\n";
    let machine = machine("table-tilting-xyzac", controls);
    let make = |control: &Control| {
        let mut m = Maker::new(control);
        m.go(Path::Rapid, 0.0, &[("x", 1.0)]).event(Event::Gas(true), true).set("current_a", 120.0, true);
        m.set("current_a", 150.5, false).event(Event::Arc(true), false).go(Path::Line, 1.0, &[("x", 2.0)]);
        m.event(Event::Arc(false), true).event(Event::Gas(false), false).go(Path::Line, 1.0, &[("x", 3.0)]);
        m.event(Event::Message("stop".into()), true);
        let options = WriteOptions { machine: "five axes".to_owned(), ..WriteOptions::default() };
        write(control, &m.program, &options).unwrap()
    };
    let grbl = make(&Control::new(&machine, Dialect::Grblhal).unwrap());
    let lines: Vec<&str> = grbl.lines().collect();
    for line in ["S120 (current_a)", "G1 X2 F60 S150.5 M3", "M5 (arc off)", "M63 P1 (gas off)", "M0", "M30"] {
        assert!(lines.contains(&line), "{line} in {grbl}");
    }
    assert!(
        grbl.contains("[for five axes: Two passes by hand]") || grbl.contains("(for five axes: Two passes by hand)")
    );
    assert!(!grbl.contains("G17") && !grbl.contains("M2\n"));
    let cnc = make(&Control::new(&machine, Dialect::Linuxcnc).unwrap());
    let lines: Vec<&str> = cnc.lines().collect();
    for line in ["M101 (gas on)", "G1 X3 F60 M102", "M62 P0 (arc on with the motion)"] {
        assert!(lines.contains(&line), "{line} in {cnc}");
    }
}

/// Splines of PMAC pass the plan at their knots; cubics have speeds of the plan.
#[test]
fn cubics_are_fewer_than_lines() {
    let planned = Planned::example("saddle");
    let control = Control::new(&planned.machine, Dialect::Pmac).unwrap();
    let count = |interpolation, tolerance_mm| {
        let options = Options { interpolation, tolerance_mm, ..Options::default() };
        planned.program(&control, &options).unwrap().steps.iter().filter(|s| matches!(s.what, What::Move(_))).count()
    };
    let (cubic, line) = (count(Interpolation::Pvt, 0.001), count(Interpolation::Linear, 0.001));
    assert!(4 * cubic < line, "{cubic} {line}");
    assert!(count(Interpolation::Pvt, 0.000_1) > cubic);
}
