//! The thread of the cycle: executives one after another, each with its programs.

use crate::devices::CellDevices;
use crate::prepared_task::Prepared;
use crate::tracking::{Sensing, Slot};
use rtrb::{Consumer, Producer};
use seamwright_executive::devices::WithSensors;
use seamwright_executive::realtime::{LivePort, Paced, RealtimeRights, Shutdown, guarded};
use seamwright_executive::{End, Executive};
use seamwright_machine::Machine;
use std::cell::RefCell;
use std::sync::{Arc, OnceLock};

/// Tasks given to and returned by the cycle.
pub(crate) struct Swap {
    /// The next task; present when [`End::Load`] comes.
    pub(crate) next: Consumer<Box<Prepared>>,
    /// Finished tasks, to be dropped in another thread.
    pub(crate) done: Producer<Box<Prepared>>,
}

impl Swap {
    /// Returns the newest task: earlier ones were refused.
    fn next(&mut self) -> Option<Box<Prepared>> {
        let mut meant = None;
        while let Ok(next) = self.next.pop() {
            self.done(meant.replace(next));
        }
        meant
    }

    /// Returns a task; if the queue is full it is dropped here: late, at rest.
    fn done(&mut self, task: Option<Box<Prepared>>) {
        drop(task.map(|task| self.done.push(task)));
    }
}

/// Runs on `devices` until a quit command. A task for another machine brings its devices and gets a new executive,
/// which is off.
/// The real-time rights granted to the thread go to `footing`. A panic switches the devices off and requests
/// `shutdown`.
pub(crate) fn run(
    mut task: Box<Prepared>,
    mut devices: CellDevices,
    mut port: LivePort,
    mut swap: Swap,
    footing: &Arc<OnceLock<RealtimeRights>>,
    shutdown: &Shutdown,
) {
    footing.get_or_init(|| RealtimeRights::ask(None));
    loop {
        let machine = task.machine().clone();
        let mut paced = Paced::supervised(WithSensors { devices, sensors: None }, &machine, shutdown);
        let next = guarded(&mut paced, shutdown, |paced| on_machine(&machine, paced, &mut port, &mut task, &mut swap));
        // The link learns from the flag that the cycle has failed.
        let Ok(Some(next)) = next else { return };
        task.devices = Some(paced.devices.devices);
        swap.done(Some(std::mem::replace(&mut task, next)));
        match task.devices.take() {
            Some(its) => devices = its,
            // The link ensures devices before it hands over the task.
            None => return,
        }
    }
}

/// Runs the programs of one machine. Returns the first task for another one, or `None` at the end.
fn on_machine(
    machine: &Machine,
    paced: &mut Paced<WithSensors<CellDevices, Option<Sensing>>>,
    port: &mut LivePort,
    task: &mut Box<Prepared>,
    swap: &mut Swap,
) -> Option<Box<Prepared>> {
    let guide = RefCell::new(None);
    let mut slot = Slot(&guide);
    let mut executive = Executive::new(machine, paced, port).with_guide(Some(&mut slot));
    loop {
        guide.replace(task.guide.take());
        executive.devices_mut().devices.sensors = task.sensors.take();
        if task.with(|work| executive.serve(Some(work))) == End::Quit {
            return None;
        }
        // Guide and sensors go with their task.
        task.guide = guide.take();
        task.sensors = executive.devices_mut().devices.sensors.take();
        match swap.next() {
            Some(next) if next.fingerprint() != task.fingerprint() => return Some(next),
            Some(next) => swap.done(Some(std::mem::replace(task, next))),
            None => {}
        }
    }
}
