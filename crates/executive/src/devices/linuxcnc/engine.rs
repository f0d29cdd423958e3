//! Running HAL, with our streams and the hardware.

use super::error::{LinuxCncError, Symptom};
use super::programs::{self, Commands, Keeper, Program, User};
use super::script;
use super::stream_line::{self, Sample};
use crate::realtime::{RealtimeRights, SteadyTime};
use rtrb::{Consumer, Producer, RingBuffer};
use rustix::fs::{OFlags, fcntl_getfl, fcntl_setfl};
use seamwright_machine::{Axis, LinuxCnc, Machine};
use seamwright_message::Message;
use std::io::{BufRead as _, BufReader};
use std::path::{Path, PathBuf};
use std::process::{ChildStdin, ChildStdout};
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

/// Capacity of the queue between the reader and the cycle, samples.
const SAMPLES: usize = 1024;
/// Maximum time until the first sample.
const FIRST: Duration = Duration::from_secs(3);
/// HAL counts as ended after this time without a sample, even if its programs run.
const SILENT: Duration = Duration::from_secs(2);

/// Start parameters of HAL.
#[derive(Debug)]
pub(super) struct Plan {
    user: User,
    axes: Vec<Axis>,
    /// Commands before those of the hardware.
    before: String,
    hardware: Hardware,
}

#[derive(Debug)]
enum Hardware {
    /// The user's HAL file.
    File(PathBuf),
    /// Commands for axes without hardware.
    None(String),
}

impl Plan {
    /// Plans with the hardware of the user's HAL file, found in `folder`, or with axes without hardware. Errors: no
    /// user may run HAL, or the folder is missing.
    pub(super) fn new(machine: &Machine, device: &LinuxCnc, folder: &Path) -> Result<Self, LinuxCncError> {
        let before = script::before(machine, device, &programs::owner(std::process::id()));
        let hardware = match &device.hal {
            Some(hal) => Hardware::File(std::path::absolute(folder.join(hal))?),
            None => Hardware::None(script::simulated(machine)),
        };
        Ok(Self { user: User::find()?, axes: machine.axes.clone(), before, hardware })
    }
}

/// The cycle's side of the streams.
#[derive(Debug)]
pub(super) struct Link {
    /// Set-points go in here; the pipe never blocks.
    pub(super) stream: ChildStdin,
    pub(super) samples: Consumer<Sample>,
}

/// Time of HAL's last sample, ms after `begun`.
#[derive(Debug, Clone)]
struct Heard {
    begun: Instant,
    last_ms: Arc<AtomicU64>,
}

impl Heard {
    fn now(&self) {
        self.last_ms.store(self.begun.elapsed().as_millis() as u64, Ordering::Relaxed);
    }

    fn ago(&self) -> Duration {
        self.begun.elapsed().saturating_sub(Duration::from_millis(self.last_ms.load(Ordering::Relaxed)))
    }
}

/// HAL's programs.
#[derive(Debug)]
pub(super) struct Engine {
    streamer: Program,
    sampler: Program,
    keeper: Keeper,
    user: User,
    heard: Heard,
}

impl Engine {
    /// Starts HAL, without power. Takes about a second. Errors: LinuxCNC is not installed, runs already, rejects the
    /// file, or does not run; each error names the cure.
    pub(super) fn start(plan: &Plan) -> Result<(Self, Link), LinuxCncError> {
        let user = &plan.user;
        programs::alone(user)?;
        let keeper = Keeper::start(user)?;
        programs::take(user, Commands::Ours(&plan.before))?;
        match &plan.hardware {
            Hardware::None(commands) => programs::take(user, Commands::Ours(commands))?,
            Hardware::File(path) => programs::take(user, Commands::File(path))?,
        }
        programs::take(user, Commands::Ours(script::AFTER))?;
        let mut streamer = programs::start(user, "halstreamer", &[], true)?;
        // Line buffering: by default it holds its output back until there are 4 KB.
        let mut sampler = programs::start(user, "stdbuf", &["-oL", "halsampler"], true)?;
        let (Some(stream), Some(stdout)) = (streamer.stdin(), sampler.stdout()) else {
            return Err(LinuxCncError::System(Message::new("cell-hal-no-pipes")));
        };
        fcntl_setfl(&stream, fcntl_getfl(&stream).map_err(std::io::Error::from)? | OFlags::NONBLOCK)
            .map_err(std::io::Error::from)?;
        let (to, samples) = RingBuffer::new(SAMPLES);
        let heard = Heard { begun: Instant::now(), last_ms: Arc::default() };
        let (axes, hears) = (plan.axes.clone(), heard.clone());
        std::thread::spawn(move || listen(stdout, &axes, &hears, to));
        let engine = Self { streamer, sampler, keeper, user: user.clone(), heard };
        if let Err(error) = engine.wait_for(&samples) {
            engine.end(false);
            return Err(error);
        }
        Ok((engine, Link { stream, samples }))
    }

    fn wait_for(&self, samples: &Consumer<Sample>) -> Result<(), LinuxCncError> {
        let begun = Instant::now();
        while samples.is_empty() {
            if samples.is_abandoned() || begun.elapsed() > FIRST {
                let output = Message::new("cell-hal-output").message("sampler", self.sampler.error_output());
                let output = output.message("keeper", self.keeper.error_output());
                return Err(LinuxCncError::Failed { what: Symptom::NoSamples, output });
            }
            std::thread::sleep(Duration::from_millis(1));
        }
        Ok(())
    }

    /// Returns which part has ended, among those that axes need. Without its keeper HAL goes on.
    pub(super) fn ended(&mut self) -> Option<Message> {
        if self.streamer.has_ended() {
            Some(Message::new("cell-hal-program-ended").text("program", "halstreamer"))
        } else if self.sampler.has_ended() {
            Some(Message::new("cell-hal-program-ended").text("program", "halsampler"))
        } else if self.heard.ago() > SILENT {
            Some(Message::new("cell-hal-no-data"))
        } else {
            None
        }
    }

    /// Ends everything and clears it up. If `gently`, stored set-points are executed first, which needs a closed
    /// stream.
    pub(super) fn end(mut self, gently: bool) {
        self.streamer.end(if gently { Duration::from_secs(1) } else { Duration::ZERO });
        self.keeper.end();
        self.sampler.end(Duration::from_millis(100));
        programs::clear(&self.user);
    }
}

/// Reads HAL's samples until it ends.
fn listen(from: ChildStdout, axes: &[Axis], heard: &Heard, mut to: Producer<Sample>) {
    RealtimeRights::ask_below_cycle();
    let mut from = BufReader::new(from);
    let mut text = String::new();
    while !to.is_abandoned() {
        text.clear();
        match from.read_line(&mut text) {
            Ok(1..) => {
                if let Some(sample) = stream_line::read(&text, axes, SteadyTime::now()) {
                    heard.now();
                    // If the queue is full the sample is dropped; a newer one comes.
                    let _ = to.push(sample);
                }
            }
            _ => break,
        }
    }
}
