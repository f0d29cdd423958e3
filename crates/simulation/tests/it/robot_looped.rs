//! Welds on simulated robot controls in simulated time: the executive, session and protocol of a real cell.

use crate::common::{Script, When, at, down, held, in_mode, limit_use, simulated, up, weld};
use seamwright_executive::devices::{DeviceSet, WithSensors};
use seamwright_executive::{Alarm, Ask, Executive, Mode, Note, Place, Start};
use seamwright_machine::{Clamped, Machine, RobotDevice, Surroundings, shipped};
use seamwright_motion::WeldMotion;
use seamwright_program::{Pass, TorchPath};
use seamwright_simulation::devices::{SimulatedInputs, SimulatedSource};
use seamwright_simulation::robot::{
    Disturbances, EgmControl, JointPositions, LoopedRobot, MAX_JOINTS, RsiControl, RtdeControl, Servo, SimulatedControl,
};
use seamwright_simulation::tracking::Distortion;
use seamwright_simulation::{Conditions, Sample, SimulatedCell};
use seamwright_weld::Welding;
