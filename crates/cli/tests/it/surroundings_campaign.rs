//! Faults around a cell that welds on a Modbus source: disk, library, device, clients. STOP is acknowledged in every one
//! of them, arc and gas go off at the device, and record and audit log are whole.
//!
//! The table of `docs/explanation/processes.md` states the times; `make soak` prints those of this computer.

use crate::cell_process::{Panel, is_off, signal, started_in};
use crate::common::good;
use crate::modbus_server::TestServer;
use crate::modbus_welder::welder;
use seamwright_cell::StopLine;
use seamwright_executive::Ask;
use seamwright_record::DataFolder;
use seamwright_record::library::{Query, WeldResult};
use seamwright_record::trace::Trace;
use seamwright_testkit::{Random, soak};
use std::fs::File;
use std::io::{Read as _, Write as _};
use std::net::TcpStream;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

#[derive(Debug, Clone, Copy, PartialEq)]
enum Fault {
    /// None, for comparison.
    Nothing,
    /// Not a byte is free.
    DiskFull,
    /// Every access waits for three seconds.
    DiskHangs,
    /// Another program holds the database.
    LibraryLocked,
    /// Answers come 0.18 s late.
    SlowDevice,
    /// 300 clients send one byte of a request now and then.
    SlowClients,
    /// Eight clients are refused as fast as they ask.
    Refusals,
}

const FAULTS: [Fault; 7] = [
    Fault::Nothing,
    Fault::DiskFull,
    Fault::DiskHangs,
    Fault::LibraryLocked,
    Fault::SlowDevice,
    Fault::SlowClients,
    Fault::Refusals,
];

/// Duration of a fault before STOP.
const LASTS: Duration = Duration::from_millis(1500);
/// Maximum time from STOP to arc and gas off at the device, as for faults of processes.
const OFF_WITHIN: Duration = Duration::from_secs(12);
/// Size of the file system that becomes full: the room that a weld must find is 64 MB and twice its trace.
const SMALL: &str = "size=256m";

/// A file system for the data, mounted while this lives.
struct Disk {
    at: PathBuf,
    /// Its process, for a file system in user space.
    process: Option<Child>,
}

impl Disk {
    /// Mounts a small file system in memory at `at`; `None` without the right to do so.
    fn small(at: &Path) -> Option<Self> {
        let mount = Command::new("mount").args(["-t", "tmpfs", "-o", SMALL, "none"]).arg(at).output().ok()?;
        mount.status.success().then(|| Self { at: at.to_owned(), process: None })
    }

    /// Mounts a file system in user space, whose process can be frozen; `None` without that program, or without the right.
    fn frozen(at: &Path, real: &Path) -> Option<Self> {
        std::fs::create_dir_all(real).unwrap();
        let mut bindfs = Command::new("bindfs");
        bindfs.arg("-f").args([real, at]).stdout(Stdio::null()).stderr(Stdio::null());
        let mut process = bindfs.spawn().ok()?;
        let mounted = || std::fs::read_to_string("/proc/mounts").unwrap().contains(&format!(" {} fuse", at.display()));
        let begun = Instant::now();
        while !mounted() && begun.elapsed() < Duration::from_secs(5) {
            std::thread::sleep(Duration::from_millis(10));
        }
        if mounted() {
            return Some(Self { at: at.to_owned(), process: Some(process) });
        }
        drop(process.kill());
        drop(process.wait());
        None
    }
}

impl Drop for Disk {
    fn drop(&mut self) {
        if let Some(process) = &self.process {
            drop(Command::new("kill").args(["-CONT", &process.id().to_string()]).status());
        }
        drop(Command::new("umount").arg("-l").arg(&self.at).status());
        if let Some(process) = &mut self.process {
            drop(process.kill());
            drop(process.wait());
        }
    }
}

/// Clients in threads of their own, until this is dropped.
struct Clients(Arc<AtomicBool>, Vec<std::thread::JoinHandle<()>>);

impl Clients {
    fn start(count: usize, client: impl Fn(&AtomicBool) + Send + Clone + 'static) -> Self {
        let over = Arc::new(AtomicBool::new(false));
        let threads = (0..count).map(|_| {
            let (over, client) = (Arc::clone(&over), client.clone());
            std::thread::spawn(move || client(&over))
        });
        Self(Arc::clone(&over), threads.collect())
    }
}

impl Drop for Clients {
    fn drop(&mut self) {
        self.0.store(true, Ordering::SeqCst);
        self.1.drain(..).for_each(|thread| thread.join().unwrap());
    }
}

/// Sends a request byte by byte.
fn dawdle(address: &str, over: &AtomicBool) {
    let mut stream = TcpStream::connect(address).ok();
    while !over.load(Ordering::SeqCst) {
        if stream.as_mut().is_none_or(|stream| stream.write_all(b"G").is_err()) {
            stream = TcpStream::connect(address).ok();
        }
        std::thread::sleep(Duration::from_millis(200));
    }
}

fn be_refused(address: &str, over: &AtomicBool) {
    while !over.load(Ordering::SeqCst) {
        let Ok(mut stream) = TcpStream::connect(address) else { continue };
        drop(write!(stream, "GET /api/users HTTP/1.1\r\nhost: {address}\r\nconnection: close\r\n\r\n"));
        drop(stream.read_to_end(&mut Vec::new()));
    }
}

/// Resources of a fault while it lasts.
enum Held {
    Nothing,
    Filler(PathBuf),
    Frozen(u32),
    Library(rusqlite::Connection),
    Device,
    Clients { _clients: Clients },
}

fn inject(fault: Fault, disk: Option<&Disk>, panel: &Panel, server: &TestServer) -> Held {
    let address = panel.address.clone();
    match fault {
        Fault::Nothing => Held::Nothing,
        Fault::DiskFull => {
            let path = Path::new(&panel.data).join("filler");
            let mut filler = File::create(&path).unwrap();
            while filler.write(&[1; 4096]).is_ok_and(|written| written > 0) {}
            Held::Filler(path)
        }
        Fault::DiskHangs => {
            let process = disk.unwrap().process.as_ref().unwrap().id();
            signal("-STOP", &process.to_string());
            Held::Frozen(process)
        }
        Fault::LibraryLocked => {
            let library = rusqlite::Connection::open(Path::new(&panel.data).join("library.sqlite")).unwrap();
            library.busy_timeout(Duration::from_secs(5)).unwrap();
            library.execute_batch("BEGIN EXCLUSIVE").unwrap();
            Held::Library(library)
        }
        Fault::SlowDevice => {
            server.answer_after(Duration::from_millis(180));
            Held::Device
        }
        Fault::SlowClients => Held::Clients { _clients: Clients::start(300, move |over| dawdle(&address, over)) },
        Fault::Refusals => Held::Clients { _clients: Clients::start(8, move |over| be_refused(&address, over)) },
    }
}

impl Held {
    fn release(self, server: &TestServer) {
        match self {
            Self::Nothing | Self::Clients { .. } => {}
            Self::Filler(path) => std::fs::remove_file(path).unwrap(),
            Self::Frozen(process) => signal("-CONT", &process.to_string()),
            Self::Library(library) => library.execute_batch("ROLLBACK").unwrap(),
            Self::Device => server.answer_after(Duration::ZERO),
        }
    }
}

/// Times of a case.
struct Times {
    stop: Duration,
    off: Duration,
}

/// Runs a case; `None` if its file system cannot be mounted here.
fn run(fault: Fault) -> Option<Times> {
    let server = TestServer::new(welder);
    let folder = tempfile::tempdir().unwrap();
    let data = folder.path().join("data");
    std::fs::create_dir_all(&data).unwrap();
    let disk = match fault {
        Fault::DiskFull => Some(Disk::small(&data)?),
        Fault::DiskHangs => Some(Disk::frozen(&data, &folder.path().join("real"))?),
        _ => None,
    };
    let mut panel = started_in(folder.path(), &data, &server, "");
    let page = panel.weld(&server);
    // As the panel does: the line is open before anything goes wrong.
    let mut line = StopLine::new(&data.join("cell"));
    line.keep();
    let held = inject(fault, disk.as_ref(), &panel, &server);
    let begun = Instant::now();
    while begun.elapsed() < LASTS {
        page.beat();
        line.keep();
        std::thread::sleep(Duration::from_millis(100));
    }
    let begun = Instant::now();
    let cycle = line.ask(&Ask::Stop).unwrap_or_else(|e| panic!("{fault:?}: {e}"));
    let stop = begun.elapsed();
    assert!(cycle.is_some(), "{fault:?}");
    while !is_off(&server) {
        assert!(begun.elapsed() < OFF_WITHIN, "{fault:?}: arc or gas is on after {:?}", begun.elapsed());
        std::thread::sleep(Duration::from_millis(5));
    }
    let off = begun.elapsed();
    if fault == Fault::DiskHangs {
        std::thread::sleep(Duration::from_secs(3).saturating_sub(LASTS + begun.elapsed()));
    }
    held.release(&server);
    drop(page);
    signal("-TERM", &panel.child.id().to_string());
    let ended = panel.child.wait().unwrap();
    assert_eq!(ended.code(), Some(0), "{fault:?}");
    assert!(is_off(&server), "{fault:?}: it burns again");
    whole_record(fault, &data);
    drop(panel);
    drop(disk);
    Some(Times { stop, off })
}

/// The record has all rows until the power is off, and the audit log is whole.
fn whole_record(fault: Fault, data: &Path) {
    good(&["records", "verify", "--data", &data.display().to_string()]);
    let data = DataFolder::open_to_read(data).unwrap();
    let welds = data.library().find(&Query::default()).unwrap();
    assert!(welds.len() == 1 && welds[0].result == WeldResult::Stopped, "{fault:?}: {welds:?}");
    assert!(!welds[0].note.to_string().contains("lost"), "{fault:?}: {}", welds[0].note);
    let trace = Trace::open(&data.weld_folder(welds[0].id).join("trace.parquet")).unwrap();
    let (mut rows, mut burning) = (0, false);
    trace
        .read(&["burning"], |row| {
            rows += 1;
            burning = row[0] > 0.0;
        })
        .unwrap();
    assert!(rows > 100 && !burning, "{fault:?}: {rows} rows, burning at the end: {burning}");
}

fn one(fault: Fault) {
    match run(fault) {
        Some(Times { stop, off }) => println!("{fault:?}: STOP {stop:.1?}, off at the device {off:.1?}"),
        None => eprintln!("\n!!! SKIPPED {fault:?}: its file system cannot be mounted here\n"),
    }
}

#[test]
fn a_full_disk() {
    one(Fault::DiskFull);
}

#[test]
fn a_disk_that_hangs() {
    one(Fault::DiskHangs);
}

#[test]
fn a_locked_library() {
    one(Fault::LibraryLocked);
}

#[test]
fn a_slow_device() {
    one(Fault::SlowDevice);
}

#[test]
fn slow_clients() {
    one(Fault::SlowClients);
}

#[test]
fn a_flood_of_refusals() {
    one(Fault::Refusals);
}

/// Numbers of the cell's process, kB: memory in use, and memory locked.
fn memory(process: &str) -> (u64, u64) {
    let status = std::fs::read_to_string(format!("/proc/{process}/status")).unwrap();
    let of =
        |key: &str| status.lines().find_map(|line| line.strip_prefix(key)?.split_whitespace().next()?.parse().ok());
    (of("VmRSS:").unwrap(), of("VmLck:").unwrap())
}

/// A job as somebody types it: lines and numbers of `text` changed at random.
fn mutated(text: &str, random: &mut Random) -> String {
    const NUMBERS: [&str; 8] = ["0", "-1", "8000", "1e20", "1e-308", "nan", "99999999999", "[1, 2"];
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    for _ in 0..1 + random.below(3) {
        let at = random.below(lines.len());
        match random.below(4) {
            0 => drop(lines.remove(at)),
            1 => lines.insert(at, lines[at].clone()),
            2 => lines[at] = lines[at].chars().take(lines[at].chars().count() / 2).collect(),
            _ => {
                if let Some((key, _)) = lines[at].clone().split_once('=') {
                    lines[at] = format!("{key}= {}", random.one(&NUMBERS));
                }
            }
        }
    }
    lines.join("\n")
}

/// Drafts of `count` random jobs beside a weld, which is started again as often as it ends; 20 s without any for none.
/// Returns the number of missed cycles an hour.
fn missed_beside_drafts(count: usize) -> f64 {
    let server = TestServer::new(welder);
    let folder = tempfile::tempdir().unwrap();
    let panel = started_in(folder.path(), &folder.path().join("data"), &server, "");
    let mut page = panel.weld(&server);
    let cell = panel.cell().unwrap();
    let before = memory(&cell);
    let begun = Instant::now();
    let (head, address) = (panel.head("POST /api/draft"), panel.address.clone());
    let drafts = std::thread::spawn(move || {
        let text = include_str!("../../../../examples/thick-saddle.toml");
        let mut random = Random::new(45);
        if count == 0 {
            std::thread::sleep(Duration::from_secs(20));
        }
        let mut answered = 0;
        for _ in 0..count {
            let body = serde_json::json!({ "text": mutated(text, &mut random) }).to_string();
            let answer = Panel::send(&address, &head, &body);
            answered += usize::from(["HTTP/1.1 200", "HTTP/1.1 422"].iter().any(|status| answer.starts_with(status)));
        }
        answered
    });
    let (mut missed, mut first) = (0, None);
    while !drafts.is_finished() {
        let status = page.status();
        missed = status["missed"].as_u64().unwrap();
        first.get_or_insert(missed);
        if status["mode"] == "ready" {
            page.order("arm");
            page.start_weld();
            page.until(|status| status["mode"] == "weld");
        }
        assert!(["ready", "weld"].contains(&status["mode"].as_str().unwrap()), "{status}");
    }
    let answered = drafts.join().unwrap();
    assert!(answered >= count * 9 / 10, "{answered} of {count} drafts were answered");
    let hours = begun.elapsed().as_secs_f64() / 3600.0;
    let after = memory(&cell);
    println!(
        "{count} drafts: {} cycles missed in {hours:.3} h; kB in use, locked: {before:?}, {after:?}",
        missed - first.unwrap_or(missed)
    );
    assert!(after.0 < before.0 + 8192, "the memory of the cell grows: {before:?}, {after:?}");
    (missed - first.unwrap_or(missed)) as f64 / hours
}

#[test]
fn drafts_of_random_jobs_beside_a_weld() {
    missed_beside_drafts(30);
}

#[test]
#[ignore = "10,000 drafts beside a weld; make soak"]
fn ten_thousand_drafts_of_random_jobs_beside_a_weld() {
    let idle = missed_beside_drafts(0);
    let beside = missed_beside_drafts(if soak().is_some() { 10_000 } else { 300 });
    println!("missed cycles an hour: {idle:.0} without, {beside:.0} beside drafts");
}

/// Prints the distribution of times for the table of the docs.
#[test]
#[ignore = "20 welds of each fault; make soak"]
fn times_of_stop_under_every_fault() {
    let count = if soak().is_some() { 20 } else { 2 };
    for fault in FAULTS {
        let times: Vec<Times> = (0..count).filter_map(|_| run(fault)).collect();
        let Some(worst) = times.iter().map(|times| times.stop).max() else { continue };
        let mut off: Vec<Duration> = times.iter().map(|times| times.off).collect();
        off.sort();
        println!("| {fault:?} | {worst:.1?} | {:.1?} | {:.1?} |", off[off.len() / 2], off[off.len() - 1]);
        assert!(worst <= Duration::from_millis(50), "{fault:?}: STOP took {worst:?}");
    }
}
