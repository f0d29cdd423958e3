//! The timed set-points: exact ones, fine ones by way of coarse ones, or coarse ones for a control with a fine level.

mod commands;
mod run;
mod table;
mod two_level;

use super::process_columns::ArcClock;
use super::{period, positive};
use crate::args::{ExportArg, MotionArgs};
use crate::planning;
use crate::progress::Progress;
use crate::refusals::refused;
use crate::rows::json_text;
use seamwright_message::{Message, Unit};
use seamwright_motion::{SetPoint, WeldMotion};
use seamwright_project::failure::Failure;
use seamwright_project::files;
use seamwright_project::load::Loaded;
use seamwright_report::CertificateFigures;
use serde::Serialize;
use std::path::Path;
use table::{Along, More, Row, Table};
use two_level::TwoLevel;

pub(crate) fn run(args: &MotionArgs) -> Result<(), Failure> {
    let loaded = planning::load(&args.job, &args.planning)?;
    let period = period(args.period_ms, &loaded.machine)?;
    let commands = args.commands.as_deref().map(commands::read).transpose()?;
    if commands.is_some() {
        run::check_period(period)?;
    }
    let parts = args.coarse_ms.map(|coarse| parts(coarse, period)).transpose()?;
    let motion = planning::plan(&loaded, &args.planning)?;
    loaded.check_count(&motion, period)?;
    if let Some(path) = &args.certificate {
        write_certificate(path, &loaded, &motion)?;
    }
    if let Some(commands) = commands {
        return run::run(&loaded, &motion, &commands, period, args);
    }
    let coarse = period * f64::from(parts.unwrap_or(1));
    let mut progress = Progress::new("cli-progress-set-points", motion.count(coarse, args.air));
    let mut arc = ArcClock::new(&motion);
    let speed = |pass, set: &SetPoint| motion.tip_speed(&loaded.machine, pass, set);
    let more = if args.export == Some(ExportArg::Pvt) { More::Speeds } else { More::None };
    let mut table = Table::new(&loaded, more, args.json);
    if parts.is_none() && args.export.is_none() {
        motion.play(period, args.air, |pass, p, _| {
            progress.step();
            let along = Along::new(pass, &p, speed(pass, &p), arc.at(pass, &p));
            table.row(&Row { t: p.t, along, q: p.q, speeds: None, phase: None })
        })?;
    } else {
        let mut level = TwoLevel::new(table, period, parts.unwrap_or(1), args.export);
        motion.play(coarse, args.air, |pass, p, _| {
            progress.step();
            level.point(Along::new(pass, &p, speed(pass, &p), arc.at(pass, &p)), &p.q)
        })?;
        table = level.finish()?;
    }
    table.finish()
}

#[derive(Serialize)]
struct Certificates<'a> {
    seamwright: &'static str,
    file: &'a str,
    machine: &'a str,
    passes: Vec<CertificateFigures>,
}

fn write_certificate(path: &Path, loaded: &Loaded, motion: &WeldMotion) -> Result<(), Failure> {
    let (program, machine) = (&loaded.welding.program, &loaded.machine);
    let passes = program.value.passes.iter().zip(&motion.passes);
    let certificates = Certificates {
        seamwright: env!("CARGO_PKG_VERSION"),
        file: program.file(),
        machine: &machine.name,
        passes: passes.map(|(pass, planned)| CertificateFigures::new(machine, pass, planned)).collect(),
    };
    files::write(path, &json_text(&certificates)?)
}

/// Fine periods in a coarse one.
fn parts(coarse_ms: f64, period: f64) -> Result<u32, Failure> {
    let coarse = positive("--coarse-ms", coarse_ms)? * 1e-3;
    let parts = coarse / period;
    let whole = parts.round();
    if !(1.0..=1e6).contains(&whole) || (parts - whole).abs() > 1e-9 * parts {
        let fault = Message::new("cli-motion-coarse").value("parts", parts, Unit::One);
        let fault = fault.value("period", period * 1e3, Unit::Ms);
        return Err(refused("--coarse-ms", coarse_ms, fault, Message::new("cli-motion-whole-multiple")));
    }
    Ok(whole as u32)
}
