/// A way to take the process off at a device when the cycle has stopped. It shares no locks with the cycle.
pub trait CutOff: Send {
    /// Orders the device's own thread to write the safe outputs and to stop the watchdog output; returns at once. The
    /// next exchange with [`Watchdog::late`](super::Watchdog::late) ends this order.
    fn order(&self);
    /// Returns true once that thread has written them.
    fn is_confirmed(&self) -> bool;
    /// Writes the safe outputs over a connection of its own, where the device allows that, within seconds. Returns true
    /// if the device has confirmed them.
    fn write(&self) -> bool;
}
