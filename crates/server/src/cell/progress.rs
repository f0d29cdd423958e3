//! How far parts are welded: which passes are finished, where a weld was left, by program and part, from the library and since.

use crate::wire::{LackView, LeftView};
use seamwright_cell::executive::{Note, Place};
use seamwright_project::weld_events;
use seamwright_record::journal::Position;
use seamwright_record::library::{Library, Query, WeldRecord, WeldResult};
use seamwright_record::{Error, Plan, sha256};
use std::collections::{HashMap, HashSet};

/// A start this much before the place up to which a pass is welded welds nothing again that is finished, mm: places are written with
/// two digits.
const SAME_MM: f64 = 0.5;

/// Where a weld was left, and which one: going on there with anything else would weld where nothing is.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Left {
    /// The pass, and up to where it is welded, mm: all passes before it are finished.
    at: (u32, f64),
    record: Option<i64>,
    title: String,
    part: String,
    /// SHA-256 of the program, which names its machine.
    program: String,
}

/// How far a part is welded.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Progress {
    /// It was left there.
    Left(Left),
    /// All of it was welded, in this record.
    Whole(Option<i64>),
}

/// What is in the cell to be welded.
pub(super) struct ToWeld {
    pub(super) plan: Plan,
    /// Passes that are to be welded.
    pub(super) passes: usize,
    /// Where it begins: the pass, and the place in it, mm.
    pub(super) start: (u32, f64),
    /// How much of a finished weld before `start` is welded over on purpose, mm: asked for when it was loaded.
    overlap_mm: f64,
    /// SHA-256 of the program.
    program: String,
}

impl ToWeld {
    pub(super) fn new(plan: Plan, passes: usize, start: Option<(u32, f64)>) -> Self {
        let program = sha256(plan.program.1.as_bytes());
        Self { plan, passes, start: start.unwrap_or((1, 0.0)), overlap_mm: 0.0, program }
    }

    /// The same, where so much of a finished weld is welded over on purpose, mm.
    pub(super) fn with_overlap(self, overlap_mm: f64) -> Self {
        Self { overlap_mm, ..self }
    }

    fn key(&self) -> Key {
        (self.program.clone(), self.plan.part.clone())
    }
}

/// Program and part.
type Key = (String, String);

impl Left {
    /// A weld of what is in this cell, recorded as `record`.
    pub(super) fn now(at: (u32, f64), record: Option<i64>, of: &ToWeld) -> Self {
        let (title, part) = (of.plan.title.clone(), of.plan.part.clone());
        Self { at, record, title, part, program: of.program.clone() }
    }

    fn recorded(at: (u32, f64), weld: WeldRecord) -> Self {
        Self { at, record: Some(weld.id), title: weld.title, part: weld.part, program: weld.program.2 }
    }

    /// As pages see it while that is in the cell.
    pub(super) fn seen(&self, now: Option<&ToWeld>) -> LeftView {
        let same = |part: &str| part.is_empty() || part == self.part;
        let here = now.is_some_and(|now| now.program == self.program && same(&now.plan.part));
        let (title, part) = (self.title.clone(), self.part.clone());
        let finished = self.at.0.saturating_sub(1);
        LeftView { pass: self.at.0, s_mm: self.at.1, finished, record: self.record, title, part, here }
    }
}

/// Puts where a failure of power or program left a weld, which its journal knows, into the events of its record: there it is found
/// like any other place, however many welds come after it.
///
/// # Errors
/// If the library cannot be read or written.
pub(super) fn remember(at: &Position, library: &Library) -> Result<(), Error> {
    let weld = i64::try_from(at.weld).unwrap_or(0);
    // Of a weld whose record is gone nothing can be said.
    let Ok(record) = library.weld(weld) else { return Ok(()) };
    if record.result != WeldResult::Interrupted || weld_events::left(&library.events(weld)?).is_some() {
        return Ok(());
    }
    let place = Place { pass: at.pass.max(1) as usize, s_mm: at.welded_to };
    weld_events::event(0.0, &Note::Left(place), place)
        .map_or(Ok(()), |event| library.add_event(Some(weld), &event).map(drop))
}

/// How far parts are welded: what the library has, and what has happened since, which it may not have yet.
#[derive(Debug, Default)]
pub(super) struct Parts {
    known: HashMap<Key, Progress>,
}

impl Parts {
    /// What is in the cell was left there, or welded whole.
    pub(super) fn note(&mut self, of: &ToWeld, progress: Progress) {
        self.known.insert(of.key(), progress);
    }

    /// How far the part is that is in the cell. A program that is loaded for a part without a number is that for any part of which
    /// something is left, the newest.
    pub(super) fn of(&self, now: &ToWeld, library: Option<&Library>) -> Option<Progress> {
        let part = &now.plan.part;
        match self.known.get(&now.key()) {
            // The last part without a number is whole; others may be left.
            Some(Progress::Whole(_)) if part.is_empty() => {}
            Some(known) => return Some(known.clone()),
            None => {}
        }
        let own = |key: &&Key| key.0 == now.program && part.is_empty();
        let since = self.known.iter().filter(|(key, _)| own(key)).map(|(_, progress)| progress);
        let since = since.filter(|progress| matches!(progress, Progress::Left(_)));
        let newest = since.max_by_key(|progress| if let Progress::Left(left) = progress { left.record } else { None });
        if newest.is_some() {
            return newest.cloned();
        }
        let query = Query {
            program: Some(now.program.clone()),
            part: Some(part.clone()).filter(|part| !part.is_empty()),
            ..Query::default()
        };
        let simulated = |weld: &WeldRecord| weld.simulated == now.plan.simulated;
        // A library that cannot be read has told so elsewhere.
        let recorded = library.and_then(|library| newest_of(library, &query, simulated).ok()).flatten();
        recorded.filter(|progress| !matches!(progress, Progress::Left(left) if self.is_done(left)))
    }

    /// What the library has of it is out of date.
    fn is_done(&self, left: &Left) -> bool {
        let key = (left.program.clone(), left.part.clone());
        matches!(self.known.get(&key), Some(Progress::Whole(_)))
    }

    /// Why what is in the cell must not be welded from where it begins without a question: it would weld a finished pass again, by
    /// more than the overlap that was asked for.
    pub(super) fn finished(&self, now: &ToWeld, library: Option<&Library>) -> Option<LackView> {
        let (part, start) = (&now.plan.part, now.start);
        match self.of(now, library)? {
            Progress::Left(left) if left.part == *part => {
                let (pass, s_mm) = left.at;
                let again = start.0 < pass || (start.0 == pass && start.1 < s_mm - now.overlap_mm - SAME_MM);
                let text = format!(
                    "part \"{part}\" is welded up to pass {pass}, {s_mm:.2} mm: from pass {}, {:.2} mm finished weld would be welded \
                     again; go on there, or confirm",
                    start.0, start.1
                );
                let of = vec![part.clone(), pass.to_string(), format!("{s_mm:.2}")];
                again.then(|| LackView { key: "finished_pass".to_owned(), of, text })
            }
            // Parts without a number are others each time.
            Progress::Whole(record) if !part.is_empty() => {
                let record = record.map_or_else(|| "–".to_owned(), |id| id.to_string());
                let text = format!(
                    "part \"{part}\" is welded whole (weld {record}): it would be welded again; confirm, or name another part"
                );
                Some(LackView { key: "finished_part".to_owned(), of: vec![part.clone(), record], text })
            }
            Progress::Left(_) | Progress::Whole(_) => None,
        }
    }
}

/// Where the newest weld was left whose part was not welded whole since.
///
/// # Errors
/// If the library cannot be read.
pub(super) fn newest_left(library: &Library) -> Result<Option<Left>, Error> {
    let progress = newest_of(library, &Query::default(), |_| true)?;
    Ok(progress.and_then(|progress| if let Progress::Left(left) = progress { Some(left) } else { None }))
}

/// How far the newest part among these welds is: the newest place at which one was left, of parts that were not welded whole since;
/// if there is none, the newest that is whole.
fn newest_of(
    library: &Library,
    query: &Query,
    counts: impl Fn(&WeldRecord) -> bool,
) -> Result<Option<Progress>, Error> {
    let mut welds = library.find(query)?;
    // By number: clocks are set.
    welds.sort_by_key(|weld| std::cmp::Reverse(weld.id));
    let (mut whole, mut done) = (None, HashSet::new());
    for weld in welds.into_iter().filter(counts) {
        let key = (weld.program.2.clone(), weld.part.clone());
        match weld.result {
            WeldResult::Good | WeldResult::Deviating => {
                whole.get_or_insert(Progress::Whole(Some(weld.id)));
                done.insert(key);
            }
            WeldResult::Stopped | WeldResult::Interrupted if !done.contains(&key) => {
                // One that was left before anything was welded changes nothing.
                if let Some(at) = weld_events::left(&library.events(weld.id)?) {
                    return Ok(Some(Progress::Left(Left::recorded(at, weld))));
                }
            }
            _ => {}
        }
    }
    Ok(whole)
}

#[cfg(test)]
mod tests {
    use super::*;
    use seamwright_record::figures::Basis;

    fn to_weld(part: &str, start: (u32, f64)) -> ToWeld {
        let text = |text: &str| (text.to_owned(), text.to_owned());
        let plan = Plan {
            part: part.to_owned(),
            title: "Nozzle".to_owned(),
            simulated: true,
            job: None,
            program: text("program"),
            machine: text("machine"),
            procedure: None,
            welder: None,
            columns: Vec::new(),
            about: Vec::new(),
            most_rows: 1,
            rows: 1,
            basis: Basis::default(),
            note: String::new(),
        };
        ToWeld::new(plan, 3, Some(start))
    }

    /// A continued weld that is left again in its second pass: the root is finished, and no older place brings it back.
    #[test]
    fn a_finished_pass_is_not_begun_again_unasked() {
        let mut parts = Parts::default();
        let first = to_weld("N-1", (1, 0.0));
        assert_eq!(parts.finished(&first, None), None);
        parts.note(&first, Progress::Left(Left::now((1, 135.2), Some(1), &first)));
        let continued = to_weld("N-1", (1, 135.2));
        assert_eq!(parts.finished(&continued, None), None);
        parts.note(&continued, Progress::Left(Left::now((2, 6.0), Some(2), &continued)));
        for (start, again) in [
            ((1, 0.0), true),
            ((1, 135.2), true),
            ((2, 0.0), true),
            ((2, 5.0), true),
            ((2, 6.0), false),
            ((3, 0.0), false),
        ] {
            let lack = parts.finished(&to_weld("N-1", start), None);
            assert_eq!(lack.as_ref().map(|lack| lack.key.as_str()), again.then_some("finished_pass"), "{start:?}");
            assert!(lack.is_none_or(|lack| lack.of == ["N-1", "2", "6.00"]), "{start:?}");
            // Another part is not concerned.
            assert_eq!(parts.finished(&to_weld("N-2", start), None), None);
        }
        // Some weld over the end of what is finished is asked for each time: so much of the same pass needs no question.
        for (start, overlap_mm, again) in
            [((2, 0.0), 6.0, false), ((2, 1.0), 5.0, false), ((2, 1.0), 4.0, true), ((1, 135.2), 10.0, true)]
        {
            let of = to_weld("N-1", start).with_overlap(overlap_mm);
            assert_eq!(parts.finished(&of, None).is_some(), again, "{start:?} {overlap_mm}");
        }
        let Some(Progress::Left(left)) = parts.of(&continued, None) else { panic!("nothing is left") };
        let seen = left.seen(Some(&continued));
        assert_eq!((seen.pass, seen.finished, seen.here, seen.record), (2, 1, true, Some(2)));
        // Loaded without the number of a part it is offered too, but starts anew unasked: it may be another part.
        let unnumbered = to_weld("", (1, 0.0));
        assert_eq!(parts.of(&unnumbered, None), Some(Progress::Left(left)));
        assert_eq!(parts.finished(&unnumbered, None), None);
        // Welded whole it is finished; one without a number never is.
        parts.note(&continued, Progress::Whole(Some(3)));
        assert_eq!(parts.finished(&first, None).map(|lack| lack.key), Some("finished_part".to_owned()));
        parts.note(&unnumbered, Progress::Whole(Some(4)));
        assert_eq!(parts.finished(&unnumbered, None), None);
    }
}
