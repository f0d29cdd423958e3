use seamwright_executive::{Ask, Command, Cycle, Missing, Mode, Note, Port, Reaction};
use seamwright_motion::feed_override::RunPhase;

/// The operator of a simulated weld: from power-on to home, once; any stop ends the run.
#[derive(Debug, Default)]
pub struct WeldOperator {
    mode: Option<Mode>,
    armed: bool,
    powered: bool,
    rests: bool,
    started: bool,
    /// The run has stopped, or is to stop.
    pub(super) over: bool,
    asked: bool,
}

impl Port for WeldOperator {
    fn command(&mut self, _t: f64) -> Option<Command> {
        if std::mem::replace(&mut self.asked, true) {
            return None;
        }
        let ask = match self.mode? {
            Mode::Off if self.started || self.over => Ask::Quit,
            Mode::Off => Ask::SwitchOn,
            Mode::Fault => Ask::Quit,
            Mode::Idle | Mode::Ready if self.over => Ask::SwitchOff,
            Mode::Idle if self.powered => Ask::Home,
            Mode::Ready if self.started => Ask::SwitchOff,
            Mode::Ready if !self.armed => Ask::Arm,
            Mode::Ready => {
                self.started = true;
                Ask::StartWeld
            }
            Mode::Hold if self.rests => Ask::Stop,
            Mode::Weld | Mode::Homing if self.over => Ask::Stop,
            _ => return None,
        };
        Some(Command::of(ask))
    }

    fn show(&mut self, cycle: &Cycle<'_>) {
        self.asked = false;
        (self.mode, self.armed, self.powered) = (Some(cycle.mode), cycle.armed, cycle.reports.drives.powered);
        self.rests = matches!(cycle.phase, Some(RunPhase::Held) | None);
    }

    fn note(&mut self, _t: f64, note: Note) {
        match note {
            // Repeat commands that need a moment.
            Note::Refused(_, Missing::Power | Missing::Moving) => {}
            Note::Refused(command, _) if command.ask != Ask::Quit => self.over = true,
            Note::Alarm(raised) if raised.reaction >= Reaction::Hold => self.over = true,
            _ => {}
        }
    }
}
