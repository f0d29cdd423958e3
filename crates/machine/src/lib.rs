//! Machine files, kinematic chains, forward and inverse kinematics, limits.
