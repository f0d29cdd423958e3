//! Readers of robot programs. They know the languages, not the writers.

mod fanuc;
mod inform;
mod krl;
mod rapid;
mod scan;
mod urscript;

use super::language::RobotLanguage;
use super::program::RobotProgram;
use crate::read::ReadError;
use crate::read::error::{Fault, Read, Span};
use seamwright_message::Message;

/// Largest program that is read, bytes.
const MAX_BYTES: usize = 64 << 20;

/// Reads the robot program `text`; `file` is its name in errors.
///
/// # Errors
/// [`ReadError`] at the first fault.
pub fn read_robot(language: RobotLanguage, file: &str, text: &str) -> Result<RobotProgram, ReadError> {
    let read = |text: &str| -> Read<RobotProgram> {
        if text.len() > MAX_BYTES {
            let message = Message::new("post-robot-too-long").count("max", MAX_BYTES);
            return Err(Fault::new(Span { from: 0, to: 0 }, message));
        }
        match language {
            RobotLanguage::Rapid => rapid::read(text),
            RobotLanguage::Krl => krl::read(text),
            RobotLanguage::FanucLs => fanuc::read(text),
            RobotLanguage::Urscript => urscript::read(text),
            RobotLanguage::Inform => inform::read(text),
        }
    };
    read(text).map_err(|fault| fault.placed(file, text))
}
