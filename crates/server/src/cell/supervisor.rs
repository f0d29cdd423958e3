//! Starts the cell, watches that it lives, and starts it again, off and without a program, if it has died.

use seamwright_cell::protocol::{CELL_SILENT_S, PANEL_LOST_S, Report, Request};
use seamwright_cell::{CellClient, CellStart, fingerprint};
use seamwright_message::Message;
use std::collections::VecDeque;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// Maximum number of starts after the first one in [`WITHIN`]: a cell that dies more often is not started again.
const MAX_RESTARTS: usize = 3;
const WITHIN: Duration = Duration::from_secs(600);
/// Period of signs of life.
const BEAT: Duration = Duration::from_millis((100.0 * PANEL_LOST_S) as u64);
/// The cell is killed and started again without a cycle for this long: its devices' outputs become safe by that.
const FROZEN: Duration = Duration::from_millis((2000.0 * CELL_SILENT_S) as u64);
/// Time for its first cycle.
const FIRST: Duration = Duration::from_secs(20);

pub(super) struct Supervisor {
    start: CellStart,
    sockets: PathBuf,
    /// `None`: threads of this process.
    program: Option<PathBuf>,
    client: CellClient,
    beat: Instant,
    /// Time of the last cycle that came, and whether one has.
    heard: (Instant, bool),
    restarts: VecDeque<Instant>,
}

/// Something that has come from the cell.
pub(super) enum News {
    Report(Report),
    /// It has gone without a report of its end.
    Lost(Message),
}

impl Supervisor {
    pub(super) fn start(start: CellStart, sockets: PathBuf, program: Option<PathBuf>) -> Result<Self, Message> {
        let client = match found(&start, &sockets)? {
            Some(client) => client,
            None => started(&start, &sockets, program.as_ref())?,
        };
        let heard = (Instant::now(), false);
        Ok(Self { start, sockets, program, client, beat: Instant::now(), heard, restarts: VecDeque::new() })
    }

    /// Returns true if the cell was found running, with a program.
    pub(super) fn has_program(&self) -> bool {
        matches!(self.client.first(), Some(Report::Hello { program: Some(_), .. }))
    }

    /// Returns the inputs of the cell's start.
    pub(super) fn start_of_cell(&self) -> &CellStart {
        &self.start
    }

    /// Sends a request. Returns false if the cell does not take it.
    pub(super) fn send(&self, request: &Request) -> bool {
        self.client.send(request)
    }

    /// Shows the cell that the panel lives.
    pub(super) fn beat(&mut self) {
        if self.beat.elapsed() >= BEAT {
            self.beat = Instant::now();
            // A cell that has gone is noticed by the next report.
            self.client.send(&Request::Beat);
        }
    }

    /// Returns the next news, if there is any.
    pub(super) fn news(&mut self) -> Option<News> {
        match self.client.report() {
            Ok(Some(report)) => {
                if matches!(report, Report::Cycle(_)) {
                    self.heard = (Instant::now(), true);
                }
                Some(News::Report(report))
            }
            Ok(None) => {
                let patience = if self.heard.1 { FROZEN } else { FIRST };
                if self.heard.0.elapsed() > patience && self.client.process().is_some() {
                    // The end of its connection is the next news.
                    self.client.kill();
                    self.heard.0 = Instant::now();
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
        self.heard = (Instant::now(), false);
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
fn found(start: &CellStart, sockets: &Path) -> Result<Option<CellClient>, Message> {
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
