//! Search of torch angles: obstacles that it clears, and the reason that it reports without any clear angle.

use crate::common::{json_file, root, run};
use std::path::PathBuf;
use std::process::Output;

/// A seam along x on a plate, welded from above by the gantry of the vessel shop.
fn job(from_x: f64, to_x: f64, preparation: &str, more: &str) -> String {
    let gantry = root().join("examples/vessel-shop/gantry.toml");
    format!(
        "schema = 1\ntitle = \"line\"\nmachine = \"{}\"\n\
         [seam.line]\nstart_mm = [{from_x}, 0, 0]\nend_mm = [{to_x}, 0, 0]\n\
         first_normal = [0, 0, 1]\nsecond_normal = [0, 0, 1]\n\
         [joint]\ncap_mm = 1\n[joint.preparation.single_v]\n{preparation}\n\
         [clearance]\nleast_mm = 0.5\n\
         [weld]\nspeed_mm_s = 6\n[weld.process]\ncurrent_a = 240\nvoltage_v = 27\nwire_feed_m_min = 8.5\n{more}",
        gantry.display()
    )
}

fn text(output: &Output) -> String {
    String::from_utf8_lossy(&output.stdout).into_owned() + &String::from_utf8_lossy(&output.stderr)
}

fn fixture(size: [f64; 3], at: [f64; 3]) -> String {
    format!("[[fixtures]]\nname = \"stop\"\nshape.box = {{ size_mm = {size:?} }}\nat = {{ move_mm = {at:?} }}\n")
}

struct Jobs(tempfile::TempDir);

impl Jobs {
    fn new() -> Self {
        Self(tempfile::tempdir().unwrap())
    }

    fn write(&self, name: &str, content: &str) -> PathBuf {
        let path = self.0.path().join(name);
        std::fs::write(&path, content).unwrap();
        path
    }
}

const THIN: &str = "thickness_mm = 8\nangle_deg = 60\nroot_gap_mm = 2\nroot_face_mm = 1";

#[test]
fn a_stop_behind_the_end_of_an_open_weld_is_cleared() {
    let jobs = Jobs::new();
    // The torch's body is 15 mm in radius: without a change it meets the stop in the last 2 mm only.
    let stop = fixture([20.0, 100.0, 20.0], [219.0, 0.0, 25.0]);
    let search = "[torch]\nsearch = { max_work_deg = 30, max_travel_deg = 20 }\n";
    let out = jobs.0.path().join("out");
    for (name, more, good) in [("fixed.toml", stop.clone(), false), ("search.toml", format!("{search}{stop}"), true)] {
        let path = jobs.write(name, &job(0.0, 200.0, THIN, &more));
        let output = run(&["plan", path.to_str().unwrap(), "-o", out.to_str().unwrap()]);
        assert_eq!(output.status.success(), good, "{name}: {}", text(&output));
    }
    // The check of the whole pass agrees.
    let report = json_file(out.join("report.json"));
    assert!(report["passes"][0]["clearance"]["nearest_mm"].as_f64().unwrap() >= 0.5);
}

#[test]
fn a_pin_between_two_stations_is_seen() {
    let jobs = Jobs::new();
    // Stations are 52 mm apart on a seam of 5 m.
    let pin = fixture([4.0, 60.0, 60.0], [0.0, 38.0, 40.0]);
    let more = format!("[torch]\ntravel_angle_deg = 8\nsearch = {{ max_work_deg = 40, max_travel_deg = 10 }}\n{pin}");
    let path = jobs.write("pin.toml", &job(-2500.0, 2500.0, THIN, &more));
    let output = run(&["check", path.to_str().unwrap()]);
    assert!(output.status.success(), "{}", text(&output));
}

#[test]
fn the_reason_names_bodies_and_depth_also_within_a_procedure() {
    let jobs = Jobs::new();
    jobs.write(
        "w.toml",
        "schema = 1\nnumber = \"W\"\ntitle = \"t\"\nprocess = 135\n[[runs]]\nname = \"fill\"\nstick_out_mm = [12, 20]\n\
         [[runs]]\nname = \"cap\"\n",
    );
    let more = "[beads]\nwire_mm = 1.2\nwall_tilt_deg = 0\nfill = { area_mm2 = 45, layer_mm = 4 }\n\
                [torch]\ntravel_angle_deg = 8\nsearch = { max_work_deg = 10, max_travel_deg = 10, max_stick_out_mm = 28 }\n";
    let deep = job(0.0, 200.0, "thickness_mm = 40\nangle_deg = 20\nroot_gap_mm = 6", more);
    let path = jobs.write("deep.toml", &deep.replacen("schema = 1\n", "schema = 1\nprocedure = \"w.toml\"\n", 1));
    let output = run(&["check", path.to_str().unwrap()]);
    assert_eq!(output.status.code(), Some(1), "{}", text(&output));
    let said = text(&output);
    assert!(said.contains("gas nozzle") && said.contains("above the root"), "{said}");
    assert!(said.contains("5.0 mm longer"), "no longer than the procedure allows: {said}");
    // One reason for a pass.
    let of_first = said.lines().filter(|line| line.contains("(clearance)") && line.contains("pass 1")).count();
    assert!(of_first <= 1, "{said}");
}

#[test]
fn the_search_ends_at_the_time_limit() {
    let jobs = Jobs::new();
    let stop = fixture([20.0, 100.0, 20.0], [219.0, 0.0, 25.0]);
    let more = format!("[torch]\nsearch = {{ max_work_deg = 60, max_travel_deg = 40 }}\n{stop}");
    let path = jobs.write("slow.toml", &job(0.0, 200.0, THIN, &more));
    let output = run(&["check", path.to_str().unwrap(), "--time-limit", "1e-9"]);
    assert_eq!(output.status.code(), Some(1), "{}", text(&output));
    assert!(text(&output).contains("trying torch angles"), "{}", text(&output));
}

#[test]
fn limits_of_the_stick_out_that_contradict_each_other_are_refused() {
    let jobs = Jobs::new();
    for (torch, allowed) in [
        ("stick_out_mm = 30\nsearch = { max_work_deg = 10, max_stick_out_mm = 20 }", "30"),
        ("search = { max_work_deg = 10, max_stick_out_mm = 10 }", "15"),
    ] {
        let path = jobs.write("a.toml", &job(0.0, 200.0, THIN, &format!("[torch]\n{torch}\n")));
        let output = run(&["check", path.to_str().unwrap()]);
        assert_eq!(output.status.code(), Some(2), "{}", text(&output));
        let said = text(&output);
        assert!(said.contains("max_stick_out_mm") && said.contains(allowed), "{said}");
    }
}
