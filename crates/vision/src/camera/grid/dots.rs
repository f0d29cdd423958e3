//! Detection of dark dots in a picture.

use super::identified::GridError;
use crate::frame::{Frame, Pixels, Size};
use glam::DVec2;

/// Minimum relative darkness of the darkest dots against their surroundings; below it the picture counts as plain.
const MIN_CONTRAST: f64 = 0.05;
/// Accepted area of a dot relative to the median.
const AREAS: std::ops::RangeInclusive<f64> = 0.3..=3.0;
/// Minimum pixels of a dot.
const FEWEST_PIXELS: usize = 6;

/// Finds the centres of dark dots, pixels.
pub(super) fn find(frame: &Frame) -> Result<Vec<DVec2>, GridError> {
    let darkness = darkness(&values(frame), frame.size());
    let mut sorted: Vec<f32> = darkness.iter().step_by(3).copied().collect();
    sorted.sort_unstable_by(f32::total_cmp);
    let dark = f64::from(sorted[(sorted.len() - 1) * 99 / 100]);
    if dark < MIN_CONTRAST {
        return Err(GridError::Plain(100.0 * dark.max(0.0)));
    }
    let spots = spots(&darkness, frame.size(), (0.5 * dark) as f32);
    let mut areas: Vec<usize> = spots.iter().map(|s| s.area).collect();
    areas.sort_unstable();
    let Some(&median) = areas.get(areas.len() / 2) else { return Err(GridError::Few { found: 0 }) };
    let usual = |s: &&Spot| !s.cut && AREAS.contains(&(s.area as f64 / median as f64));
    Ok(spots.iter().filter(usual).map(|s| s.centre).collect())
}

fn values(frame: &Frame) -> Vec<f32> {
    match frame.pixels() {
        Pixels::U8(p) => p.iter().map(|v| f32::from(*v)).collect(),
        Pixels::U16(p) => p.iter().map(|v| f32::from(*v)).collect(),
    }
}

/// Relative darkness of each pixel against the mean of a box about it, slightly smoothed against noise.
fn darkness(values: &[f32], size: Size) -> Vec<f32> {
    let near = boxed(values, size, 1);
    let about = boxed(values, size, (size.width.max(size.height) / 10).max(4));
    near.iter().zip(&about).map(|(v, mean)| if *mean > 0.0 { 1.0 - v / mean } else { 0.0 }).collect()
}

/// Means over boxes of `reach` to each side, cut off at the frame's border.
fn boxed(values: &[f32], size: Size, reach: usize) -> Vec<f32> {
    let Size { width, height } = size;
    let mut sums = vec![0.0f64; (width + 1) * (height + 1)];
    for y in 0..height {
        let mut row = 0.0;
        for x in 0..width {
            row += f64::from(values[y * width + x]);
            sums[(y + 1) * (width + 1) + x + 1] = sums[y * (width + 1) + x + 1] + row;
        }
    }
    let at = |x: usize, y: usize| sums[y * (width + 1) + x];
    let mut out = Vec::with_capacity(values.len());
    for y in 0..height {
        let (top, bottom) = (y.saturating_sub(reach), (y + reach + 1).min(height));
        for x in 0..width {
            let (left, right) = (x.saturating_sub(reach), (x + reach + 1).min(width));
            let sum = at(right, bottom) - at(left, bottom) - at(right, top) + at(left, top);
            out.push((sum / ((right - left) * (bottom - top)) as f64) as f32);
        }
    }
    out
}

/// Connected pixels that are darker than the threshold.
struct Spot {
    centre: DVec2,
    area: usize,
    /// Touches the frame's border.
    cut: bool,
}

fn spots(darkness: &[f32], size: Size, threshold: f32) -> Vec<Spot> {
    let Size { width, height } = size;
    let mut seen = vec![false; darkness.len()];
    let mut stack = Vec::new();
    let mut spots = Vec::new();
    for start in 0..darkness.len() {
        if seen[start] || darkness[start] < threshold {
            continue;
        }
        seen[start] = true;
        stack.push(start);
        let (mut sum, mut weight, mut area, mut cut) = (DVec2::ZERO, 0.0, 0, false);
        while let Some(i) = stack.pop() {
            let (x, y) = (i % width, i / width);
            area += 1;
            cut |= x == 0 || y == 0 || x + 1 == width || y + 1 == height;
            // Weights start below the threshold, so that pixels at the edge count in proportion to the dot's share of
            // them.
            let w = f64::from(darkness[i] - 0.5 * threshold).max(0.0);
            sum += w * DVec2::new(x as f64, y as f64);
            weight += w;
            for (dx, dy) in [(0, 1), (1, 0), (2, 1), (1, 2)] {
                let (nx, ny) = ((x + dx).wrapping_sub(1), (y + dy).wrapping_sub(1));
                if nx < width && ny < height && !seen[ny * width + nx] && darkness[ny * width + nx] >= threshold {
                    seen[ny * width + nx] = true;
                    stack.push(ny * width + nx);
                }
            }
        }
        if area >= FEWEST_PIXELS && weight > 0.0 {
            spots.push(Spot { centre: sum / weight, area, cut });
        }
    }
    spots
}
