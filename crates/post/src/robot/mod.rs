//! Programs of robots: welds in the languages of six-axis arms.
//!
//! A robot control gets poses of the tool centre point in the work frame, positions of external axes and a speed. It
//! goes along lines and arcs from pose to pose and rounds the corners within a zone. [`robot_program`] chooses the poses, speeds and
//! zones; [`write_robot`] writes them in a [`RobotLanguage`]; [`read_robot`] reads the text without the writer;
//! [`verify_robot`] plays what was read by the control's rules (`play.rs`) and compares it with the planned motion. [`robot_to_program`] makes a weld program of
//! what was read.

mod angles;
mod arm;
mod configuration;
mod cutter;
mod language;
mod plan;
mod play;
mod pose;
mod program;
mod read;
mod speeds;
mod stream;
mod to_program;
mod verify;
mod way;
mod weld_values;
mod write;

pub use angles::{euler_zyx, from_euler_zyx, from_rotation_vector, rotation_vector};
pub use arm::{External, RobotArm};
pub use language::RobotLanguage;
pub use plan::{RobotOptions, robot_program};
pub use play::{RobotPiece, RobotPlay};
pub use pose::RobotPose;
pub use program::{ArcEnd, ArcStart, JointTarget, RobotFrames, RobotProgram, RobotStep, TcpMove, ThroughPoint};
pub use read::read_robot;
pub use stream::{MAX_SET_POINTS, ServoStream, SetPoints};
pub use to_program::{ImportedRobot, RobotImport, robot_to_program};
pub use verify::{PlannedRobot, verify_robot};
pub use way::CircularRule;
pub use weld_values::WeldValues;
pub use write::{RobotText, write_robot};
