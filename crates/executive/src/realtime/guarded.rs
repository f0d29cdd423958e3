use super::{Shutdown, ShutdownCause};
use crate::executive::{Devices, Orders, Reports};
use seamwright_message::{Message, display_by_message};
use std::panic::{AssertUnwindSafe, catch_unwind};

/// The cycle's thread panicked; its devices were ordered off.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct CyclePanicked;

impl CyclePanicked {
    /// Returns its message.
    pub fn message(&self) -> Message {
        Message::new("cell-cycle-failed")
    }
}

display_by_message!(CyclePanicked);

/// Runs cycles on `devices`. After a panic the devices get the orders of a cell that is off, and `shutdown` is
/// requested.
///
/// # Errors
/// [`CyclePanicked`].
pub fn guarded<D: Devices, T>(
    devices: &mut D,
    shutdown: &Shutdown,
    cycles: impl FnOnce(&mut D) -> T,
) -> Result<T, CyclePanicked> {
    let result = catch_unwind(AssertUnwindSafe(|| cycles(devices)));
    result.map_err(|_| {
        shutdown.request(ShutdownCause::Panic);
        let (orders, mut reports) = (Orders::default(), Reports::default());
        // If the devices themselves panic, only their drop remains: it leaves their outputs safe.
        let _ = catch_unwind(AssertUnwindSafe(|| devices.exchange(&orders, &mut reports)));
        CyclePanicked
    })
}
