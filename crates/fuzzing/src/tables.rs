//! Tables of points and profiles, and solids.

use crate::scratch::{folder, write};
use crate::target::{Target, USUAL};
use crate::texts::{describe, with_text};
use glam::DVec2;
use seamwright_clearance::read_stl;
use seamwright_project::csv::CsvReader;
use seamwright_project::load::load_foreign;
use seamwright_vision::stripe::{JointKind, StripeReader, StripeTask};
use std::sync::LazyLock;

/// Tables of points that a job's spline names.
pub const POINT_TABLE: Target = Target {
    name: "point_table",
    read: point_table,
    seeds: || {
        let text = |text: &str| text.as_bytes().to_vec();
        vec![
            text("x_mm,y_mm,z_mm\n0,0,0\n10,0,1\n20,5,2\n30,9,1\n40,9,0\n"),
            text("x_mm,y_mm,z_mm,n1x,n1y,n1z\n0,0,0,0,0,1\n10,0,1,0,0,1\n20,5,2,0,0.1,1\n30,9,1,0,0,1\n"),
            text(
                "z_mm,x_mm,y_mm,n1x,n1y,n1z,n2x,n2y,n2z,note\n0,0,0,0,0,1,0,1,0,a\n1,10,0,0,0,1,0,1,0,b\n2,20,5,0,0,1,0,1,0,\n",
            ),
        ]
    },
    words: || {
        ["x_mm", "y_mm", "z_mm", "n1x", "n1y", "n1z", "n2x", "n2y", "n2z", ",", "\n", ";"].map(str::to_owned).to_vec()
    },
    max_memory: 256 << 20,
    ..USUAL
};

/// Profiles of a laser stripe sensor: every joint is searched in them.
pub const STRIPE_PROFILE: Target = Target {
    name: "stripe_profile",
    read: |bytes| with_text(bytes, stripe_profile),
    seeds: || vec![profile(&|y| if y < 0.0 { -y } else { y }), profile(&|y| if y < 0.0 { 2.0 } else { 0.0 })],
    words: || ["y_mm,z_mm\n", "nan", ",", "\n", "0.5,", "-1e7"].map(str::to_owned).to_vec(),
    ..USUAL
};

/// STL files, ASCII and binary.
pub const STL: Target = Target {
    name: "stl",
    read: |bytes| {
        describe(read_stl(bytes, 1.0).inspect(|found| assert!(found.iter().flatten().all(|p| p.is_finite()))));
    },
    seeds: || {
        let mut binary = vec![b' '; 80];
        binary.extend(2u32.to_le_bytes());
        binary.extend(
            (0..2 * 12u8)
                .flat_map(|i| f32::from(i).to_le_bytes())
                .collect::<Vec<_>>()
                .chunks(48)
                .flat_map(|t| [t, &[0, 0]].concat()),
        );
        let text = "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1e1 -0.5\nendloop\nendfacet\nendsolid a\n";
        vec![binary, text.as_bytes().to_vec()]
    },
    words: || {
        ["solid ", "facet normal ", "outer loop\n", "vertex ", "endloop\n", "endfacet\n", "endsolid", "nan", "inf"]
            .map(str::to_owned)
            .to_vec()
    },
    is_text: false,
    ..USUAL
};

/// The example of a spline through points, through those of a table.
fn spline_job() -> String {
    let text = include_str!("../../../examples/spline.toml");
    let parts = text.split_once("points_mm = [").and_then(|(head, rest)| Some((head, rest.split_once("\n]\n")?.1)));
    let (head, tail) = parts.unwrap_or_else(|| panic!("the example has no points"));
    format!("{head}file = \"points.csv\"\ntolerance_mm = 0.1\n{tail}")
}

fn point_table(bytes: &[u8]) {
    static JOB: LazyLock<String> = LazyLock::new(spline_job);
    let folder = folder("tables");
    write(&folder.join("points.csv"), bytes);
    if let Ok((mut table, _)) = CsvReader::open("points.csv", bytes, &[&["x_mm", "y_mm", "z_mm"]]) {
        while let Some(Ok(_)) = table.texts() {}
    }
    describe(load_foreign("job.toml", &JOB, &folder).map(drop));
}

fn stripe_profile(text: &str) {
    let names = ["y_mm", "z_mm"];
    let Ok((mut table, _)) = CsvReader::open("profile.csv", text.as_bytes(), &[&names]) else { return };
    let mut points = Vec::new();
    while let Some(Ok(row)) = table.texts() {
        // As `seamwright stripe`: other cells are refused, missing ones are missing points.
        let value = |cell: &String| cell.parse().ok().filter(|v: &f64| v.abs() <= 1e7).unwrap_or(f64::NAN);
        points.push(DVec2::new(value(&row[0]), value(&row[1])));
    }
    let mut reader = StripeReader::new();
    for kind in JointKind::ALL {
        if let Ok(features) = reader.read_profile(&points, &StripeTask::in_mm(kind)) {
            assert!(features.points.iter().all(|(_, point)| point.is_finite()), "{features:?}");
            assert!((0.0..=1.0).contains(&features.confidence), "{features:?}");
        }
    }
}

fn profile(z: &dyn Fn(f64) -> f64) -> Vec<u8> {
    let rows = (-20..20).map(|i| f64::from(i) * 0.5).map(|y| format!("{y},{}\n", z(y)));
    format!("y_mm,z_mm\n{}", rows.collect::<String>()).into_bytes()
}
