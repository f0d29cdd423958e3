//! Data that a job names outside its file: tables of points, and the torch poses of its machine's axes.

use crate::csv::CsvReader;
use crate::failure::Failure;
use crate::file_scope::FileScope;
use crate::files::io_error;
use crate::load;
use glam::DVec3;
use seamwright_geometry::Pose;
use seamwright_machine::AxisKind;
use seamwright_machine::{Joints, Machine};
use seamwright_message::Message;
use seamwright_program::AxisPositions;
use seamwright_weld::{MachineAxes, MachineAxis, Outside, Wrong};
use std::cell::RefCell;
use std::io::Cursor;
use std::sync::Arc;

const POINTS: [&str; 3] = ["x_mm", "y_mm", "z_mm"];
const ONE_NORMAL: [&str; 6] = ["x_mm", "y_mm", "z_mm", "n1x", "n1y", "n1z"];
const NORMALS: [&str; 9] = ["x_mm", "y_mm", "z_mm", "n1x", "n1y", "n1z", "n2x", "n2y", "n2z"];

/// Maximum number of rows of a table.
const MAX_ROWS: usize = 20_000;

/// Files and machines as a job names them.
pub(crate) struct Beside<'a> {
    within: FileScope<'a>,
    /// The machine asked for last.
    machine: RefCell<Option<(String, Machine)>>,
}

impl<'a> Beside<'a> {
    pub(crate) fn new(within: FileScope<'a>) -> Self {
        Self { within, machine: RefCell::new(None) }
    }

    fn rows(&self, name: &str) -> Result<Vec<Vec<f64>>, Failure> {
        let bytes = self.within.bytes(name).map_err(|e| {
            let message = Message::new("project-unreadable").text("file", name).message("why", io_error(&e));
            Failure::refused(message, Message::new("project-file-from-job"))
        })?;
        let (mut reader, _) = CsvReader::open(name, Cursor::new(bytes), &[&NORMALS, &ONE_NORMAL, &POINTS])?;
        let mut rows = Vec::new();
        while let Some(row) = reader.row() {
            if rows.len() == MAX_ROWS {
                let allowed = Message::new("project-up-to-points").number("max", MAX_ROWS as f64, 0);
                return Err(Failure::refused(Message::new("project-table-too-long").text("file", name), allowed));
            }
            rows.push(row?.to_vec());
        }
        Ok(rows)
    }
}

fn wrong(failure: &Failure) -> Wrong {
    let (message, allowed) = failure.fault_and_allowed();
    Wrong { message, allowed }
}

impl Outside for Beside<'_> {
    fn bytes(&self, file: &str) -> std::io::Result<Vec<u8>> {
        self.within.bytes(file)
    }

    fn table(&self, file: &str) -> Result<Vec<Vec<f64>>, Wrong> {
        self.rows(file).map_err(|failure| wrong(&failure))
    }

    fn tip(&self, name: &str, axes: &[f64]) -> Result<DVec3, Wrong> {
        let mut known = self.machine.borrow_mut();
        if known.as_ref().is_none_or(|(last, _)| last != name) {
            let machine = load::machine_beside(name, &self.within).map_err(|failure| wrong(&failure))?;
            *known = machine.map(|machine| (name.to_owned(), machine));
        }
        let Some((_, machine)) = known.as_ref() else {
            let message = Message::new("project-no-recording-machine").text("name", name);
            return Err(Wrong { message, allowed: Message::new("project-machine-as-recorded") });
        };
        let names: Vec<&str> = machine.axes.iter().map(|a| a.name.as_str()).collect();
        if axes.len() != names.len() {
            let message = Message::new("project-positions-for-axes").text("machine", name);
            let message = message.count("positions", axes.len()).count("axes", names.len());
            return Err(Wrong { message, allowed: names.join(", ").into() });
        }
        let mut q = Joints::default();
        for ((q, axis), value) in q.iter_mut().zip(&machine.axes).zip(axes) {
            *q = axis.from_file(*value);
        }
        if let Some(violation) = machine.outside(&q) {
            let message = machine.range_error(&violation).message();
            return Err(Wrong { message, allowed: Message::new("project-within-axis-ranges") });
        }
        Ok(machine.forward(&q).point)
    }

    fn axes(&self, name: &str) -> Result<Arc<dyn MachineAxes>, Wrong> {
        match load::machine_beside(name, &self.within).map_err(|failure| wrong(&failure))? {
            Some(machine) => Ok(Arc::new(Axes(machine))),
            None => {
                let message = Message::new("project-no-machine").text("name", name);
                Err(Wrong { message, allowed: Message::new("project-shipped-machine-or-file") })
            }
        }
    }
}

/// A machine as points given by its axes see it.
#[derive(Debug)]
struct Axes(Machine);

impl MachineAxes for Axes {
    fn axes(&self) -> Vec<MachineAxis> {
        let axis = |a: &seamwright_machine::Axis| MachineAxis {
            name: a.name.clone(),
            rotary: a.kind == AxisKind::Rotary,
            home: a.home,
            max_speed: a.max_speed,
        };
        self.0.axes.iter().map(axis).collect()
    }

    fn torch(&self, positions: &AxisPositions) -> Pose {
        self.0.forward(positions)
    }

    fn stick_out(&self) -> Option<f64> {
        self.0.stick_out_mm
    }
}
