//! Tracking of the loaded task: correction of its passes, and sensors of its joints.

use crate::task::Base;
use seamwright_executive::devices::Sensors;
use seamwright_executive::tracking::Tracking;
use seamwright_executive::{Guide, Guided, Place, Planned, SeamOrders, Seen, SensorReport, Tracked, Trouble};
use seamwright_machine::Joints;
use seamwright_simulation::tracking::SimulatedSensors;
use seamwright_tracking::beam::Picture;
use self_cell::self_cell;
use std::cell::RefCell;
use std::sync::Arc;

type TrackingOf<'a> = Tracking<'a>;
type SensorsOf<'a> = SimulatedSensors<'a>;

self_cell! {
    /// Corrects the passes of a task.
    pub(crate) struct Guiding {
        owner: Arc<Base>,
        #[not_covariant]
        dependent: TrackingOf,
    }
}

self_cell! {
    pub(crate) struct Sensing {
        owner: Arc<Base>,
        #[not_covariant]
        dependent: SensorsOf,
    }
}

/// A machine alone has nothing to track.
const NOTHING: &str = "there is nothing to track";

impl Guiding {
    /// Creates the tracking of a task that starts at `start`.
    pub(crate) fn of(base: &Arc<Base>, start: Place) -> Result<Self, String> {
        Self::try_new(Arc::clone(base), |base| {
            base.with_dependent(|_, cell| {
                let tracking = cell.as_ref().map(|cell| cell.tracking(start).map_err(|e| e.to_string()));
                tracking.transpose()?.flatten().ok_or_else(|| NOTHING.to_owned())
            })
        })
    }
}

impl Sensing {
    /// Creates the sensors of a task.
    pub(crate) fn of(base: &Arc<Base>) -> Result<Self, String> {
        Self::try_new(Arc::clone(base), |base| {
            base.with_dependent(|_, cell| {
                let cell = cell.as_ref().ok_or_else(|| NOTHING.to_owned())?;
                cell.sensors().map_err(|e| e.to_string())
            })
        })
    }
}

impl Sensors for Sensing {
    fn exchange(&mut self, orders: &SeamOrders, truth: Option<&Joints>, report: &mut SensorReport) {
        self.with_dependent_mut(|_, sensors| sensors.exchange(orders, truth, report));
    }

    fn picture(&self) -> Option<Picture<'_>> {
        self.with_dependent(|_, sensors| sensors.picture())
    }
}

/// Slot for the guides of successive tasks of one executive.
pub(crate) struct Slot<'a>(pub(crate) &'a RefCell<Option<Guiding>>);

impl Slot<'_> {
    fn ask<T>(&self, ask: impl FnOnce(&mut Tracking<'_>) -> T) -> Option<T> {
        // Only the cycle's thread comes here, and never from within a guide.
        Some(self.0.borrow_mut().as_mut()?.with_dependent_mut(|_, tracking| ask(tracking)))
    }
}

impl Guide for Slot<'_> {
    fn begin(&mut self, pass: usize, from_mm: f64, welds: bool) -> bool {
        self.ask(|tracking| tracking.begin(pass, from_mm, welds)).unwrap_or(false)
    }

    fn look(&mut self, seen: &Seen<'_>, goes: bool) -> Option<Guided> {
        self.ask(|tracking| tracking.look(seen, goes)).flatten()
    }

    fn ready(&mut self) -> Result<(), Trouble> {
        self.ask(|tracking| tracking.ready()).unwrap_or(Ok(()))
    }

    fn follow(&mut self, seen: &Seen<'_>, planned: &Planned<'_>) -> Guided {
        self.ask(|tracking| tracking.follow(seen, planned)).unwrap_or_else(|| Guided::as_planned(planned))
    }

    fn settle(&mut self, seen: &Seen<'_>, q: &Joints, goes: bool) -> Option<Guided> {
        self.ask(|tracking| tracking.settle(seen, q, goes)).flatten()
    }

    fn tracked(&self) -> [Option<Tracked>; 2] {
        self.ask(|tracking| tracking.tracked()).unwrap_or_default()
    }
}
