use crate::path_length::is_beyond;
use schemars::JsonSchema;
use seamwright_document::{Document, DocumentError, Finite, NonNegative};
use seamwright_message::{Message, Unit};
use serde::{Deserialize, Serialize};

/// Work angles of a bead are smaller than this, degrees.
const MAX_WORK_DEG: f64 = 90.0;

/// Position of a pass's bead beside the seam, row by row: columns of equal length. Values between rows are interpolated
/// smoothly (twice continuously differentiable); a single row holds for the whole pass.
///
/// Rows are given by the seam's path length. On a closed seam they repeat every turn and lie within one turn. On an
/// open seam they reach from the start of the pass to its end or beyond, within the weld.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Bead {
    /// Path lengths on the seam, mm from the start of the weld; increasing.
    pub s_mm: Vec<Finite>,
    /// Distance of the torch tip from the seam across the bisector of the faces, mm, positive towards the first part.
    pub across_mm: Vec<Finite>,
    /// Distance of the torch tip from the seam along the bisector, mm, positive out of the joint.
    pub out_mm: Vec<Finite>,
    /// Angle that the bead adds to the torch's work angle, degrees.
    pub work_angle_deg: Vec<Finite>,
    /// Width of the weave as a part of that of the pass' weave, 0 to 1; empty if it is the same all along.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub weave_part: Vec<NonNegative>,
    /// Area of the bead's cross-section, mm^2; 0 where there is to be no metal.
    pub area_mm2: Vec<NonNegative>,
}

/// Place of a bead's wire and its area at one path length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BeadRow {
    /// Distance of the wire from the seam across the bisector, mm.
    pub across_mm: f64,
    /// Distance of the wire from the seam along the bisector, mm.
    pub out_mm: f64,
    /// Area of the cross-section, mm^2.
    pub area_mm2: f64,
}

impl Bead {
    /// The row at path length `s` of the seam, mm: between rows on a line, beyond them as the nearest one, or as after a
    /// `period` (mm) of a seam welded all round. The bead has at least one row.
    pub fn row_at(&self, s: f64, period: Option<f64>) -> BeadRow {
        let s = period.map_or(s, |period| s.rem_euclid(period));
        let last = self.s_mm.len() - 1;
        let after = self.s_mm.partition_point(|row| row.get() <= s);
        let (before, next) = match (after.checked_sub(1), after <= last, period) {
            (Some(before), true, _) => (before, after),
            (None, _, None) => (0, 0),
            (Some(before), false, None) => (before, before),
            (_, _, Some(_)) => (last, 0),
        };
        let distance = |from: f64, to: f64| if to < from { to - from + period.unwrap_or(0.0) } else { to - from };
        let from = self.s_mm[before].get();
        let width = distance(from, self.s_mm[next].get());
        let part = if width > 0.0 { (distance(from, s) / width).clamp(0.0, 1.0) } else { 0.0 };
        let between = |a: f64, b: f64| a + part * (b - a);
        BeadRow {
            across_mm: between(self.across_mm[before].get(), self.across_mm[next].get()),
            out_mm: between(self.out_mm[before].get(), self.out_mm[next].get()),
            area_mm2: between(self.area_mm2[before].get(), self.area_mm2[next].get()),
        }
    }

    /// Checks the values that need no seam: columns of equal length with at least one row, path lengths that increase,
    /// angles in front of both faces. `path` is the bead's address in `file`. Fails with the key's address.
    pub(crate) fn check<T>(&self, file: &Document<T>, path: &str) -> Result<(), DocumentError> {
        let rows = self.s_mm.len();
        if rows == 0 {
            let allowed = Message::new("program-at-least-one-path-length");
            return Err(file.error_at(&format!("{path}.s_mm"), Message::new("program-bead-empty"), allowed));
        }
        let columns = [
            ("across_mm", self.across_mm.len()),
            ("out_mm", self.out_mm.len()),
            ("work_angle_deg", self.work_angle_deg.len()),
            ("area_mm2", self.area_mm2.len()),
            ("weave_part", if self.weave_part.is_empty() { rows } else { self.weave_part.len() }),
        ];
        if let Some((key, found)) = columns.into_iter().find(|(_, found)| *found != rows) {
            let message = Message::new("program-bead-column-length").count("rows", found).count("wanted", rows);
            let allowed = Message::new("program-numbers").count("numbers", rows);
            return Err(file.error_at(&format!("{path}.{key}"), message, allowed));
        }
        if let Some(i) = (1..rows).find(|&i| !is_beyond(self.s_mm[i].get(), self.s_mm[i - 1].get())) {
            let message = Message::new("program-path-lengths-increase");
            let allowed = Message::new("document-more-than").value("min", self.s_mm[i - 1].get(), Unit::Mm);
            return Err(file.error_at(&format!("{path}.s_mm[{i}]"), message, allowed));
        }
        if let Some(i) = self.work_angle_deg.iter().position(|a| a.get().abs() >= MAX_WORK_DEG) {
            let message = Message::new("program-torch-behind-face");
            let allowed = Message::new("document-strictly-between");
            let allowed = allowed.value("min", -MAX_WORK_DEG, Unit::Deg).value("max", MAX_WORK_DEG, Unit::Deg);
            return Err(file.error_at(&format!("{path}.work_angle_deg[{i}]"), message, allowed));
        }
        if let Some(i) = self.weave_part.iter().position(|part| part.get() > 1.0) {
            let message = Message::new("program-weave-part-above-one");
            let allowed = Message::new("document-between").number("min", 0.0, 0).number("max", 1.0, 0);
            return Err(file.error_at(&format!("{path}.weave_part[{i}]"), message, allowed));
        }
        Ok(())
    }
}
