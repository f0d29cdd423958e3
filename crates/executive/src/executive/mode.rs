use seamwright_message::{Argument, Message, display_by_message};
use std::fmt;

/// Operating mode of the cell. Power means that the drives hold or move the axes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Mode {
    /// Drives without power, brakes closed.
    Off,
    /// Power on, positions unknown.
    Idle,
    /// The axes search for their references.
    Homing,
    /// Power on, positions known, at rest.
    Ready,
    /// The operator jogs axes.
    Jog,
    /// Jogging with recording of positions.
    Teach,
    /// The program runs with the process off.
    DryRun,
    /// The program runs with the process on.
    Weld,
    /// A program is stopped on its path and can resume.
    Hold,
    /// Tripped; nothing moves before a reset.
    Fault,
}

/// Events of the cell.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Event {
    /// Power-on request.
    SwitchOn,
    /// Power-off request.
    SwitchOff,
    /// Homing request.
    Home,
    /// All references are known.
    Homed,
    /// Jogging request.
    Jog,
    /// Teaching request.
    Teach,
    /// Request to start or resume the program without process.
    DryRun,
    /// Request to start or resume the program with process.
    Weld,
    /// Stop on the path.
    Hold,
    /// The current activity has finished.
    Finish,
    /// Abort the current activity.
    Abort,
    /// An alarm trips the cell.
    Trip,
    /// Fault reset.
    Reset,
}

impl Mode {
    /// All modes.
    pub const ALL: [Self; 10] = [
        Self::Off,
        Self::Idle,
        Self::Homing,
        Self::Ready,
        Self::Jog,
        Self::Teach,
        Self::DryRun,
        Self::Weld,
        Self::Hold,
        Self::Fault,
    ];

    /// Returns the mode after `event`: the single table of transitions. [`table`] prints it.
    ///
    /// # Guarantees
    /// Tested for every event in every mode:
    ///
    /// - A trip leads to [`Mode::Fault`] from every mode.
    /// - Hold and abort are never refused.
    /// - Only a reset leaves a fault, and it leads to [`Mode::Off`].
    /// - The process can only come on by [`Event::Weld`], from rest with known positions or from a hold.
    ///
    /// # Examples
    /// ```
    /// use seamwright_executive::{Event, Mode};
    ///
    /// assert_eq!(Mode::Off.after(Event::SwitchOn), Ok(Mode::Idle));
    /// assert!(Mode::Off.after(Event::Weld).is_err());
    /// assert_eq!(Mode::Weld.after(Event::Trip), Ok(Mode::Fault));
    /// ```
    ///
    /// # Errors
    /// [`Refused`] if the mode does not accept the event.
    pub fn after(self, event: Event) -> Result<Self, Refused> {
        use Event as E;
        Ok(match (self, event) {
            (_, E::Trip) => Self::Fault,
            (Self::Fault, E::Reset) | (Self::Idle | Self::Ready, E::SwitchOff) => Self::Off,
            (Self::Off, E::SwitchOn) => Self::Idle,
            (Self::Idle | Self::Ready, E::Home) => Self::Homing,
            (Self::Idle | Self::Homing, E::Homed) => Self::Ready,
            (Self::Homing, E::Hold | E::Abort) => Self::Idle,
            (Self::Ready, E::Jog) => Self::Jog,
            (Self::Ready, E::Teach) => Self::Teach,
            (Self::Ready | Self::Hold, E::DryRun) => Self::DryRun,
            (Self::Ready | Self::Hold, E::Weld) => Self::Weld,
            (Self::Jog | Self::Teach, E::Hold | E::Finish | E::Abort) => Self::Ready,
            (Self::DryRun | Self::Weld, E::Hold) => Self::Hold,
            (Self::DryRun | Self::Weld | Self::Hold, E::Finish | E::Abort) => Self::Ready,
            // A stop is accepted in every mode.
            (mode, E::Hold | E::Abort) => mode,
            (mode, event) => return Err(Refused { mode, event }),
        })
    }

    /// Returns true if the drives are to have power.
    pub fn has_power(self) -> bool {
        !matches!(self, Self::Off | Self::Fault)
    }

    /// Returns true if axes may move.
    pub fn moves(self) -> bool {
        matches!(self, Self::Homing | Self::Jog | Self::Teach | Self::DryRun | Self::Weld)
    }

    /// Its name in files and interfaces; for people there is [`Mode::message`].
    pub fn name(self) -> &'static str {
        match self {
            Self::Off => "off",
            Self::Idle => "idle",
            Self::Homing => "homing",
            Self::Ready => "ready",
            Self::Jog => "jog",
            Self::Teach => "teach",
            Self::DryRun => "dry run",
            Self::Weld => "weld",
            Self::Hold => "hold",
            Self::Fault => "fault",
        }
    }

    /// Returns its words.
    pub fn message(self) -> Message {
        Message::new(match self {
            Self::Off => "cell-mode-off",
            Self::Idle => "cell-mode-idle",
            Self::Homing => "cell-mode-homing",
            Self::Ready => "cell-mode-ready",
            Self::Jog => "cell-mode-jog",
            Self::Teach => "cell-mode-teach",
            Self::DryRun => "cell-mode-dry-run",
            Self::Weld => "cell-mode-weld",
            Self::Hold => "cell-mode-hold",
            Self::Fault => "cell-mode-fault",
        })
    }
}

impl Event {
    /// All events.
    pub const ALL: [Self; 13] = [
        Self::SwitchOn,
        Self::SwitchOff,
        Self::Home,
        Self::Homed,
        Self::Jog,
        Self::Teach,
        Self::DryRun,
        Self::Weld,
        Self::Hold,
        Self::Finish,
        Self::Abort,
        Self::Trip,
        Self::Reset,
    ];

    /// Its name in files and interfaces; for people there is [`Event::message`].
    pub fn name(self) -> &'static str {
        match self {
            Self::SwitchOn => "switch on",
            Self::SwitchOff => "switch off",
            Self::Home => "home",
            Self::Homed => "homed",
            Self::Jog => "jog",
            Self::Teach => "teach",
            Self::DryRun => "dry run",
            Self::Weld => "weld",
            Self::Hold => "hold",
            Self::Finish => "finish",
            Self::Abort => "abort",
            Self::Trip => "trip",
            Self::Reset => "reset",
        }
    }

    /// Returns its words.
    pub fn message(self) -> Message {
        Message::new(match self {
            Self::SwitchOn => "cell-trigger-switch-on",
            Self::SwitchOff => "cell-trigger-switch-off",
            Self::Home => "cell-trigger-home",
            Self::Homed => "cell-trigger-homed",
            Self::Jog => "cell-trigger-jog",
            Self::Teach => "cell-trigger-teach",
            Self::DryRun => "cell-trigger-dry-run",
            Self::Weld => "cell-trigger-weld",
            Self::Hold => "cell-trigger-hold",
            Self::Finish => "cell-trigger-finish",
            Self::Abort => "cell-trigger-abort",
            Self::Trip => "cell-trigger-trip",
            Self::Reset => "cell-trigger-reset",
        })
    }
}

impl fmt::Display for Mode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

impl fmt::Display for Event {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

/// An event that a mode does not accept.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Refused {
    /// The mode.
    pub mode: Mode,
    /// The event.
    pub event: Event,
}

impl Refused {
    /// Modes that accept the event.
    pub fn allowed(self) -> impl Iterator<Item = Mode> {
        Mode::ALL.into_iter().filter(move |mode| mode.after(self.event).is_ok())
    }

    /// Returns its message.
    pub fn message(&self) -> Message {
        let allowed = self.allowed().map(|mode| Argument::Message(Box::new(mode.message())));
        let message = Message::new("cell-refused").message("event", self.event.message());
        message.message("mode", self.mode.message()).list("modes", allowed)
    }
}

display_by_message!(Refused);

/// Returns the table of transitions as Markdown: one row per mode, one column per event; `-` for a refused event.
pub fn table() -> String {
    let mut text = String::from("| mode |");
    Event::ALL.iter().for_each(|event| text += &format!(" {event} |"));
    text += "\n|---|";
    text += &"---|".repeat(Event::ALL.len());
    for mode in Mode::ALL {
        text += &format!("\n| **{mode}** |");
        for event in Event::ALL {
            let to = mode.after(event).map_or("-", |to| if to == mode { "stays" } else { to.name() });
            text += &format!(" {to} |");
        }
    }
    text + "\n"
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_event_in_every_mode() {
        for mode in Mode::ALL {
            for event in Event::ALL {
                let after = mode.after(event);
                match event {
                    Event::Trip => assert_eq!(after, Ok(Mode::Fault)),
                    Event::Hold | Event::Abort => {
                        let to = after.unwrap();
                        assert!(!to.moves(), "{mode} {event}");
                        assert_eq!(to.has_power(), mode.has_power(), "a stop neither gives nor takes power");
                    }
                    Event::Weld => assert_eq!(after.is_ok(), matches!(mode, Mode::Ready | Mode::Hold)),
                    Event::Reset => assert_eq!(after.ok(), (mode == Mode::Fault).then_some(Mode::Off)),
                    _ => {}
                }
                if let Ok(to) = after {
                    // Only a request brings power, motion or the process.
                    assert!(!to.has_power() || mode.has_power() || event == Event::SwitchOn);
                    assert!(to == mode || to != Mode::Weld || event == Event::Weld);
                    let asks = matches!(event, Event::Home | Event::Jog | Event::Teach | Event::DryRun | Event::Weld);
                    assert!(to == mode || !to.moves() || asks);
                    assert!(mode != Mode::Fault || to == Mode::Fault || event == Event::Reset);
                } else {
                    let text = after.unwrap_err().to_string();
                    assert!(text.contains(event.name()) && text.contains(mode.name()), "{text}");
                    assert!(after.unwrap_err().allowed().count() > 0);
                }
            }
        }
    }

    /// Every mode can be reached from every other mode.
    #[test]
    fn no_mode_is_an_island() {
        let reach = |from: Mode| {
            let mut seen = vec![from];
            let mut i = 0;
            while i < seen.len() {
                for event in Event::ALL {
                    if let Ok(to) = seen[i].after(event)
                        && !seen.contains(&to)
                    {
                        seen.push(to);
                    }
                }
                i += 1;
            }
            seen
        };
        for mode in Mode::ALL {
            assert_eq!(reach(mode).len(), Mode::ALL.len(), "{mode}");
        }
    }

    #[test]
    fn the_document_has_the_table() {
        let text = include_str!("../../../../docs/explanation/executive.md");
        assert!(text.contains(&table()), "docs/explanation/executive.md needs this table:\n{}", table());
    }
}
