//! The process that answers one question and ends. Limits of memory, time and priority protect the cell.

use super::question::Question;
use super::{Header, Progress};
use crate::http::Refused;
use crate::limits::{LONG_PROCESSOR_TIME, PLAN_MEMORY_BYTES, PLAN_PROCESSOR_TIME};
use std::io::{self, BufWriter, Read as _, Write};
use std::path::Path;
use std::time::Duration;

/// Answers the question on standard input on standard output. Texts may name files in `jobs`.
///
/// # Errors
/// If the limits cannot be set, or the parent process has gone.
pub fn answer_one_question(jobs: &Path) -> io::Result<()> {
    // Before it reads anything; a long question may have more time of the processor later.
    limit(PLAN_PROCESSOR_TIME, LONG_PROCESSOR_TIME)?;
    let mut question = Vec::new();
    io::stdin().lock().read_to_end(&mut question)?;
    let question = serde_json::from_slice::<Question>(&question);
    let is_long = question.as_ref().is_ok_and(Question::is_long);
    let processor_time = if is_long { LONG_PROCESSOR_TIME } else { PLAN_PROCESSOR_TIME };
    limit(processor_time, processor_time)?;
    if let Some(language) = question.as_ref().ok().and_then(Question::language) {
        language.speak();
    }
    let answer = question
        .map_err(|e| Refused::server(e.to_string()))
        .and_then(|question| question.answer(jobs, &report_progress));
    let mut out = BufWriter::new(io::stdout().lock());
    let (header, body) = match answer {
        Ok(body) => (Header::Answer { bytes: body.len() }, body),
        Err(refused) => (Header::of(&refused), Vec::new()),
    };
    serde_json::to_writer(&mut out, &header)?;
    out.write_all(b"\n")?;
    out.write_all(&body)?;
    out.flush()
}

/// Writes a line of progress.
fn report_progress(Progress { done, total, kept }: Progress) {
    // One thread at a time writes a whole line. If the server has gone, the answer fails.
    let mut out = io::stdout().lock();
    if serde_json::to_writer(&mut out, &Header::Progress { done, total, kept }).is_ok() {
        drop(out.write_all(b"\n").and_then(|()| out.flush()));
    }
}

/// Limits this process for the rest of its life; its processor time may be raised to `most_time`.
#[cfg(target_os = "linux")]
fn limit(processor_time: Duration, most_time: Duration) -> io::Result<()> {
    use rustix::process::{Resource, Rlimit, Signal, set_parent_process_death_signal, setpriority_process, setrlimit};
    /// Priority reduction (`nice`): below the panel's own work.
    const NICE: i32 = 15;
    let most = |value: u64| Rlimit { current: Some(value), maximum: Some(value) };
    setrlimit(Resource::As, most(PLAN_MEMORY_BYTES))?;
    let (time, most_time) = (Some(processor_time.as_secs()), Some(most_time.as_secs()));
    setrlimit(Resource::Cpu, Rlimit { current: time, maximum: most_time })?;
    setrlimit(Resource::Core, most(0))?;
    setpriority_process(None, NICE)?;
    set_parent_process_death_signal(Some(Signal::KILL))?;
    // If memory still runs short, the kernel ends this process first. Some systems lack this file.
    let _ = std::fs::write("/proc/self/oom_score_adj", "1000");
    Ok(())
}

#[cfg(not(target_os = "linux"))]
fn limit(_: Duration, _: Duration) -> io::Result<()> {
    Ok(())
}
