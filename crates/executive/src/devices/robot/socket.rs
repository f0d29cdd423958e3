use super::RobotFault;
use seamwright_machine::{Listening, RobotProtocolKind};
use seamwright_message::Message;
use std::io::{ErrorKind, Read as _, Write as _};
use std::net::{IpAddr, SocketAddr, TcpStream, ToSocketAddrs as _, UdpSocket};
use std::time::Duration;

/// Maximum time to connect.
const CONNECT: Duration = Duration::from_secs(1);
/// Maximum time for which a read or a write waits.
const WAIT: Duration = Duration::from_millis(5);

/// Connection with a control.
#[derive(Debug)]
pub(super) enum Socket {
    /// A stream to the control.
    Stream(TcpStream),
    /// Datagrams from the control, and the sender of the last one.
    Datagrams { socket: UdpSocket, from: Option<IpAddr>, sender: Option<SocketAddr> },
}

/// Result of waiting for data.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Received {
    Nothing,
    Bytes(usize),
}

impl Socket {
    /// Connects to the control, or listens for it.
    pub(super) fn open(protocol: &RobotProtocolKind) -> Result<Self, RobotFault> {
        match protocol {
            RobotProtocolKind::Rtde { address } => connect(address).map(Self::Stream),
            RobotProtocolKind::Egm(listening) | RobotProtocolKind::Rsi(listening) => listen(listening),
        }
    }

    pub(super) fn is_stream(&self) -> bool {
        matches!(self, Self::Stream(_))
    }

    /// Waits up to [`WAIT`] for data.
    pub(super) fn receive(&mut self, buffer: &mut [u8]) -> Result<Received, RobotFault> {
        let received = match self {
            Self::Stream(stream) => match stream.read(buffer) {
                Ok(0) => return Err(RobotFault::Closed),
                other => other,
            },
            Self::Datagrams { socket, from, sender } => socket.recv_from(buffer).map(|(count, by)| {
                if from.is_some_and(|from| from != by.ip()) {
                    return 0;
                }
                *sender = Some(by);
                count
            }),
        };
        match received {
            Ok(0) => Ok(Received::Nothing),
            Ok(count) => Ok(Received::Bytes(count)),
            // A refused datagram of ours shows up here, while the control does not listen yet.
            Err(error) if is_passing(error.kind()) => Ok(Received::Nothing),
            Err(error) if error.kind() == ErrorKind::ConnectionRefused && !self.is_stream() => Ok(Received::Nothing),
            Err(error) => Err(RobotFault::Lost(Message::outside(&error))),
        }
    }

    /// Sends bytes to the control, if there are any.
    pub(super) fn send(&mut self, bytes: &[u8]) -> Result<(), RobotFault> {
        if bytes.is_empty() {
            return Ok(());
        }
        let sent = match self {
            Self::Stream(stream) => stream.write_all(bytes),
            Self::Datagrams { socket, sender: Some(sender), .. } => match socket.send_to(bytes, *sender) {
                // The control counts what is missing.
                Err(error) if is_passing(error.kind()) || error.kind() == ErrorKind::ConnectionRefused => Ok(()),
                other => other.map(drop),
            },
            Self::Datagrams { .. } => Ok(()),
        };
        sent.map_err(|error| RobotFault::Lost(Message::outside(&error)))
    }
}

fn is_passing(kind: ErrorKind) -> bool {
    matches!(kind, ErrorKind::WouldBlock | ErrorKind::TimedOut | ErrorKind::Interrupted)
}

fn connect(address: &str) -> Result<TcpStream, RobotFault> {
    let unreachable = |error: std::io::Error| RobotFault::Unreachable(Message::outside(&error));
    let mut last = None;
    for address in address.to_socket_addrs().map_err(unreachable)? {
        match TcpStream::connect_timeout(&address, CONNECT) {
            Ok(stream) => {
                stream.set_nodelay(true).map_err(unreachable)?;
                stream.set_read_timeout(Some(WAIT)).map_err(unreachable)?;
                stream.set_write_timeout(Some(WAIT)).map_err(unreachable)?;
                return Ok(stream);
            }
            Err(error) => last = Some(error),
        }
    }
    Err(unreachable(last.unwrap_or_else(|| ErrorKind::NotFound.into())))
}

fn listen(listening: &Listening) -> Result<Socket, RobotFault> {
    let socket = UdpSocket::bind(listening.on).map_err(|error| match error.kind() {
        ErrorKind::AddrInUse => RobotFault::PortInUse,
        _ => RobotFault::NotListening(Message::outside(&error)),
    })?;
    socket.set_read_timeout(Some(WAIT)).map_err(|error| RobotFault::NotListening(Message::outside(&error)))?;
    socket.set_write_timeout(Some(WAIT)).map_err(|error| RobotFault::NotListening(Message::outside(&error)))?;
    Ok(Socket::Datagrams { socket, from: listening.from, sender: None })
}
