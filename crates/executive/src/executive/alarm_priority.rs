//! Rationalisation of alarms (ISA-18.2, clause 6): severity of the consequence, time to respond, and the priority that
//! follows from both.
//!
//! The consequence is that of no operator action *after the reaction of the cell*: the cell has already switched off
//! what endangers people or part. The priority gives the operator the order of actions.

use super::alarm::{Alarm, Reaction};
use seamwright_message::named_enum;

named_enum! {
    /// Severity of the consequence if the operator does not act, the mildest first.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
    pub enum Severity {
        /// Time is lost.
        Minor => "minor", "alarm-severity-minor";
        /// The weld must be repaired, or its record is incomplete.
        Moderate => "moderate", "alarm-severity-moderate";
        /// Part or machine is damaged.
        Major => "major", "alarm-severity-major";
        /// People are endangered, or the part is lost.
        Severe => "severe", "alarm-severity-severe";
    }
}

named_enum! {
    /// Time until an operator action is too late, the shortest first.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
    pub enum ResponseTime {
        /// Less than one minute.
        Minute => "minute", "alarm-response-minute";
        /// One to ten minutes.
        TenMinutes => "ten minutes", "alarm-response-ten-minutes";
        /// More than ten minutes.
        Longer => "longer", "alarm-response-longer";
    }
}

named_enum! {
    /// Priority of an alarm, the most urgent first.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
    pub enum Priority {
        /// Act at once.
        Critical => "critical", "alarm-priority-critical";
        /// Act before anything else.
        High => "high", "alarm-priority-high";
        /// Act soon.
        Medium => "medium", "alarm-priority-medium";
        /// Act before the next start.
        Low => "low", "alarm-priority-low";
    }
}

impl Priority {
    /// Returns the priority of a consequence that can be averted within `response`.
    pub fn of(severity: Severity, response: ResponseTime) -> Self {
        use ResponseTime::{Longer, Minute, TenMinutes};
        match (severity, response) {
            (Severity::Severe, Minute) => Self::Critical,
            (Severity::Severe, TenMinutes) | (Severity::Major, Minute) => Self::High,
            (Severity::Severe, Longer) | (Severity::Major, TenMinutes) | (Severity::Moderate, Minute) => Self::Medium,
            (Severity::Major | Severity::Moderate | Severity::Minor, _) => Self::Low,
        }
    }
}

/// Result of the rationalisation of an alarm.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Rationalisation {
    /// Reaction of the cell.
    pub reaction: Reaction,
    /// Severity of the consequence without an operator action.
    pub severity: Severity,
    /// Time to respond.
    pub response: ResponseTime,
}

const fn row(reaction: Reaction, severity: Severity, response: ResponseTime) -> Rationalisation {
    Rationalisation { reaction, severity, response }
}

impl Rationalisation {
    /// Its priority.
    pub fn priority(self) -> Priority {
        Priority::of(self.severity, self.response)
    }
}

impl Alarm {
    /// Returns the row of this alarm in the table of rationalisation, for the reaction of the catalogue.
    pub fn rationalisation(self) -> Rationalisation {
        use Reaction::{Hold, PowerOff, ProcessOff, Stop, Tell};
        use ResponseTime::{Longer, Minute, TenMinutes};
        use Severity::{Major, Minor, Moderate, Severe};
        match self {
            Self::Interlock => row(Tell, Minor, Longer),
            Self::DriveFault => row(PowerOff, Major, TenMinutes),
            Self::LimitSwitch => row(PowerOff, Major, Longer),
            Self::FollowingError => row(Stop, Major, TenMinutes),
            Self::DrivePower => row(PowerOff, Major, TenMinutes),
            // Whether they obeyed the order to stop is unknown.
            Self::DrivesSilent => row(PowerOff, Major, Minute),
            Self::DrivesRestarted => row(PowerOff, Minor, Longer),
            Self::NoReference => row(Tell, Minor, Longer),
            Self::InputsSilent => row(Stop, Moderate, TenMinutes),
            Self::InputsRestarted => row(Stop, Moderate, Longer),
            Self::SourceSilent => row(ProcessOff, Moderate, TenMinutes),
            Self::SourceRestarted => row(ProcessOff, Moderate, Longer),
            Self::SourceFault => row(ProcessOff, Moderate, TenMinutes),
            Self::NoArc => row(ProcessOff, Minor, Longer),
            Self::ArcLost => row(ProcessOff, Moderate, TenMinutes),
            // The cell has no other way to switch it off.
            Self::ProcessStuckOn => row(PowerOff, Severe, Minute),
            Self::ProcessValue => row(Hold, Moderate, Longer),
            Self::WireStuck => row(Hold, Moderate, TenMinutes),
            Self::Overrun => row(Stop, Moderate, TenMinutes),
            Self::MotionStuck => row(ProcessOff, Moderate, TenMinutes),
            Self::PanelSilent => row(Tell, Minor, Longer),
            Self::JogStopped => row(Tell, Minor, Longer),
            // The weld goes on: each minute more of it has no record.
            Self::RecordFailing => row(Tell, Moderate, Minute),
            Self::Tracking => row(ProcessOff, Moderate, TenMinutes),
            Self::Starved => row(Stop, Moderate, Longer),
        }
    }

    /// Returns the rationalisation of an occurrence with `reaction`: the level of an interlock and the state of tracking
    /// change it.
    pub fn rationalised_with(self, reaction: Reaction) -> Rationalisation {
        match (self, reaction) {
            // Lost vacuum, gas or coolant where it was needed.
            (Self::Interlock, Reaction::Tell) => self.rationalisation(),
            (Self::Interlock, _) => row(reaction, Severity::Major, ResponseTime::TenMinutes),
            // A warning: the weld goes on and may miss the joint.
            (Self::Tracking, Reaction::Tell) => row(reaction, Severity::Moderate, ResponseTime::Minute),
            _ => Rationalisation { reaction, ..self.rationalisation() },
        }
    }

    /// Returns the priority of an occurrence with `reaction`.
    pub fn priority(self, reaction: Reaction) -> Priority {
        self.rationalised_with(reaction).priority()
    }

    /// Returns true if an occurrence with `reaction` may be shelved: it only informs. An unmet interlock also only
    /// informs, but prevents starts.
    pub fn is_shelvable(self, reaction: Reaction) -> bool {
        reaction == Reaction::Tell && self != Self::Interlock
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// More severe or more urgent never lowers the priority.
    #[test]
    fn priority_grows_with_severity_and_urgency() {
        for severity in Severity::ALL {
            for response in ResponseTime::ALL {
                let priority = Priority::of(severity, response);
                for worse in Severity::ALL.into_iter().filter(|worse| *worse >= severity) {
                    for sooner in ResponseTime::ALL.into_iter().filter(|sooner| *sooner <= response) {
                        assert!(Priority::of(worse, sooner) <= priority, "{worse:?} {sooner:?}");
                    }
                }
            }
        }
    }

    /// The shares stay near the advice of ISA-18.2: about 5 % high (with critical), 15 % medium, 80 % low.
    #[test]
    fn few_alarms_are_urgent() {
        let count = |wanted: &[Priority]| {
            Alarm::ALL.into_iter().filter(|alarm| wanted.contains(&alarm.rationalisation().priority())).count()
        };
        let part = |wanted: &[Priority]| count(wanted) as f64 / Alarm::ALL.len() as f64;
        assert!(part(&[Priority::Critical, Priority::High]) <= 0.10);
        assert!((0.10..=0.20).contains(&part(&[Priority::Medium])));
        assert!(part(&[Priority::Low]) >= 0.70);
    }

    #[test]
    fn an_occurrence_that_stops_more_is_never_less_urgent() {
        let interlock = |reaction| Alarm::Interlock.priority(reaction);
        assert_eq!(interlock(Reaction::Tell), Priority::Low);
        assert_eq!(interlock(Reaction::PowerOff), Priority::Medium);
        assert_eq!(Alarm::Tracking.priority(Reaction::Tell), Priority::Medium);
        assert_eq!(Alarm::ProcessStuckOn.priority(Reaction::PowerOff), Priority::Critical);
        for alarm in Alarm::ALL {
            assert!(!alarm.is_shelvable(Reaction::Hold), "{alarm:?}");
        }
    }
}
