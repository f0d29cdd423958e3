//! Refusals on their way to the audit log: counted and summed up, so that repetition fills neither queue nor disk.

use super::audit_entry::{Change, entry};
use super::stored_message::stored;
use seamwright_message::{Message, Unit};
use seamwright_record::library::AuditEntry;
use std::collections::HashMap;
use std::time::{Duration, Instant};

/// After the first refusal of a kind, further ones are counted for this time and written as one entry.
const SUM_UP: Duration = Duration::from_secs(60);
/// Maximum number of kinds counted at a time; all others share one more kind.
const MAX_KINDS: usize = 64;

/// Kind of a refusal: user, command and result.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
struct Kind {
    user: String,
    command: String,
    result: String,
}

/// Refusals of a kind since its last entry.
#[derive(Debug)]
struct Counted {
    station: String,
    result: Message,
    since: Instant,
    count: u64,
}

/// Refusals not written yet.
#[derive(Debug, Default)]
pub(super) struct Refusals {
    kinds: HashMap<Kind, Counted>,
    first: Vec<AuditEntry>,
}

impl Refusals {
    /// Counts a refusal; the first of its kind gets an entry at once.
    pub(super) fn add(&mut self, user: &str, station: &str, command: &str, result: &Message, now: Instant) {
        let result_text = stored(result.clone());
        let mut kind = Kind { user: user.to_owned(), command: command.to_owned(), result: result_text.clone() };
        if self.kinds.len() >= MAX_KINDS && !self.kinds.contains_key(&kind) {
            (kind.user, kind.command) = (String::new(), stored(Message::new("server-audit-others")));
        }
        if let Some(counted) = self.kinds.get_mut(&kind) {
            counted.count += 1;
            return;
        }
        self.first.push(entry(&kind.user, station, &kind.command, Change::default(), &result_text));
        let (station, result) = (station.to_owned(), result.clone());
        self.kinds.insert(kind, Counted { station, result, since: now, count: 0 });
    }

    /// Takes the entries that are due; `all`: also those still being counted.
    pub(super) fn due(&mut self, now: Instant, all: bool) -> Vec<AuditEntry> {
        let mut entries = std::mem::take(&mut self.first);
        self.kinds.retain(|kind, counted| {
            let elapsed = now.saturating_duration_since(counted.since);
            if elapsed < SUM_UP && !all {
                return true;
            }
            if counted.count > 0 {
                let result = Message::new("server-audit-more").message("result", counted.result.clone());
                let result = result.count("n", counted.count as usize);
                let result = stored(result.quantity("time", elapsed.as_secs_f64().ceil(), Unit::S, 0));
                entries.push(entry(&kind.user, &counted.station, &kind.command, Change::default(), &result));
            }
            let goes_on = counted.count > 0 && !all;
            (counted.count, counted.since) = (0, now);
            goes_on
        });
        entries
    }

    /// Time until the next entry is due; `None` if nothing waits.
    pub(super) fn next(&self, now: Instant) -> Option<Duration> {
        if !self.first.is_empty() {
            return Some(Duration::ZERO);
        }
        self.kinds.values().map(|counted| (counted.since + SUM_UP).saturating_duration_since(now)).min()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cell::stored_message::from_stored;

    fn words(entry: &AuditEntry) -> String {
        from_stored(entry.result.clone()).to_string()
    }

    #[test]
    fn repeated_refusals_become_one_entry_a_minute() {
        let (mut refusals, begin) = (Refusals::default(), Instant::now());
        (0..313).for_each(|_| {
            refusals.add("eve", "panel", "users.read", &Message::new("server-audit-refused-role"), begin);
        });
        assert_eq!(refusals.due(begin, false).len(), 1);
        assert!(refusals.due(begin + SUM_UP / 2, false).is_empty());
        let due = refusals.due(begin + SUM_UP, false);
        assert_eq!(due.len(), 1);
        assert_eq!((due[0].user.as_str(), words(&due[0])), ("eve", "refused: role: 312 more in 60 s".to_owned()));
        // Without further refusals the next one counts as the first again.
        assert!(refusals.due(begin + 2 * SUM_UP, false).is_empty());
        refusals.add("eve", "panel", "users.read", &Message::new("server-audit-refused-role"), begin + 2 * SUM_UP);
        assert_eq!(refusals.due(begin + 2 * SUM_UP, true).len(), 1);
        assert_eq!(refusals.next(begin), None);
    }

    #[test]
    fn made_up_names_take_bounded_memory_and_entries() {
        let (mut refusals, begin) = (Refusals::default(), Instant::now());
        (0..10_000).for_each(|i| {
            refusals.add(&format!("name {i}"), "panel", "log in", &Message::new("server-audit-refused"), begin);
        });
        let entries = refusals.due(begin, true);
        assert!(entries.len() <= MAX_KINDS + 2, "{}", entries.len());
        let summed: u64 = entries.iter().filter_map(|e| words(e).split(' ').nth(1)?.parse::<u64>().ok()).sum();
        let firsts = entries.iter().filter(|e| words(e) == "refused").count() as u64;
        assert_eq!(summed + firsts, 10_000);
    }
}
