use crate::is_beyond;
use schemars::JsonSchema;
use seamwright_document::{Document, DocumentError, Finite, NonNegative};
use serde::{Deserialize, Serialize};

/// Work angles of a bead are smaller than this, degrees.
const MAX_WORK_DEG: f64 = 90.0;

/// Where the bead of a pass lies beside the seam, row by row: columns of equal length. Between the rows everything
/// goes smoothly (twice continuously differentiable) from one value to the next; with one row it is the same all along.
///
/// Rows are by the seam's path length. On a seam that is welded all round they come again every turn and lie within
/// one; on any other they reach from where the pass begins to where it ends or beyond, within the weld.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Bead {
    /// Path lengths on the seam, mm from the start of the weld; increasing.
    pub s_mm: Vec<Finite>,
    /// How far the torch tip is from the seam across the bisector of the faces, towards the first part, mm.
    pub across_mm: Vec<Finite>,
    /// How far the torch tip is from the seam along the bisector, out of the joint, mm.
    pub out_mm: Vec<Finite>,
    /// What the bead adds to the torch's work angle, degrees.
    pub work_angle_deg: Vec<Finite>,
    /// Width of the weave as a part of that of the pass' weave, 0 to 1; empty if it is the same all along.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub weave_part: Vec<NonNegative>,
    /// Area of the bead's cross-section, mm^2; 0 where there is to be no metal.
    pub area_mm2: Vec<NonNegative>,
}

impl Bead {
    /// Checks the values that need no seam: columns of equal length with at least one row, path lengths that increase,
    /// angles in front of both faces. `path` is the bead's address in `file`.
    ///
    /// # Errors
    /// With the key's address.
    pub(crate) fn check<T>(&self, file: &Document<T>, path: &str) -> Result<(), DocumentError> {
        let rows = self.s_mm.len();
        if rows == 0 {
            return Err(file.error_at(&format!("{path}.s_mm"), "the bead has no rows", "at least one path length"));
        }
        let columns = [
            ("across_mm", self.across_mm.len()),
            ("out_mm", self.out_mm.len()),
            ("work_angle_deg", self.work_angle_deg.len()),
            ("area_mm2", self.area_mm2.len()),
            ("weave_part", if self.weave_part.is_empty() { rows } else { self.weave_part.len() }),
        ];
        if let Some((key, found)) = columns.into_iter().find(|(_, found)| *found != rows) {
            let message = format!("the column has {found} rows, s_mm has {rows}");
            return Err(file.error_at(&format!("{path}.{key}"), message, format!("{rows} numbers")));
        }
        if let Some(i) = (1..rows).find(|&i| !is_beyond(self.s_mm[i].get(), self.s_mm[i - 1].get())) {
            let allowed = format!("more than {}", self.s_mm[i - 1].get());
            return Err(file.error_at(&format!("{path}.s_mm[{i}]"), "the path lengths must increase", allowed));
        }
        if let Some(i) = self.work_angle_deg.iter().position(|a| a.get().abs() >= MAX_WORK_DEG) {
            let allowed = format!("more than -{MAX_WORK_DEG} and less than {MAX_WORK_DEG}");
            let message = "the torch would lie behind a face";
            return Err(file.error_at(&format!("{path}.work_angle_deg[{i}]"), message, allowed));
        }
        if let Some(i) = self.weave_part.iter().position(|part| part.get() > 1.0) {
            let message = "the weave would be wider than it is";
            return Err(file.error_at(&format!("{path}.weave_part[{i}]"), message, "0 to 1"));
        }
        Ok(())
    }
}
