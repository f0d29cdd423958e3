//! All tests in one program, which is compiled and linked once.

mod brute_force;
mod distance;
mod domain;
mod fit;
mod head;
mod reduce;
mod reference;
mod rounded_rectangle;
mod spline;
mod torus;
mod trimmed;
