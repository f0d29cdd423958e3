use seamwright_machine::{ModbusDevice, Place, Table};
use seamwright_message::{Message, Unit, display_by_message};
use std::borrow::Cow;
use std::fmt::Display;
use std::time::Duration;
use tokio::net::TcpStream;
use tokio::runtime::{Builder, Runtime};
use tokio_modbus::client::{Client as _, Context, tcp};
use tokio_modbus::{ExceptionCode, Request, Response, Slave};

/// Maximum time to open a connection.
const CONNECT: Duration = Duration::from_secs(1);

/// Reasons for a failed request.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Trouble {
    /// The device answers with a refusal; the connection stays open.
    Refused {
        /// The device's reason.
        code: ExceptionCode,
        /// The affected registers.
        what: Message,
    },
    /// The device answers, but its heart-beat stands still.
    Lifeless(Message),
    /// The connection is lost.
    Gone(Message),
}

impl Trouble {
    pub(super) fn message(&self) -> Message {
        match self {
            Self::Refused { code, what } => {
                Message::new("cell-modbus-refused").message("what", what.clone()).text("code", code.to_string())
            }
            Self::Lifeless(message) | Self::Gone(message) => message.clone(),
        }
    }

    /// A connection lost by an error of the system.
    fn gone(error: &impl Display) -> Self {
        Self::Gone(Message::outside(&error))
    }

    /// Adds the names of the affected registers to a refusal.
    pub(super) fn about(self, device: &ModbusDevice, registers: impl Iterator<Item = usize>) -> Self {
        let Self::Refused { code, what } = self else { return self };
        let names: Vec<&str> = registers.map(|i| device.registers[i].name.as_str()).collect();
        let what = Message::new("cell-modbus-named").message("registers", what).text("names", names.join(", "));
        Self::Refused { code, what }
    }
}

display_by_message!(Trouble);

/// Consecutive cells of a table: 16-bit registers or bits.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct CellRange {
    pub(super) table: Table,
    /// Address of the first cell.
    pub(super) at: u16,
    pub(super) count: u16,
}

impl CellRange {
    /// Returns the cells of a register.
    pub(super) fn of(place: &Place) -> Self {
        Self { table: place.table, at: place.at, count: place.cells() }
    }

    /// Returns the address after the last cell: in u32, because the last cell may be the last of the table.
    pub(super) fn end(&self) -> u32 {
        u32::from(self.at) + u32::from(self.count)
    }
}

/// Message with a time-out.
pub(super) fn within(code: &'static str, time: Duration) -> Message {
    Message::new(code).value("time", time.as_secs_f64(), Unit::S)
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
    Builder::new_current_thread().enable_io().enable_time().build().map_err(|e| Trouble::gone(&e))
}

impl Wire {
    /// Opens a connection.
    pub(super) async fn connect(device: &ModbusDevice) -> Result<Self, Trouble> {
        let gone = |e: std::io::Error| Trouble::gone(&e);
        let stream = tokio::time::timeout(CONNECT, TcpStream::connect(device.address.as_str())).await;
        let stream = stream.map_err(|_| Trouble::Gone(within("cell-modbus-no-connection", CONNECT)))?.map_err(gone)?;
        // Requests are small and sequential: send at once.
        stream.set_nodelay(true).map_err(gone)?;
        let context = tcp::attach_slave(stream, Slave(device.unit));
        Ok(Self { context, timeout: Duration::from_secs_f64(device.timeout_s) })
    }

    /// Reads a range into `cells`; a bit is 0 or 1.
    pub(super) async fn read(&mut self, range: CellRange, cells: &mut Vec<u16>) -> Result<(), Trouble> {
        let CellRange { table, at, count } = range;
        let request = match table {
            Table::Coil => Request::ReadCoils(at, count),
            Table::Discrete => Request::ReadDiscreteInputs(at, count),
            Table::Holding => Request::ReadHoldingRegisters(at, count),
            Table::Input => Request::ReadInputRegisters(at, count),
        };
        cells.clear();
        match self.call(request, range).await? {
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
        let message = Message::new("cell-modbus-cells").text("table", table.name()).number("at", f64::from(at), 0);
        Err(Trouble::Gone(message.count("asked", count.into()).count("answered", cells.len())))
    }

    /// Writes `cells` starting at `at`.
    pub(super) async fn write(&mut self, table: Table, at: u16, cells: &[u16]) -> Result<(), Trouble> {
        let request = match (table.has_bits(), cells) {
            (true, [bit]) => Request::WriteSingleCoil(at, *bit != 0),
            (true, bits) => Request::WriteMultipleCoils(at, bits.iter().map(|bit| *bit != 0).collect()),
            (false, [word]) => Request::WriteSingleRegister(at, *word),
            (false, words) => Request::WriteMultipleRegisters(at, Cow::Borrowed(words)),
        };
        self.call(request, CellRange { table, at, count: cells.len() as u16 }).await.map(drop)
    }

    /// Sends a request for the cells of `range`, and waits for its answer.
    async fn call(&mut self, request: Request<'_>, range: CellRange) -> Result<Response, Trouble> {
        let timeout = self.timeout;
        let answer = tokio::time::timeout(timeout, self.context.call(request)).await;
        match answer {
            Err(_) => Err(Trouble::Gone(within("cell-modbus-no-answer", timeout))),
            // The library has no error of its own for a closed connection.
            Ok(Err(e)) if e.to_string().contains("os error 0") => {
                Err(Trouble::Gone(Message::new("cell-modbus-closed")))
            }
            Ok(Err(e)) => Err(Trouble::gone(&e)),
            Ok(Ok(Err(code))) => Err(Trouble::Refused {
                code,
                what: Message::new("cell-modbus-registers")
                    .text("table", range.table.name())
                    .number("from", f64::from(range.at), 0)
                    .number("to", f64::from(range.end() - 1), 0),
            }),
            Ok(Ok(Ok(response))) => Ok(response),
        }
    }
}
