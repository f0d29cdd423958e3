use super::{Disturbances, JointPositions, SimulatedControl};
use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::{Rng as _, SeedableRng as _};
use seamwright_executive::realtime::RealtimeRights;
use std::io::{ErrorKind, Read as _, Write as _};
use std::net::{SocketAddr, TcpListener, TcpStream, UdpSocket};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

/// Faults of the datagrams that a simulated control sends, as parts of them.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct PacketFaults {
    /// Lost.
    pub lost: f64,
    /// Sent twice.
    pub doubled: f64,
    /// Overtaken by the next one.
    pub overtaken: f64,
    /// Followed by bytes that are no message.
    pub garbage: f64,
}

/// Line of a simulated control to its client.
#[derive(Debug)]
enum Line {
    Tcp { listener: TcpListener, client: Option<TcpStream> },
    Udp { socket: UdpSocket, to: SocketAddr },
}

/// State shared with the thread.
struct Shared {
    control: Box<dyn SimulatedControl>,
    faults: PacketFaults,
    /// The client's connection is to be cut.
    cuts: bool,
}

/// A simulated control on a socket of this computer, in a thread of its own.
pub struct ControlServer {
    address: SocketAddr,
    shared: Arc<Mutex<Shared>>,
    ends: Arc<AtomicBool>,
    thread: Option<JoinHandle<()>>,
}

impl ControlServer {
    /// Starts a control that is a server of TCP, as RTDE is, on `address`.
    ///
    /// # Errors
    /// The address cannot be used.
    pub fn tcp(control: impl SimulatedControl + 'static, address: &str) -> std::io::Result<Self> {
        let listener = TcpListener::bind(address)?;
        listener.set_nonblocking(true)?;
        let address = listener.local_addr()?;
        Ok(Self::start(Box::new(control), address, Line::Tcp { listener, client: None }))
    }

    /// Starts a control that sends datagrams to `to`, as EGM and RSI do.
    ///
    /// # Errors
    /// No socket can be made.
    pub fn udp(control: impl SimulatedControl + 'static, to: SocketAddr) -> std::io::Result<Self> {
        let socket = UdpSocket::bind((if to.is_ipv4() { "127.0.0.1" } else { "::1" }, 0))?;
        socket.set_nonblocking(true)?;
        let address = socket.local_addr()?;
        Ok(Self::start(Box::new(control), address, Line::Udp { socket, to }))
    }

    fn start(control: Box<dyn SimulatedControl>, address: SocketAddr, line: Line) -> Self {
        let shared = Shared { control, faults: PacketFaults::default(), cuts: false };
        let shared = Arc::new(Mutex::new(shared));
        let ends = Arc::new(AtomicBool::new(false));
        let (its, stops) = (Arc::clone(&shared), Arc::clone(&ends));
        let thread = std::thread::spawn(move || run(line, &its, &stops));
        Self { address, shared, ends, thread: Some(thread) }
    }

    /// Its address.
    #[must_use]
    pub fn address(&self) -> SocketAddr {
        self.address
    }

    fn shared(&self) -> MutexGuard<'_, Shared> {
        self.shared.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Returns the positions of the joints, in the units of the protocol.
    #[must_use]
    pub fn positions(&self) -> JointPositions {
        *self.shared().control.arm().positions()
    }

    /// True while the arm follows set-points.
    #[must_use]
    pub fn follows(&self) -> bool {
        self.shared().control.follows()
    }

    /// Switches disturbances.
    pub fn disturb(&self, disturbances: Disturbances) {
        self.shared().control.disturb(disturbances);
    }

    /// Sets the faults of later datagrams.
    pub fn spoil(&self, faults: PacketFaults) {
        self.shared().faults = faults;
    }

    /// Cuts the connection, or starts the control's program again.
    pub fn cut(&self) {
        self.shared().cuts = true;
    }
}

impl Drop for ControlServer {
    fn drop(&mut self) {
        self.ends.store(true, Ordering::Release);
        if let Some(thread) = self.thread.take() {
            // A panic has reported itself.
            let _ = thread.join();
        }
    }
}

fn run(mut line: Line, shared: &Mutex<Shared>, ends: &AtomicBool) {
    // A control is never late; without the right this one is as late as any program.
    RealtimeRights::ask(None);
    let begun = Instant::now();
    let mut random = Pcg64Mcg::seed_from_u64(1);
    let mut held: Option<Vec<u8>> = None;
    let mut next_s = 0.0;
    let mut buffer = vec![0; 1 << 16];
    while !ends.load(Ordering::Acquire) {
        let now_s = begun.elapsed().as_secs_f64();
        let mut out = Vec::new();
        let mut locked = shared.lock().unwrap_or_else(PoisonError::into_inner);
        if std::mem::take(&mut locked.cuts) {
            if let Line::Tcp { client, .. } = &mut line {
                *client = None;
            }
            locked.control.connect();
        }
        if line.accept() {
            locked.control.connect();
        }
        while let Some(count) = line.receive(&mut buffer) {
            locked.control.take(&buffer[..count], now_s, &mut out);
        }
        let answers = out.len();
        let period_s = locked.control.period_s();
        if now_s >= next_s {
            // A thread that was late catches up with the grid.
            next_s = ((now_s / period_s).floor() + 1.0) * period_s;
            locked.control.tick((now_s / period_s).floor() * period_s, &mut out);
        }
        let faults = locked.faults;
        drop(locked);
        let reports = out.split_off(answers);
        out.iter().for_each(|message| line.send(message));
        for report in reports {
            let mut happens = |part: f64| (random.next_u64() >> 11) as f64 / (1u64 << 53) as f64 <= part - 1e-18;
            if happens(faults.lost) {
                continue;
            }
            if happens(faults.garbage) {
                line.send(b"\x0a\xff<Rob no message");
            }
            if happens(faults.overtaken) && held.is_none() {
                held = Some(report);
                continue;
            }
            line.send(&report);
            if happens(faults.doubled) {
                line.send(&report);
            }
            if let Some(late) = held.take() {
                line.send(&late);
            }
        }
        std::thread::sleep(Duration::from_micros(200));
    }
}

impl Line {
    /// Takes a new client.
    fn accept(&mut self) -> bool {
        let Self::Tcp { listener, client } = self else { return false };
        let Ok((stream, _)) = listener.accept() else { return false };
        let is_set = stream.set_nonblocking(true).is_ok() && stream.set_nodelay(true).is_ok();
        *client = is_set.then_some(stream);
        is_set
    }

    fn receive(&mut self, buffer: &mut [u8]) -> Option<usize> {
        match self {
            Self::Tcp { client, .. } => match client.as_mut()?.read(buffer) {
                Ok(0) => {
                    *client = None;
                    None
                }
                Ok(count) => Some(count),
                Err(error) if error.kind() == ErrorKind::WouldBlock => None,
                Err(_) => {
                    *client = None;
                    None
                }
            },
            Self::Udp { socket, .. } => socket.recv_from(buffer).ok().map(|(count, _)| count),
        }
    }

    /// Sends a message; it is lost without a client.
    fn send(&mut self, message: &[u8]) {
        match self {
            Self::Tcp { client: Some(stream), .. } => drop(stream.write_all(message)),
            Self::Tcp { .. } => {}
            Self::Udp { socket, to } => drop(socket.send_to(message, *to)),
        }
    }
}
