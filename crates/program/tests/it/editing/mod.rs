//! Editing of programs: thousands of random programs, operations and ways back.

mod cubics;
mod inverses;
mod layout;
mod random;
mod reducing;
mod refusals;
mod sequences;
mod switches;
mod variables;
