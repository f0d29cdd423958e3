use thiserror::Error;

/// Why LinuxCNC's HAL does not run.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum LinuxCncError {
    /// A program that is needed is not there.
    #[error(
        "LinuxCNC is not installed: there is no program `{0}`\n   allowed: Debian's package linuxcnc-uspace (apt install linuxcnc-uspace)"
    )]
    NotInstalled(String),
    /// There can be only one on a computer.
    #[error(
        "LinuxCNC's HAL runs already, {0}\n   allowed: one at a time; end the other, or clear it away with `halrun -U`"
    )]
    Running(String),
    /// HAL did not take a file.
    #[error("LinuxCNC does not take {file}: {said}")]
    Refused {
        /// Which file, or our own part.
        file: String,
        /// What it said.
        said: String,
    },
    /// It does not do what it should.
    #[error("LinuxCNC's HAL {what}: {said}")]
    Failed {
        /// What happened.
        what: &'static str,
        /// What it said.
        said: String,
    },
    /// Something else.
    #[error("LinuxCNC's HAL cannot be run: {0}")]
    System(String),
}

impl From<std::io::Error> for LinuxCncError {
    fn from(error: std::io::Error) -> Self {
        Self::System(error.to_string())
    }
}
