//! Thread of a teaching session.

use super::axis_motion::Hand;
use super::rig::{Asked, CellRig, Sees, Station};
use super::state::{Field, Found, Open, State, Wish};
use crate::cell::happening;
use crate::http::{Panel, Turn, job_text};
use crate::refusal::panel_word;
use crate::wire::{TaughtLook, TaughtPointView, TeachPhase};
use glam::DVec3;
use seamwright_frames::LiveFrames;
use seamwright_geometry::HeightTable;
use seamwright_machine::{Machine, Sensor};
use seamwright_message::Message;
use seamwright_project::Failure;
use seamwright_project::load::{Loaded, load_foreign};
use seamwright_simulation::camera_simulator::{Appearance, CameraSimulator, Distortion};
use seamwright_simulation::teaching::{Truth, truth};
use seamwright_teaching::{
    self as teaching, CameraPose, Crawl, Look, Outcome, Picture, PlannedWeld, SeamLine, Setup, from_nominal, teach,
};
use std::cell::RefCell;
use std::sync::Arc;
use std::time::Duration;

/// Distortion of a simulated part: shift (mm), turn (rad) and bend (mm), as in `seamwright teach`.
pub(crate) const DISTORTION: Distortion =
    Distortion { shift_mm: 1.0, turn: 0.3 * std::f64::consts::PI / 180.0, bend_mm: 1.0 };
/// Maximum wait for a frame of the machine's camera.
const PATIENCE: Duration = Duration::from_secs(5);
/// Spacing of points sent to pages, mm.
const TOLD_MM: f64 = 1.0;

/// Runs a session to its end, regular or not.
pub(super) fn run(panel: &Arc<Panel>, open: &Open) {
    let hub = &panel.cell.hub;
    let result = session(panel, open);
    let t = hub.latest().map_or(0.0, |status| status.t);
    let (key, why, found) = match result {
        Ok(None) => ("stopped", None, None),
        Ok(Some(found)) => {
            let stopped = panel.teaching.state().wish == Wish::Stop;
            let key = if stopped { "stopped" } else { found.outcome.ended };
            (key, found.outcome.finding.clone().filter(|_| !stopped), Some(found))
        }
        Err(failure) => ("failed", Some(failure.message()), None),
    };
    hub.event(
        t,
        happening(
            Message::new("server-event-teach-ended")
                .text("job", &open.job)
                .message("result", panel_word("teach-end", key)),
        ),
    );
    panel.teaching.ended(hub, |state| {
        (state.view.key, state.view.why, state.found) =
            (Some(key.to_owned()), why.map(Into::into), found.map(Arc::new));
    });
}

/// Runs a session. `None`: it was stopped before the search began.
fn session(panel: &Arc<Panel>, open: &Open) -> Result<Option<Found>, Failure> {
    let hub = &panel.cell.hub;
    let text = job_text(panel, &open.job).map_err(|refused| Failure::input(refused.message))?;
    let loaded = load_foreign(&open.job, &text, &panel.jobs())?;
    let machine = &loaded.machine;
    if hub.machine().is_none_or(|cell| cell.name != machine.name) {
        return Err(Failure::input(
            Message::new("server-teach-other-machine").text("job", &open.job).text("machine", &machine.name),
        ));
    }
    let nominal = teaching::nominal(&loaded.welding.program.value, loaded.seam()?);
    let found = outcome(panel, open, &loaded, &nominal)?;
    Ok(found.map(|(outcome, truth)| Found { nominal, outcome, truth, loaded }))
}

/// Follows the joint. In a simulation the true distance of the line found from the seam is known too.
fn outcome(
    panel: &Arc<Panel>,
    open: &Open,
    loaded: &Loaded,
    nominal: &SeamLine,
) -> Result<Option<(Outcome, Option<Truth>)>, Failure> {
    let (hub, machine) = (&panel.cell.hub, &loaded.machine);
    let (sensor, table) = camera(machine)?;
    let Some(turn) = turn(panel) else { return Ok(None) };
    let ground = PlannedWeld::new(&loaded.welding, machine, &loaded.clamped, nominal)?;
    drop(turn);
    panel.teaching.change(hub, |state| {
        state.field = Some(Field { nominal: nominal.clone(), table: table.clone() });
        state.view.nominal_mm = nominal.length();
        let (width, height) = table.size_px();
        state.view.size_px = (width as u32, height as u32);
    });
    let (camera, actual) = open_camera(panel, machine, sensor, open, nominal)?;
    let station = Station {
        hand: Hand { panel, machine },
        sensor,
        table,
        around: ground.around(),
        camera: RefCell::new(camera),
        drawn: RefCell::new(None),
    };
    let Some(point) = station.place() else { return Ok(None) };
    let begin =
        teaching::start(nominal, point).ok_or_else(|| Failure::input(Message::new("server-teach-start-far")))?;
    let outcome = crawl(loaded, nominal, open, &ground, &station, begin)?;
    let truth = actual.map(|actual| truth(&actual, &outcome.smooth));
    Ok(Some((outcome, truth)))
}

/// Returns the cell's camera. A simulated cell without live frames gets the camera simulator and the seam that it sees.
fn open_camera<'a>(
    panel: &Panel,
    machine: &'a Machine,
    sensor: &'a Sensor,
    open: &Open,
    nominal: &SeamLine,
) -> Result<(Sees<'a>, Option<SeamLine>), Failure> {
    // The job's machine file may be older than the cell's.
    let Some(cell) = panel.cell.hub.machine() else {
        return Err(Failure::input(Message::new("server-no-machine")));
    };
    let own = cell.sensors.iter().find(|s| s.name == sensor.name);
    if let Some((own, address)) = own.and_then(|own| Some((own, own.frames.as_ref()?))) {
        panel.cameras.check(address).map_err(Failure::input)?;
        let mut camera = LiveFrames::connect(address, sensor.size_px, PATIENCE)?;
        // A camera without frames is reported before any motion.
        camera.next(Duration::ZERO)?;
        return Ok((Sees::Camera(camera, Duration::from_secs_f64(own.latency_s)), None));
    }
    if !cell.devices.is_empty() {
        return Err(Failure::input(Message::new("server-teach-no-frames").text("sensor", &sensor.name)));
    }
    let actual = DISTORTION.of(nominal, u64::from(open.seed));
    let appearance = Appearance { tacks: open.tack_mm.into_iter().collect(), ..Appearance::default() };
    let camera = CameraSimulator::new(machine, sensor, actual.clone(), appearance, u64::from(open.seed));
    let camera = camera
        .ok_or_else(|| Failure::input(Message::new("server-teach-sensor-no-camera").text("sensor", &sensor.name)))?;
    Ok((Sees::Simulated(Box::new(camera)), Some(actual)))
}

/// Waits for a turn to plan; `None` once the session is stopped.
fn turn(panel: &Panel) -> Option<Turn> {
    while panel.teaching.state().wish != Wish::Stop {
        if let Some(turn) = panel.planning.now() {
            return Some(turn);
        }
        panel.teaching.wait(Duration::from_millis(50));
    }
    None
}

fn camera(machine: &Machine) -> Result<(&Sensor, &HeightTable), Failure> {
    let none = || Failure::input(Message::new("server-teach-no-camera").text("machine", &machine.name));
    machine.cameras().next().ok_or_else(none)
}

fn crawl(
    loaded: &Loaded,
    nominal: &SeamLine,
    open: &Open,
    ground: &PlannedWeld<'_>,
    station: &Station<'_>,
    begin: CameraPose,
) -> Result<Outcome, Failure> {
    let (machine, sensor, table) = (&loaded.machine, station.sensor, station.table);
    let guide = |point: DVec3| ground.guide(point);
    let start = station.hand.axes().map_or(machine.home(), |(set, ..)| set);
    let carrier = ground.carrier(machine, sensor, &guide, start);
    let mut rig = CellRig { station, carrier };
    let mut crawl = Crawl::new(teaching::settings(nominal, open.step_mm), table, nominal, begin);
    let mut follower = teaching::follower(table, open.longest_tack_mm)?;
    let mut asked = Asked { station, ended: false };
    let mut looks = Vec::new();
    let mut each = |look: &Look| -> Result<(), Failure> {
        let axes = look.frame.axes.clone().unwrap_or_default();
        looks.push(axes.clone());
        let panel = station.hand.panel;
        panel.teaching.change(&panel.cell.hub, |state| update_view(state, look, &looks, nominal));
        let q = machine.joints_from_file(&axes);
        station.show(&q, look.view.height, || Picture::of(look, table));
        Ok(())
    };
    let setup = Setup { machine, sensor, midline: &mut follower, operator: &mut asked };
    let run = teach(setup, &mut crawl, &mut rig, &mut each)?;
    Ok(Outcome::of(&crawl, &run, asked.ended))
}

fn update_view(state: &mut State, look: &Look, axes: &[Vec<f64>], nominal: &SeamLine) {
    let (line, notes) = (look.crawl.line(), look.crawl.notes());
    let view = &mut state.view;
    view.phase = TeachPhase::Runs;
    (view.way_mm, view.frames) = (line.length(), notes.len() as u32);
    view.confidence = notes.last().map_or(0.0, |note| note.confidence);
    view.least_confidence = line.points().iter().map(|p| p.confidence).reduce(f64::min).unwrap_or(0.0);
    state.taught.looks = notes
        .iter()
        .zip(axes)
        .map(|(note, axes)| TaughtLook {
            s_mm: note.way,
            at: note.eye.to_array(),
            axes: axes.clone(),
            confidence: note.confidence,
            believed: note.agrees,
        })
        .collect();
    let mut points: Vec<TaughtPointView> = Vec::new();
    for (point, way) in line.points().iter().zip(line.ways()) {
        if points.last().is_some_and(|last| way - last.s_mm < TOLD_MM) {
            continue;
        }
        points.push(TaughtPointView {
            s_mm: *way,
            at: point.point.to_array(),
            confidence: point.confidence,
            from_nominal_mm: from_nominal(nominal, point.point),
        });
    }
    state.taught.points = points;
}
