use super::strip::{COLS, HALF, ROWS, Strip};

/// Rows before and after that the line through a row's centre is fitted to.
const LINE: usize = 8;

/// The middle of the joint in each row, columns from the axis: centroid of what is darker than a straight baseline,
/// then a straight line through the centres near by. And its standard error, columns, from their scatter.
pub(super) fn midline(
    strip: &Strip,
    path: &[usize; ROWS],
    supported: &[bool; ROWS],
    width: f32,
) -> ([f32; ROWS], [f32; ROWS]) {
    let mut centre = [0.0; ROWS];
    for (i, centre) in centre.iter_mut().enumerate() {
        *centre = centroid(&strip.grey, i, path[i] as f32, width) - HALF as f32;
    }
    let (mut smooth, mut error) = (centre, [f32::INFINITY; ROWS]);
    for (i, (value, error)) in smooth.iter_mut().zip(&mut error).enumerate() {
        let near = (i.saturating_sub(LINE)..(i + LINE + 1).min(ROWS)).filter(|k| supported[*k]);
        let places = near.map(|k| {
            let v = k as f32 - i as f32;
            let u = v / (LINE + 1) as f32;
            (v, centre[k], 1.0 - u * u)
        });
        let Some((at, slope)) = line(places.clone()) else { continue };
        let [mut sum, mut squares, mut weights] = [0.0f32; 3];
        places.for_each(|(v, y, w)| {
            sum += w * (y - at - slope * v).powi(2);
            squares += w * w;
            weights += w;
        });
        // Centres are of three rows each: a third of them are independent.
        (*value, *error) = (at, (sum / weights * 3.0 * squares).sqrt() / weights);
    }
    (smooth, error)
}

/// What of the profile about `middle` in rows near `i` is neither even nor a ramp, grey values: a shadow's rim or another
/// joint beside this one.
pub(super) fn odd(strip: &Strip, middle: &[f32; ROWS], i: usize, width: f32) -> f32 {
    const MOST: usize = 12;
    let reach = ((1.3 * width + 2.0) as usize).clamp(3, MOST);
    let mut odd = [0.0f32; MOST + 1];
    let rows = [i.saturating_sub(6), i, (i + 6).min(ROWS - 1)];
    for k in rows {
        let group = &strip.group[k];
        let at = |place: f32| {
            let place = place.clamp(0.0, (COLS - 2) as f32);
            let (low, part) = (place as usize, place.fract());
            group[low] * (1.0 - part) + group[low + 1] * part
        };
        let centre = middle[k] + HALF as f32;
        for (u, odd) in odd[..=reach].iter_mut().enumerate() {
            *odd += (at(centre + u as f32) - at(centre - u as f32)) / 6.0;
        }
    }
    let odd = &odd[1..=reach];
    let (product, norm) = odd.iter().enumerate().fold((0.0f32, 0.0f32), |(p, n), (k, o)| {
        let u = (k + 1) as f32;
        (p + u * o, n + u * u)
    });
    let slope = product / norm;
    let sum: f32 = odd.iter().enumerate().map(|(k, o)| (o - slope * (k + 1) as f32).powi(2)).sum();
    (sum / reach as f32).sqrt()
}

/// Value at 0 and slope of the weighted line through places (x, y, weight).
pub(super) fn line(places: impl Iterator<Item = (f32, f32, f32)>) -> Option<(f32, f32)> {
    let [mut w, mut x, mut y, mut xx, mut xy] = [0.0f32; 5];
    for (px, py, weight) in places {
        w += weight;
        x += weight * px;
        y += weight * py;
        xx += weight * px * px;
        xy += weight * px * py;
    }
    let spread = w * xx - x * x;
    (spread > 1e-3 * w * w).then(|| ((xx * y - x * xy) / spread, (w * xy - x * y) / spread))
}

/// Centroid of the three rows about `i` near column `at`, by a window that falls off and moves to it.
fn centroid(grey: &[[f32; COLS]], i: usize, at: f32, width: f32) -> f32 {
    let rows = &grey[i.saturating_sub(1)..(i + 2).min(ROWS)];
    let (window, side) = (0.9 * width + 1.0, (1.2 * width + 1.5).ceil() as usize);
    let mut centre = at;
    for _ in 0..3 {
        let middle = (centre.round() as usize).clamp(side + 2, COLS - 3 - side);
        let mean = |j: usize| rows.iter().map(|row| row[j - 1] + row[j] + row[j + 1]).sum::<f32>() / 3.0;
        let (left, right) = (mean(middle - side), mean(middle + side));
        let (mut mass, mut moment, mut all) = (0.0, 0.0, 0.0);
        for j in middle - side..=middle + side {
            let u = (j as f32 - centre) / window;
            let weight = (1.0 - u * u).max(0.0);
            let along = (j + side - middle) as f32 / (2 * side) as f32;
            let dark = left + along * (right - left) - rows.iter().map(|row| row[j]).sum::<f32>();
            mass += weight * dark;
            moment += weight * dark * (j as f32 - centre);
            all += weight * dark.abs();
        }
        if mass <= 0.3 * all {
            break;
        }
        centre = (centre + 1.5 * moment / mass).clamp(at - 0.7 * width - 1.0, at + 0.7 * width + 1.0);
    }
    centre
}

/// Full width at half depth, columns, of the mean profile about the midline of supported rows; none if it has no clear
/// rims.
pub(super) fn full_width(strip: &Strip, middle: &[f32; ROWS], supported: &[bool; ROWS], width: f32) -> Option<f32> {
    const REACH: usize = 12;
    let mut profile = [0.0f32; 2 * REACH + 1];
    let mut count = 0;
    for i in (0..ROWS).filter(|i| supported[*i]) {
        let first = middle[i] + (HALF - REACH) as f32;
        if first < 0.0 || first as usize + 2 * REACH + 1 >= COLS {
            continue;
        }
        let (low, part) = (first as usize, first.fract());
        for (k, value) in profile.iter_mut().enumerate() {
            *value += strip.grey[i][low + k] * (1.0 - part) + strip.grey[i][low + k + 1] * part;
        }
        count += 1;
    }
    if count < 8 {
        return None;
    }
    let side = ((1.3 * width + 1.5).round() as usize).min(REACH - 1);
    let base = |k: usize| (profile[k - 1] + profile[k] + profile[k + 1]) / 3.0;
    let (left, right) = (base(REACH - side), base(REACH + side));
    let floor = (profile[REACH - 1].min(profile[REACH + 1])).min(profile[REACH]);
    let rim = |base: f32, sign: isize| {
        let half = 0.5 * (base + floor);
        let at = |k: usize| profile[REACH.saturating_add_signed(sign * k as isize)];
        let k = (0..REACH).find(|k| at(k + 1) >= half)?;
        let rise = at(k + 1) - at(k);
        (rise > 0.0).then(|| k as f32 + ((half - at(k)) / rise).clamp(0.0, 1.0))
    };
    if left.min(right) <= floor {
        return None;
    }
    Some(rim(left, -1)? + rim(right, 1)?)
}
