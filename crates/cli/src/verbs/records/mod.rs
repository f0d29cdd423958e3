//! `seamwright records`: the library of recorded welds.

mod backup;
mod data;
mod export;
mod lines;
mod list;
mod recover;
mod show;
mod verify;

use crate::args::records::{Action, RecordsArgs};
pub(super) use data::folder;
use seamwright_project::failure::Failure;

pub(crate) fn run(args: &RecordsArgs) -> Result<(), Failure> {
    match &args.action {
        Action::List(a) => list::run(a),
        Action::Show(a) => show::run(a),
        Action::Export(a) => export::run(a),
        Action::Audit(a) => lines::audit(a),
        Action::Alarms(a) => lines::alarms(a),
        Action::Verify(a) => verify::run(a),
        Action::Backup(a) => backup::backup(a),
        Action::Restore(a) => backup::restore(a),
        Action::Recover(a) => recover::run(a),
    }
}
