//! Beads: a groove is filled layer by layer, all along the seam.
//!
//! Layers are chosen once, so that beads keep their areas, heights and windows all along the seam (`layers.rs`, with the
//! section of a bead in `shape.rs`). At every station of the seam the beads then fill the groove there (`fill.rs`). Each keeps its share of the area.
//! Speed or wire feed follows, or layers end where there is less to fill (`plan.rs`). Each bead becomes a pass of the
//! program, or several beads all round the seam become one, with step-overs between them (`passes.rs`).
//!
//! **Layers from areas.** The area of a section is quadratic in the height between corners of the edges (`joint`), so
//! the height of a layer follows from its area in closed form. A bead keeps its share of the area all along the seam.
//! Its position and angle become rows of the pass, and its speed becomes ramps.

mod file;
mod fill;
mod findings;
mod in_position;
mod layers;
mod outline;
mod passes;
mod plan;
mod refusal;
mod run_values;
mod sectors;
mod shape;
#[cfg(test)]
mod tests;
mod toes;

pub use file::{Adapt, Beads, Order, Run};
pub use fill::BeadAt;
pub use in_position::{BeadNumbers, ToeAt};
pub use layers::Layer;
pub use plan::BeadPlan;
pub(crate) use run_values::WeldValues;
pub use toes::Toes;

use crate::joint::SeamJoint;
use crate::seam::SeamCurve;
use findings::BeadPlace;
use layers::Runs;
use passes::PassOfBeads;
use seamwright_document::{Document, DocumentError};
use seamwright_message::Message;
use seamwright_program::{Finding, Pass};
use sectors::Sectors;

/// A joint with its beads.
#[derive(Debug)]
pub(crate) struct Filled {
    pub(crate) plan: BeadPlan,
    pub(crate) passes: Vec<Pass>,
    pub(crate) findings: Vec<Finding>,
}

impl Beads {
    /// Fills the joint of `seam`; speed and process values missing from the runs are those of `weld`, all others those of
    /// `template`.
    /// Fails with the key's address: no area of a bead, ramps, a station without a groove.
    pub(crate) fn filled<T>(
        &self,
        file: &Document<T>,
        seam: &SeamCurve,
        joint: &SeamJoint,
        weld: &WeldValues,
        template: &Pass,
    ) -> Result<Filled, DocumentError> {
        if let Some((name, _)) = weld.process.iter().find(|(_, value)| value.is_ramp()) {
            let message = Message::new("weld-ramp-with-beads");
            return Err(file.error_at(&format!("weld.process.{name}"), message, Message::new("document-number")));
        }
        let values = |name, run: &Run| {
            if run.travel_angle_deg.is_some() && !template.torch.at.is_empty() {
                let message = Message::new("weld-travel-angle-twice");
                let allowed = Message::new("weld-allowed-travel-angle-once");
                return Err(file.error_at(&format!("beads.{name}.travel_angle_deg"), message, allowed));
            }
            self.run_values(file, name, run, weld)
        };
        if weld.insert_mm2 > 0.0 && self.root.is_none() {
            let allowed = Message::new("weld-allowed-insert-root");
            return Err(file.error_at("joint.insert", Message::new("weld-insert-without-root"), allowed));
        }
        let fill = values("fill", &self.fill)?;
        let runs = Runs {
            root: self.root.as_ref().map(|run| values("root", run)).transpose()?,
            cap: self.cap.as_ref().map(|run| values("cap", run)).transpose()?.unwrap_or_else(|| fill.clone()),
            fill,
            spacing: self.spacing_to_width.get(),
            most: self.most_percent.get() / 100.0,
        };
        let plan = BeadPlan::new(seam, joint, self, &runs).map_err(|why| {
            let stations = file.given_or("beads.station_mm", "beads");
            let (key, allowed) = why.cure(&joint.joint().preparation, &runs, stations);
            file.error_at(&key, why.message(), allowed)
        })?;
        let sectors = Sectors::new(file, self, seam, weld.process)?;
        self.check_step_over(file, seam)?;
        let all = passes::passes(&plan, self, &runs, &sectors, seam, template);
        if self.adapt == Adapt::WeaveWidth && all.iter().all(|of| of.pass.weave.is_none()) {
            let allowed = Message::new("weld-allowed-weave");
            return Err(file.error_at("beads.adapt", Message::new("weld-no-bead-weaves"), allowed));
        }
        let place = |bead: usize| {
            let found = |(i, of): (usize, &PassOfBeads)| {
                let turn = of.beads.iter().position(|other| *other == bead)?;
                Some(BeadPlace { pass: i + 1, before_mm: turn as f64 * seam.length() })
            };
            all.iter().enumerate().find_map(found).unwrap_or_default()
        };
        let findings = plan.findings(&runs, place);
        let passes = all.into_iter().map(|of| of.pass).collect();
        Ok(Filled { plan, passes, findings })
    }
}
