//! Stops and holds of pages, on their own way to the cell.

use seamwright_cell::StopLine;
use seamwright_executive::Ask;
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use tokio::sync::oneshot;

/// Stops and holds, past all queues and past the desk. One thread passes them on, so that no page waits for a cell that
/// does not answer.
#[derive(Debug, Clone)]
pub(crate) struct Urgent {
    to: Sender<Asked>,
}

#[derive(Debug)]
struct Asked {
    ask: Ask,
    answer: oneshot::Sender<Option<u64>>,
}

impl Urgent {
    pub(super) fn start(line: StopLine) -> std::io::Result<Self> {
        let (to, from) = channel();
        std::thread::Builder::new().name("panel-stop".into()).spawn(move || pass_on(line, &from))?;
        Ok(Self { to })
    }

    /// Requests a stop or a hold. The answer is the number of the cycle that acted; `None` or nothing if none has.
    pub(crate) fn ask(&self, ask: &Ask) -> oneshot::Receiver<Option<u64>> {
        let (answer, answered) = oneshot::channel();
        // The thread lives as long as there is a sender.
        drop(self.to.send(Asked { ask: *ask, answer }));
        answered
    }
}

fn pass_on(mut line: StopLine, from: &Receiver<Asked>) {
    loop {
        let first = match from.recv_timeout(StopLine::KEEP) {
            Ok(first) => first,
            Err(RecvTimeoutError::Timeout) => {
                line.keep();
                continue;
            }
            Err(RecvTimeoutError::Disconnected) => return,
        };
        // Requests that came meanwhile are answered together: a held key does not delay the next stop.
        let all: Vec<Asked> = std::iter::once(first).chain(from.try_iter()).collect();
        let ask = if all.iter().any(|asked| asked.ask == Ask::Stop) { Ask::Stop } else { Ask::Hold };
        let cycle = line.ask(&ask).unwrap_or(None);
        // A page may not wait for its answer.
        all.into_iter().for_each(|asked| {
            let _ = asked.answer.send(cycle);
        });
    }
}
