use seamwright_message::{Message, Unit, display_by_message};

/// Invalid settings or records of beam mode.
#[derive(Debug, Clone, PartialEq)]
pub enum Error {
    /// An invalid value.
    Value(crate::lead::Error),
    /// Frames would interrupt the weld too often.
    TooOften {
        /// Frame period, s.
        period_s: f64,
        /// Minimum period that the weld allows, s.
        every_s: f64,
    },
    /// A frame would interrupt the weld for too long.
    TooLong {
        /// Duration of a frame, s.
        scan_s: f64,
        /// Maximum interruption that the weld allows, s.
        longest_s: f64,
    },
    /// The detection zone lies outside the frame.
    ZoneOutside {
        /// The speed, mm/s.
        speed_mm_s: f64,
        /// Start of the zone, mm ahead of the beam.
        from_mm: f64,
        /// End of the zone, mm ahead of the beam.
        to_mm: f64,
        /// End of the frame, mm ahead of the beam.
        reach_mm: f64,
        /// Minimum and maximum speed whose zone lies inside the frame, mm/s; `None` without such a speed.
        speeds_that_work: Option<[f64; 2]>,
    },
    /// A stored deviation that does not cover the pass.
    NotCovered {
        /// Start of the pass in stored path length, mm.
        from_mm: f64,
        /// End of the pass in stored path length, mm.
        to_mm: f64,
        /// Start of the stored range, mm.
        first_mm: f64,
        /// End of the stored range, mm.
        last_mm: f64,
    },
}

display_by_message!(Error);

impl From<crate::lead::Error> for Error {
    fn from(error: crate::lead::Error) -> Self {
        Self::Value(error)
    }
}

impl Error {
    /// Returns the description of the error.
    pub fn message(&self) -> Message {
        match *self {
            Self::Value(ref error) => error.message(),
            Self::TooOften { period_s, every_s } => Message::new("tracking-frames-too-often")
                .value("period", period_s, Unit::S)
                .value("min", every_s, Unit::S),
            Self::TooLong { scan_s, longest_s } => {
                Message::new("tracking-frame-too-long").value("scan", scan_s, Unit::S).value("max", longest_s, Unit::S)
            }
            Self::ZoneOutside { speed_mm_s, from_mm, to_mm, reach_mm, speeds_that_work } => {
                let works = speeds_that_work.is_some();
                let code = if works { "tracking-zone-outside" } else { "tracking-zone-outside-at-any-speed" };
                let message = Message::new(code)
                    .value("speed", speed_mm_s, Unit::MmPerS)
                    .quantity("from", from_mm, Unit::Mm, 1)
                    .quantity("to", to_mm, Unit::Mm, 1)
                    .quantity("reach", reach_mm, Unit::Mm, 1);
                let Some([slow, fast]) = speeds_that_work else { return message };
                message.quantity("min", slow, Unit::MmPerS, 1).quantity("max", fast, Unit::MmPerS, 1)
            }
            Self::NotCovered { from_mm, to_mm, first_mm, last_mm } => Message::new("tracking-pass-not-covered")
                .value("from", from_mm, Unit::Mm)
                .value("to", to_mm, Unit::Mm)
                .value("first", first_mm, Unit::Mm)
                .value("last", last_mm, Unit::Mm),
        }
    }
}
