use super::make_room;
use super::profile::{Around, MIDDLE, Profile, Reading, Shape, about, across};
use super::strip::Strip;
use crate::simd::{Work, wide};
use pulp::Simd;

/// Measurements of the rows of a strip about the joint's middle, and sums over rows.
#[derive(Debug, Clone, Default)]
pub(super) struct Readings {
    rows: Vec<Reading>,
    /// Grey values about each middle.
    around: Vec<Around>,
    /// Sums over the rows before each: depth, moment, step and squared step.
    sums: Vec<[f64; 4]>,
    /// Sums over the rows before each of the grey values within reach of the middle.
    around_sums: Vec<Around>,
}

/// See [`Readings::read`].
struct Read<'a> {
    readings: &'a mut Readings,
    profile: &'a Profile,
    strip: &'a Strip,
    centres: &'a [f32],
}

impl Work for Read<'_> {
    #[inline(always)]
    fn run(self, simd: impl Simd) {
        let Readings { rows, around, sums: all_sums, around_sums } = self.readings;
        rows.clear();
        around.clear();
        all_sums.clear();
        let mut sums = [0.0; 4];
        all_sums.push(sums);
        for (row, centre) in self.strip.grey.iter().zip(self.centres) {
            let greys = about(row, *centre);
            let reading = self.profile.read(simd, &greys);
            let [depth, moment, step] = [reading.depth, reading.moment, reading.step].map(f64::from);
            let new = [depth, moment, step, step * step];
            sums = std::array::from_fn(|k| sums[k] + new[k]);
            all_sums.push(sums);
            rows.push(reading);
            around.push(greys);
        }
        // The first row's light is subtracted: small numbers keep more digits.
        let light = around.first().map_or(0.0, |greys| greys[MIDDLE]);
        let within = across(self.profile.reach(), |_| 1.0);
        let mut sum = Around::default();
        around_sums.clear();
        around_sums.push(sum);
        for greys in around {
            for (sum, (grey, within)) in sum.iter_mut().zip(greys.iter().zip(&within)) {
                *sum += (grey - light) * within;
            }
            around_sums.push(sum);
        }
    }
}

/// Means over rows.
#[derive(Debug, Clone, Copy)]
pub(super) struct About {
    /// Depth, grey values.
    pub(super) depth: f32,
    /// Depth times shift to the right, grey values times pixels.
    pub(super) moment: f32,
    /// Step of the light from left to right, grey values, and its squared standard error.
    pub(super) step: f32,
    pub(super) step_variance: f32,
}

/// Part of the strip about each row's middle.
#[derive(Debug, Clone, Copy)]
pub(super) struct Window {
    /// Columns to either side of the middle.
    pub(super) reach: usize,
    /// Rows before and after the row.
    pub(super) around: usize,
}

impl Readings {
    /// Reserves capacity for this many rows.
    pub(super) fn make_room(&mut self, rows: usize) {
        make_room(&mut self.rows, rows);
        make_room(&mut self.around, rows);
        make_room(&mut self.sums, rows + 1);
        make_room(&mut self.around_sums, rows + 1);
    }

    /// Measures each row about its centre.
    pub(super) fn read(&mut self, profile: &Profile, strip: &Strip, centres: &[f32]) {
        wide(Read { readings: self, profile, strip, centres });
    }

    #[inline(always)]
    pub(super) fn row(&self, i: usize) -> Reading {
        self.rows[i]
    }

    #[inline(always)]
    fn near(&self, i: usize, around: usize) -> (usize, usize) {
        (i.saturating_sub(around), (i + around + 1).min(self.rows.len()))
    }

    /// Returns means over the rows within `around` of row `i`.
    #[inline(always)]
    pub(super) fn about(&self, i: usize, around: usize) -> About {
        let (from, to) = self.near(i, around);
        let part = 1.0 / (to - from) as f64;
        let (before, after) = (&self.sums[from], &self.sums[to]);
        let [depth, moment, step, square]: [f64; 4] = std::array::from_fn(|k| (after[k] - before[k]) * part);
        // Neighbouring rows are correlated: one of four is independent.
        let step_variance = ((square - step * step).max(0.0) * 4.0 * part) as f32;
        About { depth: depth as f32, moment: moment as f32, step: step as f32, step_variance }
    }

    /// Returns the mean of the rows within `around` of row `i`, grey values up to a common offset.
    #[inline(always)]
    pub(super) fn mean(&self, i: usize, around: usize) -> Around {
        let (from, to) = self.near(i, around);
        let part = 1.0 / (to - from) as f32;
        let (before, after) = (&self.around_sums[from], &self.around_sums[to]);
        Around::from_fn(|t| (after[t] - before[t]) * part)
    }

    /// Computes the RMS difference of the rows about each from the mean of the `seen` rows, grey values. Light, its
    /// slope across and the depth are factored out.
    #[inline(always)]
    pub(super) fn rests<S: Simd>(&self, simd: S, window: Window, seen: impl Fn(usize) -> bool, rests: &mut Vec<f32>) {
        let Window { reach, around } = window;
        let mut mean = Shape::default();
        self.around.iter().enumerate().filter(|(i, _)| seen(*i)).for_each(|(_, greys)| mean.add(greys, reach));
        let [a, b, c] = mean.and_light(reach);
        rests.clear();
        rests.extend((0..self.rows.len()).map(|i| {
            let shape = Shape(self.mean(i, around));
            let of_others: f32 = [&a, &b, &c].iter().map(|other| shape.dot(simd, other).powi(2)).sum();
            ((shape.dot(simd, &shape) - of_others).max(0.0) / (2 * reach + 1) as f32).sqrt()
        }));
    }
}
