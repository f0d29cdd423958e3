//! A Modbus TCP device for tests: four tables, an optional welding source, and faults.

// Not every test needs all of it.
#![allow(dead_code)]

use std::collections::HashSet;
use std::future::Future;
use std::net::SocketAddr;
use std::pin::Pin;
use std::sync::atomic::{AtomicBool, AtomicU64, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, MutexGuard};
use std::thread::JoinHandle;
use std::time::Duration;
use tokio_modbus::server::Service;
use tokio_modbus::server::tcp::{Server, accept_tcp_connection};
use tokio_modbus::{ExceptionCode, Request, Response};

/// Tables of the device, and counts of its requests.
pub(crate) struct Bank {
    pub(crate) coils: Vec<bool>,
    pub(crate) discrete: Vec<bool>,
    pub(crate) holding: Vec<u16>,
    pub(crate) input: Vec<u16>,
    /// Missing registers (holding and input).
    pub(crate) holes: HashSet<u16>,
    /// Numbers of read and write requests so far.
    pub(crate) reads: usize,
    pub(crate) writes: usize,
    /// Behaviour of the device itself, run before each request.
    pub(crate) works: fn(&mut Bank),
}

/// A device that can be silenced, stopped and started again.
pub(crate) struct TestServer {
    pub(crate) address: SocketAddr,
    bank: Arc<Mutex<Bank>>,
    silent: Arc<AtomicBool>,
    /// Read requests stay unanswered, write requests do not.
    mute: Arc<AtomicBool>,
    /// Time before each answer, ms.
    slow: Arc<AtomicU64>,
    /// Number of connections so far, and those of them that are silent.
    connections: Arc<AtomicUsize>,
    deaf: Arc<AtomicUsize>,
    /// Accepts one connection at a time: others are closed at once.
    single: bool,
    running: Option<(Arc<AtomicBool>, JoinHandle<()>)>,
}

impl TestServer {
    /// Starts the server at a free port of this computer.
    pub(crate) fn new(works: fn(&mut Bank)) -> Self {
        let bank = Bank {
            coils: vec![false; 65536],
            discrete: vec![false; 65536],
            holding: vec![0; 65536],
            input: vec![0; 65536],
            holes: HashSet::new(),
            reads: 0,
            writes: 0,
            works,
        };
        let address = SocketAddr::from(([127, 0, 0, 1], 0));
        let (silent, mute) = (Arc::new(AtomicBool::new(false)), Arc::new(AtomicBool::new(false)));
        let (connections, deaf, slow) = (Arc::default(), Arc::default(), Arc::default());
        let bank = Arc::new(Mutex::new(bank));
        let mut server = Self { address, bank, silent, mute, slow, connections, deaf, single: false, running: None };
        server.start();
        server
    }

    /// Starts a server that accepts one connection at a time.
    pub(crate) fn single(works: fn(&mut Bank)) -> Self {
        let mut server = Self::new(works);
        server.stop();
        server.single = true;
        server.start();
        server
    }

    /// Accepts read requests without answering them; write requests are executed and answered.
    pub(crate) fn mute(&self, mute: bool) {
        self.mute.store(mute, Ordering::SeqCst);
    }

    pub(crate) fn bank(&self) -> MutexGuard<'_, Bank> {
        self.bank.lock().unwrap()
    }

    /// Accepts requests without ever answering them.
    pub(crate) fn silence(&self, silent: bool) {
        self.silent.store(silent, Ordering::SeqCst);
    }

    /// Answers each request this much later.
    pub(crate) fn answer_after(&self, delay: Duration) {
        self.slow.store(delay.as_millis() as u64, Ordering::SeqCst);
    }

    /// Accepts requests on the present connections without ever answering or executing them; others work.
    pub(crate) fn silence_present(&self) {
        self.deaf.store(self.connections.load(Ordering::SeqCst), Ordering::SeqCst);
    }

    /// Ends all connections and accepts none.
    pub(crate) fn stop(&mut self) {
        if let Some((stop, thread)) = self.running.take() {
            stop.store(true, Ordering::SeqCst);
            thread.join().unwrap();
        }
    }

    /// Accepts connections at the same port as before.
    pub(crate) fn start(&mut self) {
        let stop = Arc::new(AtomicBool::new(false));
        let listener = std::net::TcpListener::bind(self.address).unwrap();
        listener.set_nonblocking(true).unwrap();
        self.address = listener.local_addr().unwrap();
        let device = Device {
            bank: Arc::clone(&self.bank),
            silent: Arc::clone(&self.silent),
            mute: Arc::clone(&self.mute),
            slow: Arc::clone(&self.slow),
            deaf: Arc::clone(&self.deaf),
        };
        let connections = Arc::clone(&self.connections);
        let (single, open) = (self.single, Arc::new(()));
        let asked = Arc::clone(&stop);
        let thread = std::thread::spawn(move || {
            let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build().unwrap();
            // The connections' tasks end with the runtime.
            runtime.block_on(async {
                let server = Server::new(tokio::net::TcpListener::from_std(listener).unwrap());
                let connected = |stream: tokio::net::TcpStream, from| {
                    stream.set_nodelay(true).unwrap();
                    let device = device.clone();
                    // Held by a connection as long as it is open.
                    let free = !single || Arc::strong_count(&open) == 1;
                    let held = Arc::clone(&open);
                    let number = connections.fetch_add(1, Ordering::SeqCst);
                    async move {
                        accept_tcp_connection(stream, from, |_| {
                            Ok(free.then(|| Connected { device: device.clone(), number, _open: held.clone() }))
                        })
                    }
                };
                let asked = async move {
                    while !asked.load(Ordering::SeqCst) {
                        tokio::time::sleep(Duration::from_millis(2)).await;
                    }
                };
                server.serve_until(&connected, |_| {}, asked).await.unwrap();
            });
        });
        self.running = Some((stop, thread));
    }
}

impl Drop for TestServer {
    fn drop(&mut self) {
        self.stop();
    }
}

#[derive(Clone)]
struct Device {
    bank: Arc<Mutex<Bank>>,
    silent: Arc<AtomicBool>,
    mute: Arc<AtomicBool>,
    slow: Arc<AtomicU64>,
    deaf: Arc<AtomicUsize>,
}

/// A connection to it.
#[derive(Clone)]
struct Connected {
    device: Device,
    number: usize,
    _open: Arc<()>,
}

impl Service for Connected {
    type Request = Request<'static>;
    type Response = Response;
    type Exception = ExceptionCode;
    type Future = Pin<Box<dyn Future<Output = Result<Response, ExceptionCode>> + Send>>;

    fn call(&self, request: Self::Request) -> Self::Future {
        let Device { bank, silent, mute, slow, deaf } = &self.device;
        let is_deaf = self.number < deaf.load(Ordering::SeqCst);
        if is_deaf || silent.load(Ordering::SeqCst) || mute.load(Ordering::SeqCst) && !request.is_write() {
            return Box::pin(std::future::pending());
        }
        let answer = bank.lock().unwrap().answer(&request);
        match slow.load(Ordering::SeqCst) {
            0 => Box::pin(std::future::ready(answer)),
            ms => Box::pin(async move {
                tokio::time::sleep(Duration::from_millis(ms)).await;
                answer
            }),
        }
    }
}

impl Bank {
    fn answer(&mut self, request: &Request<'_>) -> Result<Response, ExceptionCode> {
        (self.works)(self);
        let answer = match *request {
            Request::ReadCoils(at, n) => Response::ReadCoils(cut(&self.coils, at, n)?.to_vec()),
            Request::ReadDiscreteInputs(at, n) => Response::ReadDiscreteInputs(cut(&self.discrete, at, n)?.to_vec()),
            Request::ReadHoldingRegisters(at, n) => {
                Response::ReadHoldingRegisters(self.registers(&self.holding, at, n)?)
            }
            Request::ReadInputRegisters(at, n) => Response::ReadInputRegisters(self.registers(&self.input, at, n)?),
            Request::WriteSingleCoil(at, on) => {
                self.coils[usize::from(at)] = on;
                Response::WriteSingleCoil(at, on)
            }
            Request::WriteMultipleCoils(at, ref bits) => {
                cut_mut(&mut self.coils, at, bits.len())?.copy_from_slice(bits);
                Response::WriteMultipleCoils(at, bits.len() as u16)
            }
            Request::WriteSingleRegister(at, word) => {
                self.registers(&self.holding, at, 1)?;
                self.holding[usize::from(at)] = word;
                Response::WriteSingleRegister(at, word)
            }
            Request::WriteMultipleRegisters(at, ref words) => {
                self.registers(&self.holding, at, words.len() as u16)?;
                cut_mut(&mut self.holding, at, words.len())?.copy_from_slice(words);
                Response::WriteMultipleRegisters(at, words.len() as u16)
            }
            _ => return Err(ExceptionCode::IllegalFunction),
        };
        if request.is_write() {
            self.writes += 1;
        } else {
            self.reads += 1;
        }
        (self.works)(self);
        Ok(answer)
    }

    fn registers(&self, table: &[u16], at: u16, n: u16) -> Result<Vec<u16>, ExceptionCode> {
        let cells = cut(table, at, n)?;
        let hole = (0..n).any(|k| self.holes.contains(&(at + k)));
        if hole { Err(ExceptionCode::IllegalDataAddress) } else { Ok(cells.to_vec()) }
    }
}

trait IsWrite {
    fn is_write(&self) -> bool;
}

impl IsWrite for Request<'_> {
    fn is_write(&self) -> bool {
        !matches!(
            self,
            Self::ReadCoils(..)
                | Self::ReadDiscreteInputs(..)
                | Self::ReadHoldingRegisters(..)
                | Self::ReadInputRegisters(..)
        )
    }
}

fn cut<T>(table: &[T], at: u16, n: u16) -> Result<&[T], ExceptionCode> {
    table.get(usize::from(at)..usize::from(at) + usize::from(n)).ok_or(ExceptionCode::IllegalDataAddress)
}

fn cut_mut<T>(table: &mut [T], at: u16, n: usize) -> Result<&mut [T], ExceptionCode> {
    table.get_mut(usize::from(at)..usize::from(at) + n).ok_or(ExceptionCode::IllegalDataAddress)
}
