//! The process of the cell, and STOP from a terminal.

use crate::args::serve::{CellArgs, StopArgs};
use crate::refusals::{not_json, refused};
use crate::rows::print_text;
use seamwright_cell::{CellStart, Listeners, StopLine, run};
use seamwright_executive::Ask;
use seamwright_executive::realtime::Shutdown;
use seamwright_message::Message;
use seamwright_project::failure::Failure;
use std::io::{ErrorKind, Read as _};

/// Maximum size of what a cell starts with, bytes: the text of a machine file.
const MAX_START: u64 = 16 << 20;

/// Runs a cell until its panel or a signal ends it. The first line of standard output reports whether it is ready.
pub(crate) fn cell(args: &CellArgs) -> Result<(), Failure> {
    let shutdown = Shutdown::default();
    shutdown.on_signals()?;
    shutdown.on_panic();
    // If memory runs short, the kernel ends other processes first. It needs rights that a service has; some systems lack
    // this file.
    let _ = std::fs::write("/proc/self/oom_score_adj", "-900");
    let mut text = String::new();
    std::io::stdin().take(MAX_START).read_to_string(&mut text)?;
    let said = |outcome: &Result<(), Message>| {
        let line = serde_json::to_string(outcome).map_err(|e| Failure::environment(Message::outside(&e)))?;
        print_text(&format!("{line}\n"))
    };
    let start: CellStart = serde_json::from_str(&text).map_err(|e| not_json(std::io::Error::other(e)))?;
    let listeners = Listeners::bind(&args.sockets);
    // A panel that has gone meanwhile is noticed by the link.
    let ended = listeners.and_then(|listeners| run(&start, listeners, &shutdown, || drop(said(&Ok(())))));
    match ended {
        Ok(true) => Ok(()),
        Ok(false) => Err(Failure::environment(Message::new("cli-cycle-ended-early"))),
        Err(why) => {
            said(&Err(why.clone()))?;
            Err(Failure::environment(why))
        }
    }
}

/// Stops the running cell of a data folder, and prints the number of the cycle that acted.
pub(crate) fn stop(args: &StopArgs) -> Result<(), Failure> {
    let data = super::records::folder(args.data.as_deref())?;
    let mut line = StopLine::new(&data.join("cell"));
    match line.ask(&Ask::Stop) {
        Ok(Some(cycle)) => print_text(&format!("{}\n", Message::new("cli-stopped").number("cycle", cycle as f64, 0))),
        Ok(None) => Ok(()),
        Err(e) if matches!(e.kind(), ErrorKind::NotFound | ErrorKind::ConnectionRefused | ErrorKind::NotADirectory) => {
            let data = data.display().to_string();
            Err(refused("--data", data, Message::new("cli-no-cell-runs"), Message::new("cli-data-of-running-cell")))
        }
        Err(e) => Err(Failure::environment(Message::new("cli-stop-unanswered").message("why", Message::outside(&e)))),
    }
}
