//! Messages between a panel and its cell.

use crate::target::{Target, USUAL};
use seamwright_cell::{decode_plan, encode_plan, fuzzing};
use seamwright_project::load::{Loaded, load};
use std::path::Path;
use std::sync::OnceLock;

/// Requests of a panel.
pub const CELL_REQUEST: Target =
    Target { name: "cell_request", read: fuzzing::requests, seeds: fuzzing::request_seeds, is_text: false, ..USUAL };

/// Reports of a cell.
pub const CELL_REPORT: Target =
    Target { name: "cell_report", read: fuzzing::reports, seeds: fuzzing::report_seeds, is_text: false, ..USUAL };

/// The motion of a planned job: what a planner's process may send to the executive.
pub const CELL_MOTION: Target = Target {
    name: "cell_motion",
    read: |bytes| {
        if let Ok(plan) = decode_plan(bytes, loaded()) {
            assert_eq!(plan.motion.verify(&loaded().machine), Ok(()));
        }
    },
    seeds: || {
        let motion = loaded().plan().unwrap_or_else(|e| panic!("{}", e.message()));
        vec![encode_plan(loaded(), &motion).unwrap_or_else(|e| panic!("{e}"))]
    },
    is_text: false,
    max_length: 1 << 16,
    ..USUAL
};

/// The shortest job that is delivered.
fn loaded() -> &'static Loaded {
    static LOADED: OnceLock<Loaded> = OnceLock::new();
    LOADED.get_or_init(|| load(Path::new("first-weld")).unwrap_or_else(|e| panic!("{}", e.message())))
}
