//! Random jobs with beads, starts, end angles, overlaps, parts, tacks and copies on every kind of seam: each is planned, or
//! refused with a key that is in its file.

use seamwright_document::DocumentError;
use seamwright_program::TorchPath;
use seamwright_testkit::{Random, cases};
use seamwright_weld::Welding;
use std::fmt::Write as _;

/// A number mostly as a person writes it, with a digit after the point; else with all digits.
fn written(random: &mut Random, low: f64, high: f64) -> f64 {
    let value = random.within(low, high);
    let rounded = (value * 10.0).round() / 10.0;
    if random.one_in(4) || rounded < low { value } else { rounded }
}

/// Kind of joint on a seam.
#[derive(Clone, Copy, PartialEq)]
enum Faces {
    Corner,
    Butt,
}

const KINDS: usize = 25;

/// A seam of a kind, whether its faces stand on each other, and whether it has angles.
fn seam(random: &mut Random, kind: usize) -> (String, Faces, bool) {
    let r = written(random, 20.0, 120.0);
    let nozzle = |random: &mut Random, body: String, lean: f64| {
        let zero = if random.one_in(2) { "zero_direction = [0.3, 1, 0.1]\n" } else { "" };
        let (x, y) = (random.within(-lean, lean), random.within(-lean, lean));
        format!("[seam.nozzle]\nradius_mm = {r}\ndirection = [{x}, {y}, 1]\n{zero}[seam.nozzle.body.{body}\n")
    };
    let size = r * random.within(1.6, 6.0);
    let joint = if random.one_in(2) { Faces::Butt } else { Faces::Corner };
    let word = if joint == Faces::Butt { "butt" } else { "fillet" };
    let text = match kind {
        0 => nozzle(random, format!("cylinder]\nradius_mm = {size}"), 0.3),
        1 => nozzle(random, format!("sphere]\nradius_mm = {size}"), 0.3),
        2 => nozzle(random, "plane]\nnormal = [0.1, 0.2, 1]".to_owned(), 0.5),
        3 => {
            let half = random.within(10.0, 40.0);
            let apex = 3.0 * size / f64::tan(half.to_radians());
            nozzle(random, format!("cone]\nhalf_angle_deg = {half}\naxis = [1, 0, 0]\napex_mm = [-{apex}, 0, 0]"), 0.2)
        }
        4 => nozzle(random, format!("ellipsoid]\nsemi_axes_mm = [{}, {}, {size}]", 1.5 * size, 2.0 * size), 0.2),
        5 => nozzle(
            random,
            format!("torus]\nbend_radius_mm = {}\nradius_mm = {size}\ncentre_mm = [{}, 0, 0]", 5.0 * size, 5.0 * size),
            0.1,
        ),
        6 => nozzle(
            random,
            format!(
                "torispherical_head]\nouter_diameter_mm = {}\nthickness_mm = 8\nstandard = \"din_28011\"",
                3.0 * size
            ),
            0.1,
        ),
        7 => nozzle(random, format!("ellipsoidal_head]\nouter_diameter_mm = {}", 3.0 * size), 0.1),
        8 => nozzle(random, format!("hemispherical_head]\nouter_diameter_mm = {}", 3.0 * size), 0.1),
        9 => nozzle(
            random,
            format!("flat_head]\nouter_diameter_mm = {}\nthickness_mm = 8\nknuckle_radius_mm = 30", 3.0 * size),
            0.1,
        ),
        10 => format!(
            "[seam.branch]\nradius_mm = {r}\nchord_radius_mm = {size}\nangle_deg = {}\n",
            written(random, 50.0, 130.0)
        ),
        11 => format!(
            "[seam.branch]\nradius_mm = {r}\nchord_radius_mm = {size}\nangle_deg = 60\neccentricity_mm = {}\n\
             other = {{ radius_mm = {r}, angle_deg = 60, gap_mm = {} }}\n",
            random.within(0.0, 0.2 * r),
            random.within(-0.5 * r, 20.0)
        ),
        12 => format!("[seam.ellipse]\na_mm = {r}\nb_mm = {}\njoint = \"{word}\"\n", written(random, 20.0, 90.0)),
        13 => format!("[seam.circle]\nradius_mm = {r}\njoint = \"{word}\"\n"),
        14 => format!(
            "[seam.arc]\nstart_mm = [0, 0, 0]\nvia_mm = [{r}, {}, 0]\nend_mm = [{}, 0, 0]\njoint = \"{word}\"\n",
            random.within(5.0, r),
            2.0 * r
        ),
        15 => format!(
            "[seam.rounded_rectangle]\nwidth_mm = {}\nheight_mm = {r}\ncorner_mm = {}\njoint = \"{word}\"\n",
            2.0 * r,
            random.one(&[0.0, 6.0, 0.4 * r])
        ),
        16 | 17 => format!(
            "[seam.polyline]\npoints_mm = [[0, 0, 0], [{r}, 0, 0], [{r}, {}, 0], [{}, {r}, 0]]\nclosed = {}\njoint = \"{word}\"\n",
            0.8 * r,
            random.within(-0.5 * r, 0.5 * r),
            kind == 17
        ),
        18 => format!(
            "[seam.helix]\nradius_mm = {r}\npitch_mm = {}\nturns = {}\njoint = \"{word}\"\n",
            written(random, 20.0, 80.0),
            written(random, 0.3, 2.5)
        ),
        19 | 20 => {
            // Round about a circle, and not too far round if it is open.
            let count = if kind == 20 { 7 } else { 5 };
            let point = |i: u32, random: &mut Random| {
                let (angle, out) = (std::f64::consts::TAU * f64::from(i) / 7.0, r + random.within(-3.0, 3.0));
                format!("[{}, {}, 0]", out * angle.cos(), out * angle.sin())
            };
            let points: Vec<String> = (0..count).map(|i| point(i, random)).collect();
            format!("[seam.spline]\npoints_mm = [{}]\nclosed = {}\njoint = \"{word}\"\n", points.join(", "), kind == 20)
        }
        21 => format!(
            "[seam.line]\nstart_mm = [0, 0, 0]\nend_mm = [{}, 0, 0]\nfirst_normal = [0, {}, 0.1]\nsecond_normal = [0, 0, 1]\n",
            3.0 * r,
            random.one(&[-1.0, -0.001])
        ),
        22 => format!(
            "[seam.t_joint]\nstart_mm = [0, 0, 0]\nend_mm = [{}, 0, 0]\nskin_normal = [0, 0, 1]\nweb_mm = 8\nfillet = \"{}\"\n",
            3.0 * r,
            random.one(&["left", "right", "both"])
        ),
        24 => format!("[seam.circle]\nradius_mm = {r}\njoint = \"{word}\"\n"),
        _ => format!("[seam.girth]\nradius_mm = {r}\ncut_normal = [{}, 0, 1]\n", random.within(0.0, 0.4)),
    };
    let faces = match kind {
        0..=11 | 22 => Faces::Corner,
        21 if text.contains("-0.001") => Faces::Butt,
        21 => Faces::Corner,
        12..=20 | 24 => joint,
        _ => Faces::Butt,
    };
    (text, faces, matches!(kind, 0..=13 | 15 | 23 | 24))
}

/// A start on a circle of radius `r`, and a part of it taught: a little outside, between two positions.
fn taught(random: &mut Random, r: f64) -> String {
    let (phi, from, to) = (written(random, -90.0, 90.0), random.within(0.05, 0.2), random.within(0.35, 0.8));
    let around = std::f64::consts::TAU * r;
    let point = |i: u32| {
        let angle = phi.to_radians() + std::f64::consts::TAU * (from + (to - from) * f64::from(i) / 5.0);
        format!("[{}, {}, 0]", (r + 1.0) * angle.cos(), (r + 1.0) * angle.sin())
    };
    let points: Vec<String> = (1..5).map(point).collect();
    format!(
        "[start]\nphi_deg = {phi}\noverlap_mm = {}\n[[taught]]\nfrom_mm = {}\nto_mm = {}\npoints_mm = [{}]\n",
        written(random, 0.0, 30.0),
        from * around,
        to * around,
        points.join(", ")
    )
}

fn start(random: &mut Random, angles: bool, closed: bool, around: f64) -> String {
    let mut text = "[start]\n".to_owned();
    let phi = written(random, -400.0, 400.0);
    let clockwise = random.one_in(3);
    if angles {
        let _ = writeln!(text, "phi_deg = {phi}");
        if clockwise {
            text.push_str("direction = \"clockwise\"\n");
        }
    }
    match *random.one(&[0, 1, 1, 2, 2, 2]) {
        0 => {}
        1 if closed => {
            let _ = writeln!(text, "overlap_mm = {}", written(random, 0.0, 0.3 * around));
        }
        2 if angles => {
            let turn = if random.one_in(5) { 360.0 } else { written(random, 15.0, 365.0) };
            let _ = writeln!(text, "end_phi_deg = {}", if clockwise { phi - turn } else { phi + turn });
        }
        _ => {}
    }
    text
}

fn joint(random: &mut Random, faces: Faces) -> String {
    let t = written(random, 3.0, 18.0);
    let (gap, face) = (written(random, 0.0, 3.0), written(random, 0.0, 2.0));
    let preparation = match (faces, *random.one(&[0, 1, 2, 3])) {
        (Faces::Corner, 0) => format!("fillet = {{ leg_mm = {t} }}"),
        (Faces::Corner, 1) => format!("fillet = {{ throat_mm = {} }}", 0.6 * t),
        (Faces::Corner, 2) => {
            let cut = if random.one_in(2) { "cut_deg" } else { "angle_deg" };
            let prepared = random.one(&["first", "second"]);
            format!(
                "t_bevel = {{ prepared = \"{prepared}\", thickness_mm = {t}, {cut} = {}, root_gap_mm = {gap}, \
                 root_face_mm = {face}, leg_mm = {} }}",
                written(random, 30.0, 50.0),
                written(random, 0.0, 6.0)
            )
        }
        (Faces::Corner, _) => {
            format!(
                "t_j = {{ thickness_mm = {t}, angle_deg = 15, radius_mm = 3, root_gap_mm = {gap}, root_face_mm = {face} }}"
            )
        }
        (Faces::Butt, 0) => format!("square = {{ thickness_mm = {t}, root_gap_mm = {gap} }}"),
        (Faces::Butt, 1) => {
            format!("single_v = {{ thickness_mm = {t}, angle_deg = 60, root_gap_mm = {gap}, root_face_mm = {face} }}")
        }
        (Faces::Butt, 2) => {
            format!("bevel = {{ thickness_mm = {t}, angle_deg = 45, root_gap_mm = {gap}, root_face_mm = {face} }}")
        }
        (Faces::Butt, _) => format!(
            "u = {{ thickness_mm = {t}, angle_deg = 12, radius_mm = 3, root_gap_mm = {gap}, root_face_mm = {face} }}"
        ),
    };
    let mut text = format!("[joint]\ncap_mm = {}\npreparation.{preparation}\n", written(random, 0.0, 2.0));
    if random.one_in(5) {
        let _ = write!(
            text,
            "[[joint.fit_up]]\ns_mm = 0\nroot_gap_mm = {gap}\n[[joint.fit_up]]\ns_mm = {}\nroot_gap_mm = {}\n",
            written(random, 20.0, 200.0),
            gap + 0.5
        );
    }
    text
}

#[rustfmt::skip]
const ADAPT: [&str; 9] =
    ["speed", "speed", "wire_feed", "wire_feed", "passes", "passes", "passes", "passes", "weave_width"];

fn beads(random: &mut Random) -> String {
    let mut text = format!(
        "[beads]\nadapt = \"{}\"\norder = \"{}\"\nstagger_mm = {}\nalternate = {}\nshortest_mm = {}\n",
        random.one(&ADAPT),
        random.one(&["walls_first", "from_first", "from_second"]),
        written(random, 0.0, 90.0),
        random.one_in(2),
        written(random, 5.0, 120.0)
    );
    if !random.one_in(4) {
        let _ = writeln!(text, "station_mm = {}", written(random, 3.0, 30.0));
    }
    let wired = text.contains("wire_feed") || random.one_in(3);
    if wired {
        text.push_str("wire_mm = 1.2\n");
    }
    for run in ["root", "fill", "cap"] {
        if run != "fill" && random.one_in(3) {
            continue;
        }
        let _ = write!(text, "{run} = {{ layer_mm = {}", written(random, 1.5, 5.0));
        if !wired {
            let _ = write!(text, ", area_mm2 = {}", written(random, 8.0, 40.0));
        }
        if random.one_in(3) {
            let _ = write!(text, ", speed_mm_s = {}", written(random, 3.0, 9.0));
        }
        if random.one_in(12) {
            let _ = write!(text, ", travel_angle_deg = {}", written(random, -30.0, 30.0));
        }
        if run != "root" && random.one_in(4) {
            let _ = write!(text, ", weave = {{ width_mm = {}, pitch_mm = 3 }}", written(random, 1.0, 6.0));
        }
        text.push_str(" }\n");
    }
    text
}

fn order(random: &mut Random, many_copies: bool) -> String {
    let mut text = String::new();
    match *random.one(&[0, 0, 0, 0, 0, 0, 1, 2, 3, 3]) {
        1 => text.push_str("[order]\nparts = \"quadrants\"\n"),
        2 => text.push_str("[order]\nparts = \"at_corners\"\n"),
        3 => {
            let _ = writeln!(text, "[order]\nparts = {{ back_step_mm = {} }}", written(random, 4.0, 150.0));
        }
        _ => {}
    }
    if !text.is_empty() && !random.one_in(4) {
        let _ = writeln!(text, "tie_in_mm = {}", written(random, 0.0, 10.0));
    }
    if random.one_in(4) {
        let length = written(random, 5.0, 20.0);
        let clear =
            if random.one_in(4) { String::new() } else { format!("clear_mm = {}\n", written(random, 0.0, 15.0)) };
        let number = if random.one_in(2) {
            format!("count = {}", random.one(&[2, 3, 4, 7]))
        } else {
            format!("pitch_mm = {}", written(random, 15.0, 90.0))
        };
        let _ = writeln!(text, "[tacks]\nlength_mm = {length}\n{clear}{number}");
    }
    if random.one_in(6) {
        let _ = writeln!(text, "[cosmetic]\nfrom_mm = {}", written(random, 0.0, 40.0));
    }
    if random.one_in(8) || many_copies {
        let (rows, columns) = if many_copies { (10, 100) } else { (2, 2) };
        let steps = "step_mm = [500, 0, 0]\nrow_step_mm = [0, 500, 0]";
        let _ = writeln!(text, "[rows]\nrows = {rows}\ncolumns = {columns}\n{steps}");
    }
    text
}

fn torch(random: &mut Random) -> String {
    if random.one_in(4) {
        let s = written(random, 5.0, 150.0);
        return format!(
            "[[torch.at]]\ns_mm = 0\nwork_angle_deg = 5\n[[torch.at]]\ns_mm = {s}\ntravel_angle_deg = {}\n",
            written(random, -20.0, 20.0)
        );
    }
    format!(
        "[torch]\nwork_angle_deg = {}\ntravel_angle_deg = {}\n",
        written(random, -10.0, 10.0),
        written(random, -20.0, 20.0)
    )
}

/// Speeds and currents at stations along the weld, a few or very many.
fn stations(random: &mut Random, many: bool) -> String {
    let count = if many && random.one_in(2) { 4100 } else { *random.one(&[1, 2, 5]) };
    let step = if count > 5 { 0.01 } else { written(random, 2.0, 20.0) };
    let station = |i: i32, random: &mut Random| {
        let mut text = format!("[[weld.at]]\ns_mm = {}\n", f64::from(i) * step);
        let values = *random.one(&[0, 1, 2]);
        if values != 1 {
            let _ = writeln!(text, "speed_mm_s = {}", written(random, 3.0, 9.0));
        }
        if values != 2 {
            let _ = writeln!(text, "process = {{ current_a = {} }}", written(random, 100.0, 250.0));
        }
        text
    };
    (0..count).map(|i| station(i, random)).collect()
}

fn seam_radius(text: &str) -> f64 {
    value_at(text, "seam.circle.radius_mm").and_then(|r| r.as_float().or(r.as_integer().map(|r| r as f64))).unwrap()
}

fn job(case: usize) -> String {
    let mut random = Random::of_case(case as u32);
    let kind = case % KINDS;
    let (seam, faces, angles) = seam(&mut random, kind);
    let closed = angles || matches!(kind, 17 | 20);
    let mut text = format!("schema = 1\ntitle = \"case {case}\"\nmachine = \"m\"\n{seam}");
    let begin = match kind {
        24 => taught(&mut random, seam_radius(&text)),
        _ => start(&mut random, angles, closed, 300.0),
    };
    text.push_str(&begin);
    // With stations of the weld there are no beads, except by an intended mistake. Rarely there are too many rows of
    // them, and of copies.
    let (with_stations, many) = (random.one_in(6), random.one_in(32));
    if !with_stations || random.one_in(8) {
        text.push_str(&joint(&mut random, faces));
        text.push_str(&beads(&mut random));
    }
    let stations = if with_stations { stations(&mut random, many) } else { String::new() };
    text.push_str(&order(&mut random, with_stations && many));
    text.push_str(&torch(&mut random));
    text + "[weld]\nspeed_mm_s = 6\nprocess = { current_a = 200, wire_feed_m_min = 8 }\n" + &stations
}

/// The value at a key path like `beads.root.process` or `torch.at[1].s_mm` in a file's text.
fn value_at(text: &str, key: &str) -> Option<toml::Value> {
    let mut here = toml::Value::Table(toml::from_str(text).unwrap_or_else(|e| panic!("{e}\n{text}")));
    for part in key.split('.') {
        let (name, indices) = part.split_once('[').map_or((part, ""), |(name, indices)| (name, indices));
        here = here.get(name)?.clone();
        for index in indices.split('[').filter(|index| !index.is_empty()) {
            here = here.get(index.trim_end_matches(']').parse::<usize>().ok()?)?.clone();
        }
    }
    Some(here)
}

/// Checks that a refusal names a key of the file.
fn check_refusal(text: &str, error: &DocumentError) {
    assert!(value_at(text, &error.key).is_some(), "the key is in no file: {error}\n{text}");
    assert!(error.line > 0 && error.allowed.is_some(), "{error}\n{text}");
}

/// Checks that every pass is on the seam, and that the torch stands somewhere all along it.
fn check_plan(text: &str, welding: &Welding) {
    let passes = &welding.program.value.passes;
    assert!(!passes.is_empty());
    for (i, pass) in passes.iter().enumerate() {
        let path = welding.path(i);
        assert!(path.length() > 0.0 && (path.length() - pass.length()).abs() <= 1e-6, "pass {}\n{text}", pass.name);
        for part in [0.0, 0.37, 1.0] {
            let pose = path.pose(part * path.length());
            assert!(
                pose.point.is_finite() && (pose.direction.length() - 1.0).abs() < 1e-9,
                "pass {}\n{text}",
                pass.name
            );
        }
    }
}

/// Jobs that are planned, saved as a program and read again: one in so many.
const SAVED: usize = 8;

#[test]
fn jobs_on_every_kind_of_seam_are_planned_or_refused_with_a_key_of_their_file() {
    let (mut planned, mut refused) = ([0; KINDS], [0; KINDS]);
    let mut keys = std::collections::BTreeMap::new();
    for case in 0..cases(1_500) {
        let text = job(case);
        match Welding::read("job.toml", &text) {
            Ok(welding) => {
                planned[case % KINDS] += 1;
                check_plan(&text, &welding);
                if case % SAVED == 0 {
                    let program = welding.program.value.to_toml().unwrap();
                    let again = Welding::read("program.toml", &program).unwrap_or_else(|e| panic!("{e}\n{text}"));
                    assert_eq!(again.program.value.passes.len(), welding.program.value.passes.len(), "{text}");
                }
            }
            Err(error) => {
                refused[case % KINDS] += 1;
                check_refusal(&text, &error);
                *keys.entry(format!("{}: {}", error.key, error.message)).or_insert(0) += 1;
            }
        }
    }
    for (key, count) in keys.iter().filter(|(_, count)| **count > cases(20)) {
        println!("{count:6} {key}");
    }
    println!("planned {planned:?}\nrefused {refused:?}");
    // Most jobs are sensible: refusals are the exception on every kind of seam.
    for kind in 0..KINDS {
        assert!(planned[kind] > refused[kind] / 2, "kind {kind}: planned {planned:?}, refused {refused:?}");
    }
}
