use super::{Alarm, Event};
use seamwright_motion::jog;

/// Who asked, and from where: numbers that the outside resolves to names, so that a cycle carries no text.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Origin {
    /// Number of the user; 0 is the cell itself.
    pub user: u32,
    /// Number of the station or connection.
    pub station: u32,
}

/// Something that is asked of the cell.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Command {
    /// Who asked.
    pub origin: Origin,
    /// The asker's own number for it, given back with what came of it.
    pub number: u32,
    /// What.
    pub ask: Ask,
}

impl Command {
    /// From nobody in particular.
    pub fn of(ask: Ask) -> Self {
        Self { origin: Origin::default(), number: 0, ask }
    }
}

/// What can be asked.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Ask {
    /// Power for the drives.
    SwitchOn,
    /// No power for the drives.
    SwitchOff,
    /// Find the references.
    Home,
    /// This axis to its home position, references known.
    HomeAxis(u8),
    /// Jogging, until [`Ask::Hold`].
    StartJog,
    /// Jogging while places are recorded.
    StartTeach,
    /// What the operator's hand on the keys wants; a sign of life even if it is what it was.
    Jog(jog::Command),
    /// The program with the process off.
    StartDryRun,
    /// Allow the next start of the process: for one start, within a minute.
    Arm,
    /// The program with the process on; must be armed.
    StartWeld,
    /// Stand still on the path, the process as the pass says.
    Hold,
    /// Go on after a hold; must be armed if the process is to come on.
    Resume,
    /// Go back along the path with the process off, until the next hold.
    Reverse,
    /// Stop on the path with the process off at once, and give up the program. Never refused.
    Stop,
    /// Part of the planned speed, 0 to 1.
    Override(f64),
    /// The fault has been looked at.
    Reset,
    /// All alarms are known.
    Acknowledge,
    /// This alarm is known, with which axis, condition or process value; the others are not.
    AcknowledgeOne(Alarm, u8),
    /// What stands between now and this: told in notes, changes nothing.
    Why(Event),
    /// Give the cell back for another program, power and references as they are; must not move.
    Load,
    /// End the executive; must not move.
    Quit,
}

impl Ask {
    /// In a few words.
    pub fn name(&self) -> &'static str {
        match self {
            Self::SwitchOn => "switch on",
            Self::SwitchOff => "switch off",
            Self::Home => "home",
            Self::HomeAxis(_) => "home axis",
            Self::StartJog => "start jog",
            Self::StartTeach => "start teach",
            Self::Jog(_) => "jog",
            Self::StartDryRun => "start dry run",
            Self::Arm => "arm",
            Self::StartWeld => "start weld",
            Self::Hold => "hold",
            Self::Resume => "resume",
            Self::Reverse => "reverse",
            Self::Stop => "stop",
            Self::Override(_) => "override",
            Self::Reset => "reset",
            Self::Acknowledge => "acknowledge",
            Self::AcknowledgeOne(..) => "acknowledge one",
            Self::Why(_) => "why",
            Self::Load => "load",
            Self::Quit => "quit",
        }
    }
}
