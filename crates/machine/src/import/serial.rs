//! The chain of a robot from its base to a link at its end.

use super::axis_names::axis_names;
use super::parts::{Owner, shapes};
use super::urdf::{Joint, Limit, Robot, unknown_link};
use super::{ImportOptions, ImportedArm, ImportedAxis, plain_name};
use crate::chain::MAX_AXES;
use glam::{DAffine3, DVec3};
use seamwright_document::DocumentError;
use seamwright_message::{Message, Unit};

/// Millimetres of a metre.
pub(super) const MM: f64 = 1000.0;
/// Longest chain of an arm, m: the largest arms reach 5 m.
const MAX_LENGTH_M: f64 = 50.0;
/// Shortest chain of an arm, m.
const MIN_LENGTH_M: f64 = 0.02;
/// Largest position of a rotary axis, rad: five turns; more are degrees.
const MAX_ANGLE: f64 = 31.5;
/// Highest speed of a rotary axis, rad/s: eight turns per second; more are degrees.
const MAX_ANGULAR_SPEED: f64 = 50.0;
/// Name of the flange by the convention of ROS-Industrial.
const FLANGE: &str = "tool0";

/// Returns the arm between the links that `options` name.
pub(super) fn arm(robot: &Robot<'_>, options: &ImportOptions<'_>) -> Result<ImportedArm, DocumentError> {
    let base = base(robot, options.base)?;
    let mut notes = Vec::new();
    let tip = tip(robot, base, options.tip, &mut notes)?;
    let chain = chain(robot, base, tip)?;
    check_length(robot, &chain, options.scale)?;
    let moving: Vec<&Joint<'_>> =
        chain.iter().map(|&j| &robot.joints[j]).filter(|joint| joint.kind != "fixed").collect();
    if moving.is_empty() || moving.len() > MAX_AXES {
        let fault = Message::new("machine-urdf-axes").count("n", moving.len()).text("link", &robot.links[tip].name);
        let cure = Message::new("machine-urdf-cure-axes").text("max", MAX_AXES.to_string());
        return Err(robot.links[tip].place.error(fault, cure));
    }
    let names = axis_names(&moving.iter().map(|joint| joint.name.as_str()).collect::<Vec<_>>());
    let scale = MM * options.scale;
    let (mut axes, mut frame) = (Vec::new(), DAffine3::IDENTITY);
    for joint in chain.iter().map(|&j| &robot.joints[j]) {
        frame *= in_mm(joint.origin, scale);
        if joint.kind != "fixed" {
            axes.push(axis(joint, names[axes.len()].clone(), &frame, scale)?);
        }
    }
    if robot.rounded_angles > 0 {
        notes.push(Message::new("machine-import-rounded-angles").count("n", robot.rounded_angles));
    }
    let owners = Owner::of(robot, base, &chain, &names, scale, &mut notes);
    let shapes = if options.with_shapes { shapes(robot, &owners, options, &mut notes)? } else { Vec::new() };
    Ok(ImportedArm {
        name: plain_name(&robot.name),
        title: robot.name.clone(),
        source: String::new(),
        axes,
        flange: frame,
        flange_name: robot.links[tip].name.clone(),
        tool: None,
        direction: DVec3::Z,
        work: DAffine3::IDENTITY,
        shapes,
        ignored: Vec::new(),
        notes,
    })
}

/// A displacement in the unit of the source as one in mm.
pub(super) fn in_mm(motion: DAffine3, scale: f64) -> DAffine3 {
    DAffine3 { translation: scale * motion.translation, ..motion }
}

fn named(robot: &Robot<'_>, name: &str) -> Result<usize, DocumentError> {
    let found = robot.links.iter().position(|link| link.name == name);
    found.ok_or_else(|| {
        let known: Vec<&str> = robot.links.iter().map(|link| link.name.as_str()).collect();
        unknown_link(&robot.place, name, &known)
    })
}

/// The link called `name`, or the only one that no joint carries.
fn base(robot: &Robot<'_>, name: Option<&str>) -> Result<usize, DocumentError> {
    if let Some(name) = name {
        return named(robot, name);
    }
    let roots: Vec<usize> = (0..robot.links.len()).filter(|&link| robot.links[link].carrier.is_none()).collect();
    match roots.as_slice() {
        [root] => Ok(*root),
        [] if robot.links.is_empty() => {
            Err(robot.place.error(Message::new("machine-urdf-empty"), Message::new("machine-urdf-cure-root")))
        }
        [] => Err(loop_at(robot, 0)),
        several => {
            let fault = Message::new("machine-urdf-roots").text("links", names(robot, several));
            Err(robot.place.error(fault, Message::new("machine-urdf-cure-roots")))
        }
    }
}

fn names(robot: &Robot<'_>, links: &[usize]) -> String {
    links.iter().map(|&link| robot.links[link].name.as_str()).collect::<Vec<_>>().join(", ")
}

fn loop_at(robot: &Robot<'_>, link: usize) -> DocumentError {
    let link = &robot.links[link];
    let fault = Message::new("machine-urdf-loop").text("link", &link.name);
    link.place.error(fault, Message::new("machine-urdf-cure-tree"))
}

/// The link called `name`; or the only end of the tree that axes move, or of several the one called `tool0`.
fn tip(robot: &Robot<'_>, base: usize, name: Option<&str>, notes: &mut Vec<Message>) -> Result<usize, DocumentError> {
    if let Some(name) = name {
        return named(robot, name);
    }
    let is_end = |link: &usize| robot.joints.iter().all(|joint| joint.parent != *link);
    let moves = |link: &usize| {
        let path = path(robot, base, *link);
        path.is_some_and(|path| path.iter().any(|&j| robot.joints[j].kind != "fixed"))
    };
    let ends: Vec<usize> = (0..robot.links.len()).filter(is_end).filter(moves).collect();
    match ends.as_slice() {
        [end] => Ok(*end),
        [] => {
            let fault = Message::new("machine-urdf-no-axes").text("link", &robot.links[base].name);
            Err(robot.links[base].place.error(fault, Message::new("machine-urdf-cure-no-axes")))
        }
        several => {
            let flange = several.iter().copied().find(|&link| robot.links[link].name == FLANGE);
            if let Some(flange) = flange {
                notes.push(Message::new("machine-import-flange").text("links", names(robot, several)));
                return Ok(flange);
            }
            let fault =
                Message::new("machine-urdf-tips").count("n", several.len()).text("links", names(robot, several));
            Err(robot.place.error(fault, Message::new("machine-urdf-cure-tips")))
        }
    }
}

/// Joints from `base` to `link`; none if the link is not carried by the base.
fn path(robot: &Robot<'_>, base: usize, link: usize) -> Option<Vec<usize>> {
    let (mut path, mut at) = (Vec::new(), link);
    while at != base {
        let joint = robot.links[at].carrier.filter(|_| path.len() < robot.joints.len())?;
        path.push(joint);
        at = robot.joints[joint].parent;
    }
    path.reverse();
    Some(path)
}

fn chain(robot: &Robot<'_>, base: usize, tip: usize) -> Result<Vec<usize>, DocumentError> {
    path(robot, base, tip).ok_or_else(|| {
        let tip = &robot.links[tip];
        let fault = Message::new("machine-urdf-not-carried").text("tip", &tip.name);
        let fault = fault.text("base", &robot.links[base].name);
        tip.place.error(fault, Message::new("machine-urdf-cure-not-carried"))
    })
}

/// Refuses lengths that are not those of an arm in metres.
fn check_length(robot: &Robot<'_>, chain: &[usize], scale: f64) -> Result<(), DocumentError> {
    let lengths = chain.iter().map(|&j| robot.joints[j].origin.translation.length() * scale);
    let length: f64 = lengths.sum();
    let (code, factor) = match length {
        l if l > MAX_LENGTH_M => ("machine-urdf-too-long", "0.001"),
        l if l < MIN_LENGTH_M => ("machine-urdf-too-short", "1000"),
        _ => return Ok(()),
    };
    let fault = Message::new(code).value("length", (length * 1e6).round() * 1e-6, Unit::M);
    let longest = chain.iter().max_by(|a, b| {
        let length = |j: usize| robot.joints[j].origin.translation.length();
        length(**a).total_cmp(&length(**b))
    });
    let place = longest.map_or(&robot.place, |&j| &robot.joints[j].place);
    Err(place.error(fault, Message::new("machine-urdf-cure-scale").text("factor", factor)))
}

fn axis(joint: &Joint<'_>, name: String, frame: &DAffine3, scale: f64) -> Result<ImportedAxis, DocumentError> {
    let is_rotary = match joint.kind.as_str() {
        "revolute" | "continuous" => true,
        "prismatic" => false,
        _ => {
            let fault = Message::new("machine-urdf-joint-type").text("joint", &joint.name);
            return Err(joint.kind_place.error(fault, Message::new("machine-urdf-cure-joint-type")));
        }
    };
    if let Some((other, place)) = &joint.mimic {
        let fault = Message::new("machine-urdf-mimic").text("joint", &joint.name).text("other", other);
        return Err(place.error(fault, Message::new("machine-urdf-cure-mimic")));
    }
    let Some(limit) = &joint.limit else {
        let fault = Message::new("machine-urdf-limit-missing").text("joint", &joint.name);
        return Err(joint.place.error(fault, Message::new("machine-urdf-cure-limit")));
    };
    let unit = if is_rotary { 1.0 } else { scale };
    let range = if joint.kind == "continuous" { None } else { Some(range(joint, limit, is_rotary)?.map(|v| v * unit)) };
    if limit.velocity <= 0.0 {
        let fault = Message::new("machine-urdf-velocity").text("joint", &joint.name);
        return Err(limit.velocity_place.error(fault, Message::new("machine-urdf-cure-velocity")));
    }
    if is_rotary && limit.velocity > MAX_ANGULAR_SPEED {
        return Err(in_degrees(joint, &limit.velocity_place));
    }
    let home = range.map_or(0.0, |[low, high]| if low <= 0.0 && high >= 0.0 { 0.0 } else { 0.5 * (low + high) });
    Ok(ImportedAxis {
        name,
        source_name: joint.name.clone(),
        is_rotary,
        direction: frame.matrix3 * joint.axis,
        at: frame.translation,
        range,
        home,
        max_speed: limit.velocity * unit,
        effort: limit.effort,
    })
}

fn range(joint: &Joint<'_>, limit: &Limit<'_>, is_rotary: bool) -> Result<[f64; 2], DocumentError> {
    if limit.lower >= limit.upper {
        let fault = Message::new("machine-urdf-limit-empty").text("joint", &joint.name);
        let place = if limit.upper_place.key == limit.place.key { &limit.place } else { &limit.upper_place };
        return Err(place.error(fault, Message::new("machine-urdf-cure-limit")));
    }
    if is_rotary && limit.lower.abs().max(limit.upper.abs()) > MAX_ANGLE {
        return Err(in_degrees(joint, &limit.upper_place));
    }
    Ok([limit.lower, limit.upper])
}

fn in_degrees(joint: &Joint<'_>, place: &super::xml::Place<'_>) -> DocumentError {
    let fault = Message::new("machine-urdf-degrees").text("joint", &joint.name);
    place.error(fault, Message::new("machine-urdf-cure-degrees"))
}
