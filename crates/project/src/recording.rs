//! Data recorded of a weld beside its rows.

use crate::failure::Failure;
use crate::load::Loaded;
use seamwright_executive::Place;
use seamwright_message::{Message, Unit};
use seamwright_motion::WeldMotion;
use seamwright_program::{Procedure, Program};
use seamwright_record::Plan;
use seamwright_record::figures::{Basis, HEAT_INPUT, Judged, Power};
use seamwright_record::trace::{Column, Kind};

/// A part of a trace has an hour.
const PART_S: f64 = 3600.0;

/// Description of a trace's rows.
#[derive(Debug)]
pub struct Header<'a> {
    /// Columns with their units.
    pub columns: &'a [(String, &'static str)],
    /// Pairs of (key, value).
    pub about: &'a [(&'static str, String)],
    /// Position at which a weld continues that was started before, if any.
    pub from: Option<Place>,
}

impl Header<'_> {
    /// Columns with the kind of each.
    pub fn columns(&self) -> Vec<Column> {
        self.columns.iter().map(|(name, unit)| Column::new(name, *unit, kind(name))).collect()
    }
}

/// Part and welder of a weld.
#[derive(Debug, Clone, Default)]
pub struct Who {
    /// Number of the part, as the shop has it.
    pub part: String,
    /// No metal is welded.
    pub simulated: bool,
    /// Name of the welder.
    pub welder: Option<String>,
}

/// Rows of a part of a trace.
pub fn most_rows(period_s: f64) -> u64 {
    (PART_S / period_s) as u64
}

/// Time and positions in full, states in a byte, the rest to 7 digits.
fn kind(name: &str) -> Kind {
    match name {
        "pass" | "missed" => Kind::U32,
        "arc" | "mode" | "gas" | "process_state" | "burning" | "power" | "steady" => Kind::U8,
        "t_s" | "s_mm" | "tip_s_mm" | "welded_mm" | "inputs" => Kind::F64,
        axis if ["_set_mm", "_set_deg", "_true_mm", "_true_deg", "_measured_mm", "_measured_deg"]
            .iter()
            .any(|end| axis.ends_with(end)) =>
        {
            Kind::F64
        }
        _ => Kind::F32,
    }
}

/// Plan of a weld's recording.
///
/// # Errors
/// A machine file that has become unreadable.
pub fn record_plan(loaded: &Loaded, motion: &WeldMotion, header: &Header<'_>, who: Who) -> Result<Plan, Failure> {
    let document = &loaded.welding.program;
    let program = &document.value;
    let failed = |e: &dyn std::fmt::Display| Failure::Environment(Message::outside(e));
    let text = program.to_toml().map_err(|e| failed(&e))?;
    let file = std::path::Path::new(document.file()).file_name().map(|n| n.to_string_lossy().into_owned());
    let machine = loaded.machine_text()?;
    let procedure = match &program.procedure {
        Some(p) => Some((p.number.clone(), p.to_toml().map_err(|e| failed(&e))?)),
        None => None,
    };
    let is_job = !Program::is_in(document.text());
    Ok(Plan {
        part: who.part,
        title: program.title.clone(),
        simulated: who.simulated,
        job: is_job.then(|| (file.unwrap_or_default(), document.text().to_owned())),
        program: (program.title.clone(), text),
        machine: (loaded.machine.name.clone(), machine),
        procedure,
        welder: who.welder,
        columns: header.columns(),
        about: header.about.to_vec(),
        most_rows: most_rows(loaded.machine.servo_period_s),
        rows: motion.count(loaded.machine.servo_period_s, true),
        basis: basis(program, motion),
        note: header.from.map_or_else(Message::default, |at| goes_on(program, at)),
    })
}

/// A continued weld starts before the position up to which its pass is welded, by the overlap.
fn goes_on(program: &Program, at: Place) -> Message {
    let pass = at.pass.checked_sub(1).and_then(|i| program.passes.get(i));
    let overlap = pass.map_or(0.0, |pass| pass.sequence.overlap_mm.get());
    let note = Message::new("project-goes-on").pass("pass", at.pass);
    note.quantity("from", (at.s_mm - overlap).max(0.0), Unit::Mm, 2)
}

/// Values that are judged: process values, speed and heat input of each pass between its acceleration and deceleration
/// phases.
fn basis(program: &Program, motion: &WeldMotion) -> Basis {
    let procedure = program.procedure.as_ref();
    let mut judged = Vec::new();
    for (number, (pass, planned)) in (1..).zip(program.passes.iter().zip(&motion.passes)) {
        let run = procedure.and_then(|p| p.run_of(number, pass));
        let legs = planned.profile.legs();
        let along: Vec<_> = legs.iter().map(|leg| (leg.run_up_end, leg.run_down_start)).collect();
        let mut judge = |name: &str, allowed: Option<(f64, f64)>| {
            judged.push(Judged { pass: number as u32, name: name.to_owned(), allowed, along: along.clone() });
        };
        let of_run = |window: Option<seamwright_program::Window>| window.map(seamwright_program::Window::ends);
        judge("tip_speed_mm_s", of_run(run.and_then(|r| r.speed_mm_s)));
        if procedure.is_some() {
            judge(HEAT_INPUT, of_run(run.and_then(|r| r.heat_input_kj_mm)));
        }
        let values = pass.spans.iter().flat_map(|s| s.process.keys());
        let names: std::collections::BTreeSet<&String> = values.collect();
        for name in names {
            judge(name, of_run(run.and_then(|r| r.ranges.get(name).copied())));
        }
    }
    Basis { power: procedure.map(power), judged }
}

fn power(procedure: &Procedure) -> Power {
    let factors = procedure.power_factors().map(|(name, by)| (name.to_owned(), by));
    Power { factors: factors.collect(), efficiency: procedure.thermal_efficiency() }
}
