use crate::cell::Hub;
use crate::refusal::{Lack, lack};
use crate::wire::{TaughtView, TeachPhase, TeachView, WorkView};
use glam::{DAffine3, DVec2, DVec3};
use seamwright_geometry::HeightTable;
use seamwright_message::Message;
use seamwright_project::load::Loaded;
use seamwright_simulation::teaching::Truth;
use seamwright_teaching::{Answer, Outcome, SeamLine};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

#[derive(Debug, Clone)]
pub(crate) struct Open {
    pub(super) job: String,
    pub(super) step_mm: f64,
    pub(super) longest_tack_mm: f64,
    pub(super) seed: u32,
    pub(super) tack_mm: Option<(f64, f64)>,
}

/// The operator's request to a session.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) enum Wish {
    #[default]
    Run,
    Pause,
    Stop,
}

/// Nominal seam and camera map of a session, for positions that the operator points at.
#[derive(Clone)]
pub(super) struct Field {
    pub(super) nominal: SeamLine,
    pub(super) table: HeightTable,
}

/// Result of a session, to make a program from.
pub(super) struct Found {
    pub(super) loaded: Loaded,
    pub(super) nominal: SeamLine,
    pub(super) outcome: Outcome,
    /// True distance of the line from the seam; known in a simulation only.
    pub(super) truth: Option<Truth>,
}

#[derive(Default)]
pub(super) struct State {
    /// The session's thread is running.
    lives: bool,
    /// The page that commands it.
    pub(super) station: u32,
    pub(super) wish: Wish,
    /// Name of the machine on which it is taught.
    machine: String,
    /// Position of the joint, as the operator answered.
    said: Option<Answer>,
    pub(super) view: TeachView,
    pub(super) taught: TaughtView,
    pub(super) picture: Option<Arc<Vec<u8>>>,
    pub(super) field: Option<Field>,
    /// Camera pose of the newest picture, and height of the work at that time, mm in the camera's frame.
    pub(super) sight: Option<(DAffine3, f64)>,
    pub(super) found: Option<Arc<Found>>,
}

/// Teaching by camera of a panel: at most one session.
#[derive(Default)]
pub(crate) struct Teaching {
    state: Mutex<State>,
    turned: Condvar,
}

impl Teaching {
    pub(super) fn state(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Changes the state and sends its view to all pages.
    pub(super) fn change(&self, hub: &Hub, change: impl FnOnce(&mut State)) {
        let mut state = self.state();
        change(&mut state);
        let view = state.view.clone();
        drop(state);
        hub.teaches(view);
        self.turned.notify_all();
    }

    pub(super) fn wait(&self, most: Duration) {
        drop(self.turned.wait_timeout(self.state(), most));
    }

    /// Opens a session of the page `station`, along the seam of a loaded job on its machine.
    pub(super) fn open(&self, hub: &Hub, station: u32, work: &WorkView) -> Result<(), Lack> {
        let mut state = self.state();
        if state.lives {
            return Err(lack("busy", Message::new("server-teach-is-open")));
        }
        // Picture numbers continue, so that an old picture is never taken for a new one.
        let picture = state.view.picture;
        *state = State { lives: true, station, machine: work.machine.clone(), ..State::default() };
        state.view = TeachView { phase: TeachPhase::Plans, job: work.job.clone(), picture, ..TeachView::default() };
        let view = state.view.clone();
        drop(state);
        hub.teaches(view);
        Ok(())
    }

    /// Forgets the result of another seam or machine: `work` is now loaded. A running session ends by itself.
    pub(crate) fn leave(&self, hub: &Hub, work: &WorkView) {
        // Checked and changed under one lock: a session that starts meanwhile is not forgotten.
        self.change(hub, |state| {
            let view = &state.view;
            if state.lives || view.job.is_empty() || (view.job == work.job && state.machine == work.machine) {
                return;
            }
            let picture = view.picture;
            *state = State { view: TeachView { picture, ..TeachView::default() }, ..State::default() };
        });
    }

    pub(super) fn ended(&self, hub: &Hub, change: impl FnOnce(&mut State)) {
        self.change(hub, |state| {
            state.lives = false;
            state.view.phase = TeachPhase::Ended;
            change(state);
        });
    }

    /// Sets the joint position `point`, given by the operator on page `station`.
    pub(super) fn here(&self, station: u32, point: DVec3) -> Result<(), Lack> {
        let mut state = self.state();
        if !matches!(state.view.phase, TeachPhase::Places | TeachPhase::Asks) {
            return Err(lack("mode", Message::new("server-teach-not-asked")));
        }
        let foot = state.field.as_ref().filter(|_| point.is_finite()).and_then(|f| f.nominal.foot(point));
        let Some(foot) = foot else {
            return Err(lack("value", Message::new("server-teach-far")));
        };
        (state.said, state.station, state.wish) = (Some(Answer::Point(point, Some(foot.along))), station, Wish::Run);
        drop(state);
        self.turned.notify_all();
        Ok(())
    }

    pub(super) fn end_here(&self) -> Result<(), Lack> {
        let mut state = self.state();
        if state.view.phase != TeachPhase::Asks {
            return Err(lack("mode", Message::new("server-teach-not-asked")));
        }
        state.said = Some(Answer::End);
        drop(state);
        self.turned.notify_all();
        Ok(())
    }

    /// Pauses with a reason for [`TeachView::key`]; no effect if no session is following.
    pub(crate) fn pause(&self, why: &str) -> Result<(), Lack> {
        let mut state = self.state();
        if state.lives && state.wish == Wish::Run && state.view.phase == TeachPhase::Runs {
            (state.wish, state.view.key) = (Wish::Pause, Some(why.to_owned()));
            drop(state);
            self.turned.notify_all();
        }
        Ok(())
    }

    pub(super) fn resume(&self, station: u32) -> Result<(), Lack> {
        let mut state = self.state();
        if !state.lives || state.wish != Wish::Pause {
            return Err(lack("mode", Message::new("server-teach-not-paused")));
        }
        (state.wish, state.station) = (Wish::Run, station);
        drop(state);
        self.turned.notify_all();
        Ok(())
    }

    pub(super) fn wish(&self, wish: Wish) -> Result<(), Lack> {
        let mut state = self.state();
        if !state.lives {
            return Err(lack("mode", Message::new("server-teach-not-open")));
        }
        state.wish = wish;
        drop(state);
        self.turned.notify_all();
        Ok(())
    }

    pub(super) fn take_answer(&self) -> Option<Answer> {
        self.state().said.take()
    }

    /// Returns the position on the work that a pixel of the newest picture shows.
    pub(super) fn seen_at(&self, px: DVec2) -> Option<DVec3> {
        let state = self.state();
        let ((camera, height), field) = state.sight.zip(state.field.as_ref())?;
        let point = field.table.to_point(px, height).ok()?;
        Some(camera.transform_point3(point)).filter(|p| p.is_finite())
    }

    /// Returns the position on the work at the centre of the camera's view.
    pub(super) fn middle(&self) -> Option<DVec3> {
        self.state().sight.map(|(camera, height)| camera.transform_point3(DVec3::Z * height))
    }

    pub(crate) fn picture(&self) -> Option<Arc<Vec<u8>>> {
        self.state().picture.clone()
    }

    pub(crate) fn taught(&self) -> TaughtView {
        self.state().taught.clone()
    }
}
