//! Frames of the machine file: seen, changed, and taught by touched points.

use super::answer::{Answer, Refused};
use super::jog::base;
use super::panel::{Panel, Shared};
use super::setup::{Changed, ChangedPart, OfCell, of_cell, tell};
use crate::cell::Change;
use crate::limits::MAX_FRAMES;
use crate::users::Session;
use crate::view::rows;
use crate::wire::{FrameChange, FrameEntry, FramePoints, FrameTaught, FramesView};
use axum::Json;
use axum::extract::State;
use glam::{DAffine3, DMat3, DVec3};
use seamwright_document::Transform;
use seamwright_machine::{Joints, Machine, MachineFile};
use seamwright_message::{Message, Unit};
use seamwright_project::own_machine::{OwnMachine, Setting, Step};
use std::path::Path;
use std::sync::Arc;

/// Maximum coordinate of a frame, mm.
const FARTHEST_MM: f64 = 1e5;
/// Minimum distance of the points that teach a frame, mm: 0.1 mm of touching is then less than 0.3 degrees.
const MIN_APART_MM: f64 = 20.0;
/// Minimum angle between the directions to the points on the axis and in the plane, degrees.
const MIN_ANGLE_DEG: f64 = 15.0;
/// Maximum deviation of the axes of a sent frame from length 1 and right angles.
const SQUARE: f64 = 1e-4;

/// A step of the file with a fixed displacement: its branch and number, and its name for people.
struct FixedStep {
    branch: &'static str,
    nth: usize,
    kind: &'static str,
    /// The frame in which it is given.
    within: &'static str,
}

impl FixedStep {
    fn id(&self) -> String {
        format!("{} {}", self.branch, self.nth)
    }
}

/// Fixed steps of a machine file, named as robots name them.
fn fixed_steps(file: &MachineFile) -> Vec<(FixedStep, Transform)> {
    let mut all = Vec::new();
    let last_axis = file.tool.iter().rposition(|step| step.axis.is_some());
    let behind = |nth: usize| last_axis.is_none_or(|axis| nth > axis);
    let ends = file.tool.iter().enumerate().filter(|(nth, step)| behind(*nth) && step.fixed.is_some()).count();
    let mut end = 0;
    for (nth, step) in file.tool.iter().enumerate() {
        let Some(fixed) = step.fixed else { continue };
        let (kind, within) = if !behind(nth) {
            ("mount", "before")
        } else {
            end += 1;
            match (end == ends, end == 1) {
                (true, true) => ("tool", "before"),
                (true, false) => ("tool", "flange"),
                (false, true) => ("flange", "before"),
                (false, false) => ("adapter", "flange"),
            }
        };
        all.push((FixedStep { branch: "tool", nth, kind, within }, fixed));
    }
    let last = file.work.iter().rposition(|step| step.fixed.is_some());
    for (nth, step) in file.work.iter().enumerate() {
        let Some(fixed) = step.fixed else { continue };
        let kind = if last == Some(nth) { "work" } else { "table" };
        let is_first = file.work[..nth].iter().all(|before| before.axis.is_none() && before.fixed.is_none());
        all.push((FixedStep { branch: "work", nth, kind, within: if is_first { "base" } else { "before" } }, fixed));
    }
    all
}

/// All frames of a file: those of steps, of the machine, and of users.
fn entries(machine: &Machine, file: &MachineFile) -> Vec<FrameEntry> {
    let entry = |id: String, kind: &str, within: &str, frame: &DAffine3, editable: bool| FrameEntry {
        id,
        kind: kind.to_owned(),
        name: String::new(),
        within: within.to_owned(),
        frame: rows(frame),
        editable,
        before: None,
    };
    let home = Joints::default();
    let mut all = vec![entry("base".to_owned(), "base", "work", &base(machine, &home), false)];
    let steps = fixed_steps(file);
    all.extend(steps.iter().map(|(step, fixed)| entry(step.id(), step.kind, step.within, &fixed.affine(), true)));
    all.push(entry("tcp".to_owned(), "tcp", "flange", &machine.heads[0].tool, false));
    all.extend(file.frames.iter().map(|(name, frame)| FrameEntry {
        name: name.clone(),
        ..entry(format!("user {name}"), "user", "base", &frame.affine(), true)
    }));
    all
}

fn file_of(own: &OwnMachine, text: &str) -> Result<MachineFile, Refused> {
    let name = own.path.file_name().map_or_else(|| "machine.toml".into(), |name| name.to_string_lossy());
    let read = MachineFile::read(&name, text).map_err(seamwright_project::Failure::from)?;
    Ok(read.value)
}

/// Frames of the file before the last change, by their identifiers.
fn before(of: &OfCell) -> Vec<FrameEntry> {
    let mut path = of.own.path.clone().into_os_string();
    path.push(".before");
    let text = std::fs::read_to_string(Path::new(&path)).ok();
    let file = text.and_then(|text| file_of(&of.own, &text).ok());
    file.map(|file| entries(&of.machine, &file)).unwrap_or_default()
}

fn view(panel: &Panel, of: &OfCell) -> Result<FramesView, Refused> {
    let mut frames = entries(&of.machine, &file_of(&of.own, &of.own.text)?);
    let before = before(of);
    for frame in frames.iter_mut().filter(|frame| frame.editable) {
        let was = before.iter().find(|was| was.id == frame.id).map(|was| was.frame);
        frame.before = was.filter(|was| was.iter().zip(&frame.frame).any(|(a, b)| (a - b).abs() > 1e-9));
    }
    Ok(FramesView { file: of.file(panel), pending: of.pending(panel), arm: of.machine.has_free_roll(), frames })
}

pub(super) async fn frames(State(panel): Shared) -> Answer<FramesView> {
    panel.run(|panel| &panel.drawing, move |panel| view(panel, &of_cell(panel)?)).await.map(Json)
}

/// The rigid motion of a sent frame.
fn affine(frame: &[f64; 12]) -> Result<DAffine3, Refused> {
    let row = |i: usize| DVec3::new(frame[4 * i], frame[4 * i + 1], frame[4 * i + 2]);
    let matrix3 = DMat3::from_cols(row(0), row(1), row(2)).transpose();
    let translation = DVec3::new(frame[3], frame[7], frame[11]);
    let is_square = (matrix3.transpose() * matrix3).abs_diff_eq(DMat3::IDENTITY, SQUARE) && matrix3.determinant() > 0.0;
    let is_near = translation.is_finite() && translation.abs().max_element() <= FARTHEST_MM;
    if !(is_square && is_near) {
        return Err(Message::new("server-frame-invalid").value("max", FARTHEST_MM, Unit::Mm).into());
    }
    Ok(DAffine3 { matrix3, translation })
}

/// Settings of a table with a displacement: rounded to 0.0001 mm and 1e-7 degrees, beyond any measurement.
fn settings(frame: &DAffine3) -> Result<Vec<(&'static str, Setting)>, Refused> {
    let invalid = || Refused::input(Message::new("server-frame-invalid").value("max", FARTHEST_MM, Unit::Mm));
    let transform = Transform::from_affine(frame).ok_or_else(invalid)?;
    let rounded = |v: f64, digit: f64| (v * digit).round() / digit + 0.0;
    let move_mm = transform.move_mm.get().to_array().map(|v| rounded(v, 1e4));
    let turn = transform.turn.map_or_else(Vec::new, |turn| turn.unit().to_array().map(|v| rounded(v, 1e9)).to_vec());
    let angle = rounded(transform.angle_deg.get(), 1e7);
    let is_turned = angle.abs() > 0.0 && !turn.is_empty();
    Ok(vec![
        ("move_mm", Setting::Row(move_mm.to_vec())),
        ("turn", Setting::Row(if is_turned { turn } else { Vec::new() })),
        ("angle_deg", Setting::Number(is_turned.then_some(angle))),
    ])
}

/// The text of the file with the changed frame.
fn changed(of: &OfCell, asked: &FrameChange) -> Result<String, Refused> {
    let unknown =
        || Refused::input(Message::new("server-no-frame").text("name", &asked.id).text("allowed", "GET /api/frames"));
    if let Some(name) = asked.id.strip_prefix("user ") {
        let Some(frame) = &asked.frame else {
            return Ok(of.own.with(&[Step::Table("frames")], &[(name, Setting::Number(None))])?);
        };
        let file = file_of(&of.own, &of.own.text)?;
        if !file.frames.contains_key(name) && file.frames.len() >= MAX_FRAMES {
            return Err(Message::new("server-too-many-frames").count("max", MAX_FRAMES).into());
        }
        return Ok(of.own.with(&[Step::Table("frames"), Step::Table(name)], &settings(&affine(frame)?)?)?);
    }
    let file = file_of(&of.own, &of.own.text)?;
    let (step, _) = fixed_steps(&file).into_iter().find(|(step, _)| step.id() == asked.id).ok_or_else(unknown)?;
    // A step of the machine is changed, never removed.
    let frame = affine(asked.frame.as_ref().ok_or_else(unknown)?)?;
    Ok(of.own.with(&[Step::Nth(step.branch, step.nth), Step::Table("fixed")], &settings(&frame)?)?)
}

/// A frame as text for the audit log.
fn written(frame: Option<&[f64; 12]>) -> String {
    let transform = frame.and_then(|frame| affine(frame).ok()).and_then(|frame| Transform::from_affine(&frame));
    transform.map_or_else(
        || "-".to_owned(),
        |of| {
            let [x, y, z] = of.move_mm.get().to_array();
            let [a, b, c] = of.turn.map_or([0.0, 0.0, 1.0], |turn| turn.unit().to_array());
            let angle = of.angle_deg.get();
            format!("move_mm [{x:.3}, {y:.3}, {z:.3}] turn [{a:.5}, {b:.5}, {c:.5}] angle_deg {angle:.4}")
        },
    )
}

pub(super) async fn keep(State(panel): Shared, session: Session, Json(asked): Json<FrameChange>) -> Answer<FramesView> {
    let kept = move |panel: &Arc<Panel>| {
        let of = of_cell(panel)?;
        let was = view(panel, &of)?.frames.into_iter().find(|frame| frame.id == asked.id).map(|frame| frame.frame);
        let text = changed(&of, &asked)?;
        let kept = of.keep(text)?;
        let (view, file) = (view(panel, &kept)?, kept.file(panel));
        let (old, new) = (written(was.as_ref()), written(asked.frame.as_ref()));
        let part = ChangedPart { kind: Changed::Frame, name: &asked.id, file: &file };
        tell(panel, &session.user, part, Change { old: &old, new: &new });
        in_force(panel, &kept.machine);
        Ok(view)
    };
    panel.run(|panel| &panel.planning, kept).await.map(Json)
}

/// User frames are in force at once: no motion of a program depends on them.
fn in_force(panel: &Panel, kept: &Machine) {
    if let Some(machine) = panel.cell.hub.machine().filter(|machine| machine.name == kept.name) {
        let mut machine = (*machine).clone();
        if machine.user_frames != kept.user_frames {
            machine.user_frames.clone_from(&kept.user_frames);
            panel.cell.hub.set_machine(&machine);
        }
    }
}

pub(super) async fn teach(State(panel): Shared, Json(asked): Json<FramePoints>) -> Answer<FrameTaught> {
    panel.run(|panel| &panel.drawing, move |panel| taught(&*panel.machine()?, &asked)).await.map(Json)
}

/// The frame through three points that the tip has touched: origin, a point on x, a point on the side of y.
fn taught(machine: &Machine, asked: &FramePoints) -> Result<FrameTaught, Refused> {
    let mut points = Vec::new();
    for axes in &asked.touches {
        if axes.len() != machine.axes.len() || axes.iter().any(|v| !v.is_finite() || v.abs() > 1e6) {
            let message = Message::new("server-touch").text("touch", format!("{axes:?}"));
            return Err(message.count("n", machine.axes.len()).into());
        }
        let q = machine.joints_from_file(axes);
        points.push(base(machine, &q).inverse().transform_point3(machine.forward(&q).point));
    }
    let [origin, on_x, in_plane] = points[..] else {
        return Err(Message::new("server-frame-three-points").count("n", points.len()).into());
    };
    let (x, side) = (on_x - origin, in_plane - origin);
    let apart_mm = x.length().min(side.length());
    if apart_mm < MIN_APART_MM {
        let message = Message::new("server-frame-too-near").quantity("distance", apart_mm, Unit::Mm, 1);
        return Err(message.value("min", MIN_APART_MM, Unit::Mm).into());
    }
    let angle = x.angle_between(side).to_degrees();
    if !(MIN_ANGLE_DEG..=180.0 - MIN_ANGLE_DEG).contains(&angle) {
        let message = Message::new("server-frame-on-line").quantity("angle", angle, Unit::Deg, 1);
        return Err(message.value("min", MIN_ANGLE_DEG, Unit::Deg).into());
    }
    let x = x.normalize();
    let z = x.cross(side).normalize();
    let frame = DAffine3 { matrix3: DMat3::from_cols(x, z.cross(x), z), translation: origin };
    Ok(FrameTaught { frame: rows(&frame), apart_mm, angle_deg: angle })
}

#[cfg(test)]
mod tests {
    use super::*;
    use seamwright_machine::shipped;

    fn machine(name: &str) -> (Machine, MachineFile) {
        let text = shipped(name).unwrap().text;
        (Machine::read("m", text).unwrap(), MachineFile::read("m", text).unwrap().value)
    }

    #[test]
    fn fixed_steps_have_the_names_of_robots() {
        let names = |machine_name: &str| {
            let (machine, file) = machine(machine_name);
            let all = entries(&machine, &file);
            all.iter().map(|of| format!("{} {} in {}", of.id, of.kind, of.within)).collect::<Vec<_>>()
        };
        assert_eq!(
            names("irb-2600-positioner"),
            [
                "base base in work",
                "tool 6 flange in before",
                "tool 7 tool in flange",
                "work 0 table in base",
                "work 2 work in before",
                "tcp tcp in flange"
            ]
        );
        assert_eq!(names("torch-5axis")[1..3], ["tool 2 mount in before", "tool 5 tool in before"]);
    }

    /// The tool centre point in the flange is the tool frame with the tip, for a machine with a tip of its own.
    #[test]
    fn the_tool_centre_point_is_that_of_the_chain() {
        let text = shipped("ur10e").unwrap().text.replace("stick_out_mm = 15", "stick_out_mm = 15\ntip_mm = [1, 2, 3]");
        let (machine, file) = (Machine::read("m", &text).unwrap(), MachineFile::read("m", &text).unwrap().value);
        let all = entries(&machine, &file);
        let of = |kind: &str| affine(&all.iter().find(|of| of.kind == kind).unwrap().frame).unwrap();
        let wanted = of("tool") * DAffine3::from_translation(DVec3::new(1.0, 2.0, 3.0));
        assert!(of("tcp").abs_diff_eq(wanted, 1e-9));
    }

    /// Three touched points of a frame give that frame, wherever on axis and plane they are.
    #[test]
    fn three_points_teach_a_frame() {
        let (machine, _) = machine("ur10e");
        let wanted = DAffine3::from_rotation_translation(
            glam::DQuat::from_euler(glam::EulerRot::XYZ, 0.1, -0.2, 0.7),
            DVec3::new(-700.0, -300.0, 200.0),
        );
        let home = machine.home();
        let touch = |local: DVec3| {
            let in_work = base(&machine, &home) * wanted * DAffine3::from_translation(local);
            let pose = seamwright_geometry::Pose { point: in_work.translation, ..machine.forward(&home) };
            let found = machine.reach(pose, &home).unwrap()[0].joints;
            machine.axes.iter().zip(found).map(|(axis, q)| axis.to_file(q)).collect::<Vec<f64>>()
        };
        let points = |a: DVec3, b: DVec3| FramePoints { touches: vec![touch(DVec3::ZERO), touch(a), touch(b)] };
        let taught = taught(&machine, &points(DVec3::X * 200.0, DVec3::new(-50.0, 120.0, 0.0))).unwrap();
        assert!(affine(&taught.frame).unwrap().abs_diff_eq(wanted, 1e-6), "{taught:?}");
        let refused = |a: DVec3, b: DVec3| super::taught(&machine, &points(a, b)).unwrap_err().message.code;
        assert_eq!(refused(DVec3::X * 5.0, DVec3::Y * 100.0), "server-frame-too-near");
        assert_eq!(refused(DVec3::X * 100.0, DVec3::new(-100.0, 3.0, 0.0)), "server-frame-on-line");
        let two = FramePoints { touches: vec![touch(DVec3::ZERO); 2] };
        assert_eq!(super::taught(&machine, &two).unwrap_err().message.code, "server-frame-three-points");
    }
}
