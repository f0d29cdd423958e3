use super::message::{Origin, formatted, not_sent};
use super::receiver::{SyslogReceiver, Transport};
use crate::cell::{Hub, happening};
use seamwright_message::Message;
use seamwright_record::library::PendingEntry;
use std::io::{self, ErrorKind, Read, Write};
use std::net::{SocketAddr, TcpStream, ToSocketAddrs, UdpSocket};
use std::sync::atomic::{AtomicBool, AtomicU64, AtomicUsize, Ordering};
use std::sync::mpsc::{Receiver, SyncSender, sync_channel};
use std::sync::{Arc, Weak};
use std::time::{Duration, Instant};

/// Maximum number of messages that wait, each of at most 2 KiB. Further ones are counted as not sent.
const MAX_WAITING: usize = 4096;
/// Maximum time to connect, and of a write.
const PATIENCE: Duration = Duration::from_secs(5);
/// Delay before the first new attempt; each further one doubles it.
const MIN_DELAY: Duration = Duration::from_millis(500);
const MAX_DELAY: Duration = Duration::from_secs(30);
/// Interval of the events about an unreachable receiver.
const REMIND: Duration = Duration::from_secs(60);
/// Time without an error after which a receiver counts as reached: UDP reports only the message after a lost one.
const CALM: Duration = Duration::from_secs(2);
/// Maximum wait for the receiver at the end of the program.
const LAST_WORDS: Duration = Duration::from_secs(1);
/// Polling period of the end of the program.
const LOOK: Duration = Duration::from_millis(20);

/// Sends entries to a receiver, in a thread of its own.
pub(crate) struct Syslog {
    to: SyncSender<Vec<u8>>,
    origin: Origin,
    state: Arc<State>,
}

#[derive(Default)]
struct State {
    /// Number of messages in the queue or being sent.
    waiting: AtomicUsize,
    /// Number of messages not sent since this was last reported.
    not_sent: AtomicU64,
    fails: AtomicBool,
    ends: AtomicBool,
}

impl Drop for Syslog {
    fn drop(&mut self) {
        self.state.ends.store(true, Ordering::Relaxed);
    }
}

impl Syslog {
    /// Starts the thread. Its events go to `hub`.
    pub(crate) fn start(receiver: SyslogReceiver, hub: &Arc<Hub>) -> Self {
        let (to, from) = sync_channel(MAX_WAITING);
        let (origin, state) = (Origin::here(), Arc::new(State::default()));
        let sender = Sender {
            receiver,
            hub: Arc::downgrade(hub),
            state: Arc::clone(&state),
            origin: origin.clone(),
            connection: None,
            failed: None,
            told: None,
        };
        std::thread::spawn(move || sender.run(&from));
        Self { to, origin, state }
    }

    /// Sends an entry later. Never waits.
    pub(crate) fn send(&self, entry: &PendingEntry) {
        let State { waiting, not_sent, .. } = &*self.state;
        waiting.fetch_add(1, Ordering::Relaxed);
        if self.to.try_send(formatted(entry, &self.origin)).is_err() {
            waiting.fetch_sub(1, Ordering::Relaxed);
            not_sent.fetch_add(1, Ordering::Relaxed);
        }
    }

    /// Waits a moment until everything is sent, at the end of the program; not for an unreachable receiver.
    pub(crate) fn flush(&self) {
        let begun = Instant::now();
        let is_busy = || self.state.waiting.load(Ordering::Relaxed) > 0 && !self.state.fails.load(Ordering::Relaxed);
        while is_busy() && begun.elapsed() < LAST_WORDS {
            std::thread::sleep(LOOK);
        }
    }
}

enum Connection {
    Udp(UdpSocket),
    Tcp(TcpStream),
}

impl Connection {
    fn open(receiver: &SyslogReceiver) -> io::Result<Self> {
        let mut last = io::Error::from(ErrorKind::NotFound);
        for address in (receiver.host.as_str(), receiver.port).to_socket_addrs()? {
            match Self::to(receiver.transport, address) {
                Ok(connection) => return Ok(connection),
                Err(e) => last = e,
            }
        }
        Err(last)
    }

    fn to(transport: Transport, address: SocketAddr) -> io::Result<Self> {
        match transport {
            Transport::Udp => {
                let any: SocketAddr = if address.is_ipv4() { ([0; 4], 0).into() } else { ([0; 16], 0).into() };
                let socket = UdpSocket::bind(any)?;
                socket.connect(address)?;
                Ok(Self::Udp(socket))
            }
            Transport::Tcp => {
                let stream = TcpStream::connect_timeout(&address, PATIENCE)?;
                stream.set_nodelay(true)?;
                stream.set_write_timeout(Some(PATIENCE))?;
                Ok(Self::Tcp(stream))
            }
        }
    }

    fn send(&mut self, message: &[u8]) -> io::Result<()> {
        match self {
            Self::Udp(socket) => socket.send(message).map(drop),
            Self::Tcp(stream) => {
                still_open(stream)?;
                // Octet counting: newlines end nothing.
                let mut frame = format!("{} ", message.len()).into_bytes();
                frame.extend_from_slice(message);
                stream.write_all(&frame)
            }
        }
    }
}

/// Fails if the receiver has closed the connection, which a write does not notice.
fn still_open(stream: &mut TcpStream) -> io::Result<()> {
    stream.set_nonblocking(true)?;
    let read = stream.read(&mut [0; 64]);
    stream.set_nonblocking(false)?;
    match read {
        Ok(0) => Err(ErrorKind::ConnectionAborted.into()),
        Err(e) if e.kind() != ErrorKind::WouldBlock => Err(e),
        // A receiver has nothing to say; it is ignored.
        Ok(_) | Err(_) => Ok(()),
    }
}

struct Sender {
    receiver: SyslogReceiver,
    hub: Weak<Hub>,
    state: Arc<State>,
    origin: Origin,
    connection: Option<Connection>,
    /// Time of the last error, since the receiver was last reached.
    failed: Option<Instant>,
    /// Time of the last event about an error.
    told: Option<Instant>,
}

impl Sender {
    fn run(mut self, from: &Receiver<Vec<u8>>) {
        for message in from {
            self.send(&message);
            self.state.waiting.fetch_sub(1, Ordering::Relaxed);
        }
    }

    /// Sends a message, again and again until it succeeds or the program ends.
    fn send(&mut self, message: &[u8]) {
        let mut delay = MIN_DELAY;
        loop {
            match self.attempt(message) {
                Ok(()) => return self.works(),
                Err(e) => self.fails(&e),
            }
            let begun = Instant::now();
            while begun.elapsed() < delay {
                if self.state.ends.load(Ordering::Relaxed) {
                    return;
                }
                std::thread::sleep(LOOK);
            }
            delay = (2 * delay).min(MAX_DELAY);
        }
    }

    fn attempt(&mut self, message: &[u8]) -> io::Result<()> {
        let mut connection = match self.connection.take() {
            Some(connection) => connection,
            None => Connection::open(&self.receiver)?,
        };
        // After an error the connection is opened anew.
        connection.send(message)?;
        self.connection = Some(connection);
        Ok(())
    }

    fn fails(&mut self, e: &io::Error) {
        self.state.fails.store(true, Ordering::Relaxed);
        self.failed = Some(Instant::now());
        if matches!(self.receiver.transport, Transport::Udp) {
            // The error is about the message before.
            self.state.not_sent.fetch_add(1, Ordering::Relaxed);
        }
        if self.told.is_none_or(|told| told.elapsed() >= REMIND) {
            self.told = Some(Instant::now());
            let waiting = self.state.waiting.load(Ordering::Relaxed);
            let message = Message::new("server-event-syslog-fails").text("receiver", self.receiver.to_string());
            self.event(message.message("reason", Message::outside(e)).count("n", waiting));
        }
    }

    fn works(&mut self) {
        let is_calm = match self.receiver.transport {
            Transport::Udp => self.failed.is_none_or(|failed| failed.elapsed() >= CALM),
            Transport::Tcp => true,
        };
        if !is_calm {
            return;
        }
        self.state.fails.store(false, Ordering::Relaxed);
        let lost = self.state.not_sent.swap(0, Ordering::Relaxed);
        if lost > 0 && self.attempt(&not_sent(lost, &self.origin)).is_err() {
            self.state.not_sent.fetch_add(lost, Ordering::Relaxed);
            return;
        }
        if self.failed.take().is_some() || lost > 0 {
            self.told = None;
            let message = Message::new("server-event-syslog-sends").text("receiver", self.receiver.to_string());
            self.event(message.count("n", lost as usize));
        }
    }

    fn event(&self, message: Message) {
        if let Some(hub) = self.hub.upgrade() {
            hub.event(hub.latest().map_or(0.0, |status| status.t), happening(message));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::message::grammar::{Parsed, parse};
    use super::*;
    use seamwright_record::Moment;
    use seamwright_record::library::AuditEntry;
    use std::net::TcpListener;

    /// Maximum wait of a test.
    const LONG: Duration = Duration::from_secs(60);

    fn order(n: usize) -> PendingEntry {
        let text = |t: &str| t.to_owned();
        let command = format!("order {n} \n]\"\\");
        let (user, station, old, new, result) = (text("ada"), text("panel"), text(""), text(""), text("accepted"));
        PendingEntry::Audit(AuditEntry { at: Moment::now(), user, station, command, old, new, result })
    }

    fn receiver(scheme: &str, port: u16) -> SyslogReceiver {
        format!("{scheme}://127.0.0.1:{port}").parse().unwrap()
    }

    /// Number of the order in a message.
    fn number(parsed: &Parsed) -> usize {
        parsed.words.split(' ').nth(3).unwrap().parse().unwrap()
    }

    /// Next message by octet counting; `None` at the end of the connection.
    fn frame(stream: &mut TcpStream) -> Option<Vec<u8>> {
        let mut length = 0;
        loop {
            let mut byte = [0];
            stream.read_exact(&mut byte).ok()?;
            match byte[0] {
                b' ' => break,
                digit => length = 10 * length + usize::from(digit.checked_sub(b'0').filter(|d| *d < 10).unwrap()),
            }
        }
        let mut message = vec![0; length];
        stream.read_exact(&mut message).ok()?;
        Some(message)
    }

    /// Waits for an event of this code.
    fn wait_for(hub: &Hub, key: &str) {
        let begun = Instant::now();
        loop {
            let (station, mut from, _) = hub.connect("ada", crate::wire::Role::Operator).unwrap();
            while let Ok(text) = from.try_recv() {
                if text.contains(&format!("\"key\":\"{key}\"")) {
                    return hub.disconnect(station);
                }
            }
            hub.disconnect(station);
            assert!(begun.elapsed() < LONG, "{key}");
            std::thread::sleep(LOOK);
        }
    }

    #[test]
    fn messages_arrive_by_udp() {
        let socket = UdpSocket::bind("127.0.0.1:0").unwrap();
        socket.set_read_timeout(Some(LONG)).unwrap();
        let syslog = Syslog::start(receiver("udp", socket.local_addr().unwrap().port()), &Arc::default());
        for n in 0..50 {
            syslog.send(&order(n));
            let mut bytes = [0; 4096];
            let length = socket.recv(&mut bytes).unwrap();
            assert_eq!(number(&parse(&bytes[..length]).unwrap()), n);
        }
        syslog.flush();
    }

    /// The receiver closes the connection between two messages: the next one arrives over a new connection.
    #[test]
    fn messages_arrive_by_tcp_after_a_new_connection_too() {
        let listener = TcpListener::bind("127.0.0.1:0").unwrap();
        let syslog = Syslog::start(receiver("tcp", listener.local_addr().unwrap().port()), &Arc::default());
        for connection in 0..3 {
            (0..20).for_each(|n| syslog.send(&order(20 * connection + n)));
            let (mut stream, _) = listener.accept().unwrap();
            stream.set_read_timeout(Some(LONG)).unwrap();
            for n in 0..20 {
                let message = frame(&mut stream).unwrap();
                assert_eq!(number(&parse(&message).unwrap()), 20 * connection + n);
            }
        }
    }

    /// An unreachable receiver delays no caller; messages without room are counted and reported to operator and receiver.
    #[test]
    fn nobody_waits_for_a_receiver_and_what_is_not_sent_is_counted() {
        let listener = TcpListener::bind("127.0.0.1:0").unwrap();
        let address = listener.local_addr().unwrap();
        drop(listener);
        let hub = Arc::new(Hub::default());
        let syslog = Syslog::start(receiver("tcp", address.port()), &hub);
        let all = MAX_WAITING + 500;
        let begun = Instant::now();
        (0..all).for_each(|n| syslog.send(&order(n)));
        assert!(begun.elapsed() < LONG / 2);
        wait_for(&hub, "syslog_fails");
        syslog.flush();
        let listener = TcpListener::bind(address).unwrap();
        let (mut stream, _) = listener.accept().unwrap();
        stream.set_read_timeout(Some(LONG)).unwrap();
        let (mut arrived, mut counted, mut next) = (0, None, 0);
        while counted.is_none() || arrived + counted.unwrap_or(0) < all {
            let parsed = parse(&frame(&mut stream).unwrap()).unwrap();
            match parsed.kind.as_str() {
                "NOT-SENT" => counted = Some(parsed.data["not_sent"]["count"].parse::<usize>().unwrap()),
                _ => {
                    // In their order; the sender may have made room for one after others were refused.
                    assert!(number(&parsed) >= next);
                    (arrived, next) = (arrived + 1, number(&parsed) + 1);
                }
            }
        }
        assert!(arrived >= MAX_WAITING && arrived + counted.unwrap() == all, "{arrived} {counted:?}");
        wait_for(&hub, "syslog_sends");
    }

    #[test]
    fn a_name_that_does_not_exist_is_told() {
        let hub = Arc::new(Hub::default());
        let syslog = Syslog::start("udp://no-such-host.invalid".parse().unwrap(), &hub);
        syslog.send(&order(0));
        wait_for(&hub, "syslog_fails");
    }
}
