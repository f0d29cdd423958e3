//! The running machine: the simulated cell.
