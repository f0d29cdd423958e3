/// Settings that cannot work.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum Error {
    /// A value outside of what is allowed.
    #[error("{key} = {value}: allowed is {allowed}")]
    Value {
        /// Which one.
        key: &'static str,
        /// What was given.
        value: f64,
        /// What may be.
        allowed: &'static str,
    },
    /// What is seen arrives too late to be followed at this speed.
    #[error(
        "a sensor {lead_mm} mm ahead is too near at {speed_mm_s} mm/s: a deviation must be known {notice_s} s before the torch \
         is there; allowed is a lead of {lead_that_works_mm:.1} mm or more, or {speed_that_works_mm_s:.1} mm/s or less"
    )]
    LeadTooShort {
        /// The sensor's lead.
        lead_mm: f64,
        /// The greatest speed asked for.
        speed_mm_s: f64,
        /// From exposure to the time at which the actuator must begin to move.
        notice_s: f64,
        /// Lead that suits the speed.
        lead_that_works_mm: f64,
        /// Speed that suits the lead.
        speed_that_works_mm_s: f64,
    },
}
