//! Starts the cell, watches that it lives, and starts it again, off and without a program, if it has died.

use seamwright_cell::protocol::{CELL_SILENT_S, Report, Request};
use seamwright_cell::{CellClient, CellStart, fingerprint};
use seamwright_message::Message;
use std::collections::VecDeque;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// Maximum number of starts after the first one in [`WITHIN`]: a cell that dies more often is not started again.
const MAX_RESTARTS: usize = 3;
const WITHIN: Duration = Duration::from_secs(600);
/// The panel writes the safe outputs of devices itself without a cycle for this long.
const SILENT: Duration = Duration::from_millis((1000.0 * CELL_SILENT_S) as u64);
/// The cell is killed and started again without a cycle for this long: its devices' outputs become safe by that.
const FROZEN: Duration = Duration::from_millis((2000.0 * CELL_SILENT_S) as u64);
/// Time between two looks beyond which this process itself has stood still.
const OWN_GAP: Duration = Duration::from_millis(500);
/// Time for its first cycle, and for its end in order.
const FIRST: Duration = Duration::from_secs(20);

pub(super) struct Supervisor {
    start: CellStart,
    sockets: PathBuf,
    /// `None`: threads of this process.
    program: Option<PathBuf>,
    client: CellClient,
    /// Its cycle has ended in order.
    ends: bool,
    /// Time of the last cycle that came, or of the start.
    heard: Instant,
    has_heard: bool,
    /// Time of the last look for news.
    looked: Instant,
    restarts: VecDeque<Instant>,
}

/// Something that has come from the cell.
pub(super) enum News {
    Report(Report),
    /// It has gone without a report of its end.
    Lost(Message),
}

impl Supervisor {
    /// Looks after the cell that was [`found`], or starts one.
    pub(super) fn start(
        found: Option<CellClient>,
        start: CellStart,
        sockets: PathBuf,
        program: Option<PathBuf>,
    ) -> Result<Self, Message> {
        let client = found.map_or_else(|| started(&start, &sockets, program.as_ref()), Ok)?;
        let now = Instant::now();
        let restarts = VecDeque::new();
        Ok(Self { start, sockets, program, client, ends: false, heard: now, has_heard: false, looked: now, restarts })
    }

    /// Returns true if the cell was found running, with a program.
    pub(super) fn has_program(&self) -> bool {
        matches!(self.client.first(), Some(Report::Hello { program: Some(_), .. }))
    }

    /// Returns true if the process of the cell lives without a cycle.
    pub(super) fn is_silent(&self) -> bool {
        self.has_heard && !self.ends && self.client.process().is_some() && self.heard.elapsed() > SILENT
    }

    /// Returns the inputs of the cell's start.
    pub(super) fn start_of_cell(&self) -> &CellStart {
        &self.start
    }

    /// Sends a request. Returns false if the cell does not take it.
    pub(super) fn send(&self, request: &Request) -> bool {
        self.client.send(request)
    }

    /// Returns the next news, if there is any.
    pub(super) fn news(&mut self) -> Option<News> {
        if self.looked.elapsed() > OWN_GAP {
            // This process stood still itself: what the cell has sent meanwhile is still to come.
            self.heard = Instant::now();
        }
        self.looked = Instant::now();
        match self.client.report() {
            Ok(Some(report)) => {
                if matches!(report, Report::Ending) {
                    (self.heard, self.ends) = (Instant::now(), true);
                }
                if matches!(report, Report::Cycle(_)) {
                    (self.heard, self.has_heard) = (Instant::now(), true);
                }
                Some(News::Report(report))
            }
            Ok(None) => {
                let patience = if self.ends || !self.has_heard { FIRST } else { FROZEN };
                if self.heard.elapsed() > patience && self.client.process().is_some() {
                    // The end of its connection is the next news.
                    self.client.kill();
                    self.heard = Instant::now();
                }
                None
            }
            Err(_) => {
                let why = self.client.wait();
                Some(News::Lost(why.unwrap_or_else(|| Message::new("cell-process-ended-early"))))
            }
        }
    }

    /// Starts a new cell in the place of one that has died: its devices are connected anew, which makes their outputs
    /// safe.
    ///
    /// # Errors
    /// If it has died too often, or its devices do not answer.
    pub(super) fn restart(&mut self) -> Result<(), Message> {
        self.restarts.retain(|at| at.elapsed() < WITHIN);
        if self.restarts.len() >= MAX_RESTARTS {
            return Err(Message::new("server-cell-dies-often").number("n", (MAX_RESTARTS + 1) as f64, 0));
        }
        self.restarts.push_back(Instant::now());
        self.client = started(&self.start, &self.sockets, self.program.as_ref())?;
        self.ends = false;
        (self.heard, self.has_heard, self.looked) = (Instant::now(), false, Instant::now());
        Ok(())
    }

    /// Waits until the cell has gone. Returns how it ended, if not in order.
    pub(super) fn wait(&self) -> Option<Message> {
        self.client.wait()
    }

    pub(super) fn kill(&self) {
        self.client.kill();
    }
}

/// Finds a cell that has outlived its panel, with a program or on the machine of `start`. Another one is ended.
pub(super) fn found(start: &CellStart, sockets: &Path) -> Result<Option<CellClient>, Message> {
    let Some(client) = CellClient::found(sockets)? else { return Ok(None) };
    let fits = match client.first() {
        Some(Report::Hello { program: Some(_), .. }) => true,
        Some(Report::Hello { machine, .. }) => machine == fingerprint(&start.machine.read()?),
        _ => false,
    };
    if fits {
        return Ok(Some(client));
    }
    client.send(&Request::Shutdown);
    let begin = Instant::now();
    while client.report().is_ok() && begin.elapsed() < FIRST {
        std::thread::sleep(Duration::from_millis(1));
    }
    // How it ended is in its own log.
    client.wait();
    Ok(None)
}

fn started(start: &CellStart, sockets: &Path, program: Option<&PathBuf>) -> Result<CellClient, Message> {
    match program {
        Some(program) => CellClient::in_process(program, sockets, start),
        None => CellClient::in_threads(sockets, start),
    }
}
