//! Weld metal of earlier passes as solids: obstacles of the passes after them.
//!
//! Passes whose wire has the same height in the groove are a layer. The areas of the layers, from the root out, give the
//! levels between them, and the beads of a layer share its width evenly. So the metal follows from the rows of the
//! passes alone, in a job as in a program. Crowns are those of the drawn outlines (`beads/outline.rs`), or higher.

use super::groove::{STATIONS, Station, stations};
use super::swept::close_ring;
use crate::joint::{SeamJoint, Section};
use crate::seam::SeamCurve;
use crate::stretch::Stretch;
use glam::{DVec2, DVec3};
use seamwright_clearance::{ClearanceError, Shape, Solid};
use seamwright_program::{BeadRow, Pass, Program};
use std::cell::OnceCell;
use std::sync::Arc;

/// Number of columns across the groove. Beads that end within a column fill it.
const COLUMNS: usize = 24;
/// Beads with wires nearer to each other than this are of one layer (in height) or the same bead (across), mm: far more
/// than rows are rounded, far less than beads are apart.
const SAME_MM: f64 = 0.05;
/// Height of crowns over their layer's level as a part of the layer.
const CROWN: f64 = 0.05;
/// The same in a cap of several beads, as a multiple of its parabola.
const CAP_CROWN: f64 = 1.15;
/// Film over places without metal, as a part of the whole area: it keeps the solid closed.
const FILM: f64 = 1e-3;

/// Weld metal in the order of the passes.
pub struct Metal<'a> {
    program: &'a Program,
    seam: &'a SeamCurve,
    stations: Vec<Station>,
    stretches: Vec<Option<Stretch>>,
    /// All beads of each copy at each station, by layer from the root out and then from the second part to the first.
    deposits: Vec<OnceCell<Vec<Vec<Deposit>>>>,
}

/// A bead at a station.
#[derive(Clone, Copy)]
struct Deposit {
    height: f64,
    across: f64,
    area: f64,
    /// Index of the first pass that lays it.
    pass: usize,
}

impl<'a> Metal<'a> {
    pub(crate) fn new(
        program: &'a Program,
        seam: &'a SeamCurve,
        joint: &SeamJoint,
        stretches: Vec<Option<Stretch>>,
    ) -> Self {
        let is_filled = program.passes.iter().any(|pass| pass.bead.is_some());
        let stations = if is_filled { stations(seam, joint) } else { Vec::new() };
        let deposits = vec![OnceCell::new(); program.copy_count()];
        Self { program, seam, stations, stretches, deposits }
    }

    /// The metal in the work frame before each pass, and after the last one: a solid for each copy of the seam that has
    /// metal. Each is made when it is asked for.
    ///
    /// # Errors
    /// Metal that has no closed surface.
    pub fn by_pass(&self) -> impl Iterator<Item = Result<Vec<Solid>, ClearanceError>> {
        let mut copies: Vec<Option<Solid>> = vec![None; self.program.copy_count()];
        let after = move |(i, pass): (usize, &Pass)| {
            if pass.bead.is_some() && !self.stations.is_empty() {
                copies[pass.copy] = Some(self.of_copy(pass.copy, i + 1)?);
            }
            Ok(copies.iter().flatten().cloned().collect())
        };
        std::iter::once(Ok(Vec::new())).chain(self.program.passes.iter().enumerate().map(after))
    }

    /// The metal on a copy of the seam before pass `before`.
    fn of_copy(&self, copy: usize, before: usize) -> Result<Solid, ClearanceError> {
        let all = self.deposits[copy].get_or_init(|| self.stations.iter().map(|s| self.deposits(s, copy)).collect());
        let outlines: Vec<Vec<DVec3>> =
            self.stations.iter().zip(all).map(|(station, deposits)| outline(station, deposits, before)).collect();
        let mesh = close_ring(&outlines, self.seam.all_round())?;
        let of = self.program.copy_name(copy).map_or(String::new(), |name| format!(" of {name}"));
        let shape = Shape::Mesh(Arc::new(mesh));
        Solid::new(format!("weld metal{of}"), shape, self.program.copy_in_work(copy))
    }

    /// All beads at a station, in order.
    fn deposits(&self, station: &Station, copy: usize) -> Vec<Deposit> {
        let mut all: Vec<Deposit> = Vec::new();
        let section = &station.section;
        let passes =
            self.program.passes.iter().zip(&self.stretches).enumerate().filter(|(_, (pass, _))| pass.copy == copy);
        let beads = passes.flat_map(|(i, (pass, stretch))| {
            let of_pass =
                stretch.iter().flat_map(|stretch| pass.beads().map(|(bead, range)| (bead, stretch.part(range))));
            of_pass.map(move |(bead, stretch)| (i, bead, stretch))
        });
        for (i, bead, stretch) in beads {
            if !self.covers(&stretch, station.p.s) {
                continue;
            }
            let period = self.seam.all_round().then(|| self.seam.length());
            let BeadRow { across_mm, out_mm, area_mm2: area } = bead.row_at(station.p.s, period);
            let tip = DVec2::new(across_mm, out_mm);
            let (height, across) = (tip.dot(section.up), tip.dot(section.across()));
            // The parts of a bead that is welded in several passes overlap.
            let is_same = |d: &Deposit| (d.height - height).abs() < SAME_MM && (d.across - across).abs() < SAME_MM;
            if area > 0.0 && !all.iter().any(is_same) {
                all.push(Deposit { height, across, area, pass: i });
            }
        }
        all.sort_by(|a, b| a.height.total_cmp(&b.height));
        for layer in all.chunk_by_mut(|a, b| b.height - a.height < SAME_MM) {
            layer.sort_by(|a, b| a.across.total_cmp(&b.across));
        }
        all
    }

    /// True if a pass lays metal at path length `s` of the seam, or up to the next station from there.
    fn covers(&self, stretch: &Stretch, s: f64) -> bool {
        let more = self.seam.weld_length() / f64::from(STATIONS);
        let own = stretch.own_s(s) + more;
        let own = if self.seam.all_round() { own.rem_euclid(self.seam.length()) } else { own };
        (0.0..=stretch.length + 2.0 * more).contains(&own)
    }
}

/// The top of a column: its level, the layer below it, and if it is a cap.
#[derive(Clone, Copy, Default)]
struct Top {
    level: f64,
    layer: f64,
    beads: usize,
}

impl Top {
    /// Area below the surface at a part of the width.
    fn at(&self, section: &Section, part: f64) -> f64 {
        let groove = section.area();
        let over = (self.level - groove).max(0.0);
        if over > 0.0 {
            let crown = if self.beads > 1 { CAP_CROWN } else { 1.0 };
            return groove + crown * over * 6.0 * part * (1.0 - part);
        }
        (self.level + CROWN * self.layer).min(groove.max(self.level))
    }
}

/// The outline at a station of the metal laid before pass `before`: its top from the second part to the first, and both
/// roots.
fn outline(station: &Station, deposits: &[Deposit], before: usize) -> Vec<DVec3> {
    let section = &station.section;
    let tops = tops(section, deposits, before);
    let node = |i: usize| {
        let beside = [i.checked_sub(1), Some(i).filter(|i| *i < COLUMNS)];
        let column = |c: usize| tops[c].at(section, i as f64 / COLUMNS as f64);
        let area = beside.into_iter().flatten().map(column).fold(FILM * section.total(), f64::max);
        section.point(i as f64 / COLUMNS as f64, area)
    };
    let roots = [&section.first, &section.second].map(|edge| edge.first().copied().unwrap_or_default());
    (0..=COLUMNS).map(node).chain(roots).map(|p| station.point(p)).collect()
}

/// The tops of all columns, of beads laid before pass `before`.
fn tops(section: &Section, deposits: &[Deposit], before: usize) -> [Top; COLUMNS] {
    let mut tops = [Top::default(); COLUMNS];
    let mut below = 0.0;
    for layer in deposits.chunk_by(|a, b| b.height - a.height < SAME_MM) {
        let area: f64 = layer.iter().map(|d| d.area).sum();
        for (c, top) in tops.iter_mut().enumerate() {
            let share = layer.len() as f64 / COLUMNS as f64;
            let (from, to) = (c as f64 * share, (c + 1) as f64 * share);
            let touched = from.floor() as usize..(to.ceil() as usize).min(layer.len());
            if layer[touched].iter().any(|d| d.pass < before) {
                *top = Top { level: (below + area).min(section.total()), layer: area, beads: layer.len() };
            }
        }
        below += area;
    }
    tops
}
