//! Verbs about the machine and the work in it.

mod check;
mod place;
mod placed;
mod touched;
mod tune;
mod tuning;

use crate::args::machine::{MachineArgs, MachineVerb};
use crate::failure::Failure;

pub(crate) fn run(args: &MachineArgs) -> Result<(), Failure> {
    match &args.verb {
        MachineVerb::Place(a) => place::run(a),
        MachineVerb::Check(a) => check::run(a),
        MachineVerb::Tune(a) => tune::run(a),
    }
}
