use crate::wire::LeftView;
use seamwright_project::weld_events;
use seamwright_record::journal::Position;
use seamwright_record::library::{Library, Query, WeldRecord, WeldResult};
use seamwright_record::{Error, Plan, sha256};

/// Where a weld was left, and which one: going on there with anything else would weld where nothing is.
pub(super) struct Left {
    at: (u32, f64),
    record: Option<i64>,
    title: String,
    part: String,
    /// SHA-256 of the program, which names its machine.
    program: String,
}

/// What is in the cell to be welded.
pub(super) struct ToWeld {
    pub(super) plan: Plan,
    /// Passes that are to be welded.
    pub(super) passes: usize,
    /// SHA-256 of the program.
    program: String,
}

impl ToWeld {
    pub(super) fn new(plan: Plan, passes: usize) -> Self {
        let program = sha256(plan.program.1.as_bytes());
        Self { plan, passes, program }
    }
}

impl Left {
    /// A weld of what is in this cell, recorded as `record`.
    pub(super) fn now(at: (u32, f64), record: Option<i64>, of: &ToWeld) -> Self {
        let (title, part) = (of.plan.title.clone(), of.plan.part.clone());
        Self { at, record, title, part, program: of.program.clone() }
    }

    /// What a failure of power or program left, from its record.
    pub(super) fn before(at: &Position, library: &Library) -> Result<Self, Error> {
        let weld = library.weld(i64::try_from(at.weld).unwrap_or(0))?;
        Ok(Self::recorded((at.pass.max(1), at.welded_to), weld))
    }

    /// What was stopped before the program ended in order, if nothing has been welded since.
    pub(super) fn stopped(library: &Library) -> Result<Option<Self>, Error> {
        let newest = library.find(&Query::default())?.into_iter().next();
        let Some(weld) = newest.filter(|weld| weld.result == WeldResult::Stopped) else { return Ok(None) };
        let at = weld_events::left(&library.events(weld.id)?);
        Ok(at.map(|at| Self::recorded(at, weld)))
    }

    fn recorded(at: (u32, f64), weld: WeldRecord) -> Self {
        Self { at, record: Some(weld.id), title: weld.title, part: weld.part, program: weld.program.2 }
    }

    /// As pages see it while that is in the cell.
    pub(super) fn seen(&self, now: Option<&ToWeld>) -> LeftView {
        let same = |part: &str| part.is_empty() || part == self.part;
        let here = now.is_some_and(|now| now.program == self.program && same(&now.plan.part));
        let (title, part) = (self.title.clone(), self.part.clone());
        LeftView { pass: self.at.0, s_mm: self.at.1, record: self.record, title, part, here }
    }
}
