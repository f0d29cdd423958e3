//! Setup of the machine: axes, drives and tools in its file; shelving of alarms.

use super::answer::{Answer, Refused};
use super::panel::{Panel, Shared};
use crate::cell::{Change, ToDesk, happening};
use crate::limits::MAX_TOUCHES;
use crate::users::Session;
use crate::view::{PARAMETERS, parameters_view};
use crate::wire::{ParameterChange, ParametersView, Shelving, ToolAnswer, ToolTip, ToolTouches};
use axum::Json;
use axum::extract::State;
use axum::http::StatusCode;
use glam::{DAffine3, DVec3};
use seamwright_cell::fingerprint;
use seamwright_geometry::fit::{outliers, pivot, rms};
use seamwright_machine::{Joints, MAX_AXES, Machine};
use seamwright_message::{Message, Unit};
use seamwright_project::load::{Loaded, load_foreign};
use seamwright_project::own_machine::{OwnMachine, Setting, Step};
use std::sync::Arc;
use tokio::sync::oneshot;

/// Maximum residual of consistent touches, mm; they determine the tip within half of it.
const AGREE_MM: f64 = 0.5;
/// Maximum tip displacement, mm. Beyond it the tool is a different one, or the touches were of several points.
const FAR_MM: f64 = 20.0;
/// Maximum tip coordinate, mm.
const FARTHEST_MM: f64 = 1e4;

/// Machine file of the loaded job, and its machine.
pub(super) struct OfCell {
    pub(super) own: OwnMachine,
    pub(super) machine: Machine,
}

pub(super) fn of_cell(panel: &Panel) -> Result<OfCell, Refused> {
    let Some(work) = panel.cell.hub.work() else {
        return Err(Refused::not_found(Message::new("server-no-job-loaded")));
    };
    let jobs = panel.jobs();
    let loaded: Loaded = load_foreign(&work.job, &super::jobs::text(panel, &work.job)?, &jobs)?;
    Ok(OfCell { own: OwnMachine::of(&loaded, &jobs)?, machine: loaded.machine })
}

impl OfCell {
    fn view(&self, panel: &Panel) -> Result<ParametersView, Refused> {
        let mut view = parameters_view(&self.own, &self.machine)?;
        (view.file, view.pending) = (self.file(panel), self.pending(panel));
        Ok(view)
    }

    /// Returns true while the cell still has the machine before the change.
    pub(super) fn pending(&self, panel: &Panel) -> bool {
        panel.cell.hub.machine().is_some_and(|machine| fingerprint(&machine) != fingerprint(&self.machine))
    }

    /// Returns the file's name relative to the folder of jobs.
    pub(super) fn file(&self, panel: &Panel) -> String {
        let path = &self.own.path;
        let jobs = panel.jobs();
        let inside = path.strip_prefix(&jobs).ok().map(std::path::Path::to_owned);
        // An existing file has its canonical path.
        let inside =
            inside.or_else(|| path.strip_prefix(jobs.canonicalize().ok()?).ok().map(std::path::Path::to_owned));
        inside.unwrap_or_else(|| path.clone()).display().to_string()
    }

    /// Writes `text` to the file; returns the file with its machine.
    pub(super) fn keep(self, text: String) -> Result<Self, Refused> {
        let machine = self.own.keep(&text)?;
        Ok(Self { own: OwnMachine { path: self.own.path, text }, machine })
    }
}

pub(super) async fn parameters(State(panel): Shared) -> Answer<ParametersView> {
    panel.run(|panel| &panel.drawing, move |asked| of_cell(asked)?.view(asked)).await.map(Json)
}

/// Formats keys with their values for the audit log.
fn format_values<'a>(values: impl Iterator<Item = (&'a str, Option<f64>)>) -> String {
    let one = |(key, value): (&str, Option<f64>)| value.map_or_else(|| format!("{key} -"), |v| format!("{key} {v}"));
    values.map(one).collect::<Vec<_>>().join(", ")
}

pub(super) async fn change(
    State(panel): Shared,
    session: Session,
    Json(asked): Json<ParameterChange>,
) -> Answer<ParametersView> {
    let changed = move |panel: &Arc<Panel>| {
        let of = of_cell(panel)?;
        let names: Vec<&str> = of.machine.axes.iter().map(|axis| axis.name.as_str()).collect();
        let Some(axis) = of.machine.axes.iter().find(|axis| axis.name == asked.axis) else {
            return Err(Message::new("server-no-axis")
                .text("axis", &asked.axis)
                .text("allowed", names.join(", "))
                .into());
        };
        let axis_table =
            of.own.axis_table(&axis.name).ok_or_else(|| Refused::server(Message::new("server-axis-not-in-file")))?;
        let drive_table = [Step::Table("drives"), Step::Table(&axis.name)];
        let (mut of_axis, mut of_drive) = (Vec::new(), Vec::new());
        for (key, value) in &asked.values {
            let Some((_, group, kind)) = PARAMETERS.iter().find(|(known, ..)| known == key) else {
                let allowed: Vec<&str> = PARAMETERS.iter().map(|(key, ..)| *key).collect();
                return Err(Message::new("server-no-parameter")
                    .text("key", key)
                    .text("allowed", allowed.join(", "))
                    .into());
            };
            if kind.is_some_and(|kind| kind != axis.kind) {
                return Err(Message::new("server-other-kind-of-axis").text("key", key).into());
            }
            let list = if *group == "axis" { &mut of_axis } else { &mut of_drive };
            list.push((key.as_str(), Setting::Number(*value)));
        }
        let before = parameters_view(&of.own, &of.machine)?;
        let row = before.axes.iter().find(|row| row.name == asked.axis);
        let was = |key: &str| row.and_then(|row| row.values.iter().find(|v| v.key == key)).and_then(|v| v.value);
        let mut old = format_values(asked.values.iter().map(|(key, _)| (key.as_str(), was(key))));
        let mut new = format_values(asked.values.iter().map(|(key, value)| (key.as_str(), *value)));
        if let Some(notches) = &asked.notches {
            let number = |key, number| (key, Setting::Number(Some(number)));
            let table =
                |n: &[f64; 3]| vec![number("frequency_hz", n[0]), number("depth", n[1]), number("width_hz", n[2])];
            of_drive.push(("notches", Setting::Tables(notches.iter().map(table).collect())));
            old += &format!(" notches {:?}", row.map_or(&[][..], |row| &row.notches));
            new += &format!(" notches {notches:?}");
        }
        let mut text = of.own.text.clone();
        if !of_axis.is_empty() {
            text = of.own.with(&axis_table, &of_axis)?;
        }
        if !of_drive.is_empty() {
            text = OwnMachine { path: of.own.path.clone(), text }.with(&drive_table, &of_drive)?;
        }
        let name = asked.axis.clone();
        let kept = of.keep(text)?;
        let (view, file) = (kept.view(panel)?, kept.file(panel));
        let part = ChangedPart { kind: Changed::Axis, name: &name, file: &file };
        tell(panel, &session.user, part, Change { old: old.trim(), new: new.trim() });
        Ok(view)
    };
    panel.run(|panel| &panel.planning, changed).await.map(Json)
}

/// Kind of a changed part of a machine file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Changed {
    Axis,
    Tool,
    Sensor,
    Frame,
}

/// Changed part of a machine file: its kind, its name, and the file.
#[derive(Debug, Clone, Copy)]
pub(super) struct ChangedPart<'a> {
    pub(super) kind: Changed,
    pub(super) name: &'a str,
    pub(super) file: &'a str,
}

/// Reports a change to all pages and the audit log.
pub(super) fn tell(panel: &Panel, user: &str, part: ChangedPart<'_>, change: Change<'_>) {
    let ChangedPart { kind, name, file } = part;
    let (audit, event) = match kind {
        Changed::Axis => ("server-audit-set-axis", Message::new("server-event-machine-changed").text("subject", name)),
        Changed::Tool => ("server-audit-set-tool", Message::new("server-event-tool-changed").text("head", name)),
        Changed::Frame => ("server-audit-set-frame", Message::new("server-event-frame-changed").text("frame", name)),
        Changed::Sensor => {
            ("server-audit-set-sensor", Message::new("server-event-sensor-changed").text("sensor", name))
        }
    };
    let command = Message::new(audit).text("name", name).text("file", file);
    panel.audit(user, command, change, Message::new("server-audit-kept"));
    let t = panel.cell.hub.latest().map_or(0.0, |status| status.t);
    panel.cell.hub.event(t, happening(event.text("file", file)).by(Some(user.to_owned())));
}

fn head(machine: &Machine, head: u32) -> Result<usize, Refused> {
    let count = machine.heads.len();
    let known = usize::try_from(head).ok().filter(|head| *head < count);
    known.ok_or_else(|| {
        Refused::input(Message::new("server-no-head").number("head", f64::from(head), 0).count("max", count - 1))
    })
}

pub(super) async fn find_tool(State(panel): Shared, Json(asked): Json<ToolTouches>) -> Answer<ToolAnswer> {
    let found = move |on: &Arc<Panel>| touched_tool(&of_cell(on)?.machine, &asked);
    panel.run(|panel| &panel.drawing, found).await.map(Json)
}

/// Finds the position of a tip from touches of one point.
pub(super) fn touched_tool(machine: &Machine, asked: &ToolTouches) -> Result<ToolAnswer, Refused> {
    let head = head(machine, asked.head)?;
    if asked.touches.len() > MAX_TOUCHES {
        return Err(Message::new("server-too-many-touches")
            .count("n", asked.touches.len())
            .count("max", MAX_TOUCHES)
            .into());
    }
    let frames: Result<Vec<DAffine3>, Refused> = asked.touches.iter().map(|t| frame(machine, head, t)).collect();
    tool(machine, head, &frames?)
}

/// Returns the tool's frame at a touch; its origin is the assumed tip.
fn frame(machine: &Machine, head: usize, touch: &[f64]) -> Result<DAffine3, Refused> {
    let axes = &machine.axes;
    if touch.len() != axes.len() || touch.iter().any(|v| !v.is_finite() || v.abs() > 1e6) {
        let message = Message::new("server-touch").text("touch", format!("{touch:?}")).count("n", axes.len());
        return Err(message.into());
    }
    let mut q: Joints = [0.0; MAX_AXES];
    q.iter_mut().zip(axes).zip(touch).for_each(|((q, axis), value)| *q = axis.from_file(*value));
    Ok(machine.mount_frame(head, &q) * DAffine3::from_translation(machine.heads[head].tip))
}

fn tool(machine: &Machine, head: usize, frames: &[DAffine3]) -> Result<ToolAnswer, Refused> {
    let fit =
        pivot(frames).map_err(|e| Refused::input(Message::new("server-more-touches").message("why", e.message())))?;
    let was = machine.heads[head].tip;
    let worst = fit.residuals.iter().copied().fold(0.0, f64::max);
    let verdict = if worst > AGREE_MM || fit.deviation.max_element() > 0.5 * AGREE_MM {
        "poor"
    } else if fit.tip.length() > FAR_MM {
        "far"
    } else if fit.unseen.is_empty() {
        "good"
    } else {
        "unseen"
    };
    // Rounded to 0.0001 mm, beyond manual accuracy.
    let tip = ((was + fit.tip) * 1e4).round() / 1e4;
    Ok(ToolAnswer {
        was_mm: was.to_array(),
        tip_mm: tip.to_array(),
        point_mm: fit.point.to_array(),
        rms_mm: rms(&fit.residuals),
        outliers: outliers(&fit.residuals),
        residuals_mm: fit.residuals,
        deviation_mm: fit.deviation.to_array(),
        apart_deg: fit.apart.to_degrees(),
        unseen: fit.unseen.iter().map(DVec3::to_array).collect(),
        verdict: verdict.to_owned(),
    })
}

pub(super) async fn keep_tool(
    State(panel): Shared,
    session: Session,
    Json(asked): Json<ToolTip>,
) -> Answer<ParametersView> {
    let kept = move |panel: &Arc<Panel>| {
        let of = of_cell(panel)?;
        let head = head(&of.machine, asked.head)?;
        if asked.tip_mm.iter().any(|v| v.is_nan() || v.abs() > FARTHEST_MM) {
            return Err(Message::new("server-tip-far")
                .text("tip", format!("{:?}", asked.tip_mm))
                .value("max", FARTHEST_MM, Unit::Mm)
                .into());
        }
        let name = of.machine.heads[head].name.clone();
        let was = of.machine.heads[head].tip;
        // One head without a name, or several with names.
        let table = if of.own.has("torch") { Step::Table("torch") } else { Step::Nth("heads", head) };
        let text = of.own.with(&[table], &[("tip_mm", Setting::Row(asked.tip_mm.to_vec()))])?;
        let kept = of.keep(text)?;
        let (view, file) = (kept.view(panel)?, kept.file(panel));
        let written = |tip: DVec3| format!("tip_mm {:?}", tip.to_array());
        let change = (written(was), written(DVec3::from_array(asked.tip_mm)));
        let part = ChangedPart { kind: Changed::Tool, name: &name, file: &file };
        tell(panel, &session.user, part, Change { old: &change.0, new: &change.1 });
        Ok(view)
    };
    panel.run(|panel| &panel.planning, kept).await.map(Json)
}

pub(super) async fn shelve(
    State(panel): Shared,
    session: Session,
    Json(asked): Json<Shelving>,
) -> Result<StatusCode, Refused> {
    let gone = || Refused::server(Message::new("server-cell-ended"));
    let (answer, answered) = oneshot::channel();
    let command = Message::new("server-audit-shelve").number("alarm", f64::from(asked.number), 0);
    let command = command.number("detail", f64::from(asked.detail), 0).number("minutes", f64::from(asked.minutes), 0);
    panel.cell.desk.send(ToDesk::Shelve(asked, session.user.clone(), answer)).map_err(|_| gone())?;
    let result = answered.await.map_err(|_| gone())?;
    let said = result.as_ref().map_or_else(Message::clone, |()| Message::new("server-audit-accepted"));
    panel.audit(&session.user, command, Change::default(), said);
    result.map(|()| StatusCode::NO_CONTENT).map_err(Refused::input)
}
