use seamwright_message::named_enum;

named_enum! {
    /// Level of a log line, the most severe first.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
    pub enum Level {
        /// Something failed: data are lost, or the cell is not safe by its own confirmation.
        Error => "error",
        /// Something needs attention.
        Warn => "warn",
        /// A routine event: start, end, login, load, weld.
        Info => "info",
        /// Details for finding a fault.
        Debug => "debug",
    }
}

impl From<Level> for tracing::Level {
    fn from(level: Level) -> Self {
        match level {
            Level::Error => Self::ERROR,
            Level::Warn => Self::WARN,
            Level::Info => Self::INFO,
            Level::Debug => Self::DEBUG,
        }
    }
}
