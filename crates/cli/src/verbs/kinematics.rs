use crate::args::KinematicsArgs;
use crate::refusals::{of_option, refused};
use crate::rows::{Cell, Rows};
use glam::DVec3;
use seamwright_machine::{ArmConfiguration, Elbow, Joints, Machine, Shoulder, Solution, Target, WristSide};
use seamwright_message::{Language, Message};
use seamwright_project::csv::CsvReader;
use seamwright_project::failure::Failure;
use seamwright_project::load;
use std::io;

const POSE: [&str; 6] = ["x_mm", "y_mm", "z_mm", "ax", "ay", "az"];
/// Direction across the torch, with `--frame`.
const ACROSS: [&str; 3] = ["ux", "uy", "uz"];

pub(crate) fn run(args: &KinematicsArgs) -> Result<(), Failure> {
    let machine = head(load::machine(&args.machine)?, args.head.as_deref())?;
    if args.configuration && machine.arm_configuration(&machine.home()).is_none() {
        let fault = Message::new("cli-no-configurations");
        return Err(Failure::input(of_option("--configuration", fault)));
    }
    if args.arm_angle_deg.is_some() && machine.arm_angle(&machine.home()).is_none() {
        return Err(Failure::input(of_option("--arm-angle-deg", Message::new("cli-no-arm-angle"))));
    }
    let axes: Vec<&str> = machine.axes.iter().map(|a| a.name.as_str()).collect();
    let pose: Vec<&str> = POSE.into_iter().chain(ACROSS.into_iter().filter(|_| args.frame)).collect();
    let configuration = configuration_columns(&machine, args);
    let owned = |names: &[&str]| names.iter().map(|n| (*n).to_owned()).collect::<Vec<String>>();
    if args.forward {
        let mut rows = Rows::new(owned(&[&pose[..], &configuration].concat()), args.json);
        each_row(&axes, |values| forward(&machine, values, args, &mut rows))?;
        return rows.finish();
    }
    let row: &[&str] = if args.branches { &["row"] } else { &[] };
    let columns = [row, &axes[..], &["error", "attitude_error_deg"], &configuration].concat();
    let mut rows = Rows::new(owned(&columns), args.json);
    let mut near = machine.home();
    let mut number = 0;
    each_row(&pose, |values| {
        number += 1;
        let solutions = match target(values, args) {
            Ok(target) if args.branches => branches(&machine, &target, &near),
            Ok(target) => vec![inverse(&machine, &target, &near, args.continuous).map_err(Missing::all)],
            Err(reason) => vec![Err(Missing::all(reason))],
        };
        if let ([Ok(solution)], true) = (&solutions[..], args.continuous) {
            near = solution.joints;
        }
        let mut write = |solution: &Result<Solution, Missing>| {
            write_solution(&machine, solution, args, number, configuration.len(), &mut rows)
        };
        solutions.iter().try_for_each(&mut write)
    })?;
    rows.finish()
}

fn configuration_columns(machine: &Machine, args: &KinematicsArgs) -> Vec<&'static str> {
    let arm_angle = machine.arm_angle(&machine.home()).map(|_| "arm_angle_deg");
    let names = ["shoulder", "elbow", "wrist", "turns"].into_iter().chain(arm_angle);
    names.filter(|_| args.configuration).collect()
}

/// Names of an arm's configuration, and its arm angle.
struct Named {
    words: [String; 4],
    arm_angle_deg: Option<f64>,
}

impl Named {
    fn new(machine: &Machine, q: &Joints) -> Option<Self> {
        let ArmConfiguration { shoulder, elbow, wrist, turns } = machine.arm_configuration(q)?;
        let shoulder = if shoulder == Shoulder::Front { "front" } else { "back" };
        let elbow = if elbow == Elbow::Up { "up" } else { "down" };
        let wrist = if wrist == WristSide::NoFlip { "no_flip" } else { "flip" };
        let turns = turns.map(|turn| turn.to_string()).join(" ");
        let words = [shoulder.to_owned(), elbow.to_owned(), wrist.to_owned(), turns];
        Some(Self { words, arm_angle_deg: machine.arm_angle(q).map(f64::to_degrees) })
    }

    fn cells(&self) -> impl Iterator<Item = Cell<'_>> {
        self.words.iter().map(|word| Cell::Text(word)).chain(self.arm_angle_deg.map(Cell::Number))
    }
}

fn forward(machine: &Machine, values: &[f64], args: &KinematicsArgs, rows: &mut Rows) -> Result<(), Failure> {
    let q = machine.joints_from_file(values);
    let pose = machine.forward(&q);
    let across = args.frame.then(|| machine.across(&q));
    let vectors = [pose.point, pose.direction].into_iter().chain(across);
    let named = Named::new(machine, &q).filter(|_| args.configuration);
    let cells = vectors.flat_map(|v| v.to_array().map(Cell::Number));
    rows.row(&cells.chain(named.iter().flat_map(Named::cells)).collect::<Vec<_>>())
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

/// Reason why a row has no solution, and positions beyond a range.
struct Missing {
    reason: Message,
    joints: Option<Joints>,
}

impl Missing {
    fn all(reason: Message) -> Self {
        Self { reason, joints: None }
    }
}

/// The pose or frame of a row.
fn target(values: &[f64], args: &KinematicsArgs) -> Result<Target, Message> {
    let direction = |at: usize| {
        let v = DVec3::new(values[at], values[at + 1], values[at + 2]);
        v.try_normalize().ok_or_else(|| Message::new("cli-direction-without-length"))
    };
    let point = DVec3::new(values[0], values[1], values[2]);
    let first = seamwright_geometry::Pose { point, direction: direction(3)? };
    let across = if args.frame { Some(direction(6)?) } else { None };
    Ok(Target { across, arm_angle: args.arm_angle_deg.map(f64::to_radians), ..Target::from(first) })
}

/// The positions for a pose: near the row before, or within all ranges and nearest to home.
fn inverse(machine: &Machine, target: &Target, near: &Joints, continuous: bool) -> Result<Solution, Message> {
    if continuous {
        let solution = machine.inverse_near(*target, near).map_err(|e| e.message())?;
        return machine.outside(&solution.joints).map_or(Ok(solution), |v| Err(machine.range_error(&v).message()));
    }
    let found = machine.reach(*target, near).map_err(|e| e.message())?;
    let far = |s: &Solution| -> f64 {
        machine.axes.iter().zip(s.joints.iter().zip(near)).map(|(a, (p, q))| ((p - q) / a.max_speed).powi(2)).sum()
    };
    // If the direction cannot be met, the branch that comes nearest to it is used; then the one nearest to the present
    // axis positions.
    let cost = |s: &Solution| (s.attitude_error * 1e6).round() * 1e6 + far(s);
    let best = found.into_iter().min_by(|a, b| cost(a).total_cmp(&cost(b)));
    best.ok_or_else(|| Message::new("cli-pose-out-of-reach"))
}

/// All branches, turned into the ranges; those that stay beyond one with its reason.
fn branches(machine: &Machine, target: &Target, near: &Joints) -> Vec<Result<Solution, Missing>> {
    let all = match machine.inverse(*target, near) {
        Ok(all) => all,
        Err(reason) => return vec![Err(Missing::all(reason.message()))],
    };
    let within = |solution: &Solution| {
        let joints = machine.turned_into_range(&solution.joints);
        match machine.outside(&joints) {
            None => Ok(Solution { joints, ..*solution }),
            Some(beyond) => Err(Missing { reason: machine.range_error(&beyond).message(), joints: Some(joints) }),
        }
    };
    all.iter().map(within).collect()
}

fn write_solution(
    machine: &Machine,
    solution: &Result<Solution, Missing>,
    args: &KinematicsArgs,
    number: u32,
    configuration: usize,
    rows: &mut Rows,
) -> Result<(), Failure> {
    let (joints, reason, error) = match solution {
        Ok(s) => (Some(s.joints), None, Some(s.attitude_error.to_degrees())),
        // A table is data, so it is English in every language.
        Err(missing) => (missing.joints, Some(missing.reason.in_language(Language::English)), None),
    };
    let named = joints.and_then(|q| Named::new(machine, &q)).filter(|_| args.configuration);
    let mut cells = Vec::new();
    cells.extend(args.branches.then(|| Cell::Number(f64::from(number))));
    match &joints {
        Some(q) => cells.extend(machine.axes.iter().zip(q).map(|(a, q)| Cell::Number(a.to_file(*q)))),
        None => cells.extend(machine.axes.iter().map(|_| Cell::Empty)),
    }
    cells.push(reason.as_deref().map_or(Cell::Empty, Cell::Text));
    cells.push(error.map_or(Cell::Empty, Cell::Number));
    match &named {
        Some(named) => cells.extend(named.cells()),
        None => cells.extend((0..configuration).map(|_| Cell::Empty)),
    }
    rows.row(&cells)
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
