use thiserror::Error;

/// Reasons why LinuxCNC's HAL does not run.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum LinuxCncError {
    /// A required program is missing.
    #[error(
        "LinuxCNC is not installed: there is no program `{0}`\n   allowed: Debian's package linuxcnc-uspace (apt install linuxcnc-uspace)"
    )]
    NotInstalled(String),
    /// Another HAL runs; a computer can run only one.
    #[error(
        "LinuxCNC's HAL runs already, {0}\n   allowed: one at a time; end the other, or clear it away with `halrun -U`"
    )]
    Running(String),
    /// HAL rejected a file.
    #[error("LinuxCNC does not take {file}: {said}")]
    Refused {
        /// The file, or our own commands.
        file: String,
        /// HAL's message.
        said: String,
    },
    /// HAL does not work.
    #[error("LinuxCNC's HAL {what}: {said}")]
    Failed {
        /// The symptom.
        what: &'static str,
        /// HAL's message.
        said: String,
    },
    /// Any other failure.
    #[error("LinuxCNC's HAL cannot be run: {0}")]
    System(String),
}

impl From<std::io::Error> for LinuxCncError {
    fn from(error: std::io::Error) -> Self {
        Self::System(error.to_string())
    }
}
