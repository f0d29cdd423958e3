//! The operator's panel: HTTP, WebSocket, users, and the cell behind them.
//!
//! [`serve()`] starts the cell of [`Settings`] and serves its panel until a signal ends it. [`wire`] has the messages
//! in both directions; the panel's types are generated from them. [`Tls`] encrypts the connections.
//!
//! ```no_run
//! use seamwright_machine::{Machine, shipped};
//! use seamwright_server::{Settings, serve};
//!
//! let file = shipped("saddle-4axis").expect("a shipped machine");
//! let settings = Settings {
//!     bind: ([127, 0, 0, 1], 8080).into(),
//!     names: Vec::new(),
//!     tls: None,
//!     data: "data".into(),
//!     machine: Machine::read(file.name, file.text)?,
//!     folder: ".".into(),
//!     values: Vec::new(),
//!     cameras: Vec::new(),
//!     program: None,
//!     job: Some("first-weld".to_owned()),
//! };
//! serve(&settings, |address| println!("Open {address}"))?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

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
