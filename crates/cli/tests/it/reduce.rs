//! `seamwright tools reduce`: the table of a small path to the last digit, the taught joint that ships, errors with their
//! address.

use crate::common::{bad, column, good, json, root, run_with, table};

const HEADER: &str = "kind,first,last,cx_mm,cy_mm,cz_mm,radius_mm,nx,ny,nz,max_error_mm\n";

/// A line along x and half a circle back.
const BEND: &str = "x_mm,y_mm,z_mm\n0,0,0\n5,0,0\n10,0,0\n13,1,0\n14,2,0\n15,5,0\n14,8,0\n13,9,0\n10,10,0\n";

fn joint() -> String {
    root().join("examples/taught-joint.csv").display().to_string()
}

#[test]
fn a_small_path_to_the_last_digit() {
    for method in ["greedy", "fewest"] {
        let output = run_with(&["tools", "reduce", "-", "--tolerance-mm", "0.27", "--method", method], BEND);
        let told = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(0), "{told}");
        let text = String::from_utf8(output.stdout).unwrap();
        // The last cell is rounding.
        let (exact, rounding) = text.trim_end().rsplit_once(',').unwrap();
        assert_eq!(exact, format!("{HEADER}line,0,2,,,,,,,,0\narc,2,8,10,5,0,5,0,0,1"));
        assert!(rounding.parse::<f64>().unwrap() < 1e-14);
        assert!(told.starts_with("9 points; lines: 1, arcs: 1; maximum error"), "{told}");
    }
}

#[test]
fn the_taught_joint_is_a_line_and_two_arcs() {
    let arguments = ["tools", "reduce", &joint(), "--tolerance-mm", "0.05", "--axis-tolerance", "0.1"];
    let text = good(&arguments);
    let t = table(&text);
    let kinds: Vec<&str> = text.lines().skip(1).map(|l| l.split(',').next().unwrap()).collect();
    assert_eq!(kinds, ["line", "arc", "arc"]);
    assert_eq!(column(&t, "first"), [0.0, 16.0, 42.0]);
    assert_eq!(column(&t, "last"), [16.0, 42.0, 68.0]);
    let radius = column(&t, "radius_mm");
    assert!((radius[1] - 45.0).abs() < 0.1 && (radius[2] - 70.0).abs() < 0.5, "{radius:?}");
    assert!((column(&t, "cx_mm")[1] + 25.0).abs() < 0.1 && (column(&t, "cy_mm")[1] - 40.0).abs() < 0.1);
    assert!(column(&t, "nz")[1] > 0.9999);
    assert!(column(&t, "max_error_mm").iter().all(|e| *e <= 0.05));
    // A rotary axis that must be met better than it was taught needs more spans.
    let fine = table(&good(&["tools", "reduce", &joint(), "--tolerance-mm", "0.05", "--axis-tolerance", "0.02"]));
    assert!(fine.1.len() > 3);
    let json = json(&[&arguments[..], &["--json"]].concat());
    assert_eq!(
        (&json["points"], &json["lines"], &json["arcs"], &json["at_least"]),
        (&69.into(), &1.into(), &2.into(), &3.into())
    );
    let greatest = column(&t, "max_error_mm").into_iter().fold(0.0, f64::max);
    assert_eq!(json["greatest_error_mm"].as_f64(), Some(greatest));
    for (span, row) in json["spans"].as_array().unwrap().iter().zip(&t.1) {
        assert_eq!(span.as_object().unwrap().keys().cloned().collect::<Vec<_>>(), t.0);
        for (name, value) in t.0.iter().zip(row).skip(1) {
            assert!(span[name].as_f64().map_or(value.is_nan(), |v| (v - value).abs() <= 1e-15 * v.abs()), "{name}");
        }
    }
}

#[test]
fn the_drawing_shows_points_lines_and_arcs() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("joint.svg");
    good(&[
        "tools",
        "reduce",
        &joint(),
        "--tolerance-mm",
        "0.05",
        "--axis-tolerance",
        "0.1",
        "--svg",
        &file.display().to_string(),
    ]);
    let svg = std::fs::read_to_string(file).unwrap();
    for text in ["Seen along z", "Seen along y", "Seen along x", ">lines<", ">arcs<", ">points<", ">ends<"] {
        assert!(svg.contains(text), "{text}");
    }
}

#[test]
fn what_is_wrong_is_named_with_its_place() {
    let cases = [
        (
            "x_mm,y_mm\n0,0\n",
            "-:1: there is no column `z_mm` in `x_mm,y_mm`\n   allowed: a header line with x_mm,y_mm,z_mm",
        ),
        ("x_mm,y_mm,z_mm,b_deg\n0,0,0,0\n\n1,nan,0,0\n", "-:4: y_mm = `nan`: not a finite number\n   allowed:"),
        ("x_mm,y_mm,z_mm,b_deg\n0,0,0,0\n1,0,0\n", "-:3: b_deg = ``: not a finite number"),
        (
            "x_mm,y_mm,z_mm\n0,0,0\n1,0,-2e9\n",
            "-:3: z_mm = `-2000000000`: too far away\n   allowed: -1e9 to 1e9\n   cure:",
        ),
        ("x_mm,y_mm,z_mm\n0,0,0\n", "-: 1 point\n   allowed: at least two\n   cure:"),
        ("", "-:1: there is no column `x_mm`"),
    ];
    for (points, message) in cases {
        let output = run_with(&["tools", "reduce", "-", "--tolerance-mm", "0.1"], points);
        let told = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(output.status.code() == Some(2) && output.stdout.is_empty() && told.contains(message), "{told}");
    }
    for (more, message) in [
        (&["--tolerance-mm", "0"][..], "--tolerance-mm 0: not allowed"),
        (&["--tolerance-mm", "1", "--axis-tolerance", "-1"], "--axis-tolerance -1: not allowed"),
        (&["--tolerance-mm", "1", "--svg", "/no-such-folder/a.svg"], "cannot be written: there is no such folder"),
        (&[], "--tolerance-mm"),
    ] {
        let output = run_with(&[&["tools", "reduce", "-"], more].concat(), BEND);
        let told = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(output.status.code() == Some(2) && told.contains(message), "{told}");
    }
    bad(2, &["tools", "reduce", "no-such-file.csv", "--tolerance-mm", "1"]);
}
