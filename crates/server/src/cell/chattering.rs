//! Chattering alarms (ISA-18.2): the same alarm comes and goes many times a minute.

use seamwright_message::Message;
use std::collections::HashMap;
use std::time::{Duration, Instant};

/// Interval in which occurrences are counted.
const MINUTE: Duration = Duration::from_secs(60);
/// Number of occurrences in a minute from which an alarm chatters.
const CHATTERS: u32 = 3;
/// Maximum number of occurrences of an alarm that are stored in a minute; further ones are counted.
const MAX_STORED: u32 = 10;
/// Maximum number of alarms that are counted: more than a cell can have.
const MAX_ALARMS: usize = 512;

/// Occurrences of alarms within a minute.
#[derive(Debug, Default)]
pub(super) struct Occurrences {
    of: HashMap<String, Counted>,
}

#[derive(Debug)]
struct Counted {
    since: Instant,
    count: u32,
}

impl Occurrences {
    /// Counts an occurrence. Returns the number within a minute, this one included.
    fn count(&mut self, alarm: &str, now: Instant) -> u32 {
        if self.of.len() >= MAX_ALARMS {
            self.of.retain(|_, counted| now.saturating_duration_since(counted.since) < MINUTE);
        }
        if self.of.len() >= MAX_ALARMS && !self.of.contains_key(alarm) {
            return 1;
        }
        let counted = self.of.entry(alarm.to_owned()).or_insert(Counted { since: now, count: 0 });
        if now.saturating_duration_since(counted.since) >= MINUTE {
            *counted = Counted { since: now, count: 0 };
        }
        counted.count += 1;
        counted.count
    }

    /// Counts an occurrence. Returns true if it is too many to be stored.
    pub(super) fn is_flood(&mut self, name: &Message, now: Instant) -> bool {
        self.count(&name.as_data(), now) > MAX_STORED
    }

    /// Counts an occurrence. Returns true if the alarm chatters.
    pub(super) fn chatters(&mut self, alarm: u8, detail: u8, now: Instant) -> bool {
        self.count(&format!("{alarm} {detail}"), now) >= CHATTERS
    }

    /// Forgets all: the next occurrence after an acknowledgement is stored in any case.
    pub(super) fn forget(&mut self) {
        self.of.clear();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_alarm_chatters_from_the_third_occurrence_in_a_minute() {
        let (mut occurrences, begin) = (Occurrences::default(), Instant::now());
        let at = |s: u64| begin + Duration::from_secs(s);
        assert!(!occurrences.chatters(4, 0, at(0)) && !occurrences.chatters(4, 0, at(1)));
        assert!(!occurrences.chatters(4, 1, at(2)) && occurrences.chatters(4, 0, at(3)));
        assert!(!occurrences.chatters(4, 0, at(61)));
    }

    #[test]
    fn a_flood_is_bounded_and_memory_too() {
        let (mut occurrences, begin) = (Occurrences::default(), Instant::now());
        let name = Message::new("alarm-1-title");
        let stored = (0..1000).filter(|_| !occurrences.is_flood(&name, begin)).count();
        assert_eq!(stored, MAX_STORED as usize);
        occurrences.forget();
        assert!(!occurrences.is_flood(&name, begin));
        for i in 0..10_000 {
            occurrences.is_flood(&Message::verbatim(format!("{i}")), begin);
        }
        assert!(occurrences.of.len() <= MAX_ALARMS);
    }
}
