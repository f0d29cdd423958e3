//! The panel's side of the link: starts a cell and talks to it.

use crate::frame::{Inbox, encode};
use crate::protocol::{MAX_REPORT, PANEL_LOST_S, Report, Request, VERSION};
use crate::run::{CellStart, run};
use crate::sockets::{self, Listeners};
use seamwright_executive::realtime::Shutdown;
use seamwright_message::Message;
use std::io::{BufRead as _, BufReader, Write as _};
use std::os::unix::net::UnixStream;
use std::os::unix::process::ExitStatusExt as _;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, SyncSender, TryRecvError, TrySendError, channel, sync_channel};
use std::sync::{Mutex, PoisonError};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

/// Maximum time of a cell to connect its devices.
const READY: Duration = Duration::from_secs(60);
/// Maximum time of an ended cell to be gone.
const GONE: Duration = Duration::from_secs(5);
/// Reports that wait for the panel; beyond that the cell leaves cycles out.
const REPORTS: usize = 4096;
/// Period of [`Request::Beat`] while there is nothing else to be sent.
const BEAT: Duration = Duration::from_millis((100.0 * PANEL_LOST_S) as u64);
/// Requests that wait for the cell: it reads them every millisecond.
const REQUESTS: usize = 1024;

/// The connection to the cell has ended without [`Report::Ended`]: it was killed, has crashed, or has turned the panel
/// away.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct CellLost;

/// Process or threads of the cell.
#[derive(Debug)]
enum Home {
    Process(Child),
    Threads(JoinHandle<()>),
    /// A process that this one has not started.
    Found(u32),
    Gone,
}

/// A running cell as its panel sees it.
#[derive(Debug)]
pub struct CellClient {
    /// The first report, if it was read here.
    first: Mutex<Option<Report>>,
    reports: Mutex<Receiver<Report>>,
    requests: SyncSender<Vec<u8>>,
    home: Mutex<Home>,
    pid: Option<u32>,
}

impl CellClient {
    /// Starts `program cell` as a process, with its sockets in `folder`, and connects to it.
    ///
    /// # Errors
    /// If it cannot be started, or its machine or devices are invalid.
    pub fn in_process(program: &Path, folder: &Path, start: &CellStart) -> Result<Self, Message> {
        let text = serde_json::to_vec(start).map_err(|e| Message::outside(&e))?;
        let mut command = Command::new(program);
        command.arg("cell").arg("--sockets").arg(folder).arg("--start-on-input");
        // Each arena of the allocator reserves 64 MiB, which counts as locked memory; the cycle allocates nothing.
        command.env("MALLOC_ARENA_MAX", "1");
        command.stdin(Stdio::piped()).stdout(Stdio::piped());
        let mut child = command.spawn().map_err(|e| no_process(&e))?;
        let said = child.stdin.take().zip(child.stdout.take());
        let ready =
            said.ok_or_else(|| no_process(&std::io::ErrorKind::BrokenPipe.into())).and_then(|(mut to, from)| {
                // A process that has already ended reports the reason itself.
                drop(to.write_all(&text));
                drop(to);
                ready(BufReader::new(from))
            });
        if let Err(why) = ready {
            // It has ended, or is of no use.
            drop(child.kill());
            drop(child.wait());
            return Err(why);
        }
        Self::connect(folder, Home::Process(child))
    }

    /// Starts a cell in threads of this process, with its sockets in `folder`, and connects to it.
    ///
    /// # Errors
    /// See [`CellClient::in_process`].
    pub fn in_threads(folder: &Path, start: &CellStart) -> Result<Self, Message> {
        let listeners = Listeners::bind(folder)?;
        let (to, from) = channel();
        let start = start.clone();
        let cell = move || {
            let ready = to.clone();
            let ended = run(&start, listeners, &Shutdown::default(), move || drop(ready.send(Ok(()))));
            // Once the cell has been ready, the receiver has gone.
            drop(to.send(ended.map(drop)));
        };
        let thread = std::thread::Builder::new().name("cell".into()).spawn(cell).map_err(|e| Message::outside(&e))?;
        from.recv().unwrap_or_else(|_| Err(Message::new("cell-program-panicked")))?;
        Self::connect(folder, Home::Threads(thread))
    }

    /// Connects to the cell that runs with its sockets in `folder`; `None` if no cell runs there.
    ///
    /// # Errors
    /// If it has another panel, or another version of this program runs it.
    pub fn found(folder: &Path) -> Result<Option<Self>, Message> {
        let Ok(stream) = UnixStream::connect(sockets::panel(folder)) else { return Ok(None) };
        let client = Self::over(stream, Home::Gone).map_err(|e| no_process(&e))?;
        let reports = client.reports.lock().unwrap_or_else(PoisonError::into_inner);
        match reports.recv_timeout(GONE) {
            Ok(hello @ Report::Hello { version: VERSION, process, .. }) => {
                drop(reports);
                *client.home.lock().unwrap_or_else(PoisonError::into_inner) = Home::Found(process);
                Ok(Some(Self { pid: Some(process), first: Mutex::new(Some(hello)), ..client }))
            }
            _ => Err(Message::new("cell-already-runs").text("folder", folder.display().to_string())),
        }
    }

    fn connect(folder: &Path, home: Home) -> Result<Self, Message> {
        let stream = UnixStream::connect(sockets::panel(folder));
        stream.and_then(|stream| Self::over(stream, home)).map_err(|e| no_process(&e))
    }

    /// Talks over `stream`, in a thread for each direction.
    fn over(mut stream: UnixStream, home: Home) -> std::io::Result<Self> {
        let mut from = stream.try_clone()?;
        let (to_desk, reports) = sync_channel(REPORTS);
        let reads = move || {
            let mut inbox = Inbox::default();
            while matches!(inbox.read(&mut from), Ok(true)) {
                while let Ok(Some(report)) = inbox.next(MAX_REPORT) {
                    let ended = matches!(report, Report::Ended { .. });
                    if to_desk.send(report).is_err() {
                        return;
                    }
                    if ended {
                        // The cell waits for this end. It fails if the cell has gone already.
                        drop(from.shutdown(std::net::Shutdown::Both));
                        return;
                    }
                }
            }
        };
        let (requests, to_send) = sync_channel::<Vec<u8>>(REQUESTS);
        let writes = move || {
            let mut beat = Vec::new();
            // Its encoding never fails; without it the cell would only answer to the loss of a panel.
            drop(encode(&Request::Beat, &mut beat));
            loop {
                let next = match to_send.recv_timeout(BEAT) {
                    Ok(bytes) => bytes,
                    Err(RecvTimeoutError::Timeout) => beat.clone(),
                    Err(RecvTimeoutError::Disconnected) => break,
                };
                if stream.write_all(&next).is_err() {
                    return;
                }
            }
            // The last sender has gone: the reader ends with the connection.
            drop(stream.shutdown(std::net::Shutdown::Both));
        };
        let named = |name: &str| std::thread::Builder::new().name(name.into());
        named("from-cell").spawn(reads)?;
        named("to-cell").spawn(writes)?;
        let pid = if let Home::Process(child) = &home { Some(child.id()) } else { None };
        let (reports, home) = (Mutex::new(reports), Mutex::new(home));
        let first = Mutex::new(None);
        let client = Self { first, reports, requests, home, pid };
        client.send(&Request::Hello { version: VERSION });
        Ok(client)
    }

    /// Returns the number of the cell's process; `None` in threads of this one.
    pub fn process(&self) -> Option<u32> {
        self.pid
    }

    /// Sends a request. Returns false if the cell has gone, or has not read for so long that the request is dropped.
    pub fn send(&self, request: &Request) -> bool {
        let mut bytes = Vec::new();
        match encode(request, &mut bytes) {
            Ok(()) => match self.requests.try_send(bytes) {
                Ok(()) => true,
                Err(TrySendError::Full(_) | TrySendError::Disconnected(_)) => false,
            },
            Err(_) => false,
        }
    }

    /// Returns the first report of a cell that was found, until it is taken by [`CellClient::report`].
    pub fn first(&self) -> Option<Report> {
        self.first.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }

    /// Returns the next report, if one has come.
    ///
    /// # Errors
    /// The cell has gone; all its reports have been returned before.
    pub fn report(&self) -> Result<Option<Report>, CellLost> {
        if let Some(first) = self.first.lock().unwrap_or_else(PoisonError::into_inner).take() {
            return Ok(Some(first));
        }
        match self.reports.lock().unwrap_or_else(PoisonError::into_inner).try_recv() {
            Ok(report) => Ok(Some(report)),
            Err(TryRecvError::Empty) => Ok(None),
            Err(TryRecvError::Disconnected) => Err(CellLost),
        }
    }

    /// Kills a cell that does not answer, if it is a process of its own: its devices see the end of their connections.
    pub fn kill(&self) {
        match &mut *self.home.lock().unwrap_or_else(PoisonError::into_inner) {
            // Has no effect on a process that has already ended.
            Home::Process(child) => drop(child.kill()),
            Home::Found(process) => end_process(*process),
            Home::Threads(_) | Home::Gone => {}
        }
    }

    /// Waits until the cell has gone, and kills it if it does not go. Returns how it ended, if not in order.
    pub fn wait(&self) -> Option<Message> {
        match std::mem::replace(&mut *self.home.lock().unwrap_or_else(PoisonError::into_inner), Home::Gone) {
            Home::Gone => None,
            Home::Found(process) => {
                let begin = Instant::now();
                let runs = || Path::new("/proc").join(process.to_string()).exists();
                while runs() && begin.elapsed() < GONE {
                    std::thread::sleep(Duration::from_millis(2));
                }
                runs().then(|| {
                    end_process(process);
                    Message::new("cell-process-silent")
                })
            }
            Home::Threads(thread) => thread.join().is_err().then(|| Message::new("cell-program-panicked")),
            Home::Process(mut child) => {
                let begin = Instant::now();
                let status = loop {
                    match child.try_wait() {
                        Ok(Some(status)) => break Some(status),
                        Ok(None) if begin.elapsed() < GONE => std::thread::sleep(Duration::from_millis(2)),
                        _ => break None,
                    }
                };
                let Some(status) = status else {
                    drop(child.kill());
                    drop(child.wait());
                    return Some(Message::new("cell-process-silent"));
                };
                match (status.code(), status.signal()) {
                    (Some(0), _) => None,
                    (_, Some(signal)) => {
                        Some(Message::new("cell-process-signal").number("signal", f64::from(signal), 0))
                    }
                    (code, _) => {
                        Some(Message::new("cell-process-code").number("code", f64::from(code.unwrap_or(-1)), 0))
                    }
                }
            }
        }
    }
}

fn no_process(error: &std::io::Error) -> Message {
    Message::new("cell-no-process").message("why", Message::outside(error))
}

/// Kills a process by its number. It is that of a cell whose socket is still open, so it has not been given to another.
fn end_process(process: u32) {
    use rustix::process::{Pid, Signal, kill_process};
    if let Some(pid) = i32::try_from(process).ok().and_then(Pid::from_raw) {
        // Has no effect on a process that has already ended.
        let _ = kill_process(pid, Signal::KILL);
    }
}

/// Waits for the first line of a cell: `{"Ok":null}` or `{"Err":MESSAGE}`.
fn ready(mut from: BufReader<std::process::ChildStdout>) -> Result<(), Message> {
    let (to, came) = channel();
    let read = move || {
        let mut line = String::new();
        let count = from.read_line(&mut line);
        // Later lines are not read: a cell prints nothing else.
        drop(to.send(count.map(|_| line)));
    };
    std::thread::Builder::new().name("start-of-cell".into()).spawn(read).map_err(|e| Message::outside(&e))?;
    let ended = || Message::new("cell-process-ended-early");
    match came.recv_timeout(READY) {
        Ok(Ok(line)) => serde_json::from_str::<Result<(), Message>>(&line).unwrap_or_else(|_| Err(ended())),
        Ok(Err(_)) | Err(RecvTimeoutError::Disconnected) => Err(ended()),
        Err(RecvTimeoutError::Timeout) => Err(Message::new("cell-process-silent")),
    }
}
