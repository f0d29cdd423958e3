use super::alarm::Alarm;
use super::missing_permissive::Missing;
use super::mode::{Event, Mode, Refused};
use seamwright_message::{Message, Unit};
use seamwright_motion::jog;
use serde::{Deserialize, Serialize};

/// Origin of a command: numbers that the outside resolves to names, so that a cycle carries no text.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct Origin {
    /// Number of the user; 0 is the cell itself.
    pub user: u32,
    /// Number of the station or connection.
    pub station: u32,
}

/// A command to the cell.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Command {
    /// Origin of the command.
    pub origin: Origin,
    /// The sender's number of the command, returned with its outcome.
    pub number: u32,
    /// The requested action.
    pub ask: Ask,
}

impl Command {
    /// Creates a command of the cell itself.
    pub fn of(ask: Ask) -> Self {
        Self { origin: Origin::default(), number: 0, ask }
    }
}

/// Requested actions.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum Ask {
    /// Switch the drives on.
    SwitchOn,
    /// Switch the drives off.
    SwitchOff,
    /// Home all axes.
    Home,
    /// Move this axis to its home position; needs known references.
    HomeAxis(u8),
    /// Jogging, until [`Ask::Hold`].
    StartJog,
    /// Jogging with recording of positions.
    StartTeach,
    /// The jog command of the enabling switch; a sign of life even without a change.
    Jog(jog::Command),
    /// Start the program with the process off.
    StartDryRun,
    /// Allow the next start of the process: for one start, within a minute.
    Arm,
    /// Start the program with the process on; must be armed.
    StartWeld,
    /// Stop on the path; the pass defines the process during the hold.
    Hold,
    /// Resume after a hold; must be armed if the process is to come on.
    Resume,
    /// Move back along the path with the process off, until the next hold.
    Reverse,
    /// Switch the process off at once, stop on the path, and abort the program. Never refused.
    Stop,
    /// Feed override, 0 to 1 of the planned speed.
    Override(f64),
    /// Reset the fault.
    Reset,
    /// Acknowledge all alarms.
    Acknowledge,
    /// Acknowledge this alarm of this axis, condition or process value; the others stay as they are.
    AcknowledgeOne(Alarm, u8),
    /// Report the missing permissives of this event in notes; changes nothing.
    Why(Event),
    /// Return the cell for another program, with power and references unchanged; must not move.
    Load,
    /// End the executive; must not move.
    Quit,
}

impl Ask {
    /// Returns true for commands that are always accepted.
    pub(super) fn stops(&self) -> bool {
        matches!(self, Self::Stop | Self::Hold)
    }

    /// Returns the event that the command triggers; `None` if it does not change the mode. `welds`: the held program
    /// welds.
    pub(super) fn event(&self, welds: bool) -> Option<Event> {
        Some(match self {
            Self::SwitchOn => Event::SwitchOn,
            Self::SwitchOff => Event::SwitchOff,
            Self::Home | Self::HomeAxis(_) => Event::Home,
            Self::StartJog => Event::Jog,
            Self::StartTeach => Event::Teach,
            Self::StartDryRun => Event::DryRun,
            Self::StartWeld => Event::Weld,
            Self::Reset => Event::Reset,
            Self::Resume if welds => Event::Weld,
            Self::Resume => Event::DryRun,
            _ => return None,
        })
    }

    /// Returns why a mode refuses the command, whatever else is missing. `welds`: the program that runs, or ran last,
    /// welds; `powered`: the drives have power.
    pub fn refused_in(&self, mode: Mode, welds: bool, powered: bool) -> Option<Missing> {
        let event = match self {
            Self::Reverse if mode != Mode::Hold => return Some(Missing::Motion),
            Self::Arm if mode == Mode::Hold && !welds => return Some(Missing::Motion),
            Self::Reverse => Event::DryRun,
            Self::Arm => Event::Weld,
            _ => self.event(welds)?,
        };
        // A held program resumes in its own mode.
        let starts = matches!(self, Self::StartDryRun | Self::StartWeld);
        if mode == Mode::Hold && starts || mode != Mode::Hold && *self == Self::Resume {
            return Some(Missing::Mode(Refused { mode, event }));
        }
        let needs_power = !matches!(event, Event::SwitchOn | Event::SwitchOff | Event::Reset);
        mode.after(event).err().map(Missing::Mode).or((needs_power && !powered).then_some(Missing::Power))
    }

    /// Its name in files and interfaces, and the code of its words.
    fn words(&self) -> [&'static str; 2] {
        match self {
            Self::SwitchOn => ["switch on", "cell-ask-switch-on"],
            Self::SwitchOff => ["switch off", "cell-ask-switch-off"],
            Self::Home => ["home", "cell-ask-home"],
            Self::HomeAxis(_) => ["home axis", "cell-ask-home-axis"],
            Self::StartJog => ["start jog", "cell-ask-start-jog"],
            Self::StartTeach => ["start teach", "cell-ask-start-teach"],
            Self::Jog(_) => ["jog", "cell-ask-jog"],
            Self::StartDryRun => ["start dry run", "cell-ask-start-dry-run"],
            Self::Arm => ["arm", "cell-ask-arm"],
            Self::StartWeld => ["start weld", "cell-ask-start-weld"],
            Self::Hold => ["hold", "cell-ask-hold"],
            Self::Resume => ["resume", "cell-ask-resume"],
            Self::Reverse => ["reverse", "cell-ask-reverse"],
            Self::Stop => ["stop", "cell-ask-stop"],
            Self::Override(_) => ["override", "cell-ask-override"],
            Self::Reset => ["reset", "cell-ask-reset"],
            Self::Acknowledge => ["acknowledge", "cell-ask-acknowledge"],
            Self::AcknowledgeOne(..) => ["acknowledge one", "cell-ask-acknowledge-one"],
            Self::Why(_) => ["why", "cell-ask-why"],
            Self::Load => ["load", "cell-ask-load"],
            Self::Quit => ["quit", "cell-ask-quit"],
        }
    }

    /// Its name in files and interfaces; for people there is [`Ask::message`].
    pub fn name(&self) -> &'static str {
        self.words()[0]
    }

    /// Returns its words.
    pub fn message(&self) -> Message {
        let message = Message::new(self.words()[1]);
        match self {
            Self::Override(part) => message.quantity("override", 100.0 * part, Unit::Percent, 0),
            _ => message,
        }
    }
}
