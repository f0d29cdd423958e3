use std::io::{self, Write};

/// Writes step and direction lines as a value change dump (IEEE 1364, clause 18), which GTKWave and logic analysers
/// open. Times are whole multiples of 1 ns. Memory does not grow with the output. Methods fail if
/// it cannot be written.
///
/// Each axis is a scope with the wires `step` and `direction`; direction 1 counts up.
pub struct VcdWriter<W: Write> {
    out: W,
    now: u64,
    /// Levels of the wires, step and direction by turns.
    wires: Vec<bool>,
}

/// An axis in a value change dump.
#[derive(Debug, Clone, PartialEq)]
pub struct VcdAxis {
    /// Name of its scope: letters, digits and `_`.
    pub name: String,
    /// Level of the direction line at the start.
    pub positive: bool,
    /// A remark for the head of the file.
    pub about: String,
}

/// A wire of an axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Wire {
    /// Pulses.
    Step,
    /// 1 counts up, 0 down.
    Direction,
}

impl<W: Write> VcdWriter<W> {
    /// Writes the head, and the lines at time 0: step low.
    pub fn new(mut out: W, about: &str, axes: &[VcdAxis]) -> io::Result<Self> {
        writeln!(out, "$version seamwright {} $end", env!("CARGO_PKG_VERSION"))?;
        for text in std::iter::once(about).chain(axes.iter().map(|a| a.about.as_str())) {
            // A `$end` or a line of its own in a title would end the remark.
            writeln!(out, "$comment {} $end", text.replace('$', "").replace('\n', " "))?;
        }
        writeln!(out, "$timescale 1 ns $end")?;
        for (i, axis) in axes.iter().enumerate() {
            writeln!(out, "$scope module {} $end", axis.name)?;
            for (wire, name) in [(2 * i, "step"), (2 * i + 1, "direction")] {
                writeln!(out, "$var wire 1 {} {name} $end", code(wire))?;
            }
            writeln!(out, "$upscope $end")?;
        }
        writeln!(out, "$enddefinitions $end\n#0\n$dumpvars")?;
        let wires: Vec<bool> = axes.iter().flat_map(|a| [false, a.positive]).collect();
        for (wire, value) in wires.iter().enumerate() {
            writeln!(out, "{}{}", u8::from(*value), code(wire))?;
        }
        writeln!(out, "$end")?;
        Ok(Self { out, now: 0, wires })
    }

    /// A wire of axis `axis` (by index) at `time_ns`, not before the last change. A value that it has already is not
    /// written.
    pub fn change(&mut self, time_ns: u64, axis: usize, wire: Wire, value: bool) -> io::Result<()> {
        let wire = 2 * axis + usize::from(wire == Wire::Direction);
        if std::mem::replace(&mut self.wires[wire], value) == value {
            return Ok(());
        }
        if time_ns > self.now {
            self.now = time_ns;
            writeln!(self.out, "#{time_ns}")?;
        }
        writeln!(self.out, "{}{}", u8::from(value), code(wire))
    }

    /// Ends the file at `time_ns`.
    pub fn finish(mut self, time_ns: u64) -> io::Result<W> {
        if time_ns > self.now {
            writeln!(self.out, "#{time_ns}")?;
        }
        self.out.flush()?;
        Ok(self.out)
    }
}

/// The short code of wire `i`: one printing character, there are never more wires than these.
fn code(i: usize) -> char {
    char::from(b'!' + (i % 94) as u8)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn axis(name: &str, positive: bool) -> VcdAxis {
        VcdAxis { name: name.to_owned(), positive, about: format!("{name}: $end of\nthe table") }
    }

    #[test]
    fn head_and_changes() {
        let mut vcd = VcdWriter::new(Vec::new(), "a job", &[axis("x", true), axis("a", false)]).unwrap();
        vcd.change(0, 0, Wire::Direction, true).unwrap();
        vcd.change(100, 0, Wire::Step, true).unwrap();
        vcd.change(100, 1, Wire::Direction, true).unwrap();
        vcd.change(2600, 0, Wire::Step, false).unwrap();
        let text = String::from_utf8(vcd.finish(10_000).unwrap()).unwrap();
        let (head, body) = text.split_once("$enddefinitions $end\n").unwrap();
        assert_eq!(body, "#0\n$dumpvars\n0!\n1\"\n0#\n0$\n$end\n#100\n1!\n1$\n#2600\n0!\n#10000\n");
        for line in [
            "$comment a job $end",
            "$comment x: end of the table $end",
            "$timescale 1 ns $end",
            "$scope module a $end",
            "$var wire 1 $ direction $end",
        ] {
            assert!(head.lines().any(|l| l == line), "{line} in {head}");
        }
    }
}
