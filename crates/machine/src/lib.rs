//! Machine files, kinematic chains, forward and inverse kinematics, limits.
//!
//! A [`Machine`] is read from a machine file. It holds the axes and one chain of elementary motions from the clamped
//! work to the torch. Planner, simulator and posts all use this chain; the code is independent of any particular
//! machine. [`Machine::forward`] computes the pose of the torch, [`Machine::inverse`] all [`Branches`] that reach a
//! pose. [`check`] tests a machine file, and [`Surroundings`] checks clearance.
//!
//! This crate has no time and no file access. Internal lengths are in mm and angles in rad; files are in degrees.
//!
//! # Examples
//!
//! Compute a pose, and the axis positions that reach it:
//!
//! ```
//! use seamwright_machine::{Machine, shipped};
//!
//! let file = shipped("saddle-4axis").expect("a shipped machine");
//! let machine = Machine::read(file.name, file.text)?;
//! let home = machine.home();
//! let pose = machine.forward(&home);
//! let solution = machine.inverse_near(pose, &home)?;
//! assert!((machine.forward(&solution.joints).point - pose.point).length() < 1e-9);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::print_stdout, clippy::print_stderr))]

mod assemble;
mod axis;
mod axis_limits;
mod beam_deflection;
mod cell;
mod chain;
pub mod check;
mod collision_monitor;
mod devices;
mod file;
mod head_pair;
mod import;
mod inverse;
mod lever;
mod links;
mod machine;
mod pitch_error;
mod roll;
mod sensor;
mod shipped;
mod solids;
mod stepper;
mod surroundings;
mod tip_motion;
mod welding_head;

pub use axis::{Axis, AxisKind, Drive, EncoderSide, Load, RangeViolation};
pub use axis_limits::AxisLimits;
pub use beam_deflection::BeamDeflection;
pub use cell::{InterlockFile, Level, PanelLost, Source, SourceFile};
pub use chain::{AxisSet, Chain, Joints, MAX_AXES};
pub use collision_monitor::CollisionMonitor;
pub use devices::{
    BitFile, DeviceFile, EgmFile, LinuxCnc, LinuxCncFile, Listening, MachineDevices, ModbusDevice, ModbusFile,
    NumberFile, NumberType, OutputsFile, Place, Register, ReportsFile, RobotDevice, RobotProtocolKind, Role, RsiFile,
    RtdeFile, Scaled, Steps, StepsFile, Table, Word, WordOrder,
};
pub use file::{
    ControlFile, ControlsFile, DeflectionFile, DriveFile, HeadFile, Io, LinkClearanceFile, MachineFile, NotchFile,
    PitchErrorFile, StepFile, StepperFile, TipFile, TorchFile, ZoneFile, ZoneKind,
};
pub use import::{DhConvention, DhRow, FoundMesh, ImportOptions, ImportedArm, ImportedAxis, ImportedShape, OpwArm};
pub use inverse::{
    ArmConfiguration, ArmMargins, Branches, Elbow, MAX_BRANCHES, PairFault, Shoulder, Solution, Unreachable, WristSide,
};
pub use links::{LinkFrames, LinkJoint, Links, MAX_LINKS, NamedFrame};
pub use machine::{Machine, Target};
pub use pitch_error::PitchError;
pub use roll::RollReference;
pub use seamwright_clearance::{Clamped, Solid};
pub use sensor::{CameraSensor, HeightRowFile, PixelMapFile, Sensor, SensorFile, SensorKind, Sight, StripeSensor};
pub use shipped::{SHIPPED, Shipped, shipped};
pub use solids::{LinkSolids, Zone};
pub use stepper::{PulseTicks, Stepper, StepperMotor};
pub use surroundings::{Course, Surroundings};
pub use welding_head::Head;
