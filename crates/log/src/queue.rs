//! Queue of lines to the thread that writes them: no caller waits for standard error.

use crate::format::Format;
use std::io::{self, Write};
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::mpsc::{Receiver, Sender, SyncSender, TrySendError, channel, sync_channel};
use std::time::Duration;
use tracing_subscriber::fmt::MakeWriter;

/// Maximum number of queued lines.
const MAX_WAITING: usize = 1024;
/// Maximum wait for standard error at the end.
const PATIENCE: Duration = Duration::from_secs(1);

enum Item {
    Line(Vec<u8>),
    /// Everything before this is written.
    Flush(Sender<()>),
}

/// Entrance of the queue.
#[derive(Debug, Clone)]
pub(crate) struct Queue {
    to: SyncSender<Item>,
    left_out: Arc<AtomicU64>,
}

/// The thread that writes.
#[derive(Debug)]
pub(crate) struct Writer {
    to: SyncSender<Item>,
}

impl Queue {
    /// Starts the thread that writes. `None` if the system refuses a thread.
    pub(crate) fn to_standard_error(format: Format) -> Option<(Self, Writer)> {
        Self::to(io::stderr(), format, MAX_WAITING)
    }

    fn to(out: impl Write + Send + 'static, format: Format, room: usize) -> Option<(Self, Writer)> {
        let (to, from) = sync_channel(room);
        let left_out = Arc::new(AtomicU64::new(0));
        let counted = Arc::clone(&left_out);
        std::thread::Builder::new().name("log".to_owned()).spawn(move || write(&from, &counted, format, out)).ok()?;
        Some((Self { to: to.clone(), left_out }, Writer { to }))
    }
}

impl Writer {
    /// Waits until all queued lines are written, a moment at most.
    pub(crate) fn flush(&self) {
        let (to, written) = channel();
        let mut item = Item::Flush(to);
        // A full queue empties as fast as standard error is read.
        for _ in 0..10 {
            match self.to.try_send(item) {
                Ok(()) => break,
                Err(TrySendError::Disconnected(_)) => return,
                Err(TrySendError::Full(same)) => item = same,
            }
            std::thread::sleep(PATIENCE / 10);
        }
        let _ = written.recv_timeout(PATIENCE);
    }
}

fn write(from: &Receiver<Item>, left_out: &AtomicU64, format: Format, mut out: impl Write) {
    for item in from {
        let gap = left_out.swap(0, Ordering::Relaxed);
        if gap > 0 {
            // A failed write is ignored: logging stops nothing.
            let _ = out.write_all(format.left_out(gap).as_bytes());
        }
        let _ = match item {
            Item::Line(line) => out.write_all(&line),
            Item::Flush(to) => to.send(()).map_err(|_| io::ErrorKind::BrokenPipe.into()),
        };
    }
}

impl Write for Queue {
    /// Takes a whole line, or counts it as left out.
    fn write(&mut self, line: &[u8]) -> io::Result<usize> {
        if self.to.try_send(Item::Line(line.to_vec())).is_err() {
            self.left_out.fetch_add(1, Ordering::Relaxed);
        }
        Ok(line.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

impl<'a> MakeWriter<'a> for Queue {
    type Writer = Self;

    fn make_writer(&'a self) -> Self {
        self.clone()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::Mutex;

    /// Standard error whose reader is slow: writing waits for the lock.
    #[derive(Clone, Default)]
    struct Slow(Arc<Mutex<Vec<u8>>>);

    impl Write for Slow {
        fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
            self.0.lock().unwrap().extend_from_slice(bytes);
            Ok(bytes.len())
        }

        fn flush(&mut self) -> io::Result<()> {
            Ok(())
        }
    }

    #[test]
    fn nobody_waits_for_a_slow_reader_and_lines_left_out_are_counted() {
        let slow = Slow::default();
        let (mut queue, writer) = Queue::to(slow.clone(), Format::Text, 8).unwrap();
        let reads = slow.0.lock().unwrap();
        for i in 0..100 {
            queue.write_all(format!("line {i}\n").as_bytes()).unwrap();
        }
        drop(reads);
        writer.flush();
        let text = String::from_utf8(slow.0.lock().unwrap().clone()).unwrap();
        let lines = text.lines().filter(|line| line.starts_with("line ")).count();
        // The thread may hold one line more.
        assert!((8..=9).contains(&lines), "{text}");
        assert!(text.contains(&format!("{} log lines were left out code=", 100 - lines)), "{text}");
    }
}
