//! Weaves: phases, process values along them, wrong ones, and their way back to a file.

#![allow(clippy::float_cmp, reason = "values at the sides are exactly those")]

use seamwright_program::{ArcTime, Dwells, Figure, Pass, Program, Weaving};

const TEXT: &str = "schema = 1\ntitle = \"t\"\nmachine = \"m\"\n[seam.nozzle]\nradius_mm = 250\n\
    [seam.nozzle.body.cylinder]\nradius_mm = 800\n[[passes]]\nname = \"root\"\n[passes.weave]\n\
    width_mm = 8\nfrequency_hz = 1.5\nfigure = \"trapezoid\"\ndwell_first_s = 0.15\ndwell_second_s = 0.1\n\
    at_sides = { current_a = 150 }\n\
    [[passes.spans]]\nfrom_mm = 0\nto_mm = 40\nspeed_mm_s = 3\nprocess = { current_a = 200 }\n\
    [[passes.spans]]\nfrom_mm = 40\nto_mm = 90\nspeed_mm_s = { from = 3, to = 5 }\nprocess = { current_a = 200 }\n\
    [[passes.spans]]\nfrom_mm = 90\nto_mm = 120\nspeed_mm_s = { from = 5, to = 5.00000001 }\n\
    process = { current_a = { from = 200, to = 180 } }\n";

fn pass(text: &str) -> Pass {
    Program::read("p.toml", text).unwrap().value.passes.remove(0)
}

#[test]
fn phases_are_the_integral_of_frequency_over_speed() {
    let pass = pass(TEXT);
    let weaving = Weaving::new(&pass).unwrap();
    // Midpoints of many small steps: second order.
    let (steps, length) = (120_000, 120.0);
    let h = length / f64::from(steps);
    let mut sum = 0.0;
    for i in 0..steps {
        let s = h * f64::from(i);
        assert!((weaving.phase(s) - sum).abs() < 1e-7, "{s}: {} {sum}", weaving.phase(s));
        let knot = weaving.offset(s).0 - 4.0 * pass.swing_at(s);
        assert!(knot.abs() < 1e-9, "{s}");
        sum += h * 1.5 / pass.speed_at(s + 0.5 * h);
    }
    // Knots are where the figure's are.
    let knots = weaving.knots();
    let at_figure = knots.iter().filter(|s| {
        let phase = weaving.phase(**s).rem_euclid(1.0);
        let figure = Figure::Trapezoid.knots(Dwells { first: 0.225, second: 0.15 });
        figure.iter().chain(&[1.0]).any(|knot| (phase - knot).abs() < 1e-9)
    });
    let all = 4.0 * weaving.phase(length);
    assert!((at_figure.count() as f64 - all).abs() < 4.0 && knots.len() as f64 > all);
    assert!(knots.is_sorted());
    let slow = weaving.faster(0.5);
    assert!((slow.phase(100.0) - 0.5 * weaving.phase(100.0)).abs() < 1e-12);
}

#[test]
fn process_values_follow_the_square_of_the_swing() {
    let pass = pass(TEXT);
    let current = |s: f64| pass.process_at("current_a", s, ArcTime::TRAVEL).unwrap();
    let mut sides = 0;
    for i in 0..9000 {
        let s = 0.01 * f64::from(i);
        let swing = pass.swing_at(s);
        assert!((current(s) - (200.0 - 50.0 * swing * swing)).abs() < 1e-9);
        if swing.abs() == 1.0 {
            assert_eq!(current(s), 150.0);
            sides += 1;
        }
    }
    // The dwells are 0.25 s of 0.667 s, between the fades.
    assert!((f64::from(sides) / 8500.0 - 0.375).abs() < 0.02, "{sides}");
    assert_eq!(current(0.0), 200.0);
}

#[test]
fn wrong_weaves_have_an_address() {
    let wrong = |from: &str, to: &str| {
        assert!(TEXT.contains(from), "{from}");
        let e = Program::read("p.toml", &TEXT.replacen(from, to, 1)).unwrap_err();
        (e.key.trim_start_matches("passes[0].").to_owned(), e.message)
    };
    for (from, to, key, code) in [
        ("frequency_hz = 1.5", "", "weave", "program-weave-pitch-unclear"),
        ("frequency_hz = 1.5", "frequency_hz = 1\npitch_mm = 2", "weave", "program-weave-pitch-unclear"),
        ("\"trapezoid\"", "\"sine\"", "weave.dwell_first_s", "program-only-trapezoid-dwells"),
        ("frequency_hz = 1.5", "pitch_mm = 2", "weave.dwell_first_s", "program-dwell-needs-frequency"),
        ("= 0.15", "= 0.6", "weave.dwell_first_s", "program-dwells-too-long"),
        ("width_mm = 8", "width_mm = 8\nlength_mm = 2", "weave.length_mm", "program-figure-without-length"),
        ("{ current_a = 150", "{ voltage_v = 20", "weave.at_sides.voltage_v", "document-unknown-name"),
        ("{ current_a = 150", "{ current_a = -1", "weave.at_sides.current_a", "program-process-value-negative"),
        ("{ from = 3, to = 5 }", "4", "spans[1].speed_mm_s", "program-weave-speed-jumps"),
        ("\"root\"", "\"root\"\ncorner = { blend_mm = 0.2 }", "corner", "program-weave-at-blend"),
        ("= 0.15\ndwell_second_s = 0.1", "= 0", "weave.width_mm", ""),
    ] {
        if key == "weave.width_mm" {
            let e = Program::read("p.toml", &TEXT.replacen("width_mm = 8", "width_mm = 0", 1)).unwrap_err();
            assert!(e.key.ends_with("weave.width_mm"), "{e}");
            continue;
        }
        let (found, message) = wrong(from, to);
        assert_eq!((found.as_str(), message.code.as_ref()), (key, code), "{message}");
    }
    let fast = TEXT.replacen("= 0.15\ndwell_second_s = 0.1", "= 0", 1).replacen("1.5", "40", 1);
    let e = Program::read("p.toml", &fast).unwrap_err();
    assert_eq!(e.key, "passes[0].weave.frequency_hz");
    assert!(e.message.to_string().contains("0.0750 mm") && e.allowed.unwrap().to_string().contains("30.0000 Hz"));
}

#[test]
fn programs_come_back_as_they_were_and_without_a_weave_have_no_word_of_it() {
    let program = Program::read("p.toml", TEXT).unwrap().value;
    let text = program.to_toml().unwrap();
    assert_eq!(Program::read("p.toml", &text).unwrap().value, program);
    let mut plain = program;
    plain.passes[0].weave = None;
    let text = plain.to_toml().unwrap();
    assert!(!text.contains("weave") && !text.contains("oscillation"), "{text}");
}
