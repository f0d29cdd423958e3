//! Woven passes against independent formulas, and faults of weaves in jobs.

#![allow(clippy::float_cmp, reason = "what is copied is the same to the last digit")]

use crate::jobs::{WithSeam, read};
use glam::DVec3;
use proptest::prelude::*;
use seamwright_document::Positive;
use seamwright_program::{Figure, PathRange, TorchPath, Weave};
use seamwright_testkit::cases;
use seamwright_weld::Welding;
use std::f64::consts::TAU;

const SADDLE: &str = include_str!("../../../../examples/saddle.toml");
const TRUNNION: &str = include_str!("../../../../examples/trunnion-saddle.toml");
const WEAVE: &str = include_str!("../../../../examples/weave.toml");
const HILLSIDE: &str = include_str!("../../../../examples/hillside.toml");

fn woven(text: &str, reverse: bool, weave: Option<Weave>) -> Welding {
    let mut program = read(text).program.value;
    let pass = &mut program.passes[0];
    pass.weave = weave;
    if reverse {
        (pass.begin_mm, pass.reverse) = (seamwright_document::NonNegative::new(pass.length()).unwrap(), true);
    }
    read(&program.to_toml().unwrap())
}

fn number(value: f64) -> Positive {
    Positive::new(value).unwrap()
}

fn weave(figure: Figure, width: f64, pitch: f64, fade: f64) -> Weave {
    Weave {
        figure,
        width_mm: number(width),
        length_mm: None,
        pitch_mm: Some(number(pitch)),
        frequency_hz: None,
        dwell_first_s: Default::default(),
        dwell_second_s: Default::default(),
        plane_deg: Default::default(),
        fade_mm: seamwright_document::NonNegative::new(fade).unwrap(),
        at_sides: Default::default(),
    }
}

/// Offset of the figure, in parts, by independent formulas.
fn figure(figure: Figure, phase: f64) -> (f64, f64) {
    let angle = TAU * phase;
    match figure {
        Figure::Circle => (angle.sin(), angle.cos()),
        Figure::Eight => (angle.sin(), (2.0 * angle).sin()),
        _ => (angle.sin(), 0.0),
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(cases(60)))]

    /// The pose is the unwoven one, moved in the plane square to the seam and to the torch and along the seam. The
    /// line, its tangent and its rate are those of the unwoven path; the foot of a point beside it is found.
    #[test]
    fn poses_are_those_of_a_formula(
        job in 0..2usize,
        reverse in any::<bool>(),
        kind in 0..3usize,
        (width, pitch, fade) in (0.5..12.0f64, 0.5..15.0f64, 0.0..30.0f64),
        plane in -80.0..80.0f64,
        parts in prop::collection::vec(0.0..1.0f64, 40),
    ) {
        let text = [SADDLE, TRUNNION][job];
        let asked = [Figure::Sine, Figure::Circle, Figure::Eight][kind];
        let weave = |pitch| {
            let plane_deg = seamwright_document::Finite::new(plane).unwrap();
            Some(Weave { plane_deg, ..weave(asked, width, pitch, fade) })
        };
        let (plain, other) = (woven(text, reverse, None), woven(text, reverse, weave(pitch)));
        let (plain, path) = (plain.path(0), other.path(0));
        let length = path.length();
        for s in parts.iter().map(|part| part * length) {
            let (bare, pose) = (plain.pose(s), path.pose(s));
            prop_assert!(bare.direction == pose.direction);
            let groove = plain.groove(s).unwrap();
            let tangent: DVec3 = groove.tangent;
            let mut aside = bare.direction.cross(tangent).normalize();
            if aside.dot(groove.towards_first) < 0.0 {
                aside = -aside;
            }
            // Lifted towards the torch.
            let aside = plane.to_radians().cos() * aside - plane.to_radians().sin() * bare.direction;
            let (across, along) = figure(asked, s / pitch);
            let t = if fade > 0.0 { (s.min(length - s) / fade.min(0.5 * length)).min(1.0) } else { 1.0 };
            let full = 0.5 * width * (6.0 * t.powi(5) - 15.0 * t.powi(4) + 10.0 * t.powi(3));
            let exact = bare.point + full * (across * aside + along * tangent);
            prop_assert!(pose.point.distance(exact) < 1e-9 * (1.0 + width), "{} {}", pose.point, exact);
            prop_assert!(path.line(s).0.distance(bare.point) < 1e-9);
            prop_assert!(path.line(s).1.distance(plain.line(s).1) < 1e-6 && path.rate(s) == plain.rate(s));
            let inside = s.clamp(1.0, length - 1.0);
            let ahead = path.pose(inside).point + 0.01 * path.line(inside).1;
            prop_assert!((path.foot(ahead, inside, PathRange::up_to(length)) - inside - 0.01).abs() < 1e-4);
        }
        // Half as fast, and not at all.
        let woven_path = path.weave().unwrap();
        let (half, none) = (woven_path.slower(0.5), woven_path.slower(0.0));
        let s = parts[0] * length;
        prop_assert!(none.pose(s) == plain.pose(s) && plain.weave().is_none());
        let twice = woven(text, reverse, weave(2.0 * pitch));
        prop_assert!(half.pose(s).point.distance(twice.path(0).pose(s).point) < 1e-9);
    }
}

#[test]
fn jobs_put_the_weave_into_their_passes() {
    let job = read(WEAVE);
    let pass = &job.program.value.passes[0];
    assert_eq!(pass.weave.as_ref().unwrap().figure, Figure::Trapezoid);
    let again = read(&job.program.value.to_toml().unwrap());
    for s in [0.0, 3.0, 17.3, 60.0, 119.0] {
        assert_eq!(again.path(0).pose(s), job.path(0).pose(s));
    }
    // In a weld of several passes a run has its own, or that of the weld.
    let own =
        HILLSIDE.replacen("7.5, layer_mm = 3.5 }", "7.5, layer_mm = 3.5, weave = { width_mm = 5, pitch_mm = 3 } }", 1);
    let text = format!("{own}\n[weld.weave]\nwidth_mm = 2\npitch_mm = 2\n");
    let job = read(&text);
    for pass in &job.program.value.passes {
        let width = pass.weave.as_ref().unwrap().width_mm.get();
        let cap = pass.role == Some(seamwright_program::Role::Cap);
        assert_eq!(width, if cap { 5.0 } else { 2.0 }, "{}", pass.name);
    }
}

/// With `adapt = "weave_width"` weaves are as wide as the groove less the walls, up to their own width. The deposited
/// metal is as without.
#[test]
fn weaves_are_as_wide_as_the_groove() {
    let weave = "\n[weld.weave]\nwidth_mm = 9\npitch_mm = 3\nfade_mm = 0\n";
    let text = HILLSIDE.replacen("adapt = \"speed\"", "adapt = \"weave_width\"", 1) + weave;
    let (job, plain) = (read(&text), read(&(HILLSIDE.to_owned() + weave)));
    let (joint, plan) = (job.joint.as_ref().unwrap(), job.plan.as_ref().unwrap());
    let (mut narrow, mut wide, mut near) = (f64::INFINITY, 0.0_f64, 0);
    for (k, pass) in job.program.value.passes.iter().enumerate() {
        let path = job.path(k);
        let path = path.along_seam().unwrap();
        // Extreme of the weave to a side: a quarter of a period on.
        for s in (0..200).map(|i| f64::from(i) * 3.0 + 0.75).filter(|s| *s < pass.length()) {
            let at = pass.seam_s(s).rem_euclid(job.seam().length());
            let section = joint.section(&job.seam().at(at)).unwrap();
            let bead = plan.in_order(&section, at)[k];
            // The tip by position in the groove and height, and the walls there.
            let origin = section.place(0.0, 0.0);
            let (aside, up) = (section.place(1.0, 0.0) - origin, section.place(0.0, 1.0) - origin);
            let of = |v: glam::DVec2| (v.dot(aside), v.dot(up));
            let (place, height) = of(bead.tip - origin);
            let (left, right) = section.slices.edges(height);
            let (across, along) = path.woven(s).unwrap();
            // Three quarters of the wire's 1.2 mm from each wall, and no farther, unless it is as wide as it may be.
            let room = (place - across - left).min(right - place - across) - 0.9;
            assert!(along == 0.0 && (room > -0.02 || across.abs() < 0.02), "{room} at {s} of {}", pass.name);
            near += usize::from(room < 0.02);
            (narrow, wide) = (narrow.min(across), wide.max(across));
        }
        let other = &plain.program.value.passes[k];
        assert_eq!((pass.spans.len(), pass.length()), (other.spans.len(), other.length()));
        assert_eq!(pass.speed_at(100.0), other.speed_at(100.0));
        assert!(other.bead.as_ref().unwrap().weave_part.is_empty());
    }
    // Between rows a width may pass its largest by a hundredth.
    assert!(wide > 2.0 * narrow && near > 100 && wide < 4.51, "{narrow} {wide} {near}");
    let text = HILLSIDE.replacen("adapt = \"speed\"", "adapt = \"weave_width\"", 1);
    let e = Welding::read("job.toml", &text).unwrap_err();
    assert!(e.key == "beads.adapt" && e.message.code == "weld-no-bead-weaves", "{e}");
}

#[test]
fn wrong_weaves_in_jobs_have_an_address() {
    let wrong = |from: &str, to: &str| {
        assert!(WEAVE.contains(from), "{from}");
        let e = Welding::read("job.toml", &WEAVE.replacen(from, to, 1)).unwrap_err();
        (e.key.clone(), e.message.clone())
    };
    for (from, to, key, message) in [
        ("frequency_hz = 0.75 ", "pitch_mm = 2\nfrequency_hz = 0.75 ", "weld.weave", "not clear"),
        ("\"trapezoid\"", "\"circle\"", "weld.weave.dwell_first_s", "only a trapezoid dwells"),
        ("{ current_a = 170 }", "{ amps_a = 170 }", "weld.weave.at_sides.amps_a", ""),
        ("speed_mm_s = 2.5", "speed_mm_s = 2.5\ncorner = { blend_mm = 0.2 }", "weld.corner", "cannot be blended"),
        ("speed_mm_s = 2.5", "speed_mm_s = 0.07", "weld.weave.frequency_hz", "would take only 0.0933 mm"),
        (
            "speed_mm_s = 2.5",
            "speed_mm_s = 2.5\noscillation = { across_mm = 1, along_mm = 1, frequency_hz = 1 }",
            "weld.oscillation.along_mm",
            "has no length",
        ),
    ] {
        let (found, said) = wrong(from, to);
        assert!(found == key && said.to_string().contains(message), "{found}: {said}");
    }
}

#[test]
fn gaps_of_an_oscillation_are_findings() {
    let with = |spot: &str| {
        let keys =
            format!("oscillation = {{ figure = \"circle\", across_mm = 1, frequency_hz = 100, spot_mm = {spot} }}");
        read(&WEAVE.replacen("speed_mm_s = 2.5", &format!("speed_mm_s = 2.5\n{keys}"), 1)).findings()
    };
    assert!(with("0.03").iter().all(|f| f.kind != "oscillation"));
    let found = with("0.02");
    let gap = found.iter().find(|f| f.kind == "oscillation").unwrap();
    assert!(
        !gap.allowed && gap.message.to_string().contains("0.0250 mm") && gap.cure_text().contains("125.0000"),
        "{gap:?}"
    );
}
