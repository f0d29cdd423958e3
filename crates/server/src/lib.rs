//! The operator's panel: HTTP, WebSocket, users, and the cell behind them.

mod cell;
mod connections;
mod http;
mod serve;
mod teaching;
#[cfg(test)]
mod tests;
mod tls;
mod users;
mod view;
pub mod wire;

pub use serve::{Error, Settings, serve};
pub use tls::Tls;
