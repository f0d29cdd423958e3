//! Position of the simulated part, and whether its passes are tracked, from the command line.

use crate::args::part::PartArgs;
use seamwright_project::failure::Failure;
use seamwright_project::files;
use seamwright_project::simulated_part::Part;
use seamwright_simulation::tracking::Distortion;
use seamwright_tracking::beam::DeviationRecord;
use std::path::Path;

pub(super) fn read(args: &PartArgs) -> Result<Part, Failure> {
    let distortion = match &args.distortion {
        Some(path) => Some(Distortion::read(&path.display().to_string(), &files::read(path)?)?),
        None => None,
    };
    let replay = args.replay.as_deref().map(stored).transpose()?;
    let tracking = (distortion.is_some() || replay.is_some()) && !args.no_tracking;
    Ok(Part { distortion, replay, tracking })
}

/// Deviations of the seam that an earlier weld has measured.
fn stored(path: &Path) -> Result<DeviationRecord, Failure> {
    let record = DeviationRecord::from_csv(&path.display().to_string(), &files::read(path)?);
    record.map_err(|e| Failure::input(e.to_string()))
}
