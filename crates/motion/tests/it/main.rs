//! All tests in one program, which is compiled and linked once. Tests that count the resources of a process are
//! separate programs.

mod air;
mod arc_limits;
mod asked_speed;
mod examples;
mod fine;
mod held_axes;
mod pace;
#[path = "../pace_law/mod.rs"]
mod pace_law;
mod pace_run;
mod pace_start;
mod passes;
mod positions;
mod procedure;
mod pulses;
mod ranges;
mod redundancy;
mod run_up;
mod searches;
mod taught;
mod tip_limits;
mod weave;
mod weld_motion;
