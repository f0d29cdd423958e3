//! Robot programs as text.

mod fanuc;
mod inform;
mod krl;
mod rapid;
mod text;
mod urscript;

use super::arm::RobotArm;
use super::language::RobotLanguage;
use super::program::RobotProgram;
use seamwright_machine::{Io, Machine};

/// Machine and remarks of a text.
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
        RobotLanguage::Krl => krl::write(program, options),
        RobotLanguage::FanucLs => fanuc::write(program, options),
        RobotLanguage::Urscript => urscript::write(program, options),
        RobotLanguage::Inform => inform::write(program, options),
    }
}
