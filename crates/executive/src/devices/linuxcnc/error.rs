use seamwright_message::{Message, display_by_message};

/// Reasons why LinuxCNC's HAL does not run.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum LinuxCncError {
    /// A required program is missing.
    NotInstalled(String),
    /// Another HAL runs; a computer can run only one.
    Running(Message),
    /// HAL rejected a file.
    Refused {
        /// The file, or our own commands.
        file: Message,
        /// HAL's message.
        output: Message,
    },
    /// HAL does not work.
    Failed {
        /// The symptom.
        what: Symptom,
        /// HAL's message.
        output: Message,
    },
    /// Any other failure.
    System(Message),
}

/// Symptom of a HAL that does not work.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Symptom {
    /// It does not start.
    NoStart,
    /// It delivers no samples.
    NoSamples,
}

impl LinuxCncError {
    /// Returns its message.
    pub fn message(&self) -> Message {
        match self {
            Self::NotInstalled(program) => Message::new("cell-hal-not-installed").text("program", program),
            Self::Running(owner) => Message::new("cell-hal-running").message("owner", owner.clone()),
            Self::Refused { file, output } => {
                Message::new("cell-hal-refused").message("file", file.clone()).message("why", output.clone())
            }
            Self::Failed { what: Symptom::NoStart, output } => {
                Message::new("cell-hal-no-start").message("why", output.clone())
            }
            Self::Failed { what: Symptom::NoSamples, output } => {
                Message::new("cell-hal-no-samples").message("why", output.clone())
            }
            Self::System(why) => Message::new("cell-hal-not-run").message("why", why.clone()),
        }
    }
}

display_by_message!(LinuxCncError);

impl From<std::io::Error> for LinuxCncError {
    fn from(error: std::io::Error) -> Self {
        Self::System(Message::outside(&error))
    }
}
