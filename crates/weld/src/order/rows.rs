use crate::allowed::between;
use glam::DVec3;
use schemars::JsonSchema;
use seamwright_document::{Document, DocumentError, Point, Transform};
use seamwright_message::{Message, Unit};
use seamwright_program::SeamCopy;
use serde::{Deserialize, Serialize};
use std::num::NonZeroU32;

/// Maximum number of copies; more are a mistake.
const MAX_COPIES: u32 = 1000;

/// Copies of the seam in parallel rows.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Rows {
    /// Number of rows.
    pub rows: u32,
    /// Number of copies in a row.
    pub columns: u32,
    /// From a copy to the next in its row, in the part's frame, mm.
    #[serde(default, skip_serializing_if = "Point::is_zero")]
    pub step_mm: Point,
    /// From a row to the next, in the part's frame, mm.
    #[serde(default, skip_serializing_if = "Point::is_zero")]
    pub row_step_mm: Point,
}

impl Rows {
    /// Checks the table `rows` of a job with the seam's frame `placement`. Fails with the key's address: no copies or
    /// very many, copies at the same position or too far away.
    pub(crate) fn check<T>(&self, file: &Document<T>, placement: &Transform) -> Result<(), DocumentError> {
        for (key, count) in [("rows.rows", self.rows), ("rows.columns", self.columns)] {
            if count == 0 || count > MAX_COPIES {
                let allowed = between(1.0, f64::from(MAX_COPIES), Unit::One);
                return Err(file.error_at(key, Message::new("weld-copy-count-invalid"), allowed));
            }
        }
        if u64::from(self.rows) * u64::from(self.columns) > u64::from(MAX_COPIES) {
            let allowed =
                Message::new("weld-allowed-columns").value("max", f64::from(MAX_COPIES / self.rows), Unit::One);
            let allowed = allowed.count("copies", MAX_COPIES as usize);
            return Err(file.error_at("rows.columns", Message::new("weld-too-many-copies"), allowed));
        }
        let step = |step: Point| !step.is_zero();
        let coincide = |key: &str, allowed: &'static str| {
            Err(file.error_at(key, Message::new("weld-copies-coincide"), Message::new(allowed)))
        };
        if self.columns > 1 && !step(self.step_mm) {
            return coincide("rows.step_mm", "document-direction");
        }
        if self.rows > 1 && !step(self.row_step_mm) {
            return coincide("rows.row_step_mm", "document-direction");
        }
        let places: Vec<DVec3> = self.places().map(|(_, _, place)| place).collect();
        let place = |step: DVec3| Point::new(placement.move_mm.get() + step);
        if places.iter().any(|step| place(*step).is_none()) {
            let key = if self.columns > 1 { "rows.step_mm" } else { "rows.row_step_mm" };
            let allowed = Message::new("weld-allowed-copies-within").value("limit", 1e7, Unit::Mm);
            return Err(file.error_at(key, Message::new("weld-copy-too-far"), allowed));
        }
        let twice = |(i, place): (usize, &DVec3)| places[..i].contains(place);
        if places.iter().enumerate().any(twice) {
            return coincide("rows.row_step_mm", "weld-allowed-row-step");
        }
        Ok(())
    }

    /// The copies, row by row, the seam's own placement being that of the first.
    pub(crate) fn copies(&self, placement: &Transform) -> Vec<SeamCopy> {
        let copy = |(row, column, step): (u32, u32, DVec3)| SeamCopy {
            name: format!("row {row}, {column}"),
            row: NonZeroU32::new(row),
            placement: Transform {
                move_mm: Point::new(placement.move_mm.get() + step).unwrap_or(placement.move_mm),
                ..*placement
            },
        };
        self.places().map(copy).collect()
    }

    /// Row and number in it, from 1, and how far from the first copy.
    fn places(&self) -> impl Iterator<Item = (u32, u32, DVec3)> {
        let (step, row_step) = (self.step_mm.get(), self.row_step_mm.get());
        (0..self.rows).flat_map(move |row| {
            (0..self.columns)
                .map(move |column| (row + 1, column + 1, f64::from(row) * row_step + f64::from(column) * step))
        })
    }
}
