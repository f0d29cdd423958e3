//! The light of the image along a course: a line or an arc that the stripe is thought to be on.
//!
//! The chain has one place a column, and reflections and spatter shift or take it. But light adds up: where the stripe is,
//! the pixels on its course are bright whatever else is seen in the column, and where it ends they are dark.

use super::blobs::Blobs;
use super::fit::{StripeArc, StripeLine};
use super::profile::Profile;
use crate::{Frame, Pixels};
use glam::DVec2;
use seamwright_geometry::Homography;

/// Half the rows of a strip as a part of the stripe's usual width: one and a quarter standard deviations.
const HALF: f64 = 0.35;

/// Light of a column where something else than the stripe is seen on the course, so that the stripe may be there or not.
pub(super) const SOMETHING_ELSE: f64 = f64::INFINITY;

/// Part of the stripe's usual strength from which on light that is not centred on the course is something else.
const BRIGHT: f64 = 0.15;

/// How much one side of the course may be brighter than the other, part of both.
const ONE_SIDED: f64 = 0.5;

/// What the stripe follows.
#[derive(Debug, Clone, Copy)]
pub(super) enum Course {
    Line(StripeLine),
    /// The lower half of a circle.
    Arc(StripeArc),
}

impl Course {
    /// Signed distance of a place.
    pub(super) fn off(&self, p: DVec2) -> f64 {
        match self {
            Self::Line(line) => line.off(p),
            Self::Arc(arc) => -arc.off(p),
        }
    }

    /// Its place at `y`; none beside an arc.
    pub(super) fn at(&self, y: f64) -> Option<DVec2> {
        let z = match self {
            Self::Line(line) => line.at.y + (y - line.at.x) * line.along.y / line.along.x.max(1e-6),
            Self::Arc(arc) => arc.centre.y - (arc.radius.powi(2) - (y - arc.centre.x).powi(2)).sqrt(),
        };
        z.is_finite().then_some(DVec2::new(y, z))
    }
}

/// An image with what is known of its light.
pub(super) struct Light<'a> {
    frame: &'a Frame<'a>,
    blobs: &'a Blobs,
    to_px: Option<Homography>,
    /// Half the height of a strip, rows.
    half: f64,
    /// Light that is not of the background's noise.
    bright: f64,
}

impl<'a> Light<'a> {
    /// Of an image whose stripe is usually so many rows wide and so strong.
    pub(super) fn new(
        frame: &'a Frame<'a>,
        blobs: &'a Blobs,
        to_mm: Option<&Homography>,
        (width, strength): (f64, f64),
    ) -> Self {
        let to_px = to_mm.map(Homography::inverse);
        Self { frame, blobs, to_px, half: (HALF * width).max(1.0), bright: BRIGHT * strength }
    }

    /// Light on `course` in the profile's columns `from` to `to`, both included, in that order: grey values above the
    /// background, summed over a strip of rows. Not a number where the course leaves the image, [`SOMETHING_ELSE`] where
    /// that is.
    pub(super) fn along(&self, profile: &Profile, course: &Course, (from, to): (i32, i32), strip: &mut Vec<f64>) {
        strip.clear();
        let step = if to >= from { 1 } else { -1 };
        let columns = (0..=(to - from).abs()).map(|i| f64::from(from + step * i));
        if let Course::Line(line) = course {
            // A straight line in the image too.
            let ends = [line.at - line.along, line.at + line.along].map(|p| self.px(p));
            let [Some(a), Some(b)] = ends else { return };
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

    /// The place of `course` in a column of the profile, looked for from `y` on, and its row.
    pub(super) fn place(&self, profile: &Profile, course: &Course, column: f64, y: f64) -> Option<(DVec2, f64)> {
        let (column, along) = (profile.image_column(column), profile.pitch * profile.direction);
        let mut at = course.at(y)?;
        // Columns are nearly even along y.
        for _ in 0..2 {
            at = course.at(at.x + (column - self.px(at)?.x) * along)?;
        }
        Some((at, self.px(at)?.y))
    }

    /// Light of a column within `half` rows of `row`, if it is centred on it.
    fn strip(&self, column: f64, row: f64) -> f64 {
        let (width, height) = (self.frame.width(), self.frame.height());
        let inside = (0.0..=height as f64 - 1.0).contains(&row) && (-0.5..width as f64 - 0.5).contains(&column);
        if !inside {
            return f64::NAN;
        }
        let column = column.round() as usize;
        let background = self.blobs.background_at(column, row as usize);
        match self.frame.pixels() {
            Pixels::U8(pixels) => self.centred(row, |r| f64::from(pixels[r * width + column]) - background),
            Pixels::U16(pixels) => self.centred(row, |r| f64::from(pixels[r * width + column]) / 257.0 - background),
        }
    }

    /// The light about `row` in a column of so much light in each row.
    fn centred(&self, row: f64, grey: impl Fn(usize) -> f64) -> f64 {
        // The strip, and as much again above and below it.
        let (mut light, mut above, mut below) = (0.0, 0.0, 0.0);
        let first = (row - 2.0 * self.half).ceil().max(0.0) as usize;
        let last = ((row + 2.0 * self.half) as usize).min(self.frame.height() - 1);
        for r in first..=last {
            let (to, value) = (r as f64 - row, grey(r));
            light += value * (self.half + 0.5 - to.abs()).clamp(0.0, 1.0);
            let lower = (to + 0.5).clamp(0.0, 1.0);
            below += value * lower;
            above += value * (1.0 - lower);
        }
        if light > self.bright && (above - below).abs() > ONE_SIDED * (above + below) {
            return SOMETHING_ELSE;
        }
        light
    }
}
