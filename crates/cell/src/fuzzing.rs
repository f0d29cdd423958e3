//! Readers of bytes from another process, for random inputs.

use crate::frame::{Inbox, encode};
use crate::program::Program;
use crate::protocol::{MAX_REPORT, MAX_REQUEST, RecordStart, Report, Request, VERSION};
use seamwright_executive::{Alarm, Ask, Command};
use seamwright_record::WeldFiles;
use seamwright_record::trace::{Column, Kind};
use serde::Serialize;
use serde::de::DeserializeOwned;

/// Reads requests of a panel: as they come from a socket, and as the message of one frame.
///
/// # Panics
/// If a request that is read is not the same after writing and reading.
pub fn requests(bytes: &[u8]) {
    messages::<Request>(bytes, MAX_REQUEST);
}

/// Reads reports of a cell, like [`requests`].
///
/// # Panics
/// If a report that is read is not the same after writing and reading.
pub fn reports(bytes: &[u8]) {
    messages::<Report>(bytes, MAX_REPORT);
}

fn messages<T: Serialize + DeserializeOwned>(bytes: &[u8], max: usize) {
    let length = u32::try_from(bytes.len()).unwrap_or(u32::MAX).to_le_bytes();
    for stream in [bytes.to_vec(), [&length, bytes].concat()] {
        let mut inbox = Inbox::default();
        let mut rest = &stream[..];
        while matches!(inbox.read(&mut rest), Ok(true)) {}
        while let Ok(Some(message)) = inbox.next::<T>(max) {
            let written = encoded(&message);
            let mut again = Inbox::default();
            let mut from = &written[..];
            while matches!(again.read(&mut from), Ok(true)) {}
            let read = again.next::<T>(usize::MAX).unwrap_or_else(|e| panic!("{e}"));
            // NaN differs from itself; its bytes do not.
            assert!(read.is_some_and(|read| encoded(&read) == written));
        }
    }
}

fn encoded(message: &impl Serialize) -> Vec<u8> {
    let mut bytes = Vec::new();
    encode(message, &mut bytes).unwrap_or_else(|e| panic!("{e}"));
    bytes
}

/// One request of each kind, without the length of its frame.
pub fn request_seeds() -> Vec<Vec<u8>> {
    let program = Program {
        number: 1,
        job: "first-weld.toml".to_owned(),
        text: "schema = 1".to_owned(),
        folder: "jobs".into(),
        machine: "0123".to_owned(),
        motion: vec![0x81, 0xa1, 0x61],
        sha256: "4567".to_owned(),
        from: None,
        about: "{}".to_owned(),
        distortion: None,
    };
    let files = WeldFiles {
        weld: 7,
        data: "data".into(),
        columns: vec![Column::new("t_s", "s", Kind::F64)],
        about: vec![("title".to_owned(), "a weld".to_owned())],
        most_rows: 1000,
        rows: 100,
    };
    let requests = [
        Request::Hello { version: VERSION },
        Request::Beat,
        Request::Command(Command::of(Ask::Override(0.5))),
        Request::Command(Command::of(Ask::AcknowledgeOne(Alarm::ALL[3], 7))),
        Request::Load(Box::new(program)),
        Request::Record(Box::new(RecordStart { start: 3, passes: 2, files, values: 2, heads: 1 })),
        Request::NoRecord { start: 3 },
        Request::Shutdown,
    ];
    requests.iter().map(|request| encoded(request).split_off(4)).collect()
}

/// One report of most kinds, without the length of its frame.
pub fn report_seeds() -> Vec<Vec<u8>> {
    let reports = [
        Report::Hello {
            version: VERSION,
            process: 1,
            machine: "0123".to_owned(),
            program: None,
            alarms: Vec::new(),
            recording: Some(7),
            unrecorded: Some(3),
            open: vec![6, 7],
        },
        Report::WeldBegins { start: 3 },
        Report::RecordFails { why: seamwright_message::Message::verbatim("slow") },
        Report::Recorded { weld: 7 },
        Report::Ending,
        Report::Prepared { number: 1, outcome: Err(crate::protocol::Unprepared::Busy) },
        Report::DevicesReleased,
        Report::Released { device: "source".to_owned(), outcome: Ok(()) },
        Report::Ended { failed: false },
    ];
    reports.iter().map(|report| encoded(report).split_off(4)).collect()
}
