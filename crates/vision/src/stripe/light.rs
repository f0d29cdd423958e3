//! Light of the image along a course: a line or an arc on which the stripe is assumed.
//!
//! The chain has one point per column, and reflections and spatter shift or replace it. Light adds up instead: pixels
//! on the stripe's course are bright regardless of other light in the column, and dark beyond its end.

use super::blobs::Blobs;
use super::fit::{StripeArc, StripeLine};
use super::profile::{Columns, Profile};
use crate::frame::{Frame, Pixels};
use glam::DVec2;
use seamwright_geometry::Homography;

/// Half the rows of a strip as a part of the stripe's usual width: 1.25 standard deviations.
const HALF: f64 = 0.35;

/// Light of a column with another object on the course, so that the stripe may be there or not.
pub(super) const SOMETHING_ELSE: f64 = f64::INFINITY;

/// Minimum light of another object off the course's centre, as a part of the stripe's usual strength.
const BRIGHT: f64 = 0.15;

/// Maximum difference of the light on both sides of the course, as a part of their sum.
const ONE_SIDED: f64 = 0.5;

/// Assumed path of the stripe.
#[derive(Debug, Clone, Copy)]
pub(super) enum Course {
    Line(StripeLine),
    /// The lower half of a circle.
    Arc(StripeArc),
}

impl Course {
    /// Returns the signed distance of a point.
    pub(super) fn off(&self, p: DVec2) -> f64 {
        match self {
            Self::Line(line) => line.off(p),
            Self::Arc(arc) => -arc.off(p),
        }
    }

    /// Returns the point at `y`; `None` beside an arc.
    pub(super) fn at(&self, y: f64) -> Option<DVec2> {
        let z = match self {
            Self::Line(line) => line.at.y + (y - line.at.x) * line.along.y / line.along.x.max(1e-6),
            Self::Arc(arc) => arc.centre.y - (arc.radius.powi(2) - (y - arc.centre.x).powi(2)).sqrt(),
        };
        z.is_finite().then_some(DVec2::new(y, z))
    }
}

/// Usual width and strength of the stripe in an image.
#[derive(Debug, Clone, Copy)]
pub(super) struct UsualStripe {
    /// Rows from border to border.
    pub(super) width: f64,
    /// Sum of the grey values above the background, down a column.
    pub(super) strength: f64,
}

/// Grey values of the pixels in a column.
#[derive(Debug, Clone, Copy)]
struct GreyScale {
    /// Background, grey values.
    background: f64,
    /// Pixel value of one grey value.
    unit: f64,
}

/// An image with the parameters of its light.
pub(super) struct Light<'a> {
    frame: &'a Frame<'a>,
    blobs: &'a Blobs,
    to_px: Option<Homography>,
    /// Half the height of a strip, rows.
    half: f64,
    /// Minimum light above the background's noise.
    bright: f64,
}

impl<'a> Light<'a> {
    /// Creates it for an image.
    pub(super) fn new(frame: &'a Frame<'a>, blobs: &'a Blobs, to_mm: Option<&Homography>, usual: UsualStripe) -> Self {
        let to_px = to_mm.map(Homography::inverse);
        Self { frame, blobs, to_px, half: (HALF * usual.width).max(1.0), bright: BRIGHT * usual.strength }
    }

    /// Measures the light on `course` in the profile's columns, in their order. The unit is grey values above the
    /// background, summed over a strip of rows. The light is NaN where the course leaves the image, and
    /// [`SOMETHING_ELSE`] where another object is seen.
    pub(super) fn along(&self, profile: &Profile, course: &Course, columns: Columns, strip: &mut Vec<f64>) {
        let Columns { from, to } = columns;
        strip.clear();
        let step = if to >= from { 1 } else { -1 };
        let columns = (0..=(to - from).abs()).map(|i| f64::from(from + step * i));
        if let Course::Line(line) = course {
            // The line is straight in the image too.
            let [Some(a), Some(b)] = [line.at - line.along, line.at + line.along].map(|p| self.px(p)) else { return };
            let slope = (b.y - a.y) / (b.x - a.x);
            strip.extend(columns.map(|c| profile.image_column(c)).map(|x| self.strip(x, a.y + (x - a.x) * slope)));
            return;
        }
        let mut y = profile.y_at(f64::from(from));
        for column in columns {
            let place = self.place(profile, course, column, y);
            strip.push(place.map_or(f64::NAN, |(_, row)| self.strip(profile.image_column(column), row)));
            y = place.map_or(y, |(p, _)| p.x) + f64::from(step) * profile.pitch;
        }
    }

    fn px(&self, p: DVec2) -> Option<DVec2> {
        match &self.to_px {
            Some(map) => map.map(p),
            None => Some(DVec2::new(p.x, -p.y)),
        }
    }

    /// Finds the point of `course` in a column of the profile, from `y` on, and its row.
    pub(super) fn place(&self, profile: &Profile, course: &Course, column: f64, y: f64) -> Option<(DVec2, f64)> {
        let (column, along) = (profile.image_column(column), profile.pitch * profile.direction);
        let mut at = course.at(y)?;
        // Columns are nearly uniform along y.
        for _ in 0..2 {
            at = course.at(at.x + (column - self.px(at)?.x) * along)?;
        }
        Some((at, self.px(at)?.y))
    }

    /// Returns the light of a column within `half` rows of `row`, if it is centred on it.
    fn strip(&self, column: f64, row: f64) -> f64 {
        let (width, height) = (self.frame.width(), self.frame.height());
        let inside = (0.0..=height as f64 - 1.0).contains(&row) && (-0.5..width as f64 - 0.5).contains(&column);
        if !inside {
            return f64::NAN;
        }
        // The range check above guarantees at least -0.5.
        let column = (column + 0.5) as usize;
        let background = self.blobs.background_at(column, row as usize);
        let scale = |unit| GreyScale { background, unit };
        match self.frame.pixels() {
            Pixels::U8(pixels) => self.centred(row, scale(1.0), |r| u32::from(pixels[r * width + column])),
            Pixels::U16(pixels) => self.centred(row, scale(257.0), |r| u32::from(pixels[r * width + column])),
        }
    }

    /// Returns the light about `row` in a column above the background.
    fn centred(&self, row: f64, scale: GreyScale, pixel: impl Fn(usize) -> u32) -> f64 {
        // The strip, and as much again above and below it.
        let first = (row - 2.0 * self.half).ceil().max(0.0) as usize;
        let last = ((row + 2.0 * self.half) as usize).min(self.frame.height() - 1);
        // Upper border, middle and lower border of the strip, their pixels, and the sums up to these.
        let edges = [row - self.half, row, row + self.half].map(|edge| edge + 0.5);
        let within = edges.map(|edge| (edge.max(0.0) as usize).clamp(first, last));
        let (mut all, mut before) = (0, [0; 3]);
        for r in first..=last {
            all += pixel(r);
            for (sum, edge) in before.iter_mut().zip(within) {
                *sum = if r < edge { all } else { *sum };
            }
        }
        let light = |sum: f64, rows: f64| sum / scale.unit - scale.background * rows;
        let [upper, middle, lower] = [0, 1, 2].map(|i| {
            let part = (edges[i] - within[i] as f64).clamp(0.0, 1.0);
            light(f64::from(before[i]) + part * f64::from(pixel(within[i])), (within[i] - first) as f64 + part)
        });
        let (above, all) = (middle, light(f64::from(all), (last + 1 - first) as f64));
        let (light, below) = (lower - upper, all - middle);
        if light > self.bright && (above - below).abs() > ONE_SIDED * (above + below) {
            return SOMETHING_ELSE;
        }
        light
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use seamwright_testkit::Random;

    const SIZE: (usize, usize) = (64, 200);
    const HEIGHT: f64 = 120.0;
    const SIGMA: f64 = 2.5;
    const SLOPE: f64 = 0.3;

    fn row(column: f64) -> f64 {
        80.0 + SLOPE * (column - 20.0)
    }

    /// A stripe along a straight line on a dark background, 16 bits.
    fn image() -> Vec<u16> {
        let grey = |i: usize| {
            let (column, at) = ((i % SIZE.0) as f64, (i / SIZE.0) as f64);
            HEIGHT * (-(at - row(column)).powi(2) / (2.0 * SIGMA * SIGMA)).exp()
        };
        (0..SIZE.0 * SIZE.1).map(|i| (257.0 * grey(i)).round() as u16).collect()
    }

    /// Integral of the bell from `a` to `b` by Simpson's rule.
    fn integral(a: f64, b: f64) -> f64 {
        let bell = |t: f64| (-t * t / (2.0 * SIGMA * SIGMA)).exp();
        let n = 200;
        let h = (b - a) / f64::from(n);
        let sum: f64 = (0..=n)
            .map(|k| bell(a + h * f64::from(k)) * if k == 0 || k == n { 1.0 } else { f64::from(2 + 2 * (k % 2)) })
            .sum();
        HEIGHT * sum * h / 3.0
    }

    #[test]
    fn light_on_a_course_is_the_stripes_integral_over_the_strip() {
        let pixels = image();
        let frame = Frame::new(SIZE.0, SIZE.1, Pixels::U16(&pixels)).unwrap();
        let mut blobs = Blobs::default();
        assert!(blobs.find(&frame));
        let mut profile = Profile::default();
        (profile.pitch, profile.direction) = (1.0, 1.0);
        for width in [6.0, 10.0, 20.0] {
            let light = Light::new(&frame, &blobs, None, UsualStripe { width, strength: HEIGHT });
            let half = HALF * width;
            let mut strip = Vec::new();
            let columns = Columns { from: 5, to: 60 };
            // y is the column, z the row upwards.
            let course = |below: f64| {
                let along = DVec2::new(1.0, -SLOPE).normalize();
                Course::Line(StripeLine { at: DVec2::new(20.0, -row(20.0) - below), along })
            };
            light.along(&profile, &course(0.0), columns, &mut strip);
            assert_eq!(strip.len(), 56);
            for (i, found) in strip.iter().enumerate() {
                let wanted = integral(-half, half);
                assert!((found - wanted).abs() < 0.03 * wanted, "{width}, {i}: {found} {wanted}");
            }
            // The reverse direction gives the same light in reverse order.
            let forwards = strip.clone();
            light.along(&profile, &course(0.0), Columns { from: 60, to: 5 }, &mut strip);
            assert!(strip.iter().eq(forwards.iter().rev()));
            // Far from the stripe it is dark. Beside it another object is seen, and outside the image the light is
            // unknown.
            light.along(&profile, &course(40.0 + half), columns, &mut strip);
            assert!(strip.iter().all(|v| v.abs() < 0.02 * HEIGHT));
            light.along(&profile, &course(half + SIGMA), columns, &mut strip);
            assert!(strip.iter().all(|v| v.is_infinite()), "{width}: {strip:?}");
            light.along(&profile, &course(150.0), columns, &mut strip);
            assert!(strip.iter().all(|v| v.is_nan()));
        }
    }

    #[test]
    fn courses_are_below_what_is_above_them() {
        let line = Course::Line(StripeLine { at: DVec2::new(1.0, 2.0), along: DVec2::from_angle(0.4) });
        let arc = Course::Arc(StripeArc { centre: DVec2::new(3.0, 9.0), radius: 8.0 });
        for k in 0..1000 {
            let y = 3.0 + 7.9 * (0.7 * f64::from(k)).sin();
            for course in [line, arc] {
                let on = course.at(y).unwrap();
                assert!(course.off(on).abs() < 1e-9 && (on.x - y).abs() < 1e-12);
                let up = 0.5 + 0.4 * (1.3 * f64::from(k)).cos();
                assert!(course.off(on + up * DVec2::Y) > 0.0 && course.off(on - up * DVec2::Y) < 0.0);
            }
        }
        assert!(arc.at(3.0 + 8.1).is_none() && arc.at(3.0 - 8.1).is_none());
    }

    #[test]
    fn light_is_the_sum_of_pixels_by_the_parts_of_them_in_the_strip() {
        let mut random = Random::new(7);
        let pixels: Vec<u16> = (0..40).map(|_| random.below(65535) as u16).collect();
        let frame = Frame::new(1, 40, Pixels::U16(&pixels)).unwrap();
        let blobs = Blobs::default();
        let (mut beside, mut on) = (0, 0);
        for _ in 0..5000 {
            // Also strip borders at pixel borders, and strips across the image's borders.
            let snap = |v: f64| if v.fract() < 0.2 { (2.0 * v).round() / 2.0 } else { v };
            let (row, half) = (snap(random.within(0.0, 39.0)), snap(random.within(1.0, 13.0)));
            let background = random.within(0.0, 200.0);
            let light = Light { frame: &frame, blobs: &blobs, to_px: None, half, bright: 40.0 };
            let found = light.centred(row, GreyScale { background, unit: 257.0 }, |r| u32::from(pixels[r]));
            let (mut all, mut above, mut below) = (0.0, 0.0, 0.0);
            for (r, pixel) in pixels.iter().enumerate() {
                let (to, value) = (r as f64 - row, f64::from(*pixel) / 257.0 - background);
                all += value * (half + 0.5 - to.abs()).clamp(0.0, 1.0);
                if to.abs() <= 2.0 * half {
                    below += value * (to + 0.5).clamp(0.0, 1.0);
                    above += value * (0.5 - to).clamp(0.0, 1.0);
                }
            }
            if all > 40.0 && (above - below).abs() > ONE_SIDED * (above + below) {
                assert!(found.is_infinite(), "{row} {half}: {found} {all} {above} {below}");
                beside += 1;
            } else {
                assert!((found - all).abs() < 1e-8, "{row} {half}: {found} {all}");
                on += 1;
            }
        }
        assert!(beside > 300 && on > 1000, "{beside} {on}");
    }
}
