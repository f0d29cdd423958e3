//! Self-tests of a machine file: round trip of the inverse, Jacobian against differences, plausible limits, singular
//! configurations, reach. Seeded, without I/O.

mod english;
mod hill_climb;
mod jacobian;
mod random;
mod reach;
mod round_trip;
mod sanity;
mod singular;
mod skeleton;
mod task;
mod thresholds;
mod voxels;

pub use jacobian::JacobianCheck;
pub use reach::Reach;
pub use round_trip::RoundTrip;
pub use sanity::{Remark, remarks};
pub use singular::{SingularPlace, Singularities};
pub use skeleton::{AxisPlace, Side, Skeleton};
pub use task::{TYPICAL_RADIUS_MM, TYPICAL_SPEED_MM_S};
pub use voxels::Volume;

use crate::axis::{Axis, AxisKind};
use crate::file::MachineFile;
use crate::machine::Machine;
use seamwright_document::Document;
use seamwright_message::Message;
use serde::Serialize;
use task::Task;

/// Extent and random seed of a check.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct CheckOptions {
    /// The same seed gives the same result.
    pub seed: u64,
    /// Random positions of the round trip, for each head and for the pair.
    pub poses: u32,
}

/// Results of all tests; lengths in mm, angles in degrees, as in the file.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Check {
    /// Short name of the machine.
    pub name: String,
    /// Its title.
    pub title: String,
    /// Seed of the random positions.
    pub seed: u64,
    /// True if every test passed; remarks do not count.
    pub passed: bool,
    /// Descriptions of the failures.
    #[serde(serialize_with = "english::list")]
    pub failures: Vec<Message>,
    /// Unusual values.
    pub remarks: Vec<Remark>,
    /// The axes with their limits.
    pub axes: Vec<AxisFigures>,
    /// Each head alone.
    pub heads: Vec<HeadCheck>,
    /// Both heads at once, on machines that support it.
    pub pair: Option<RoundTrip>,
}

/// One axis in file units.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct AxisFigures {
    /// Name.
    pub name: String,
    /// Letter in part programs.
    pub letter: Option<char>,
    /// `linear` or `rotary`.
    pub kind: &'static str,
    /// mm or deg.
    pub unit: &'static str,
    /// `torch` or `work`.
    pub moves: &'static str,
    /// Lowest and highest position; none without end stops.
    pub range: Option<(f64, f64)>,
    /// Position after homing.
    pub home: f64,
    /// Maximum speed, 1/s.
    pub max_speed: f64,
    /// Maximum acceleration, 1/s^2.
    pub max_acceleration: f64,
    /// Maximum jerk, 1/s^3; none without a limit.
    pub max_jerk: Option<f64>,
    /// Time from rest to the maximum speed at the maximum acceleration, s.
    pub to_speed_s: f64,
}

/// The tests of one head.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct HeadCheck {
    /// Name of the head.
    pub name: String,
    /// Description of the inverse kinematics.
    #[serde(serialize_with = "english::one")]
    pub structure: Message,
    /// Forward, inverse, forward.
    pub round_trip: RoundTrip,
    /// Jacobian and differences.
    pub jacobian: JacobianCheck,
    /// Singular configurations.
    pub singular: Singularities,
    /// Reach.
    pub reach: Reach,
}

impl Check {
    /// Maximum number of steps of a check, for a progress bar.
    pub fn steps(machine: &Machine, options: &CheckOptions) -> u64 {
        let others = u64::from(singular::LOOKED_AT + reach::LOOKED_AT) + voxels::SIDE.pow(3) as u64;
        let pair = u64::from(machine.can_pair()) * u64::from(options.poses);
        machine.heads.len() as u64 * (u64::from(options.poses) + others) + pair
    }

    /// Runs all tests; `step` is called for every position tried.
    pub fn run(
        file: &Document<MachineFile>,
        machine: &Machine,
        options: &CheckOptions,
        step: &mut dyn FnMut(),
    ) -> Self {
        let heads: Vec<HeadCheck> = (0..machine.heads.len())
            .map(|head| one_head(&machine.clone().with_first_head(head), options, step))
            .collect();
        let pair = machine.can_pair().then(|| round_trip::pair(machine, options.seed, options.poses, step));
        let failures = failures(&heads, pair.as_ref());
        let skeleton = machine.skeleton(&machine.home());
        let axes = machine.axes.iter().zip(&skeleton.axes).map(|(axis, place)| figures(axis, place.side)).collect();
        Self {
            name: machine.name.clone(),
            title: machine.title.clone(),
            seed: options.seed,
            passed: failures.is_empty(),
            failures,
            remarks: remarks(file, machine),
            axes,
            heads,
            pair,
        }
    }
}

fn one_head(machine: &Machine, options: &CheckOptions, step: &mut dyn FnMut()) -> HeadCheck {
    let task = Task::new(machine);
    HeadCheck {
        name: machine.heads[0].name.clone(),
        structure: machine.heads[0].structure(&machine.axes),
        round_trip: round_trip::one_head(&task, options.seed, options.poses, step),
        jacobian: jacobian::check(machine, options.seed),
        singular: singular::find(&task, options.seed, step),
        reach: reach::find(machine, options.seed, step),
    }
}

fn failures(heads: &[HeadCheck], pair: Option<&RoundTrip>) -> Vec<Message> {
    let mut failures = Vec::new();
    for head in heads {
        let failed = |why| Message::new("machine-check-head").text("head", &head.name).message("why", why);
        if !head.round_trip.passed {
            failures.push(failed(round_trip_failure(&head.round_trip)));
        }
        if !head.jacobian.passed {
            let why = Message::new("machine-check-jacobian")
                .text("difference", format!("{:.1e}", head.jacobian.relative))
                .axis("axis", &head.jacobian.axis);
            failures.push(failed(why));
        }
    }
    if let Some(pair) = pair.filter(|p| !p.passed) {
        failures.push(Message::new("machine-check-pair").message("why", round_trip_failure(pair)));
    }
    failures
}

fn round_trip_failure(r: &RoundTrip) -> Message {
    let small = |value: f64| format!("{value:.1e}");
    Message::new("machine-check-round-trip")
        .text("distance", small(r.point_mm))
        .text("angle", small(r.direction_deg))
        .text("difference", small(r.axes_mm_or_deg))
        .count("unsolved", (r.unsolved - r.off_centre) as usize)
        .count("missed", r.branch_missed as usize)
}

fn figures(axis: &Axis, side: Side) -> AxisFigures {
    AxisFigures {
        name: axis.name.clone(),
        letter: axis.letter,
        kind: if axis.kind == AxisKind::Linear { "linear" } else { "rotary" },
        unit: axis.unit(),
        moves: if side == Side::Tool { "torch" } else { "work" },
        range: axis.range.map(|(low, high)| (axis.to_file(low), axis.to_file(high))),
        home: axis.to_file(axis.home),
        max_speed: axis.to_file(axis.max_speed),
        max_acceleration: axis.to_file(axis.max_acceleration),
        max_jerk: axis.max_jerk.is_finite().then(|| axis.to_file(axis.max_jerk)),
        to_speed_s: axis.max_speed / axis.max_acceleration,
    }
}
