//! One chain of blobs across the columns: the stripe, without reflections and spatter.
//!
//! The method is Viterbi's with a few live ends. An end is continued by a blob of the next column, or waits while no
//! blob of a column fits. A blob earns up to 1 by its strength. A step costs by its distance from the end's course, but
//! at most the cost of a jump (edges of lap joints, gaps). Earning a jump takes more columns than spatter has. A
//! reflection must earn the jumps to it and back, so it cannot take over from a visible stripe.

use super::blobs::{Blob, Blobs, MAX_BLOBS};
use glam::DVec2;

/// Cost per pixel off the course, and per pixel up or down regardless of the course, for corners and steep walls.
const A_PIXEL: f32 = 0.8;
const A_ROW: f32 = 0.12;

/// Rows up or down that are free per column, and the maximum number of such columns.
const FREE_ROWS: f32 = 1.0;
const FREE_COLUMNS: f32 = 40.0;

/// Maximum cost of a step, and the columns of the image that raise it by 1.
const JUMP: f32 = 20.0;
const JUMP_COLUMNS: f32 = 64.0;

/// Maximum number of waiting ends.
const WAITING: usize = 4;

/// Weight of a new slope in the course.
const NEW_SLOPE: f32 = 0.4;

/// Maximum slope of the course, rows per column.
const STEEPEST: f32 = 4.0;

/// A point of the stripe in the image.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StripePoint {
    /// Column, and row of the stripe's centre, pixels.
    pub at: DVec2,
    /// Sum of the grey values (0 to 255) above the background, down the column.
    pub strength: f64,
    /// Rows from border to border.
    pub width: f64,
    /// True if some of its pixels are saturated.
    pub saturated: bool,
}

/// A blob in a chain.
#[derive(Debug, Clone, Copy)]
struct Node {
    column: u32,
    blob: u8,
    before: u32,
}

#[derive(Debug, Clone, Copy)]
struct End {
    score: f32,
    row: f32,
    slope: f32,
    column: u32,
    node: u32,
    /// Continued by a blob on its course, so that nothing is lost if it does not wait any more.
    continued: bool,
}

/// Scales of the scores in an image.
#[derive(Debug, Clone, Copy)]
struct Scoring {
    /// Strength of a usual blob.
    strength: f32,
    /// Maximum cost of a step.
    jump: f32,
}

/// Chains blobs; reuses its buffers from image to image.
#[derive(Debug, Clone, Default)]
pub(super) struct Chainer {
    nodes: Vec<Node>,
    live: Vec<End>,
    next: Vec<End>,
    strengths: Vec<f32>,
}

const NONE: u32 = u32::MAX;

/// Minimum length of a run of the stripe: the columns of the image divided by this, and columns.
const SHORTEST_PART: usize = 32;
const SHORTEST: usize = 8;

/// A run ends at this many missing columns, or at a next point this many rows off: per column, plus a constant.
const BREAK_COLUMNS: f64 = 14.0;
const BREAK_SLOPE: f64 = 5.0;
const BREAK_ROWS: f64 = 8.0;

impl Chainer {
    /// Reserves capacity for an image of this many columns.
    pub(super) fn reserve(&mut self, columns: usize) {
        self.nodes.clear();
        self.nodes.reserve(columns * MAX_BLOBS);
        self.live.clear();
        self.live.reserve(WAITING + 2 * MAX_BLOBS);
        self.next.clear();
        self.next.reserve(MAX_BLOBS);
        self.strengths.clear();
        self.strengths.reserve(columns);
    }

    /// Links the stripe among `blobs` from left to right into `chain`.
    pub(super) fn link(&mut self, blobs: &Blobs, chain: &mut Vec<StripePoint>) {
        chain.clear();
        let strength = self.usual_strength(blobs);
        let scoring = Scoring { strength, jump: JUMP + blobs.width() as f32 / JUMP_COLUMNS };
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
                let end = self.extend(column as u32, i as u8, blob, scoring);
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

    /// Returns the median strength of the strongest blobs of the columns.
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

    /// Returns the best chain that ends with this blob.
    fn extend(&mut self, column: u32, index: u8, blob: &Blob, scoring: Scoring) -> End {
        let earns = (blob.strength / scoring.strength).clamp(0.15, 1.0);
        let mut best: Option<(f32, usize, f32)> = None;
        for (i, end) in self.live.iter_mut().enumerate() {
            let columns = (column - end.column) as f32;
            let off = (blob.row - end.row - end.slope * columns).abs();
            // The course is less certain after columns without the stripe.
            let on_course = A_PIXEL * off / (1.0 + 0.1 * (columns - 1.0)).min(4.0);
            let free = FREE_ROWS * columns.min(FREE_COLUMNS);
            let anywhere = A_ROW * ((blob.row - end.row).abs() - free).max(0.0) + 0.4;
            let cost = on_course.min(anywhere).min(scoring.jump);
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

/// Removes short runs of points without neighbours: spatter where the stripe itself is not visible.
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
