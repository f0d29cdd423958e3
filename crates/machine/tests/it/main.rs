//! All tests in one program, which is compiled and linked once.

mod branches;
mod check;
mod common;
mod devices;
mod files;
mod heads;
mod kinematics;
mod pitch_error;
mod random_chains;
mod surroundings;
mod tool;
