//! Robot programs as text.

mod rapid;
mod text;
mod urscript;

use super::arm::RobotArm;
use super::language::RobotLanguage;
use super::program::RobotProgram;
use seamwright_machine::{Io, Machine};

/// What a text needs beside the program.
#[derive(Debug, Clone, Copy)]
pub struct RobotText<'a> {
    /// The machine.
    pub machine: &'a Machine,
    /// The same as a robot.
    pub arm: &'a RobotArm,
    /// Remarks for the start of the text.
    pub remarks: &'a [String],
}

impl RobotText<'_> {
    pub(super) fn io(&self) -> &Io {
        &self.machine.io
    }
}

/// The text of `program` in `language`.
pub fn write_robot(language: RobotLanguage, program: &RobotProgram, options: &RobotText) -> String {
    match language {
        RobotLanguage::Rapid => rapid::write(program, options),
        RobotLanguage::Urscript => urscript::write(program, options),
        _ => String::new(),
    }
}
