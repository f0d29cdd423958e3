use super::image::Ordered;
use super::link::{Life, Line, Link};
use super::orders::OrderWriter;
use super::reports::{ReportReader, Stamped};
use super::wire::{Trouble, runtime};
use crate::devices::InputBits;
use crate::devices::traffic::TrafficLog;
use crate::executive::SourceReport;
use crate::realtime::RealtimeRights;
use seamwright_machine::ModbusDevice;
use seamwright_message::Message;
use std::sync::Arc;
use tokio::runtime::Runtime;
use triple_buffer::{Input, Output};

/// The client's side of the data shared with the cycle.
#[derive(Debug)]
pub(super) struct Ends {
    pub(super) orders: Output<Ordered>,
    pub(super) source: Input<Stamped<SourceReport>>,
    pub(super) inputs: Input<Stamped<InputBits>>,
    pub(super) life: Arc<Life>,
    pub(super) traffic: TrafficLog,
}

/// Modbus client in a thread of its own: orders on one connection, reports on another, so that orders never wait for
/// reports. On a device with only one connection they alternate, request by request.
#[derive(Debug)]
pub(super) struct Client {
    runtime: Runtime,
    link: Link,
    orders: OrderWriter,
    reports: ReportReader,
}

impl Client {
    /// Creates an unconnected client; `values` are the names of the job's process values.
    pub(super) fn new(device: &ModbusDevice, values: &[String], ends: Ends) -> Result<Self, Trouble> {
        let Ends { orders, source, inputs, life, traffic } = ends;
        let line = Line::default();
        let second = if device.connections > 1 { Line::default() } else { line.clone() };
        Ok(Self {
            runtime: runtime()?,
            link: Link::new(device, life, traffic),
            orders: OrderWriter::new(device, values, line, orders),
            reports: ReportReader::new(device, values, second, source, inputs),
        })
    }

    /// Connects, brings all outputs to their safe states, reads everything once. Errors: the trouble; the client is not
    /// connected then.
    pub(super) fn connect(&mut self) -> Result<(), Trouble> {
        let Self { runtime, link, orders, reports } = self;
        runtime.block_on(async {
            orders.connect(link).await?;
            let trouble = link.unordered.borrow().clone();
            trouble.map_or(Ok(()), Err)?;
            reports.connect(link).await.map_err(|trouble| match trouble {
                Trouble::Gone(why) if link.device.connections > 1 => {
                    Trouble::Gone(Message::new("cell-modbus-second-connection").message("why", why))
                }
                other => other,
            })
        })
    }

    /// Polls until the cell ends; leaves the outputs safe.
    pub(super) fn run(self) {
        RealtimeRights::ask_below_cycle();
        let Self { runtime, link, mut orders, mut reports } = self;
        runtime.block_on(async {
            tokio::select! {
                () = orders.run(&link) => {}
                // Reports run until the orders end.
                () = reports.run(&link) => {}
            }
            drop(reports);
            orders.end(&link).await;
        });
    }
}
