//! A Spark cluster, reached through the Python package: `python3 -m seamwright.spark`.
//!
//! That program gets a line of JSON, the task, and a line for each piece; `end` follows the last one. It answers with a
//! line with its version, lines that say how many more pieces it takes, a line for each result in any order, and at last
//! `end`, or a line that says what failed. If its input ends before it has answered, it cancels what runs and goes.

use super::task::{Task, parsed};
use crate::threads::locked;
use seamwright_message::Message;
use seamwright_project::failure::Failure;
use serde::Deserialize;
use serde_json::json;
use std::collections::VecDeque;
use std::io::{BufRead, BufReader, BufWriter, Read, Write};
use std::path::PathBuf;
use std::process::{Child, ChildStderr, ChildStdin, ChildStdout, Command, Stdio};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::sync::{Condvar, Mutex, PoisonError};
use std::time::Duration;

/// Lines of errors that are kept.
const ERROR_LINES: usize = 20;
/// Time between looks whether the run is cancelled.
const LOOK_EVERY: Duration = Duration::from_millis(100);

/// A Spark cluster.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Spark {
    /// Address of Spark Connect, as `sc://host:15002`.
    pub address: String,
    /// The Python program with the package `seamwright`.
    pub python: PathBuf,
}

/// A run on a cluster.
pub(crate) struct Run<'a> {
    pub(crate) task: &'a Task,
    pub(crate) cancel: Option<&'a AtomicBool>,
    /// Takes the result of a piece.
    pub(crate) done: &'a (dyn Fn(&str) -> Result<(), Failure> + Sync),
}

/// An answer of the program.
#[derive(Deserialize)]
#[serde(rename_all = "snake_case")]
enum Answer {
    Version(String),
    /// It takes so many more pieces.
    Want(u64),
    Result(String),
    /// The client of Spark Connect is not installed.
    NoClient(String),
    Failed(String),
    End,
}

impl Spark {
    /// Plans the pieces that `feed` sends. Sending returns false after a fault: then `feed` should end.
    ///
    /// # Errors
    /// Those of `feed` and of `done`; a missing program, one of another version, a failure of the cluster;
    /// [`Failure::Cancelled`].
    pub(crate) fn plan(
        &self,
        run: &Run<'_>,
        feed: impl FnOnce(&dyn Fn(String) -> bool) -> Result<(), Failure>,
    ) -> Result<(), Failure> {
        let task = run.task.bytes()?;
        let (mut child, pipes) = self.start()?;
        let bridge = Bridge::new(pipes.input);
        let mut answers = BufReader::new(pipes.output).lines();
        let (errors, is_whole) = std::thread::scope(|scope| {
            let errors = scope.spawn(|| last_lines(pipes.errors));
            let is_whole = match self.check_version(answers.next()) {
                Ok(true) => {
                    let header = json!({ "spark": self.address, "task_bytes": task.len() }).to_string();
                    bridge.write(&[header.as_bytes(), b"\n", &task]);
                    self.exchange(run, &bridge, answers, feed)
                }
                Ok(false) => false,
                Err(failure) => bridge.fail(failure),
            };
            *locked(&bridge.input) = None;
            (errors.join().unwrap_or_default(), is_whole)
        });
        // It ends by itself when its input has ended.
        let status = child.wait();
        match locked(&bridge.fault).take() {
            Some(failure) => Err(failure),
            None if is_whole => Ok(()),
            None => Err(self.ended(status.map_or_else(|e| e.to_string(), |status| status.to_string()), errors)),
        }
    }

    /// Sends pieces and takes results. Returns true if the program has answered all of them.
    fn exchange(
        &self,
        run: &Run<'_>,
        bridge: &Bridge,
        answers: impl Iterator<Item = std::io::Result<String>> + Send,
        feed: impl FnOnce(&dyn Fn(String) -> bool) -> Result<(), Failure>,
    ) -> bool {
        let (finished, ended) = channel::<()>();
        std::thread::scope(|scope| {
            scope.spawn(move || bridge.watch(run.cancel, &ended));
            let reader = scope.spawn(move || {
                let is_whole = self.read(answers, bridge, run.done).unwrap_or_else(|failure| bridge.fail(failure));
                if !is_whole {
                    *locked(&bridge.input) = None;
                }
                drop(finished);
                is_whole
            });
            match feed(&|piece| bridge.send(&piece)) {
                Ok(()) => _ = bridge.write(&[b"end\n"]),
                Err(failure) => _ = bridge.fail(failure),
            }
            reader.join().unwrap_or(false)
        })
    }

    /// Takes results to the end. Returns false if there are no more answers before it.
    fn read(
        &self,
        answers: impl Iterator<Item = std::io::Result<String>>,
        bridge: &Bridge,
        done: &(dyn Fn(&str) -> Result<(), Failure> + Sync),
    ) -> Result<bool, Failure> {
        for line in answers {
            match parsed(&line?)? {
                Answer::Result(result) => done(&result)?,
                Answer::Want(pieces) => bridge.want(pieces),
                Answer::End => return Ok(true),
                Answer::NoClient(why) => return Err(self.no_client(&why)),
                Answer::Failed(why) => {
                    let message = Message::new("schedule-spark-failed").text("address", &self.address);
                    return Err(Failure::environment(message.message("why", Message::verbatim(why))));
                }
                Answer::Version(_) => {}
            }
        }
        Ok(false)
    }

    fn start(&self) -> Result<(Child, Pipes), Failure> {
        let mut command = Command::new(&self.python);
        command.args(["-m", "seamwright.spark"]);
        command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        let missing = |why: &dyn std::fmt::Display| {
            let message = Message::new("schedule-spark-no-python").text("python", self.name());
            Failure::environment(message.message("why", Message::outside(why)))
        };
        let mut child = command.spawn().map_err(|e| missing(&e))?;
        match (child.stdin.take(), child.stdout.take(), child.stderr.take()) {
            (Some(input), Some(output), Some(errors)) => Ok((child, Pipes { input, output, errors })),
            _ => Err(missing(&"")),
        }
    }

    /// The first answer must be this version: programs of different versions may plan differently.
    /// Returns false without an answer: the errors say why.
    fn check_version(&self, first: Option<std::io::Result<String>>) -> Result<bool, Failure> {
        let answer = first.and_then(Result::ok).and_then(|line| parsed(&line).ok());
        let own = env!("CARGO_PKG_VERSION");
        match answer {
            Some(Answer::Version(found)) if found == own => Ok(true),
            Some(Answer::Version(found)) => {
                let message = Message::new("schedule-spark-version").text("python", self.name());
                Err(Failure::environment(message.text("found", found).text("program", own)))
            }
            _ => Ok(false),
        }
    }

    fn no_client(&self, why: &str) -> Failure {
        let message = Message::new("schedule-spark-no-client").text("python", self.name());
        Failure::environment(message.message("why", Message::verbatim(why)))
    }

    /// The program has gone without a reason: its last errors are one.
    fn ended(&self, status: String, errors: Vec<String>) -> Failure {
        let why = [vec![status], errors].concat().join("\n   ");
        let message = Message::new("schedule-spark-ended").text("python", self.name());
        Failure::environment(message.message("why", Message::verbatim(why)))
    }

    fn name(&self) -> String {
        self.python.display().to_string()
    }
}

/// Pipes of the program.
struct Pipes {
    input: ChildStdin,
    output: ChildStdout,
    errors: ChildStderr,
}

/// State that the threads of a run share.
struct Bridge {
    /// None when no more is sent.
    input: Mutex<Option<BufWriter<ChildStdin>>>,
    /// The first fault.
    fault: Mutex<Option<Failure>>,
    /// Number of pieces that may be sent: more would wait in the pipe, whose end could not be closed then.
    wanted: Mutex<u64>,
    more: Condvar,
}

impl Bridge {
    fn new(input: ChildStdin) -> Self {
        let input = Mutex::new(Some(BufWriter::new(input)));
        Self { input, fault: Mutex::new(None), wanted: Mutex::new(0), more: Condvar::new() }
    }

    fn want(&self, pieces: u64) {
        *locked(&self.wanted) += pieces;
        self.more.notify_all();
    }

    /// Sends a piece when it is wanted. Returns false if nothing more is sent.
    fn send(&self, piece: &str) -> bool {
        let mut wanted = locked(&self.wanted);
        while *wanted == 0 {
            if locked(&self.input).is_none() {
                return false;
            }
            wanted = self.more.wait_timeout(wanted, LOOK_EVERY).unwrap_or_else(PoisonError::into_inner).0;
        }
        *wanted -= 1;
        drop(wanted);
        self.write(&[piece.as_bytes(), b"\n"])
    }

    /// Writes all parts. Returns false if the program does not read any more.
    fn write(&self, parts: &[&[u8]]) -> bool {
        let mut input = locked(&self.input);
        let Some(pipe) = input.as_mut() else { return false };
        let written = parts.iter().try_for_each(|part| pipe.write_all(part)).and_then(|()| pipe.flush());
        if written.is_err() {
            *input = None;
        }
        written.is_ok()
    }

    /// Keeps the first fault, and ends the input: the program cancels what runs, and goes. Returns false.
    fn fail(&self, failure: Failure) -> bool {
        let _ = locked(&self.fault).get_or_insert(failure);
        *locked(&self.input) = None;
        false
    }

    /// Looks whether the run is cancelled, until it ends.
    fn watch(&self, cancel: Option<&AtomicBool>, ended: &Receiver<()>) {
        while ended.recv_timeout(LOOK_EVERY) == Err(RecvTimeoutError::Timeout) {
            if cancel.is_some_and(|cancel| cancel.load(Ordering::Relaxed)) {
                self.fail(Failure::Cancelled);
                return;
            }
        }
    }
}

/// The last lines of a stream, when it has ended.
fn last_lines(stream: impl Read) -> Vec<String> {
    let mut last = VecDeque::new();
    for line in BufReader::new(stream).split(b'\n').map_while(Result::ok) {
        if last.len() == ERROR_LINES {
            last.pop_front();
        }
        last.push_back(String::from_utf8_lossy(&line).trim_end().to_owned());
    }
    last.into()
}
