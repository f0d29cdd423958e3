//! A laser stripe across a joint: its image becomes a profile, the profile the joint's features (DUALBEAM-2013).
//!
//! 1. `blobs`: up to five bright places of every column (three are not enough: spatter is brighter), sub-pixel, above a background that is taken away.
//! 2. `chain`: one chain of them across the columns by Viterbi's method: reflections and spatter are left out.
//!    The places that are told are those of several columns together (`smooth`).
//! 3. `profile`: the chain in mm, through the sensor's map. All further steps are in mm.
//! 4. `segments`: at most five straight segments, cut by dynamic programming and fitted robustly.
//! 5. `joints`: what the segments must look like for each joint, and what is measured of it, with a confidence. Where parts
//!    end, and whether the joint is all there, is looked up in the image: `light` along a course, `edges` of it.
//!
//! The stripe runs from left to right: one place a column. y grows to the right, z upwards, to the sensor. All steps are
//! deterministic, and once a [`StripeReader`] has seen an image it allocates nothing for others of that size.

mod blobs;
mod chain;
mod edges;
mod features;
mod fit;
mod joints;
mod light;
mod profile;
mod segments;
mod smooth;

pub use chain::StripePoint;
pub use features::{Doubt, Expected, Feature, Features, JointKind, NoFeatures, Quantity, StripeTask};
pub use fit::StripeLine;
pub use segments::Segment;

use crate::Frame;
use blobs::Blobs;
use chain::Chainer;
use glam::DVec2;
use joints::View;
use light::Light;
use profile::{Profile, median};
use seamwright_geometry::Homography;
use segments::Cutter;
use smooth::Smoother;

/// Fewest places of a profile.
const FEWEST: usize = 24;

/// Least part of an image's columns with the stripe.
const LEAST_COLUMNS: f64 = 0.25;

/// Reads stripes, one after the other; keeps its buffers.
#[derive(Debug, Clone, Default)]
pub struct StripeReader {
    blobs: Blobs,
    chainer: Chainer,
    chain: Vec<StripePoint>,
    smoother: Smoother,
    profile: Profile,
    cutter: Cutter,
    segments: Vec<Segment>,
    strip: Vec<f64>,
    evidence: [Vec<f64>; 2],
    scratch: Vec<f64>,
}

impl StripeReader {
    /// A reader.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// The joint asked for in an image: places and lengths in mm if `to_mm` maps (column, row) to (y, z), else in pixels
    /// with z against the rows.
    ///
    /// # Errors
    /// The reason why there is none.
    pub fn read_image(
        &mut self,
        frame: &Frame,
        to_mm: Option<&Homography>,
        task: &StripeTask,
    ) -> Result<Features, NoFeatures> {
        self.link(frame)?;
        self.profile.set_chain(&self.chain, &self.blobs, to_mm);
        self.smoother.smooth(&mut self.chain);
        self.scratch.clear();
        self.scratch.extend(self.chain.iter().map(|p| p.width));
        let width = median(&mut self.scratch).unwrap_or(0.0);
        self.scratch.clear();
        self.scratch.extend(self.chain.iter().map(|p| p.strength));
        let usual = (width, median(&mut self.scratch).unwrap_or(0.0));
        self.cut()?;
        let light = Some(Light::new(frame, &self.blobs, to_mm, usual));
        let Self { profile, segments, strip, evidence, scratch, .. } = self;
        View { profile, segments, task, light, strip, evidence, scratch }.joint()
    }

    /// The stripe in an image, without looking for a joint.
    ///
    /// # Errors
    /// If there is none.
    pub fn trace(&mut self, frame: &Frame) -> Result<&[StripePoint], NoFeatures> {
        self.link(frame)?;
        self.smoother.smooth(&mut self.chain);
        Ok(&self.chain)
    }

    /// The stripe, each column by itself.
    fn link(&mut self, frame: &Frame) -> Result<(), NoFeatures> {
        self.segments.clear();
        self.chain.clear();
        self.reserve(frame.width());
        if !self.blobs.find(frame) {
            return Err(NoFeatures::Saturated);
        }
        self.chainer.link(&self.blobs, &mut self.chain);
        let (found, columns) = (self.chain.len(), frame.width());
        if found < FEWEST {
            return Err(NoFeatures::NoStripe);
        }
        if (found as f64) < LEAST_COLUMNS * columns as f64 {
            return Err(NoFeatures::ShortStripe { found, columns });
        }
        Ok(())
    }

    /// Room for all that an image of so many columns can hold: later images of that size allocate nothing.
    fn reserve(&mut self, columns: usize) {
        self.chainer.reserve(columns);
        self.chain.reserve(columns);
        self.smoother.reserve(columns);
        self.profile.reserve(columns);
        self.cutter.reserve(columns);
        self.segments.reserve(segments::MOST);
        for strip in self.evidence.iter_mut().chain([&mut self.strip]) {
            strip.clear();
            strip.reserve(columns + 1);
        }
        self.scratch.clear();
        self.scratch.reserve(columns * blobs::MOST);
    }

    /// The joint asked for in a profile of (y, z), mm, in any order; places that are not finite are missing.
    ///
    /// # Errors
    /// The reason why there is none.
    pub fn read_profile(&mut self, points: &[DVec2], task: &StripeTask) -> Result<Features, NoFeatures> {
        self.segments.clear();
        self.chain.clear();
        self.profile.set_points(points);
        self.cut()?;
        let Self { profile, segments, strip, evidence, scratch, .. } = self;
        View { profile, segments, task, light: None, strip, evidence, scratch }.joint()
    }

    /// The stripe in the last image, from left to right; empty after a profile.
    #[must_use]
    pub fn chain(&self) -> &[StripePoint] {
        &self.chain
    }

    /// The segments of the last profile, from left to right.
    #[must_use]
    pub fn segments(&self) -> &[Segment] {
        &self.segments
    }

    /// Length of a column along y in the last profile, mm.
    #[must_use]
    pub fn pitch(&self) -> f64 {
        self.profile.pitch
    }

    /// Cuts the profile into segments.
    fn cut(&mut self) -> Result<(), NoFeatures> {
        let found = self.profile.samples.len();
        if found < FEWEST || self.profile.pitch <= 0.0 {
            return Err(NoFeatures::TooFewPoints { found, needed: FEWEST });
        }
        self.cutter.cut(&self.profile, &mut self.segments);
        if self.profile.repick(&self.segments) {
            self.cutter.cut(&self.profile, &mut self.segments);
        }
        Ok(())
    }
}
