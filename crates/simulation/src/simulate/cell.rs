use super::judge::Judge;
use crate::conditions::Conditions;
use crate::devices::fault::{Device, Faulty};
use crate::devices::simulated::{SimulatedDrives, SimulatedInputs, SimulatedSource};
use crate::error::Error;
use crate::tracking::pass_scene::{PassScene, Whole};
use crate::tracking::simulated_sensors::SimulatedSensors;
use arrayvec::ArrayVec;
use seamwright_executive::devices::{DeviceSet, InputBits, WithSensors};
use seamwright_executive::tracking::{PassSeams, RESERVE, Tracking, TrackingConditions};
use seamwright_executive::{DriveReport, Error as CellError, Place, SensorReport, SourceReport, Start, Work};
use seamwright_machine::Machine;
use seamwright_motion::WeldMotion;
use seamwright_program::{Pass, TorchPath};

/// A program on simulated devices: work, devices, tracking, and evaluation of the weld.
pub struct SimulatedCell<'a> {
    machine: &'a Machine,
    /// The machine used for planning: with tracking, less the reserve of the corrections.
    planned_on: Machine,
    passes: Vec<(&'a dyn TorchPath, &'a Pass)>,
    motion: &'a WeldMotion,
    conditions: Conditions<'a>,
    /// Seams of each pass whose seam may differ from the plan, or that is tracked.
    seams: Vec<Option<PassSeams<'a>>>,
    whole: Whole,
}

/// Simulated devices, each with fault injection.
pub type CellDevices<'a> = WithSensors<
    DeviceSet<
        Faulty<SimulatedDrives, DriveReport>,
        Faulty<SimulatedSource, SourceReport>,
        Faulty<SimulatedInputs, InputBits>,
    >,
    Faulty<SimulatedSensors<'a>, SensorReport>,
>;

impl<'a> SimulatedCell<'a> {
    /// Creates the cell of `motion`, whose passes are `passes`.
    pub fn new(
        machine: &'a Machine,
        passes: Vec<(&'a dyn TorchPath, &'a Pass)>,
        motion: &'a WeldMotion,
        conditions: Conditions<'a>,
    ) -> Self {
        let hidden = conditions.distortion.is_some() || conditions.tracking;
        let whole = Whole::of(&passes);
        let of_pass = |(pass, planned): (&(&'a dyn TorchPath, &'a Pass), &seamwright_motion::PassMotion)| {
            let (path, pass) = *pass;
            let has = hidden && planned.arc && path.points().is_none();
            has.then(|| PassSeams::new(path, pass))
        };
        let seams = passes.iter().zip(&motion.passes).map(of_pass).collect();
        let planned_on = machine.with_reserve(if conditions.tracking { RESERVE } else { 0.0 });
        Self { machine, planned_on, passes, motion, conditions, seams, whole }
    }

    /// Returns the executive's program, from `start` on.
    ///
    /// # Errors
    /// [`Error::Cell`] for more process values than a cell carries.
    pub fn work(&self, start: Start) -> Result<Work<'_>, Error> {
        let passes: Vec<&Pass> = self.passes.iter().map(|(_, pass)| *pass).collect();
        let work = Work::new(&self.planned_on, self.conditions.around, &passes, self.motion, start);
        Ok(work.map_err(CellError::Values)?)
    }

    /// Returns its devices, with the axes at home, or at the start of the first weld if there is no move from home.
    ///
    /// # Errors
    /// [`Error::Cell`] for invalid drive values; [`Error::Tracking`] for a pass that does not allow tracking.
    pub fn devices(&self) -> Result<CellDevices<'_>, Error> {
        let Conditions { seed, faults, .. } = self.conditions;
        let (machine, period) = (self.machine, self.machine.servo_period_s);
        let drives = SimulatedDrives::new(machine, seed)?;
        let drives = match (self.motion.transfers.first(), self.motion.passes.first()) {
            (None, Some(pass)) => drives.standing_at(&pass.path.at(0.0)),
            _ => drives,
        };
        let inputs = SimulatedInputs::all_met(machine);
        let devices = DeviceSet {
            drives: Faulty::new(drives, Device::Drives, faults, period),
            source: Faulty::new(SimulatedSource::new(seed, period), Device::Source, faults, period),
            inputs: Faulty::new(inputs, Device::Inputs, faults, period),
        };
        let sensors = Faulty::new(self.sensors()?, Device::Sensors, faults, period);
        Ok(WithSensors { devices, sensors })
    }

    /// Returns the joint sensors.
    ///
    /// # Errors
    /// [`Error::Tracking`] for a pass that does not allow tracking.
    pub fn sensors(&self) -> Result<SimulatedSensors<'_>, Error> {
        let simulated_heads = self.seams.iter().zip(&self.motion.passes).map(|(seams, planned)| match seams {
            Some(seams) if self.conditions.tracking => {
                Ok(self.scene(seams).simulated_heads(&seams.correction(self.machine, planned)?, self.conditions.seed))
            }
            _ => Ok(ArrayVec::new()),
        });
        let simulated_heads: Result<_, Error> = simulated_heads.collect();
        Ok(SimulatedSensors::new(self.machine, simulated_heads?))
    }

    /// Returns the tracking of its passes, if they are tracked; the program starts at `start`.
    ///
    /// # Errors
    /// [`Error::Tracking`] for a pass that does not allow tracking.
    pub fn tracking(&self, start: Place) -> Result<Option<Tracking<'_>>, Error> {
        let Conditions { replay, around, .. } = self.conditions;
        let conditions = TrackingConditions { replay, around };
        let tracking = || Tracking::new(self.machine, &self.seams, self.motion, conditions, start);
        Ok(self.conditions.tracking.then(tracking).transpose()?)
    }

    /// Returns the evaluation of the weld.
    ///
    /// # Errors
    /// [`Error::Tracking`] for a torch that does not follow the seam's line, on a part that differs from the plan.
    pub fn judge(&self) -> Result<Judge<'_>, Error> {
        let heads = self.seams.iter().zip(&self.motion.passes).map(|(seams, planned)| match seams {
            Some(seams) => self.scene(seams).truths(self.machine, planned, self.conditions.seed),
            None => Ok(ArrayVec::new()),
        });
        let heads: Result<_, Error> = heads.collect();
        Ok(Judge::new(self.machine, &self.passes, self.motion, heads?, self.conditions.seed))
    }
    fn scene<'b>(&'b self, seams: &'b PassSeams<'a>) -> PassScene<'b> {
        PassScene { seams, distortion: self.conditions.distortion, whole: self.whole }
    }
}
