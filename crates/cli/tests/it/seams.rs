//! Seams in a plane and helices through the command line: welded with every choice at their corners; bad input with its
//! address.

use crate::common::{column, example, good, has_all, run, table};
use std::fs;

fn job(seam: &str, corner: &str) -> String {
    format!("schema = 1\ntitle = \"t\"\nmachine = \"ellipse-xy\"\n{seam}\n[weld]\nspeed_mm_s = 5\ncorner = {corner}\n")
}

/// Runs `verb` on a job; exit code, standard output, errors.
fn with(verb: &str, text: &str) -> (i32, String, String) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("job.toml");
    fs::write(&path, text).unwrap();
    let out = folder.path().join("out").display().to_string();
    let path = path.display().to_string();
    let arguments = if verb == "seam" { vec!["tools", verb, &path] } else { vec![verb, &path, "-o", &out] };
    let output = run(&arguments);
    let words = |bytes| String::from_utf8(bytes).unwrap();
    (output.status.code().unwrap(), words(output.stdout), words(output.stderr))
}

fn refused(seam: &str, key: &str, words: &[&str]) {
    let (code, out, text) = with("plan", &job(seam, "\"stop\""));
    println!("{text}");
    assert!(code == 2 && out.is_empty() && text.lines().count() <= 12, "{text}");
    assert!(text.contains("job.toml:") && text.contains("allowed: ") && text.contains(key), "{text}");
    has_all(&text, words);
}

const CIRCLE: &str = "[seam.circle]\nradius_mm = 20\njoint = \"butt\"\n";
const ARC: &str = "[seam.arc]\nstart_mm = [-40, 0, 0]\nvia_mm = [0, 25, 0]\nend_mm = [40, 0, 0]\njoint = \"butt\"\n";
const RECTANGLE: &str =
    "[seam.rounded_rectangle]\nwidth_mm = 60\nheight_mm = 40\ncorner_mm = 8\njoint = \"butt\"\n[start]\nphi_deg = 90\n";
const POLYLINE: &str = "[seam.polyline]\npoints_mm = [[-40, 0, 0], [0, 0, 0], [10, 30, 0]]\njoint = \"butt\"\n";

#[test]
fn circles_and_arcs_weld() {
    for (seam, length) in [(CIRCLE, 40.0 * std::f64::consts::PI), (ARC, 89.0 * (40.0f64 / 44.5).asin())] {
        let (code, csv, _) = with("seam", &job(seam, "\"refuse\""));
        let (t, n) = (table(&csv), csv.lines().count());
        assert!(code == 0 && n == 102);
        assert!((column(&t, "s_mm")[100] - length).abs() < 1e-9);
        assert!(column(&t, "phi_deg").iter().all(|phi| phi.is_nan() == (seam == ARC)));
        let (code, _, text) = with("simulate", &job(seam, "\"refuse\""));
        assert_eq!(code, 0, "{text}");
    }
}

#[test]
fn the_tube_plate_welds_as_printed_and_with_every_choice() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out").display().to_string();
    good(&["simulate", &example("tube-plate"), "-o", &out]);
    let report = fs::read_to_string(folder.path().join("out/report.json")).unwrap();
    let report: serde_json::Value = serde_json::from_str(&report).unwrap();
    assert_eq!(report["seam"]["kind"], "rounded rectangle");
    let blends = report["findings"].as_array().unwrap().iter().filter(|f| f["kind"] == "blend").count();
    // Its corners, from lines into arcs, are blended within less than a micrometre, so no blend is reported.
    assert_eq!(blends, 0, "{report:#}");
    // Everywhere within 0.05 mm of the rounded rectangle.
    let t = table(&good(&["tools", "motion", &example("tube-plate"), "--period-ms", "5"]));
    let (x, y) = (column(&t, "x"), column(&t, "y"));
    let away = |(x, y): (&f64, &f64)| (((x.abs() - 22.0).max(0.0)).hypot((y.abs() - 12.0).max(0.0)) - 8.0).abs();
    let worst = x.iter().zip(&y).map(away).fold(0.0, f64::max);
    assert!(worst < 0.05 && worst > 0.0, "{worst}");

    let (code, _, text) = with("plan", &job(RECTANGLE, "\"refuse\""));
    assert!(code == 1 && text.contains("blend_mm"), "{text}");
    assert_eq!(text.matches("finding (stop)").count(), 8, "{text}");
    let (code, _, text) = with("simulate", &job(RECTANGLE, "\"stop\""));
    assert_eq!(code, 0, "{text}");
    // Sharp corners the same, but the torch cannot turn at once over a fillet.
    let sharp = RECTANGLE.replace("corner_mm = 8", "corner_mm = 0");
    for (corner, expected) in [("\"refuse\"", 1), ("\"stop\"", 0), ("{ blend_mm = 0.3 }", 0)] {
        let (code, _, text) = with("plan", &job(&sharp, corner));
        assert_eq!(code, expected, "{corner}: {text}");
    }
    let (code, _, text) = with("plan", &job(&sharp.replace("\"butt\"", "\"fillet\""), "\"stop\""));
    assert!(code == 1 && text.contains("the torch's direction would jump"), "{text}");
}

#[test]
fn polylines_stop_at_corners_or_go_round_them() {
    for (corner, expected) in [("\"refuse\"", 1), ("\"stop\"", 0), ("{ blend_mm = 0.3 }", 0)] {
        // Slower, y sticks as it breaks away at the corner: a finding of its own.
        let quick = job(POLYLINE, corner).replace("speed_mm_s = 5", "speed_mm_s = 8");
        let (code, _, text) = with("simulate", &quick);
        assert_eq!(code, expected, "{corner}: {text}");
    }
    let (_, csv, _) = with("seam", &job(POLYLINE, "\"refuse\""));
    let t = table(&csv);
    assert!((column(&t, "s_mm")[100] - 40.0 - 1000f64.sqrt()).abs() < 1e-9);
    assert!(column(&t, "phi_deg").iter().all(|phi| phi.is_nan()));
}

/// A strip of 1.5 turns on a tube that stands on the axis of a tilting rotary table.
const HELIX: &str = "[placement]\nmove_mm = [0, 0, 150]\n[seam.helix]\nradius_mm = 60\npitch_mm = 20\nturns = 1.5\n\
                     wall_faces = \"left\"\n";

#[test]
fn helices_weld() {
    let on_table = |joint: &str| {
        job(&HELIX.replace("wall_faces", &format!("joint = \"{joint}\"\nwall_faces")), "\"refuse\"")
            .replace("ellipse-xy", "table-tilting-xyzac")
    };
    for (joint, dihedral) in [("fillet", 90.0), ("butt", 180.0)] {
        let (code, csv, _) = with("seam", &on_table(joint));
        let t = table(&csv);
        assert!(code == 0 && (column(&t, "phi_deg")[100] - 540.0).abs() < 1e-9);
        assert!((column(&t, "s_mm")[100] - 1.5 * (120.0 * std::f64::consts::PI).hypot(20.0)).abs() < 1e-9);
        assert!(column(&t, "dihedral_deg").iter().all(|d| (d - dihedral).abs() < 1e-9));
        let (code, _, text) = with("simulate", &on_table(joint));
        assert_eq!(code, 0, "{text}");
    }
}

#[test]
fn mistakes() {
    refused(&HELIX.replace("= 20", "= 0"), "seam.helix.pitch_mm = 0", &["[seam.girth]"]);
    refused(&HELIX.replace("turns = 1.5", "turns = -1"), "seam.helix.turns = -1", &["greater than 0"]);
    refused(&format!("{HELIX}[start]\nphi_deg = 20\n"), "start.phi_deg", &["does not close"]);

    refused(&CIRCLE.replace("= 20", "= -20"), "seam.circle.radius_mm = -20", &["greater than 0"]);
    refused(&CIRCLE.replace("radius_mm", "radius"), "seam.circle.radius", &["did you mean `radius_mm`?"]);
    refused(&format!("{CIRCLE}zero_direction = [0, 0, 1]\n"), "seam.circle.zero_direction", &["not along `normal`"]);

    refused(&ARC.replace("[0, 25, 0]", "[5, 0, 0]"), "seam.arc.via_mm", &["[seam.line]"]);
    refused(&format!("{ARC}normal = [0, 1, 1]\n"), "seam.arc.normal", &["45.0000°"]);
    refused(&format!("{ARC}[start]\noverlap_mm = 5\n"), "start.overlap_mm", &["does not close"]);

    refused(&RECTANGLE.replace("= 8", "= 20.5"), "seam.rounded_rectangle.corner_mm = 20.5", &["0 mm to 20 mm"]);
    refused(&RECTANGLE.replace("= 60", "= \"60\""), "seam.rounded_rectangle.width_mm", &["greater than 0"]);
    refused(&RECTANGLE.replace("\"butt\"", "\"lap\""), "seam.rounded_rectangle.joint", &["fillet"]);

    refused(
        &POLYLINE.replace("[10, 30, 0]", "[0, 0, 0]"),
        "seam.polyline.points_mm[2]",
        &["coincides with the one before"],
    );
    refused(&POLYLINE.replace("[10, 30, 0]", "[10, 30, 0.5]"), "seam.polyline.points_mm[2]", &["0.500000 mm above"]);
    refused(&POLYLINE.replace("[10, 30, 0]", "[10, nan, 0]"), "seam.polyline.points_mm[2]", &["finite"]);
    refused(&format!("{POLYLINE}[start]\nphi_deg = 5\n"), "start.phi_deg", &["does not close"]);
}

/// The torch of a fillet would have to jump at sharp corners: each is one finding, and none blames the axes.
#[test]
fn a_corner_at_which_the_torch_jumps_is_one_finding() {
    let corners = "[seam.rounded_rectangle]\nwidth_mm = 60\nheight_mm = 40\ncorner_mm = 0\njoint = \"fillet\"\n\
                   [start]\nphi_deg = 90\n";
    let text = |machine: &str| job(corners, "\"stop\"").replace("ellipse-xy", machine);
    for machine in ["torch-5axis", "table-tilting-xyzac"] {
        let (code, _, errors) = with("plan", &text(machine));
        let found: Vec<&str> = errors.lines().filter(|line| line.starts_with("finding (")).collect();
        if found.iter().any(|line| line.starts_with("finding (reach)")) {
            continue;
        }
        assert!(code == 1 && found.len() == 4, "{machine}: {errors}");
        assert!(
            found.iter().all(|line| line.starts_with("finding (turn): the torch's direction would jump by")),
            "{errors}"
        );
    }
}
