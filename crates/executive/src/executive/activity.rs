use super::alarm_list::Place;
use super::clock::StopTimer;
use super::device_interface::{SeamOrders, VALUES};
use seamwright_motion::feed_override::RunPhase;

/// The current activity: a program, jogging, homing, or rest.
#[derive(Debug, Default)]
pub(super) struct Activity {
    /// A program or a jog has not come to rest.
    pub(super) busy: bool,
    /// The running or held program welds; false for a dry run.
    pub(super) welds: bool,
    /// Its state in this cycle.
    pub(super) doing: Doing,
    /// Position at which a program was left with the weld unfinished.
    pub(super) left: Option<Place>,
    /// Time since the fault that stops the running program.
    pub(super) fault: StopTimer,
}

/// State of the program in a cycle.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Doing {
    /// Arc or beam is requested.
    pub(super) asked: bool,
    pub(super) gas: bool,
    pub(super) values: [f64; VALUES],
    pub(super) phase: Option<RunPhase>,
    pub(super) place: Place,
    pub(super) speed: f64,
    pub(super) steady: bool,
    pub(super) welded_mm: f64,
    pub(super) seam: SeamOrders,
}
