use super::image::Ordered;
use super::link::{Line, Link};
use super::orders::OrderWriter;
use super::reports::ReportReader;
use super::traffic::TrafficLog;
use super::wire::{Trouble, runtime};
use crate::devices::InputBits;
use crate::executive::SourceReport;
use crate::realtime::Footing;
use seamwright_machine::ModbusDevice;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64};
use std::time::Instant;
use tokio::runtime::Runtime;
use triple_buffer::{Input, Output};

/// Signs of life between the cycle and the client.
#[derive(Debug, Default)]
pub(super) struct Life {
    /// Cycles so far.
    pub(super) cycles: AtomicU64,
    /// Nobody needs the client any more.
    pub(super) ended: AtomicBool,
}

/// What was read, and when.
pub(super) type Stamped<T> = Option<(T, Instant)>;

/// The client's ends of what it shares with the cycle.
#[derive(Debug)]
pub(super) struct Ends {
    pub(super) orders: Output<Ordered>,
    pub(super) source: Input<Stamped<SourceReport>>,
    pub(super) inputs: Input<Stamped<InputBits>>,
    pub(super) life: Arc<Life>,
    pub(super) traffic: TrafficLog,
}

/// What talks to the device, in a thread of its own: orders on one connection and reports on another, so that an order never
/// waits for an answer to a question. On a device that takes one connection only they take turns, request by request.
#[derive(Debug)]
pub(super) struct Client {
    runtime: Runtime,
    link: Link,
    orders: OrderWriter,
    reports: ReportReader,
}

impl Client {
    /// Not connected yet; `values` are the names of the job's process values.
    pub(super) fn new(device: &ModbusDevice, values: &[String], ends: Ends) -> Result<Self, Trouble> {
        let Ends { orders, source, inputs, life, traffic } = ends;
        let line = Line::default();
        let second = if device.connections > 1 { Line::default() } else { line.clone() };
        Ok(Self {
            runtime: runtime()?,
            link: Link::new(device, life, traffic),
            orders: OrderWriter::new(device, values, (line, orders)),
            reports: ReportReader::new(device, values, (second, source, inputs)),
        })
    }

    /// Connects, brings all outputs to what they shall be, reads everything once.
    ///
    /// # Errors
    /// What went wrong; nothing is connected then.
    pub(super) fn connect(&mut self) -> Result<(), Trouble> {
        let Self { runtime, link, orders, reports } = self;
        runtime.block_on(async {
            orders.connect(link).await?;
            let trouble = link.unordered.borrow().clone();
            trouble.map_or(Ok(()), Err)?;
            let read = reports.connect(link).await;
            read.map_err(|trouble| match trouble {
                Trouble::Gone(why) if link.device.connections > 1 => {
                    Trouble::Gone(format!("{why}, on a second connection; if it takes one only: connections = 1"))
                }
                other => other,
            })
        })
    }

    /// Polls until nobody needs it any more; leaves the outputs safe.
    pub(super) fn run(self) {
        Footing::ask_below_cycle();
        let Self { runtime, link, mut orders, mut reports } = self;
        runtime.block_on(async {
            tokio::select! {
                () = orders.run(&link) => {}
                // It goes on until orders have come to their end.
                () = reports.run(&link) => {}
            }
            drop(reports);
            orders.end(&link).await;
        });
    }
}
