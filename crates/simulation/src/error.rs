use seamwright_executive::tracking;
use seamwright_message::{Message, display_by_message};

/// Reasons why a cell cannot be simulated.
#[derive(Debug, Clone, PartialEq)]
pub enum Error {
    /// The cell cannot run.
    Cell(seamwright_executive::Error),
    /// A pass does not allow tracking.
    Tracking(tracking::Error),
    /// Invalid distortion file.
    Distortion(Message),
    /// The axes cannot carry the gun aside.
    Carried(Message),
    /// A frame or record is not available.
    Frame(Message),
}

impl Error {
    /// Returns its message.
    pub fn message(&self) -> Message {
        match self {
            Self::Cell(error) => error.message(),
            Self::Tracking(error) => error.message(),
            Self::Carried(why) => Message::new("cell-gun-not-carried").message("why", why.clone()),
            Self::Distortion(message) | Self::Frame(message) => message.clone(),
        }
    }
}

display_by_message!(Error);

impl From<seamwright_executive::Error> for Error {
    fn from(error: seamwright_executive::Error) -> Self {
        Self::Cell(error)
    }
}

impl From<tracking::Error> for Error {
    fn from(error: tracking::Error) -> Self {
        Self::Tracking(error)
    }
}

impl From<seamwright_tracking::lead::Error> for Error {
    fn from(error: seamwright_tracking::lead::Error) -> Self {
        Self::Tracking(error.into())
    }
}

impl From<seamwright_tracking::beam::Error> for Error {
    fn from(error: seamwright_tracking::beam::Error) -> Self {
        Self::Tracking(error.into())
    }
}
