use seamwright_message::{Message, Unit, display_by_message};

/// Invalid tracking settings.
#[derive(Debug, Clone, PartialEq)]
pub enum Error {
    /// A value outside its allowed range.
    Value {
        /// Name of the setting.
        key: &'static str,
        /// Given value.
        value: f64,
        /// Description of the allowed range.
        allowed: Message,
    },
    /// Measurements arrive too late to be followed at this speed.
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

display_by_message!(Error);

impl Error {
    /// A value that must be finite and greater than 0.
    pub(crate) fn not_positive(key: &'static str, value: f64) -> Self {
        Self::Value { key, value, allowed: Message::new("document-positive-number") }
    }

    /// A value that must lie from `min` to `max`.
    pub(crate) fn not_between(key: &'static str, value: f64, [min, max]: [f64; 2]) -> Self {
        let allowed = Message::new("document-between").value("min", min, Unit::One).value("max", max, Unit::One);
        Self::Value { key, value, allowed }
    }

    /// Returns the description of the error.
    pub fn message(&self) -> Message {
        match *self {
            Self::Value { key, value, ref allowed } => Message::new("tracking-value")
                .key("key", key)
                .value("value", value, Unit::One)
                .message("allowed", allowed.clone()),
            Self::LeadTooShort { lead_mm, speed_mm_s, notice_s, lead_that_works_mm, speed_that_works_mm_s } => {
                Message::new("tracking-look-ahead-too-short")
                    .value("distance", lead_mm, Unit::Mm)
                    .value("speed", speed_mm_s, Unit::MmPerS)
                    .value("notice", notice_s, Unit::S)
                    .quantity("min", lead_that_works_mm, Unit::Mm, 1)
                    .quantity("max", speed_that_works_mm_s, Unit::MmPerS, 1)
            }
        }
    }
}
