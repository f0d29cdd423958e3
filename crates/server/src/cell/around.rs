//! What is near to what, for the eye: beside the cycle, which keeps clear by itself.

use super::hub::Hub;
use crate::view::near;
use crate::wire::NearView;
use seamwright_machine::{Clamped, Joints, Machine, Surroundings};
use self_cell::self_cell;
use std::sync::{Arc, Weak};
use std::time::Duration;

/// How often it is looked at.
const LOOK: Duration = Duration::from_millis(50);
/// Nothing is told beyond this, mm.
const WITHIN_MM: f64 = 60.0;

self_cell! {
    struct Stood {
        owner: (Machine, Clamped),
        #[not_covariant]
        dependent: Surroundings,
    }
}

/// Machine, part and fixtures.
pub(crate) struct Around(Stood);

impl Around {
    /// # Errors
    /// In words: solids that cannot be kept apart.
    pub(crate) fn new(machine: &Machine, clamped: &Clamped) -> Result<Self, String> {
        let owner = (machine.clone(), clamped.clone());
        let stood = Stood::try_new(owner, |(machine, clamped)| Surroundings::new(machine, clamped));
        stood.map(Self).map_err(|e| e.to_string())
    }

    /// What is nearest to being too near with the axes at `q`, mm or rad.
    pub(super) fn near(&self, q: &Joints) -> Option<NearView> {
        self.0.with_dependent(|_, around| near(around, q, WITHIN_MM))
    }
}

/// Looks at what is near as long as somebody shows it.
pub(super) fn watch(hub: &Weak<Hub>) {
    let mut last: Option<(Joints, usize)> = None;
    while let Some(hub) = hub.upgrade() {
        if let Some((around, q)) = hub.around().zip(hub.set_points()) {
            // The same place in the same surroundings needs no second look.
            let now = (q, Arc::as_ptr(&around) as usize);
            if last != Some(now) {
                hub.set_near(around.near(&q));
                last = Some(now);
            }
        }
        drop(hub);
        std::thread::sleep(LOOK);
    }
}
