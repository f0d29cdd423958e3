use super::positive;
use super::process::ProcessColumns;
use crate::args::MotionArgs;
use crate::failure::Failure;
use crate::files;
use crate::load::{Loaded, load};
use crate::progress::Progress;
use crate::rows::{Cell, Rows};
use seamwright_motion::WeldMotion;
use seamwright_report::CertificateFigures;
use serde::Serialize;
use std::path::Path;

pub(crate) fn run(args: &MotionArgs) -> Result<(), Failure> {
    let loaded = load(&args.job)?;
    let machine = &loaded.machine;
    let period = match args.period_ms {
        Some(ms) => positive("--period-ms", ms)? * 1e-3,
        None => machine.servo_period_s,
    };
    let motion = loaded.plan()?;
    loaded.check_count(&motion, period)?;
    if let Some(path) = &args.certificate {
        write_certificate(path, &loaded, &motion)?;
    }
    let program = &loaded.welding.program.value;
    let mut process = ProcessColumns::new(program, &motion);
    let mut columns: Vec<String> = ["t_s", "pass", "s_mm"].map(str::to_owned).into();
    columns.extend(machine.axes.iter().map(|a| a.name.clone()));
    columns.extend(["speed_mm_s".to_owned(), "arc".to_owned()]);
    columns.extend_from_slice(process.names());
    let mut rows = Rows::new(columns, args.json)?;
    let mut progress = Progress::new("set-points", motion.count(period, args.air));
    let mut cells = Vec::new();
    let number = |v: f64| if v.is_finite() { Cell::Number(v) } else { Cell::Empty };
    motion.play(period, args.air, |pass, p, _| {
        progress.step();
        cells.clear();
        cells.extend([Cell::Number(p.t), Cell::Count(pass as u64), number(p.law.s)]);
        cells.extend(machine.axes.iter().zip(&p.q).map(|(axis, q)| Cell::Number(axis.to_file(*q))));
        let arc = p.phase.arc();
        cells.extend([number(p.law.v), Cell::Count(u64::from(arc))]);
        cells.extend(process.values(pass, &p).map(Cell::Number));
        rows.row(&cells)
    })?;
    rows.finish()
}

/// The certificates of all passes, in order.
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
    let json = serde_json::to_string_pretty(&certificates).map_err(|e| Failure::Environment(e.to_string()))?;
    files::write(path, &(json + "\n"))
}
