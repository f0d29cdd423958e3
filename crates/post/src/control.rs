use crate::error::Error;
use crate::part_program::{Channel, ChannelKind, Event};
use seamwright_machine::{AxisKind, ControlFile, Io, Machine};
use seamwright_message::named_enum;

named_enum! {
    /// A language of part programs.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum Dialect {
        /// Siemens Sinumerik 840D.
        Sinumerik => "sinumerik",
        /// LinuxCNC.
        Linuxcnc => "linuxcnc",
        /// grblHAL.
        Grblhal => "grblhal",
        /// Delta Tau PMAC motion programs.
        Pmac => "pmac",
    }
}

/// Language and settings of a machine's control.
#[derive(Debug, Clone, PartialEq)]
pub struct Control {
    /// Its language.
    pub dialect: Dialect,
    /// Channels of a row: the machine's axes, then process values by name.
    pub channels: Vec<Channel>,
    /// Address of each channel; empty for an analogue output.
    pub addresses: Vec<String>,
    /// Number of the analogue output of each channel that has one.
    pub outputs: Vec<Option<u8>>,
    /// Codes of the machine's own with their effect, the longest first.
    pub codes: Vec<(String, Code)>,
    /// Outputs that switch arc, gas and wire.
    pub io: Io,
    /// Whether numbers have a decimal comma.
    pub decimal_comma: bool,
    /// Analogue output that switches LinuxCNC's kinematics.
    pub kinematics_output: Option<u8>,
    /// Lines at the start instead of the usual ones.
    pub header: Option<String>,
    /// Lines at the end instead of the usual ones.
    pub footer: Option<String>,
}

/// Effect of a code of the machine's own.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Code {
    /// Switches an output or calls a program.
    Event(Event),
    /// The control stops at the end of every block from here on.
    ExactStop,
    /// It goes through from block to block from here on.
    ContinuousPath,
}

/// Letters that LinuxCNC and grblHAL have for axes; the first three are rotary.
const LETTERS: &str = "ABCUVWXYZ";

impl Control {
    /// The control of `machine` that speaks `dialect`.
    ///
    /// # Errors
    /// [`Error::NoLetter`], [`Error::WrongLetter`] where an axis has no address that the control knows.
    pub fn new(machine: &Machine, dialect: Dialect) -> Result<Self, Error> {
        let controls = &machine.controls;
        let file = match dialect {
            Dialect::Sinumerik => &controls.sinumerik,
            Dialect::Linuxcnc => &controls.linuxcnc,
            Dialect::Grblhal => &controls.grblhal,
            Dialect::Pmac => &controls.pmac,
        };
        let mut control = Self {
            dialect,
            channels: Vec::new(),
            addresses: Vec::new(),
            outputs: Vec::new(),
            codes: file.codes.iter().map(|(code, does)| (code.clone(), code_of(does))).collect(),
            io: machine.io.clone(),
            decimal_comma: file.decimal_comma,
            kinematics_output: file.kinematics_output,
            header: file.header.clone(),
            footer: file.footer.clone(),
        };
        control.codes.sort_by_key(|(code, _)| std::cmp::Reverse(code.len()));
        for axis in &machine.axes {
            let address = match (file.axes.get(&axis.name), dialect) {
                (Some(address), _) => address.clone(),
                (None, Dialect::Sinumerik) => axis.name.to_ascii_uppercase(),
                (None, _) => axis.letter.map(String::from).unwrap_or_default(),
            };
            if dialect != Dialect::Sinumerik {
                check_letter(&axis.name, axis.kind, &address, dialect)?;
            }
            let kind = match axis.kind {
                AxisKind::Linear => ChannelKind::Linear,
                AxisKind::Rotary => ChannelKind::Rotary,
            };
            control.add(&axis.name, kind, address, None);
        }
        control.add_process(file);
        Ok(control)
    }

    fn add_process(&mut self, file: &ControlFile) {
        let io = self.io.clone();
        let names: std::collections::BTreeSet<&String> = file.process.keys().chain(io.analog.keys()).collect();
        for name in names {
            let output = io.analog.get(name).copied();
            match file.process.get(name) {
                Some(address) if self.dialect == Dialect::Sinumerik => {
                    self.add(name, ChannelKind::Interpolated, address.clone(), None);
                }
                Some(address) => self.add(name, ChannelKind::Stepped, address.clone(), None),
                None => self.add(name, ChannelKind::Stepped, String::new(), output),
            }
        }
    }

    fn add(&mut self, name: &str, kind: ChannelKind, address: String, output: Option<u8>) {
        self.channels.push(Channel { name: name.to_owned(), kind });
        self.addresses.push(address);
        self.outputs.push(output);
    }

    /// Whether a part program switches arc or beam by a code or an output. A Sinumerik that interpolates process values
    /// switches it by these, unless the machine file has a code for it.
    pub fn switches_arc(&self) -> bool {
        let interpolates = self.channels.iter().any(|c| c.kind == ChannelKind::Interpolated);
        let coded = self.code(&Code::Event(Event::Arc(true))).is_some();
        coded || (!interpolates && (self.io.arc.is_some() || self.has_spindle_arc()))
    }

    /// Index of the channel called `name`.
    pub fn channel(&self, name: &str) -> Option<usize> {
        self.channels.iter().position(|c| c.name == name)
    }

    /// The machine's own code for `does`, if it has one.
    pub fn code(&self, does: &Code) -> Option<&str> {
        self.codes.iter().find(|(_, d)| d == does).map(|(code, _)| code.as_str())
    }
}

/// Meaning of an event's name in a machine file.
fn code_of(does: &str) -> Code {
    Code::Event(match does {
        "exact_stop" => return Code::ExactStop,
        "continuous_path" => return Code::ContinuousPath,
        "arc_on" => Event::Arc(true),
        "arc_off" => Event::Arc(false),
        "gas_on" => Event::Gas(true),
        "gas_off" => Event::Gas(false),
        "wire_on" => Event::Wire(true),
        "wire_off" => Event::Wire(false),
        name => Event::Call(name.into()),
    })
}

/// These controls know single letters, and take A, B and C for rotary axes.
fn check_letter(axis: &str, kind: AxisKind, address: &str, dialect: Dialect) -> Result<(), Error> {
    let mut chars = address.chars();
    let letter = chars.next().filter(|c| LETTERS.contains(*c) && chars.next().is_none());
    let letter = letter.ok_or_else(|| Error::NoLetter { axis: axis.to_owned() })?;
    let rotary = "ABC".contains(letter);
    if dialect == Dialect::Pmac || rotary == (kind == AxisKind::Rotary) {
        return Ok(());
    }
    Err(Error::WrongLetter { axis: axis.to_owned(), letter, rotary: !rotary })
}
