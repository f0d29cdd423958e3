//! One chain of blobs across the columns: the stripe, without reflections and spatter.
//!
//! Viterbi's method with a few live ends: an end is continued by a blob of the next column, or waits while columns have
//! none that fits. A blob earns up to 1 by its strength; a step costs by how far it leaves the end's course, but never
//! more than a jump does (edges of lap joints, gaps), which takes more columns to earn than spatter has. A reflection
//! must earn its way out and back, and so cannot take over where the stripe itself is seen.

use super::blobs::{Blob, Blobs, MOST};
use glam::DVec2;

/// Cost of a pixel off the course, and of a pixel up or down whatever the course: corners, steep walls.
const A_PIXEL: f32 = 0.8;
const A_ROW: f32 = 0.12;

/// Rows up or down that are free for every column, and most such columns.
const FREE_ROWS: f32 = 1.0;
const FREE_COLUMNS: f32 = 40.0;

/// Most that a step costs, and what it costs more by the columns of the image.
const JUMP: f32 = 20.0;
const JUMP_COLUMNS: f32 = 64.0;

/// Live ends kept while they wait.
const WAITING: usize = 4;

/// Part of a new slope in the course.
const NEW_SLOPE: f32 = 0.4;

/// Steepest course, rows a column.
const STEEPEST: f32 = 4.0;

/// A place of the stripe in the image.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StripePoint {
    /// Column, and row of the stripe's centre, pixels.
    pub at: DVec2,
    /// Grey values (0 to 255) above the background, summed down the column.
    pub strength: f64,
    /// Rows from border to border.
    pub width: f64,
    /// Whether some of its pixels are saturated.
    pub saturated: bool,
}

/// A blob in a chain.
#[derive(Debug, Clone, Copy)]
struct Node {
    column: u32,
    blob: u8,
    before: u32,
}

/// The end of a chain.
#[derive(Debug, Clone, Copy)]
struct End {
    score: f32,
    row: f32,
    slope: f32,
    column: u32,
    node: u32,
    /// Continued by a blob that lies on its course: nothing is lost by not waiting any more.
    continued: bool,
}

/// Chains blobs; its buffers are kept from image to image.
#[derive(Debug, Clone, Default)]
pub(super) struct Chainer {
    nodes: Vec<Node>,
    live: Vec<End>,
    next: Vec<End>,
    strengths: Vec<f32>,
}

const NONE: u32 = u32::MAX;

/// A run of the stripe has at least this part of the image's columns, and so many.
const SHORTEST_PART: usize = 32;
const SHORTEST: usize = 8;

/// A run ends where so many columns are missing, or where the next place is so many rows off for each column, and more.
const BREAK_COLUMNS: f64 = 14.0;
const BREAK_SLOPE: f64 = 5.0;
const BREAK_ROWS: f64 = 8.0;

impl Chainer {
    /// Room for what an image of so many columns can hold.
    pub(super) fn reserve(&mut self, columns: usize) {
        self.nodes.clear();
        self.nodes.reserve(columns * MOST);
        self.live.clear();
        self.live.reserve(WAITING + 2 * MOST);
        self.next.clear();
        self.next.reserve(MOST);
        self.strengths.clear();
        self.strengths.reserve(columns);
    }

    /// The stripe among `blobs`, from left to right, into `chain`.
    pub(super) fn link(&mut self, blobs: &Blobs, chain: &mut Vec<StripePoint>) {
        chain.clear();
        let usual = self.usual_strength(blobs);
        let jump = JUMP + blobs.width() as f32 / JUMP_COLUMNS;
        self.nodes.clear();
        self.live.clear();
        let mut best: Option<(f32, u32)> = None;
        for column in 0..blobs.width() {
            let found = blobs.of(column);
            if found.is_empty() {
                continue;
            }
            self.next.clear();
            for (i, blob) in found.iter().enumerate() {
                let end = self.extend(column as u32, i as u8, blob, (usual, jump));
                if best.is_none_or(|(score, _)| end.score > score) {
                    best = Some((end.score, end.node));
                }
                self.next.push(end);
            }
            self.live.retain(|end| !end.continued);
            self.live.sort_unstable_by(|a, b| b.score.total_cmp(&a.score));
            self.live.truncate(WAITING);
            self.live.append(&mut self.next);
        }
        let mut node = best.map_or(NONE, |(_, node)| node);
        while let Some(&Node { column, blob, before }) = self.nodes.get(node as usize) {
            let blob = blobs.of(column as usize)[usize::from(blob)];
            chain.push(StripePoint {
                at: DVec2::new(f64::from(column), f64::from(blob.row)),
                strength: f64::from(blob.strength),
                width: f64::from(blob.width),
                saturated: blob.saturated,
            });
            node = before;
        }
        chain.reverse();
        drop_short_runs(chain, blobs.width());
    }

    /// Median strength of the strongest blobs of the columns.
    fn usual_strength(&mut self, blobs: &Blobs) -> f32 {
        self.strengths.clear();
        let best = |c: usize| blobs.of(c).iter().map(|b| b.strength).reduce(f32::max);
        self.strengths.extend((0..blobs.width()).filter_map(best));
        if self.strengths.is_empty() {
            return 1.0;
        }
        let middle = self.strengths.len() / 2;
        *self.strengths.select_nth_unstable_by(middle, f32::total_cmp).1
    }

    /// The best chain that ends with this blob.
    fn extend(&mut self, column: u32, index: u8, blob: &Blob, (usual, jump): (f32, f32)) -> End {
        let earns = (blob.strength / usual).clamp(0.15, 1.0);
        let mut best: Option<(f32, usize, f32)> = None;
        for (i, end) in self.live.iter_mut().enumerate() {
            let columns = (column - end.column) as f32;
            let off = (blob.row - end.row - end.slope * columns).abs();
            // The course is known less well over columns without the stripe.
            let on_course = A_PIXEL * off / (1.0 + 0.1 * (columns - 1.0)).min(4.0);
            let free = FREE_ROWS * columns.min(FREE_COLUMNS);
            let anywhere = A_ROW * ((blob.row - end.row).abs() - free).max(0.0) + 0.4;
            let cost = on_course.min(anywhere).min(jump);
            if cost < earns {
                end.continued = true;
            }
            if best.is_none_or(|(score, _, _)| end.score - cost > score) {
                best = Some((end.score - cost, i, columns));
            }
        }
        let node = self.nodes.len() as u32;
        let fresh = End { score: earns, row: blob.row, slope: 0.0, column, node, continued: false };
        let (end, before) = match best {
            Some((score, i, columns)) if score > 0.0 => {
                let last = &self.live[i];
                let step = ((blob.row - last.row) / columns).clamp(-STEEPEST, STEEPEST);
                let jumped = (blob.row - last.row).abs() > STEEPEST * columns + 3.0;
                let slope = if jumped { last.slope } else { last.slope + NEW_SLOPE * (step - last.slope) };
                (End { score: score + earns, slope, ..fresh }, last.node)
            }
            _ => (fresh, NONE),
        };
        self.nodes.push(Node { column, blob: index, before });
        end
    }
}

/// Takes out short runs of places without neighbours: spatter where the stripe itself is not seen.
fn drop_short_runs(chain: &mut Vec<StripePoint>, width: usize) {
    let shortest = (width / SHORTEST_PART).max(SHORTEST);
    let breaks = |a: &StripePoint, b: &StripePoint| {
        let step = b.at - a.at;
        step.x > BREAK_COLUMNS || step.y.abs() > BREAK_SLOPE * step.x + BREAK_ROWS
    };
    let (mut kept, mut first) = (0, 0);
    for i in 0..chain.len() {
        if i + 1 < chain.len() && !breaks(&chain[i], &chain[i + 1]) {
            continue;
        }
        if i + 1 - first >= shortest {
            chain.copy_within(first..=i, kept);
            kept += i + 1 - first;
        }
        first = i + 1;
    }
    chain.truncate(kept);
}
