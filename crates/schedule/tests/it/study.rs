//! Studies: reproducible, interrupted, against independent values, and wrong.

use seamwright_project::examples::example;
use seamwright_schedule::{Overrides, Study, StudyProgress, StudyRun, StudySummary};
use seamwright_testkit::cases;
use std::collections::HashMap;
use std::path::Path;
use std::sync::Mutex;
use std::time::Duration;

const HEAD: &str = "schema = 1\njob = \"saddle\"\nseed = 4\n";
const HEIGHT: &str =
    "[[quantities]]\nname = \"z\"\nvary.work = \"z_mm\"\ndraw.normal = { deviation = 3, within = 9 }\n";

fn study(folder: &Path, text: &str) -> Result<Study, String> {
    let path = folder.join("study.toml");
    std::fs::write(&path, text).unwrap();
    Study::open(&path, Overrides::default()).map_err(|failure| failure.text())
}

fn run(study: &Study, output: &Path, threads: usize) -> (StudySummary, StudyProgress) {
    let last = Mutex::new(StudyProgress { done: 0, kept: 0 });
    let run = StudyRun { study, output, threads, spark: None, limit: Duration::from_secs(60), cancel: None };
    let (summary, files) = run.run(&|progress| *last.lock().unwrap() = progress).unwrap();
    assert!(files.iter().all(|file| file.is_file()));
    let progress = *last.lock().unwrap();
    assert_eq!(progress.done, run.plans());
    (summary, progress)
}

fn rows(output: &Path) -> Vec<HashMap<String, String>> {
    let mut reader = csv::Reader::from_path(output.join("draws.csv")).unwrap();
    reader.deserialize().map(Result::unwrap).collect()
}

fn number(row: &HashMap<String, String>, column: &str) -> f64 {
    row[column].parse().unwrap_or_else(|_| panic!("{column}: {row:?}"))
}

#[test]
fn the_same_seed_gives_the_same_rows_with_any_number_of_threads() {
    let folder = tempfile::tempdir().unwrap();
    let text = format!("{HEAD}draws = 6\nsampling = \"random\"\n{HEIGHT}");
    let opened = study(folder.path(), &text).unwrap();
    let outputs = [1, 2].map(|threads| {
        let output = folder.path().join(format!("{threads}"));
        run(&opened, &output, threads);
        ["draws.csv", "summary.json"].map(|name| std::fs::read(output.join(name)).unwrap())
    });
    assert_eq!(outputs[0], outputs[1]);
    // More draws keep the first ones, and another seed has others.
    let more = study(folder.path(), &text.replace("draws = 6", "draws = 9")).unwrap();
    assert!((0..6).all(|row| more.values(row) == opened.values(row)));
    let other = study(folder.path(), &text.replace("seed = 4", "seed = 5")).unwrap();
    assert_ne!(other.values(0), opened.values(0));
    let (_, progress) = run(&more, &folder.path().join("1"), 2);
    assert_eq!((progress.done, progress.kept), (12, 9));
}

#[test]
fn an_interrupted_study_goes_on() {
    let folder = tempfile::tempdir().unwrap();
    let output = folder.path().join("out");
    let opened = study(folder.path(), &format!("{HEAD}draws = 5\n{HEIGHT}")).unwrap();
    run(&opened, &output, 2);
    let results = std::fs::read(output.join("draws.csv")).unwrap();
    // As if it had been killed while the fifth result was written.
    let journal = std::fs::read(output.join("draws.jsonl")).unwrap();
    let ends: Vec<usize> = (0..journal.len()).filter(|i| journal[*i] == b'\n').collect();
    std::fs::write(output.join("draws.jsonl"), &journal[..ends[3] + 30]).unwrap();
    std::fs::remove_file(output.join("draws.csv")).unwrap();
    let (_, progress) = run(&opened, &output, 1);
    assert_eq!((progress.done, progress.kept), (8, 4));
    assert_eq!(std::fs::read(output.join("draws.csv")).unwrap(), results);
}

/// The lift of the saddle's machine is parallel to z: a nozzle that stands higher by z, or a lift that stands further by
/// its error, changes the lift's positions and so its margin one to one.
#[test]
fn an_error_along_a_linear_axis_changes_its_margin_one_to_one() {
    let folder = tempfile::tempdir().unwrap();
    let draws = cases(40u16);
    for (vary, sense) in [("work = \"z_mm\"", 1.0), ("axis_error = \"h\"", -1.0)] {
        let text = format!("{HEAD}draws = {draws}\n{}", HEIGHT.replace("work = \"z_mm\"", vary));
        let output = folder.path().join(vary.replace(['"', ' '], ""));
        let (summary, _) = run(&study(folder.path(), &text).unwrap(), &output, 2);
        let figure = summary.figures.iter().find(|figure| figure.name == "margin_h_mm").unwrap();
        let nominal = figure.nominal.unwrap();
        let mut signs = Vec::new();
        for row in rows(&output) {
            let change = number(&row, "margin_h_mm") - nominal;
            let z = sense * number(&row, "z");
            assert!((change.abs() - z.abs()).abs() < 1e-6, "{vary}: {change} for {z}");
            signs.push(change * z > 0.0);
            assert!(number(&row, "correction_mm") < 1e-6 + if sense > 0.0 { z.abs() } else { 0.0 });
        }
        // One end of the range is the nearer one throughout.
        assert!(signs.iter().all(|sign| *sign == signs[0]), "{signs:?}");
        let error = figure.standard_error;
        assert!((figure.mean - nominal).abs() < 3.0 * error, "{} {nominal} {error}", figure.mean);
        // Of a normal distribution cut at three deviations.
        assert!((figure.deviation - 3.0 * 0.986_6).abs() < 3.0 * figure.deviation / (2.0 * f64::from(draws)).sqrt());
        let index = &figure.indices[0].index;
        assert!((index.estimate - 1.0).abs() < 1e-6, "{index:?}");
        assert!((summary.weldable.estimate - 1.0).abs() < 1e-12 && summary.weldable.low > 0.9);
    }
}

#[test]
fn draws_that_fail_are_results_and_sweeps_have_curves() {
    let folder = tempfile::tempdir().unwrap();
    let output = folder.path().join("out");
    // The shell's radius is 800; the lift has 300 mm, of which 400 leave nothing.
    let text = format!(
        "{HEAD}draws = 2\n\
         [[quantities]]\nname = \"r\"\nvary.job_key = \"seam.nozzle.radius_mm\"\ndraw.values = [250, 900]\n\
         [[quantities]]\nname = \"h\"\nvary.work = \"z_mm\"\ndraw.values = [0, 400]\n\
         [[quantities]]\nname = \"x\"\nvary.work = \"x_mm\"\ndraw.uniform = {{ within = 1 }}\n"
    );
    let (summary, _) = run(&study(folder.path(), &text).unwrap(), &output, 2);
    let rows = rows(&output);
    assert_eq!((summary.draws, rows.len()), (8, 8));
    for row in &rows {
        let expected = match (row["r"].as_str(), row["h"].as_str()) {
            ("250", "0") => "weldable",
            ("250", _) => "not_weldable",
            _ => "invalid",
        };
        assert_eq!(row["status"], expected, "{row:?}");
        assert_eq!(expected == "invalid", row["error"].contains("seam.nozzle.radius_mm"), "{row:?}");
        assert_eq!(expected == "not_weldable", row["findings"].contains("motion-beyond-range"), "{row:?}");
        if expected == "not_weldable" {
            assert!(number(row, "margin_h_mm") < 0.0 && number(row, "margin_percent") < 0.0);
        }
    }
    // Draws of x are common to all combinations.
    assert_eq!(rows[0]["x"], rows[3]["x"]);
    assert_ne!(rows[0]["x"], rows[4]["x"]);
    let height = summary.sweeps.iter().find(|sweep| sweep.quantity == "h").unwrap();
    let weldable: Vec<f64> = height.points.iter().map(|point| point.weldable.estimate).collect();
    assert_eq!(weldable, [0.5, 0.0]);
    let finding = summary.findings.iter().find(|f| f.code == "motion-beyond-range").unwrap();
    assert!(finding.draws == 2 && finding.probability.low > 0.0 && finding.probability.high < 1.0);
}

#[test]
fn joints_and_tilts_vary_too() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("job.toml"), example("hillside").unwrap().text).unwrap();
    let text = "schema = 1\njob = \"job.toml\"\n\
        [[quantities]]\nname = \"gap\"\nvary.job_key = \"joint.preparation.t_bevel.root_gap_mm\"\ndraw.values = [2, 3]\n\
        [[quantities]]\nname = \"tilt\"\nvary.work = \"turn_x_deg\"\ndraw.values = [0, 1]\n";
    let output = folder.path().join("out");
    let (summary, progress) = run(&study(folder.path(), text).unwrap(), &output, 2);
    assert_eq!((summary.draws, progress.done), (4, 9));
    for row in rows(&output) {
        let (deviation, correction) = (number(&row, "fill_deviation_percent"), number(&row, "correction_mm"));
        // The nominal plan has a gap of 2 mm: a wider groove lacks metal.
        assert!(if row["gap"] == "2" { deviation.abs() < 1e-6 } else { deviation < -1.0 }, "{row:?}");
        // The seam lies about 60 mm from the axis about which it is tilted: 1 degree moves it by more than 1 mm.
        assert_eq!(correction > 1.0, row["tilt"] == "1", "{row:?}");
    }
}

#[test]
fn keys_of_the_machine_vary_too() {
    let folder = tempfile::tempdir().unwrap();
    let text = format!(
        "{HEAD}[[quantities]]\nname = \"v\"\nvary.machine_key = \"tool[3].max_speed_mm_s\"\ndraw.values = [1, 50]\n"
    );
    let output = folder.path().join("out");
    run(&study(folder.path(), &text).unwrap(), &output, 2);
    for row in rows(&output) {
        // The lift needs about 3 mm/s at the requested speed.
        let keeps = row["status"] == "weldable" && number(&row, "speed_percent") > 99.9;
        assert_eq!(keeps, row["v"] == "50", "{row:?}");
    }
}

#[test]
fn faults_name_the_key() {
    let folder = tempfile::tempdir().unwrap();
    let with = |vary: &str, draw: &str| format!("{HEAD}[[quantities]]\nvary.{vary}\ndraw.{draw}\n");
    let normal = "normal = { deviation = 1 }";
    for (text, parts) in [
        (with("job_key = \"seam.nozzle.radius_cm\"", normal), ["quantities[0].vary.job_key", "seam.nozzle.radius_mm"]),
        (with("job_key = \"title\"", normal), ["quantities[0].vary.job_key", "study-not-a-number"]),
        (
            with("machine_key = \"tool[99].range_mm[0]\"", normal),
            ["quantities[0].vary.machine_key", "study-key-unknown"],
        ),
        (with("axis_error = \"hh\"", normal), ["quantities[0].vary.axis_error", "beta"]),
        (with("work = \"z_mm\"", "normal = { deviation = -1 }"), ["quantities[0].draw.normal.deviation", "-1"]),
        (
            with("work = \"z_mm\"", "uniform = { min = 2, max = 1 }"),
            ["quantities[0].draw.uniform.min", "study-min-above-max"],
        ),
        (with("job_key = \"weld.weave.amplitude_mm\"", normal), ["quantities[0]", "study"]),
        (format!("{HEAD}{HEIGHT}{HEIGHT}"), ["quantities[1].vary.work", "study-quantity-twice"]),
        (HEAD.to_owned(), ["quantities", "study-no-quantities"]),
        (format!("{HEAD}draws = 20000000\n{HEIGHT}"), ["draws", "10000000"]),
        (format!("{HEAD}{}", HEIGHT.replace("\"z\"", "\"total_s\"")), ["quantities[0].name", "study-name-taken"]),
        (format!("{HEAD}{HEIGHT}").replace("saddle", "sadle"), ["study.toml:2", "study-job-unreadable"]),
    ] {
        let Err(error) = study(folder.path(), &text) else { panic!("{text}") };
        assert!(parts.iter().all(|part| error.replace(',', "").contains(part)), "{text}{error}");
    }
    // An invalid job is refused; a job without a plan is studied.
    let job = example("saddle").unwrap().text;
    std::fs::write(folder.path().join("bad.toml"), job.replace("radius_mm = 250", "radius_mm = 2500")).unwrap();
    std::fs::write(folder.path().join("far.toml"), job.replace("[0, 0, -800]", "[0, 0, 800]")).unwrap();
    let of = |name: &str| format!("{HEAD}draws = 2\n{HEIGHT}").replace("\"saddle\"", &format!("\"{name}\""));
    let Err(error) = study(folder.path(), &of("bad.toml")) else { panic!("valid") };
    assert!(error.contains("bad.toml") && error.contains("radius_mm"), "{error}");
    let (summary, _) = run(&study(folder.path(), &of("far.toml")).unwrap(), &folder.path().join("out"), 1);
    assert_eq!((summary.nominal.status, summary.outcomes["not_weldable"]), ("not_weldable", 2));
}

/// A million draws are addressed, not stored.
#[test]
fn a_million_draws_are_counted_without_being_made() {
    let folder = tempfile::tempdir().unwrap();
    for sampling in ["random", "latin_hypercube", "sobol"] {
        let text = format!("{HEAD}draws = 1000000\nsampling = \"{sampling}\"\n{HEIGHT}");
        let opened = study(folder.path(), &text).unwrap();
        assert_eq!(opened.rows(), 1_000_000);
        assert!(opened.values(999_999)[0].abs() <= 9.0);
    }
}
