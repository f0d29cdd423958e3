//! Position of a simulated part, and whether its passes are tracked.

use crate::failure::Failure;
use crate::load::Loaded;
use crate::planning::Planning;
use seamwright_document::DocumentError;
use seamwright_executive::tracking::RESERVE;
use seamwright_machine::{Machine, Surroundings};
use seamwright_message::Message;
use seamwright_motion::WeldMotion;
use seamwright_simulation::Conditions;
use seamwright_simulation::devices::Fault;
use seamwright_simulation::tracking::{Distortion, check};
use seamwright_tracking::beam::DeviationRecord;

/// A simulated part; by default it lies as planned, and is not tracked.
#[derive(Debug, Clone, Default)]
pub struct Part {
    /// Deviation from the planned part.
    pub distortion: Option<Distortion>,
    /// Deviations that an earlier weld has measured: passes are corrected by them.
    pub replay: Option<DeviationRecord>,
    /// Its passes are tracked.
    pub tracking: bool,
}

impl Part {
    /// Returns the part with this deviation from the plan, as in [`Distortion::read`]: its passes are tracked. Without
    /// one it lies as planned.
    ///
    /// # Errors
    /// Text that describes no deviation.
    pub fn distorted(text: Option<&str>) -> Result<Self, DocumentError> {
        let distortion = text.map(|text| Distortion::read("distortion", text)).transpose()?;
        Ok(Self { tracking: distortion.is_some(), distortion, replay: None })
    }

    /// Conditions of its welding.
    pub fn conditions<'a>(&'a self, seed: u64, faults: &'a [Fault], around: &'a Surroundings<'a>) -> Conditions<'a> {
        Conditions {
            seed,
            distortion: self.distortion.as_ref(),
            tracking: self.tracking,
            replay: self.replay.as_ref(),
            around: Some(around),
            faults,
        }
    }

    /// Looks whether it can be welded on the devices of `machine`: real ones have no simulated part.
    ///
    /// # Errors
    /// If it cannot.
    pub fn check_devices(&self, machine: &Machine) -> Result<(), Failure> {
        if !self.tracking || machine.devices.is_empty() {
            return Ok(());
        }
        let message = Message::new("project-tracking-with-devices");
        Err(Failure::refused(message, Message::new("project-no-devices-or-tracking")))
    }

    /// The plan, with the axes' reserve for tracking.
    ///
    /// # Errors
    /// A weld that the machine cannot make, or track.
    pub fn plan(&self, loaded: &Loaded) -> Result<WeldMotion, Failure> {
        self.plan_under(loaded, &Planning::default())
    }

    /// Plans as [`Part::plan`] does, within the limits of `planning`.
    ///
    /// # Errors
    /// A pass without a plan in that time, or without tracking.
    pub fn plan_under(&self, loaded: &Loaded, planning: &Planning) -> Result<WeldMotion, Failure> {
        let machine = &loaded.machine;
        let reserve = if self.tracking { RESERVE } else { 0.0 };
        let motion = loaded.plan_under(&machine.with_reserve(reserve), planning)?;
        loaded.check_count(&motion, machine.servo_period_s)?;
        if self.distortion.is_some() || self.tracking {
            let (paths, around) = (loaded.paths(), loaded.surroundings()?);
            check(machine, &loaded.passes(&paths), &motion, &self.conditions(0, &[], &around))?;
        }
        Ok(motion)
    }
}
