//! The cycle in real time: a fixed period, what the system grants to it, and how late it was.
//!
//! Stated degraded mode: where the system grants no priority, no locked memory or no CPU of its own the cycle runs all the
//! same, [`Footing`] says what is missing, and [`Latency`] what it costs. More cycles missed at once than the drives ride out stop the cell.

mod footing;
mod guarded;
mod latency;
mod live;
mod pacer;
mod shutdown;

pub use footing::Footing;
pub use guarded::{CyclePanicked, guarded};
pub use latency::Latency;
pub use live::{LivePort, Noted, Outside, Shown, Urgent, live};
pub use pacer::{Paced, Pacer};
pub use shutdown::{Shutdown, ShutdownCause, contained};
