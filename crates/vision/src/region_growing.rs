//! Joint detection by region growing as in EBW-2004, for comparison with [`crate::joint`].
//!
//! From a point on the joint, groups of pixels in several directions about the heading are compared. The group whose
//! mean brightness is nearest to the joint's gives the direction. Its first pixel joins the region if it is homogeneous
//! with it. The region then grows across the heading; its middle is the midline.

use crate::frame::{Frame, Pixels};

/// Pixels per group.
const GROUP: usize = 10;
/// Directions to either side of the heading, and the angle from one to the next, rad.
const DIRECTIONS: i32 = 4;
const TURN: f32 = 0.2;
/// Maximum growth of the region to either side, pixels.
const ACROSS: usize = 60;
/// The heading is measured over this many points.
const MEMORY: usize = 12;
/// Half the side of the square about the start in which joint and metal are measured, pixels.
const AROUND: i32 = 12;
/// Maximum difference of a pixel from the region, as a part of the difference between metal and joint.
const HOMOGENEOUS: f32 = 0.5;
/// Weight of each new pixel in the region's brightness.
const SHARE: f32 = 0.05;

/// Reason why growing stopped.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum GrowthEnd {
    /// The region reached the frame's border.
    LeftImage,
    /// No pixel ahead is like the region.
    Inhomogeneous,
    /// The region is longer than twice the frame's sides together, so it goes round.
    TooLong,
}

/// Result of [`grow`].
#[derive(Debug, Clone, PartialEq)]
pub struct Growth {
    /// Midline, pixels, points about one pixel apart.
    pub midline: Vec<[f32; 2]>,
    /// Reason why growing stopped.
    pub end: GrowthEnd,
}

/// Grows a region of a dark joint from the point `start` (pixels) in the rough `direction` (rad, from x to y). The
/// darkest pixels near the start count as the joint's. A start outside the frame, or not finite, gives an empty midline
/// and [`GrowthEnd::LeftImage`]; a uniform frame gives an empty midline and [`GrowthEnd::Inhomogeneous`].
#[must_use]
pub fn grow(frame: &Frame, start: [f32; 2], direction: f32) -> Growth {
    let none = |end| Growth { midline: Vec::new(), end };
    let Some(_) = grey(frame, start).filter(|_| direction.is_finite()) else { return none(GrowthEnd::LeftImage) };
    let Some((mut brightness, allowed)) = joint_and_tolerance(frame, start) else {
        return none(GrowthEnd::Inhomogeneous);
    };
    let longest = 2 * (frame.width() + frame.height());
    let (mut at, mut heading) = (start, direction);
    let mut midline: Vec<[f32; 2]> = Vec::new();
    while midline.len() < longest {
        let Some(turn) = way(frame, at, heading, brightness) else {
            return Growth { midline, end: GrowthEnd::LeftImage };
        };
        let next = ahead(at, heading + turn, 1.0);
        let Some(found) = grey(frame, next) else { return Growth { midline, end: GrowthEnd::LeftImage } };
        if (found - brightness).abs() > allowed {
            return Growth { midline, end: GrowthEnd::Inhomogeneous };
        }
        brightness += SHARE * (found - brightness);
        at = middle(frame, next, heading, brightness, allowed);
        midline.push(at);
        if let Some(before) = midline.len().checked_sub(MEMORY).map(|i| midline[i]) {
            heading = (at[1] - before[1]).atan2(at[0] - before[0]);
        }
    }
    Growth { midline, end: GrowthEnd::TooLong }
}

/// Returns the turn from the heading to the group nearest to the joint's brightness, rad; `None` if the heading leaves
/// the frame.
fn way(frame: &Frame, at: [f32; 2], heading: f32, brightness: f32) -> Option<f32> {
    // At the border the region must not turn aside and run along it.
    grey(frame, ahead(at, heading, 1.0))?;
    let mut best: Option<(f32, f32)> = None;
    // Order from the heading outwards, so that the straightest of equal groups wins.
    for k in (0..=DIRECTIONS).flat_map(|k| [k, -k]) {
        let turn = k as f32 * TURN;
        let group = (1..=GROUP).map_while(|i| grey(frame, ahead(at, heading + turn, i as f32)));
        let (count, sum) = group.fold((0usize, 0.0), |(count, sum), g| (count + 1, sum + g));
        if count == 0 {
            continue;
        }
        let off = (sum / count as f32 - brightness).abs();
        if best.is_none_or(|(least, _)| off < least) {
            best = Some((off, turn));
        }
    }
    best.map(|(_, turn)| turn)
}

/// Returns the middle of the pixels across the heading that are like the region.
fn middle(frame: &Frame, at: [f32; 2], heading: f32, brightness: f32, allowed: f32) -> [f32; 2] {
    let alike = |p: [f32; 2]| grey(frame, p).is_some_and(|g| (g - brightness).abs() <= allowed);
    let side = |angle: f32| (1..=ACROSS).take_while(|i| alike(ahead(at, heading + angle, *i as f32))).count() as f32;
    let quarter = std::f32::consts::FRAC_PI_2;
    ahead(at, heading + quarter, 0.5 * (side(quarter) - side(-quarter)))
}

fn ahead([x, y]: [f32; 2], angle: f32, by: f32) -> [f32; 2] {
    [x + by * angle.cos(), y + by * angle.sin()]
}

/// Returns the joint's brightness near the start (mean of the darkest tenth) and the tolerance of its pixels; `None`
/// for a uniform neighbourhood.
fn joint_and_tolerance(frame: &Frame, [x, y]: [f32; 2]) -> Option<(f32, f32)> {
    let near = -AROUND..=AROUND;
    let mut greys: Vec<f32> = near
        .clone()
        .flat_map(|i| near.clone().map(move |j| [x + i as f32, y + j as f32]))
        .filter_map(|p| grey(frame, p))
        .collect();
    greys.sort_by(f32::total_cmp);
    let darkest = &greys[..greys.len().div_ceil(10)];
    let joint = darkest.iter().sum::<f32>() / darkest.len().max(1) as f32;
    let metal = *greys.get(3 * greys.len() / 4)?;
    (metal - joint >= 1.0).then_some((joint, HOMOGENEOUS * (metal - joint)))
}

/// Grey value of the nearest pixel, 0 to 255; `None` outside the frame.
fn grey(frame: &Frame, [x, y]: [f32; 2]) -> Option<f32> {
    let (x, y) = (x.round(), y.round());
    // The negated comparison also rejects NaN.
    if !(x >= 0.0 && y >= 0.0 && x < frame.width() as f32 && y < frame.height() as f32) {
        return None;
    }
    let i = y as usize * frame.width() + x as usize;
    match frame.pixels() {
        Pixels::U8(pixels) => pixels.get(i).map(|p| f32::from(*p)),
        Pixels::U16(pixels) => pixels.get(i).map(|p| f32::from(*p) / 257.0),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use seamwright_testkit::Random;

    const SIZE: usize = 200;

    /// Metal of 160 with uniform noise of up to `noise`, and a joint 60 darker and 7 pixels wide. `joint` gives a
    /// point's distance from its midline.
    fn scene(noise: f32, joint: impl Fn(f32, f32) -> f32) -> Vec<u8> {
        let mut random = Random::new(7);
        let mut pixels = Vec::new();
        for y in 0..SIZE {
            for x in 0..SIZE {
                let even = random.within(-1.0, 1.0) as f32;
                let dark = if joint(x as f32, y as f32).abs() <= 3.5 { 60.0 } else { 0.0 };
                pixels.push((160.0 - dark + noise * even) as u8);
            }
        }
        pixels
    }

    fn grown(pixels: &[u8], start: [f32; 2], direction: f32) -> Growth {
        grow(&Frame::new(SIZE, SIZE, Pixels::U8(pixels)).unwrap(), start, direction)
    }

    fn slanted(x: f32, y: f32) -> f32 {
        (y - 60.0 - 0.3 * x) / (1.0f32 + 0.09).sqrt()
    }

    #[test]
    fn a_clean_line_to_the_rim() {
        let growth = grown(&scene(0.0, slanted), [5.0, 62.0], 0.1);
        assert_eq!(growth.end, GrowthEnd::LeftImage);
        assert!(growth.midline.last().unwrap()[0] > 195.0);
        // Within half a joint's width of the border the region is cut on one side.
        let clear = growth.midline.iter().filter(|p| p[0] < 195.0);
        let worst = clear.map(|p| slanted(p[0], p[1]).abs()).fold(0.0, f32::max);
        assert!(worst <= 1.0, "{worst}");
    }

    #[test]
    fn an_arc() {
        let arc = |x: f32, y: f32| (x - 20.0).hypot(y - 100.0) - 80.0;
        let growth = grown(&scene(5.0, arc), [20.0, 20.0], 0.0);
        let half = growth.midline.iter().filter(|p| p[0] > 20.0);
        let worst = half.map(|p| arc(p[0], p[1]).abs()).fold(0.0, f32::max);
        assert!(worst <= 2.0 && growth.midline.len() > 200, "{worst} {}", growth.midline.len());
    }

    /// The limit that [`crate::joint`] overcomes: the region does not cross a tack.
    #[test]
    fn it_ends_at_a_tack_and_where_the_joint_ends() {
        let tacked = |x: f32, y: f32| if (80.0..110.0).contains(&x) { 99.0 } else { slanted(x, y) };
        let growth = grown(&scene(3.0, tacked), [5.0, 62.0], 0.1);
        assert_eq!(growth.end, GrowthEnd::Inhomogeneous);
        assert!((growth.midline.last().unwrap()[0] - 80.0).abs() < 6.0);
    }

    #[test]
    fn nothing_in_an_even_frame_nor_outside_of_it() {
        let even = vec![128; SIZE * SIZE];
        assert_eq!(grown(&even, [50.0, 50.0], 0.0), Growth { midline: vec![], end: GrowthEnd::Inhomogeneous });
        for start in [[-1.0, 5.0], [f32::NAN, 5.0], [5.0, 200.0]] {
            assert_eq!(grown(&even, start, 0.0), Growth { midline: vec![], end: GrowthEnd::LeftImage });
        }
        assert_eq!(grown(&even, [5.0, 5.0], f32::INFINITY).midline, Vec::<[f32; 2]>::new());
    }
}
