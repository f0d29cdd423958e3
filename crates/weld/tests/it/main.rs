//! All tests in one program, which is compiled and linked once.

mod beads;
mod bounds;
mod branch;
mod jobs;
mod nozzle_wall;
mod part;
mod part_groove;
mod part_random;
mod pass;
mod plane;
mod points;
mod random_jobs;
mod short_sequences;
mod space;
mod spiral;
mod spline;
mod stations;
mod t_joint;
mod taught;
mod weave;
mod welding;
