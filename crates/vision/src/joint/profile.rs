use super::strip::{COLS, Line};

/// Columns to one side of the middle at most.
pub(super) const REACH: usize = 13;

/// A bell across the joint, and what of a profile moves with it.
#[derive(Debug, Clone)]
pub(super) struct Profile {
    /// Columns looked at on either side of the middle.
    reach: usize,
    /// Weights of the even part (from the middle outwards) that give the depth.
    depth: [f32; REACH],
    /// Weights of the odd part that give depth times shift where light changes evenly across the joint, ...
    even_light: [f32; REACH],
    /// ... and where it steps at the joint.
    stepped_light: [f32; REACH],
    /// Weights of the odd part that give the step.
    step: [f32; REACH],
}

/// What one row tells of the joint near a place.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Reading {
    /// Depth, grey values.
    pub(super) depth: f32,
    /// Depth times shift to the right, grey values times pixels.
    pub(super) moment: f32,
    /// The same if light steps at the joint.
    pub(super) stepped_moment: f32,
    /// Half of the step, grey values.
    pub(super) step: f32,
}

impl Profile {
    /// For a joint of this full width at half depth, columns.
    pub(super) fn new(width: f32) -> Self {
        let reach = ((1.2 * width + 2.0).ceil() as usize).clamp(3, REACH - 1);
        let spread = width / 2.355;
        let bell = |t: usize| (-0.5 * (t as f32 / spread).powi(2)).exp();
        let mut slope = [0.0; REACH];
        let (mut ramp, mut one, mut even) = ([0.0; REACH], [0.0; REACH], [0.0; REACH]);
        for t in 0..=reach {
            slope[t] = -(t as f32) / (spread * spread) * bell(t);
            ramp[t] = t as f32;
            one[t] = f32::from(u8::from(t > 0));
            even[t] = bell(t);
        }
        // The middle is there once, all else twice.
        let mut depth = [0.0; REACH];
        let mean = (2.0 * even.iter().sum::<f32>() - even[0]) / (2 * reach + 1) as f32;
        for t in 0..=reach {
            depth[t] = -(even[t] - mean) * if t == 0 { 1.0 } else { 2.0 };
        }
        let norm = -depth.iter().zip(&even).map(|(d, e)| d * e).sum::<f32>();
        depth.iter_mut().for_each(|d| *d /= norm);
        let even_light = against(&slope, &[ramp]);
        let stepped_light = against(&slope, &[ramp, less(&one, &ramp)]);
        let step = against(&one, &[ramp, less(&slope, &ramp)]);
        Self { reach, depth, even_light, stepped_light, step }
    }

    /// What `row` tells about column `centre` (fractions too), and its even part from the middle outwards.
    pub(super) fn read(&self, row: &Line, centre: f32, even: &mut [f32; REACH]) -> Reading {
        let centre = centre.clamp((REACH + 1) as f32, (COLS - REACH - 3) as f32);
        let (low, part) = (centre as usize, centre.fract());
        let at = |j: usize| row[j] * (1.0 - part) + row[j + 1] * part;
        let mut reading = Reading::default();
        for t in 0..=self.reach {
            let (right, left) = (at(low + t), at(low - t));
            even[t] = 0.5 * (right + left);
            let odd = 0.5 * (right - left);
            reading.depth += self.depth[t] * even[t];
            reading.moment += self.even_light[t] * odd;
            reading.stepped_moment += self.stepped_light[t] * odd;
            reading.step += self.step[t] * odd;
        }
        reading
    }

    /// Full width at half depth of a mean even part, columns; none if it has no clear rim.
    pub(super) fn width(&self, even: &[f32; REACH]) -> Option<f32> {
        let outer = self.reach - 1;
        let base = even[outer..=self.reach].iter().sum::<f32>() / 2.0;
        let floor = even[0].min(0.5 * (even[0] + even[1]));
        let half = 0.5 * (base + floor);
        let k = (0..outer).find(|k| even[k + 1] >= half)?;
        let rise = even[k + 1] - even[k];
        (rise > 0.0 && base > floor).then(|| 2.0 * (k as f32 + ((half - even[k]) / rise).clamp(0.0, 1.0)))
    }
}

/// Weights that give how much of `wanted` is in a line, whatever there is of the others (orthogonal to each other).
fn against(wanted: &[f32; REACH], others: &[[f32; REACH]]) -> [f32; REACH] {
    let free = others.iter().fold(*wanted, |free, other| less(&free, other));
    let norm = dot(&free, wanted);
    free.map(|f| f / norm)
}

/// `a` less its part along `b`.
fn less(a: &[f32; REACH], b: &[f32; REACH]) -> [f32; REACH] {
    let part = dot(a, b) / dot(b, b);
    std::array::from_fn(|t| a[t] - part * b[t])
}

fn dot(a: &[f32; REACH], b: &[f32; REACH]) -> f32 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
