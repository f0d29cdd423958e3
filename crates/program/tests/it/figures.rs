//! Figures of a weave.

use seamwright_program::{Dwells, Figure, Swing};

const ALL: [Figure; 5] = [Figure::Sine, Figure::Triangle, Figure::Trapezoid, Figure::Circle, Figure::Eight];

#[test]
fn figures_reach_both_sides_and_come_round_smoothly() {
    for figure in ALL {
        let trapezoid = figure == Figure::Trapezoid;
        let dwells = if trapezoid { Dwells { first: 0.2, second: 0.1 } } else { Dwells::NONE };
        let at = |p: f64| figure.at(p, dwells);
        let all: Vec<Swing> = (0..10_000).map(|i| at(f64::from(i) / 1e4)).collect();
        let reach =
            |f: fn(&Swing) -> f64| all.iter().map(f).fold((1.0, -1.0), |(l, h): (f64, f64), x| (l.min(x), h.max(x)));
        let (low, high) = reach(|s| s.across);
        assert!((low + 1.0).abs() < 1e-6 && (high - 1.0).abs() < 1e-6, "{figure:?}");
        let (low, high) = reach(|s| s.along);
        let long = if figure.is_round() { 1.0 } else { 0.0 };
        assert!((low + long).abs() < 1e-6 && (high - long).abs() < 1e-6, "{figure:?}");
        // Second differences are those of a function twice continuously differentiable: no jumps.
        let h = 1e-4;
        let bend = |p: f64| (at(p + h).across - 2.0 * at(p).across + at(p - h).across) / (h * h);
        for i in 0..10_000 {
            let p = f64::from(i) / 1e4;
            assert!((bend(p + h) - bend(p)).abs() < 1.2, "{figure:?} {p}: {} {}", bend(p), bend(p + h));
        }
    }
}

#[test]
fn dwells_last_as_asked() {
    let dwells = Dwells { first: 0.25, second: 0.1 };
    let at = |p: f64| Figure::Trapezoid.at(p, dwells).across;
    let part = |side: f64| (0..100_000).filter(|i| (at(f64::from(*i) / 1e5) - side).abs() < 1e-15).count() as f64 / 1e5;
    assert!((part(1.0) - 0.25).abs() < 1e-3 && (part(-1.0) - 0.1).abs() < 1e-3);
    let knots = Figure::Trapezoid.knots(dwells);
    assert_eq!(knots.iter().map(|p| at(*p)).collect::<Vec<_>>(), [-1.0, 1.0, 1.0, -1.0]);
}
