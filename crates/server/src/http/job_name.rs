use super::answer::Refused;
use crate::limits::MAX_JOB_NAME_BYTES;
use seamwright_message::{Message, Unit};

/// Checks the file name of a job: no folders, no hidden files.
pub(super) fn checked(name: &str) -> Result<&str, Refused> {
    let good = |c: char| c.is_alphanumeric() || "-_. ()+".contains(c);
    let is_toml = name.strip_suffix(".toml").is_some_and(|stem| !stem.is_empty());
    if is_toml
        && name.len() <= MAX_JOB_NAME_BYTES
        && !name.starts_with(['.', ' '])
        && name.chars().all(good)
        && !name.contains("..")
    {
        return Ok(name);
    }
    Err(Message::new("server-job-name").text("name", name).value("max", MAX_JOB_NAME_BYTES as f64, Unit::Byte).into())
}
