//! Self-tests of machine files: shipped files pass, planted mistakes are found, reach agrees with closed forms.

use seamwright_machine::check::{Check, CheckOptions, Remark, Side, remarks};
use seamwright_machine::{Clamped, Machine, MachineFile, SHIPPED, Surroundings, shipped};
use seamwright_message::Message;
use std::f64::consts::PI;

fn checked(text: &str, poses: u32) -> Check {
    let machine = Machine::read("m.toml", text).unwrap();
    let file = MachineFile::read("m.toml", text).unwrap();
    let mut steps = 0;
    let options = CheckOptions { seed: 3, poses };
    let check = Check::run(&file, &machine, &options, &mut || steps += 1);
    assert!(steps <= Check::steps(&machine, &options) && steps >= u64::from(poses));
    check
}

fn remarked(text: &str) -> Vec<Remark> {
    remarks(&MachineFile::read("m.toml", text).unwrap(), &Machine::read("m.toml", text).unwrap())
}

fn changed(name: &str, from: &str, to: &str) -> String {
    let text = shipped(name).unwrap().text;
    assert!(text.contains(from), "{from}");
    text.replacen(from, to, 1)
}

#[test]
fn machines_that_ship_pass_without_remarks() {
    for s in SHIPPED {
        let check = checked(s.text, 3000);
        assert!(check.passed && check.failures.is_empty(), "{}: {:?}", s.name, check.failures);
        assert!(check.remarks.is_empty(), "{}: {:?}", s.name, check.remarks);
        assert_eq!(check.pair.is_some(), s.name == "dual-laser-10axis");
        let numeric = check.heads.iter().any(|h| !h.structure.to_string().starts_with("closed form"));
        assert!(!numeric, "{}", check.heads[0].structure);
        assert!(check.heads.iter().all(|h| h.round_trip.solutions >= 6000 && h.jacobian.relative < 1e-8));
    }
    let structure = checked(shipped("ebw-7axis").unwrap().text, 1).heads[0].structure.to_string();
    assert_eq!(structure, "closed form: 3 linear (x, y, z) + 2 rotary (v, q); redundant: u, w");
}

#[test]
fn the_same_seed_finds_the_same() {
    let text = shipped("table-tilting-xyzac").unwrap().text;
    assert_eq!(checked(text, 200), checked(text, 200));
}

#[test]
fn planted_slips_are_found() {
    let torch = "torch-5axis";
    for (name, from, to, key, why) in [
        // mm/min, m/s, rad/s, deg/min.
        (torch, "max_speed_mm_s = 100", "max_speed_mm_s = 6000", "tool[0].max_speed_mm_s", "faster"),
        ("saddle-4axis", "max_speed_mm_s = 50", "max_speed_mm_s = 3000", "tool[2].max_speed_mm_s", "never reaches"),
        (torch, "max_speed_mm_s = 100", "max_speed_mm_s = 0.1", "tool[0].max_speed_mm_s", "slower"),
        ("ebw-7axis", "max_speed_deg_s = 20", "max_speed_deg_s = 0.35", "tool[4].max_speed_deg_s", "slower"),
        (torch, "max_speed_deg_s = 60", "max_speed_deg_s = 3600.5", "tool[3].max_speed_deg_s", "faster"),
        // m/s^2, and far too large.
        (torch, "acceleration_mm_s2 = 500", "acceleration_mm_s2 = 0.5", "tool[0].max_acceleration_mm_s2", "200 s"),
        (torch, "acceleration_mm_s2 = 500", "acceleration_mm_s2 = 150000", "tool[0].max_acceleration_mm_s2", "0.6"),
        (torch, "max_jerk_mm_s3 = 5000", "max_jerk_mm_s3 = 5", "tool[0].max_jerk_mm_s3", "100 s"),
        (torch, "max_jerk_mm_s3 = 5000\n", "\n", "tool[0]", "no jerk limit"),
        // rad, turns, m.
        (torch, "range_deg = [-80, 80]", "range_deg = [-3.14, 3.14]", "tool[3].range_deg", "quarter turns in rad"),
        (torch, "range_deg = [-80, 80]", "range_deg = [-1.396, 1.396]", "tool[3].range_deg", "-79.9849° to 79.9849°"),
        (torch, "range_deg = [-80, 80]", "range_deg = [-40000, 40000]", "tool[3].range_deg", "222.2222 turns"),
        (torch, "range_mm = [-800, 800]", "range_mm = [-80000, 80000]", "tool[0].range_mm", "160 m"),
        (torch, "servo_period_ms = 1", "servo_period_ms = 0.001", "servo_period_ms", "every 0.001 ms"),
        (torch, "move_mm = [0, 0, 250]", "move_mm = [0, 0, 250000]", "tool[2].fixed", "100 m"),
        // Drives.
        (torch, "mass_kg = 60", "mass_kg = 60000", "drives.y.peak_force_n", "needs 30055 N"),
        (torch, "mass_kg = 300", "mass_kg = 0.3\npeak_force_n = 250000 #", "drives.x.mass_kg", "times as strong"),
        (torch, "counts_per_mm = 1000", "counts_per_mm = 1", "drives.y.encoder_counts_per_mm", "one count is 1 mm"),
    ] {
        let mut text = changed(name, from, to);
        if to.contains('#') {
            text = text.replacen("\npeak_force_n = 2500\n", "\n", 1);
        }
        let remarks = remarked(&text);
        let found: Vec<_> = remarks.iter().filter(|r| r.key == key).collect();
        assert!(found.len() == 1 && found[0].why.to_string().contains(why), "{to}: {remarks:?}");
        let line = text.lines().nth(found[0].line.max(1) - 1).unwrap();
        assert!(found[0].value.is_empty() || line.contains(&found[0].value), "{line}: {found:?}");
        assert!(found[0].cure.code.starts_with("machine-cure-"));
    }
    // Without drives: one remark per axis.
    let text = shipped(torch).unwrap().text;
    let without = &text[..text.find("[drives.y]").unwrap()];
    let remarks = remarked(without);
    let without: Vec<_> = remarks.iter().filter(|r| r.why.code == "machine-remark-drive-missing").collect();
    assert!(without.len() == 5 && without.iter().all(|r| r.line == 0), "{remarks:?}");
    let table = "\n[pitch_error.y]\nat_mm = [-800, 0, 800]\nerror_mm = [0, 5, 0]\n";
    let remarks = remarked(&format!("{text}{table}"));
    assert!(remarks.len() == 1 && remarks[0].key == "pitch_error.y.error_mm", "{remarks:?}");
}

/// Without shapes no check is possible; a remark on a home position that is too close names the links.
#[test]
fn collisions_that_cannot_be_seen_or_are_there_from_the_start_are_remarked_upon() {
    let text = shipped("saddle-4axis").unwrap().text;
    let (before, rest) = text.split_once("[[shapes.").unwrap();
    let (_, after) = rest.split_once("[drives.").unwrap();
    let remarks = remarked(&format!("{before}[drives.{after}"));
    assert!(remarks.len() == 1 && remarks[0].key == "shapes" && remarks[0].line == 0, "{remarks:?}");
    assert_eq!(remarks[0].why.code, "machine-remark-no-shapes");
    // The torch driven down into the work's table.
    let low = changed("table-tilting-xyzac", "home_mm = 400", "home_mm = -290");
    let machine = Machine::read("m.toml", &low).unwrap();
    let around = Surroundings::new(&machine, &Clamped::default()).unwrap();
    assert!(!around.is_clear(&machine.home()));
    let remarks = remarked(&low);
    assert!(remarks.len() == 1 && remarks[0].key == "home", "{remarks:?}");
    let why = remarks[0].why.to_string();
    assert!(why.contains("torch") && why.contains("0 mm apart"), "{remarks:?}");
    // Without a collision at the home position there is no remark.
    assert!(remarked(shipped("table-tilting-xyzac").unwrap().text).is_empty());
}

/// The tilting table is singular with the torch along C; the distance that a weld needs is known in closed form.
#[test]
fn known_singular_places_are_found_and_named() {
    let check = checked(shipped("table-tilting-xyzac").unwrap().text, 100);
    let places = &check.heads[0].singular.places;
    assert_eq!(places.len(), 1, "{places:?}");
    assert_eq!(places[0].what, Message::new("machine-singular-along-axis").axis("axis", "c"));
    assert!(places[0].at.len() == 1 && places[0].at[0].0 == "a" && places[0].at[0].1.abs() < 1e-4);
    // C turns the direction by sin(a) of its own speed: 0.1 rad/s must not take more than 120 deg/s.
    let expected = (0.1 / 120f64.to_radians()).asin().to_degrees();
    let (margin, axis) = places[0].margin.clone().unwrap();
    assert!((margin - expected).abs() < 1e-3 && axis == "c", "{margin} {expected}");
    // Not in the range of the torch machine, and there with wider ranges: at both ends of b.
    assert!(checked(shipped("torch-5axis").unwrap().text, 100).heads[0].singular.places.is_empty());
    let wide = shipped("torch-5axis").unwrap().text.replace("range_deg = [-80, 80]", "range_deg = [-120, 120]");
    let check = checked(&wide, 2000);
    let places = &check.heads[0].singular.places;
    assert!(
        places.len() == 1 && places[0].what.to_string().contains("along axis a") && places[0].at[0].0 == "b",
        "{places:?}"
    );
    let (at, also) = (places[0].at[0].1, &places[0].also);
    assert!((at + 90.0).abs() < 1e-3 && also.len() == 1 && (also[0] - 90.0).abs() < 1e-3, "{places:?}");
    assert!(check.passed);
    // The saddle welder's tip on the axis of theta: 400 + s + 100 sin(beta) = 0.
    let long = changed("saddle-4axis", "range_mm = [-200, 200]", "range_mm = [-500, 200]");
    let places = checked(&long, 100).heads[0].singular.places.clone();
    let place =
        places.iter().find(|p| p.what == Message::new("machine-singular-tip-on-axis").axis("axis", "theta")).unwrap();
    let value = |name: &str| place.at.iter().find(|a| a.0 == name).unwrap().1;
    let radius = 400.0 + value("s") + 100.0 * value("beta").to_radians().sin();
    assert!(place.family && radius.abs() < 1e-3, "{places:?}");
}

/// A singular set is listed once, for any number of its configurations found; those of arms have their usual names.
#[test]
fn a_singular_set_is_listed_once() {
    let places = |text: &str| checked(text, 50).heads[0].singular.places.clone();
    let scara = places(include_str!("../../../../tests/data/field-trial/scara.toml"));
    assert_eq!(scara.len(), 1, "{scara:#?}");
    assert!(
        scara[0].what.code == "machine-singular-stretched" && scara[0].at.len() == 1 && scara[0].at[0].0 == "j2",
        "{scara:#?}"
    );
    for arm in [
        include_str!("../../../../tests/data/field-trial/ur10e.toml"),
        include_str!("../../../../tests/data/field-trial/irb.toml"),
    ] {
        let found = places(arm);
        let named = |name: &str| found.iter().filter(|p| p.what.code.ends_with(name)).count();
        assert!(found.len() <= 3 && named("wrist") == 1 && named("elbow") <= 1, "{found:#?}");
        assert!(found.iter().all(|p| p.what.to_string().contains("singularity")), "{found:#?}");
        let wrist = found.iter().find(|p| p.what.code.ends_with("wrist")).unwrap();
        assert!(wrist.at.len() == 1 && wrist.at[0].0 == "j5", "{wrist:#?}");
        // The wrist is stretched at 0 and at half turns within the range.
        let all = std::iter::once(wrist.at[0].1).chain(wrist.also.iter().copied());
        assert!(all.into_iter().all(|v| (v / 180.0 - (v / 180.0).round()).abs() < 1e-4), "{wrist:#?}");
    }
    let ur = places(include_str!("../../../../tests/data/field-trial/ur10e.toml"));
    // The ranges of the other arm end before it is stretched.
    for name in ["shoulder", "elbow"] {
        assert!(ur.iter().any(|p| p.what.code.ends_with(name)), "{ur:#?}");
    }
}

const LIMITS: &str = "max_speed_mm_s = 50\nmax_acceleration_mm_s2 = 500\n";
const TURNS: &str = "max_speed_deg_s = 50\nmax_acceleration_deg_s2 = 500\n";
const HEAD: &str = "schema = 1\nname = \"m\"\ntitle = \"m\"\n";
const TORCH: &str = "[torch]\ndirection = [0, 0, -1]\n";

fn slide(branch: &str, name: &str, way: &str, range: &str) -> String {
    format!("[[{branch}]]\naxis = \"{name}\"\nmove = {way}\nrange_mm = {range}\n{LIMITS}")
}

#[test]
fn reach_agrees_with_closed_forms() {
    // A box, one side of it slanting.
    let text = [
        HEAD,
        &slide("tool", "x", "[1, 0, 0]", "[-300, 500]"),
        &slide("tool", "y", "[0, 1, 0]", "[-100, 100]"),
        &slide("work", "z", "[0.6, 0, -0.8]", "[0, 400]"),
        TORCH,
    ]
    .concat();
    let reach = checked(&text, 50).heads[0].reach.clone();
    let expected = 800.0 * 200.0 * 0.8 * 400.0;
    assert!((reach.volume.measure - expected).abs() < 5.0 * reach.volume.deviation, "{reach:?}");
    assert!(reach.volume.deviation < 0.01 * expected && reach.volume.dimensions == 3);
    let corners = [[-300.0 - 240.0, -100.0, 0.0], [500.0, 100.0, 320.0]];
    for (found, corner) in reach.work_box_mm.iter().zip(corners) {
        assert!(found.iter().zip(corner).all(|(a, b)| (a - b).abs() < 1e-6), "{reach:?}");
    }
    assert!((reach.base_box_mm[1][2] - reach.base_box_mm[0][2]).abs() < 1e-9, "z moves the work");
    assert!(reach.tilt_deg < 1e-9);
    // A polar machine: a hollow cylinder, all round.
    let text = [
        HEAD,
        &format!("[[work]]\naxis = \"c\"\nturn = [0, 0, 1]\ncontinuous = true\n{TURNS}"),
        &slide("tool", "r", "[1, 0, 0]", "[150, 400]\nhome_mm = 200"),
        &slide("tool", "z", "[0, 0, 1]", "[-50, 250]"),
        TORCH,
    ]
    .concat();
    let reach = checked(&text, 50).heads[0].reach.clone();
    let expected = PI * (400.0f64.powi(2) - 150.0f64.powi(2)) * 300.0;
    assert!((reach.volume.measure - expected).abs() < 5.0 * reach.volume.deviation, "{reach:?} {expected}");
    assert!(reach.volume.deviation < 0.02 * expected);
    for (found, corner) in reach.work_box_mm.iter().zip([[-400.0, -400.0, -50.0], [400.0, 400.0, 250.0]]) {
        assert!(found.iter().zip(corner).all(|(a, b)| (a - b).abs() < 1e-3), "{reach:?}");
    }
    // A ring in a plane: an area.
    let flat = text.replace("range_mm = [-50, 250]", "range_mm = [-1e-10, 1e-10]");
    let reach = checked(&flat, 50).heads[0].reach.clone();
    let expected = PI * (400.0f64.powi(2) - 150.0f64.powi(2));
    assert!(reach.volume.dimensions == 2, "{reach:?}");
    assert!((reach.volume.measure - expected).abs() < 5.0 * reach.volume.deviation, "{reach:?} {expected}");
}

/// Two rotary axes that turn the torch: the maximum tilt is at both ends of range.
#[test]
fn tilt_is_the_greatest_over_the_ranges() {
    let check = checked(shipped("torch-5axis").unwrap().text, 10);
    let expected = (80f64.to_radians().cos().powi(2)).acos().to_degrees();
    assert!((check.heads[0].reach.tilt_deg - expected).abs() < 1e-6, "{}", check.heads[0].reach.tilt_deg);
}

#[test]
fn arrangements_without_a_closed_form_are_checked_too() {
    let turn = |branch: &str, name: &str, way: &str, at: &str| {
        format!("[[{branch}]]\naxis = \"{name}\"\nturn = {way}\nat_mm = {at}\nrange_deg = [-100, 100]\n{TURNS}")
    };
    let text = [
        HEAD,
        &turn("tool", "a1", "[0, 0, 1]", "[0, 0, 0]"),
        &turn("tool", "a2", "[0, 1, 0]", "[100, 0, 300]"),
        &turn("tool", "a3", "[0, 1, 0]", "[100, 0, 800]"),
        &turn("tool", "a4", "[1, 0, 0]", "[600, 0, 800]"),
        &turn("tool", "a5", "[0, 1, 0]", "[700, 0, 800]"),
        "[[tool]]\nfixed = { move_mm = [700, 0, 650] }\n",
        "[torch]\ndirection = [0.5, 0, -1]\n",
    ]
    .concat();
    let check = checked(&text, 1000);
    let head = &check.heads[0];
    assert!(head.structure.to_string().starts_with("numeric (Newton's method): 5 rotary"), "{}", head.structure);
    assert!(check.passed, "{:?}", head.round_trip);
    assert!(!head.singular.places.is_empty());
}

/// Positive motion in the base frame against forward kinematics: a tool-side axis moves the tip in its direction, a
/// work-side one against it as seen from the work.
#[test]
fn places_of_axes_are_those_of_the_kinematics() {
    for s in SHIPPED {
        let machine = Machine::read(s.name, s.text).unwrap();
        let q = machine.spread(7);
        let skeleton = machine.skeleton(&q);
        let base = machine.base_frame(&machine.link_frames(&q)).inverse();
        for place in &skeleton.axes {
            for head in 0..machine.heads.len() {
                let columns = machine.clone().with_first_head(head).jacobian(&q);
                if !machine.heads[head].chain.axes().has(place.axis) {
                    continue;
                }
                let tip = base.transform_point3(machine.forward_of(head, &q).point);
                let seen = base.transform_vector3(columns[place.axis].0);
                let moved = match machine.axes[place.axis].kind {
                    seamwright_machine::AxisKind::Linear => place.direction,
                    seamwright_machine::AxisKind::Rotary => place.direction.cross(tip - place.at),
                };
                let sense = if place.side == Side::Tool { 1.0 } else { -1.0 };
                assert!((seen - sense * moved).length() < 1e-9, "{} {}", s.name, machine.axes[place.axis].name);
            }
        }
        for (head, (name, tip)) in skeleton.heads.iter().enumerate() {
            assert_eq!(name, &machine.heads[head].name);
            let work = skeleton.work.inverse().transform_point3(tip.point);
            assert!((work - machine.forward_of(head, &q).point).length() < 1e-9);
        }
    }
}
