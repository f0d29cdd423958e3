//! All tests in one program, which is compiled and linked once.

mod grid;
mod joint;
mod joint_no_alloc;
mod stripe_no_alloc;
