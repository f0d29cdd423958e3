//! Audit log and alarms to a syslog receiver (RFC 5424), over UDP (RFC 5426) or TCP with octet counting (RFC 6587).
//!
//! A thread of its own sends. Callers only put a message into a bounded queue: neither network nor receiver delays the
//! cell. Messages that are not sent are counted and reported to operator and receiver.

mod message;
mod receiver;
mod sender;

pub use receiver::{InvalidReceiver, SyslogReceiver};
pub(crate) use sender::Syslog;
