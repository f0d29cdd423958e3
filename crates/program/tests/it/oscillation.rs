//! Oscillation of a beam.

use seamwright_document::DocumentError;
use seamwright_program::{Pass, Program};
use std::f64::consts::TAU;

fn text(oscillation: &str) -> String {
    format!(
        "schema = 1\ntitle = \"t\"\nmachine = \"m\"\n[seam.circle]\nradius_mm = 100\n\
         [[passes]]\nname = \"beam\"\n[passes.oscillation]\n{oscillation}\n\
         [[passes.spans]]\nfrom_mm = 0\nto_mm = 100\nspeed_mm_s = 10\n"
    )
}

fn pass(oscillation: &str) -> Result<Pass, DocumentError> {
    Program::read("p.toml", &text(oscillation)).map(|mut p| p.value.passes.remove(0))
}

#[test]
fn the_beam_draws_its_figure_on_the_moving_work() {
    let circle = pass("figure = \"circle\"\nacross_mm = 2\nalong_mm = 1\nfrequency_hz = 500").unwrap();
    let circle = circle.oscillation.unwrap();
    for i in 0..100 {
        let periods = 0.03 * f64::from(i);
        let (across, along) = circle.on_work(periods, 10.0);
        let (sin, cos) = (TAU * periods).sin_cos();
        assert!((across - sin).abs() < 1e-12 && (along - 0.5 * cos - 0.02 * periods).abs() < 1e-12);
    }
}

#[test]
fn gaps_are_told_with_the_frequency_that_closes_them() {
    let with = |spot: &str| pass(&format!("across_mm = 2\nfrequency_hz = 500\n{spot}")).unwrap();
    let gaps = |pass: &Pass| pass.oscillation.unwrap().gaps(pass.speeds().1);
    assert!(gaps(&with("")).is_none() && gaps(&with("spot_mm = 0.02")).is_none());
    let (message, cure) = gaps(&with("spot_mm = 0.0199")).unwrap();
    assert!(message.to_string().contains("0.0200 mm") && cure.to_string().contains("502.5126 Hz"), "{message} {cure}");
}

#[test]
fn wrong_oscillations_have_an_address() {
    for (keys, key) in [
        ("across_mm = 0\nfrequency_hz = 1", "across_mm"),
        ("across_mm = 1\nfrequency_hz = -1", "frequency_hz"),
        ("across_mm = 1\nalong_mm = 1\nfrequency_hz = 1", "along_mm"),
        ("figure = \"zigzag\"\nacross_mm = 1\nfrequency_hz = 1", "figure"),
        ("across_mm = 1\nfrequency_hz = 1\nspot_mm = 0", "spot_mm"),
    ] {
        let e = pass(keys).unwrap_err();
        assert_eq!(e.key, format!("passes[0].oscillation.{key}"), "{e}");
    }
    let e = pass("across_mm = 1").unwrap_err();
    assert!(e.to_string().contains("frequency_hz"), "{e}");
}
