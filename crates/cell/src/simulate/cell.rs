use super::{Conditions, Judge};
use crate::Error;
use crate::devices::{
    Device, DeviceSet, Faulty, InputBits, SimulatedDrives, SimulatedInputs, SimulatedSource, WithSensors,
};
use crate::executive::{DriveReport, Interlocks, Place, SensorReport, SourceReport, Start, Work};
use crate::tracking::{PassScene, RESERVE, SimulatedSensors, Tracking, Whole};
use arrayvec::ArrayVec;
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
    /// Scene of each pass whose seam may differ from the plan, or that is tracked.
    scenes: Vec<Option<PassScene<'a>>>,
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
        let scene = |(pass, planned): (&(&'a dyn TorchPath, &'a Pass), &seamwright_motion::PassMotion)| {
            let (path, pass) = *pass;
            let has = hidden && planned.arc && path.points().is_none();
            has.then(|| PassScene::new(path, pass, conditions.distortion, whole))
        };
        let scenes = passes.iter().zip(&motion.passes).map(scene).collect();
        let planned_on = machine.with_reserve(if conditions.tracking { RESERVE } else { 0.0 });
        Self { machine, planned_on, passes, motion, conditions, scenes }
    }

    /// Returns the executive's program, from `start` on.
    ///
    /// # Errors
    /// [`Error::Values`] for more process values than a cell carries.
    pub fn work(&self, start: Start) -> Result<Work<'_>, Error> {
        let passes: Vec<&Pass> = self.passes.iter().map(|(_, pass)| *pass).collect();
        Work::new(&self.planned_on, self.conditions.around, &passes, self.motion, start).map_err(Error::Values)
    }

    /// Returns its devices, with the axes at home, or at the start of the first weld if there is no move from home.
    ///
    /// # Errors
    /// [`Error::Drive`]; [`Error::Tracking`] for a pass that does not allow tracking.
    pub fn devices(&self) -> Result<CellDevices<'_>, Error> {
        let Conditions { seed, faults, .. } = self.conditions;
        let (machine, period) = (self.machine, self.machine.servo_period_s);
        let drives = SimulatedDrives::new(machine, seed)?;
        let drives = match (self.motion.transfers.first(), self.motion.passes.first()) {
            (None, Some(pass)) => drives.standing_at(&pass.path.at(0.0)),
            _ => drives,
        };
        let inputs = SimulatedInputs::new(Interlocks::new(&machine.interlocks).all_met());
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
        let simulated_heads = self.scenes.iter().zip(&self.motion.passes).map(|(scene, planned)| match scene {
            Some(scene) if self.conditions.tracking => {
                Ok(scene.simulated_heads(&scene.correction(self.machine, planned)?, self.conditions.seed))
            }
            _ => Ok(ArrayVec::new()),
        });
        let simulated_heads: Result<_, crate::tracking::Error> = simulated_heads.collect();
        Ok(SimulatedSensors::new(self.machine, simulated_heads?))
    }

    /// Returns the tracking of its passes, if they are tracked; the program starts at `start`.
    ///
    /// # Errors
    /// [`Error::Tracking`] for a pass that does not allow tracking.
    pub fn tracking(&self, start: Place) -> Result<Option<Tracking<'_>>, Error> {
        let tracking = || Tracking::new(self.machine, &self.scenes, self.motion, self.conditions, start);
        Ok(self.conditions.tracking.then(tracking).transpose()?)
    }

    /// Returns the evaluation of the weld.
    ///
    /// # Errors
    /// [`Error::Tracking`] for a torch that does not follow the seam's line, on a part that differs from the plan.
    pub fn judge(&self) -> Result<Judge<'_>, Error> {
        let heads = self.scenes.iter().zip(&self.motion.passes).map(|(scene, planned)| match scene {
            Some(scene) => scene.truths(self.machine, planned, self.conditions.seed),
            None => Ok(ArrayVec::new()),
        });
        let heads: Result<_, crate::tracking::Error> = heads.collect();
        Ok(Judge::new(self.machine, &self.passes, self.motion, heads?, self.conditions.seed))
    }
}
