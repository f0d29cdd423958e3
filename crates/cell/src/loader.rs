//! The way of a program to the cycle: read and check it, release devices that another one used, connect its own.

use crate::devices::{CellDevices, Connection};
use crate::prepared_task::Prepared;
use crate::program::Program;
use crate::protocol::Unprepared;
use seamwright_machine::{Joints, MachineDevices};
use seamwright_message::Message;
use std::path::PathBuf;
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

/// Maximum time for releasing devices.
const RELEASE: Duration = Duration::from_secs(20);

/// A program being prepared, in threads beside the link's.
pub(crate) struct Loader {
    /// Devices that jobs may use, chosen at the start of the cell, and the folder of their paths.
    own: MachineDevices,
    folder: PathBuf,
    stage: Stage,
}

enum Stage {
    Idle,
    /// The program is read.
    Reading {
        number: u32,
        thread: JoinHandle<Result<Box<Prepared>, Message>>,
    },
    /// The cycle has been given a machine without devices; the ones of before are being dropped.
    Releasing {
        number: u32,
        prepared: Box<Prepared>,
        old: Connection,
        since: Instant,
    },
    /// Devices are being connected.
    Connecting {
        number: u32,
        thread: JoinHandle<Result<Box<Prepared>, Message>>,
    },
}

/// Next task of the link.
pub(crate) enum Step {
    /// Nothing yet.
    Wait,
    /// Give this machine without a program to the cycle, so that it releases its devices.
    Release(Box<Prepared>),
    /// Give this task to the cycle.
    Give(u32, Box<Prepared>),
    /// Report that the program with this number cannot be run.
    Refuse(u32, Unprepared),
}

/// State of the cell as the loader needs it.
pub(crate) struct CellNow<'a> {
    /// Connected devices.
    pub(crate) connection: &'a Connection,
    /// Set-points of the axes, if all are referenced.
    pub(crate) at: Option<Joints>,
    pub(crate) is_off: bool,
}

impl Loader {
    pub(crate) fn new(own: MachineDevices, folder: PathBuf) -> Self {
        Self { own, folder, stage: Stage::Idle }
    }

    /// Starts to prepare `program`.
    pub(crate) fn begin(&mut self, program: Program, now: &CellNow<'_>) -> Result<(), Unprepared> {
        if !matches!(self.stage, Stage::Idle) {
            return Err(Unprepared::Busy);
        }
        let at = now.at.map(|at| (now.connection.clone(), at));
        let number = program.number;
        let thread = spawn(move || program.prepare(at).map(Box::new));
        self.stage = Stage::Reading { number, thread: thread.map_err(Unprepared::Devices)? };
        Ok(())
    }

    /// Goes on as far as possible without a wait.
    pub(crate) fn step(&mut self, now: &CellNow<'_>) -> Step {
        match std::mem::replace(&mut self.stage, Stage::Idle) {
            Stage::Idle => Step::Wait,
            Stage::Reading { number, thread } if thread.is_finished() => match joined(thread) {
                Ok(prepared) => self.read(number, prepared, now),
                Err(message) => Step::Refuse(number, Unprepared::Invalid(message)),
            },
            Stage::Connecting { number, thread } if thread.is_finished() => match joined(thread) {
                Ok(prepared) => Step::Give(number, prepared),
                Err(message) => Step::Refuse(number, Unprepared::Devices(message)),
            },
            Stage::Releasing { number, prepared, old, since } => {
                if !old.is_there() {
                    return self.connect(number, prepared);
                }
                if since.elapsed() > RELEASE {
                    return Step::Refuse(number, Unprepared::Devices(Message::new("server-devices-held")));
                }
                self.stage = Stage::Releasing { number, prepared, old, since };
                Step::Wait
            }
            waiting => {
                self.stage = waiting;
                Step::Wait
            }
        }
    }

    /// Gives a task that the connected devices serve; for another one, exchanges the devices first.
    fn read(&mut self, number: u32, prepared: Box<Prepared>, now: &CellNow<'_>) -> Step {
        if now.connection.serves_it(&prepared) {
            return Step::Give(number, prepared);
        }
        let its = &prepared.machine().devices;
        if !its.is_empty() && *its != self.own {
            return Step::Refuse(number, Unprepared::Devices(Message::new("server-other-devices")));
        }
        if !now.is_off {
            return Step::Refuse(number, Unprepared::NeedsOff);
        }
        if !now.connection.is_real() {
            return self.connect(number, prepared);
        }
        match Prepared::bare(prepared.machine()) {
            Ok(bare) => {
                let old = now.connection.clone();
                self.stage = Stage::Releasing { number, prepared, old, since: Instant::now() };
                Step::Release(Box::new(bare))
            }
            Err(why) => Step::Refuse(number, Unprepared::Devices(Message::verbatim(why))),
        }
    }

    fn connect(&mut self, number: u32, mut prepared: Box<Prepared>) -> Step {
        let folder = self.folder.clone();
        let connected = move || {
            let values = prepared.with(|work| work.values().to_vec());
            prepared.devices = Some(CellDevices::new(&prepared, &folder, &values).map_err(Message::verbatim)?);
            Ok(prepared)
        };
        match spawn(connected) {
            Ok(thread) => {
                self.stage = Stage::Connecting { number, thread };
                Step::Wait
            }
            Err(why) => Step::Refuse(number, Unprepared::Devices(why)),
        }
    }
}

type Task = JoinHandle<Result<Box<Prepared>, Message>>;

fn spawn(work: impl FnOnce() -> Result<Box<Prepared>, Message> + Send + 'static) -> Result<Task, Message> {
    std::thread::Builder::new().name("preparation".into()).spawn(work).map_err(|e| Message::outside(&e))
}

/// The result of a thread; a panic in it is a fault of this program.
fn joined(thread: Task) -> Result<Box<Prepared>, Message> {
    thread.join().unwrap_or_else(|_| Err(Message::new("cell-program-panicked")))
}
