//! A part program as text.

mod dialect;
mod feed_mode;
mod grblhal;
mod header;
mod linuxcnc;
mod number;
mod options;
mod pmac;
mod rs274;
mod sinumerik;
mod steps;
mod text;
mod writer;

pub(crate) use number::fixed;
pub use options::{Feed, WriteOptions};

use crate::control::{Control, Dialect};
use crate::error::Error;
use crate::part_program::{Event, PartProgram};
use writer::Writer;

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
