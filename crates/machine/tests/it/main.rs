//! All tests in one program, which is compiled and linked once.

mod arms;
mod branches;
mod check;
mod common;
mod devices;
mod files;
mod heads;
mod import;
mod kinematics;
mod linuxcnc;
mod pitch_error;
mod random_arms;
mod random_chains;
mod robot;
mod round_trip;
mod seven_axes;
mod steps;
mod surroundings;
mod tip_motion;
mod tool;
