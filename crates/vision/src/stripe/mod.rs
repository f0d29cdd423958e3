//! Laser stripe sensor: the image of a stripe across a joint becomes a profile, the profile the joint's features
//! (DUALBEAM-2013).
//!
//! 1. `blobs`: up to five bright blobs of every column, sub-pixel, above a subtracted background. (Three are not
//!    enough: spatter is brighter.)
//! 2. `blob_chain`: one chain of blobs across the columns by Viterbi's method, without reflections and spatter. Reported
//!    points are smoothed over several columns (`smooth`).
//! 3. `profile`: the chain in mm, through the sensor's map. All further steps are in mm.
//! 4. `segments`: at most five straight segments, cut by dynamic programming and fitted robustly.
//! 5. `joints`: the required shape and the measurements of each joint type, with a confidence. The ends of parts, and
//!    the completeness of the joint, are checked in the image: `light` along a course, `edges` of it.
//!
//! The stripe runs from left to right, with one point per column. y grows to the right, z upwards, to the sensor. All
//! steps are deterministic. After a first image, a [`StripeReader`] does not allocate for others of that size.

mod blob_chain;
mod blobs;
mod edges;
mod features;
mod fit;
mod joints;
mod light;
mod profile;
mod segments;
mod smooth;

pub use blob_chain::StripePoint;
pub use features::{Doubt, Expected, Feature, Features, JointKind, NoFeatures, Quantity, StripeTask};
pub use fit::StripeLine;
pub use segments::Segment;

use crate::frame::Frame;
use blob_chain::Chainer;
use blobs::Blobs;
use glam::DVec2;
use joints::View;
use light::{Light, UsualStripe};
use profile::{Profile, median};
use seamwright_geometry::Homography;
use segments::Cutter;
use smooth::Smoother;

/// Minimum points of a profile.
const FEWEST: usize = 24;

/// Minimum part of an image's columns with the stripe.
const MIN_COLUMNS: f64 = 0.25;

/// Reads stripes, one after the other; reuses its buffers.
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
    /// Creates a reader.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Detects the task's joint in an image. Points and lengths are in mm if `to_mm` maps (column, row) to (y, z), else
    /// in pixels with z against the rows.
    ///
    /// # Errors
    /// The reason why no joint was detected.
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
        let strength = median(&mut self.scratch).unwrap_or(0.0);
        self.cut()?;
        let light = Some(Light::new(frame, &self.blobs, to_mm, UsualStripe { width, strength }));
        let Self { profile, segments, strip, evidence, scratch, .. } = self;
        View { profile, segments, task, light, strip, evidence, scratch }.joint()
    }

    /// Traces the stripe in an image, without detecting a joint.
    ///
    /// # Errors
    /// The reason why no stripe was found.
    pub fn trace(&mut self, frame: &Frame) -> Result<&[StripePoint], NoFeatures> {
        self.link(frame)?;
        self.smoother.smooth(&mut self.chain);
        Ok(&self.chain)
    }

    /// Links the stripe, each column on its own.
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
        if (found as f64) < MIN_COLUMNS * columns as f64 {
            return Err(NoFeatures::ShortStripe { found, columns });
        }
        Ok(())
    }

    /// Reserves capacity for an image of this many columns, so that later images of that size do not allocate.
    fn reserve(&mut self, columns: usize) {
        self.chainer.reserve(columns);
        self.chain.reserve(columns);
        self.smoother.reserve(columns);
        self.profile.reserve(columns);
        self.cutter.reserve(columns);
        self.segments.reserve(segments::MAX_SEGMENTS);
        for strip in self.evidence.iter_mut().chain([&mut self.strip]) {
            strip.clear();
            strip.reserve(columns + 1);
        }
        self.scratch.clear();
        self.scratch.reserve(columns * blobs::MAX_BLOBS);
    }

    /// Detects the task's joint in a profile of points (y, z), mm, in any order; points that are not finite count as
    /// missing.
    ///
    /// # Errors
    /// The reason why no joint was detected.
    pub fn read_profile(&mut self, points: &[DVec2], task: &StripeTask) -> Result<Features, NoFeatures> {
        self.segments.clear();
        self.chain.clear();
        self.profile.set_points(points);
        self.cut()?;
        let Self { profile, segments, strip, evidence, scratch, .. } = self;
        View { profile, segments, task, light: None, strip, evidence, scratch }.joint()
    }

    /// Returns the stripe in the last image, from left to right; empty after a profile.
    #[must_use]
    pub fn chain(&self) -> &[StripePoint] {
        &self.chain
    }

    /// Returns the segments of the last profile, from left to right.
    #[must_use]
    pub fn segments(&self) -> &[Segment] {
        &self.segments
    }

    /// Returns the length of a column along y in the last profile, mm.
    #[must_use]
    pub fn pitch(&self) -> f64 {
        self.profile.pitch
    }

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
