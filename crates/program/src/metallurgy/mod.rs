//! The metals of a weld: composition, carbon equivalents, preheat and cooling time.
//!
//! Formulas are those of EN 1011-2: preheat by its method B (annex C.3, from Uwer and Höhne), cooling time between 800
//! and 500 degrees Celsius by its annex D. They hold for unalloyed and low-alloy ferritic steels.

mod composition;
mod cooling_time;
mod file;
mod preheat;

pub use composition::{CarbonEquivalents, Composition};
pub use cooling_time::{CoolingTime, HeatFlow, ShapeFactors};
pub use file::{Material, MaterialGroup, Materials, WeldMetal};
pub use preheat::{Hardening, PREHEAT_RANGE, PreheatRange};
