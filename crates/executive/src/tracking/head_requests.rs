use seamwright_message::Message;
use seamwright_tracking::actuator::{Alarm, Cause, Lag};
use seamwright_tracking::beam::{Beam, Misfit};

/// One cycle of a head.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Step {
    /// Time, s.
    pub(crate) t: f64,
    /// Path length of the torch's set-point, mm.
    pub(crate) s: f64,
    /// Speed along the seam, mm/s.
    pub(crate) speed: f64,
    /// True while the arc or beam is on.
    pub(crate) welds: bool,
    /// The torch, which lags behind the set-point.
    pub(crate) lag: Lag,
}

/// Cause of an alarm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Why {
    Sensor(Cause),
    /// The stored deviations do not fit.
    Misfit(Misfit),
    /// The joint was not seen before the weld.
    NotSeen,
}

impl Why {
    pub(super) fn message(&self) -> Message {
        match self {
            Self::Sensor(cause) => cause.message(),
            Self::NotSeen => Message::new("cell-joint-not-seen"),
            Self::Misfit(misfit) => misfit.message(),
        }
    }
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct HeadRequests {
    /// Maximum feed override of the torch in the next cycle.
    pub(super) feed_override: f64,
    /// Most severe alarm, and its cause.
    pub(super) alarm: Option<(Alarm, Option<Why>)>,
    /// Order for the beam, and its deflection, mm.
    pub(super) beam: Beam,
    pub(super) deflection_mm: f64,
}

impl HeadRequests {
    pub(super) const NOTHING: Self = Self { feed_override: 1.0, alarm: None, beam: Beam::Weld, deflection_mm: 0.0 };
}
