//! Part programs that are proven before anybody sees them.

use crate::failure::Failure;
use crate::load::Loaded;
use seamwright_machine::Machine;
use seamwright_message::{Message, Unit, display_by_message};
use seamwright_motion::WeldMotion;
use seamwright_post::{
    Control, Error, Feed, Level, Options, PartProgram, Planned, ReadOptions, Verification, WriteOptions, part_program,
    read, verify, write,
};
use seamwright_program::TorchPath;

/// Reason why there is no part program.
#[derive(Debug)]
pub enum Unproven {
    /// It cannot be made.
    Failure(Failure),
    /// Differences of the text read back from the plan: a line each.
    Wrong(Vec<Message>),
}

impl Unproven {
    /// Description of the reason; differences are separate lines.
    pub fn message(&self) -> Message {
        match self {
            Self::Failure(failure) => failure.message(),
            Self::Wrong(lines) => Message::lines(lines.clone()),
        }
    }
}

display_by_message!(Unproven);

impl From<Failure> for Unproven {
    fn from(failure: Failure) -> Self {
        Self::Failure(failure)
    }
}

/// The part program of a planned weld, with its proof in the header.
///
/// # Errors
/// A motion without a part program, or a program that deviates when it is read back.
pub fn proven(
    loaded: &Loaded,
    motion: &WeldMotion,
    control: &Control,
    options: &Options,
    feed: Feed,
) -> Result<(String, Verification), Unproven> {
    let paths = loaded.paths();
    let paths: Vec<&dyn TorchPath> = paths.iter().map(|p| p as &dyn TorchPath).collect();
    let program = &loaded.welding.program.value;
    let part = part_program(&loaded.machine, control, program, &paths, motion, options);
    let part = part.map_err(|e| match &e {
        Error::TooFine { .. } => {
            let message = Message::new("project-option-tolerance").value("value", options.tolerance_mm, Unit::One);
            Failure::Input(message.message("why", e.message()))
        }
        _ => Failure::Input(e.message()),
    })?;
    let mut write_options = WriteOptions {
        machine: loaded.machine.title.clone(),
        feed,
        rounding_mm: options.rounding_mm(),
        remarks: Vec::new(),
    };
    let text = |options: &WriteOptions| write(control, &part, options).map_err(|e| Failure::Input(e.message()));
    let planned = Planned {
        machine: &loaded.machine,
        control,
        program,
        motion,
        tolerance_mm: options.tolerance_mm,
        speed_percent: options.speed_percent,
    };
    let proof = prove(&part, &text(&write_options)?, options.level, planned)?;
    write_options.remarks = proof.lines();
    Ok((text(&write_options)?, proof))
}

/// Reads `text` back and verifies it against its source and the plan: unproven text is not written.
fn prove(part: &PartProgram, text: &str, level: Level, planned: Planned) -> Result<Verification, Unproven> {
    let start = start(planned.machine, planned.control);
    let options = ReadOptions { lenient: false, level, start: Some(start.clone()) };
    let back =
        read(planned.control, "the part program", text, &options).map_err(|e| Unproven::Wrong(vec![e.located()]))?;
    verify(part, &back.program, &start, planned).map_err(Unproven::Wrong)
}

/// The row before the first block: all axes at home, all outputs off.
pub fn start(machine: &Machine, control: &Control) -> Vec<f64> {
    let home = machine.home();
    let mut row = vec![0.0; control.channels.len()];
    for (i, axis) in machine.axes.iter().enumerate() {
        row[i] = axis.to_file(home[i]);
    }
    row
}
