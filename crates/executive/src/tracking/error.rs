use seamwright_message::{Message, Unit, display_by_message};

/// Reason why a weld cannot be tracked.
#[derive(Debug, Clone, PartialEq)]
pub enum Error {
    /// A head has no cross slide for corrections.
    NoSlide {
        /// Name of the machine.
        machine: String,
        /// Counted from 1.
        head: usize,
    },
    /// The machine has no sensor that sees the joint ahead of a head.
    NoSensor {
        /// Name of the machine.
        machine: String,
        /// Counted from 1.
        head: usize,
    },
    /// The best sensor of a head does not lead it along the whole pass.
    NotLeading {
        /// Name of the machine.
        machine: String,
        /// Name of the sensor.
        sensor: String,
        /// Counted from 1.
        head: usize,
        /// Minimum and maximum.
        ahead_mm: [f64; 2],
    },
    /// The torch does not follow the seam's line.
    OffLine {
        /// Name of the pass.
        pass: String,
        /// Motion of the torch off the line.
        what: OffLine,
    },
    /// The slides of a head do not span the plane square to its seam.
    SlidesAside {
        /// Name of the machine.
        machine: String,
        /// Counted from 1.
        head: usize,
    },
    /// Invalid settings, such as a lead too short for the speed.
    Settings(seamwright_tracking::lead::Error),
    /// Invalid settings of beam mode.
    Beam(seamwright_tracking::beam::Error),
    /// The machine has no camera that looks through the beam.
    NoCamera {
        /// Name of the machine.
        machine: String,
    },
    /// Stored deviations on a machine without a beam to correct with.
    NoReplay {
        /// Name of the machine.
        machine: String,
    },
}

/// Motion of a torch off the seam's line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OffLine {
    /// Two torches weave.
    TwoTorches,
    /// A beam weaves.
    Beam,
    /// Corners are blended.
    Blends,
}

impl Error {
    /// Returns its message.
    pub fn message(&self) -> Message {
        let of = |code, machine: &str| Message::new(code).text("machine", machine);
        match self {
            Self::NoSlide { machine, head } => of("cell-no-cross-slide", machine).pass("head", *head),
            Self::NoSensor { machine, head } => of("cell-no-stripe-sensor", machine).pass("head", *head),
            Self::NotLeading { machine, sensor, head, ahead_mm: [from, to] } => of("cell-sensor-not-leading", machine)
                .text("sensor", sensor)
                .pass("head", *head)
                .quantity("min", *from, Unit::Mm, 1)
                .quantity("max", *to, Unit::Mm, 1),
            Self::OffLine { pass, what } => Message::new(match what {
                OffLine::TwoTorches => "cell-off-line-two-torches",
                OffLine::Beam => "cell-off-line-beam",
                OffLine::Blends => "cell-off-line-blends",
            })
            .text("pass", pass),
            Self::SlidesAside { machine, head } => of("cell-slides-aside", machine).pass("head", *head),
            Self::Settings(error) => error.message(),
            Self::Beam(error) => error.message(),
            Self::NoCamera { machine } => of("cell-no-beam-camera", machine),
            Self::NoReplay { machine } => of("cell-no-replay", machine),
        }
    }
}

display_by_message!(Error);

impl From<seamwright_tracking::lead::Error> for Error {
    fn from(error: seamwright_tracking::lead::Error) -> Self {
        Self::Settings(error)
    }
}

impl From<seamwright_tracking::beam::Error> for Error {
    fn from(error: seamwright_tracking::beam::Error) -> Self {
        Self::Beam(error)
    }
}
