//! Commands that have no effect at the moment, with the reason: the panel greys them.

use super::names::Names;
use crate::refusal::{Lack, lack};
use crate::wire::RefusedView;
use seamwright_executive::realtime::Shown;
use seamwright_executive::{Ask, Missing, Mode};
use seamwright_message::{Argument, Message};

/// Commands by their names in [`crate::wire::AskView`]; all others have an effect in every mode.
const COMMANDS: [(&str, Ask); 13] = [
    ("switch_on", Ask::SwitchOn),
    ("switch_off", Ask::SwitchOff),
    ("home", Ask::Home),
    ("start_jog", Ask::StartJog),
    ("start_teach", Ask::StartTeach),
    ("start_dry_run", Ask::StartDryRun),
    ("arm", Ask::Arm),
    ("start_weld", Ask::StartWeld),
    ("hold", Ask::Hold),
    ("resume", Ask::Resume),
    ("reverse", Ask::Reverse),
    ("stop", Ask::Stop),
    ("reset", Ask::Reset),
];

/// Part of the cell's state that decides which commands it would refuse whatever else is missing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Readiness {
    mode: Mode,
    powered: bool,
    /// The program that runs, or ran last, welds.
    welds: bool,
    /// Something moves along the path, in a hold too.
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
        let moves = shown.mode.moves() || shown.mode == Mode::Hold && shown.speed.abs() > 1e-3;
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
        let refused = |(name, ask): &(&str, Ask)| {
            let why = self.lack(ask, names)?.into();
            Some(RefusedView { ask: (*name).to_owned(), why })
        };
        COMMANDS.iter().filter_map(refused).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use seamwright_machine::{Machine, shipped};

    /// Returns the commands that have an effect, by their names.
    fn possible(mode: Mode, powered: bool, welds: bool, moves: bool) -> String {
        let machine = Machine::read("m.toml", shipped("saddle-4axis").unwrap().text).unwrap();
        let names = Names { machine, fingerprint: String::new(), values: 0, heads: 0 };
        let refused = Readiness { mode, powered, welds, moves }.refused(&names);
        let is_possible = |name: &&str| refused.iter().all(|of| of.ask != *name);
        COMMANDS.iter().map(|(name, _)| *name).filter(is_possible).collect::<Vec<_>>().join(" ")
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
}
