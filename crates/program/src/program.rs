use crate::consumables::{Consumables, Costs};
use crate::copies::SeamCopy;
use crate::interpass::Interpass;
use crate::joint::Joint;
use crate::keyed::Keyed;
use crate::metallurgy::Materials;
use crate::offsets::{Offsets, check_offset};
use crate::part::{Clearance, Part};
use crate::pass::Pass;
use crate::path_length::{is_beyond, is_same_position};
use crate::procedure::Procedure;
use crate::process::check_process;
use crate::repeat::Repeat;
use crate::seam::{Seam, SeamStart};
use crate::taught::Taught;
use crate::transfer::TransferMoves;
use crate::variables::{self, Variables};
use glam::DAffine3;
use schemars::JsonSchema;
use seamwright_clearance::SolidFile;
use seamwright_document::{Document, DocumentError, SchemaVersion, Transform, to_toml};
use seamwright_message::{Message, Unit};
use serde::{Deserialize, Serialize};

/// A weld program: everything needed to weld, but for the machine's own file.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Program {
    /// Version of the file format.
    pub schema: SchemaVersion,
    /// Title, for people.
    pub title: String,
    /// The machine: a name of one that ships, or a path to a machine file from the program's folder.
    pub machine: String,
    /// Numbers by name: any number in the file may be written `"= expression"` over them, with + - * / and parentheses.
    #[serde(default, skip_serializing_if = "Variables::is_empty")]
    pub variables: Variables,
    /// The work offset in force: a name among `offsets`. Without one the part's frame is the machine's work frame.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub offset: Option<String>,
    /// Work offsets by name: the part's frame in the machine's work frame, as measured.
    #[serde(default, skip_serializing_if = "Offsets::is_empty")]
    pub offsets: Offsets,
    /// The seam's frame in the part's frame.
    #[serde(default, skip_serializing_if = "Transform::is_identity")]
    pub placement: Transform,
    /// The places at which the seam is welded, if it is welded at several; they replace `placement`.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub copies: Vec<SeamCopy>,
    /// The seam; a program whose passes all go through points needs none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub seam: Option<Seam>,
    /// Start of the weld on the seam.
    #[serde(default)]
    pub start: SeamStart,
    /// The joint along the seam.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub joint: Option<Joint>,
    /// Parts of the seam replaced by taught points, in order.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub taught: Vec<Taught>,
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
    #[serde(default, skip_serializing_if = "TransferMoves::is_usual")]
    pub air: TransferMoves,
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
    /// The welding procedure that the passes must keep to.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub procedure: Option<Procedure>,
    /// Passes in the order of welding.
    pub passes: Vec<Pass>,
}

impl Program {
    /// Names of the process values of all passes, in alphabetical order.
    pub fn process_values(&self) -> Vec<String> {
        let names: std::collections::BTreeSet<&String> =
            self.passes.iter().flat_map(|p| &p.spans).flat_map(|s| s.process.keys()).collect();
        names.into_iter().cloned().collect()
    }

    /// True if `text` is a program and not a job: it has passes.
    pub fn is_in(text: &str) -> bool {
        toml::from_str::<toml::Table>(text).is_ok_and(|t| t.contains_key("passes"))
    }

    /// Reads a program file, with expressions over its variables, and checks that its passes hang together.
    ///
    /// # Errors
    /// The first thing wrong, with its address.
    pub fn read(file: &str, text: &str) -> Result<Document<Self>, DocumentError> {
        let document = Document::<Self>::read(file, &variables::substituted(file, text)?)?;
        check_offset(&document, document.value.offset.as_deref(), &document.value.offsets)?;
        SeamCopy::check(&document, &document.value.copies, &document.value.placement)?;
        if document.value.passes.is_empty() {
            let allowed = Message::new("program-at-least-one-table").key("table", "[[passes]]");
            return Err(document.error_at("passes", Message::new("program-no-passes"), allowed));
        }
        Self::check_extent(&document)?;
        let value = &document.value;
        check_metals(&document, value.materials.as_ref(), value.interpass.as_ref(), &value.consumables)?;
        if let Some(procedure) = &document.value.procedure {
            procedure.check(&document, "procedure")?;
            procedure.check_passes(&document, "procedure", &document.value.passes)?;
        }
        for (p, pass) in document.value.passes.iter().enumerate() {
            let mut end = 0.0;
            if pass.copy >= document.value.copy_count() {
                let allowed = match document.value.copies.len() {
                    0 => Message::new("program-no-copies"),
                    count => Message::new("program-copy-index").number("max", (count - 1) as f64, 0),
                };
                let message = Message::new("program-no-such-copy");
                return Err(document.error_at(&format!("passes[{p}].copy"), message, allowed));
            }
            if let Some(points) = &pass.points {
                points.check(&document, &format!("passes[{p}].points"))?;
                pass.check_through_points(&document, &format!("passes[{p}]"))?;
                continue;
            }
            if document.value.seam.is_none() {
                let message = Message::new("program-pass-without-seam");
                let allowed = Message::new("program-seam-or-points");
                return Err(document.error_at(&format!("passes[{p}]"), message, allowed));
            }
            if pass.spans.is_empty() {
                let message = Message::new("program-pass-without-spans");
                let allowed = Message::new("program-at-least-one-table").key("table", "[[passes.spans]]");
                return Err(document.error_at(&format!("passes[{p}].spans"), message, allowed));
            }
            let (corner, tolerance) = (format!("passes[{p}].corner"), format!("passes[{p}].tolerance"));
            if let Some(bead) = &pass.bead {
                bead.check(&document, &format!("passes[{p}].bead"))?;
            }
            pass.check_step_overs(&document, &format!("passes[{p}]"))?;
            if let Some(weave) = &pass.weave {
                let (path, process) = (format!("passes[{p}].weave"), &pass.spans[0].process);
                weave.check(&document, &path, process, Keyed { key: &corner, value: &pass.corner })?;
                let speed_at = |i: usize| format!("passes[{p}].spans[{i}].speed_mm_s");
                weave.check_speeds(&document, &path, &pass.spans, speed_at)?;
            }
            if let Some(oscillation) = &pass.oscillation {
                oscillation.check(&document, &format!("passes[{p}].oscillation"))?;
            }
            pass.corner.check(&document, &corner, Keyed { key: &tolerance, value: &pass.tolerance })?;
            pass.sequence.check(&document, &format!("passes[{p}].sequence"), &pass.spans[0].process)?;
            for (i, span) in pass.spans.iter().enumerate() {
                let path = |key: &str| format!("passes[{p}].spans[{i}].{key}");
                if !is_same_position(span.from_mm.get(), end) {
                    let message = Message::new("program-span-gap");
                    let allowed = Message::new("quantity").value("value", end, Unit::One);
                    return Err(document.error_at(&path("from_mm"), message, allowed));
                }
                check_process(&document, &path("process"), &span.process)?;
                if !span.process.keys().eq(pass.spans[0].process.keys()) {
                    let names: Vec<&str> = pass.spans[0].process.keys().map(String::as_str).collect();
                    let message = Message::new("program-span-other-values");
                    return Err(document.error_at(&path("process"), message, names.join(", ")));
                }
                let (from, to) = span.speed_mm_s.ends();
                if pass.least_speed_mm_s.is_some_and(|least| least.get() >= from.min(to)) {
                    let message = Message::new("program-min-speed-not-below");
                    let allowed = Message::new("program-below-span-speed").value("max", from.min(to), Unit::One);
                    return Err(document.error_at(&format!("passes[{p}].least_speed_mm_s"), message, allowed));
                }
                end = span.to_mm.get();
                if !is_beyond(end, span.from_mm.get()) {
                    let allowed = Message::new("document-more-than").value("min", span.from_mm.get(), Unit::Mm);
                    return Err(document.error_at(&path("to_mm"), Message::new("program-span-empty"), allowed));
                }
            }
        }
        Ok(document)
    }

    /// The work offset in force: maps the part's frame to the machine's work frame.
    pub fn work_offset(&self) -> DAffine3 {
        self.offset.as_ref().and_then(|name| self.offsets.get(name)).map_or(DAffine3::IDENTITY, Transform::affine)
    }

    /// The program as a file.
    ///
    /// # Errors
    /// None in practice: every value in a program has a TOML form.
    pub fn to_toml(&self) -> Result<String, toml::ser::Error> {
        let mut written = self.clone();
        written.passes.iter_mut().filter(|pass| pass.points.is_some()).for_each(|pass| pass.spans.clear());
        let body = one_point_a_line(&to_toml(&written)?);
        Ok(format!(
            "# A Seamwright weld program. Lengths in mm, angles in degrees, times in s; s counts from the weld's start.\n{body}"
        ))
    }
}

/// Checks the tables `materials`, `interpass` and `consumables` of a job or program file.
///
/// # Errors
/// With the key's address.
pub fn check_metals<T>(
    file: &Document<T>,
    materials: Option<&Materials>,
    interpass: Option<&Interpass>,
    consumables: &Consumables,
) -> Result<(), DocumentError> {
    materials.map_or(Ok(()), |materials| materials.check(file, "materials"))?;
    interpass.map_or(Ok(()), |interpass| interpass.check(file, "interpass"))?;
    consumables.check(file, "consumables")
}

/// Tables of points with a line for each, so that differences of files are those of points.
fn one_point_a_line(text: &str) -> String {
    let mut out = String::with_capacity(text.len() + text.len() / 8);
    for line in text.lines() {
        let table = ["points", "speeds"]
            .into_iter()
            .find_map(|key| Some((key, line.strip_prefix(key)?.strip_prefix(" = [[")?.strip_suffix("]]")?)));
        match table {
            Some((key, rows)) => {
                out.extend([key, " = [\n"]);
                rows.split("], [").for_each(|row| out.extend(["    [", row, "],\n"]));
                out.push(']');
            }
            None => out.push_str(line),
        }
        out.push('\n');
    }
    out
}

impl Program {
    /// The program with each pass as many times as it is welded; the names of repeated ones end in " 1", " 2" and so on.
    pub fn expanded(&self) -> Self {
        let times = |pass: &Pass| {
            let count = pass.repeat.get();
            let name = |i: u16| if count == 1 { pass.name.clone() } else { format!("{} {i}", pass.name) };
            (1..=count).map(|i| Pass { name: name(i), repeat: Repeat::default(), ..pass.clone() }).collect::<Vec<_>>()
        };
        Self { passes: self.passes.iter().flat_map(times).collect(), ..self.clone() }
    }
}
