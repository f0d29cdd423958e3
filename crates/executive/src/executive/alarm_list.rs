use super::alarm::{Alarm, Reaction};
use super::command::Ask;
use super::port::Note;
use arrayvec::ArrayVec;
use seamwright_message::{Message, Unit};
use serde::{Deserialize, Serialize};

/// Position of the torch.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Place {
    /// The pass, counted from 1; 0 outside of all passes.
    pub pass: usize,
    /// Path length in it, mm.
    pub s_mm: f64,
}

/// State of an alarm (ISA-18.2, clause 5.5).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum AlarmState {
    /// Active and unacknowledged.
    Unacknowledged,
    /// Active and acknowledged.
    Acknowledged,
    /// Returned to normal, unacknowledged.
    Returned,
}

/// An alarm on the list.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Raised {
    /// The alarm.
    pub alarm: Alarm,
    /// Index of the axis, condition or process value, from 0; 0 if there is only one.
    pub detail: u8,
    /// Reaction of the cell.
    pub reaction: Reaction,
    /// Its state.
    pub state: AlarmState,
    /// True for the first alarm on an empty list.
    pub first_out: bool,
    /// Time of the alarm, s.
    pub t: f64,
    /// Torch position at the alarm.
    pub place: Place,
    /// Length of the gap in the cycle that raised it, s; only of [`Alarm::Overrun`].
    pub gap_s: Option<f64>,
}

impl Raised {
    /// Returns what it is about: the length of its gap, or [`Alarm::about`].
    pub fn about(&self, axes: &[&str], conditions: &[&str]) -> Option<Message> {
        match self.gap_s {
            Some(gap_s) => Some(Message::new("quantity").quantity("value", 1e3 * gap_s, Unit::Ms, 0)),
            None => self.alarm.about(self.detail, axes, conditions),
        }
    }

    /// Returns its cause, with the length of its gap.
    pub fn cause(&self) -> Message {
        match self.gap_s {
            Some(gap_s) => Message::new("alarm-19-cause-gap").quantity("gap", 1e3 * gap_s, Unit::Ms, 0),
            None => self.alarm.entry().cause,
        }
    }
}

/// Capacity of the alarm list: one entry for each alarm, axis and condition.
pub const MAX_ALARMS: usize = 160;

/// The active and the unacknowledged alarms. No alarm is lost: there is room for each alarm once with every detail.
#[derive(Debug, Clone, Default)]
pub struct AlarmList {
    list: ArrayVec<Raised, MAX_ALARMS>,
    /// Number of alarms lost on a full list.
    lost: u32,
}

impl AlarmList {
    /// Raises an alarm; returns its entry if it is new or more severe. The list decides on its state and on the
    /// first-out mark.
    pub fn raise(&mut self, new: Raised) -> Option<Raised> {
        let new = Raised { state: AlarmState::Unacknowledged, first_out: self.list.is_empty(), ..new };
        if let Some(known) = self.list.iter_mut().find(|r| r.alarm == new.alarm && r.detail == new.detail) {
            if known.state != AlarmState::Returned && new.reaction <= known.reaction {
                return None;
            }
            // It has returned, or its reaction is more severe: a new occurrence, but the first-out mark stays.
            *known = Raised { first_out: known.first_out, ..new };
            return Some(*known);
        }
        if self.list.try_push(new).is_err() {
            self.lost += 1;
        }
        Some(new)
    }

    /// Marks the cause of an alarm as gone; returns true if that is a change.
    pub fn clear(&mut self, alarm: Alarm, detail: u8) -> bool {
        let Some(i) = self.list.iter().position(|r| r.alarm == alarm && r.detail == detail) else { return false };
        match self.list[i].state {
            AlarmState::Unacknowledged => self.list[i].state = AlarmState::Returned,
            AlarmState::Acknowledged => drop(self.list.remove(i)),
            AlarmState::Returned => return false,
        }
        true
    }

    /// Updates a copy of the executive's list from its notes; returns true if the copy has changed.
    pub fn follow(&mut self, note: &Note) -> bool {
        match note {
            Note::Alarm(r) => {
                self.raise(*r);
                // A momentary alarm.
                if r.state == AlarmState::Returned {
                    self.clear(r.alarm, r.detail);
                }
            }
            Note::Cleared(alarm, detail) => drop(self.clear(*alarm, *detail)),
            Note::Taken(command) => match command.ask {
                Ask::Acknowledge => drop(self.acknowledge()),
                Ask::AcknowledgeOne(alarm, detail) => return self.acknowledge_one(alarm, detail),
                _ => return false,
            },
            _ => return false,
        }
        true
    }

    /// Acknowledges all alarms; returns how many were unacknowledged.
    pub fn acknowledge(&mut self) -> usize {
        let before = self.list.iter().filter(|r| r.state != AlarmState::Acknowledged).count();
        self.list.retain(|r| r.state != AlarmState::Returned);
        self.list.iter_mut().for_each(|r| r.state = AlarmState::Acknowledged);
        before
    }

    /// Acknowledges one alarm; returns true if it was unacknowledged. The other alarms do not change.
    pub fn acknowledge_one(&mut self, alarm: Alarm, detail: u8) -> bool {
        let Some(i) = self.list.iter().position(|r| r.alarm == alarm && r.detail == detail) else { return false };
        match self.list[i].state {
            AlarmState::Acknowledged => return false,
            AlarmState::Unacknowledged => self.list[i].state = AlarmState::Acknowledged,
            AlarmState::Returned => drop(self.list.remove(i)),
        }
        true
    }

    /// Returns true if the alarm is active.
    pub fn is_active(&self, alarm: Alarm, detail: u8) -> bool {
        self.list.iter().any(|r| r.alarm == alarm && r.detail == detail && r.state != AlarmState::Returned)
    }

    /// Returns all alarms on the list, in the order of their arrival.
    pub fn iter(&self) -> impl Iterator<Item = &Raised> {
        self.list.iter()
    }

    /// Returns the first-out alarm.
    pub fn first(&self) -> Option<&Raised> {
        self.list.iter().find(|r| r.first_out).or(self.list.first())
    }

    /// Returns the number of alarms lost on a full list.
    pub fn lost(&self) -> u32 {
        self.lost
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const HERE: Place = Place { pass: 1, s_mm: 5.0 };

    fn new(alarm: Alarm, detail: u8, reaction: Reaction) -> Raised {
        let state = AlarmState::Unacknowledged;
        Raised { alarm, detail, reaction, state, first_out: false, t: 1.0, place: HERE, gap_s: None }
    }

    fn raise(list: &mut AlarmList, alarm: Alarm, detail: u8) -> Option<Raised> {
        list.raise(new(alarm, detail, alarm.reaction()))
    }

    #[test]
    fn alarms_live_as_the_standard_says() {
        let list = &mut AlarmList::default();
        assert!(raise(list, Alarm::ArcLost, 0).unwrap().first_out);
        assert!(raise(list, Alarm::ArcLost, 0).is_none());
        assert!(!raise(list, Alarm::FollowingError, 2).unwrap().first_out);
        // Cleared before its acknowledgement: still on the list; raised again: new.
        assert!(list.clear(Alarm::ArcLost, 0) && !list.clear(Alarm::ArcLost, 0));
        assert_eq!(list.first().unwrap().alarm, Alarm::ArcLost);
        assert!(!list.is_active(Alarm::ArcLost, 0));
        assert!(raise(list, Alarm::ArcLost, 0).unwrap().first_out);
        assert_eq!(list.acknowledge(), 2);
        assert_eq!(list.acknowledge(), 0);
        assert!(list.clear(Alarm::ArcLost, 0));
        assert_eq!(list.iter().count(), 1);
        assert!(list.clear(Alarm::FollowingError, 2) && list.first().is_none());
        // The next one is first-out again; a returned alarm leaves the list when acknowledged.
        assert!(raise(list, Alarm::Overrun, 0).unwrap().first_out);
        list.clear(Alarm::Overrun, 0);
        assert_eq!(list.acknowledge(), 1);
        assert_eq!(list.iter().count(), 0);
    }

    /// Random alarms come, go and are acknowledged one by one or all. The state of each follows from its own history,
    /// independent of the others.
    #[test]
    fn one_alarm_is_acknowledged_without_the_others() {
        let mut state = 5u64;
        let mut below = |n: u64| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) % n
        };
        let list = &mut AlarmList::default();
        // Each alarm: active, acknowledged.
        let mut each = [(false, true); 6];
        for step in 0..20_000 {
            let k = below(6) as usize;
            let (alarm, detail) = (Alarm::ALL[k / 2], (k % 2) as u8);
            let (there, known) = each[k];
            match below(4) {
                0 => {
                    assert_eq!(raise(list, alarm, detail).is_some(), !there, "{step}");
                    each[k] = (true, there && known);
                }
                1 => {
                    assert_eq!(list.clear(alarm, detail), there, "{step}");
                    each[k] = (false, known);
                }
                2 => {
                    assert_eq!(list.acknowledge_one(alarm, detail), !known, "{step}");
                    each[k] = (there, true);
                }
                _ if below(8) == 0 => {
                    list.acknowledge();
                    each.iter_mut().for_each(|one| one.1 = true);
                }
                _ => {}
            }
            for (k, (there, known)) in each.iter().enumerate() {
                let found = list.iter().find(|r| r.alarm == Alarm::ALL[k / 2] && usize::from(r.detail) == k % 2);
                let wanted = match (there, known) {
                    (true, false) => Some(AlarmState::Unacknowledged),
                    (true, true) => Some(AlarmState::Acknowledged),
                    (false, false) => Some(AlarmState::Returned),
                    (false, true) => None,
                };
                assert_eq!(found.map(|r| r.state), wanted, "{step}");
            }
        }
    }

    #[test]
    fn what_grows_worse_is_news() {
        let list = &mut AlarmList::default();
        assert!(list.raise(new(Alarm::Tracking, 3, Reaction::Tell)).is_some());
        list.acknowledge();
        assert!(list.raise(new(Alarm::Tracking, 3, Reaction::Tell)).is_none());
        let worse = list.raise(new(Alarm::Tracking, 3, Reaction::ProcessOff)).unwrap();
        assert_eq!((worse.reaction, worse.state), (Reaction::ProcessOff, AlarmState::Unacknowledged));
        assert!(list.raise(new(Alarm::Tracking, 3, Reaction::Hold)).is_none());
    }

    #[test]
    fn a_full_list_tells_what_it_lost() {
        let list = &mut AlarmList::default();
        for detail in 0..=u8::MAX {
            raise(list, Alarm::Interlock, detail);
        }
        assert_eq!((list.iter().count(), list.lost()), (MAX_ALARMS, 256 - MAX_ALARMS as u32));
    }
}
