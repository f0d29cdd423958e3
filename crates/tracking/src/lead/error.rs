/// Invalid tracking settings.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum Error {
    /// A value outside its allowed range.
    #[error("{key} = {value}: allowed is {allowed}")]
    Value {
        /// Name of the setting.
        key: &'static str,
        /// Given value.
        value: f64,
        /// Description of the allowed range.
        allowed: &'static str,
    },
    /// Measurements arrive too late to be followed at this speed.
    #[error(
        "a sensor {lead_mm} mm ahead is too near at {speed_mm_s} mm/s: a deviation must be known {notice_s} s before the torch \
         is there; allowed is a lead of {lead_that_works_mm:.1} mm or more, or {speed_that_works_mm_s:.1} mm/s or less"
    )]
    LeadTooShort {
        /// Look-ahead distance of the sensor, mm.
        lead_mm: f64,
        /// Requested maximum speed, mm/s.
        speed_mm_s: f64,
        /// Time from exposure to the start of the actuator's motion, s.
        notice_s: f64,
        /// Minimum look-ahead distance for this speed, mm.
        lead_that_works_mm: f64,
        /// Maximum speed for this look-ahead distance, mm/s.
        speed_that_works_mm_s: f64,
    },
}
