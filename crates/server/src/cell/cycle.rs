//! The thread of the cycle: executives one after another, each with its programs.

use super::prepared::Prepared;
use rtrb::{Consumer, Producer};
use seamwright_cell::devices::{DeviceSet, SimulatedDrives, SimulatedInputs, SimulatedSource};
use seamwright_cell::executive::{Devices, End, Executive, Interlocks};
use seamwright_cell::realtime::{Footing, LivePort, Paced, Pacer};
use seamwright_machine::Machine;

/// What the cycle is given and gives back.
pub(super) struct Swap {
    /// The next task; there when [`End::Load`] comes.
    pub(super) next: Consumer<Box<Prepared>>,
    /// Those that are done with, to be dropped elsewhere.
    pub(super) done: Producer<Box<Prepared>>,
}

/// Runs until it is told to quit. A task for another machine gets a new executive, which is off.
pub(super) fn run(mut task: Box<Prepared>, mut port: LivePort, mut swap: Swap) {
    Footing::ask(None);
    loop {
        let machine = task.machine().clone();
        let Ok(devices) = devices(&machine) else { return };
        let mut paced = Paced { devices, pacer: Pacer::new(machine.servo_period_s) };
        let mut executive = Executive::new(&machine, &mut paced as &mut dyn Devices, &mut port);
        loop {
            if task.with(|work| executive.serve(Some(work))) == End::Quit {
                return;
            }
            // The last one is meant: those before it were refused.
            while let Ok(next) = swap.next.pop() {
                // Where nobody takes it, it is dropped here: late, at rest.
                drop(swap.done.push(std::mem::replace(&mut task, next)));
            }
            if task.machine().name != machine.name {
                break;
            }
        }
    }
}

fn devices(
    machine: &Machine,
) -> Result<DeviceSet<SimulatedDrives, SimulatedSource, SimulatedInputs>, seamwright_cell::Error> {
    let period_s = machine.servo_period_s;
    Ok(DeviceSet {
        drives: SimulatedDrives::new(machine, 1)?,
        source: SimulatedSource::new(1, period_s),
        inputs: SimulatedInputs::new(Interlocks::new(&machine.interlocks).all_met()),
        period_s,
    })
}
