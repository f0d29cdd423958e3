//! Faults of panel, cell and planner in every mode, while the device watches: arc and gas go off in time, STOP is
//! acknowledged, nothing starts by itself, records and audit log are whole.
//!
//! The table of `docs/explanation/processes.md` states the times.

use crate::cell_process::{Page, Panel, is_off, signal, started};
use crate::common::good;
use crate::modbus_server::TestServer;
use crate::modbus_welder::welder;
use crate::stopped::eventually;
use seamwright_testkit::{Random, soak};
use serde_json::json;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

#[derive(Debug, Clone, Copy, PartialEq)]
enum Target {
    Panel,
    Cell,
    Planner,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Fault {
    /// A signal that ends the process.
    Signal(&'static str),
    /// SIGSTOP for this time, ms.
    Frozen(u64),
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Mode {
    Ready,
    Jog,
    Teach,
    DryRun,
    Weld,
    Hold,
}

const TARGETS: [Target; 3] = [Target::Panel, Target::Cell, Target::Planner];
const FAULTS: [Fault; 8] = [
    // Also what the system does to a process that has taken all memory.
    Fault::Signal("-KILL"),
    // The end after a failed allocation.
    Fault::Signal("-ABRT"),
    // A stack overflow.
    Fault::Signal("-SEGV"),
    Fault::Signal("-TERM"),
    Fault::Signal("-HUP"),
    Fault::Frozen(300),
    Fault::Frozen(1200),
    Fault::Frozen(5000),
];
const MODES: [Mode; 6] = [Mode::Ready, Mode::Jog, Mode::Teach, Mode::DryRun, Mode::Weld, Mode::Hold];

/// Time from a fault to arc and gas off at the device: notice, crater and post-flow of the job, and a poll of a loaded
/// computer.
const OFF_WITHIN: Duration = Duration::from_secs(12);

struct Case {
    target: Target,
    fault: Fault,
    mode: Mode,
}

/// Brings the cell to its mode.
fn enter(panel: &Panel, server: &TestServer, mode: Mode) -> Page {
    if matches!(mode, Mode::Weld | Mode::Hold) {
        let mut page = panel.weld(server);
        if mode == Mode::Hold {
            page.order("hold");
            page.until(|status| status["mode"] == "hold");
        }
        return page;
    }
    let mut page = panel.ready();
    match mode {
        Mode::Jog => page.order("start_jog"),
        Mode::Teach => page.order("start_teach"),
        Mode::DryRun => page.order("start_dry_run"),
        _ => {}
    }
    page
}

fn planner(panel: &Panel) -> Option<String> {
    let text = include_str!("../../../../examples/thick-saddle.toml");
    let body = json!({ "text": text }).to_string();
    let (head, address) = (panel.head("POST /api/plan"), panel.address.clone());
    // Its answer is an error, if one comes.
    std::thread::spawn(move || drop(Panel::send(&address, &head, &body)));
    let mut found = None;
    let begun = Instant::now();
    while found.is_none() && begun.elapsed() < Duration::from_secs(5) {
        let jobs = format!("answer-one-question --jobs {}", panel.data);
        let output = Command::new("pgrep").args(["-f", &jobs]).output().unwrap();
        found = String::from_utf8(output.stdout).unwrap().lines().next().map(str::to_owned);
    }
    found
}

fn inject(process: &str, fault: Fault) {
    match fault {
        // A planner may have answered meanwhile. The first SIGSEGV that comes from outside only removes the handler, which
        // looks for stack overflows.
        Fault::Signal(name) => {
            for _ in 0..if name == "-SEGV" { 2 } else { 1 } {
                drop(Command::new("kill").args([name, process]).stderr(Stdio::null()).status());
                std::thread::sleep(Duration::from_millis(50));
            }
        }
        Fault::Frozen(ms) => {
            drop(Command::new("kill").args(["-STOP", process]).status());
            std::thread::sleep(Duration::from_millis(ms));
            drop(Command::new("kill").args(["-CONT", process]).status());
        }
    }
}

fn run(case: &Case) {
    let Case { target, fault, mode } = *case;
    let about = format!("{target:?} {fault:?} {mode:?}");
    let server = TestServer::new(welder);
    let folder = tempfile::tempdir().unwrap();
    let mut panel = started(folder.path(), &server, "");
    let page = enter(&panel, &server, mode);
    let cell = panel.cell().unwrap();
    let process = match target {
        Target::Panel => Some(panel.child.id().to_string()),
        Target::Cell => Some(cell.clone()),
        Target::Planner => planner(&panel),
    };
    let Some(process) = process else { return };
    page.beat();
    inject(&process, fault);
    let begun = Instant::now();

    // The panel's process ends in order, or is gone.
    let ends = target == Target::Panel && matches!(fault, Fault::Signal(_));
    let in_order = ends && matches!(fault, Fault::Signal("-TERM" | "-HUP"));
    if ends {
        let status = panel.child.wait().unwrap();
        assert_eq!(status.code() == Some(0), in_order, "{about}: {status}");
    }
    // STOP is acknowledged by every cell that lives.
    if !in_order {
        eventually("a cell", || panel.cell().is_some());
        let mut acknowledged = false;
        while !acknowledged && begun.elapsed() < OFF_WITHIN {
            let stop = Command::new(env!("CARGO_BIN_EXE_seamwright")).args(["stop", "--data", &panel.data]).output();
            acknowledged = stop.unwrap().status.success();
        }
        assert!(acknowledged, "{about}: no STOP within {OFF_WITHIN:?}");
    }
    while !is_off(&server) {
        assert!(begun.elapsed() < OFF_WITHIN, "{about}: arc or gas is on after {:?}", begun.elapsed());
        std::thread::sleep(Duration::from_millis(5));
    }
    // Nothing burns again by itself.
    std::thread::sleep(Duration::from_millis(700));
    assert!(is_off(&server), "{about}: it burns again");

    // The next panel finds the cell, or starts one; its data are whole.
    if ends {
        drop(page);
        let next = Panel::start(Path::new(&panel.data), "job.toml");
        Page::open(&next).until(|status| status["mode"] != "weld");
        signal("-TERM", &next.child.id().to_string());
        let mut next = next;
        assert_eq!(next.child.wait().unwrap().code(), Some(0), "{about}");
    } else {
        signal("-TERM", &panel.child.id().to_string());
        drop(page);
        assert_eq!(panel.child.wait().unwrap().code(), Some(0), "{about}");
    }
    assert!(is_off(&server), "{about}");
    good(&["records", "recover", "--data", &panel.data]);
    good(&["records", "verify", "--data", &panel.data]);
}

fn campaign(cases: u32, lanes: u32) {
    std::thread::scope(|scope| {
        for lane in 0..lanes {
            scope.spawn(move || {
                for number in (lane..cases).step_by(lanes as usize) {
                    let mut random = Random::of_case(number);
                    let case = Case {
                        target: TARGETS[number as usize % TARGETS.len()],
                        fault: *random.one(&FAULTS),
                        mode: *random.one(&MODES),
                    };
                    run(&case);
                }
            });
        }
    });
}

#[test]
fn faults_of_processes_leave_nothing_on() {
    campaign(60, 6);
}

#[test]
#[ignore = "1,000 combinations in real time; make soak"]
fn a_thousand_faults_of_processes() {
    campaign(if soak().is_some() { 1000 } else { 60 }, 6);
}
