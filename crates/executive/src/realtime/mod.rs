//! The cycle in real time: a fixed period, the resources granted by the system, and the lateness.
//!
//! Degraded mode: without priority, locked memory or a CPU of its own the cycle runs all the same. [`RealtimeRights`] reports
//! the missing resources, and [`Latency`] their cost. More consecutive missed cycles than the drives tolerate stop the
//! cell.
//!
//! Time is that of [`SteadyTime`]. [`Paced`] judges the gaps in the cycle, and its supervisor, a thread of its own,
//! takes the process off while a gap lasts.

mod clock;
mod cycle_supervisor;
mod guarded;
mod latency;
mod live;
mod pacer;
mod rights;
mod shutdown;

pub use clock::{ManualTime, SteadyTime, SystemTime, TimeSource};
pub use guarded::{CyclePanicked, guarded};
pub use latency::Latency;
pub use live::{LivePort, Noted, Outside, QueueFill, Shown, Urgent, UrgentRequest, live};
pub use pacer::{Paced, Pacer};
pub use rights::RealtimeRights;
pub use shutdown::{Shutdown, ShutdownCause, contained};
