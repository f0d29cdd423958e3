//! Consumable inserts: filler metal between the root faces, fused by the root pass.

use crate::joint::{FitUp, Joint, WeldedSide};
use crate::preparation::Preparation;
use schemars::JsonSchema;
use seamwright_document::{Document, DocumentError, Positive};
use seamwright_message::{Message, Unit};
use serde::{Deserialize, Serialize};

/// A consumable insert (AWS A5.30) in the root gap of a butt joint.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Insert {
    /// Shape of its cross-section.
    pub kind: InsertKind,
    /// Width between the root faces, mm: that of the stem of a T, J or Y.
    pub width_mm: Positive,
    /// Height through the root, mm.
    pub height_mm: Positive,
    /// Area of its cross-section, mm^2; width times height if missing. Needed for a T, J or Y.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub area_mm2: Option<Positive>,
}

/// Shape of an insert by its class in AWS A5.30.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum InsertKind {
    /// Class 1: inverted T, the EB insert.
    InvertedT,
    /// Class 2: J.
    J,
    /// Class 3: solid ring of rectangular section.
    Ring,
    /// Class 4: Y.
    #[serde(rename = "y_shape")]
    Y,
    /// Class 5: rectangle with contoured edges.
    Rectangular,
}

/// The root gap may be wider than the insert by this much, mm: a wider gap does not fuse safely to both root faces.
/// A shop value: put that of the qualified procedure in its place.
pub const MAX_INSERT_PLAY_MM: f64 = 0.5;

impl Insert {
    /// Area of its cross-section, mm^2.
    pub fn area_mm2(&self) -> f64 {
        self.area_mm2.map_or_else(|| self.width_mm.get() * self.height_mm.get(), Positive::get)
    }

    fn is_rectangle(&self) -> bool {
        matches!(self.kind, InsertKind::Ring | InsertKind::Rectangular)
    }
}

impl Joint {
    /// Checks that the insert at `path` of a file fits in the root gap of a butt joint, as drawn and as measured.
    pub(crate) fn check_insert<T>(&self, file: &Document<T>, path: &str) -> Result<(), DocumentError> {
        let Some(insert) = &self.insert else { return Ok(()) };
        let has_root_faces = self.preparation.is_butt()
            && !matches!(self.preparation, Preparation::Corner(_) | Preparation::FlareV(_))
            && self.side == WeldedSide::Face;
        if !has_root_faces || self.backing.is_some() {
            let message = Message::new("program-insert-without-root-faces");
            return Err(file.error_at(&format!("{path}.insert"), message, Message::new("program-allowed-insert")));
        }
        if insert.area_mm2.is_none() && !insert.is_rectangle() {
            let message = Message::new("program-insert-area-missing");
            let allowed = Message::new("program-allowed-insert-area");
            return Err(file.error_at(&format!("{path}.insert"), message, allowed));
        }
        let wall = self.preparation.thickness_mm().unwrap_or(f64::INFINITY);
        if insert.height_mm.get() >= wall {
            let allowed = Message::new("document-less-than").value("max", wall, Unit::Mm);
            let key = format!("{path}.insert.height_mm");
            return Err(file.error_at(&key, Message::new("program-insert-too-high"), allowed));
        }
        let drawn = format!("{path}.preparation.{}.root_gap_mm", self.preparation.key());
        let drawn = file.given_or(&drawn, &format!("{path}.insert.width_mm")).to_owned();
        insert.check_gap(file, &drawn, self.preparation.root_gap_mm())?;
        let before_weld = |(_, at): &(usize, &FitUp)| at.after_layer == 0;
        for (i, at) in self.fit_up.iter().enumerate().filter(before_weld) {
            insert.check_gap(file, &format!("{path}.fit_up[{i}].root_gap_mm"), at.root_gap_mm.get())?;
        }
        Ok(())
    }
}

impl Insert {
    /// Fails at `key` if the insert does not fit in a root gap (mm), or lies in it with too much play.
    fn check_gap<T>(&self, file: &Document<T>, key: &str, gap: f64) -> Result<(), DocumentError> {
        let width = self.width_mm.get();
        if (width..=width + MAX_INSERT_PLAY_MM).contains(&gap) {
            return Ok(());
        }
        let message = Message::new("program-insert-gap").value("gap", gap, Unit::Mm).value("width", width, Unit::Mm);
        let allowed = Message::new("document-between").value("min", width, Unit::Mm);
        let allowed = allowed.value("max", width + MAX_INSERT_PLAY_MM, Unit::Mm);
        Err(file.error_at(key, message, allowed))
    }
}
