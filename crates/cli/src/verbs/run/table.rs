//! The trace of a run: a row a cycle.

use crate::args::records::RecordArgs;
use crate::verbs::row_destination::{self, Happened, Rows};
use seamwright_executive::Place;
use seamwright_executive::realtime::Shown;
use seamwright_machine::Machine;
use seamwright_motion::WeldMotion;
use seamwright_project::failure::Failure;
use seamwright_project::files::Output;
use seamwright_project::load::Loaded;
use seamwright_project::recording::Header;
use seamwright_project::run_rows;
use seamwright_record::Outcome;
use seamwright_record::journal::Journal;

/// The trace as it grows, in the output folder or in the library.
pub(in crate::verbs) struct Table {
    rows: Rows,
    machine: Machine,
    tips: run_rows::Tips,
    values: usize,
    /// Suffixes of the columns of each head that is tracked.
    heads: Vec<String>,
}

/// Content of a trace besides its axes.
#[derive(Clone, Copy)]
pub(super) struct Content<'a> {
    /// Names of the process values.
    pub(super) values: &'a [String],
    pub(super) is_tracked: bool,
    /// Start position, if not at the start of the first pass.
    pub(super) from: Option<Place>,
}

impl Table {
    pub(super) fn new(
        loaded: &Loaded,
        motion: &WeldMotion,
        output: &Output,
        record: &RecordArgs,
        content: Content<'_>,
    ) -> Result<Self, Failure> {
        let Content { values, is_tracked, from } = content;
        let heads = if is_tracked { run_rows::head_names(loaded) } else { Vec::new() };
        let machine = &loaded.machine;
        let title = loaded.welding.program.value.title.clone();
        let about = [("title", title), ("machine", machine.name.clone())];
        let columns = run_rows::columns(machine, values, &heads);
        let rows = row_destination::begin(
            loaded,
            motion,
            &Header { columns: &columns, about: &about, from },
            output,
            record,
            machine.devices.is_empty(),
        )?;
        Ok(Self { rows, machine: machine.clone(), tips: run_rows::Tips::default(), values: values.len(), heads })
    }

    pub(super) fn row(&mut self, shown: &Shown) -> Result<(), Failure> {
        let row = run_rows::row(&mut self.tips, &self.machine, shown, self.values, self.heads.len());
        self.rows.row(row)?;
        match self.rows.weld() {
            Some((_, Some(trouble))) => Err(Failure::environment(trouble.clone())),
            _ => Ok(()),
        }
    }

    pub(super) fn weld(&self) -> Option<u64> {
        self.rows.weld().and_then(|(id, _)| u64::try_from(id).ok())
    }

    /// The journal for power loss, if the weld is recorded.
    pub(super) fn journal(&self) -> Result<Option<Journal>, Failure> {
        self.rows.journal()
    }

    /// Adds the finished trace to `output` and to the library.
    pub(super) fn finish(self, outcome: &Outcome, happened: Happened<'_>, output: &mut Output) -> Result<(), Failure> {
        self.rows.keep("run", outcome, happened, output)
    }
}
