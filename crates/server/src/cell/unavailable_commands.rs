//! Commands that have no effect at the moment, with the reason: the panel greys them.

use super::names::Names;
use crate::refusal::{Lack, lack};
use crate::wire::{AskView, RefusedView};
use seamwright_executive::realtime::Shown;
use seamwright_executive::{Alarm, Ask, Missing, Mode};
use seamwright_message::{Argument, Message, Unit};

/// Commands that a mode can refuse; all others have an effect in every mode.
const COMMANDS: [AskView; 13] = [
    AskView::SwitchOn {},
    AskView::SwitchOff {},
    AskView::Home { axis: None },
    AskView::StartJog {},
    AskView::StartTeach {},
    AskView::StartDryRun {},
    AskView::Arm {},
    AskView::StartWeld { reweld: false },
    AskView::Hold {},
    AskView::Resume {},
    AskView::Reverse {},
    AskView::Stop {},
    AskView::Reset {},
];

/// Converts a command for the executive; returns it with its name in the table of permissions
/// and in [`RefusedView`].
pub(crate) fn executive_command(ask: &AskView) -> Result<(&'static str, Ask), Lack> {
    Ok(match ask {
        AskView::SwitchOn {} => ("switch_on", Ask::SwitchOn),
        AskView::SwitchOff {} => ("switch_off", Ask::SwitchOff),
        AskView::Home { axis: None } => ("home", Ask::Home),
        AskView::Home { axis: Some(axis) } => ("home", Ask::HomeAxis(*axis)),
        AskView::StartJog {} => ("start_jog", Ask::StartJog),
        AskView::StartTeach {} => ("start_teach", Ask::StartTeach),
        AskView::StartDryRun {} => ("start_dry_run", Ask::StartDryRun),
        AskView::Arm {} => ("arm", Ask::Arm),
        AskView::StartWeld { .. } => ("start_weld", Ask::StartWeld),
        AskView::Hold {} => ("hold", Ask::Hold),
        AskView::Resume {} => ("resume", Ask::Resume),
        AskView::Reverse {} => ("reverse", Ask::Reverse),
        AskView::Stop {} => ("stop", Ask::Stop),
        AskView::Override { part } if (0.0..=1.0).contains(part) => ("override", Ask::Override(*part)),
        AskView::Override { part } => {
            return Err(lack("value", Message::new("server-override-range").value("value", *part, Unit::One)));
        }
        AskView::Reset {} => ("reset", Ask::Reset),
        AskView::Acknowledge { one: None } => ("acknowledge", Ask::Acknowledge),
        AskView::Acknowledge { one: Some((number, detail)) } => {
            let alarm = Alarm::ALL.into_iter().find(|alarm| alarm.number() == usize::from(*number));
            let alarm = alarm.ok_or_else(|| {
                lack(
                    "value",
                    Message::new("server-no-alarm")
                        .number("number", f64::from(*number), 0)
                        .count("max", Alarm::ALL.len()),
                )
            })?;
            ("acknowledge", Ask::AcknowledgeOne(alarm, *detail))
        }
    })
}

/// Part of the cell's state that decides which commands it would refuse whatever else is missing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Readiness {
    mode: Mode,
    powered: bool,
    /// The program that runs, or ran last, welds.
    welds: bool,
    /// Axes may move; in a hold: they do.
    moves: bool,
}

impl Readiness {
    /// Returns the state at a cycle, `before` being that of the last one.
    pub(super) fn at(shown: &Shown, before: Option<Self>) -> Self {
        let welds = match shown.mode {
            Mode::Weld => true,
            Mode::DryRun => false,
            _ => before.is_some_and(|before| before.welds),
        };
        let moves = shown.mode.moves() || shown.mode == Mode::Hold && !shown.orders.rests();
        Self { mode: shown.mode, powered: shown.orders.power && shown.reports.drives.powered, welds, moves }
    }

    fn lack(self, ask: &Ask, names: &Names) -> Option<Lack> {
        let at_rest = match ask {
            Ask::Hold => !self.moves,
            Ask::Stop => !self.moves && self.mode != Mode::Hold,
            _ => {
                let missing = ask.refused_in(self.mode, self.welds, self.powered)?;
                let is_mode = matches!(missing, Missing::Mode(_));
                return Some(if is_mode { self.wrong_mode(ask) } else { names.lack(missing) });
            }
        };
        at_rest.then(|| lack("at_rest", Message::new("server-at-rest")))
    }

    /// Names the modes in which the command itself is possible: resuming and starting are the same event.
    fn wrong_mode(self, ask: &Ask) -> Lack {
        let modes = Mode::ALL.into_iter().filter(|mode| ask.refused_in(*mode, self.welds, true).is_none());
        let message = Message::new("cell-refused").message("event", ask.message()).message("mode", self.mode.message());
        lack("mode", message.list("modes", modes.map(|mode| Argument::Message(Box::new(mode.message())))))
    }

    /// Returns the commands without effect, with the reasons.
    pub(super) fn refused(self, names: &Names) -> Vec<RefusedView> {
        let refused = |ask: &AskView| {
            let (name, ask) = executive_command(ask).ok()?;
            Some(RefusedView { ask: name.to_owned(), why: self.lack(&ask, names)?.into() })
        };
        COMMANDS.iter().filter_map(refused).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use seamwright_executive::{Orders, Place, ProcessState, Reports, Status};
    use seamwright_machine::{Machine, shipped};

    /// Returns the commands that have an effect, by their names.
    fn possible(mode: Mode, powered: bool, welds: bool, moves: bool) -> String {
        let machine = Machine::read("m.toml", shipped("saddle-4axis").unwrap().text).unwrap();
        let names = Names { machine, fingerprint: String::new(), values: 0, heads: 0 };
        let refused = Readiness { mode, powered, welds, moves }.refused(&names);
        let is_possible = |name: &&str| refused.iter().all(|of| of.ask != *name);
        let commands = COMMANDS.iter().map(|ask| executive_command(ask).unwrap().0);
        commands.filter(is_possible).collect::<Vec<_>>().join(" ")
    }

    #[test]
    fn a_command_is_possible_where_mode_and_power_allow_it_and_it_has_an_effect() {
        let starts = "home start_jog start_teach start_dry_run arm start_weld";
        assert_eq!(possible(Mode::Off, false, false, false), "switch_on");
        assert_eq!(possible(Mode::Idle, true, false, false), "switch_off home");
        assert_eq!(possible(Mode::Ready, true, false, false), format!("switch_off {starts}"));
        assert_eq!(possible(Mode::Ready, false, false, false), "switch_off", "the drives have no power yet");
        assert_eq!(possible(Mode::Jog, true, false, true), "hold stop");
        assert_eq!(possible(Mode::Weld, true, true, true), "hold stop");
        assert_eq!(possible(Mode::Hold, true, true, false), "arm resume reverse stop");
        assert_eq!(possible(Mode::Hold, true, false, true), "hold resume reverse stop", "a dry run goes on dry");
        assert_eq!(possible(Mode::Fault, false, false, false), "reset");
        let ready = Readiness { mode: Mode::Ready, powered: true, welds: true, moves: false };
        let resume = ready.wrong_mode(&Ask::Resume).message.to_string();
        assert!(resume.contains("resume") && resume.ends_with("allowed in hold"), "{resume}");
    }

    /// On a transfer move there is no path speed: the motion of the axes shows that a held program moves.
    #[test]
    fn a_held_program_moves_while_its_axes_do() {
        let (place, process) = (Place::default(), ProcessState::Off);
        let mut shown = Shown {
            cycle: 1,
            status: Status {
                mode: Mode::Hold,
                place,
                process,
                t: 1.0,
                phase: None,
                speed: 0.0,
                steady: false,
                welded_mm: 0.0,
                armed: false,
                feed_override: 1.0,
                tracked: [None; 2],
            },
            orders: Orders::default(),
            reports: Reports::default(),
            lost: 0,
        };
        assert!(!Readiness::at(&shown, None).moves);
        shown.orders.set[1].velocity = -0.2;
        assert!(Readiness::at(&shown, None).moves);
    }
}
