//! Programs for robot controls that take set-points.

use crate::args::machine::{RobotProgramArgs, RobotProtocolName};
use crate::rows::print_text;
use seamwright_executive::devices::robot::{KRL, RAPID, URSCRIPT};
use seamwright_project::failure::Failure;

pub(super) fn run(args: &RobotProgramArgs) -> Result<(), Failure> {
    print_text(match args.protocol {
        RobotProtocolName::Rtde => URSCRIPT,
        RobotProtocolName::Egm => RAPID,
        RobotProtocolName::Rsi => KRL,
    })
}
