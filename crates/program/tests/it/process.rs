//! Process values: ramps and slopes, and values that are refused.

use seamwright_program::{ArcTime, Program};

const TEXT: &str = "schema = 1\ntitle = \"t\"\nmachine = \"m\"\n[seam.nozzle]\nradius_mm = 250\n\
    [seam.nozzle.body.cylinder]\nradius_mm = 800\n[[passes]]\nname = \"root\"\n[passes.sequence]\n\
    travel_delay_s = 0.5\nupslope = { time_s = 0.4, process = { beam_ma = 10 } }\n\
    crater_s = 1\ndownslope = { time_s = 0.5, process = { beam_ma = 5 } }\n\
    [[passes.spans]]\nfrom_mm = 0\nto_mm = 10\nspeed_mm_s = 5\n\
    process = { beam_ma = { from = 20, to = 60 }, lens_ma = 700 }\n\
    [[passes.spans]]\nfrom_mm = 10\nto_mm = 20\nspeed_mm_s = 8\nprocess = { beam_ma = 60, lens_ma = 700 }\n";

#[test]
fn ramps_and_slopes_have_their_values() {
    let program = Program::read("p.toml", TEXT).unwrap().value;
    assert_eq!(Program::read("p.toml", &program.to_toml().unwrap()).unwrap().value, program);
    let pass = &program.passes[0];
    let at = |s: f64, since_on_s: f64, until_off_s: f64| {
        pass.process_at("beam_ma", s, ArcTime { since_on_s, until_off_s }).unwrap()
    };
    let far = f64::INFINITY;
    for (s, value) in [(0.0, 20.0), (2.5, 30.0), (10.0 - 1e-12, 60.0), (10.0, 60.0), (15.0, 60.0), (20.0, 60.0)] {
        assert!((at(s, far, far) - value).abs() < 1e-9, "{s}");
    }
    // Upslope: from 10 when the arc goes on to the 20 at the start of the weld, after 0.4 s.
    for (since, value) in [(0.0, 10.0), (0.1, 12.5), (0.4, 20.0), (0.5, 20.0)] {
        assert!((at(0.0, since, far) - value).abs() < 1e-12);
    }
    // Downslope: the last half second down to 5.
    for (until, value) in [(1.0, 60.0), (0.5, 60.0), (0.25, 32.5), (0.0, 5.0)] {
        assert!((at(20.0, far, until) - value).abs() < 1e-12);
    }
    let at_once = ArcTime { since_on_s: 0.0, until_off_s: 0.0 };
    assert_eq!(pass.process_at("lens_ma", 3.0, at_once), Some(700.0));
    assert_eq!(pass.process_at("voltage_v", 3.0, at_once), None);
}

#[test]
fn values_that_no_machine_has_are_refused() {
    let arc = TEXT.replace("beam_ma", "current_a").replace("lens_ma = 700", "voltage_v = 27, wire_feed_m_min = 8");
    assert!(Program::read("p.toml", &arc).is_ok());
    let wrong = |from: &str, to: &str| {
        assert!(arc.contains(from), "{from}");
        let e = Program::read("p.toml", &arc.replace(from, to)).unwrap_err();
        println!("{e}");
        (e.key, e.allowed.map_or_else(String::new, |allowed| allowed.to_string()))
    };
    let at = |name: &str| format!("passes[0].spans[0].process.{name}");
    assert_eq!(wrong("voltage_v = 27", "voltage_v = 2700"), (at("voltage_v"), "0 to 100".to_owned()));
    assert_eq!(wrong("to = 60 }", "to = 60000 }"), (at("current_a.to"), "0 to 3000".to_owned()));
    assert_eq!(wrong("feed_m_min = 8", "feed_m_min = 800"), (at("wire_feed_m_min"), "0 to 100".to_owned()));
    let twice = wrong("feed_m_min = 8", "feed_m_min = 8, wire_feed_mm_s = 99");
    assert_eq!(twice, (at("wire_feed_mm_s"), "either wire_feed_m_min or wire_feed_mm_s".to_owned()));
    let slope = wrong("process = { current_a = 5 }", "process = { current_a = 50000 }").0;
    assert_eq!(slope, "passes[0].sequence.downslope.process.current_a");
}

#[test]
fn what_beams_have_is_no_arc() {
    // Without a current of an arc a voltage may be that of a gun, also in V; a coil's current is its own quantity.
    let beam = TEXT.replace("lens_ma = 700", "lens_ma = 700, voltage_v = 60000");
    assert!(Program::read("p.toml", &beam).is_ok());
    let e = Program::read("p.toml", &TEXT.replace("lens_ma = 700", "accelerating_kv = 600")).unwrap_err();
    assert_eq!(e.allowed.as_ref().map(ToString::to_string).as_deref(), Some("0 to 300"));
}

#[test]
fn wrong_ramps_have_an_address() {
    let wrong = |from: &str, to: &str| {
        assert!(TEXT.contains(from));
        let e = Program::read("p.toml", &TEXT.replacen(from, to, 1)).unwrap_err();
        println!("{e}");
        (e.key, e.allowed.map_or_else(String::new, |allowed| allowed.to_string()))
    };
    let key = |from: &str, to: &str| wrong(from, to).0;
    assert_eq!(key("from = 20, to", "from = -20, to"), "passes[0].spans[0].process.beam_ma.from");
    assert_eq!(key("to = 60 }", "to = -60 }"), "passes[0].spans[0].process.beam_ma.to");
    assert_eq!(key("beam_ma = 60,", "beam_ma = -60,"), "passes[0].spans[1].process.beam_ma");
    let (at, allowed) = wrong("{ from = 20, to = 60 }", "\"20\"");
    assert!(at.ends_with("beam_ma") && allowed.contains("{ from = .., to = .. }"), "{at} {allowed}");
    assert!(key("to = 60 }", "to = nan }").ends_with("beam_ma.to"));
    assert!(key("to = 60 }", "too = 60 }").contains("beam_ma"));
    assert!(key(", to = 60 }", " }").contains("beam_ma"));
    assert_eq!(key("time_s = 0.4", "time_s = 0.6"), "passes[0].sequence.upslope.time_s");
    assert_eq!(key("time_s = 0.5", "time_s = 1.1"), "passes[0].sequence.downslope.time_s");
    assert_eq!(key("time_s = 0.4", "time_s = 0"), "passes[0].sequence.upslope.time_s");
    let (at, allowed) = wrong("process = { beam_ma = 5 }", "process = { current_a = 5 }");
    assert_eq!((at.as_str(), allowed.as_str()), ("passes[0].sequence.downslope.process.current_a", "beam_ma, lens_ma"));
    assert!(key("beam_ma = 10 }", "beam_ma = -10 }").contains("upslope"));
}
