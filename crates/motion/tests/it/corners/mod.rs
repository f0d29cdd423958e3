//! Corners inside a pass: refused, stopped at or blended; checked by walking along set-points and by brute force.

mod random;
pub(crate) mod route;

use crate::planning::{one_span, shipped_machine};
use glam::DVec3;
use route::{Part, Route};
use seamwright_document::Positive;
use seamwright_machine::Machine;
use seamwright_motion::PassMotion;
use seamwright_program::{AtCorner, Finding, OnLimit, Pass, TorchPath};

fn blend(mm: f64) -> AtCorner {
    AtCorner::BlendMm(Positive::new(mm).unwrap())
}

fn pass(length: f64, speed: f64, corner: AtCorner) -> Pass {
    Pass { corner, ..one_span(length, speed) }
}

fn plan(machine: &Machine, route: &Route, speed: f64, corner: AtCorner) -> Result<PassMotion, Vec<Finding>> {
    PassMotion::plan(machine, route, &pass(route.length(), speed, corner), 1)
}

fn of_kind<'a>(findings: &'a [Finding], kind: &str) -> Vec<&'a Finding> {
    findings.iter().filter(|f| f.kind == kind).collect()
}

/// Two lines of 40 mm with a turn between them.
fn bent(turn_deg: f64) -> Route {
    Route::new(DVec3::ZERO, vec![Part::line(0.0, 40.0), Part::line(turn_deg, 40.0)])
}

#[test]
fn a_corner_is_refused_with_both_choices_unless_the_pass_says_what_to_do() {
    let found = plan(&shipped_machine("ellipse-xy"), &bent(90.0), 10.0, AtCorner::Refuse).unwrap_err();
    let stops = of_kind(&found, "stop");
    assert_eq!(stops.len(), 1, "{found:#?}");
    assert!(!stops[0].allowed && (stops[0].from_mm - 40.0).abs() < 1e-9);
    assert!(stops[0].cure_text().contains("corner = \"stop\""), "{}", stops[0].cure_text());
    assert!(stops[0].cure_text().contains("corner = { blend_mm = 0.2 }"), "{}", stops[0].cure_text());
}

#[test]
fn stops_asked_for_are_exact_and_a_note() {
    let (machine, route) = (shipped_machine("ellipse-xy"), bent(90.0));
    let mut asked = pass(80.0, 10.0, AtCorner::Stop);
    // Deceleration to and acceleration from a stop are not findings.
    asked.on_limit = OnLimit::Refuse;
    let motion = PassMotion::plan(&machine, &route, &asked, 1).unwrap();
    let stops = of_kind(&motion.findings, "stop");
    assert!(stops.len() == 1 && stops[0].allowed, "{:#?}", motion.findings);
    assert!(of_kind(&motion.findings, "speed").is_empty(), "{:#?}", motion.findings);
    assert_eq!(motion.profile.legs().len(), 2);
    assert!(
        (motion.profile.legs()[0].to - 40.0).abs() < 1e-9
            && motion.profile.legs()[0].run_down_start > motion.profile.legs()[0].run_up_end
    );
    assert!(motion.path.blends().is_empty());
    assert!(motion.profile.speed(40.0) < 1e-6);
    assert!(machine.forward(&motion.path.at(40.0)).point.distance(route.pose(40.0).point) < 1e-9);
    // A stop is slower than any minimum speed.
    asked.least_speed_mm_s = Positive::new(5.0);
    let found = PassMotion::plan(&machine, &route, &asked, 1).unwrap_err();
    let slow: Vec<&Finding> = of_kind(&found, "least_speed").into_iter().filter(|f| !f.allowed).collect();
    assert!(slow.len() == 1 && slow[0].message.to_string().contains("it stops at a corner"), "{found:#?}");
    asked.corner = blend(0.3);
    PassMotion::plan(&machine, &route, &asked, 1).unwrap();
}

#[test]
fn legs_too_short_for_the_asked_speed_are_told() {
    let route = Route::new(DVec3::ZERO, vec![Part::line(0.0, 60.0), Part::line(90.0, 0.5), Part::line(90.0, 60.0)]);
    let motion = plan(&shipped_machine("ellipse-xy"), &route, 20.0, AtCorner::Stop).unwrap();
    let told = of_kind(&motion.findings, "speed");
    assert_eq!(told.len(), 1, "{told:#?}");
    assert!(told[0].message.to_string().contains("too short") && (told[0].from_mm - 60.0).abs() < 1e-9);
    let mut refuses = pass(route.length(), 20.0, AtCorner::Stop);
    refuses.on_limit = OnLimit::Refuse;
    let found = PassMotion::plan(&shipped_machine("ellipse-xy"), &route, &refuses, 1).unwrap_err();
    assert!(found.iter().filter(|f| !f.allowed).all(|f| f.kind == "speed") && !found.is_empty(), "{found:#?}");
}

#[test]
fn a_right_angle_is_blended_as_wide_as_the_closed_form_says() {
    let (machine, route) = (shipped_machine("ellipse-xy"), bent(90.0));
    for mm in [0.003, 0.02, 0.2, 0.5] {
        let motion = plan(&machine, &route, 30.0, blend(mm)).unwrap();
        let (from, to) = motion.path.blends()[0];
        // The middle of a quintic between straight lines is 3/16 of its half width away from each of them.
        let half = 0.999 * mm * 16.0 / 3.0;
        assert!(
            (from - (40.0 - half)).abs() < 1e-3 * half && (to - (40.0 + half)).abs() < 1e-3 * half,
            "{mm}: {from} {to}"
        );
        assert!(motion.findings.iter().all(|f| f.kind != "stop"));
        let notes = of_kind(&motion.findings, "blend");
        // Deviations below the accuracy of drives get no note.
        assert_eq!(notes.len(), usize::from(0.999 * mm >= 0.005), "{notes:#?}");
        let told = |note: &&Finding| {
            note.message.to_string().contains(&format!("{:.3} mm", 0.999 * mm)) && note.cure.is_none()
        };
        assert!(notes.iter().all(told), "{notes:#?}");
    }
    // Limited to half the distance to the ends of the path.
    let short = Route::new(DVec3::ZERO, vec![Part::line(0.0, 1.0), Part::line(90.0, 40.0)]);
    let (from, to) = plan(&machine, &short, 30.0, blend(0.5)).unwrap().path.blends()[0];
    assert!((from - 0.5).abs() < 1e-9 && (to - 1.5).abs() < 1e-9);
}

#[test]
fn a_blend_is_no_wider_than_the_asked_speed_needs() {
    let (machine, route) = (shipped_machine("ellipse-xy"), bent(90.0));
    let wide = |speed: f64| {
        let mut asked = pass(80.0, speed, blend(0.5));
        asked.on_limit = OnLimit::Refuse;
        let motion = PassMotion::plan(&machine, &route, &asked, 1).unwrap();
        let (from, to) = motion.path.blends()[0];
        to - from
    };
    let widths = [1.0, 2.0, 4.0, 8.0].map(wide);
    assert!(widths.windows(2).all(|w| w[1] > 1.5 * w[0]), "{widths:?}");
    assert!(widths[0] < 0.2 && widths[3] < 2.0 * 0.5 * 16.0 / 3.0, "{widths:?}");
}

#[test]
fn a_rounded_rectangle_goes_round_without_a_stop() {
    let arc = || Part::arc(20.0 * std::f64::consts::FRAC_PI_2, 1.0 / 20.0);
    let sides = [100.0, 60.0, 100.0, 60.0];
    let parts = sides.iter().flat_map(|side| [Part::line(0.0, *side), arc()]).collect();
    let (machine, route) = (shipped_machine("ellipse-xy"), Route::new(DVec3::new(-50.0, -50.0, 0.0), parts));
    let stopping = plan(&machine, &route, 20.0, AtCorner::Stop).unwrap();
    assert_eq!(stopping.profile.legs().len(), 8);
    let motion = plan(&machine, &route, 20.0, blend(0.05)).unwrap();
    assert!(motion.path.blends().len() == 7 && motion.profile.legs().len() == 1);
    let (least, greatest) = motion.certificate.band().unwrap();
    // The profile keeps a reserve of a thousandth and more if the rate of the tip changes.
    assert!(least > 20.0 * (1.0 - 2e-3) && greatest <= 20.0 * (1.0 + 1e-9), "{least} {greatest}");
    let shares = [&motion, &stopping].map(|m| m.certificate.at_asked);
    assert!(shares[0] > 0.95 && shares[0] > shares[1], "{shares:?}");
    assert!(motion.profile.duration() < stopping.profile.duration() - 0.5);
}

#[test]
fn a_torch_that_begins_to_lean_is_a_corner_of_its_axes_only() {
    let lean = [0.01, 0.0];
    let parts = vec![Part::line(0.0, 40.0), Part { lean, ..Part::line(0.0, 20.0) }, Part::line(0.0, 40.0)];
    let (machine, route) = (shipped_machine("torch-5axis"), Route::new(DVec3::new(0.0, 0.0, 300.0), parts));
    let refused = plan(&machine, &route, 10.0, AtCorner::Refuse).unwrap_err();
    assert_eq!(of_kind(&refused, "stop").len(), 2, "{refused:#?}");
    let motion = plan(&machine, &route, 10.0, blend(0.1)).unwrap();
    assert_eq!(motion.path.blends().len(), 2);
    for &(from, to) in motion.path.blends() {
        for k in 0..=200 {
            let s = from + (to - from) * f64::from(k) / 200.0;
            let (torch, asked) = (machine.forward(&motion.path.at(s)), route.pose(s));
            assert!(torch.point.distance(asked.point) <= 0.1 + 1e-9);
            assert!(torch.direction.angle_between(asked.direction) <= 10f64.to_radians());
        }
    }
}

#[test]
fn corners_near_to_each_other_or_to_the_end() {
    let machine = shipped_machine("ellipse-xy");
    let near = Route::new(DVec3::ZERO, vec![Part::line(0.0, 40.0), Part::line(60.0, 0.1), Part::line(60.0, 40.0)]);
    let motion = plan(&machine, &near, 30.0, blend(0.2)).unwrap();
    let [a, b] = [motion.path.blends()[0], motion.path.blends()[1]];
    assert!((a.1 - 40.05).abs() < 1e-9 && (b.0 - 40.05).abs() < 1e-9, "{a:?} {b:?}");
    let last = Route::new(DVec3::ZERO, vec![Part::line(0.0, 40.0), Part::line(90.0, 1e-3)]);
    let found = plan(&machine, &last, 10.0, blend(0.2)).unwrap_err();
    let stops = of_kind(&found, "stop");
    assert!(stops.len() == 1 && !stops[0].allowed, "{found:#?}");
    assert!(
        stops[0].message.to_string().contains("no room for a blend") && stops[0].cure_text().contains("\"stop\""),
        "{stops:#?}"
    );
    let motion = plan(&machine, &last, 10.0, AtCorner::Stop).unwrap();
    assert!(motion.profile.legs().len() == 2 && motion.profile.duration() < 20.0);
}

#[test]
fn a_small_blend_of_a_long_path_keeps_every_limit() {
    let machine = shipped_machine("ellipse-xy");
    let parts = vec![Part::line(0.0, 500.0), Part::line(100.0, 150.0), Part::line(80.0, 900.0), Part::line(-90.0, 0.8)];
    let route = Route::new(DVec3::new(0.0, -50.0, 0.0), parts);
    let motion = plan(&machine, &route, 40.0, blend(0.01)).unwrap();
    assert_eq!(motion.path.blends().len(), 3);
    let rows: Vec<[f64; 2]> = motion.set_points(2e-4).map(|p| [p.q[0], p.q[1]]).collect();
    for (i, axis) in machine.axes.iter().enumerate() {
        let mut row: Vec<f64> = rows.iter().map(|q| q[i]).collect();
        let limits = axis.limits();
        for (order, limit) in [limits.speed, limits.acceleration, limits.jerk].into_iter().enumerate() {
            row = row.windows(2).map(|w| (w[1] - w[0]) / 2e-4).collect();
            let most = row.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
            assert!(most <= limit + 1e-12 / 2e-4f64.powi(order as i32 + 1), "{order}: {most} of {limit}");
        }
    }
}

#[test]
fn a_path_that_turns_back_cannot_be_blended() {
    let machine = shipped_machine("ellipse-xy");
    for (turn, blends) in [(180.0, false), (175.0, false), (160.0, true)] {
        let plan = plan(&machine, &bent(turn), 10.0, blend(0.2));
        assert_eq!(plan.is_ok(), blends, "{turn}");
        if let Err(found) = plan {
            let stops = of_kind(&found, "stop");
            assert!(stops.len() == 1 && stops[0].message.to_string().contains("turns back on itself"), "{found:#?}");
        }
    }
    let motion = plan(&machine, &bent(180.0), 10.0, AtCorner::Stop).unwrap();
    assert_eq!(motion.profile.legs().len(), 2);
}
