//! All tests in one program, which is compiled and linked once.

mod arc_through;
mod at_corner;
mod editing;
mod figures;
mod finding_groups;
mod findings;
mod offsets;
mod oscillation;
mod path_length;
mod positions;
mod procedure_files;
mod process;
mod program_files;
mod weaving;
mod windows;
