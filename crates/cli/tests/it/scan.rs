//! `seamwright vision scan`: series of simulated profiles and images of known grooves, and bad series.

use crate::common::{bad, column, good, has_all, run, table, write};
use seamwright_simulation::groove::{DistortedPart, Sensor, nozzle_job};
use seamwright_vision::Image;
use seamwright_weld::Welding;
use std::fmt::Write as _;
use std::path::Path;

/// Seed of job and part.
const SEED: u64 = 42;
/// Distance of the profiles, mm.
const STEP_MM: f64 = 25.0;

/// A job and a series of its profiles in a folder.
struct Series {
    job: String,
    table: String,
    /// True gaps and areas by row of the table, in the order of s.
    gaps: Vec<f64>,
    open: Vec<f64>,
}

/// Writes profiles of a distorted nozzle with the metal of a part of the groove, in a mixed order, two of them missing.
fn series(folder: &Path, filled: f64, images: bool) -> Series {
    let text = nozzle_job(SEED);
    let welding = Welding::read("job.toml", &text).unwrap();
    let (joint, seam) = (welding.joint.as_ref().unwrap(), welding.seam.as_ref().unwrap());
    let part = DistortedPart::new(SEED);
    let count = (seam.length() / STEP_MM).ceil() as usize;
    let (mut rows, mut gaps, mut open) = (Vec::new(), Vec::new(), Vec::new());
    for i in 0..count {
        let p = seam.at(seam.length() * i as f64 / count as f64);
        let groove = part.groove(joint, seam, &p, usize::from(filled > 0.0));
        let section = joint.section_with(&groove).unwrap();
        let metal = filled * section.area();
        let name = if i % 7 == 3 {
            String::new()
        } else if images {
            let Image::U8 { width, height, pixels } = Sensor::USUAL.image(&section, metal, 1, i as u64) else {
                panic!()
            };
            let mut bytes = format!("P5\n{width} {height}\n255\n").into_bytes();
            bytes.extend(pixels);
            write(folder, &format!("{i}.pgm"), bytes);
            format!("{i}.pgm")
        } else {
            let points = Sensor::USUAL.profile(&section, metal, 1, i as u64);
            let mut csv = "y_mm,z_mm\n".to_owned();
            points.iter().for_each(|p| writeln!(csv, "{},{}", p.x, p.y).unwrap());
            write(folder, &format!("{i}.csv"), csv);
            format!("{i}.csv")
        };
        rows.push(format!("{},{name}", p.s));
        gaps.push(groove.gap);
        open.push(section.area() - metal);
    }
    rows.reverse();
    rows.swap(0, count / 2);
    let job = write(folder, "job.toml", text);
    Series { job, table: write(folder, "series.csv", format!("s_mm,file\n{}\n", rows.join("\n"))), gaps, open }
}

#[test]
fn a_series_becomes_the_groove_of_a_job_and_of_the_layers_above() {
    let folder = tempfile::tempdir().unwrap();
    let Series { job, table: rows, gaps, .. } = series(folder.path(), 0.0, false);
    let new = folder.path().join("fitted.toml").display().to_string();
    let output = run(&["vision", "scan", &rows, "--job", &job, "-o", &new]);
    let errors = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(0), "{errors}");
    assert!(errors.contains("no profile"), "{errors}");
    let found = table(std::str::from_utf8(&output.stdout).unwrap());
    let (s, gap, uncertainty) =
        (column(&found, "s_mm"), column(&found, "root_gap_mm"), column(&found, "root_gap_u_mm"));
    assert!(s.windows(2).all(|w| w[1] > w[0]) && s.len() == gaps.len());
    let mut measured = 0;
    for i in 0..gaps.len() {
        if gap[i].is_finite() {
            measured += 1;
            assert!((gap[i] - gaps[i]).abs() < 5.0 * uncertainty[i].max(0.02), "{}: {} {}", s[i], gap[i], gaps[i]);
        }
    }
    assert!(measured > gaps.len() / 2 && measured < gaps.len());
    let fitted = std::fs::read_to_string(&new).unwrap();
    assert_eq!(fitted.matches("[[joint.fit_up]]").count(), measured);
    assert!(good(&["vision", "scan", &rows, "--job", &job, "--toml"]).contains("root_gap_mm = "));
    // After a layer: entries of the same layer are replaced, earlier ones stay.
    let under = folder.path().join("layer");
    std::fs::create_dir(&under).unwrap();
    let Series { table: rows, open, .. } = series(&under, 0.3, false);
    let next = folder.path().join("next.toml").display().to_string();
    let found = table(&good(&["vision", "scan", &rows, "--job", &new, "--after-layer", "1", "-o", &next]));
    let (area, uncertainty) = (column(&found, "remaining_mm2"), column(&found, "remaining_u_mm2"));
    for i in (0..open.len()).filter(|i| area[*i].is_finite()) {
        assert!(
            (area[i] - open[i]).abs() < 6.0 * uncertainty[i].max(0.3),
            "{} {} {}",
            area[i],
            open[i],
            uncertainty[i]
        );
    }
    good(&["vision", "scan", &rows, "--job", &next, "--after-layer", "1", "-o", &next]);
    let text = std::fs::read_to_string(&next).unwrap();
    assert_eq!(text.matches("after_layer = 1").count(), area.iter().filter(|a| a.is_finite()).count());
    assert!(text.starts_with(fitted.trim_end()));
    let beads = |job: &str| good(&["tools", "section", job, "--points", "3"]).lines().count();
    assert!(beads(&next) > 3);
}

#[test]
fn images_of_stripes_are_measured_too() {
    let folder = tempfile::tempdir().unwrap();
    let Series { job, table: rows, gaps, .. } = series(folder.path(), 0.0, true);
    let found = table(&good(&["vision", "scan", &rows, "--job", &job, "--mm-per-px", "0.1"]));
    let (gap, uncertainty) = (column(&found, "root_gap_mm"), column(&found, "root_gap_u_mm"));
    let seen: Vec<usize> = (0..gaps.len()).filter(|i| gap[*i].is_finite()).collect();
    assert!(2 * seen.len() > gaps.len());
    for i in seen {
        assert!((gap[i] - gaps[i]).abs() < 0.15 + 5.0 * uncertainty[i], "{} {} {}", gap[i], gaps[i], uncertainty[i]);
    }
    has_all(&bad(2, &["vision", "scan", &rows, "--job", &job]), &["--mm-per-px"]);
}

#[test]
fn a_mirrored_series_is_noticed() {
    let folder = tempfile::tempdir().unwrap();
    let Series { job, table: rows, .. } = series(folder.path(), 0.0, false);
    has_all(&bad(2, &["vision", "scan", &rows, "--job", &job, "--mirrored"]), &["without --mirrored"]);
}

#[test]
fn bad_series_are_refused_with_file_row_and_allowed_values() {
    let folder = tempfile::tempdir().unwrap();
    let Series { job, table: rows, .. } = series(folder.path(), 0.0, false);
    let scan = |text: &str, more: &[&str], words: &[&str]| {
        let series = write(folder.path(), "bad.csv", text);
        let arguments = [&["vision", "scan", &series, "--job", &job], more].concat();
        has_all(&bad(2, &arguments), words);
    };
    scan("s_mm,name\n0,0.csv\n", &[], &["bad.csv", "file", "s_mm,file"]);
    scan("s_mm,file\n0,0.csv\nx,1.csv\n", &[], &["bad.csv:3", "s_mm"]);
    scan("s_mm,file\n0,0.csv\n90000,1.csv\n", &[], &["bad.csv:3", "s_mm", "90000"]);
    scan("s_mm,file\n0,0.csv\n0,1.csv\n", &[], &["bad.csv:3", "another row"]);
    scan("s_mm,file\n0,none.csv\n", &[], &["none.csv"]);
    scan("x_mm,y_mm,z_mm,file\n0,0,9000,0.csv\n", &[], &["bad.csv:2", "beside the seam"]);
    scan("s_mm,file\n0,0.csv\n", &["--turn-deg", "80"], &["--turn-deg", "60"]);
    scan("s_mm,file\n0,0.csv\n", &["--bridge-mm", "0"], &["--bridge-mm"]);
    // Too long a part of the seam without a profile.
    let told = bad(1, &["vision", "scan", &rows, "--job", &job, "--bridge-mm", "30"]);
    has_all(&told, &["no profile shows the joint from s ="]);
    let square = write(
        folder.path(),
        "square.toml",
        nozzle_job(SEED).split("[joint]").next().unwrap().to_owned()
            + "[joint.preparation.flare_bevel]\nradius_mm = 5\n[weld]\nspeed_mm_s = 5\n",
    );
    has_all(&bad(2, &["vision", "scan", &rows, "--job", &square]), &["joint.preparation", "single_v"]);
}
