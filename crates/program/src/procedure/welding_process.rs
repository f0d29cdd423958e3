use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use seamwright_document::in_serde;
use seamwright_message::{Argument, Message};
use serde::de::{Error, Unexpected};
use serde::{Deserialize, Deserializer, Serialize};
use std::borrow::Cow;

/// A welding process by its number in ISO 4063, with its usual values. A procedure file may override each usual value
/// by a key of its own.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WeldingProcess {
    /// Number in ISO 4063.
    pub number: u16,
    /// Name.
    pub name: &'static str,
    /// Part of the arc's energy that counts as heat input: EN 1011-1, table 1; 1 for beams, which are not in it.
    pub thermal_efficiency: f64,
    /// Part of the melted wire or electrode that becomes weld metal; 1 where there need be no wire.
    pub deposition_efficiency: f64,
    /// Process values whose product is the power.
    pub power: &'static [&'static str],
}

const ARC: &[&str] = &["current_a", "voltage_v"];
const ELECTRON_BEAM: &[&str] = &["beam_ma", "accelerating_kv"];
const LASER: &[&str] = &["laser_w"];

/// Numbers and names are those of ISO 4063, thermal efficiencies those of EN 1011-1. Deposition efficiencies are the
/// middle of the values of filler metal makers for each process.
const PROCESSES: [WeldingProcess; 12] = [
    process(111, "manual metal arc welding", 0.8, 0.65, ARC),
    process(114, "self-shielded tubular cored arc welding", 0.8, 0.8, ARC),
    process(121, "submerged arc welding with solid wire", 1.0, 0.99, ARC),
    process(131, "MIG welding with solid wire", 0.8, 0.95, ARC),
    process(135, "MAG welding with solid wire", 0.8, 0.95, ARC),
    process(136, "MAG welding with flux cored wire", 0.8, 0.85, ARC),
    process(138, "MAG welding with metal cored wire", 0.8, 0.96, ARC),
    process(141, "TIG welding with solid filler", 0.6, 0.95, ARC),
    process(142, "TIG welding without filler", 0.6, 1.0, ARC),
    process(15, "plasma arc welding", 0.6, 0.95, ARC),
    process(51, "electron beam welding", 1.0, 1.0, ELECTRON_BEAM),
    process(52, "laser beam welding", 1.0, 1.0, LASER),
];

const fn process(
    number: u16,
    name: &'static str,
    thermal_efficiency: f64,
    deposition_efficiency: f64,
    power: &'static [&'static str],
) -> WeldingProcess {
    WeldingProcess { number, name, thermal_efficiency, deposition_efficiency, power }
}

impl WeldingProcess {
    /// All processes that are known.
    pub fn all() -> &'static [Self] {
        &PROCESSES
    }

    /// Number and name.
    pub fn message(&self) -> Message {
        let name = match self.number {
            111 => "process-111",
            114 => "process-114",
            121 => "process-121",
            131 => "process-131",
            135 => "process-135",
            136 => "process-136",
            138 => "process-138",
            141 => "process-141",
            142 => "process-142",
            15 => "process-15",
            51 => "process-51",
            _ => "process-52",
        };
        Message::new("program-process").text("number", self.number.to_string()).message("name", Message::new(name))
    }

    /// The process of that number.
    pub fn of(number: u16) -> Option<Self> {
        PROCESSES.into_iter().find(|p| p.number == number)
    }
}

impl<'de> Deserialize<'de> for WeldingProcess {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let number = i64::deserialize(deserializer)?;
        u16::try_from(number).ok().and_then(Self::of).ok_or_else(|| {
            let known = |p: &Self| Argument::Message(Box::new(p.message()));
            let known = Message::new("program-processes").list("processes", PROCESSES.iter().map(known));
            D::Error::invalid_value(Unexpected::Signed(number), &in_serde(&known).as_str())
        })
    }
}

impl Serialize for WeldingProcess {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_u16(self.number)
    }
}

impl JsonSchema for WeldingProcess {
    fn schema_name() -> Cow<'static, str> {
        "WeldingProcess".into()
    }
    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        let numbers: Vec<u16> = PROCESSES.iter().map(|p| p.number).collect();
        let names: Vec<String> = PROCESSES.iter().map(|p| format!("{} {}", p.number, p.name)).collect();
        json_schema!({
            "description": format!("A welding process by its number in ISO 4063: {}.", names.join(", ")),
            "enum": numbers
        })
    }
}
