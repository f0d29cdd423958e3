use super::strip::{COLS, Line};
use crate::wide::LANES;

/// Columns to one side of the middle at most.
pub(super) const REACH: usize = 13;

/// Parts of the depth at which the middles between rims are compared.
const PARTS: [f32; 3] = [0.3, 0.5, 0.7];

/// Room for the columns on one side, in whole lanes.
pub(super) const ROOM: usize = REACH.next_multiple_of(LANES);

/// A row's grey values from a middle outwards: to the left and to the right. Zeros fill the room.
pub(super) type Arms = [[f32; ROOM]; 2];

/// A bell across the joint, and what of a profile moves with it.
#[derive(Debug, Clone)]
pub(super) struct Profile {
    /// Columns looked at on either side of the middle.
    reach: usize,
    /// Columns within which the floor is.
    half: usize,
    /// Weights of the even part (from the middle outwards) that give the depth.
    depth: [f32; ROOM],
    /// Weights of the odd part that give depth times shift where light changes evenly across the joint.
    moment: [f32; ROOM],
    /// Weights of the odd part that give a step of the light.
    step: [f32; ROOM],
}

/// What one row tells of the joint near a place.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Reading {
    /// Depth, grey values.
    pub(super) depth: f32,
    /// Depth times shift to the right, grey values times pixels.
    pub(super) moment: f32,
    /// Step of the light from left to right, grey values.
    pub(super) step: f32,
}

/// The shape of a profile across the joint: both arms.
#[derive(Debug, Clone, Copy)]
pub(super) struct Shape(pub(super) Arms);

impl Default for Shape {
    fn default() -> Self {
        Self([[0.0; ROOM]; 2])
    }
}

impl Shape {
    pub(super) fn add(&mut self, arms: &Arms, reach: usize) {
        for (sum, arm) in self.0.iter_mut().zip(arms) {
            sum[..=reach].iter_mut().zip(&arm[..=reach]).for_each(|(s, a)| *s += a);
        }
    }

    /// Even light, its slope across, and this shape without those: each of length 1 and square to the others.
    pub(super) fn and_light(&self, reach: usize) -> [Self; 3] {
        let [mut even, mut slope] = [Self::default(); 2];
        for t in 0..=reach {
            even.0.iter_mut().for_each(|arm| arm[t] = 1.0);
            (slope.0[0][t], slope.0[1][t]) = (-(t as f32), t as f32);
        }
        let (even, slope) = (even.unit(), slope.unit());
        (even, slope, self.without(&even).without(&slope).unit()).into()
    }

    fn without(&self, other: &Self) -> Self {
        let part = self.dot(other);
        Self(std::array::from_fn(|k| std::array::from_fn(|t| self.0[k][t] - part * other.0[k][t])))
    }

    fn unit(&self) -> Self {
        let part = 1.0 / self.dot(self).sqrt().max(1e-3);
        Self(self.0.map(|arm| arm.map(|v| part * v)))
    }

    /// The product with another one.
    #[inline(always)]
    pub(super) fn dot(&self, other: &Self) -> f32 {
        dot(&self.0[0], &other.0[0]) + dot(&self.0[1], &other.0[1])
    }
}

impl Profile {
    /// Columns looked at on either side of the middle.
    pub(super) fn reach(&self) -> usize {
        self.reach
    }

    /// For a joint of this full width at half depth, columns.
    pub(super) fn new(width: f32) -> Self {
        let reach = ((1.2 * width + 2.0).ceil() as usize).clamp(3, REACH - 1);
        let spread = width / 2.355;
        let bell = |t: usize| (-0.5 * (t as f32 / spread).powi(2)).exp();
        let (mut slope, mut ramp, mut one, mut even) = ([0.0; ROOM], [0.0; ROOM], [0.0; ROOM], [0.0; ROOM]);
        for t in 0..=reach {
            slope[t] = -(t as f32) / (spread * spread) * bell(t);
            ramp[t] = t as f32;
            one[t] = f32::from(u8::from(t > 0));
            even[t] = bell(t);
        }
        // The middle is there once, all else twice.
        let mut depth = [0.0; ROOM];
        let mean = (2.0 * even.iter().sum::<f32>() - even[0]) / (2 * reach + 1) as f32;
        for t in 0..=reach {
            depth[t] = -(even[t] - mean) * if t == 0 { 1.0 } else { 2.0 };
        }
        let norm = -dot(&depth, &even);
        depth.iter_mut().for_each(|d| *d /= norm);
        let moment = against(&slope, &[ramp]);
        // Half of the step is odd.
        let step = against(&one, &[ramp, less(&slope, &ramp)]).map(|w| 2.0 * w);
        let half = ((0.5 * width).ceil() as usize).min(reach - 2);
        Self { reach, half, depth, moment, step }
    }

    /// What `row` tells about column `centre` (fractions too), and its grey values from there outwards.
    #[inline(always)]
    pub(super) fn read(&self, row: &Line, centre: f32, arms: &mut Arms) -> Reading {
        let centre = centre.clamp((REACH + 1) as f32, (COLS - REACH - 3) as f32);
        let (low, part) = (centre as usize, centre.fract());
        // All columns about the middle at a time.
        let from = low - (REACH - 1);
        let mut mixed = [0.0; 2 * REACH - 1];
        let pairs = row[from..from + 2 * REACH - 1].iter().zip(&row[from + 1..from + 2 * REACH]);
        mixed.iter_mut().zip(pairs).for_each(|(mixed, (a, b))| *mixed = a * (1.0 - part) + b * part);
        let [left, right] = arms;
        for t in 0..REACH {
            (left[t], right[t]) = (mixed[REACH - 1 - t], mixed[REACH - 1 + t]);
        }
        let even = std::array::from_fn(|t| 0.5 * (right[t] + left[t]));
        let odd = std::array::from_fn(|t| 0.5 * (right[t] - left[t]));
        Reading { depth: dot(&self.depth, &even), moment: dot(&self.moment, &odd), step: dot(&self.step, &odd) }
    }

    /// The left and the right rim of a mean row, columns from its middle: where it is half as deep as its floor below the
    /// metal on the darker side. None where a side is no lighter.
    pub(super) fn rims(&self, arms: &Arms) -> Option<[f32; 2]> {
        let valley = self.valley(arms);
        Some([self.rim(arms, &valley, -1, 0.5, 1.0)?, self.rim(arms, &valley, 1, 0.5, 1.0)?])
    }

    /// How far apart the middles between rims are at several parts of the depth, and the middle itself, columns: little for a
    /// valley that is the same on both sides. Each side's depth counts, or no more of it than the darker side's.
    pub(super) fn asymmetry(&self, arms: &Arms) -> f32 {
        let valley = self.valley(arms);
        let (mut low, mut high) = (0.0f32, 0.0f32);
        for most in [1.0, f32::INFINITY] {
            for part in PARTS {
                let rim = |side: isize| self.rim(arms, &valley, side, part, most);
                let (Some(left), Some(right)) = (rim(-1), rim(1)) else { return f32::INFINITY };
                let middle = 0.5 * (left + right);
                (low, high) = (low.min(middle), high.max(middle));
            }
        }
        high - low
    }

    fn valley(&self, arms: &Arms) -> Valley {
        let half = self.half as isize;
        let smooth = |t: isize| 0.25 * at(arms, t - 1) + 0.5 * at(arms, t) + 0.25 * at(arms, t + 1);
        let mut lowest = (smooth(-half), -half);
        for t in 1 - half..=half {
            let value = smooth(t);
            if value < lowest.0 {
                lowest = (value, t);
            }
        }
        let (floor_at, floor) = (lowest.1, at(arms, lowest.1));
        // The lightest metal on a side of the joint, over three columns.
        let depth = |side: isize| {
            let means = (half + 1..self.reach as isize)
                .map(|t| (at(arms, side * (t - 1)) + at(arms, side * t) + at(arms, side * (t + 1))) / 3.0);
            means.fold(f32::MIN, f32::max) - floor
        };
        Valley { floor_at, floor, depths: [depth(-1), depth(1)] }
    }

    /// Where a side rises above a part of its depth, which counts up to `most` times that of the darker side.
    fn rim(&self, arms: &Arms, valley: &Valley, side: isize, part: f32, most: f32) -> Option<f32> {
        let [left, right] = valley.depths;
        let depth = if side > 0 { right } else { left }.min(most * left.min(right));
        let level = valley.floor + part * depth;
        let k = (valley.floor_at * side..self.reach as isize).find(|k| at(arms, side * (k + 1)) >= level)?;
        let (low, rise) = (at(arms, side * k), at(arms, side * (k + 1)) - at(arms, side * k));
        (rise > 0.0).then(|| side as f32 * (k as f32 + ((level - low) / rise).clamp(0.0, 1.0)))
    }
}

/// The floor of a mean row, where it is, and how far the metal on the left and on the right is above it.
struct Valley {
    floor_at: isize,
    floor: f32,
    depths: [f32; 2],
}

/// The grey value so many columns to the right of the middle.
fn at(arms: &Arms, t: isize) -> f32 {
    arms[usize::from(t > 0)][t.unsigned_abs()]
}

/// Weights that give how much of `wanted` is in a line, whatever there is of the others (orthogonal to each other).
fn against(wanted: &[f32; ROOM], others: &[[f32; ROOM]]) -> [f32; ROOM] {
    let free = others.iter().fold(*wanted, |free, other| less(&free, other));
    let norm = dot(&free, wanted);
    free.map(|f| f / norm)
}

/// `a` less its part along `b`.
fn less(a: &[f32; ROOM], b: &[f32; ROOM]) -> [f32; ROOM] {
    let part = dot(a, b) / dot(b, b);
    std::array::from_fn(|t| a[t] - part * b[t])
}

/// The sum of products, several at a time.
#[inline(always)]
fn dot(a: &[f32; ROOM], b: &[f32; ROOM]) -> f32 {
    let mut eight = [0.0; LANES];
    for (a, b) in a.as_chunks::<LANES>().0.iter().zip(b.as_chunks::<LANES>().0) {
        eight = std::array::from_fn(|k| eight[k] + a[k] * b[k]);
    }
    let four: [f32; 4] = std::array::from_fn(|k| eight[k] + eight[k + 4]);
    (four[0] + four[2]) + (four[1] + four[3])
}
