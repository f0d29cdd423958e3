//! Windows on ramps against closed forms and dense sampling; heat input against closed forms and integration.

use seamwright_document::Finite;
use seamwright_program::{Outside, Procedure, ProcessValue, ProcessValues, Ramp, WeldingProcess, Window};
use seamwright_testkit::{Random, cases};

fn window(least: f64, greatest: f64) -> Window {
    let text = format!("w = [{least:?}, {greatest:?}]");
    toml::from_str::<std::collections::BTreeMap<String, Window>>(&text).unwrap()["w"]
}

#[test]
fn a_ramp_leaves_its_window_exactly_where_it_crosses() {
    let mut random = Random::new(11);
    let mut with = 0;
    for _ in 0..cases(20_000) {
        let [from, to] = [random.within(0.0, 300.0), random.within(0.0, 300.0)];
        let (a, b) = (random.within(0.0, 900.0), random.within(1000.0, 2000.0));
        let least = random.within(0.0, 200.0);
        let greatest = least + random.within(1.0, 100.0);
        let value = |s: f64| from + (to - from) * (s - a) / (b - a);
        let found = window(least, greatest).outside(&[a, b], value);
        let place = |v: f64| a + (v - from) / (to - from) * (b - a);
        let mut wanted: Vec<(f64, f64, f64, bool)> = Vec::new();
        let (low, high) = (from.min(to), from.max(to));
        let end = |v: f64| if v.to_bits() == from.to_bits() { a } else { b };
        for (limit, worst, out, above) in [(least, low, low < least, false), (greatest, high, high > greatest, true)] {
            let back = if above { low > greatest } else { high < least };
            let (one, other) = (end(worst), if back { a + b - end(worst) } else { place(limit) });
            wanted.extend(out.then(|| (one.min(other), one.max(other), worst, above)));
        }
        assert_eq!(found.len(), wanted.len(), "{from} {to} {least} {greatest}: {found:?}");
        for (f, w) in found.iter().zip(&wanted) {
            let close = (f.from_mm - w.0).abs() < 1e-8 && (f.to_mm - w.1).abs() < 1e-8;
            assert!(close && (f.found - w.2).abs() < 1e-12 && f.above == w.3, "{f:?} {w:?}");
        }
        with += found.len();
        dense(&found, (a, b), |s| value(s) < least || value(s) > greatest);
    }
    assert!(with > 1000);
}

/// Each of many positions is outside the window exactly if it is in a stretch, except positions at its ends.
fn dense(found: &[Outside], (a, b): (f64, f64), outside: impl Fn(f64) -> bool) {
    for i in 0..=60 {
        let s = a + (b - a) * f64::from(i) / 60.0;
        let edge = found.iter().any(|f| (s - f.from_mm).abs() < 1e-6 || (s - f.to_mm).abs() < 1e-6);
        let stretch = found.iter().any(|f| s >= f.from_mm && s <= f.to_mm);
        assert!(edge || stretch == outside(s), "{s} {found:?}");
    }
}

#[test]
fn a_value_on_its_limit_is_within() {
    let w = window(200.0, 240.0);
    assert!(w.outside(&[0.0, 9.0], |_| 240.0).is_empty() && w.outside(&[0.0, 9.0], |_| 240.0 + 1e-9).is_empty());
    assert_eq!(w.outside(&[0.0, 9.0], |_| 240.001).len(), 1);
    let steps = [0.0, 1.0, 2.0, 3.0];
    let found = w.outside(&steps, |s| if s < 1.5 { 100.0 } else { f64::INFINITY });
    assert_eq!(found.iter().map(|f| f.above).collect::<Vec<_>>(), [false, true]);
    assert!(
        found[1].found.is_infinite() && (found[0].to_mm - 1.5).abs() < 1e-12 && (found[1].from_mm - 1.5).abs() < 1e-12
    );
}

fn procedure(lines: &str) -> Procedure {
    let text = format!("schema = 1\nnumber = \"n\"\ntitle = \"t\"\n{lines}\n[[runs]]\npasses = \"1\"\n");
    Procedure::read("p.toml", &text).unwrap_or_else(|e| panic!("{e}")).value
}

fn values(of: &[(&str, f64, f64)]) -> ProcessValues {
    let ramp = |from, to| Ramp { from: Finite::new(from).unwrap(), to: Finite::new(to).unwrap() };
    of.iter().map(|(name, from, to)| ((*name).to_owned(), ProcessValue::Ramp(ramp(*from, *to)))).collect()
}

#[test]
fn heat_input_by_hand() {
    let arc = values(&[("current_a", 240.0, 240.0), ("voltage_v", 27.0, 27.0)]);
    // k U I / v: 240 A x 27 V / 10 mm/s = 648 J/mm of arc energy.
    for (process, heat) in [(121, 0.648), (135, 0.5184), (136, 0.5184), (111, 0.5184), (141, 0.3888), (15, 0.3888)] {
        let p = procedure(&format!("process = {process}"));
        let found = p.heat_input_kj_mm(p.power_w(&arc, 0.3).unwrap(), 10.0);
        assert!((found - heat).abs() < 1e-15, "{process}: {found}");
    }
    let p = procedure("process = 135\nthermal_efficiency = 0.75");
    assert!((p.heat_input_kj_mm(p.power_w(&arc, 0.0).unwrap(), 10.0) - 0.486).abs() < 1e-15);
    let beam = values(&[("beam_ma", 45.0, 45.0), ("accelerating_kv", 60.0, 60.0), ("current_a", 1.0, 1.0)]);
    let p = procedure("process = 51");
    assert!((p.power_w(&beam, 0.5).unwrap() - 2700.0).abs() < 1e-9);
    assert!((p.heat_input_kj_mm(2700.0, 15.0) - 0.18).abs() < 1e-15);
    let laser = values(&[("laser_w", 3000.0, 5000.0), ("head_kw", 3.0, 3.0)]);
    assert!((procedure("process = 52").power_w(&laser, 0.5).unwrap() - 4000.0).abs() < 1e-9);
    assert!((procedure("process = 52\npower = [\"head_kw\"]").power_w(&laser, 0.5).unwrap() - 3000.0).abs() < 1e-9);
    assert_eq!(procedure("process = 135").power_w(&laser, 0.5), None);
    assert!(procedure("process = 135").heat_input_kj_mm(5000.0, 0.0).is_infinite());
}

#[test]
fn energy_of_ramps_is_their_integral() {
    // The energy of a pass with U and I ramping along it at constant speed: by Simpson's rule (exact for a quadratic)
    // from the heat input, and in closed form.
    let mut random = Random::new(12);
    for _ in 0..cases(2000) {
        let [i0, i1, u0, u1] = [300.0, 300.0, 40.0, 40.0].map(|most| random.within(0.0, most));
        let (length, speed) = (random.within(1.0, 2000.0), random.within(1.0, 30.0));
        let p = procedure("process = 135");
        let ramps = values(&[("current_a", i0, i1), ("voltage_v", u0, u1)]);
        let heat = |part: f64| p.heat_input_kj_mm(p.power_w(&ramps, part).unwrap(), speed);
        let simpson = length / 6.0 * (heat(0.0) + 4.0 * heat(0.5) + heat(1.0));
        let mean = (2.0 * i0 * u0 + i0 * u1 + i1 * u0 + 2.0 * i1 * u1) / 6.0;
        let exact = 0.8 * mean * (length / speed) / 1000.0;
        assert!((simpson - exact).abs() < 1e-12 * exact.max(1.0), "{simpson} {exact}");
    }
}

#[test]
fn processes_have_their_usual_values() {
    for (number, k) in [(111, 0.8), (121, 1.0), (131, 0.8), (135, 0.8), (136, 0.8), (138, 0.8), (141, 0.6), (15, 0.6)] {
        assert!((WeldingProcess::of(number).unwrap().thermal_efficiency - k).abs() < 1e-15);
    }
    let p = procedure("process = 136");
    assert!((p.deposition_efficiency() - 0.85).abs() < 1e-15);
    assert!((procedure("process = 136\ndeposition_efficiency = 0.9").deposition_efficiency() - 0.9).abs() < 1e-15);
    assert!(WeldingProcess::all().iter().all(|p| p.thermal_efficiency <= 1.0 && p.deposition_efficiency <= 1.0));
}
