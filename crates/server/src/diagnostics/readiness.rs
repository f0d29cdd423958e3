use super::disk_probe::SILENT;
use crate::http::Panel;
use seamwright_log::{self as log, Level};
use seamwright_message::{Argument, Message, Unit};
use seamwright_record::SPARE_BYTES;
use std::time::Duration;

/// Maximum age of the cell's last answer.
const CELL_SILENT: Duration = Duration::from_secs(1);

/// Period of looking for the log.
const LOOK: Duration = Duration::from_secs(1);

/// Logs changes of the readiness, until dropped.
pub(crate) async fn log_changes(panel: &Panel) {
    let mut before: Option<Vec<String>> = None;
    loop {
        let reasons = reasons(panel);
        // The ages in them change with every look.
        let codes: Vec<String> = reasons.iter().map(|reason| reason.code.to_string()).collect();
        let starts = ["server-not-ready-cell-starts", "server-not-ready-disk-unknown"];
        let is_known = !codes.iter().any(|code| starts.contains(&code.as_str()));
        if is_known && before.as_ref() != Some(&codes) {
            log::event(if codes.is_empty() { Level::Info } else { Level::Error }, &change(reasons), None);
            before = Some(codes);
        }
        tokio::time::sleep(LOOK).await;
    }
}

fn change(reasons: Vec<Message>) -> Message {
    match reasons.is_empty() {
        true => Message::new("server-log-ready"),
        false => {
            let reasons = reasons.into_iter().map(|reason| Argument::Message(Box::new(reason)));
            Message::new("server-log-not-ready").list("reasons", reasons)
        }
    }
}

/// Returns the reasons for which the cell cannot be used now; empty if it is ready.
pub(crate) fn reasons(panel: &Panel) -> Vec<Message> {
    let age = panel.cell.hub.age();
    let cell = match age {
        None => Some(Message::new("server-not-ready-cell-starts")),
        Some(age) if age >= CELL_SILENT => {
            Some(Message::new("server-not-ready-cell").quantity("age", age.as_secs_f64(), Unit::S, 1))
        }
        Some(_) => None,
    };
    cell.into_iter().chain(disk(panel)).collect()
}

fn disk(panel: &Panel) -> Vec<Message> {
    let Some(probe) = panel.diagnostics.disk.get() else { return Vec::new() };
    let (look, age) = probe.last();
    let of = |code| Message::new(code).text("folder", probe.folder().display().to_string());
    if age >= SILENT {
        return vec![of("server-not-ready-disk-silent").quantity("age", age.as_secs_f64(), Unit::S, 0)];
    }
    let Some(look) = look else { return vec![of("server-not-ready-disk-unknown")] };
    let mib = |bytes: u64| (bytes >> 20) as f64;
    let full = look.room.filter(|room| room.free_bytes < SPARE_BYTES).map(|room| {
        let message = of("server-not-ready-disk-full").quantity("free", mib(room.free_bytes), Unit::MiB, 0);
        message.quantity("needed", mib(SPARE_BYTES), Unit::MiB, 0)
    });
    let trouble = look.trouble.map(|why| Message::new("server-not-ready-library").message("reason", why));
    full.into_iter().chain(trouble).collect()
}
