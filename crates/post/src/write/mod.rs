//! A part program as text.

mod feed_mode;
mod grblhal;
mod header;
mod linuxcnc;
mod number;
mod pmac;
mod rs274;
mod sinumerik;
mod text;
mod tongue;
mod writer;

pub(crate) use number::fixed;

use crate::control::{Control, Dialect};
use crate::error::Error;
use crate::part_program::{Event, PartProgram};
use writer::Writer;

/// Options of the writer.
#[derive(Debug, Clone, PartialEq)]
pub struct WriteOptions {
    /// The machine's title, for people.
    pub machine: String,
    /// Form of the blocks' times.
    pub feed: Feed,
    /// Rounding of corners between blocks by the control, mm; 0: the control's own default. LinuxCNC only.
    pub rounding_mm: f64,
    /// Remarks for the start of the text.
    pub remarks: Vec<String>,
}

impl Default for WriteOptions {
    fn default() -> Self {
        Self { machine: String::new(), feed: Feed::InverseTime, rounding_mm: 0.0, remarks: Vec::new() }
    }
}

/// Form of the blocks' times. PMAC: times, or a feed per second; its cubics and splines have times always.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Feed {
    /// Blocks per minute, G93.
    InverseTime,
    /// mm/min along the way that the control counts, G94.
    PerMinute,
}

/// The text of `program` in the language of `control`, whose channels must be those of the program.
///
/// Unchanged words are left out, but the first move of each pass has all axes. Times are those of the moves by the
/// control's own rule for feeds. With several passes Sinumerik and LinuxCNC get a sub-program for each; on the others
/// each pass has a number to start from. `control.header` and `control.footer` replace the usual lines at the start and
/// the end; `{title}` and `{machine}` in them are filled in.
///
/// # Errors
/// [`Error::Unwritable`]: the feature that the control lacks, with step, pass and operator action.
pub fn write(control: &Control, program: &PartProgram, options: &WriteOptions) -> Result<String, Error> {
    let mut writer = Writer::new(control, program, options)?;
    let result = match control.dialect {
        Dialect::Sinumerik => writer.run(&mut sinumerik::Sinumerik::default()),
        Dialect::Linuxcnc => writer.run(&mut linuxcnc::Linuxcnc::default()),
        Dialect::Grblhal => writer.run(&mut grblhal::Grblhal::default()),
        Dialect::Pmac => writer.run(&mut pmac::Pmac::default()),
    };
    result.and_then(|()| writer.finish())
}

impl Control {
    /// Whether grblHAL's spindle words switch the arc: if its speed is a process value.
    pub(crate) fn has_spindle_arc(&self) -> bool {
        self.dialect == Dialect::Grblhal && self.addresses.iter().any(|a| a == "S")
    }

    /// Digital output that brings `event` about.
    pub(crate) fn output(&self, event: &Event) -> Option<(u32, bool)> {
        let (output, on) = match event {
            Event::Arc(on) => (self.io.arc?, *on),
            Event::Gas(on) => (self.io.gas?, *on),
            Event::Wire(on) => (self.io.wire?, *on),
            Event::Output(n, on) => return Some((u32::from(*n), *on)),
            Event::Message(_) | Event::Call(_) => return None,
        };
        Some((u32::from(output), on))
    }
}
