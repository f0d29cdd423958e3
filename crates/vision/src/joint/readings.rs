use super::make_room;
use super::profile::{Arms, Profile, REACH, Reading, Shape};
use super::strip::Strip;

/// What the rows of a strip tell of the joint about its middle, and sums over rows.
#[derive(Debug, Clone, Default)]
pub(super) struct Readings {
    rows: Vec<Reading>,
    arms: Vec<Arms>,
    /// Sums over the rows before each: depth, moment, step and its square.
    sums: Vec<[f64; 4]>,
    arms_sums: Vec<Arms>,
}

/// Means over rows.
#[derive(Debug, Clone, Copy)]
pub(super) struct About {
    /// Depth, grey values.
    pub(super) depth: f32,
    /// Depth times shift to the right, grey values times pixels.
    pub(super) moment: f32,
    /// Step of the light from left to right, grey values, and its standard error.
    pub(super) step: f32,
    pub(super) step_error: f32,
}

impl Readings {
    /// Room for so many rows.
    pub(super) fn make_room(&mut self, rows: usize) {
        make_room(&mut self.rows, rows);
        make_room(&mut self.arms, rows);
        make_room(&mut self.sums, rows + 1);
        make_room(&mut self.arms_sums, rows + 1);
    }

    /// Reads each row about its centre.
    pub(super) fn read(&mut self, profile: &Profile, strip: &Strip, centres: &[f32]) {
        self.rows.clear();
        self.arms.clear();
        self.sums.clear();
        let mut sums = [0.0; 4];
        self.sums.push(sums);
        for (row, centre) in strip.grey.iter().zip(centres) {
            let mut arms = [[0.0; REACH]; 2];
            let reading = profile.read(row, *centre, &mut arms);
            let [depth, moment, step] = [reading.depth, reading.moment, reading.step].map(f64::from);
            let new = [depth, moment, step, step * step];
            sums.iter_mut().zip(new).for_each(|(sum, new)| *sum += new);
            self.sums.push(sums);
            self.rows.push(reading);
            self.arms.push(arms);
        }
        self.sum_arms(profile.reach());
    }

    /// Sums less the light of the first row: small numbers keep more digits.
    fn sum_arms(&mut self, reach: usize) {
        let light = self.arms.first().map_or(0.0, |arms| arms[0][0]);
        let mut sum: Arms = [[0.0; REACH]; 2];
        self.arms_sums.clear();
        self.arms_sums.push(sum);
        for arms in &self.arms {
            for (sum, arm) in sum.iter_mut().zip(arms) {
                sum[..=reach].iter_mut().zip(&arm[..=reach]).for_each(|(s, a)| *s += a - light);
            }
            self.arms_sums.push(sum);
        }
    }

    pub(super) fn row(&self, i: usize) -> Reading {
        self.rows[i]
    }

    fn near(&self, i: usize, around: usize) -> (usize, usize) {
        (i.saturating_sub(around), (i + around + 1).min(self.rows.len()))
    }

    /// Means over the rows within `around` of row `i`.
    pub(super) fn about(&self, i: usize, around: usize) -> About {
        let (from, to) = self.near(i, around);
        let part = 1.0 / (to - from) as f64;
        let (before, after) = (&self.sums[from], &self.sums[to]);
        let [depth, moment, step, square]: [f64; 4] = std::array::from_fn(|k| (after[k] - before[k]) * part);
        // Neighbours are alike: of four rows one is independent.
        let step_error = ((square - step * step).max(0.0) * 4.0 * part).sqrt() as f32;
        About { depth: depth as f32, moment: moment as f32, step: step as f32, step_error }
    }

    /// The mean of the rows within `around` of row `i`, from the middle outwards; grey values from some light on.
    pub(super) fn mean(&self, i: usize, around: usize) -> Arms {
        let (from, to) = self.near(i, around);
        let part = 1.0 / (to - from) as f32;
        let (before, after) = (&self.arms_sums[from], &self.arms_sums[to]);
        let mut mean = [[0.0; REACH]; 2];
        for (mean, (after, before)) in mean.iter_mut().zip(after.iter().zip(before)) {
            for (mean, (after, before)) in mean.iter_mut().zip(after.iter().zip(before)) {
                *mean = (after - before) * part;
            }
        }
        mean
    }

    /// How far the rows within `around` of each are from the mean of those that are `seen`, light and its slope across and the
    /// depth aside: root mean squares, grey values.
    pub(super) fn rests(&self, (reach, around): (usize, usize), seen: impl Fn(usize) -> bool, rests: &mut Vec<f32>) {
        let mut mean = Shape::default();
        self.arms.iter().enumerate().filter(|(i, _)| seen(*i)).for_each(|(_, arms)| mean.add(arms, reach));
        let [a, b, c] = &mean.and_light(reach);
        rests.clear();
        rests.extend((0..self.rows.len()).map(|i| {
            let shape = Shape(self.mean(i, around));
            let [all, others @ ..] = shape.dots([&shape, a, b, c]);
            let of_others: f32 = others.iter().map(|other| other.powi(2)).sum();
            ((all - of_others).max(0.0) / (2 * reach) as f32).sqrt()
        }));
    }
}
