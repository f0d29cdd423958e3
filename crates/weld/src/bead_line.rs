use crate::allowed::{at_most, between, on_weld, rounded};
use crate::pass_keys::PassKeys;
use crate::periodic_places::repeated;
use crate::seam::{SeamCurve, SeamPoint};
use crate::stretch::Stretch;
use glam::DVec3;
use seamwright_document::{Document, DocumentError, Finite};
use seamwright_geometry::CubicSpline;
use seamwright_message::{Message, Unit};
use seamwright_program::{Bead, Keyed, PathRange, SAME_POSITION_MM, is_before, is_beyond, is_same_position};

/// Position of the torch beside the seam.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BesideSeam {
    /// Distance across the bisector towards the first part, mm.
    pub across: f64,
    /// Distance along the bisector out of the joint, mm.
    pub out: f64,
    /// Addition to the work angle, rad.
    pub lean: f64,
    /// Width of the weave as a part of its own.
    pub weave_part: f64,
}

impl BesideSeam {
    /// The seam itself.
    pub(crate) const ON_SEAM: Self = Self { across: 0.0, out: 0.0, lean: 0.0, weave_part: 1.0 };

    /// The torch tip over a point of the seam, in the seam's frame, mm.
    pub fn over(&self, p: &SeamPoint) -> DVec3 {
        p.point + self.across * p.towards_first + self.out * p.bisector
    }

    /// Goes `part` of the way to `other`.
    pub(crate) fn towards(&self, other: &Self, part: f64) -> Self {
        let between = |a: f64, b: f64| a + part * (b - a);
        Self {
            across: between(self.across, other.across),
            out: between(self.out, other.out),
            lean: between(self.lean, other.lean),
            weave_part: between(self.weave_part, other.weave_part),
        }
    }
}

/// Position of a bead beside the seam, by the seam's path length: cubic splines through the rows of a [`Bead`],
/// periodic on a seam welded all round, natural on any other.
#[derive(Debug, Clone, PartialEq)]
pub struct BeadLine {
    across: CubicSpline,
    out: CubicSpline,
    /// Addition to the work angle, rad.
    lean: CubicSpline,
    /// Width of the weave as a part of its own.
    weave_part: Option<CubicSpline>,
    rows: Vec<f64>,
    period: Option<f64>,
}

impl BeadLine {
    /// The line of `bead`, whose key in the pass is `key`, of a pass over `stretch` of `seam`; `keys` are those of the pass'
    /// values in `file`.
    ///
    /// # Errors
    /// With the key's address: rows beside the weld, or rows that do not reach over the pass.
    pub fn new<T>(
        file: &Document<T>,
        keys: &PassKeys,
        Keyed { key, value: bead }: Keyed<Bead>,
        seam: &SeamCurve,
        stretch: &Stretch,
    ) -> Result<Self, DocumentError> {
        let rows: Vec<f64> = bead.s_mm.iter().map(|s| s.get()).collect();
        let last = rows.len().saturating_sub(1);
        let wrong = |i: usize, code: &'static str, allowed: Message| {
            Err(file.error_at(&keys.of(&format!("{key}.s_mm[{i}]")), Message::new(code), allowed))
        };
        let period = seam.all_round().then(|| seam.length());
        let end = period.unwrap_or(seam.weld_length());
        // On a seam welded all round its end is its start, which has a row of its own.
        let is_end = |s: f64| period.is_some() && is_same_position(s, end);
        let beside = |s: f64| is_before(s, 0.0) || is_beyond(s, end) || is_end(s);
        if let Some(i) = rows.iter().position(|s| beside(*s)) {
            return wrong(i, "weld-position-beside-weld", on_weld(end, period.is_some()));
        }
        let PathRange { from_mm: from, to_mm: to } = stretch.range();
        if period.is_none() && rows.len() > 1 {
            let code = "weld-bead-rows-too-short";
            if is_beyond(rows[0], from) {
                return wrong(0, code, at_most(rounded(from), Unit::Mm));
            }
            if is_before(rows[last], to) {
                return wrong(last, code, between(rounded(to), rounded(end), Unit::Mm));
            }
        }
        let spline = |column: &[Finite], unit: f64| {
            let points: Vec<_> = rows.iter().zip(column).map(|(s, v)| (*s, unit * v.get())).collect();
            let spline = match period {
                Some(period) => CubicSpline::periodic(&points, period),
                None => CubicSpline::natural(&points),
            };
            let allowed = || Message::new("weld-allowed-path-lengths-increasing");
            spline.map_err(|e| file.error_at(&keys.of(&format!("{key}.s_mm")), e.message(), allowed()))
        };
        let parts: Vec<Finite> = bead.weave_part.iter().filter_map(|part| Finite::new(part.get())).collect();
        Ok(Self {
            across: spline(&bead.across_mm, 1.0)?,
            out: spline(&bead.out_mm, 1.0)?,
            lean: spline(&bead.work_angle_deg, 1f64.to_radians())?,
            weave_part: (!parts.is_empty()).then(|| spline(&parts, 1.0)).transpose()?,
            rows,
            period,
        })
    }

    /// The torch at path length `s` on the seam.
    pub fn at(&self, s: f64) -> BesideSeam {
        BesideSeam {
            across: self.across.at(s).0,
            out: self.out.at(s).0,
            lean: self.lean.at(s).0,
            // Not clamped, which would make corners: at rows of 0 or 1 it may go slightly beyond.
            weave_part: self.weave_part.as_ref().map_or(1.0, |part| part.at(s).0),
        }
    }

    /// Rows inside `range` of the seam, where third derivatives may jump, mm.
    pub(crate) fn knots_within(&self, range: PathRange) -> Vec<f64> {
        // A single row is no knot: it is the same all along.
        repeated(self.rows.iter().copied().filter(|_| self.rows.len() > 1), self.period, range, SAME_POSITION_MM)
    }
}
