//! The welding procedure specification (WPS): limits of each pass.

mod bead_window;
mod pass_numbers;
mod plausibility;
mod pool;
mod position;
mod power;
mod shipped;
mod toe_angle;
mod welding_process;
mod window;

pub use bead_window::BeadWindow;
pub use pass_numbers::PassNumbers;
pub use plausibility::{Expected, Plausibility};
pub use position::{ButtLimits, FilletLimits, Inclination, PositionLimits, PositionStretch, WeldingPosition};
pub use shipped::{PROCEDURES, ShippedProcedure, shipped_procedure};
pub use toe_angle::QualityLevel;
pub use welding_process::WeldingProcess;
pub use window::{Outside, Window};

use crate::joint::FilletOrButt;
use crate::pass::{Pass, Role};
use crate::process::{check_process_name, check_process_units, check_process_value};
use schemars::JsonSchema;
use seamwright_document::{Document, DocumentError, Positive, SchemaVersion};
use seamwright_message::{Message, Unit};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// A welding procedure: process, and the window that each pass must keep to. A file of its own, or the table
/// `[procedure]` of a program.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Procedure {
    /// Version of the file format.
    pub schema: SchemaVersion,
    /// Number of the procedure specification.
    pub number: String,
    /// Title, for people and for the report.
    pub title: String,
    /// Welding process by its number in ISO 4063.
    pub process: WeldingProcess,
    /// Part of the power that counts as heat input, up to 1; if missing that of EN 1011-1 for the process, 1 for beams.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub thermal_efficiency: Option<Positive>,
    /// Process values whose product is the power: one in W or kW, or a current (A, mA, kA) and a voltage (V, kV). If
    /// missing `current_a` and `voltage_v`; `beam_ma` and `accelerating_kv` of an electron beam; `laser_w` of a laser.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub power: Option<Vec<String>>,
    /// Diameter of wire or electrode, mm.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub wire_diameter_mm: Option<Positive>,
    /// Part of the wire that becomes weld metal, up to 1; if missing the usual one of the process.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub deposition_efficiency: Option<Positive>,
    /// Kind of weld, for its positions: a groove on a nozzle is a butt weld. If missing by the angle between the faces.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub joint: Option<FilletOrButt>,
    /// Quality level of ISO 5817, for the angle at the toes of the cap; C if missing.
    #[serde(default, skip_serializing_if = "QualityLevel::is_usual")]
    pub quality_level: QualityLevel,
    /// Limits of each welding position.
    #[serde(default, skip_serializing_if = "PositionLimits::is_usual")]
    pub position_limits: PositionLimits,
    /// Comparison of current, voltage and wire feed with one another.
    #[serde(default, skip_serializing_if = "Plausibility::is_usual")]
    pub plausibility: Plausibility,
    /// Requirements for the passes.
    pub runs: Vec<Run>,
}

/// Requirements for some passes. Ranges are `[minimum, maximum]`; values without a range are not checked.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Run {
    /// The passes that are for this: by their role, without one by the first word of their name. Or give `passes`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<Role>,
    /// The passes of these numbers, counted from 1: `"1"`, `"2-5"`, `"1, 3-4"`; or give `name`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub passes: Option<PassNumbers>,
    /// Welding positions allowed (ISO 6947); any if missing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub positions: Option<Vec<WeldingPosition>>,
    /// Speed of the torch tip along the seam between acceleration and deceleration phase, mm/s.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub speed_mm_s: Option<Window>,
    /// Heat input between acceleration and deceleration phase, kJ/mm.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub heat_input_kj_mm: Option<Window>,
    /// Travel angle of the torch as the axes reach it, degrees: positive drags, negative pushes.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub travel_angle_deg: Option<Window>,
    /// Work angle of the torch as the axes reach it, degrees from the faces' bisector, positive towards the first part.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub work_angle_deg: Option<Window>,
    /// Stick-out, mm: wire between contact tip and arc.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub stick_out_mm: Option<Window>,
    /// Temperature before the first pass, degrees Celsius: to be measured, not planned.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub preheat_c: Option<Window>,
    /// Temperature before each further pass, degrees Celsius: to be measured, not planned.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub interpass_c: Option<Window>,
    /// Width of a bead, mm; if missing the usual one of the process. Checked for passes that a job's `[beads]` lays.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub bead_width_mm: Option<Window>,
    /// Height of a bead, mm; if missing the usual one of the process.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub bead_height_mm: Option<Window>,
    /// Width of a bead as a multiple of its height; if missing the usual one of the process.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub bead_width_to_height: Option<Window>,
    /// Maximum width of a bead without a weave, mm; if missing the usual one of the process and its wire.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub max_unwoven_mm: Option<Positive>,
    /// Minimum weld toe angle, degrees: between the surface of the part and the face of the cap, 180 if flush. If
    /// missing that of the quality level.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub min_toe_angle_deg: Option<Positive>,
    /// Maximum area of a bead without a weave, mm^2; if missing what surface tension holds in its welding position.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub max_unwoven_mm2: Option<Positive>,
    /// Ranges of the pass's process values, by the names that the job gives them, like `current_a`.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub ranges: BTreeMap<String, Window>,
}

/// Ranges with keys of their own: they must not be in `ranges`.
const OWN_KEYS: [&str; 13] = [
    "speed_mm_s",
    "heat_input_kj_mm",
    "travel_angle_deg",
    "work_angle_deg",
    "stick_out_mm",
    "preheat_c",
    "interpass_c",
    "bead_width_mm",
    "bead_height_mm",
    "bead_width_to_height",
    "max_unwoven_mm",
    "min_toe_angle_deg",
    "max_unwoven_mm2",
];

/// Toe angle of a weld that is flush with its part, degrees.
const MAX_TOE_DEG: f64 = 180.0;

impl Run {
    /// True if it is for `pass`, the program's `number`th.
    fn is_for(&self, number: usize, pass: &Pass) -> bool {
        self.passes.as_ref().is_some_and(|p| p.has(number)) || (self.name.is_some() && self.name == pass.known_role())
    }

    /// Fails for windows of sizes, speed or heat that begin below 0.
    fn check_sizes<T>(&self, file: &Document<T>, path: &str) -> Result<(), DocumentError> {
        let sizes = [
            ("speed_mm_s", self.speed_mm_s),
            ("heat_input_kj_mm", self.heat_input_kj_mm),
            ("stick_out_mm", self.stick_out_mm),
            ("bead_width_mm", self.bead_width_mm),
            ("bead_height_mm", self.bead_height_mm),
            ("bead_width_to_height", self.bead_width_to_height),
        ];
        let negative = sizes.into_iter().find(|(_, window)| window.is_some_and(|window| window.ends().0 < 0.0));
        negative.map_or(Ok(()), |(key, _)| {
            let allowed = Message::new("document-non-negative-number");
            Err(file.error_at(&format!("{path}.{key}"), Message::new("program-window-negative"), allowed))
        })
    }

    fn check<T>(&self, file: &Document<T>, path: &str) -> Result<(), DocumentError> {
        let message = match (&self.name, &self.passes) {
            (None, None) => Some("program-run-without-passes"),
            (Some(_), Some(_)) => Some("program-run-passes-twice"),
            _ => None,
        };
        if let Some(code) = message {
            return Err(file.error_at(path, Message::new(code), Message::new("program-run-names")));
        }
        if self.positions.as_ref().is_some_and(Vec::is_empty) {
            let message = Message::new("program-run-without-position");
            return Err(file.error_at(&format!("{path}.positions"), message, Message::new("program-run-positions")));
        }
        if self.min_toe_angle_deg.is_some_and(|angle| angle.get() > MAX_TOE_DEG) {
            let allowed = Message::new("document-more-than-up-to").value("min", 0.0, Unit::Deg);
            let allowed = allowed.value("max", MAX_TOE_DEG, Unit::Deg);
            let key = format!("{path}.min_toe_angle_deg");
            return Err(file.error_at(&key, Message::new("program-toe-angle-too-large"), allowed));
        }
        self.check_sizes(file, path)?;
        for (name, window) in &self.ranges {
            let key = format!("{path}.ranges.{name}");
            if OWN_KEYS.contains(&name.as_str()) {
                let allowed = Message::new("program-beside-ranges").key("key", name);
                return Err(file.error_at(&key, Message::new("program-not-a-process-value"), allowed));
            }
            check_process_name(file, &key, name)?;
            let (_, greatest) = window.ends();
            // A minimum of 0 or below is no limit.
            check_process_value(file, &key, name, greatest, self.ranges.keys())?;
        }
        check_process_units(file, &format!("{path}.ranges"), &self.ranges.keys())
    }
}

impl Procedure {
    /// Reads a procedure file.
    ///
    /// # Errors
    /// The first thing wrong, with its address.
    pub fn read(file: &str, text: &str) -> Result<Document<Self>, DocumentError> {
        let document = Document::<Self>::read(file, text).map_err(|mut e| {
            if e.key.starts_with("runs[") && e.message.code == "document-unknown-key" && e.help.is_none() {
                e.help = Some(Message::new("program-ranges-in-table"));
            }
            e
        })?;
        document.value.check(&document, "")?;
        Ok(document)
    }

    /// The procedure as a file.
    ///
    /// # Errors
    /// None in practice: every value in a procedure has a TOML form.
    pub fn to_toml(&self) -> Result<String, toml::ser::Error> {
        seamwright_document::to_toml(self)
    }

    /// Checks the procedure in the table `table` of `file` (empty: it is the whole file).
    ///
    /// # Errors
    /// With the key's address.
    pub fn check<T>(&self, file: &Document<T>, table: &str) -> Result<(), DocumentError> {
        let at = |key: &str| if table.is_empty() { key.to_owned() } else { format!("{table}.{key}") };
        let parts =
            [("thermal_efficiency", self.thermal_efficiency), ("deposition_efficiency", self.deposition_efficiency)];
        if let Some((key, _)) = parts.iter().find(|(_, part)| part.is_some_and(|p| p.get() > 1.0)) {
            let allowed = Message::new("document-more-than-up-to").number("min", 0.0, 0).number("max", 1.0, 0);
            return Err(file.error_at(&at(key), Message::new("program-part-above-one"), allowed));
        }
        self.check_power(file, &at("power"))?;
        self.position_limits.check(file, &at("position_limits"))?;
        if self.runs.is_empty() {
            let allowed = Message::new("program-at-least-one-table").key("table", "[[runs]]");
            return Err(file.error_at(&at("runs"), Message::new("program-procedure-without-runs"), allowed));
        }
        for (i, run) in self.runs.iter().enumerate() {
            let path = at(&format!("runs[{i}]"));
            run.check(file, &path)?;
            for (k, other) in self.runs[..i].iter().enumerate() {
                if run.name.is_some() && run.name == other.name {
                    let message = Message::new("program-name-taken").key("other", format!("runs[{k}]"));
                    let allowed = Message::new("program-one-run-per-name");
                    return Err(file.error_at(&format!("{path}.name"), message, allowed));
                }
                let both = run.passes.as_ref().zip(other.passes.as_ref()).and_then(|(a, b)| a.first_in_both(b));
                if let Some(number) = both {
                    let message = Message::new("program-pass-in-two-runs").pass("pass", number);
                    let message = message.key("other", format!("runs[{k}]"));
                    let allowed = Message::new("program-pass-in-one-run");
                    return Err(file.error_at(&format!("{path}.passes"), message, allowed));
                }
            }
        }
        Ok(())
    }

    /// Checks that each of a program's passes is in one run only, not in one by its role and another by its number.
    /// `file` and `table` as in [`Procedure::check`].
    ///
    /// # Errors
    /// With the second run's address.
    pub fn check_passes<T>(&self, file: &Document<T>, table: &str, passes: &[Pass]) -> Result<(), DocumentError> {
        for (number, pass) in (1..).zip(passes) {
            let mut runs = (0..self.runs.len()).filter(|i| self.runs[*i].is_for(number, pass));
            if let (Some(first), Some(second)) = (runs.next(), runs.next()) {
                let dot = if table.is_empty() { "" } else { "." };
                let message = Message::new("program-named-pass-in-two-runs").pass("pass", number);
                let message = message.text("name", pass.name.as_str()).key("other", format!("runs[{first}]"));
                let allowed = Message::new("program-pass-in-one-run");
                return Err(file.error_at(&format!("{table}{dot}runs[{second}]"), message, allowed));
            }
        }
        Ok(())
    }

    /// The run for `pass`, a program's `number`th (from 1), if any.
    pub fn run_of(&self, number: usize, pass: &Pass) -> Option<&Run> {
        self.runs.iter().find(|run| run.is_for(number, pass))
    }

    /// The run of that role, if any: for passes that are not made yet.
    pub fn run_named(&self, role: Role) -> Option<&Run> {
        self.runs.iter().find(|run| run.name == Some(role))
    }

    /// Part of the power that counts as heat input: the procedure's, or the process' usual one.
    pub fn thermal_efficiency(&self) -> f64 {
        self.thermal_efficiency.map_or(self.process.thermal_efficiency, Positive::get)
    }

    /// Part of the wire that becomes weld metal: the procedure's, or the process' usual one.
    pub fn deposition_efficiency(&self) -> f64 {
        self.deposition_efficiency.map_or(self.process.deposition_efficiency, Positive::get)
    }

    /// The kind of weld for the minimum and maximum angle between the faces (rad) along it.
    pub fn joint(&self, min_dihedral: f64, max_dihedral: f64) -> FilletOrButt {
        self.joint.unwrap_or_else(|| self.position_limits.joint(0.5 * (min_dihedral + max_dihedral)))
    }
}
