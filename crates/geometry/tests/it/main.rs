//! All tests in one program, which is compiled and linked once. Those that need a process of their own are beside it.

mod common;
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
