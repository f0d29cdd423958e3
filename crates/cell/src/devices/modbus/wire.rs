use seamwright_machine::{ModbusDevice, Table};
use std::borrow::Cow;
use std::time::Duration;
use tokio::net::TcpStream;
use tokio::runtime::{Builder, Runtime};
use tokio_modbus::client::{Client as _, Context, tcp};
use tokio_modbus::{ExceptionCode, Request, Response, Slave};

/// Maximum time to open a connection.
const CONNECT: Duration = Duration::from_secs(1);

/// Reasons for a failed request.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub(super) enum Trouble {
    /// The device answers with a refusal; the connection stays open.
    #[error("the device refuses {what} ({code})")]
    Refused {
        /// The device's reason.
        code: ExceptionCode,
        /// The affected registers.
        what: String,
    },
    /// The device answers, but its heart-beat stands still.
    #[error("{0}")]
    Lifeless(String),
    /// The connection is lost.
    #[error("{0}")]
    Gone(String),
}

impl Trouble {
    /// Adds the names of the affected registers to a refusal.
    pub(super) fn about(self, device: &ModbusDevice, registers: impl Iterator<Item = usize>) -> Self {
        let Self::Refused { code, what } = self else { return self };
        let names: Vec<&str> = registers.map(|i| device.registers[i].name.as_str()).collect();
        Self::Refused { code, what: format!("{what}: {}", names.join(", ")) }
    }
}

/// A connection to a device. Calls wait for the answer up to the device's time-out.
pub(super) struct Wire {
    context: Context,
    timeout: Duration,
}

impl std::fmt::Debug for Wire {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Wire").field("timeout", &self.timeout).finish_non_exhaustive()
    }
}

/// Creates the asynchronous runtime of one thread's connections.
pub(super) fn runtime() -> Result<Runtime, Trouble> {
    Builder::new_current_thread().enable_io().enable_time().build().map_err(|e| Trouble::Gone(e.to_string()))
}

impl Wire {
    /// Opens a connection.
    pub(super) async fn connect(device: &ModbusDevice) -> Result<Self, Trouble> {
        let gone = |e: std::io::Error| Trouble::Gone(e.to_string());
        let stream = tokio::time::timeout(CONNECT, TcpStream::connect(device.address.as_str())).await;
        let stream = stream.map_err(|_| Trouble::Gone("no connection within 1 s".to_owned()))?.map_err(gone)?;
        // Requests are small and sequential: send at once.
        stream.set_nodelay(true).map_err(gone)?;
        let context = tcp::attach_slave(stream, Slave(device.unit));
        Ok(Self { context, timeout: Duration::from_secs_f64(device.timeout_s) })
    }

    /// Reads `count` cells starting at `at` into `cells`; a bit is 0 or 1.
    pub(super) async fn read(
        &mut self,
        table: Table,
        at: u16,
        count: u16,
        cells: &mut Vec<u16>,
    ) -> Result<(), Trouble> {
        let request = match table {
            Table::Coil => Request::ReadCoils(at, count),
            Table::Discrete => Request::ReadDiscreteInputs(at, count),
            Table::Holding => Request::ReadHoldingRegisters(at, count),
            Table::Input => Request::ReadInputRegisters(at, count),
        };
        cells.clear();
        match self.call(request, (table, at, usize::from(count))).await? {
            // Bits come in whole bytes.
            Response::ReadCoils(bits) | Response::ReadDiscreteInputs(bits) => {
                cells.extend(bits.into_iter().take(usize::from(count)).map(u16::from));
            }
            Response::ReadHoldingRegisters(words) | Response::ReadInputRegisters(words) => cells.extend(words),
            _ => {}
        }
        if cells.len() == usize::from(count) {
            return Ok(());
        }
        Err(Trouble::Gone(format!("{} {at}: {count} cells asked for, {} answered", table.name(), cells.len())))
    }

    /// Writes `cells` starting at `at`.
    pub(super) async fn write(&mut self, table: Table, at: u16, cells: &[u16]) -> Result<(), Trouble> {
        let request = match (table.has_bits(), cells) {
            (true, [bit]) => Request::WriteSingleCoil(at, *bit != 0),
            (true, bits) => Request::WriteMultipleCoils(at, bits.iter().map(|bit| *bit != 0).collect()),
            (false, [word]) => Request::WriteSingleRegister(at, *word),
            (false, words) => Request::WriteMultipleRegisters(at, Cow::Borrowed(words)),
        };
        self.call(request, (table, at, cells.len())).await.map(drop)
    }

    async fn call(
        &mut self,
        request: Request<'_>,
        (table, at, count): (Table, u16, usize),
    ) -> Result<Response, Trouble> {
        let timeout = self.timeout;
        let answer = tokio::time::timeout(timeout, self.context.call(request)).await;
        match answer {
            Err(_) => Err(Trouble::Gone(format!("no answer within {} ms", timeout.as_millis()))),
            // The library has no error of its own for a closed connection.
            Ok(Err(e)) if e.to_string().contains("os error 0") => Err(Trouble::Gone("connection closed".to_owned())),
            Ok(Err(e)) => Err(Trouble::Gone(e.to_string())),
            Ok(Ok(Err(code))) => Err(Trouble::Refused {
                code,
                what: format!("{} {at} to {}", table.name(), usize::from(at) + count - 1),
            }),
            Ok(Ok(Ok(response))) => Ok(response),
        }
    }
}
