//! Queues of the archive, bounded in entries and in bytes.

use seamwright_message::Message;
use seamwright_record::Moment;
use seamwright_record::library::{AuditEntry, PendingEntry};
use std::collections::VecDeque;

/// Maximum number of alarms, and of orders, that wait for the disk. Further ones are only counted: a stop never waits
/// for a disk.
pub(super) const MAX_ENTRIES: usize = 65_536;
/// Maximum memory of each of both, bytes.
const MAX_BYTES: usize = 16 << 20;
/// Maximum number of entries of one transaction.
const BATCH: usize = 256;

/// Classes of entries, the first to be stored first.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Class {
    /// Alarms and acknowledgements.
    Alarms,
    Orders,
    /// Sums of refusals, and of lost entries.
    Sums,
}

const CLASSES: [Class; 3] = [Class::Alarms, Class::Orders, Class::Sums];

/// Entries of one class to be stored together.
pub(super) struct Work {
    pub(super) class: Class,
    pub(super) entries: Vec<PendingEntry>,
    /// An earlier run may have stored them.
    pub(super) is_again: bool,
}

#[derive(Debug)]
struct Item {
    entry: PendingEntry,
    bytes: usize,
    /// It is in the file too.
    is_kept: bool,
    /// An earlier run left it in the file.
    is_again: bool,
}

#[derive(Debug, Default)]
struct Queue {
    items: VecDeque<Item>,
    bytes: usize,
}

impl Queue {
    fn push(&mut self, entry: PendingEntry, is_again: bool) {
        let bytes = entry.memory_bytes();
        self.bytes += bytes;
        self.items.push_back(Item { entry, bytes, is_kept: is_again, is_again });
    }

    fn pop(&mut self) {
        if let Some(item) = self.items.pop_front() {
            self.bytes -= item.bytes;
        }
    }
}

/// Entries lost for lack of room, since they were last reported in the log.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Lost {
    pub(super) count: u64,
    pub(super) first: Moment,
    pub(super) last: Moment,
}

/// Queues of all classes.
#[derive(Debug)]
pub(super) struct Queues {
    queues: [Queue; CLASSES.len()],
    max_entries: usize,
    lost: Option<Lost>,
    lost_ever: u64,
    /// Number of sums added so far.
    sums: u64,
}

impl Default for Queues {
    fn default() -> Self {
        Self::with_room(MAX_ENTRIES)
    }
}

impl Queues {
    pub(super) fn with_room(max_entries: usize) -> Self {
        let queues = std::array::from_fn(|_| Queue::default());
        Self { queues, max_entries, lost: None, lost_ever: 0, sums: 0 }
    }

    /// Adds an entry, or counts it as lost if the queue is full.
    pub(super) fn add(&mut self, class: Class, entry: PendingEntry) {
        let queue = &mut self.queues[class as usize];
        if queue.items.len() < self.max_entries && queue.bytes < MAX_BYTES {
            queue.push(entry, false);
        } else {
            self.lose();
        }
    }

    /// Adds entries that an earlier run left.
    pub(super) fn add_again(&mut self, entries: Vec<PendingEntry>) {
        for entry in entries {
            let class = if matches!(entry, PendingEntry::Audit(_)) { Class::Orders } else { Class::Alarms };
            self.queues[class as usize].push(entry, true);
        }
    }

    /// Returns true once earlier sums are stored.
    pub(super) fn has_room_for_sums(&self) -> bool {
        self.queues[Class::Sums as usize].items.is_empty()
    }

    pub(super) fn add_sums(&mut self, sums: Vec<AuditEntry>) {
        self.sums += sums.len() as u64;
        let queue = &mut self.queues[Class::Sums as usize];
        sums.into_iter().for_each(|sum| queue.push(PendingEntry::Audit(sum), false));
    }

    /// Returns the sums that were added after the first `known` ones, and counts them as known.
    pub(super) fn new_sums(&self, known: &mut u64) -> Vec<PendingEntry> {
        let new = usize::try_from(self.sums - *known).unwrap_or(usize::MAX);
        *known = self.sums;
        let items = &self.queues[Class::Sums as usize].items;
        items.iter().skip(items.len().saturating_sub(new)).map(|item| item.entry.clone()).collect()
    }

    /// Returns the first entries of the first class that has some; none if all are empty.
    pub(super) fn next(&self) -> Work {
        for class in CLASSES {
            let items = &self.queues[class as usize].items;
            if let Some(first) = items.front() {
                let alike = items.iter().take(BATCH).take_while(|item| item.is_again == first.is_again);
                let entries = alike.map(|item| item.entry.clone()).collect();
                return Work { class, entries, is_again: first.is_again };
            }
        }
        Work { class: Class::Sums, entries: Vec::new(), is_again: false }
    }

    /// Removes the first entries of a class: the library has them.
    pub(super) fn remove(&mut self, class: Class, count: usize) {
        (0..count).for_each(|_| self.queues[class as usize].pop());
    }

    /// Removes the first entry of a class, which the library refuses.
    pub(super) fn lose_first(&mut self, class: Class) {
        self.queues[class as usize].pop();
        self.lose();
    }

    fn lose(&mut self) {
        let at = Moment::now();
        self.lost_ever += 1;
        let lost = self.lost.get_or_insert(Lost { count: 0, first: at, last: at });
        (lost.count, lost.last) = (lost.count + 1, at);
    }

    /// Takes the entries lost since the last call.
    pub(super) fn take_lost(&mut self) -> Option<Lost> {
        self.lost.take()
    }

    /// Number of entries lost so far.
    pub(super) fn lost_ever(&self) -> u64 {
        self.lost_ever
    }

    /// Number of entries that wait.
    pub(super) fn len(&self) -> usize {
        self.queues.iter().map(|queue| queue.items.len()).sum()
    }

    /// Returns the first entries of a class that are not in the file.
    pub(super) fn not_kept(&self) -> (Class, Vec<PendingEntry>) {
        for class in CLASSES {
            let items = self.queues[class as usize].items.iter().filter(|item| !item.is_kept);
            let entries: Vec<PendingEntry> = items.take(BATCH).map(|item| item.entry.clone()).collect();
            if !entries.is_empty() {
                return (class, entries);
            }
        }
        (Class::Sums, Vec::new())
    }

    /// Number of entries that are not in the file.
    pub(super) fn not_kept_len(&self) -> usize {
        self.queues.iter().flat_map(|queue| &queue.items).filter(|item| !item.is_kept).count()
    }

    /// Marks the first entries of a class that are not in the file as kept there.
    pub(super) fn mark_kept(&mut self, class: Class, count: usize) {
        let items = self.queues[class as usize].items.iter_mut().filter(|item| !item.is_kept);
        items.take(count).for_each(|item| item.is_kept = true);
    }

    /// Returns true if an acknowledgement of this alarm, or of all, waits behind the last alarm.
    pub(super) fn acknowledges(&self, name: Option<&Message>) -> bool {
        let entries = self.queues[Class::Alarms as usize].items.iter().rev().map(|item| &item.entry);
        let after = entries.take_while(|entry| !matches!(entry, PendingEntry::Alarm { .. }));
        after.into_iter().any(|entry| {
            matches!(entry, PendingEntry::Acknowledge { name: known, .. } if known.is_none() || known.as_ref() == name)
        })
    }
}
