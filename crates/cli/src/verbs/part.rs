//! How the simulated part lies, and whether its passes are tracked.

use crate::args::part::PartArgs;
use crate::failure::Failure;
use crate::files;
use crate::load::Loaded;
use seamwright_cell::Conditions;
use seamwright_cell::devices::Fault;
use seamwright_cell::tracking::{Distortion, RESERVE, check};
use seamwright_machine::Surroundings;
use seamwright_motion::WeldMotion;
use seamwright_tracking::beam::DeviationRecord;
use std::path::Path;

/// A part that is read.
pub(super) struct Part {
    distortion: Option<Distortion>,
    replay: Option<DeviationRecord>,
    tracking: bool,
}

impl Part {
    pub(super) fn read(args: &PartArgs) -> Result<Self, Failure> {
        let distortion = match &args.distortion {
            Some(path) => Some(Distortion::read(&path.display().to_string(), &files::read(path)?)?),
            None => None,
        };
        let replay = args.replay.as_deref().map(stored).transpose()?;
        let tracking = (distortion.is_some() || replay.is_some()) && !args.no_tracking;
        Ok(Self { distortion, replay, tracking })
    }

    /// Under what it is welded.
    pub(super) fn conditions<'a>(
        &'a self,
        seed: u64,
        faults: &'a [Fault],
        around: &'a Surroundings<'a>,
    ) -> Conditions<'a> {
        Conditions {
            seed,
            distortion: self.distortion.as_ref(),
            tracking: self.tracking,
            replay: self.replay.as_ref(),
            around: Some(around),
            faults,
        }
    }

    /// The plan, that leaves the axes what tracking needs; refused if that cannot be done.
    pub(super) fn plan(&self, loaded: &Loaded, conditions: &Conditions<'_>) -> Result<WeldMotion, Failure> {
        let machine = &loaded.machine;
        let motion = loaded.plan_on(&machine.with_reserve(if self.tracking { RESERVE } else { 0.0 }))?;
        loaded.check_count(&motion, machine.servo_period_s)?;
        if self.distortion.is_some() || self.tracking {
            let paths = loaded.paths();
            check(machine, &loaded.passes(&paths), &motion, conditions)?;
        }
        Ok(motion)
    }
}

/// What an earlier weld has found of the seam.
fn stored(path: &Path) -> Result<DeviationRecord, Failure> {
    let record = DeviationRecord::from_csv(&path.display().to_string(), &files::read(path)?);
    record.map_err(|e| Failure::Input(e.to_string()))
}
