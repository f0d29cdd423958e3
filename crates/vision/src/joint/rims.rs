//! Rims of a wide gap. Rows may be unconfident because of light within the gap (a chamfer, a rib, dross) or because one
//! plate is far lighter. Their middle is then taken between the two rims that continue steadily.

use super::axis::Station;
use super::levels::{Levels, to_level};
use super::strip::{COLS, Line, MID, Strip, greater};
use super::{CONFIDENT, Row, make_room};
use crate::frame::Frame;

/// Levels between the joint's level and the finer one for the rims: a joint 5 columns wide is 20 columns wide there.
pub(super) const FINER: usize = 2;
/// Lines of the finer level per row of the joint's level.
const LINES: usize = 1 << FINER;
/// Rows before and after over which the joint's direction is measured.
const HEADING: usize = 6;
/// Rows before and after over which a middle is averaged.
const SMOOTH: usize = 4;
/// Minimum rows for a steady rim.
const MIN_ROWS: usize = 4 * SMOOTH;
/// Columns on either side over which a rim's contrast is measured, as a part of the width.
const BESIDE: f32 = 0.1;
/// Minimum distance of a rim from the middle, as a part of the width.
const INNER: f32 = 0.15;
/// Cost of a rim's step to the next column, nats of light.
const MOVE: f32 = 0.5;
/// Minimum contrast between metal and gap at both rims, nats.
const CLEAR: f32 = 0.35;
/// Grey values below this are noise; an offset makes their logarithm nearly linear.
const DARK: f32 = 4.0;
/// Maximum distance of a middle from the previous one, as a part of the width.
const NEAR: f32 = 0.35;

/// Finds rims; reuses its buffers.
#[derive(Debug, Clone, Default)]
pub(super) struct Rims {
    strip: Strip,
    stations: Vec<Station>,
    /// Contrast from left to right at each column's left side, nats.
    edges: Vec<Line>,
    ways: Vec<Line>,
    left: Vec<Rim>,
    right: Vec<Rim>,
    widths: Vec<f32>,
}

#[derive(Debug, Clone, Copy, Default)]
struct Rim {
    /// Columns to the right of the middle.
    at: f32,
    /// Contrast between metal and gap, nats.
    clear: f32,
}

/// Side of the middle on which a rim is searched.
#[derive(Debug, Clone, Copy)]
struct Flank {
    /// -1 on the left, 1 on the right.
    side: f32,
    /// Minimum distance from the middle, columns.
    inner: f32,
}

impl Rims {
    /// Reserves capacity for this many rows.
    pub(super) fn make_room(&mut self, rows: usize) {
        make_room(&mut self.strip.grey, LINES * rows);
        make_room(&mut self.stations, LINES * rows);
        make_room(&mut self.edges, rows);
        make_room(&mut self.ways, rows);
        make_room(&mut self.left, rows);
        make_room(&mut self.right, rows);
        make_room(&mut self.widths, rows);
    }

    /// Places unconfident rows of a joint followed on `level` ([`FINER`] at least) between its rims, where both are
    /// clear.
    pub(super) fn place(&mut self, levels: &Levels, frame: &Frame, level: usize, rows: &mut [Row]) {
        if rows.len() < MIN_ROWS || rows.iter().all(|row| row.confidence >= CONFIDENT) {
            return;
        }
        let fine = level - FINER;
        let scale = (1usize << fine) as f32;
        self.widths.clear();
        self.widths.extend(rows.iter().map(|row| row.width / scale));
        let middle = rows.len() / 2;
        let width = *self.widths.select_nth_unstable_by(middle, f32::total_cmp).1;
        self.stand(fine, rows);
        self.strip.unroll(&levels.picture(frame, fine), self.stations.iter().copied());
        self.find_edges(((BESIDE * width).round() as usize).max(2));
        let inner = INNER * width;
        rim(&self.edges, &mut self.ways, Flank { side: -1.0, inner }, &mut self.left);
        rim(&self.edges, &mut self.ways, Flank { side: 1.0, inner }, &mut self.right);
        for (i, row) in rows.iter_mut().enumerate().filter(|(_, row)| row.confidence < CONFIDENT) {
            let [left, right] = [&self.left, &self.right].map(|rims| about(rims, i));
            let off = 0.5 * (left.at + right.at);
            if left.clear.min(right.clear) < CLEAR || off.abs() > NEAR * width {
                continue;
            }
            let [cos, sin] = self.stations[LINES * i].tangent;
            (row.x, row.y) = (row.x - off * scale * sin, row.y + off * scale * cos);
            row.width = (right.at - left.at) * scale;
        }
    }

    /// Places stations along the rows, on level `fine`, [`LINES`] per row.
    fn stand(&mut self, fine: usize, rows: &[Row]) {
        self.stations.clear();
        for (i, row) in rows.iter().enumerate() {
            let (a, b) = (rows[i.saturating_sub(HEADING)], rows[(i + HEADING).min(rows.len() - 1)]);
            let length = greater(a.away(&b), 1e-3);
            let tangent = [(b.x - a.x) / length, (b.y - a.y) / length];
            let at = [row.x, row.y].map(|v| to_level(v, fine));
            self.stations.extend((0..LINES).map(|k| {
                let along = k as f32 - 0.5 * (LINES - 1) as f32;
                Station { at: [0, 1].map(|n| at[n] + along * tangent[n]), tangent }
            }));
        }
    }

    /// Measures the contrast at each column of each row, from `beside` columns on either side.
    fn find_edges(&mut self, beside: usize) {
        self.edges.clear();
        let part = 1.0 / (LINES * beside) as f32;
        self.edges.extend(self.strip.grey.as_chunks::<LINES>().0.iter().map(|lines| {
            let mut before = [0.0; COLS + 1];
            for j in 0..COLS {
                before[j + 1] = before[j] + part * lines.iter().map(|line| line[j]).sum::<f32>();
            }
            let mut edge = Line::default();
            let ends = before[2 * beside..].iter().zip(&before[beside..]).zip(&before);
            for (edge, ((end, middle), begin)) in edge[beside..].iter_mut().zip(ends) {
                *edge = nats(middle - begin, end - middle);
            }
            edge
        }));
    }
}

/// Returns the contrast between two grey values, nats: the first term of the logarithm's series in difference over sum.
/// It is 1 % low at 0.35 nats, 4 % at 0.7.
fn nats(from: f32, to: f32) -> f32 {
    2.0 * (to - from) / (to + from + 2.0 * DARK)
}

/// Finds the rim on one side: the steady path with the highest sum of contrast.
fn rim(edges: &[Line], ways: &mut Vec<Line>, flank: Flank, rims: &mut Vec<Rim>) {
    let Flank { side, inner } = flank;
    // The left side of a column is half a column from its middle.
    let place = |j: usize| j as f32 - MID as f32 - 0.5;
    ways.clear();
    for edge in edges {
        let before = ways.last().copied().unwrap_or_default();
        ways.push(Line::from_fn(|j| {
            let aside = greater(before[j.saturating_sub(1)], before[(j + 1).min(COLS - 1)]) - MOVE;
            let clear = if side * place(j) < inner { f32::MIN } else { greater(side * edge[j], 0.0) };
            greater(before[j], aside) + clear
        }));
    }
    rims.clear();
    rims.resize(edges.len(), Rim::default());
    let last = ways.last().copied().unwrap_or_default();
    let mut at = (0..COLS).fold(0, |at, j| if last[j] > last[at] { j } else { at });
    for (i, rim) in rims.iter_mut().enumerate().rev() {
        if i + 1 < edges.len() {
            let way = &ways[i];
            let better = |a: usize, b: usize| if way[b] - MOVE > way[a] { b } else { a };
            let aside = if way[at.saturating_sub(1)] > way[(at + 1).min(COLS - 1)] {
                at.saturating_sub(1)
            } else {
                (at + 1).min(COLS - 1)
            };
            at = better(at, aside);
        }
        let clear = |j: usize| side * edges[i][j.min(COLS - 1)];
        let [before, here, after] = [clear(at.saturating_sub(1)), clear(at), clear(at + 1)];
        // Vertex of a parabola through three columns.
        let bend = before - 2.0 * here + after;
        let part = if bend < 0.0 { (0.5 * (before - after) / bend).clamp(-0.5, 0.5) } else { 0.0 };
        *rim = Rim { at: place(at) + part, clear: here };
    }
}

fn about(rims: &[Rim], i: usize) -> Rim {
    let near = &rims[i.saturating_sub(SMOOTH)..(i + SMOOTH + 1).min(rims.len())];
    let part = 1.0 / near.len() as f32;
    let sum = near.iter().fold(Rim::default(), |sum, rim| Rim { at: sum.at + rim.at, clear: sum.clear + rim.clear });
    Rim { at: part * sum.at, clear: part * sum.clear }
}
