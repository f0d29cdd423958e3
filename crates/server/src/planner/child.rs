//! A question answered by a separate process.

use super::question::Question;
use super::{Header, Progress, Token};
use crate::diagnostics::{WorkerCounts, WorkerEnd};
use crate::http::Refused;
use crate::limits::{MAX_PLAN_BYTES, PLAN_MEMORY_BYTES};
use seamwright_log as log;
use seamwright_message::{Message, Unit};
use std::io::{BufRead as _, BufReader, Read, Write as _};
use std::path::Path;
use std::process::{Child, ChildStderr, ChildStdin, ChildStdout, Command, Stdio};
use std::sync::Arc;
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::time::{Duration, Instant};

/// Polling period for a cancellation.
const LOOK: Duration = Duration::from_millis(20);
/// Maximum size of the error output that is read, bytes.
const MAX_SAID: u64 = 4 << 10;

/// A child process, killed when dropped.
struct Ended(Child);

impl Drop for Ended {
    fn drop(&mut self) {
        // Has no effect on a process that has already ended.
        drop(self.0.kill());
        drop(self.0.wait());
    }
}

/// Result of a process: its answer, or the reason for its failure.
type Said = Result<Vec<u8>, Refused>;

/// Starts `program` to answer. Waits for the answer, `patience` or a cancellation.
pub(super) fn ask(
    program: &Path,
    question: &Question,
    jobs: &Path,
    token: &Arc<Token>,
    patience: Duration,
    counts: &WorkerCounts,
) -> Result<Vec<u8>, Refused> {
    let failed = |e: std::io::Error| Refused::server(Message::new("server-no-process").text("why", e.to_string()));
    let text = serde_json::to_vec(question).map_err(|e| Refused::server(e.to_string()))?;
    let mut command = Command::new(program);
    command.arg("answer-one-question").arg("--jobs").arg(jobs);
    command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = Ended(command.spawn().map_err(failed)?);
    let running = counts.begin(child.0.id(), question.name());
    log::debug(&of_process("server-log-worker-starts", child.0.id(), question));
    let pid = child.0.id();
    let answer = converse(&mut child, text, token, patience);
    drop(child);
    report(pid, question, running.since.elapsed(), &answer);
    running.ends(end_of(&answer));
    answer
}

fn of_process(code: &'static str, pid: u32, question: &Question) -> Message {
    Message::new(code).number("pid", f64::from(pid), 0).text("question", question.name())
}

/// Logs the end of a process.
fn report(pid: u32, question: &Question, time: Duration, answer: &Said) {
    let timed = |code| of_process(code, pid, question).quantity("time", time.as_secs_f64(), Unit::S, 2);
    match (end_of(answer), answer) {
        (WorkerEnd::Answered | WorkerEnd::Refused, _) | (_, Ok(_)) => log::debug(&timed("server-log-worker-ended")),
        (how, Err(refused)) => {
            let message = timed("server-log-worker-killed").message("reason", refused.message.clone());
            // A page that asks anew does so with every pause in typing.
            if how == WorkerEnd::Superseded { log::debug(&message) } else { log::warn(&message) }
        }
    }
}

/// Returns how a process ended, by its answer.
fn end_of(answer: &Said) -> WorkerEnd {
    let Err(refused) = answer else { return WorkerEnd::Answered };
    match &*refused.message.code {
        "server-superseded" => WorkerEnd::Superseded,
        "server-planning-time" => WorkerEnd::Late,
        "server-planning-memory" => WorkerEnd::Memory,
        _ if refused.status.is_server_error() => WorkerEnd::Failed,
        _ => WorkerEnd::Refused,
    }
}

/// Asks the question and waits.
fn converse(child: &mut Ended, text: Vec<u8>, token: &Arc<Token>, patience: Duration) -> Said {
    let pipes = (child.0.stdin.take(), child.0.stdout.take(), child.0.stderr.take());
    let (Some(stdin), Some(stdout), Some(stderr)) = pipes else {
        return Err(Refused::server(Message::new("server-no-pipes")));
    };
    let (to, said) = channel();
    let of = Arc::clone(token);
    std::thread::spawn(move || to.send(talk(stdin, &text, (stdout, stderr), &of)));
    let begin = Instant::now();
    loop {
        match said.recv_timeout(LOOK) {
            Ok(said) => return said,
            Err(RecvTimeoutError::Disconnected) => return Err(Refused::server(Message::new("server-failed"))),
            Err(RecvTimeoutError::Timeout) if token.is_cancelled() => return Err(super::superseded()),
            Err(RecvTimeoutError::Timeout) if begin.elapsed() > patience => return Err(super::too_long(patience)),
            Err(RecvTimeoutError::Timeout) => {}
        }
    }
}

/// Sends the question and reads the complete answer.
fn talk(mut to: ChildStdin, text: &[u8], (out, err): (ChildStdout, ChildStderr), token: &Token) -> Said {
    // A process that has already ended reports the reason itself.
    drop(to.write_all(text));
    drop(to);
    match heard(out, token) {
        Some(said) => said,
        None => Err(why(err)),
    }
}

fn heard(out: ChildStdout, token: &Token) -> Option<Said> {
    let mut out = BufReader::new(out.take(MAX_PLAN_BYTES as u64));
    let mut line = String::new();
    let header = loop {
        line.clear();
        out.read_line(&mut line).ok()?;
        match serde_json::from_str(&line).ok()? {
            Header::Progress { done, total, kept } => token.advance(Progress { done, total, kept }),
            header => break header,
        }
    };
    match header {
        Header::Answer { bytes } => {
            let mut body = Vec::new();
            out.read_to_end(&mut body).ok()?;
            if body.len() != bytes {
                let message =
                    Message::new("server-plan-too-large").value("max", (MAX_PLAN_BYTES >> 20) as f64, Unit::MiB);
                return (bytes >= MAX_PLAN_BYTES - line.len()).then(|| Err(message.into()));
            }
            Some(Ok(body))
        }
        // Taken above.
        Header::Progress { .. } => None,
        Header::Refused { status, key, message } => Some(Err(Refused::known(status, &key, message))),
    }
}

/// Converts the last error output of a process.
fn why(err: ChildStderr) -> Refused {
    let mut said = Vec::new();
    drop(err.take(MAX_SAID).read_to_end(&mut said));
    let said = String::from_utf8_lossy(&said);
    if said.contains("memory allocation of") || said.contains("cannot allocate memory") {
        return Refused::input(Message::new("server-planning-memory").number(
            "max",
            (PLAN_MEMORY_BYTES >> 30) as f64,
            0,
        ));
    }
    Refused::server(Message::new("server-planning-failed").text("why", said.lines().next().unwrap_or("–")))
}
