//! Reports to the service manager (systemd), if it has started the panel. Errors are ignored: there may be
//! no manager.

use sd_notify::NotifyState;

/// The panel answers.
pub(crate) fn ready() {
    let _ = sd_notify::notify(&[NotifyState::Ready]);
}

/// The panel lives and the cell's cycles come: without this the manager starts both anew.
pub(crate) fn alive() {
    let _ = sd_notify::notify(&[NotifyState::Watchdog]);
}

/// The panel ends.
pub(crate) fn stopping() {
    let _ = sd_notify::notify(&[NotifyState::Stopping]);
}
