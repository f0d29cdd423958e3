//! The thread of the cycle: executives one after another, each with its programs.

use super::prepared::Prepared;
use rtrb::{Consumer, Producer};
use seamwright_cell::executive::{Devices, End, Executive};
use seamwright_cell::realtime::{Footing, LivePort, Paced, Pacer};
use seamwright_project::devices;

/// What the cycle is given and gives back.
pub(super) struct Swap {
    /// The next task; there when [`End::Load`] comes.
    pub(super) next: Consumer<Box<Prepared>>,
    /// Those that are done with, to be dropped elsewhere.
    pub(super) done: Producer<Box<Prepared>>,
}

/// Runs on `devices` until it is told to quit. A task for another machine gets a new executive, which is off, on simulated
/// devices.
pub(super) fn run(mut task: Box<Prepared>, mut devices: devices::Cell, mut port: LivePort, mut swap: Swap) {
    Footing::ask(None);
    loop {
        let machine = task.machine().clone();
        let mut paced = Paced { devices, pacer: Pacer::new(machine.servo_period_s) };
        let mut executive = Executive::new(&machine, &mut paced as &mut dyn Devices, &mut port);
        let this = task.fingerprint().to_owned();
        while task.fingerprint() == this {
            if task.with(|work| executive.serve(Some(work))) == End::Quit {
                return;
            }
            // The last one is meant: those before it were refused.
            while let Ok(next) = swap.next.pop() {
                // Where nobody takes it, it is dropped here: late, at rest.
                drop(swap.done.push(std::mem::replace(&mut task, next)));
            }
        }
        match devices::simulated(task.machine(), &[], 1) {
            Ok(simulated) => devices = simulated,
            // The desk has made sure of it before it gave the task.
            Err(_) => return,
        }
    }
}
