//! STOP and hold on a socket of their own, with a thread of its own: independent of panel, users, disks, encryption and
//! all other clients.
//!
//! One line per request: `stop` or `hold`. One line per answer: `stopped CYCLE` or `held CYCLE` with the number of the
//! cycle that acted, or `silent` if no cycle has acted in time. `here` is answered by `here`: it keeps a connection open,
//! so that a stop needs no look at a disk that may hang.

use crate::sockets;
use seamwright_executive::Ask;
use seamwright_executive::realtime::Urgent;
use std::io::{self, BufRead as _, BufReader, Read as _, Write as _};
use std::os::unix::net::{UnixListener, UnixStream};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

/// Maximum time for a cycle to act; then the answer is `silent`. The request stays.
const ACTS: Duration = Duration::from_millis(500);
/// Polling period for it.
const LOOK: Duration = Duration::from_micros(200);
/// A client that sends or reads nothing for this long is disconnected.
const PATIENCE: Duration = Duration::from_secs(2);
/// Maximum length of a request, bytes.
const MAX_LINE: u64 = 16;
/// Maximum length of an answer, bytes.
const MAX_ANSWER: usize = 64;
/// Maximum number of clients at a time.
const MAX_CLIENTS: usize = 16;

/// The listening thread; dropped, it ends.
#[derive(Debug)]
pub(crate) struct StopListener {
    is_over: Arc<AtomicBool>,
    path: Option<PathBuf>,
}

impl Drop for StopListener {
    fn drop(&mut self) {
        self.is_over.store(true, Ordering::SeqCst);
        // Wakes the thread.
        drop(self.path.take().map(UnixStream::connect));
    }
}

/// Answers clients, each in a thread of its own, so that none waits for another.
pub(crate) fn listen(listener: UnixListener, urgent: &Urgent) -> io::Result<StopListener> {
    let is_over = Arc::new(AtomicBool::new(false));
    let path = listener.local_addr()?.as_pathname().map(Path::to_owned);
    let handle = StopListener { is_over: Arc::clone(&is_over), path };
    let place = Arc::new(());
    let urgent = urgent.clone();
    let accept = move || {
        for client in listener.incoming() {
            if is_over.load(Ordering::SeqCst) {
                return;
            }
            let Ok(client) = client else { continue };
            if Arc::strong_count(&place) > MAX_CLIENTS {
                // A stop counts even if its sender cannot be answered.
                urgent.ask(&Ask::Stop);
                continue;
            }
            let (urgent, held) = (urgent.clone(), Arc::clone(&place));
            let answer = move || {
                // A client that has gone needs no answer.
                let _ = answer(client, &urgent);
                drop(held);
            };
            // Without a thread for this client it is dropped, and sees that.
            let _ = std::thread::Builder::new().name("stop".into()).spawn(answer);
        }
    };
    std::thread::Builder::new().name("stop-listener".into()).spawn(accept)?;
    Ok(handle)
}

fn answer(client: UnixStream, urgent: &Urgent) -> io::Result<()> {
    client.set_read_timeout(Some(PATIENCE))?;
    client.set_write_timeout(Some(PATIENCE))?;
    let mut lines = BufReader::new(client.try_clone()?);
    let mut client = client;
    loop {
        let mut line = String::new();
        if lines.by_ref().take(MAX_LINE).read_line(&mut line)? == 0 {
            return Ok(());
        }
        let (ask, word) = match line.trim_end() {
            "stop" => (Ask::Stop, "stopped"),
            "hold" => (Ask::Hold, "held"),
            "here" => {
                client.write_all(b"here\n")?;
                continue;
            }
            _ => {
                client.write_all(b"allowed: stop, hold, here\n")?;
                continue;
            }
        };
        let Some(request) = urgent.ask(&ask) else { continue };
        let begin = Instant::now();
        let acted = loop {
            match urgent.acted_in(request) {
                Some(cycle) => break Some(cycle),
                None if begin.elapsed() > ACTS => break None,
                None => std::thread::sleep(LOOK),
            }
        };
        let said = acted.map_or_else(|| "silent\n".to_owned(), |cycle| format!("{word} {cycle}\n"));
        client.write_all(said.as_bytes())?;
    }
}

/// Stops or holds the cell in a folder, past all queues.
#[derive(Debug)]
pub struct StopLine {
    path: PathBuf,
    /// The connection of the last request.
    kept: Option<UnixStream>,
}

impl StopLine {
    /// Time within which [`StopLine::keep`] must be called, for its connection to stay open.
    pub const KEEP: Duration = Duration::from_millis(PATIENCE.as_millis() as u64 / 2);

    /// Creates a line to the cell whose sockets are in `folder`.
    pub fn new(folder: &Path) -> Self {
        Self { path: sockets::stop(folder), kept: None }
    }

    /// Keeps the line open. Without a cell it is opened by the next call.
    pub fn keep(&mut self) {
        // The next request opens it anew.
        drop(self.say("here"));
    }

    /// Requests a stop or a hold and waits, at most a second, for the number of the cycle that acted; `None` for other
    /// commands.
    ///
    /// # Errors
    /// If there is no cell, or its cycle stands.
    pub fn ask(&mut self, ask: &Ask) -> io::Result<Option<u64>> {
        let word = match ask {
            Ask::Stop => "stop",
            Ask::Hold => "hold",
            _ => return Ok(None),
        };
        let answer = self.say(word)?;
        let cycle = answer.split_whitespace().nth(1).and_then(|cycle| cycle.parse().ok());
        cycle.map(Some).ok_or_else(|| io::Error::new(io::ErrorKind::TimedOut, "no cycle has acted"))
    }

    /// Sends a line and reads the answer; a connection whose cell has gone is replaced.
    fn say(&mut self, word: &str) -> io::Result<String> {
        if let Some(kept) = self.kept.take() {
            match self.say_over(kept, word) {
                // It lives, but does not answer: a new connection would not help.
                Err(e) if is_late(&e) => return Err(e),
                Err(_) => {}
                answer => return answer,
            }
        }
        let line = UnixStream::connect(&self.path)?;
        line.set_write_timeout(Some(2 * ACTS))?;
        line.set_read_timeout(Some(2 * ACTS))?;
        self.say_over(line, word)
    }

    /// A connection that is late stays open: the path of a new one may be on a disk that hangs.
    fn say_over(&mut self, mut line: UnixStream, word: &str) -> io::Result<String> {
        let answer = line.write_all(format!("{word}\n").as_bytes()).and_then(|()| answer_to(word, &line));
        if answer.as_ref().err().is_none_or(is_late) {
            self.kept = Some(line);
        }
        answer
    }
}

fn is_late(error: &io::Error) -> bool {
    matches!(error.kind(), io::ErrorKind::WouldBlock | io::ErrorKind::TimedOut)
}

/// Reads the answer to `word`. Late answers to `here` before it are left out.
fn answer_to(word: &str, mut line: &UnixStream) -> io::Result<String> {
    loop {
        let (mut answer, mut byte) = (Vec::new(), [0]);
        // Byte by byte: what follows stays in the socket.
        while answer.len() < MAX_ANSWER && line.read(&mut byte)? > 0 && byte != [b'\n'] {
            answer.push(byte[0]);
        }
        let answer = String::from_utf8_lossy(&answer).into_owned();
        match answer.as_str() {
            "" => return Err(io::ErrorKind::UnexpectedEof.into()),
            "here" if word != "here" => {}
            _ => return Ok(answer),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Listeners;

    /// A cycle that stands is reported as such, and the request is there once it goes on.
    #[test]
    fn a_stop_is_acknowledged_by_a_cycle_or_reported_as_silent() {
        let folder = tempfile::tempdir().unwrap();
        let listeners = Listeners::bind(folder.path()).unwrap();
        let (mut port, outside) = seamwright_executive::realtime::live(&Default::default());
        let _listens = listen(listeners.stop, &outside.urgent()).unwrap();
        let mut line = StopLine::new(folder.path());
        assert_eq!(line.ask(&Ask::Stop).unwrap_err().kind(), io::ErrorKind::TimedOut);
        let taken = seamwright_executive::Port::command(&mut port, 0.0).map(|command| command.ask);
        assert_eq!(taken, Some(Ask::Stop));
        let end = Arc::new(AtomicBool::new(false));
        let its_end = Arc::clone(&end);
        let cycle = std::thread::spawn(move || {
            let mut asked = Vec::new();
            while !its_end.load(Ordering::Relaxed) {
                asked.extend(seamwright_executive::Port::command(&mut port, 0.0).map(|command| command.ask));
                std::thread::sleep(Duration::from_millis(1));
            }
            asked
        });
        assert_eq!(line.ask(&Ask::Hold).unwrap(), Some(1));
        assert_eq!(line.ask(&Ask::Stop).unwrap(), Some(1));
        assert_eq!(line.ask(&Ask::Reset).unwrap(), None);
        // A kept line needs no file: that of its socket may be on a disk that hangs.
        line.keep();
        std::fs::remove_file(sockets::stop(folder.path())).unwrap();
        assert_eq!(line.ask(&Ask::Stop).unwrap(), Some(1));
        end.store(true, Ordering::Relaxed);
        assert_eq!(cycle.join().unwrap(), [Ask::Hold, Ask::Stop, Ask::Stop]);
    }

    #[test]
    fn other_words_are_refused_and_a_flood_of_clients_does_not_keep_a_stop_out() {
        let folder = tempfile::tempdir().unwrap();
        let listeners = Listeners::bind(folder.path()).unwrap();
        assert!(Listeners::bind(folder.path()).is_err());
        let (mut port, outside) = seamwright_executive::realtime::live(&Default::default());
        let _listens = listen(listeners.stop, &outside.urgent()).unwrap();
        let mut wrong = UnixStream::connect(sockets::stop(folder.path())).unwrap();
        wrong.write_all(b"jump\n").unwrap();
        let mut answer = String::new();
        BufReader::new(wrong).read_line(&mut answer).unwrap();
        assert_eq!(answer, "allowed: stop, hold, here\n");
        assert_eq!(seamwright_executive::Port::command(&mut port, 0.0), None);
        // Connections beyond the limit that send nothing are stops: better one too many than none.
        let held: Vec<_> =
            (0..2 * MAX_CLIENTS).map(|_| UnixStream::connect(sockets::stop(folder.path())).unwrap()).collect();
        let begin = Instant::now();
        let mut taken = None;
        while taken.is_none() && begin.elapsed() < Duration::from_secs(10) {
            taken = seamwright_executive::Port::command(&mut port, 0.0);
            std::thread::sleep(Duration::from_millis(1));
        }
        assert_eq!(taken.map(|command| command.ask), Some(Ask::Stop));
        drop(held);
    }
}
