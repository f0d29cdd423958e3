//! The operator's panel: HTTP, WebSocket, users, and the cell behind them.
//!
//! - The cycle's thread gets programs (`Prepared`, built elsewhere) through one queue and returns them through another.
//! - The desk, a thread of its own, turns cycles and notes into status, events, records and the list of alarms, and
//!   passes commands on.
//! - Stops do not queue. Neither stops nor sockets share a thread with handlers: these run on another runtime. Work on
//!   files, library and plans runs on threads of lower priority (`http/turns.rs`).
//! - Plans from texts run in a process with limits of memory and time (`planner`).
//! - Every route states its permission in one table, which a test checks route by route.

mod cell;
mod front;
mod http;
mod lack;
mod log;
mod planner;
mod serve;
mod teaching;
#[cfg(test)]
mod tests;
mod tls;
mod users;
mod view;
pub mod wire;

pub use planner::answer_one_question;
pub use serve::{Error, Settings, serve};
pub use tls::Tls;
