use crate::args::{Format, SchemaArgs};
use crate::rows::{print_json, print_text};
use seamwright_machine::MachineFile;
use seamwright_program::edit::Operation;
use seamwright_program::{Procedure, Program};
use seamwright_project::failure::Failure;
use seamwright_study::StudyFile;
use seamwright_weld::Job;

pub(crate) fn run(args: &SchemaArgs) -> Result<(), Failure> {
    let schema = match args.format {
        Format::Job => schemars::schema_for!(Job),
        Format::Machine => schemars::schema_for!(MachineFile),
        Format::Operation => schemars::schema_for!(Operation),
        Format::Procedure => schemars::schema_for!(Procedure),
        Format::Program => schemars::schema_for!(Program),
        Format::Study => schemars::schema_for!(StudyFile),
        Format::Rest => return print_json(&seamwright_server::openapi()),
        Format::Typescript => return print_text(&seamwright_server::typescript()),
    };
    print_json(&schema)
}
