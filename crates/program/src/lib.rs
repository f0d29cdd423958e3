//! The weld program as data: a seam, and passes along it with speed, torch angles and process values.
//!
//! A [`Program`] holds a [`Seam`], its [`Joint`] and the [`Pass`]es. [`TorchPath`] is the path of the torch that other
//! crates plan on, [`Finding`] a result of planning, [`Procedure`] the welding procedure specification. [`edit`]
//! changes program files and keeps their comments and layout.
//!
//! This crate has no machine, time or file access. Files are TOML with `schema = 1`; lengths are in mm, angles in files
//! in degrees.
//!
//! # Examples
//!
//! Read a program with a variable:
//!
//! ```
//! use seamwright_program::Program;
//!
//! let text = r#"
//! schema = 1
//! title = "Root pass"
//! machine = "saddle-4axis"
//! [variables]
//! start_angle_deg = 30
//! [seam.nozzle]
//! radius_mm = 250
//! [seam.nozzle.body.cylinder]
//! radius_mm = 800
//! [start]
//! phi_deg = "= start_angle_deg + 15"
//! [[passes]]
//! name = "root"
//! [[passes.spans]]
//! from_mm = 0
//! to_mm = 9
//! speed_mm_s = 5
//! "#;
//! let program = Program::read("program.toml", text)?.value;
//! assert!((program.start.phi_deg.get() - 45.0).abs() < 1e-12);
//! assert!((program.passes[0].length() - 9.0).abs() < 1e-12);
//! # Ok::<(), seamwright_document::DocumentError>(())
//! ```

#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::print_stdout, clippy::print_stderr))]

mod arc_through;
mod arc_time;
mod at_corner;
mod bead;
mod branch;
mod consumables;
mod copies;
pub mod edit;
mod finding;
mod finding_groups;
mod insert;
mod interpass;
mod joint;
mod keyed;
mod metallurgy;
mod nozzle;
mod offsets;
mod oscillation;
mod part;
mod part_of_pass;
mod pass;
mod path_length;
mod path_range;
mod plane_seam;
mod points;
mod preparation;
mod procedure;
mod process;
mod program;
mod repeat;
mod seam;
mod sequence;
mod size_limits;
mod space_seam;
mod span;
mod span_value;
mod spare_axes;
mod step_over;
mod taught;
mod tolerance;
mod torch;
mod torch_jumps;
mod transfer;
mod variables;
mod vessel_head;
mod weave;
mod weave_phase;

pub use arc_through::{ArcThrough, tip_way};
pub use arc_time::ArcTime;
pub use at_corner::AtCorner;
pub use bead::{Bead, BeadRow};
pub use branch::{Branch, OtherBranch};
pub use consumables::{Consumables, Costs};
pub use copies::SeamCopy;
pub use finding::{Finding, Severity, finding_data};
pub use finding_groups::{FindingGroup, FindingPlace, group_findings};
pub use insert::{Insert, InsertKind, MAX_INSERT_PLAY_MM};
pub use interpass::Interpass;
pub use joint::{
    AtDihedral, Backing, BackingKind, FilletOrButt, FitUp, Gouge, Joint, JointStandard, RimJoint, WeldedSide,
};
pub use keyed::Keyed;
pub use metallurgy::{
    CarbonEquivalents, Composition, CoolingTime, Hardening, HeatFlow, Material, MaterialGroup, Materials,
    PREHEAT_RANGE, PreheatRange, ShapeFactors, WeldMetal,
};
pub use nozzle::{Body, Mount, Nozzle, NozzleCurve};
pub use offsets::{OFFSET_NAMES, Offsets, check_offset, is_offset_name};
pub use oscillation::Oscillation;
pub use part::{Clearance, Part};
pub use pass::{OnLimit, Pass, Role};
pub use path_length::{SAME_POSITION_MM, is_before, is_beyond, is_same_position, part_start, parts_of};
pub use path_range::PathRange;
pub use plane_seam::{Arc, Circle, Polyline, RoundedRectangle, WallFaces};
pub use points::{
    Along, Columns, NUMBER_COLUMN, POSE_COLUMNS, PointEvent, PointSpan, Points, SPEED_COLUMN, TIME_COLUMN,
};
pub use preparation::{
    Bevel, Corner, DoubleBevel, DoubleU, DoubleV, Fillet, FlareBevel, FlareV, J, Lap, Member, Preparation, SingleV,
    Square, TBevel, TDoubleBevel, TJ, U,
};
pub use procedure::{
    BeadWindow, ButtLimits, Expected, FilletLimits, Inclination, Outside, PROCEDURES, PassNumbers, Plausibility,
    PositionLimits, PositionStretch, Procedure, QualityLevel, Run, ShippedProcedure, WeldingPosition, WeldingProcess,
    Window, shipped_procedure,
};
pub use process::{ProcessValue, ProcessValues, check_process, check_process_name, check_process_value};
pub use program::{Program, check_metals};
pub use repeat::Repeat;
pub use seam::{Direction as WeldDirection, Ellipse, Girth, Line, Seam, SeamStart, Side, TJoint};
pub use sequence::{AtHold, Sequence, Slope};
pub use size_limits::{MAX_PASSES, MAX_ROWS, MAX_SEAM_MM, MAX_TRAVEL_S};
pub use space_seam::{Helix, Spline};
pub use span::Span;
pub use span_value::{Ramp, SpanValue};
pub use spare_axes::{Position, SpareAxes, Weights};
pub use step_over::StepOver;
pub use taught::Taught;
pub use tolerance::Tolerance;
pub use torch::{
    AxisPositions, Groove, MAX_AXES, ThroughPoints, Torch, TorchAt, TorchPath, WovenPath, line_by_difference,
};
pub use torch_jumps::torch_jumps;
pub use transfer::TransferMoves;
pub use variables::Variables;
pub use vessel_head::{ConicalHead, EllipsoidalHead, FlatHead, HeadStandard, HemisphericalHead, TorisphericalHead};
pub use weave::{Dwells, Figure, Swing, Weave};
pub use weave_phase::Weaving;
