//! Cross-sections show and list the torch angles in them.

use crate::common::{column, good, root, table, write};

/// The job of the trial with another work angle, on a machine that ships.
fn job(folder: &std::path::Path, work_angle: f64) -> String {
    let text = std::fs::read_to_string(root().join("tests/data/field-trial/j2.toml")).unwrap();
    let text = text.replace("gantry5.toml", "torch-5axis");
    let changed = text.replace("work_angle_deg = 0", &format!("work_angle_deg = {work_angle}\ntravel_angle_deg = 8"));
    assert_ne!(text, changed);
    write(folder, &format!("{work_angle}.toml"), changed)
}

#[test]
fn the_torchs_angles_are_drawn_and_listed() {
    let folder = tempfile::tempdir().unwrap();
    let [upright, leaning] = [0.0, 40.0].map(|angle| {
        let svg = folder.path().join(format!("{angle}.svg"));
        let rows = good(&["tools", "section", &job(folder.path(), angle), "--svg", &svg.display().to_string()]);
        (table(&rows), std::fs::read_to_string(svg).unwrap())
    });
    assert_ne!(upright.1, leaning.1, "the same drawing");
    assert!(leaning.1.contains("torch: work angle 40°, travel angle 8°"));
    let [a, b] = [&upright.0, &leaning.0].map(|rows| column(rows, "torch_work_angle_deg"));
    let bead = column(&upright.0, "work_angle_deg");
    assert!(a.len() > 50);
    for i in 0..a.len() {
        assert!((a[i] - bead[i]).abs() < 1e-9 && (b[i] - a[i] - 40.0).abs() < 1e-9, "{} {} {}", a[i], b[i], bead[i]);
    }
    assert!(column(&leaning.0, "torch_travel_angle_deg").iter().all(|angle| (angle - 8.0).abs() < 1e-9));
    // New columns follow the old ones.
    let torch = ["width_mm", "height_mm", "torch_work_angle_deg", "torch_travel_angle_deg"];
    assert_eq!(leaning.0.0[13..], [torch.as_slice(), &["toe_second_deg", "toe_first_deg"]].concat());
    assert!(column(&upright.0, "toe_first_deg").iter().all(|angle| (45.0..=180.0).contains(angle)));
    // Captions are broken into lines.
    assert!(upright.1.contains(", toe<") && upright.1.contains(">angles "));
}

#[test]
fn a_joint_without_beads_shows_the_torch_of_its_weld() {
    let folder = tempfile::tempdir().unwrap();
    let text = "schema = 1\ntitle = \"t\"\nmachine = \"torch-5axis\"\n[seam.line]\nstart_mm = [0, 0, 0]\nend_mm = [50, 0, 0]\n\
        first_normal = [0, 0, 1]\nsecond_normal = [0, 0, 1]\n[joint.preparation.single_v]\nthickness_mm = 8\nangle_deg = 60\n\
        [torch]\nwork_angle_deg = 11\n[weld]\nspeed_mm_s = 5\n";
    let path = folder.path().join("v.toml");
    std::fs::write(&path, text).unwrap();
    let svg = folder.path().join("v.svg").display().to_string();
    let rows = table(&good(&["tools", "section", &path.display().to_string(), "--svg", &svg]));
    assert!(column(&rows, "torch_work_angle_deg").iter().all(|angle| (angle - 11.0).abs() < 1e-9));
    assert!(std::fs::read_to_string(&svg).unwrap().contains("class=\"wire-tip\""));
}
