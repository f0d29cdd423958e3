//! Position loop and the drive model used in simulation.
