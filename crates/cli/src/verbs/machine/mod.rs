//! Verbs about the machine and the work in it.

mod arm_file;
mod check;
mod import;
mod new_arm;
mod place;
mod placement_report;
mod reach;
mod robot_program;
mod touched_points;
mod tune;
mod tuning_report;

use super::{io, kinematics, latency, lists, move_to};
use crate::args::ListArgs;
use crate::args::arm::{NewArgs, NewKind};
use crate::args::machine::{MachineArgs, MachineVerb};
use seamwright_project::failure::Failure;

pub(crate) fn run(args: &MachineArgs) -> Result<(), Failure> {
    match &args.verb {
        MachineVerb::List(a) => lists::machines(&ListArgs { name: None, json: a.json }),
        MachineVerb::Show(a) => lists::machines(&ListArgs { name: Some(a.name.clone()), json: false }),
        MachineVerb::Kinematics(a) => kinematics::run(a),
        MachineVerb::Move(a) => move_to::run(a),
        MachineVerb::Io(a) => io::run(a),
        MachineVerb::RobotProgram(a) => robot_program::run(a),
        MachineVerb::Latency(a) => latency::run(a),
        MachineVerb::Import(a) => import::run(a),
        MachineVerb::New(NewArgs { kind: NewKind::Arm(a) }) => new_arm::run(a),
        MachineVerb::Place(a) => place::run(a),
        MachineVerb::Reach(a) => reach::run(a),
        MachineVerb::Check(a) => check::run(a),
        MachineVerb::Tune(a) => tune::run(a),
    }
}
