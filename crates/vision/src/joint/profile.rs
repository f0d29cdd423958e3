use super::strip::{COLS, Line, MID, greater};
use crate::aligned::Aligned;
use crate::simd::LANES;
use pulp::{Scalar, Simd};

/// Maximum columns to one side of the middle.
const REACH: usize = 12;

/// Parts of the depth at which the middles between rims are compared.
const PARTS: [f32; 3] = [0.3, 0.5, 0.7];

/// Columns about the middle of a row, in whole lanes.
pub(super) const ROOM: usize = 4 * LANES;

pub(super) const MIDDLE: usize = ROOM / 2;

/// A row's grey values about a middle, from left to right.
pub(super) type Around = Aligned<ROOM>;

/// Filters across the joint that measure depth, shift and light step, for a bell-shaped profile.
#[derive(Debug, Clone)]
pub(super) struct Profile {
    /// Columns used on either side of the middle.
    reach: usize,
    /// Columns on either side of the middle within which the floor lies.
    half: usize,
    /// Weights that give the depth, of the even part of the profile.
    depth: Around,
    /// Weights that give depth times shift, of the odd part, independent of a linear change of the light.
    moment: Around,
    /// Weights that give a step of the light, of the odd part.
    step: Around,
}

/// Measurements of one row near a point.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Reading {
    /// Depth, grey values.
    pub(super) depth: f32,
    /// Depth times shift to the right, grey values times pixels.
    pub(super) moment: f32,
    /// Step of the light from left to right, grey values.
    pub(super) step: f32,
}

/// The shape of a profile across the joint.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Shape(pub(super) Around);

impl Shape {
    pub(super) fn add(&mut self, around: &Around, reach: usize) {
        let within = MIDDLE - reach..=MIDDLE + reach;
        self.0[within.clone()].iter_mut().zip(&around[within]).for_each(|(sum, grey)| *sum += grey);
    }

    /// Returns constant light, its slope across, and this shape without those, orthonormalised.
    pub(super) fn and_light(&self, reach: usize) -> [Self; 3] {
        let even = Self(across(reach, |_| 1.0)).unit();
        let slope = Self(across(reach, |t| t)).unit();
        (even, slope, self.without(&even).without(&slope).unit()).into()
    }

    fn without(&self, other: &Self) -> Self {
        Self(less(&self.0, dot(&self.0, &other.0), &other.0))
    }

    fn unit(&self) -> Self {
        let part = 1.0 / dot(&self.0, &self.0).sqrt().max(1e-3);
        Self(self.0.map(|v| part * v))
    }

    #[inline(always)]
    pub(super) fn dot(&self, simd: impl Simd, other: &Self) -> f32 {
        self.0.dot(simd, &other.0)
    }
}

/// Evaluates `value` at each column offset from the middle, up to `reach` on either side.
pub(super) fn across(reach: usize, value: impl Fn(f32) -> f32) -> Around {
    Around::from_fn(|j| if j.abs_diff(MIDDLE) <= reach { value(j as f32 - MIDDLE as f32) } else { 0.0 })
}

/// Returns the grey values of `row` about the fractional column `centre`.
#[inline(always)]
pub(super) fn about(row: &Line, centre: f32) -> Around {
    let centre = centre.clamp(MIDDLE as f32, (COLS - MIDDLE - 1) as f32);
    let (low, part) = (centre as usize, centre.fract());
    let from = low - MIDDLE;
    let mut around = Around::default();
    let pairs = row[from..from + ROOM].iter().zip(&row[from + 1..=from + ROOM]);
    for (value, (a, b)) in around.iter_mut().zip(pairs) {
        *value = a * (1.0 - part) + b * part;
    }
    around
}

impl Profile {
    /// Returns the columns used on either side of the middle.
    pub(super) fn reach(&self) -> usize {
        self.reach
    }

    /// Creates the filters for a joint of this full width at half depth, columns.
    pub(super) fn new(width: f32) -> Self {
        let reach = ((1.2 * width + 2.0).ceil() as usize).clamp(3, REACH);
        let spread = width / 2.355;
        let bell = |t: f32| (-0.5 * (t / spread).powi(2)).exp();
        let even = across(reach, bell);
        let mean = even.iter().sum::<f32>() / (2 * reach + 1) as f32;
        let depth = across(reach, |t| mean - bell(t));
        let norm = -dot(&depth, &even);
        let depth = depth.map(|weight| weight / norm);
        let ramp = across(reach, |t| t);
        let slope = across(reach, |t| -t / (spread * spread) * bell(t));
        let one = across(reach, |t| if t < 0.0 { -1.0 } else { f32::from(u8::from(t > 0.0)) });
        let moment = against(&slope, &[ramp]);
        // Only half of the step is odd.
        let step = against(&one, &[ramp, less_along(&slope, &ramp)]).map(|w| 2.0 * w);
        let half = ((0.5 * width).ceil() as usize).min(reach - 2);
        Self { reach, half, depth, moment, step }
    }

    /// Measures the joint in a row with these grey values about a point.
    #[inline(always)]
    pub(super) fn read<S: Simd>(&self, simd: S, around: &Around) -> Reading {
        let told = |weights: &Around| weights.dot(simd, around);
        Reading { depth: told(&self.depth), moment: told(&self.moment), step: told(&self.step) }
    }

    /// Returns both rims of a mean row, columns from its middle, at half the depth of the floor below the
    /// darker side's metal. `None` if a side is no lighter.
    pub(super) fn rims(&self, around: &Around) -> Option<[f32; 2]> {
        let valley = self.valley(around);
        Some([self.rim(around, &valley, -1, 0.5, 1.0)?, self.rim(around, &valley, 1, 0.5, 1.0)?])
    }

    /// Returns the spread of the middles between rims at several parts of the depth and the middle itself, columns. It
    /// is small for a symmetric valley. Each side's own depth is tried, and also at most that of the darker side.
    pub(super) fn asymmetry(&self, around: &Around) -> f32 {
        let valley = self.valley(around);
        let (mut low, mut high) = (0.0f32, 0.0f32);
        for most in [1.0, f32::INFINITY] {
            for part in PARTS {
                let rim = |side: isize| self.rim(around, &valley, side, part, most);
                let (Some(left), Some(right)) = (rim(-1), rim(1)) else { return f32::INFINITY };
                let middle = 0.5 * (left + right);
                (low, high) = (low.min(middle), high.max(middle));
            }
        }
        high - low
    }

    fn valley(&self, around: &Around) -> Valley {
        // Index `j` is centred on column `j + 1`; the first and the last column are left out.
        let (left, right) = (&around[..ROOM - 2], &around[2..]);
        let mut smooth = [0.0; ROOM - 2];
        let mut threes = [0.0; ROOM - 2];
        for (j, (smooth, three)) in smooth.iter_mut().zip(&mut threes).enumerate() {
            let middle = around[j + 1];
            *smooth = 0.25 * left[j] + 0.5 * middle + 0.25 * right[j];
            *three = left[j] + middle + right[j];
        }
        let (first, last) = (MIDDLE - 1 - self.half, MIDDLE - 1 + self.half);
        let mut lowest = first;
        for j in first + 1..=last {
            if smooth[j] < smooth[lowest] {
                lowest = j;
            }
        }
        let floor = around[lowest + 1];
        // Lightest metal on a side of the joint, over three columns.
        let depth = |threes: &[f32]| threes.iter().fold(f32::MIN, |most, three| greater(*three, most)) / 3.0 - floor;
        let depths = [depth(&threes[MIDDLE - self.reach..first]), depth(&threes[last + 1..MIDDLE - 1 + self.reach])];
        Valley { floor_at: lowest as isize + 1 - MIDDLE as isize, floor, depths }
    }

    /// Returns the position at which a side rises above a part of its depth; the depth is limited to `most` times the
    /// darker side's.
    fn rim(&self, around: &Around, valley: &Valley, side: isize, part: f32, most: f32) -> Option<f32> {
        let [left, right] = valley.depths;
        let depth = if side > 0 { right } else { left }.min(most * left.min(right));
        let level = valley.floor + part * depth;
        let k = (valley.floor_at * side..self.reach as isize).find(|k| at(around, side * (k + 1)) >= level)?;
        let (low, rise) = (at(around, side * k), at(around, side * (k + 1)) - at(around, side * k));
        (rise > 0.0).then(|| side as f32 * (k as f32 + ((level - low) / rise).clamp(0.0, 1.0)))
    }
}

/// The floor of a mean row, its position, and the height of the metal on the left and on the right above it.
struct Valley {
    floor_at: isize,
    floor: f32,
    depths: [f32; 2],
}

/// Grey value at `t` columns to the right of the middle.
fn at(around: &Around, t: isize) -> f32 {
    around[MIDDLE.wrapping_add_signed(t)]
}

/// Returns weights that measure the part of `wanted` in a line, independent of the `others` (orthogonal to each other).
fn against(wanted: &Around, others: &[Around]) -> Around {
    let free = others.iter().fold(*wanted, |free, other| less_along(&free, other));
    let norm = dot(&free, wanted);
    free.map(|f| f / norm)
}

/// Returns `a` less its projection on `b`.
fn less_along(a: &Around, b: &Around) -> Around {
    less(a, dot(a, b) / dot(b, b), b)
}

/// Returns `a` less `part` times `b`.
fn less(a: &Around, part: f32, b: &Around) -> Around {
    Around::from_fn(|t| a[t] - part * b[t])
}

/// Dot product outside of SIMD loops, once for all rows.
fn dot(a: &Around, b: &Around) -> f32 {
    a.dot(Scalar::new(), b)
}

/// Columns about the axis are inside the strip; middles too far out are read at the limit.
const _: () = assert!(REACH < MIDDLE && MID >= MIDDLE && COLS > MID + MIDDLE);
