use glam::DVec2;

/// What a leading sensor measured.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Measurement {
    /// When it was exposed, s, on the cell's clock.
    pub exposed_s: f64,
    /// Where the joint lies in the sensor's plane, lateral and height from its zero, mm. The sensor rides on the slide.
    pub offset: DVec2,
    /// 0 to 1.
    pub confidence: f64,
}

/// What became of a measurement.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Verdict {
    /// It is used.
    Taken,
    /// Too far from what is expected: not used, unless two more agree with it.
    Gated,
    /// Three that agree with each other were gated: the seam has jumped, the estimate begins anew there.
    Restarted,
    /// It is not used.
    Refused(Refusal),
}

/// Why a measurement is not used at all.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Refusal {
    /// Its confidence is not a number from 0 to 1.
    Confidence,
    /// Too little confidence.
    Faint,
    /// Outside of the sensor's calibrated field, or no number.
    OutOfField,
    /// Its exposure is longer ago than it may be: the sensor is late, or its clock is behind.
    Late,
    /// Its exposure is too short a time ago, or in the future: the sensor's clock is wrong.
    Clock,
    /// The same value again and again: the sensor has frozen.
    Frozen,
}
