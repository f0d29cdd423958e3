//! The groove as measured along the seam, before the weld or after some of its layers.

use crate::seam::SeamCurve;
use seamwright_program::{FitUp, Joint};

/// The sizes of a groove that differ from part to part; all others are those of the preparation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Groove {
    /// Dihedral angle of the faces, rad.
    pub dihedral: f64,
    /// Root gap, mm.
    pub gap: f64,
    /// Height of the second part over the first, mm.
    pub mismatch: f64,
    /// Groove angle, rad, as the preparation's `angle_deg` counts it; that of the preparation if `None`.
    pub angle: Option<f64>,
}

/// Entries of `[[joint.fit_up]]` with the same number of complete layers.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct MeasuredGroove {
    pub(crate) after_layer: usize,
    /// By path length; empty if the groove is as drawn.
    pub(crate) rows: Vec<MeasuredRow>,
}

/// One entry.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct MeasuredRow {
    /// Its index in the file.
    pub(crate) index: usize,
    pub(crate) s: f64,
    pub(crate) gap: f64,
    pub(crate) mismatch: f64,
    /// Groove angle beyond the drawn one at its station, rad.
    pub(crate) turn: f64,
    pub(crate) remaining: Option<f64>,
    /// The part of the groove's area that is open.
    pub(crate) open: f64,
}

impl MeasuredRow {
    /// The groove as drawn.
    pub(crate) fn drawn(gap: f64) -> Self {
        Self { index: 0, s: 0.0, gap, mismatch: 0.0, turn: 0.0, remaining: None, open: 1.0 }
    }

    fn new(index: usize, at: &FitUp, joint: &Joint, seam: &SeamCurve) -> Self {
        let s = at.s_mm.get();
        // Angles of a cut bevel change with the dihedral angle, so their deviation is interpolated.
        let drawn = || joint.groove(seam.at(s).dihedral).0;
        let turn = at.angle_deg.and_then(|angle| Some(angle.get().to_radians() - drawn()?));
        Self {
            index,
            s,
            gap: at.root_gap_mm.get(),
            mismatch: at.mismatch_mm.get(),
            turn: turn.unwrap_or_default(),
            remaining: at.remaining_mm2.map(seamwright_document::Finite::get),
            open: 1.0,
        }
    }

    fn towards(&self, other: &Self, part: f64) -> Self {
        let between = |a: f64, b: f64| a + part * (b - a);
        Self {
            gap: between(self.gap, other.gap),
            mismatch: between(self.mismatch, other.mismatch),
            turn: between(self.turn, other.turn),
            open: between(self.open, other.open),
            ..*self
        }
    }
}

impl MeasuredGroove {
    /// The states of a joint, the first of them before the weld.
    pub(crate) fn all(joint: &Joint, seam: &SeamCurve) -> Vec<Self> {
        let mut all = vec![Self { after_layer: 0, rows: Vec::new() }];
        for (index, at) in joint.fit_up.iter().enumerate() {
            let row = MeasuredRow::new(index, at, joint, seam);
            match all.last_mut() {
                Some(last) if last.after_layer == at.after_layer => last.rows.push(row),
                _ => all.push(Self { after_layer: at.after_layer, rows: vec![row] }),
            }
        }
        all
    }

    /// The groove at path length `s`, linear between entries, on a seam of length `period` all round.
    pub(crate) fn at(&self, s: f64, period: Option<f64>) -> Option<MeasuredRow> {
        let (rows, first, last) = (&self.rows, self.rows.first()?, self.rows.last()?);
        let s = period.map_or(s, |period| first.s + (s - first.s).rem_euclid(period));
        let i = rows.partition_point(|row| row.s <= s);
        let Some(k) = i.checked_sub(1) else { return Some(*first) };
        let (next, to) = match (rows.get(i), period) {
            (Some(next), _) => (next, next.s),
            (None, Some(period)) => (first, first.s + period),
            (None, None) => return Some(*last),
        };
        Some(rows[k].towards(next, (s - rows[k].s) / (to - rows[k].s)))
    }
}
