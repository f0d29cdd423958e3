use crate::pass_motion::PassMotion;
use seamwright_machine::Machine;
use seamwright_program::{Outside, Pass, TorchPath, Window};
use serde::{Deserialize, Serialize};

/// A pass with its planned motion.
#[derive(Clone, Copy)]
pub struct PlannedPass<'a> {
    /// The machine whose motion it is.
    pub machine: &'a Machine,
    /// The torch path of the pass.
    pub path: &'a dyn TorchPath,
    /// The pass.
    pub pass: &'a Pass,
    /// Its number in the program, from 1.
    pub number: usize,
    /// The planned motion.
    pub motion: &'a PassMotion,
}

/// A value along a pass.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Quantity {
    /// Its key in the procedure, which ends in its unit.
    pub key: String,
    /// Minimum and maximum value found; none if missing in the plan.
    pub found: Option<(f64, f64)>,
    /// The window, if the procedure has one.
    pub allowed: Option<Window>,
    /// Stretches outside the window, in the order of path length.
    pub outside: Vec<Outside>,
}
