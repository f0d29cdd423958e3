use crate::allowed::by_key;
use crate::beads::Beads;
use crate::order::{self, Cosmetic, Rows, Tacks, WeldOrder};
use crate::procedure;
use glam::DAffine3;
use schemars::JsonSchema;
use seamwright_clearance::SolidFile;
use seamwright_document::{Document, DocumentError, Finite, NonNegative, Positive, SchemaVersion, Transform};
use seamwright_message::Message;
use seamwright_program::{
    AtCorner, Clearance, Consumables, Costs, Interpass, Joint, Keyed, Materials, Offsets, OnLimit, Oscillation, Part,
    ProcessValues, Seam, SeamCopy, SeamStart, Sequence, SpareAxes, Taught, Tolerance, Torch, TransferMoves, Weave,
    check_metals, check_offset, check_process,
};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// A job file: what is to be welded, how, and on which machine.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Job {
    /// Version of the file format.
    pub schema: SchemaVersion,
    /// Title, for people and for the report.
    pub title: String,
    /// The machine: a name of one that ships, or a path to a machine file from the job's folder.
    pub machine: String,
    /// The work offset in force: a name among `offsets`. Without one the part's frame is the machine's work frame.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub offset: Option<String>,
    /// Work offsets by name: the part's frame in the machine's work frame, as measured.
    #[serde(default, skip_serializing_if = "Offsets::is_empty")]
    pub offsets: Offsets,
    /// The seam's frame in the part's frame.
    #[serde(default)]
    pub placement: Transform,
    /// The places at which the seam is welded, if it is welded at several; they replace `placement`. Or `rows`.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub copies: Vec<SeamCopy>,
    /// The seam at many places, in rows.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rows: Option<Rows>,
    /// The order of welding.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub order: Option<WeldOrder>,
    /// Tacks, welded before everything else.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tacks: Option<Tacks>,
    /// The welding procedure that passes must keep to: a name of one that ships, or the path of a procedure file from the
    /// job's folder.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub procedure: Option<String>,
    /// The seam.
    pub seam: Seam,
    /// Start of the weld on the seam, its direction and its overlap.
    #[serde(default)]
    pub start: SeamStart,
    /// The joint: how the edges are prepared and fitted up.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub joint: Option<Joint>,
    /// Beads that fill the joint, in as many passes as needed. Without it the weld is one pass along the seam.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub beads: Option<Beads>,
    /// A pass over the finished weld.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cosmetic: Option<Cosmetic>,
    /// Base materials and weld metal.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub materials: Option<Materials>,
    /// Waiting between passes until the weld has cooled.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub interpass: Option<Interpass>,
    /// Filler metal, gas and flux, for the totals.
    #[serde(default, skip_serializing_if = "Consumables::is_usual")]
    pub consumables: Consumables,
    /// Rates for the cost of the weld.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub costs: Option<Costs>,
    /// Parts of the seam replaced by taught points, in order.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub taught: Vec<Taught>,
    /// Torch angles.
    #[serde(default)]
    pub torch: Torch,
    /// Tolerances of the finished weld.
    #[serde(default)]
    pub tolerance: Tolerance,
    /// Use of redundant axes: those beyond the ones that the torch needs.
    #[serde(default)]
    pub spare_axes: SpareAxes,
    /// Times before and after the travel.
    #[serde(default)]
    pub sequence: Sequence,
    /// The part as a solid.
    #[serde(default, skip_serializing_if = "Part::is_usual")]
    pub part: Part,
    /// Solids that hold the part, in the machine's work frame.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub fixtures: Vec<SolidFile>,
    /// Minimum clearance of the machine from part and fixtures.
    #[serde(default, skip_serializing_if = "Clearance::is_usual")]
    pub clearance: Clearance,
    /// Moves with the arc off.
    #[serde(default)]
    pub air: TransferMoves,
    /// Speed and process.
    pub weld: Weld,
}

/// Speed and process of the weld.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Weld {
    /// Speed of the torch tip along the seam, relative to the work, mm/s.
    pub speed_mm_s: Positive,
    /// Behaviour where an axis cannot keep that speed.
    #[serde(default)]
    pub on_limit: OnLimit,
    /// The procedure's minimum speed while the arc is on, mm/s; less than `speed_mm_s`. Acceleration and
    /// deceleration phases are exempt.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub least_speed_mm_s: Option<Positive>,
    /// Behaviour at a corner inside the weld.
    #[serde(default, skip_serializing_if = "AtCorner::is_usual")]
    pub corner: AtCorner,
    /// Process values by name; the name ends in its unit: `current_a`, `voltage_v`, `wire_feed_m_min` and so on. Each
    /// is a number, or a ramp `{ from = .., to = .. }` linear in path length over the weld.
    #[serde(default)]
    pub process: ProcessValues,
    /// Speed and process values at several places, linear in between.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub at: Vec<Station>,
    /// Weave of the torch; no weave if missing. With `[beads]`: the weave of passes that have none of their own.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub weave: Option<Weave>,
    /// Oscillation of the beam during travel.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub oscillation: Option<Oscillation>,
}

impl Job {
    /// Reads a job file.
    ///
    /// # Errors
    /// The first thing wrong, with its address.
    pub fn read(file: &str, text: &str) -> Result<Document<Self>, DocumentError> {
        let job = Document::<Self>::read(file, text)?;
        check_offset(&job, job.value.offset.as_deref(), &job.value.offsets)?;
        check_process(&job, "weld.process", &job.value.weld.process)?;
        job.value.weld.corner.check(&job, "weld.corner", Keyed { key: "tolerance", value: &job.value.tolerance })?;
        if let Some(weave) = &job.value.weld.weave {
            let corner = Keyed { key: "weld.corner", value: &job.value.weld.corner };
            weave.check(&job, "weld.weave", &job.value.weld.process, corner)?;
        }
        if let Some(oscillation) = &job.value.weld.oscillation {
            oscillation.check(&job, "weld.oscillation")?;
        }
        job.value.sequence.check(&job, "sequence", &job.value.weld.process)?;
        if job.value.weld.least_speed_mm_s.is_some_and(|least| least >= job.value.weld.speed_mm_s) {
            let allowed = by_key("weld-allowed-less-than-key", "speed_mm_s", job.value.weld.speed_mm_s.get());
            return Err(job.error_at("weld.least_speed_mm_s", Message::new("weld-min-speed-too-high"), allowed));
        }
        let (sequence, process) = (&job.value.sequence, &job.value.weld.process);
        if let Some(tacks) = &job.value.tacks {
            tacks.check(&job, sequence, process)?;
        }
        if let Some(cosmetic) = &job.value.cosmetic {
            cosmetic.check(&job, sequence, process)?;
        }
        order::copies(&job)?;
        check_metals(&job, job.value.materials.as_ref(), job.value.interpass.as_ref(), &job.value.consumables)?;
        procedure::check_one_wire(&job)?;
        if let Some(beads) = &job.value.beads {
            beads.check(&job)?;
            if job.value.joint.is_none() {
                let allowed = Message::new("weld-allowed-joint");
                return Err(job.error_at("beads", Message::new("weld-beads-without-joint"), allowed));
            }
            if !job.value.weld.at.is_empty() {
                let message = Message::new("weld-stations-with-beads");
                return Err(job.error_at("weld.at", message, Message::new("weld-allowed-no-table-or-beads")));
            }
        }
        Ok(job)
    }

    /// Frame of the seam, or of the first of its copies: maps the seam's frame to the machine's work frame, by way of
    /// the part's.
    pub(crate) fn seam_in_work(&self) -> DAffine3 {
        let chosen = self.offset.as_ref().and_then(|name| self.offsets.get(name));
        let placement = self.copies.first().map_or(&self.placement, |copy| &copy.placement);
        chosen.map_or(DAffine3::IDENTITY, Transform::affine) * placement.affine()
    }
}

/// Values of the weld at one place; between places they are linear in path length, before the first and after the last
/// one they stay.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Station {
    /// Path length from the start of the weld, mm.
    pub s_mm: NonNegative,
    /// Speed there, mm/s.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub speed_mm_s: Option<Positive>,
    /// Process values there, of those in `[weld.process]`.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub process: BTreeMap<String, Finite>,
}
