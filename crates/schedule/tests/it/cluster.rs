//! The program between a schedule and a cluster: one that plans as workers do, and ones that fail.

use seamwright_project::failure::Failure;
use seamwright_schedule::{Schedule, Spark, Summary, Table, Worker};
use serde_json::Value;
use std::io::{BufRead, Read, Write, stdin, stdout};
use std::os::unix::fs::PermissionsExt as _;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

/// Pieces that the program wants at a time.
const WANTED: u64 = 3;
/// Variable with which this program plans as a worker.
const AS_PROGRAM: &str = "SEAMWRIGHT_TEST_WORKER";

/// Saddles, one of which is impossible.
fn saddles(count: usize) -> String {
    let mut text = "name,template,seam.nozzle.radius_mm\nwide,saddle,900\n".to_owned();
    (1..count).for_each(|i| text += &format!("N{i},saddle,{}\n", 240 + i));
    text
}

/// A program of this script instead of Python.
fn program(folder: &Path, script: &str) -> PathBuf {
    let path = folder.join("program");
    std::fs::write(&path, format!("#!/usr/bin/env bash\n{script}")).unwrap();
    std::fs::set_permissions(&path, std::fs::Permissions::from_mode(0o755)).unwrap();
    path
}

/// A program that plans with a [`Worker`]: this one. Lines of the test harness are taken out.
fn planner(folder: &Path) -> PathBuf {
    let own = std::env::current_exe().unwrap();
    let run = "--exact cluster::plans_as_a_program --nocapture";
    program(
        folder,
        &format!("cd /; export {AS_PROGRAM}=1; '{}' {run} | grep --line-buffered '^[{{\"]'\n", own.display()),
    )
}

/// The program that another test starts.
#[test]
fn plans_as_a_program() {
    if std::env::var_os(AS_PROGRAM).is_none() {
        return;
    }
    let (mut input, mut output) = (stdin().lock(), stdout());
    let mut answer = |line: String| {
        output.write_all(format!("\n{line}\n").as_bytes()).unwrap();
        output.flush().unwrap();
    };
    answer(format!("{{\"version\":\"{}\"}}", env!("CARGO_PKG_VERSION")));
    let mut line = String::new();
    input.read_line(&mut line).unwrap();
    let header: Value = serde_json::from_str(&line).unwrap();
    assert_eq!(header["spark"], "sc://nowhere:1");
    let mut task = vec![0; header["task_bytes"].as_u64().unwrap() as usize];
    input.read_exact(&mut task).unwrap();
    let worker = Worker::new(&task).unwrap();
    loop {
        answer(format!("{{\"want\":{WANTED}}}"));
        for _ in 0..WANTED {
            line.clear();
            if input.read_line(&mut line).unwrap() == 0 {
                return;
            }
            if line == "end\n" {
                return answer("\"end\"".into());
            }
            answer(serde_json::json!({ "result": worker.plan(&line).unwrap() }).to_string());
        }
    }
}

fn planned(table: &Path, output: &Path, python: Option<PathBuf>, cancel: &AtomicBool) -> Result<Summary, Failure> {
    let (table, _) = Table::open(table).unwrap();
    let spark = python.map(|python| Spark { address: "sc://nowhere:1".into(), python });
    let schedule = Schedule {
        table: &table,
        output,
        threads: 2,
        spark: spark.as_ref(),
        limit: Duration::from_secs(60),
        post: None,
        cancel: Some(cancel),
    };
    schedule.run(&|_| {})
}

#[test]
fn a_cluster_gives_the_files_of_this_computer() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    std::fs::write(at("table.csv"), saddles(7)).unwrap();
    let no = AtomicBool::new(false);
    planned(&at("table.csv"), &at("here"), None, &no).unwrap();
    let python = planner(folder.path());
    planned(&at("table.csv"), &at("there"), Some(python), &no).unwrap();
    for file in ["schedule.csv", "schedule.parquet", "machines.csv", "report.html"] {
        let [here, there] = ["here", "there"].map(|run| std::fs::read(at(run).join(file)).unwrap());
        assert!(here == there, "{file}");
    }
    let journal = |run: &str| {
        let text = std::fs::read_to_string(at(run).join("rows.jsonl")).unwrap();
        let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
        lines.sort();
        lines
    };
    assert_eq!(journal("here"), journal("there"));
    // Nothing is left: the program is not needed any more.
    let summary = planned(&at("table.csv"), &at("there"), Some(at("missing")), &no).unwrap();
    assert_eq!((summary.rows, summary.kept), (7, 7));
}

#[test]
fn failures_of_the_program_say_what_to_do() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    std::fs::write(at("table.csv"), saddles(2)).unwrap();
    let version = format!("echo '{{\"version\":\"{}\"}}'\n", env!("CARGO_PKG_VERSION"));
    let no = AtomicBool::new(false);
    let code = |python: PathBuf| {
        let error = planned(&at("table.csv"), &at("out"), Some(python), &no).unwrap_err();
        assert_eq!(error.exit_code(), 3, "{error}");
        (error.code().unwrap_or_default(), error.text())
    };
    assert_eq!(code(at("missing")).0, "schedule-spark-no-python");
    for (script, wanted, words) in [
        ("echo '{\"version\":\"0.0.1\"}'; cat >&2\n".to_owned(), "schedule-spark-version", "0.0.1"),
        (
            "echo 'No module named seamwright' >&2; exit 1\n".to_owned(),
            "schedule-spark-ended",
            "No module named seamwright",
        ),
        ("echo '>>> '\n".to_owned(), "schedule-spark-ended", "exit status: 0"),
        (version.clone() + "exit 7\n", "schedule-spark-ended", "exit status: 7"),
        (version.clone() + "echo '{\"no_client\":\"pyspark\"}'\n", "schedule-spark-no-client", "pyspark"),
        (version.clone() + "echo '{\"failed\":\"no route\"}'\n", "schedule-spark-failed", "no route"),
        (version.clone() + "echo '{\"want\":9}'; echo '{\"result\":\"{}\"}'\n", "schedule-task-damaged", ""),
        (version + "echo '{\"want\":9}'; echo '{\"res'\n", "schedule-task-damaged", ""),
    ] {
        let (code, text) = code(program(folder.path(), &script));
        assert!(code == wanted && text.contains(words), "{script}: {text}");
    }
}

#[test]
fn a_cancelled_run_does_not_wait_for_the_cluster() {
    let folder = tempfile::tempdir().unwrap();
    let at = |name: &str| folder.path().join(name);
    std::fs::write(at("table.csv"), saddles(3)).unwrap();
    let version = env!("CARGO_PKG_VERSION");
    // It wants one piece of three, never answers, and goes when its input ends.
    let script = format!("echo '{{\"version\":\"{version}\"}}'; echo '{{\"want\":1}}'; cat >/dev/null\n");
    let (python, cancel) = (program(folder.path(), &script), AtomicBool::new(false));
    let begin = Instant::now();
    let result = std::thread::scope(|scope| {
        scope.spawn(|| {
            std::thread::sleep(Duration::from_millis(300));
            cancel.store(true, Ordering::Relaxed);
        });
        planned(&at("table.csv"), &at("out"), Some(python), &cancel)
    });
    assert!(matches!(result, Err(Failure::Cancelled)));
    assert!(begin.elapsed() < Duration::from_secs(10));
}
