//! Weld progress of parts: finished passes and the position where a weld was left, by program and part, from the
//! library and since.

use crate::refusal::{Lack, lack};
use crate::wire::LeftView;
use seamwright_executive::{Note, Place};
use seamwright_message::{Message, Unit};
use seamwright_project::weld_events;
use seamwright_record::journal::Position;
use seamwright_record::library::{Library, Query, WeldRecord, WeldResult};
use seamwright_record::{DataFolder, Error, Plan, sha256};
use std::collections::{HashMap, HashSet};

/// Tolerance for a start before the end of a pass's finished length, mm: positions are written with two digits.
const SAME_MM: f64 = 0.5;

/// Position where a weld was left, with its program and part: continuing there with another one would weld in the wrong
/// position.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Left {
    /// The pass, and the end of its finished length, mm. All passes before it are finished.
    at: (u32, f64),
    record: Option<i64>,
    title: String,
    part: String,
    /// SHA-256 of the program, which names its machine.
    program: String,
}

#[derive(Debug, Clone, PartialEq)]
pub(super) enum Progress {
    /// It was left at this position.
    Left(Left),
    /// It is welded completely, in this record.
    Whole(Option<i64>),
}

pub(super) struct ToWeld {
    pub(super) plan: Plan,
    /// Number of passes to be welded.
    pub(super) passes: usize,
    /// Start: the pass, and the position in it, mm.
    pub(super) start: (u32, f64),
    /// Length of finished weld before `start` that is welded over on purpose, mm: requested when it was loaded.
    overlap_mm: f64,
    /// SHA-256 of the program.
    program: String,
}

impl ToWeld {
    pub(super) fn new(plan: Plan, passes: usize, start: Option<(u32, f64)>) -> Self {
        let program = sha256(plan.program.1.as_bytes());
        Self { plan, passes, start: start.unwrap_or((1, 0.0)), overlap_mm: 0.0, program }
    }

    /// Returns the same with this length of finished weld welded over on purpose, mm.
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
    /// A weld of the loaded program that was left, recorded as `record`.
    pub(super) fn now(at: (u32, f64), record: Option<i64>, of: &ToWeld) -> Self {
        let (title, part) = (of.plan.title.clone(), of.plan.part.clone());
        Self { at, record, title, part, program: of.program.clone() }
    }

    fn recorded(at: (u32, f64), weld: WeldRecord) -> Self {
        Self { at, record: Some(weld.id), title: weld.title, part: weld.part, program: weld.program.2 }
    }

    /// Returns the view for pages while `now` is loaded.
    pub(super) fn seen(&self, now: Option<&ToWeld>) -> LeftView {
        let same = |part: &str| part.is_empty() || part == self.part;
        let here = now.is_some_and(|now| now.program == self.program && same(&now.plan.part));
        let (title, part) = (self.title.clone(), self.part.clone());
        let finished = self.at.0.saturating_sub(1);
        LeftView { pass: self.at.0, s_mm: self.at.1, finished, record: self.record, title, part, here }
    }
}

/// Adds the position at which a failure of power or program left a weld to the events of its record. The position comes
/// from its journal. It is then found like any other position, however many welds follow.
pub(super) fn remember(at: &Position, library: &Library) -> Result<(), Error> {
    let weld = i64::try_from(at.weld).unwrap_or(0);
    // A weld without a record is skipped.
    let Ok(record) = library.weld(weld) else { return Ok(()) };
    if record.result != WeldResult::Interrupted || weld_events::left(&library.events(weld)?).is_some() {
        return Ok(());
    }
    let place = Place { pass: at.pass.max(1) as usize, s_mm: at.welded_to };
    weld_events::event(0.0, &Note::Left(place), place)
        .map_or(Ok(()), |event| library.add_event(Some(weld), &event).map(drop))
}

/// Returns true if the library has the end of a weld, and it was no failure.
pub(super) fn is_settled(weld: i64, library: &Library) -> bool {
    let settled = |record: WeldRecord| !matches!(record.result, WeldResult::Interrupted | WeldResult::Running);
    library.weld(weld).is_ok_and(settled)
}

/// Takes the position of a weld whose end the library has out of the journal, unless a weld that has begun since has it
/// open.
pub(super) fn clear_journal(data: &DataFolder) -> Result<(), Error> {
    match data.journal() {
        Ok(mut journal) => journal.clear(),
        Err(Error::Busy { .. }) => Ok(()),
        Err(e) => Err(e),
    }
}

/// Weld progress of parts: from the library, and from newer events that it may not contain yet.
#[derive(Debug, Default)]
pub(super) struct Parts {
    known: HashMap<Key, Progress>,
}

impl Parts {
    pub(super) fn note(&mut self, of: &ToWeld, progress: Progress) {
        self.known.insert(of.key(), progress);
    }

    /// Returns the progress of the loaded part. A program loaded without a part number matches any part of it that was
    /// left, the newest.
    pub(super) fn of(&self, now: &ToWeld, library: Option<&Library>) -> Option<Progress> {
        let part = &now.plan.part;
        match self.known.get(&now.key()) {
            // The last part without a number is complete; others may be left.
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
        // Reading errors of the library are reported elsewhere.
        let recorded = library.and_then(|library| newest_of(library, &query, simulated).ok()).flatten();
        recorded.filter(|progress| !matches!(progress, Progress::Left(left) if self.is_done(left)))
    }

    /// Returns true if the library's position is out of date.
    fn is_done(&self, left: &Left) -> bool {
        let key = (left.program.clone(), left.part.clone());
        matches!(self.known.get(&key), Some(Progress::Whole(_)))
    }

    /// Returns the reason for which the loaded weld needs confirmation: it would weld a finished pass again, beyond the
    /// requested overlap.
    pub(super) fn finished(&self, now: &ToWeld, library: Option<&Library>) -> Option<Lack> {
        let (part, start) = (&now.plan.part, now.start);
        match self.of(now, library)? {
            Progress::Left(left) if left.part == *part => {
                let (pass, s_mm) = left.at;
                let again = start.0 < pass || (start.0 == pass && start.1 < s_mm - now.overlap_mm - SAME_MM);
                let message = Message::new("server-finished-pass").text("part", part).pass("pass", pass as usize);
                again.then(|| lack("finished_pass", message.quantity("s", s_mm, Unit::Mm, 2)))
            }
            // Each weld without a part number is another part.
            Progress::Whole(record) if !part.is_empty() => {
                let record = record.map_or_else(|| "–".to_owned(), |id| id.to_string());
                let message = Message::new("server-finished-part").text("part", part).text("weld", record);
                Some(lack("finished_part", message))
            }
            Progress::Left(_) | Progress::Whole(_) => None,
        }
    }
}

/// Returns the newest weld that was left and whose part has not been completed since.
pub(super) fn newest_left(library: &Library) -> Result<Option<Left>, Error> {
    let progress = newest_of(library, &Query::default(), |_| true)?;
    Ok(progress.and_then(|progress| if let Progress::Left(left) = progress { Some(left) } else { None }))
}

/// Returns the progress of the newest part among these welds: the newest one left whose part was not completed since,
/// or else the newest complete one.
fn newest_of(
    library: &Library,
    query: &Query,
    counts: impl Fn(&WeldRecord) -> bool,
) -> Result<Option<Progress>, Error> {
    let mut welds = library.find(query)?;
    // By number, since clocks can be set.
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
                // A weld that was left before anything was welded changes nothing.
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

    fn to_weld(part: &str, start: (u32, f64)) -> ToWeld {
        let text = |text: &str| (text.to_owned(), text.to_owned());
        let plan = Plan {
            part: part.to_owned(),
            title: "Nozzle".to_owned(),
            simulated: true,
            program: text("program"),
            machine: text("machine"),
            most_rows: 1,
            rows: 1,
            ..Plan::default()
        };
        ToWeld::new(plan, 3, Some(start))
    }

    /// A continued weld is left again in its second pass: the root is finished, and older positions are out of date.
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
            assert_eq!(lack.as_ref().map(|lack| lack.key), again.then_some("finished_pass"), "{start:?}");
            assert!(
                lack.is_none_or(|lack| lack.message.to_string().contains("“N-1” is welded up to pass 2, 6.00 mm")),
                "{start:?}"
            );
            // Another part is not affected.
            assert_eq!(parts.finished(&to_weld("N-2", start), None), None);
        }
        // Overlap over the end of the finished weld is requested explicitly: within it the same pass needs no
        // confirmation.
        for (start, overlap_mm, again) in
            [((2, 0.0), 6.0, false), ((2, 1.0), 5.0, false), ((2, 1.0), 4.0, true), ((1, 135.2), 10.0, true)]
        {
            let of = to_weld("N-1", start).with_overlap(overlap_mm);
            assert_eq!(parts.finished(&of, None).is_some(), again, "{start:?} {overlap_mm}");
        }
        let Some(Progress::Left(left)) = parts.of(&continued, None) else { panic!("nothing is left") };
        let seen = left.seen(Some(&continued));
        assert_eq!((seen.pass, seen.finished, seen.here, seen.record), (2, 1, true, Some(2)));
        // Loaded without a part number it is offered too, but starts anew without confirmation: it may be another part.
        let unnumbered = to_weld("", (1, 0.0));
        assert_eq!(parts.of(&unnumbered, None), Some(Progress::Left(left)));
        assert_eq!(parts.finished(&unnumbered, None), None);
        // A complete part is finished; a part without a number never is.
        parts.note(&continued, Progress::Whole(Some(3)));
        assert_eq!(parts.finished(&first, None).map(|lack| lack.key), Some("finished_part"));
        parts.note(&unnumbered, Progress::Whole(Some(4)));
        assert_eq!(parts.finished(&unnumbered, None), None);
    }
}
