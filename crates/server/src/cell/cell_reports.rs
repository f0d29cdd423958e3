//! Reports of the cell's process, and its death.

use super::desk::{Desk, Loading, NotLoaded, names_of};
use super::display_distances::Around;
use super::event::happening;
use super::names::Names;
use super::progress::ToWeld;
use crate::http::adopted;
use crate::refusal::lack;
use seamwright_cell::protocol::Report;
use seamwright_cell::{Program, fingerprint};
use seamwright_executive::realtime::{Shown, Shutdown, ShutdownCause};
use seamwright_executive::{Mode, Note, Raised};
use seamwright_log as log;
use seamwright_machine::{Clamped, Machine, MachineDevices};
use seamwright_message::Message;
use std::sync::Arc;

impl Desk {
    pub(super) fn handle_report(&mut self, report: Report) {
        match report {
            Report::Hello { process, program, alarms, recording, unrecorded, open, .. } => {
                self.hub.set_cell_process(process);
                self.recorder.found(recording, open);
                self.unrecorded = unrecorded;
                self.greeted(program.as_deref(), &alarms);
            }
            Report::Cycle(shown) => self.cycle(&shown),
            Report::Note((t, note)) => self.handle_note(t, note),
            Report::Rights(rights) => self.tell_footing(rights),
            Report::Lines(lines) => self.hub.set_lines(lines),
            Report::Queues(queues) => self.tally.queue_fill(queues),
            Report::Recorded { weld } => self.recorder.ended(weld),
            Report::WeldBegins { start } => self.begin_record(start),
            Report::RecordFails { why } => {
                self.tell(happening(Message::new("server-event-record-fails").message("reason", why)));
            }
            Report::Prepared { outcome: Ok(()), .. } => {}
            Report::Prepared { outcome: Err(why), .. } => self.unprepared(why),
            Report::DevicesReleased => self.devices_released(),
            Report::Released { device, outcome } => self.released(device, outcome),
            // The supervisor handles it.
            Report::Ending => {}
            Report::Ended { failed } => {
                // A cell that ends by itself, by a signal for instance, is gone as soon as its connection is.
                self.ended = self.expects_end;
                if failed {
                    log::error(&Message::new("server-log-cycle-failed"));
                }
            }
        }
    }

    /// The cell has answered: a new one has neither a program nor alarms, one that was found running may have both.
    fn greeted(&mut self, program: Option<&Program>, alarms: &[Raised]) {
        for raised in alarms {
            self.mirror.update(&Note::Alarm(*raised), "");
        }
        if !alarms.is_empty() {
            self.hub.alarms(self.mirror.views(&self.names));
        }
        let Some(program) = program else { return };
        self.programs = program.number;
        match adopted(program) {
            Ok(loading) => {
                let Loading { machine, view, around, plan, passes, overlap_mm, .. } = loading;
                self.hub.set_machine(&machine);
                let to_weld = ToWeld::new(plan, passes, view.from).with_overlap(overlap_mm);
                self.names = names_of(*machine, program, &view);
                self.to_weld = Some(to_weld);
                self.tell(happening(Message::new("server-event-cell-found").text("job", &view.title)));
                self.hub.set_around(around);
                self.hub.set_work(Some(view));
                self.adopts = true;
            }
            // It goes on; a new load shows its job.
            Err(why) => self.tell(happening(Message::new("server-event-not-loaded").message("reason", why.message))),
        }
    }

    /// The first cycle of a cell that was found running: a weld goes on, in its record.
    pub(super) fn adopt(&mut self, shown: &Shown) {
        self.adopts = false;
        if shown.mode == Mode::Weld {
            self.begin_weld(shown.place);
        }
        if let Some(start) = self.unrecorded.take() {
            self.begin_record(start);
        }
    }

    /// The cell has the machine of the program that is being loaded, without devices and program.
    fn devices_released(&mut self) {
        let Some(pending) = &self.loading else { return };
        let (mut machine, around) = (pending.names.machine.clone(), Arc::clone(&pending.around));
        machine.devices = MachineDevices::default();
        self.without_program(machine, around);
    }

    /// A device was released: it has confirmed its safe outputs, or has not.
    fn released(&mut self, device: String, outcome: Result<(), Message>) {
        match outcome {
            // A device that was reconnected and is safe now is removed.
            Ok(()) => drop(self.unconfirmed.remove(&device)),
            Err(why) => {
                let message = Message::new("server-event-safe-unconfirmed").text("device", &device);
                self.tell(happening(message.message("reason", why.clone())));
                self.unconfirmed.insert(device, why);
            }
        }
    }

    /// The panel itself has written the safe outputs of a device, or could not.
    pub(super) fn written_by_panel(&mut self, device: String, outcome: Result<(), Message>) {
        if outcome.is_ok() {
            self.tell(happening(Message::new("server-event-safe-by-panel").text("device", &device)));
        }
        self.released(device, outcome);
    }

    /// The cell has died: a new one takes its place, off and without a program. Nothing else starts by itself.
    pub(super) fn lost(&mut self, why: &Message, shutdown: &Shutdown) {
        self.tell(happening(Message::new("server-event-cell-lost").message("reason", why.clone())));
        self.recorder.lost(why);
        self.unrecorded = None;
        self.welding = None;
        if let Some(pending) = self.loading.take() {
            let lost = lack("silent_cycle", Message::new("server-cell-silent"));
            drop(pending.answer.send(Err(NotLoaded::Lack(lost))));
        }
        for command in std::mem::take(&mut self.waiting) {
            self.refuse(command, lack("silent_cycle", Message::new("server-cell-silent")));
        }
        if self.expects_end {
            self.write_devices();
            self.ended = true;
            return;
        }
        match self.cell.restart().and_then(|()| self.cell.start_of_cell().machine.read()) {
            Ok(machine) => self.forget_program(machine),
            Err(why) => {
                self.tell(happening(Message::new("server-event-cell-not-restarted").message("reason", why.clone())));
                self.write_devices();
                self.failure = Some(Message::new("server-event-cell-not-restarted").message("reason", why));
                self.ended = true;
                shutdown.request(ShutdownCause::Asked);
            }
        }
    }

    /// Writes the safe outputs of all devices, since no cell does.
    fn write_devices(&mut self) {
        let devices = self.names.machine.devices.modbus.clone();
        for (device, outcome) in self.own_connection.write_all(&devices) {
            self.written_by_panel(device, outcome);
        }
    }

    /// Goes back to the machine of the start, without a program.
    fn forget_program(&mut self, machine: Machine) {
        (self.now, self.readiness) = (None, None);
        // It was valid at the start.
        if let Ok(around) = Around::new(&machine, &Clamped::default()) {
            self.without_program(machine, Arc::new(around));
        }
        self.tell(happening(Message::new("server-event-cell-restarted")));
    }

    fn without_program(&mut self, machine: Machine, around: Arc<Around>) {
        self.mirror.forget();
        self.hub.set_machine(&machine);
        self.hub.set_around(around);
        self.hub.set_lines(Vec::new());
        let fingerprint = fingerprint(&machine);
        self.names = Names { machine, fingerprint, values: 0, heads: 0 };
        self.hub.alarms(self.mirror.views(&self.names));
        self.hub.set_work(None);
        self.to_weld = None;
    }
}
