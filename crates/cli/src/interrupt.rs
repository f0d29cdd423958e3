//! Ctrl-C in a search that has a result at any time.

use seamwright_project::failure::Failure;
use signal_hook::consts::SIGINT;
use signal_hook::flag;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

/// Exit code of a program that Ctrl-C has ended, as shells count it: 128 and the number of the signal.
const ENDED: i32 = 130;

/// Redirects Ctrl-C to the flag that is returned, for the rest of the process. A second Ctrl-C ends the program at once.
///
/// # Errors
/// If the system refuses.
pub(crate) fn on_ctrl_c() -> Result<Arc<AtomicBool>, Failure> {
    let flag = Arc::new(AtomicBool::new(false));
    // In this order: the first signal finds the flag down and raises it.
    flag::register_conditional_shutdown(SIGINT, ENDED, Arc::clone(&flag))?;
    flag::register(SIGINT, Arc::clone(&flag))?;
    Ok(flag)
}
