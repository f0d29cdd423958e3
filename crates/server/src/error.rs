use seamwright_message::{Message, display_by_message};

/// Reasons for not serving a panel.
#[derive(Debug)]
pub enum Error {
    /// Invalid settings.
    Settings(Message),
    /// A system call failed.
    System(Message),
}

display_by_message!(Error);

impl Error {
    /// An error of the system, in its words.
    pub(crate) fn system(error: &dyn std::fmt::Display) -> Self {
        Self::System(Message::outside(error))
    }

    /// Description of the error.
    pub fn message(&self) -> Message {
        match self {
            Self::Settings(message) | Self::System(message) => message.clone(),
        }
    }
}
