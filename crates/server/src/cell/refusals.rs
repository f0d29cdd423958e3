//! Refusals and other requests that may be repeated without limit, on their way to the audit log: counted by source and
//! kind and summed up, so that repetition fills neither queue nor disk.
//!
//! The first request of a kind from a source gets an entry at once. The others become one entry of the source a minute,
//! with their number, the times of the first and the last, and the number of each kind. No request is left out of these
//! numbers. Memory is bounded by [`MAX_SOURCES`] and [`MAX_KINDS`].

use super::audit_entry::{Change, entry};
use super::stored_message::stored;
use seamwright_message::{Argument, Message};
use seamwright_record::Moment;
use seamwright_record::library::AuditEntry;
use std::collections::HashMap;
use std::time::{Duration, Instant};

/// After the first request of a source, further ones are counted for this time and written as one entry.
const SUM_UP: Duration = Duration::from_secs(60);
/// Maximum number of sources counted at a time; all others share one more source.
const MAX_SOURCES: usize = 64;
/// Maximum number of sources with the same user, or with the same place; further ones share one more.
const MAX_ALIKE: usize = 8;
/// Maximum number of kinds of a source; all others are one more kind.
const MAX_KINDS: usize = 8;

/// A repeatable request.
#[derive(Debug, Clone)]
pub(super) struct Repeatable {
    pub(super) user: String,
    /// Page or address from which it comes, as a column of the audit log.
    pub(super) station: String,
    pub(super) command: Message,
    pub(super) result: Message,
    pub(super) is_refused: bool,
}

/// Source of requests: a user at a page or address.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
struct Source {
    user: String,
    station: String,
    is_refused: bool,
}

#[derive(Debug)]
struct Kind {
    command: Message,
    result: Message,
    /// Number of requests without an entry of their own.
    count: u64,
}

/// Requests of a source since its last entry.
#[derive(Debug)]
struct Counted {
    since: Instant,
    /// Times of the first and of the last request without an entry of its own.
    first: Moment,
    last: Moment,
    kinds: Vec<Kind>,
    /// Number of requests of further kinds.
    others: u64,
}

/// Requests not written yet.
#[derive(Debug, Default)]
pub(super) struct Refusals {
    sources: HashMap<Source, Counted>,
    /// Entries of first requests.
    first: Vec<AuditEntry>,
}

fn others() -> Message {
    Message::new("server-audit-others")
}

impl Counted {
    fn new(since: Instant) -> Self {
        let at = Moment::now();
        Self { since, first: at, last: at, kinds: Vec::new(), others: 0 }
    }

    fn count(&self) -> u64 {
        self.others + self.kinds.iter().map(|kind| kind.count).sum::<u64>()
    }

    /// Counts a request. Returns true if it is the first of its kind, which is not counted but gets an entry.
    fn add(&mut self, request: &Repeatable) -> bool {
        let known = self.kinds.iter().position(|k| k.command == request.command && k.result == request.result);
        if known.is_none() && self.kinds.len() < MAX_KINDS {
            let (command, result) = (request.command.clone(), request.result.clone());
            self.kinds.push(Kind { command, result, count: 0 });
            return true;
        }
        let at = Moment::now();
        if self.count() == 0 {
            self.first = at;
        }
        self.last = at;
        match known {
            Some(i) => self.kinds[i].count += 1,
            None => self.others += 1,
        }
        false
    }

    /// Returns the entry of everything counted, and begins anew.
    fn sum(&mut self, source: &Source) -> AuditEntry {
        let kind = |command: &Message, result: &Message, count: u64| {
            let kind = Message::new("server-audit-kind").message("command", command.clone());
            Argument::Message(Box::new(kind.message("result", result.clone()).count("n", count as usize)))
        };
        let counted = self.kinds.iter().filter(|k| k.count > 0).map(|k| kind(&k.command, &k.result, k.count));
        let mut kinds: Vec<Argument> = counted.collect();
        if self.others > 0 {
            kinds.push(kind(&others(), &others(), self.others));
        }
        let code = if source.is_refused { "server-audit-refused-sum" } else { "server-audit-repeated-sum" };
        let result = Message::new(code).count("n", self.count() as usize);
        let result = result.text("first", self.first.to_string()).text("last", self.last.to_string());
        let result = stored(result.list("kinds", kinds));
        let command = match self.kinds.iter().filter(|k| k.count > 0).collect::<Vec<_>>().as_slice() {
            [one] if self.others == 0 => one.command.clone(),
            _ => Message::new("server-audit-several"),
        };
        self.kinds.iter_mut().for_each(|kind| kind.count = 0);
        self.others = 0;
        entry(&source.user, &source.station, &stored(command), Change::default(), &result)
    }
}

impl Refusals {
    /// Counts a request; the first of its kind gets an entry at once.
    pub(super) fn add(&mut self, request: &Repeatable, now: Instant) {
        let source = self.source(request);
        let counted = self.sources.entry(source.clone()).or_insert_with(|| Counted::new(now));
        if counted.add(request) {
            let (command, result) = (stored(request.command.clone()), stored(request.result.clone()));
            self.first.push(entry(&source.user, &source.station, &command, Change::default(), &result));
        }
    }

    /// Returns the source of a request, or the one that it shares with others if there are too many.
    fn source(&self, request: &Repeatable) -> Source {
        let Repeatable { user, station, is_refused, .. } = request.clone();
        let mut source = Source { user, station, is_refused };
        if self.sources.contains_key(&source) {
            return source;
        }
        let count = |is: &dyn Fn(&Source) -> bool| self.sources.keys().filter(|of| is(of)).count();
        if count(&|of| of.user == source.user) >= MAX_ALIKE {
            source.station = stored(others());
        }
        if count(&|of| of.station == source.station) >= MAX_ALIKE {
            source.user = String::new();
        }
        // Room for what is shared by all.
        if self.sources.len() >= MAX_SOURCES && !self.sources.contains_key(&source) {
            source = Source { user: String::new(), station: stored(others()), is_refused };
        }
        source
    }

    /// Takes the entries that are due; `all`: also those still being counted.
    pub(super) fn due(&mut self, now: Instant, all: bool) -> Vec<AuditEntry> {
        let mut entries = std::mem::take(&mut self.first);
        self.sources.retain(|source, counted| {
            if now.saturating_duration_since(counted.since) < SUM_UP && !all {
                return true;
            }
            let goes_on = counted.count() > 0;
            if goes_on {
                entries.push(counted.sum(source));
            }
            counted.since = now;
            // Without further requests the next one counts as the first again.
            goes_on && !all
        });
        entries
    }

    /// Time until the next entry is due; `None` if nothing waits.
    pub(super) fn next(&self, now: Instant) -> Option<Duration> {
        if !self.first.is_empty() {
            return Some(Duration::ZERO);
        }
        self.sources.values().map(|counted| (counted.since + SUM_UP).saturating_duration_since(now)).min()
    }
}

/// Returns how many requests an entry stands for.
#[cfg(test)]
pub(super) fn requests_of(entry: &AuditEntry) -> u64 {
    let result = super::stored_message::from_stored(entry.result.clone());
    match (result.code.as_ref(), result.argument("n")) {
        ("server-audit-refused-sum" | "server-audit-repeated-sum", Some(Argument::Count(n))) => *n,
        _ => 1,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cell::stored_message::from_stored;

    fn words(column: &str) -> String {
        from_stored(column.to_owned()).to_string()
    }

    fn refused(user: &str, station: &str, command: &str) -> Repeatable {
        Repeatable {
            user: user.to_owned(),
            station: station.to_owned(),
            command: Message::verbatim(command),
            result: Message::new("server-audit-refused-role"),
            is_refused: true,
        }
    }

    #[test]
    fn repeated_refusals_become_one_entry_a_minute() {
        let (mut refusals, begin) = (Refusals::default(), Instant::now());
        (0..301).for_each(|_| refusals.add(&refused("eve", "panel at ::1", "users.read"), begin));
        (0..113).for_each(|_| refusals.add(&refused("eve", "panel at ::1", "job.write"), begin));
        assert_eq!(refusals.due(begin, false).len(), 2);
        assert!(refusals.due(begin + SUM_UP / 2, false).is_empty());
        let due = refusals.due(begin + SUM_UP, false);
        assert_eq!(due.len(), 1);
        let said = words(&due[0].result);
        assert!(said.starts_with("412 refused requests, first 20") && said.contains(" UTC, last 20"), "{said}");
        assert!(said.ends_with("users.read: refused: role (300), job.write: refused: role (112)"), "{said}");
        assert_eq!((due[0].user.as_str(), due[0].station.as_str()), ("eve", "panel at ::1"));
        assert_eq!((words(&due[0].command), requests_of(&due[0])), ("several requests".to_owned(), 412));
        // Those who go on are only summed up; after a pause the next one counts as the first again.
        refusals.add(&refused("eve", "panel at ::1", "job.write"), begin + SUM_UP);
        let due = refusals.due(begin + 2 * SUM_UP, false);
        assert_eq!((due.len(), words(&due[0].command).as_str(), requests_of(&due[0])), (1, "job.write", 1));
        assert!(refusals.due(begin + 3 * SUM_UP, false).is_empty());
        refusals.add(&refused("eve", "panel at ::1", "job.write"), begin + 3 * SUM_UP);
        assert_eq!(refusals.due(begin + 3 * SUM_UP, true).len(), 1);
        assert_eq!(refusals.next(begin), None);
    }

    /// Made-up names, addresses and requests take bounded memory and entries, and every one is counted.
    #[test]
    fn made_up_sources_and_kinds_take_bounded_memory_and_entries() {
        let max = (MAX_SOURCES + 2) * (MAX_KINDS + 1);
        for (users, stations, commands) in [(10_000, 1, 1), (1, 10_000, 1), (1, 1, 10_000), (97, 89, 83)] {
            let (mut refusals, begin) = (Refusals::default(), Instant::now());
            for i in 0..10_000 {
                let (user, station) = (format!("name {}", i % users), format!("address {}", i % stations));
                refusals.add(&refused(&user, &station, &format!("command {}", i % commands)), begin);
            }
            assert!(refusals.sources.len() <= MAX_SOURCES + 2);
            let entries = refusals.due(begin, true);
            assert!(entries.len() <= max, "{}", entries.len());
            assert_eq!(entries.iter().map(requests_of).sum::<u64>(), 10_000);
        }
    }

    /// One who floods from many places displaces no source of another user.
    #[test]
    fn a_flood_leaves_others_their_place() {
        let (mut refusals, now) = (Refusals::default(), Instant::now());
        (0..1000).for_each(|i| refusals.add(&refused("eve", &format!("address {i}"), "arm"), now));
        refusals.add(&refused("ada", "panel 1", "arm"), now);
        assert!(refusals.due(now, true).iter().any(|entry| entry.user == "ada" && entry.station == "panel 1"));
    }
}
