//! Execution of commands.

use super::command::{Ask, Command};
use super::core::Executive;
use super::device_interface::Devices;
use super::missing_permissive::Missing;
use super::mode::{Event, Mode, Refused};
use super::port::{Note, Port};
use super::requests::End;
use super::work::Work;

impl<D: Devices, P: Port> Executive<'_, D, P> {
    /// Executes a command, or notes the reason for its refusal.
    pub(super) fn take(&mut self, command: Command, work: Option<&Work<'_>>) {
        if let Ask::Why(event) = command.ask {
            for missing in self.missing(event, work) {
                self.port.note(self.now(), Note::Lacks(command, missing));
            }
        }
        let refused = self.obey(command.ask, work).err();
        // Jog commands come twenty times a second: note only refusals.
        let told = !matches!(command.ask, Ask::Jog(_)) || refused.is_some();
        if told {
            self.port.note(self.now(), refused.map_or(Note::Taken(command), |m| Note::Refused(command, m)));
        }
    }

    fn obey(&mut self, ask: Ask, work: Option<&Work<'_>>) -> Result<(), Missing> {
        if ask.stops() {
            if ask == Ask::Stop {
                self.stop();
            } else {
                self.requests.halt = true;
                self.event(Event::Hold);
            }
            return Ok(());
        }
        let Some(event) = ask.event(self.activity.welds) else { return self.adjust(ask, work) };
        // The drives' power is one of the conditions of `missing`.
        if let Some(refused) = ask.refused_in(self.mode, self.activity.welds, true) {
            return Err(refused);
        }
        if let Some(missing) = self.missing(event, work).first() {
            return Err(*missing);
        }
        let one = if let Ask::HomeAxis(axis) = ask { Some(self.home_one(axis)?) } else { None };
        if matches!(ask, Ask::StartDryRun | Ask::StartWeld) {
            self.activity.welds = event == Event::Weld;
        }
        self.requests.homes_one = one;
        (self.requests.reverse, self.requests.halt) = (false, false);
        self.event(event);
        self.process.disarm();
        match event {
            Event::SwitchOn => {
                self.io.power = true;
                self.supervision.switched_on();
            }
            Event::SwitchOff => self.io.power = false,
            _ => {}
        }
        Ok(())
    }

    /// Executes commands that do not change the mode.
    fn adjust(&mut self, ask: Ask, work: Option<&Work<'_>>) -> Result<(), Missing> {
        match ask {
            Ask::Override(value) if (0.0..=1.0).contains(&value) => self.requests.feed_override = value,
            Ask::Override(_) => return Err(Missing::Value),
            Ask::Acknowledge => drop(self.alarms.acknowledge()),
            Ask::AcknowledgeOne(alarm, detail) => drop(self.alarms.acknowledge_one(alarm, detail)),
            Ask::Arm => {
                let missing = self.missing(Event::Weld, work);
                if let Some(missing) = missing.iter().find(|m| **m != Missing::Arming) {
                    return Err(*missing);
                }
                if let Some(refused) = ask.refused_in(self.mode, self.activity.welds, true) {
                    return Err(refused);
                }
                self.process.arm(self.now());
            }
            Ask::Jog(command) if matches!(self.mode, Mode::Jog | Mode::Teach) => self.requests.jog = Some(command),
            Ask::Jog(_) => return Err(Missing::Mode(Refused { mode: self.mode, event: Event::Jog })),
            Ask::Reverse if self.mode == Mode::Hold => {
                if let Some(missing) = self.missing(Event::DryRun, work).first() {
                    return Err(*missing);
                }
                (self.requests.reverse, self.requests.halt) = (true, false);
            }
            Ask::Reverse => return Err(Missing::Motion),
            Ask::Why(_) => {}
            Ask::Load if self.activity.busy || self.mode.moves() || self.mode == Mode::Hold => {
                return Err(Missing::Moving);
            }
            Ask::Load => {
                // The position belonged to the previous program.
                self.activity.left = None;
                self.process.disarm();
                self.requests.end = Some(End::Load);
            }
            Ask::Quit if self.activity.busy || self.io.power => return Err(Missing::Moving),
            Ask::Quit => self.requests.end = Some(End::Quit),
            _ => return Err(Missing::Motion),
        }
        Ok(())
    }
}
