use glam::DVec2;
use serde::{Deserialize, Serialize};

/// Measurement of a look-ahead sensor.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Measurement {
    /// Exposure time on the cell's clock, s.
    pub exposed_s: f64,
    /// Joint position in the sensor's plane, lateral and height from its zero, mm. The slide carries the sensor.
    pub offset: DVec2,
    /// 0 to 1.
    pub confidence: f64,
}

/// Result of processing a measurement.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    /// Accepted.
    Taken,
    /// Outside the gate: used only if two more agree with it.
    Gated,
    /// Three gated measurements agree: the seam has jumped and the estimate restarts there.
    Restarted,
    /// Rejected.
    Refused(Refusal),
}

/// Reason for rejecting a measurement.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Refusal {
    /// Confidence outside 0 to 1, or not a number.
    Confidence,
    /// Confidence below the minimum.
    Faint,
    /// Offset outside the sensor's calibrated field, or not finite.
    OutOfField,
    /// Exposure too old: the sensor is late or its clock is behind.
    Late,
    /// Exposure too recent or in the future: the sensor's clock is wrong.
    Clock,
    /// Repeated identical value: the sensor has frozen.
    Frozen,
}
