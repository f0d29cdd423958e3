use seamwright_message::{Argument, Message, display_by_message, named_enum};
use serde::{Deserialize, Serialize};
use std::fmt;

named_enum! {
    /// Operating mode of the cell. Power means that the drives hold or move the axes.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
    pub enum Mode {
        /// Drives without power, brakes closed.
        Off => "off", "cell-mode-off";
        /// Power on, positions unknown.
        Idle => "idle", "cell-mode-idle";
        /// The axes search for their references.
        Homing => "homing", "cell-mode-homing";
        /// Power on, positions known, at rest.
        Ready => "ready", "cell-mode-ready";
        /// The operator jogs axes.
        Jog => "jog", "cell-mode-jog";
        /// Jogging with recording of positions.
        Teach => "teach", "cell-mode-teach";
        /// The program runs with the process off.
        DryRun => "dry run", "cell-mode-dry-run";
        /// The program runs with the process on.
        Weld => "weld", "cell-mode-weld";
        /// A program is stopped on its path and can resume.
        Hold => "hold", "cell-mode-hold";
        /// Tripped; nothing moves before a reset.
        Fault => "fault", "cell-mode-fault";
    }
}

named_enum! {
    /// Events of the cell.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
    pub enum Event {
        /// Power-on request.
        SwitchOn => "switch on", "cell-trigger-switch-on";
        /// Power-off request.
        SwitchOff => "switch off", "cell-trigger-switch-off";
        /// Homing request.
        Home => "home", "cell-trigger-home";
        /// All references are known.
        Homed => "homed", "cell-trigger-homed";
        /// Jogging request.
        Jog => "jog", "cell-trigger-jog";
        /// Teaching request.
        Teach => "teach", "cell-trigger-teach";
        /// Request to start or resume the program without process.
        DryRun => "dry run", "cell-trigger-dry-run";
        /// Request to start or resume the program with process.
        Weld => "weld", "cell-trigger-weld";
        /// Stop on the path.
        Hold => "hold", "cell-trigger-hold";
        /// The current activity has finished.
        Finish => "finish", "cell-trigger-finish";
        /// Abort the current activity.
        Abort => "abort", "cell-trigger-abort";
        /// An alarm trips the cell.
        Trip => "trip", "cell-trigger-trip";
        /// Fault reset.
        Reset => "reset", "cell-trigger-reset";
    }
}

impl Mode {
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
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
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
