use crate::carrier::{Carrier, Guide};
use crate::error::Error;
use crate::seam_line::SeamLine;
use glam::DVec3;
use seamwright_machine::{Clamped, Joints, Machine, Sensor, Surroundings};
use seamwright_motion::PassMotion;
use seamwright_weld::Welding;

/// Data for a move along a joint: the planned weld, near which its redundant axes stay, and the surroundings.
pub struct PlannedWeld<'a> {
    nominal: &'a SeamLine,
    planned: PassMotion,
    around: Surroundings<'a>,
}

impl<'a> PlannedWeld<'a> {
    /// Plans the first pass of `welding`, a job with its seam, on `machine` with `clamped` on it.
    ///
    /// # Errors
    /// A first pass that the machine cannot weld; solids whose clearance cannot be checked.
    pub fn new(
        welding: &Welding,
        machine: &'a Machine,
        clamped: &'a Clamped,
        nominal: &'a SeamLine,
    ) -> Result<Self, Error> {
        let pass = &welding.program.value.passes[0];
        let planned = PassMotion::plan(machine, &welding.path(0), pass, 1).map_err(Error::Findings)?;
        let around = Surroundings::new(machine, clamped).map_err(|e| Error::Refused(e.message()))?;
        Ok(Self { nominal, planned, around })
    }

    /// Positions of the axes where the planned weld is nearest to a point.
    pub fn guide(&self, point: DVec3) -> Option<Joints> {
        Some(self.planned.path.at(self.nominal.foot(point)?.way.min(self.planned.path.length())))
    }

    /// Positions of the axes at the start of the planned weld.
    pub fn start(&self) -> Joints {
        self.planned.path.at(0.0)
    }

    /// Obstacles of the machine.
    pub fn around(&self) -> &Surroundings<'a> {
        &self.around
    }

    /// The machine with its camera and its axes at `axes`.
    pub fn carrier<'b>(
        &'b self,
        machine: &'b Machine,
        sensor: &'b Sensor,
        guide: Guide<'b>,
        axes: Joints,
    ) -> Carrier<'b> {
        Carrier::new(machine, sensor, &self.around, Some(guide), axes)
    }
}
