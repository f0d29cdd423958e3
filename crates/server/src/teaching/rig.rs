//! The camera on the cell's machine, moved by its axes; and the operator at the panel.

use super::axis_motion::{Came, Hand};
use super::state::{Teaching, Wish};
use crate::cell::Hub;
use crate::wire::TeachPhase;
use glam::DVec3;
use seamwright_frames::{FrameError, FrameSource as _, LiveFrames, TimedFrame};
use seamwright_geometry::HeightTable;
use seamwright_machine::{AxisSet, Joints, Sensor, Surroundings};
use seamwright_message::Message;
use seamwright_motion::transfer::route;
use seamwright_simulation::camera_simulator::CameraSimulator;
use seamwright_teaching::{Answer, CameraPose, Carrier, Crawl, Operator, Picture, Rig};
use std::cell::RefCell;
use std::sync::Arc;
use std::time::{Duration, Instant};

/// Minimum interval between pictures.
const PICTURES: Duration = Duration::from_millis(100);
/// Interval between pictures while the camera waits.
const WAITING: Duration = Duration::from_millis(300);
/// Minimum axis displacement for a new picture of the camera simulator, mm or rad.
const MOVED: f64 = 5e-3;

pub(super) enum Sees<'a> {
    /// The camera simulator, from the true axis positions.
    Simulated(Box<CameraSimulator<'a>>),
    /// The machine's camera, and the time from an exposure to the arrival of its frame.
    Camera(LiveFrames, Duration),
}

/// Camera and machine, shared by the following thread and the operator.
pub(super) struct Station<'a> {
    pub(super) hand: Hand<'a>,
    pub(super) sensor: &'a Sensor,
    pub(super) table: &'a HeightTable,
    pub(super) around: &'a Surroundings<'a>,
    pub(super) camera: RefCell<Sees<'a>>,
    /// Time of the last picture.
    pub(super) drawn: RefCell<Option<Instant>>,
}

impl Station<'_> {
    fn teaching(&self) -> &Teaching {
        &self.hand.panel.teaching
    }

    fn hub(&self) -> &Hub {
        &self.hand.panel.cell.hub
    }

    /// Takes a frame from the current axis positions; `None` before the cell has reported them.
    fn expose(&self) -> Result<Option<(TimedFrame, Joints)>, FrameError> {
        let Some((_, axes, status)) = self.hand.axes() else { return Ok(None) };
        let frame = match &mut *self.camera.borrow_mut() {
            Sees::Simulated(camera) => {
                camera.expose(status.t, &axes);
                camera.next()?
            }
            Sees::Camera(camera, latency) => {
                let frame = camera.next(*latency)?;
                let file = self.hand.machine.axes.iter().zip(&axes).map(|(axis, at)| axis.to_file(*at));
                Some(TimedFrame { axes: Some(file.collect()), ..frame })
            }
        };
        Ok(frame.map(|frame| (frame, axes)))
    }

    /// Stores a picture for the pages with its camera pose, limited in rate.
    pub(super) fn show(&self, axes: &Joints, height: Option<f64>, picture: impl FnOnce() -> Picture) {
        if self.drawn.borrow().is_some_and(|drawn| drawn.elapsed() < PICTURES) {
            return;
        }
        let Ok(png) = picture().png() else { return };
        self.drawn.replace(Some(Instant::now()));
        let camera = self.hand.machine.camera_frame(self.sensor, axes);
        self.teaching().change(self.hub(), |state| {
            state.picture = Some(Arc::new(png));
            state.sight = Some((camera, height.unwrap_or(0.0)));
            state.view.picture = state.view.picture.wrapping_add(1).max(1);
        });
    }

    /// Shows camera pictures until `done` returns an answer, or the session is stopped. The axes may be jogged
    /// meanwhile.
    fn watch<T>(&self, done: impl Fn(&Teaching) -> Option<T>) -> Option<T> {
        let mut shown: Option<(Instant, Joints)> = None;
        loop {
            if self.teaching().state().wish == Wish::Stop {
                return None;
            }
            if let Some(answer) = done(self.teaching()) {
                return Some(answer);
            }
            let now = self.hand.axes().map_or_else(Joints::default, |(_, axes, _)| axes);
            let moved = |before: &Joints| before.iter().zip(now).any(|(a, b)| (a - b).abs() > MOVED);
            let is_live = matches!(*self.camera.borrow(), Sees::Camera(..));
            let due = shown.is_none_or(|(when, before)| when.elapsed() >= WAITING && (is_live || moved(&before)));
            match if due { self.expose() } else { Ok(None) } {
                Ok(Some((frame, axes))) => {
                    shown = Some((Instant::now(), axes));
                    let height = frame.height_mm;
                    self.show(&axes, height, || Picture::plain(frame.image, self.table, height.unwrap_or(0.0)));
                }
                Ok(None) => {}
                // The operator would otherwise keep looking at an old picture.
                Err(error) => {
                    shown = Some((Instant::now(), now));
                    self.teaching().change(self.hub(), |state| state.view.why = Some(error.message().into()));
                }
            }
            self.teaching().wait(PICTURES);
        }
    }

    /// Returns the start of the joint, marked by the operator; `None` if the session is stopped before.
    pub(super) fn place(&self) -> Option<DVec3> {
        self.teaching().change(self.hub(), |state| state.view.phase = TeachPhase::Places);
        let said = self.watch(|teaching| match teaching.take_answer() {
            Some(Answer::Point(point, _)) => Some(point),
            _ => None,
        });
        self.runs();
        said
    }

    fn runs(&self) {
        self.teaching().change(self.hub(), |state| {
            (state.view.phase, state.view.key, state.view.why) = (TeachPhase::Runs, None, None);
        });
    }

    /// Waits during a pause. Returns false once the session is stopped.
    fn may_run(&self) -> bool {
        if self.teaching().state().wish == Wish::Pause {
            self.teaching().change(self.hub(), |state| state.view.phase = TeachPhase::Paused);
            let run = self.watch(|teaching| (teaching.state().wish == Wish::Run).then_some(()));
            if run.is_some() {
                self.runs();
            }
        }
        self.teaching().state().wish != Wish::Stop
    }
}

/// The cell's machine as carrier of the camera.
pub(super) struct CellRig<'s, 'a> {
    pub(super) station: &'s Station<'a>,
    pub(super) carrier: Carrier<'s>,
}

impl CellRig<'_, '_> {
    /// Tries once to reach a camera pose, by a path around obstacles.
    fn once(&mut self, pose: &CameraPose) -> Result<Came, Message> {
        let hand = &self.station.hand;
        let Some((set, ..)) = hand.axes() else { return Ok(Came::Interrupted) };
        self.carrier.stands(set);
        let target = self.carrier.positions(pose)?;
        let way = route(hand.machine, self.station.around, &set, &target, AxisSet::default());
        for place in way.map_err(|e| Message::outside(&e))?.iter().skip(1) {
            match hand.go(place) {
                Came::There => {}
                other => return Ok(other),
            }
        }
        Ok(Came::There)
    }
}

impl Rig for CellRig<'_, '_> {
    fn go(&mut self, pose: &CameraPose) -> Result<(), Message> {
        while self.station.may_run() {
            match self.once(pose)? {
                Came::There => return Ok(()),
                Came::Interrupted => {}
                Came::Blocked => return Err(Message::new("server-teach-blocked")),
            }
        }
        // The session is stopped: no frame follows either.
        Ok(())
    }

    fn frame(&mut self) -> Result<Option<TimedFrame>, FrameError> {
        if !self.station.may_run() {
            return Ok(None);
        }
        Ok(self.station.expose()?.map(|(frame, _)| frame))
    }
}

pub(super) struct Asked<'s, 'a> {
    pub(super) station: &'s Station<'a>,
    /// The operator has confirmed that the joint ends where it was lost.
    pub(super) ended: bool,
}

impl Operator for Asked<'_, '_> {
    fn answer(&mut self, why: &Message, _crawl: &Crawl) -> Answer {
        let (teaching, hub) = (self.station.teaching(), self.station.hub());
        // The picture in which the joint was lost stays for a moment, with its detection.
        teaching.change(hub, |state| {
            (state.view.phase, state.view.why) = (TeachPhase::Asks, Some(why.into()));
        });
        let said = self.station.watch(Teaching::take_answer);
        self.station.runs();
        self.ended |= said == Some(Answer::End);
        said.unwrap_or(Answer::End)
    }
}
