//! The operator's panel: HTTP, WebSocket, users, and the cell behind them.
//!
//! [`serve()`] starts the cell of [`Settings`] and serves its panel until a signal ends it. [`wire`] has the messages
//! in both directions; the panel's types are generated from them. [`Tls`] encrypts the connections.
//!
//! - The cell is a process of its own (`seamwright_cell`), which is watched and replaced if it dies (`cell/supervisor.rs`).
//! - The desk, a thread of its own, turns its cycles and notes into status, events, records and the list of alarms, and
//!   passes commands on.
//! - Stops do not queue. Neither stops nor sockets share a thread with handlers: these run on another runtime. Work on
//!   files, library and plans runs on threads of lower priority (`http/work_limit.rs`).
//! - Plans from texts run in a process with limits of memory and time (`planner`).
//! - Forms of texts are made from the JSON Schemas of their formats (`form`); the panel knows no keys.
//! - Every route states its permission in one table, which a test checks route by route.
//!
//! # Examples
//!
//! Serve a cell until a signal ends it:
//!
//! ```no_run
//! use seamwright_cell::MachineSource;
//! use seamwright_machine::shipped;
//! use seamwright_server::{Settings, serve};
//!
//! let file = shipped("saddle-4axis").expect("a shipped machine");
//! let settings = Settings {
//!     bind: ([127, 0, 0, 1], 8080).into(),
//!     names: Vec::new(),
//!     tls: None,
//!     data: "data".into(),
//!     machine: MachineSource { name: file.name.to_owned(), text: file.text.to_owned(), folder: ".".into() },
//!     values: Vec::new(),
//!     cameras: Vec::new(),
//!     program: None,
//!     monitor_token: None,
//!     job: Some("first-weld".to_owned()),
//!     syslog: None,
//! };
//! serve(&settings, |address| println!("Open {address}"))?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod cell;
mod diagnostics;
mod document_kind;
mod error;
mod form;
mod front;
mod http;
mod limits;
mod planner;
mod refusal;
mod serve;
mod service_manager;
mod syslog;
mod teaching;
#[cfg(test)]
mod tests;
mod tls;
mod users;
mod view;
pub mod wire;

pub use error::Error;
#[doc(hidden)]
pub use http::fuzzing;
pub use http::{openapi, panel_packages, typescript};
pub use planner::answer_one_question;
pub use serve::{Settings, serve};
pub use syslog::{InvalidReceiver, SyslogReceiver};
pub use tls::Tls;
