//! Drives by pulses whose pulses go to a file.

use crate::failure::Failure;
use crate::files;
use rtrb::Consumer;
use seamwright_executive::devices::{Drives, StepDrives};
use seamwright_executive::{DriveReport, Orders, Slack};
use seamwright_machine::{AxisKind, Joints, Machine, Steps};
use seamwright_message::Message;
use seamwright_motion::pulses::{Edge, Event};
use seamwright_record::{VcdAxis, VcdWriter, Wire};
use std::fs::File;
use std::io::{BufWriter, Write as _};
use std::path::Path;
use std::thread::JoinHandle;
use std::time::Duration;

/// Edges that fit between the cycle and the writer: a second of ten axes at 10 kHz.
const ROOM: usize = 1 << 18;
/// Period at which the writer looks for new edges.
const LOOK: Duration = Duration::from_millis(5);

/// Drives by pulses, and the thread that writes the pulses.
#[derive(Debug)]
pub(crate) struct StreamedSteps {
    /// Gone before the writer is waited for: its end is the end of the stream.
    drives: Option<StepDrives>,
    late_s: f64,
    writer: Option<JoinHandle<()>>,
}

impl StreamedSteps {
    /// With the stream of `device`, if it has one, beside the machine file in `folder`. A named pipe waits for its reader.
    pub(crate) fn start(machine: &Machine, device: &Steps, folder: &Path) -> Result<Self, Failure> {
        let mut drives = StepDrives::new(machine, device).map_err(|e| Failure::Input(e.message()))?;
        let late_s = drives.late_s();
        let Some(name) = &device.stream else { return Ok(Self { drives: Some(drives), late_s, writer: None }) };
        let path = folder.join(name);
        let bad = |e: std::io::Error| files::not_writable(&path, &e);
        let out = BufWriter::new(File::create(&path).map_err(bad)?);
        let axes: Vec<VcdAxis> = machine
            .axes
            .iter()
            .zip(drives.steps_per_unit())
            .map(|(axis, per_unit)| {
                let unit = if axis.kind == AxisKind::Linear { "mm" } else { "deg" };
                let about = format!("{}: {} pulses per {unit}", axis.name, 1.0 / axis.to_file(1.0 / per_unit));
                VcdAxis { name: axis.name.clone(), positive: true, about }
            })
            .collect();
        let vcd = VcdWriter::new(out, &machine.name, &axes).map_err(bad)?;
        let edges = drives.tap(ROOM);
        let tick_ns = u64::from(device.tick_ns);
        let writer = std::thread::spawn(move || {
            if let Err(error) = write(vcd, edges, tick_ns) {
                // The drives have noticed: their edges are not read any more.
                let note = Message::new("project-pulses-end").text("file", path.display().to_string());
                let note = note.message("why", Message::outside(&error)).to_string();
                let _ = writeln!(std::io::stderr(), "{}", Message::new("project-note").text("note", note));
            }
        });
        Ok(Self { drives: Some(drives), late_s, writer: Some(writer) })
    }
}

/// Writes edges until no more come.
fn write(mut vcd: VcdWriter<BufWriter<File>>, mut edges: Consumer<Event>, tick_ns: u64) -> std::io::Result<()> {
    let mut now = 0;
    loop {
        // Read first: edges before the end are still there afterwards.
        let ended = edges.is_abandoned();
        while let Ok(event) = edges.pop() {
            now = event.tick * tick_ns;
            let (wire, value) = match event.edge {
                Edge::Fall => (Wire::Step, false),
                Edge::Direction(positive) => (Wire::Direction, positive),
                Edge::Rise => (Wire::Step, true),
            };
            vcd.change(now, event.axis, wire, value)?;
        }
        if ended {
            vcd.finish(now)?;
            return Ok(());
        }
        std::thread::sleep(LOOK);
    }
}

impl Drives for StreamedSteps {
    fn exchange(&mut self, orders: &Orders, report: &mut DriveReport) {
        if let Some(drives) = &mut self.drives {
            drives.exchange(orders, report);
        }
    }

    fn rides_out(&self) -> Slack {
        self.drives.as_ref().map_or(Slack::stored(0), Drives::rides_out)
    }

    fn late_s(&self) -> f64 {
        self.late_s
    }

    fn truth(&self) -> Option<&Joints> {
        self.drives.as_ref()?.truth()
    }
}

impl Drop for StreamedSteps {
    /// All edges so far are written.
    fn drop(&mut self) {
        self.drives = None;
        if let Some(writer) = self.writer.take() {
            // A writer that failed has reported it.
            let _ = writer.join();
        }
    }
}
