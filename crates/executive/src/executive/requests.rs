use seamwright_motion::jog;

/// Reasons for the return of [`super::Executive::serve`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum End {
    /// Everything is off.
    Quit,
    /// The caller must serve another program at once: nothing moves, but drives may have power and need orders.
    Load,
}

/// Accepted requests of the operator that the current activity follows.
#[derive(Debug)]
pub(super) struct Requests {
    pub(super) feed_override: f64,
    /// A held program is to move in reverse along its path, or to stop.
    pub(super) reverse: bool,
    pub(super) halt: bool,
    /// The axis that goes home alone; `None` for all axes.
    pub(super) homes_one: Option<usize>,
    /// The jog command of the enabling switch, received in this cycle.
    pub(super) jog: Option<jog::Command>,
    pub(super) end: Option<End>,
}

impl Default for Requests {
    fn default() -> Self {
        Self { feed_override: 1.0, reverse: false, halt: false, homes_one: None, jog: None, end: None }
    }
}
