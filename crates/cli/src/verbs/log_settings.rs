use crate::args::serve::{LogFormatArg, LogLevelArg, ServeArgs};
use crate::refusals::not_allowed;
use clap::ValueEnum;
use seamwright_log::{Format, Level, Settings};
use seamwright_project::failure::Failure;

/// Settings of the log: from the options, else from the environment.
pub(super) fn of(args: &ServeArgs) -> Result<Settings, Failure> {
    let level = match args.log_level.map_or_else(|| named("SEAMWRIGHT_LOG_LEVEL"), |level| Ok(Some(level)))? {
        Some(LogLevelArg::Error) => Level::Error,
        Some(LogLevelArg::Warn) => Level::Warn,
        Some(LogLevelArg::Info) | None => Level::Info,
        Some(LogLevelArg::Debug) => Level::Debug,
    };
    let format = args.log_format.map_or_else(|| named("SEAMWRIGHT_LOG_FORMAT"), |format| Ok(Some(format)))?;
    let format = format.map(|format| match format {
        LogFormatArg::Text => Format::Text,
        LogFormatArg::Json => Format::Json,
        LogFormatArg::Journal => Format::Journal,
    });
    Ok(Settings { level, format })
}

/// Value of an environment variable, if it is set.
fn named<T: ValueEnum>(variable: &str) -> Result<Option<T>, Failure> {
    let Some(text) = std::env::var(variable).ok().filter(|text| !text.is_empty()) else { return Ok(None) };
    let names = T::value_variants().iter().filter_map(T::to_possible_value);
    let allowed = || names.map(|name| name.get_name().to_owned()).collect::<Vec<_>>().join(", ");
    T::from_str(&text, true).map(Some).map_err(|_| not_allowed(variable, &text, allowed()))
}
