use crate::args::KinematicsArgs;
use crate::refusals::refused;
use crate::rows::{Cell, Rows};
use glam::DVec3;
use seamwright_machine::{Joints, Machine, Solution};
use seamwright_message::{Language, Message};
use seamwright_project::csv::CsvReader;
use seamwright_project::failure::Failure;
use seamwright_project::load;
use std::io;

const POSE: [&str; 6] = ["x_mm", "y_mm", "z_mm", "ax", "ay", "az"];

pub(crate) fn run(args: &KinematicsArgs) -> Result<(), Failure> {
    let machine = head(load::machine(&args.machine)?, args.head.as_deref())?;
    let names: Vec<&str> = machine.axes.iter().map(|a| a.name.as_str()).collect();
    let owned = |names: &[&str]| names.iter().map(|n| (*n).to_owned()).collect::<Vec<String>>();
    if args.forward {
        let mut rows = Rows::new(owned(&POSE), args.json);
        each_row(&names, |values| forward(&machine, values, &mut rows))?;
        return rows.finish();
    }
    let mut rows = Rows::new(owned(&[&names[..], &["error", "attitude_error_deg"]].concat()), args.json);
    let mut near = machine.home();
    each_row(&POSE, |values| {
        let solution = inverse(&machine, values, &near, args.continuous);
        if let (Ok(solution), true) = (&solution, args.continuous) {
            near = solution.joints;
        }
        write_solution(&machine, solution, &mut rows)
    })?;
    rows.finish()
}

fn forward(machine: &Machine, values: &[f64], rows: &mut Rows) -> Result<(), Failure> {
    let mut q = Joints::default();
    for ((q, axis), value) in q.iter_mut().zip(&machine.axes).zip(values) {
        *q = axis.from_file(*value);
    }
    let pose = machine.forward(&q);
    let [x, y, z] = pose.point.to_array().map(Cell::Number);
    let [a, b, c] = pose.direction.to_array().map(Cell::Number);
    rows.row(&[x, y, z, a, b, c])
}

/// The machine with the head that is asked for.
fn head(machine: Machine, name: Option<&str>) -> Result<Machine, Failure> {
    let Some(name) = name else { return Ok(machine) };
    let names: Vec<&str> = machine.heads.iter().map(|h| h.name.as_str()).collect();
    match names.iter().position(|n| *n == name) {
        Some(head) => Ok(machine.with_first_head(head)),
        None => Err(refused("--head", name, Message::new("cli-no-such-head"), names.join(", "))),
    }
}

/// The positions for a pose: near the row before, or within all ranges and nearest to home.
fn inverse(machine: &Machine, values: &[f64], near: &Joints, continuous: bool) -> Result<Solution, Message> {
    let direction = DVec3::new(values[3], values[4], values[5]);
    let Some(direction) = direction.try_normalize() else { return Err(Message::new("cli-direction-without-length")) };
    let pose = seamwright_geometry::Pose { point: DVec3::new(values[0], values[1], values[2]), direction };
    if continuous {
        let solution = machine.inverse_near(pose, near).map_err(|e| e.message())?;
        return machine.outside(&solution.joints).map_or(Ok(solution), |v| Err(machine.range_error(&v).message()));
    }
    let found = machine.reach(pose, near).map_err(|e| e.message())?;
    let far = |s: &Solution| -> f64 {
        machine.axes.iter().zip(s.joints.iter().zip(near)).map(|(a, (p, q))| ((p - q) / a.max_speed).powi(2)).sum()
    };
    // If the direction cannot be met, the branch that comes nearest to it is used; then the one nearest to the present
    // axis positions.
    let cost = |s: &Solution| (s.attitude_error * 1e6).round() * 1e6 + far(s);
    let best = found.into_iter().min_by(|a, b| cost(a).total_cmp(&cost(b)));
    best.ok_or_else(|| Message::new("cli-pose-out-of-reach"))
}

fn write_solution(machine: &Machine, solution: Result<Solution, Message>, rows: &mut Rows) -> Result<(), Failure> {
    match solution {
        Ok(s) => {
            let mut cells: Vec<Cell> =
                machine.axes.iter().zip(&s.joints).map(|(a, q)| Cell::Number(a.to_file(*q))).collect();
            cells.extend([Cell::Empty, Cell::Number(s.attitude_error.to_degrees())]);
            rows.row(&cells)
        }
        Err(reason) => {
            let mut cells = vec![Cell::Empty; machine.axes.len()];
            // A table is data, so it is English in every language.
            let reason = reason.in_language(Language::English);
            cells.extend([Cell::Text(&reason), Cell::Empty]);
            rows.row(&cells)
        }
    }
}

/// Reads CSV with the columns `names` (in any order, others ignored) from standard input.
fn each_row(names: &[&str], mut row: impl FnMut(&[f64]) -> Result<(), Failure>) -> Result<(), Failure> {
    let source = Message::new("cli-standard-input").to_string();
    let (mut reader, _) = CsvReader::open(&source, io::stdin().lock(), &[names])?;
    while let Some(values) = reader.row() {
        row(values?)?;
    }
    Ok(())
}
