//! The operator's panel: HTTP, WebSocket, users, and the cell behind them.

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
