//! LinuxCNC's programs: start, output, end.

use super::error::LinuxCncError;
use super::error::Symptom;
use crate::realtime::RealtimeRights;
use seamwright_message::{Message, Unit};
use std::io::{BufRead as _, BufReader, ErrorKind, Read, Write as _};
use std::os::unix::process::CommandExt as _;
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};
use std::sync::mpsc::channel;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

/// Size limit of a program's kept output, bytes.
const KEPT: usize = 4000;
/// Interval between checks for an end.
const LOOK: Duration = Duration::from_millis(5);
/// Maximum time to execute a HAL file.
const TAKES: Duration = Duration::from_secs(30);
/// Maximum time until HAL starts.
const BEGINS: Duration = Duration::from_secs(5);
/// Maximum time for an orderly end.
const ENDS: Duration = Duration::from_secs(10);

/// The user that runs HAL: HAL refuses root.
#[derive(Debug, Clone)]
pub(super) struct User {
    /// A different user: user, group, and the socket of the real-time program.
    other: Option<(u32, u32, PathBuf)>,
}

impl User {
    /// Returns our own user, or `nobody` if we are root.
    pub(super) fn find() -> Result<Self, LinuxCncError> {
        if !rustix::process::geteuid().is_root() {
            return Ok(Self { other: None });
        }
        let users = std::fs::read_to_string("/etc/passwd").unwrap_or_default();
        let nobody = users.lines().find_map(|line| {
            let mut words = line.split(':');
            let name = words.next()?;
            let (user, group) = (words.nth(1)?.parse().ok()?, words.next()?.parse().ok()?);
            (name == "nobody").then_some((user, group))
        });
        let Some((user, group)) = nobody else {
            return Err(LinuxCncError::System(Message::new("cell-hal-refuses-root")));
        };
        let socket = std::env::temp_dir().join(format!("seamwright-rtapi-{}", std::process::id()));
        Ok(Self { other: Some((user, group, socket)) })
    }

    fn command(&self, program: &str, args: &[&str]) -> Command {
        let mut command = Command::new(program);
        // C number format and messages; a process group of its own, so that the terminal's interrupt does not end it.
        command.args(args).env("LC_ALL", "C").process_group(0);
        if let Some((user, group, socket)) = &self.other {
            command.uid(*user).gid(*group).env("RTAPI_FIFO_PATH", socket).current_dir("/");
        }
        command
    }
}

#[derive(Debug, Clone, Default)]
struct ErrorOutput(Arc<Mutex<String>>);

impl ErrorOutput {
    fn listen(&self, from: impl Read + Send + 'static) {
        let output = Arc::clone(&self.0);
        std::thread::spawn(move || {
            for line in BufReader::new(from).lines().map_while(Result::ok) {
                let mut output = output.lock().unwrap_or_else(PoisonError::into_inner);
                if output.len() < KEPT && !line.starts_with("Note: Using POSIX") {
                    *output += line.trim_end();
                    output.push('\n');
                }
            }
        });
    }

    fn message(&self) -> Message {
        // Output written just before an end takes a moment to arrive.
        std::thread::sleep(Duration::from_millis(30));
        let output = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let output = output.trim_end();
        match output {
            "" => Message::new("cell-hal-no-output"),
            output => Message::verbatim(output.replace('\n', "\n   ")),
        }
    }
}

#[derive(Debug)]
pub(super) struct Program {
    child: Child,
    output: ErrorOutput,
}

/// Starts a program. If the system grants real-time priority, `urgent` ones have it.
pub(super) fn start(user: &User, program: &str, args: &[&str], urgent: bool) -> Result<Program, LinuxCncError> {
    let mut command = user.command(program, args);
    command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    spawn(command, program, urgent)
}

fn spawn(mut command: Command, program: &str, urgent: bool) -> Result<Program, LinuxCncError> {
    // A child inherits the priority of its parent thread: use a separate thread, so that ours keeps its priority.
    let started = std::thread::scope(|scope| {
        let starts = scope.spawn(|| {
            if urgent {
                RealtimeRights::ask_below_cycle();
            }
            command.spawn()
        });
        starts.join().unwrap_or_else(|_| Err(std::io::Error::other("its thread ended early")))
    });
    let mut child = started.map_err(|error| match error.kind() {
        ErrorKind::NotFound => LinuxCncError::NotInstalled(program.to_owned()),
        _ => LinuxCncError::System(Message::verbatim(format!("{program}: {error}"))),
    })?;
    let output = ErrorOutput::default();
    if let Some(stderr) = child.stderr.take() {
        output.listen(stderr);
    }
    Ok(Program { child, output })
}

impl Program {
    pub(super) fn stdin(&mut self) -> Option<ChildStdin> {
        self.child.stdin.take()
    }

    pub(super) fn stdout(&mut self) -> Option<ChildStdout> {
        self.child.stdout.take()
    }

    pub(super) fn error_output(&self) -> Message {
        self.output.message()
    }

    /// Waits for its end; returns whether it succeeded, or `None` if it takes longer.
    fn ends_within(&mut self, most: Duration) -> Option<bool> {
        let begun = Instant::now();
        loop {
            match self.child.try_wait() {
                Ok(Some(status)) => return Some(status.success()),
                Ok(None) if begun.elapsed() < most => std::thread::sleep(LOOK),
                _ => return None,
            }
        }
    }

    pub(super) fn has_ended(&mut self) -> bool {
        self.ends_within(Duration::ZERO).is_some()
    }

    /// Ends it, by force if it takes too long; its standard input must be closed.
    pub(super) fn end(&mut self, most: Duration) {
        if self.ends_within(most).is_none() {
            let _ = self.child.kill();
            let _ = self.child.wait();
        }
    }
}

/// HAL's keeper: HAL runs as long as its standard input is open. When that closes, also by a crash of ours, it stops
/// everything and clears up.
#[derive(Debug)]
pub(super) struct Keeper {
    program: Program,
    open: Option<ChildStdin>,
    user: User,
}

impl Keeper {
    pub(super) fn start(user: &User) -> Result<Self, LinuxCncError> {
        if !is_in_path("halrun") {
            return Err(LinuxCncError::NotInstalled("halrun".to_owned()));
        }
        let mut program = start(user, "stdbuf", &["-oL", "halrun"], false)?;
        let (open, stdout) = (program.stdin(), program.stdout());
        let mut keeper = Self { program, open, user: user.clone() };
        let (to, from) = channel();
        std::thread::spawn(move || {
            let mut lines = stdout.into_iter().flat_map(|stdout| BufReader::new(stdout).lines().map_while(Result::ok));
            if let Some(line) = lines.next() {
                // The receiver may have gone.
                let _ = to.send(line);
            }
            // Drain the rest, so that the keeper does not block.
            lines.for_each(drop);
        });
        if let Some(open) = &mut keeper.open {
            // It answers once it is ready; an ended keeper does not answer.
            let _ = open.write_all(b"show thread\n");
        }
        if from.recv_timeout(BEGINS).is_err() {
            return Err(LinuxCncError::Failed { what: Symptom::NoStart, output: keeper.error_output() });
        }
        Ok(keeper)
    }

    pub(super) fn error_output(&self) -> Message {
        self.program.output.message()
    }

    /// Ends HAL.
    pub(super) fn end(&mut self) {
        self.open = None;
        self.program.end(ENDS);
        if let Some((_, _, socket)) = &self.user.other {
            // The socket may be gone already.
            let _ = std::fs::remove_file(socket);
        }
    }
}

impl Drop for Keeper {
    fn drop(&mut self) {
        self.end();
    }
}

fn is_in_path(program: &str) -> bool {
    let path = std::env::var_os("PATH").unwrap_or_default();
    std::env::split_paths(&path).any(|folder| folder.join(program).is_file())
}

/// Has HAL execute commands: our own, or those of a file in its folder.
pub(super) fn take(user: &User, commands: Commands<'_>) -> Result<(), LinuxCncError> {
    let (mut command, file, text) = match commands {
        Commands::Ours(text) => (user.command("halcmd", &["-f"]), Message::new("cell-hal-own-commands"), text),
        Commands::File(path) => {
            let name = path.display().to_string();
            let mut command = user.command("halcmd", &["-f", &name]);
            command.current_dir(path.parent().unwrap_or(Path::new("/")));
            (command, Message::verbatim(name), "")
        }
    };
    command.stdin(Stdio::piped()).stdout(Stdio::null()).stderr(Stdio::piped());
    let mut program = spawn(command, "halcmd", false)?;
    if let Some(mut stdin) = program.stdin() {
        stdin.write_all(text.as_bytes())?;
    }
    match program.ends_within(TAKES) {
        Some(true) => Ok(()),
        Some(false) => Err(LinuxCncError::Refused { file, output: program.error_output() }),
        None => {
            program.end(Duration::ZERO);
            let output = Message::new("cell-hal-too-slow").value("time", TAKES.as_secs_f64(), Unit::S);
            let output = output.message("said", program.error_output());
            Err(LinuxCncError::Refused { file, output })
        }
    }
}

/// Commands for HAL.
#[derive(Debug, Clone, Copy)]
pub(super) enum Commands<'a> {
    Ours(&'a str),
    File(&'a Path),
}

/// Name of the signal that names HAL's owner.
pub(super) fn owner(process: u32) -> String {
    format!("{OWNER}{process}")
}

const OWNER: &str = "seamwright.pid.";

/// Fails if another HAL runs. One of ours without a living owner ends itself, or is removed.
pub(super) fn alone(user: &User) -> Result<(), LinuxCncError> {
    let begun = Instant::now();
    let mut cleared = false;
    while is_running() {
        let listed = user.command("halcmd", &["list", "sig", &format!("{OWNER}*")]).output();
        let listed = listed.map_err(|_| LinuxCncError::NotInstalled("halcmd".to_owned()))?;
        let text = String::from_utf8_lossy(&listed.stdout).into_owned();
        let owner = text.split_whitespace().find_map(|name| name.strip_prefix(OWNER)?.parse::<u32>().ok());
        match owner {
            // The owner, another process of ours, still runs.
            Some(process) if process != std::process::id() && Path::new(&format!("/proc/{process}")).exists() => {
                return Err(LinuxCncError::Running(Message::new("cell-hal-of-seamwright").number(
                    "process",
                    f64::from(process),
                    0,
                )));
            }
            // Its keeper is clearing up, or has ended too.
            Some(_) if begun.elapsed() > BEGINS && !cleared => {
                cleared = true;
                force_out(user);
            }
            _ if begun.elapsed() > 2 * BEGINS || (owner.is_none() && begun.elapsed() > BEGINS / 2) => {
                return Err(LinuxCncError::Running(Message::new("cell-hal-foreign")));
            }
            _ => std::thread::sleep(10 * LOOK),
        }
    }
    // A killed HAL leaves its stream memory behind, whose size does not fit another number of axes.
    free_streams(user);
    Ok(())
}

/// Shared memory keys of `streamer` and `sampler`, whose memory outlives a killed real-time program.
const STREAMS: [&str; 2] = ["0x48535430", "0x48534130"];

/// Removes the rest of HAL after its keeper has ended, or all of it if the keeper was killed.
pub(super) fn clear(user: &User) {
    if is_running() {
        force_out(user);
    }
    free_streams(user);
}

fn free_streams(user: &User) {
    // Usually there is no memory left; without the program no clean-up is possible.
    let mut command = user.command("ipcrm", &["-M", STREAMS[0], "-M", STREAMS[1]]);
    let _ = command.stdout(Stdio::null()).stderr(Stdio::null()).status();
}

/// Has LinuxCNC take HAL down, independent of its owner.
fn force_out(user: &User) {
    let mut command = user.command("halrun", &["-U"]);
    command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::piped());
    if let Ok(mut program) = spawn(command, "halrun", false) {
        program.end(ENDS);
    }
}

/// Returns true if HAL's real-time program runs.
fn is_running() -> bool {
    let Ok(processes) = std::fs::read_dir("/proc") else { return false };
    processes.flatten().any(|process| {
        let status = std::fs::read_to_string(process.path().join("status")).unwrap_or_default();
        let mut lines = status.lines();
        let named = lines.next().is_some_and(|line| line.trim_start_matches("Name:").trim() == "rtapi_app");
        named && !lines.any(|line| line.starts_with("State:") && line.contains('Z'))
    })
}
