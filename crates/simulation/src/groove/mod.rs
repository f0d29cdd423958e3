//! Welding of distorted parts layer by layer: the true groove differs from the drawing along the seam, a simulated
//! stripe sensor scans it between layers, and the layers above are planned again.
//!
//! | task | item |
//! |---|---|
//! | a part whose gap, mismatch and angles differ from the drawing | [`DistortedPart`] |
//! | weld it, with or without scans | [`weld_layers`] |
//! | the job of a random saddle or hillside nozzle | [`nozzle_job`] |
//! | errors of many parts | [`Campaign`] |
//!
//! **Metal.** A bead brings the area that its plan has at its station, times the deposition of this weld and a slow
//! random change. Metal fills the true groove from below; its surface has a wave for each bead. Each layer pulls the
//! parts together a little.
//!
//! **Not modelled:** metal that flows along the seam, burn-through, heat, and fusion of the walls, which moves metal but
//! adds none.

mod campaign;
mod layers;
mod part;

pub use campaign::{Campaign, CampaignRow, nozzle_job};
pub use layers::{Scans, WeldedGroove, weld_layers};
pub use part::{DistortedPart, Sensor};
