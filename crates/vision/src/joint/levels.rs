use super::make_room;
use super::top_hat::TopHat;
use crate::frame::{Frame, Pixels, Size};
use crate::simd::{Work, wide};
use pulp::Simd;

/// Maximum number of halvings.
pub(super) const MAX_HALVINGS: usize = 5;
/// Minimum side of a level, pixels.
const MIN_SIDE: usize = 32;

/// Image pyramid: on one level each joint is a few pixels wide, and noise is averaged over the rest.
#[derive(Debug, Clone)]
pub(super) struct Levels {
    /// Highest level computed for this frame.
    prepared: Option<usize>,
    halved: Vec<Halved>,
    /// Level that is replaced by its top-hat.
    covered: Option<usize>,
    /// Level, square and depth of the current top-hat of this frame.
    taken: Option<(usize, usize, f32)>,
    top_hat: TopHat,
}

#[derive(Debug, Clone, Default)]
struct Halved {
    width: usize,
    height: usize,
    pixels: Vec<f32>,
}

/// Grey values of a level, 0 to 255 in any format.
#[derive(Debug, Clone, Copy)]
pub(super) struct Picture<'a> {
    pub(super) width: usize,
    pub(super) height: usize,
    pub(super) grey: Grey<'a>,
    pub(super) is_top_hat: bool,
}

impl Picture<'_> {
    /// Returns the width and height.
    pub(super) fn size(&self) -> Size {
        Size { width: self.width, height: self.height }
    }
}

/// Width and depth of a joint.
#[derive(Debug, Clone, Copy)]
pub(super) struct DarkLine {
    /// Full width at half depth, pixels of its level.
    pub(super) width: f32,
    /// Depth, grey values.
    pub(super) contrast: f32,
}

#[derive(Debug, Clone, Copy)]
pub(super) enum Grey<'a> {
    U8(&'a [u8]),
    U16(&'a [u16]),
    F32(&'a [f32]),
}

/// Divisor from 16-bit grey values to 0 to 255.
pub(super) const OF_16_BITS: f32 = 257.0;

impl Levels {
    pub(super) fn new() -> Self {
        Self {
            prepared: None,
            halved: vec![Halved::default(); MAX_HALVINGS],
            covered: None,
            taken: None,
            top_hat: TopHat::default(),
        }
    }

    pub(super) fn begin_frame(&mut self) {
        (self.prepared, self.covered, self.taken) = (None, None, None);
    }

    /// Computes the levels of `frame` up to `level`, unless already done for this frame.
    pub(super) fn prepare(&mut self, frame: &Frame, level: usize) {
        if self.prepared.is_some_and(|prepared| prepared >= level) {
            return;
        }
        self.prepared = Some(level);
        for k in 0..level.min(MAX_HALVINGS) {
            let (before, rest) = self.halved.split_at_mut(k);
            let from = before.last().map_or_else(|| whole(frame), Halved::picture);
            match from.grey {
                Grey::U8(pixels) => {
                    rest[0].halve(from.width, from.height, pixels, 0.25, |[a, b], [c, d]| {
                        // Two 8-bit pixels are split from one 16-bit number, several at a time. The maximum sum is
                        // 1020.
                        let [upper, lower] = [[a, b], [c, d]].map(u16::from_le_bytes);
                        f32::from((upper & 0xff) + (upper >> 8) + (lower & 0xff) + (lower >> 8))
                    });
                }
                Grey::U16(pixels) => {
                    rest[0].halve(from.width, from.height, pixels, 0.25 / OF_16_BITS, |[a, b], [c, d]| {
                        (u32::from(a) + u32::from(b) + u32::from(c) + u32::from(d)) as f32
                    });
                }
                Grey::F32(pixels) => {
                    rest[0].halve(from.width, from.height, pixels, 0.25, |[a, b], [c, d]| a + b + c + d);
                }
            }
        }
    }

    /// Returns a prepared level; 0 is the frame itself.
    pub(super) fn picture<'a>(&'a self, frame: &Frame<'a>, level: usize) -> Picture<'a> {
        match level {
            _ if self.covered == Some(level) => self.top_hat.picture(),
            0 => whole(frame),
            level => self.halved[level - 1].picture(),
        }
    }

    /// Replaces `level` (1 at least) by its top-hat, for this joint.
    pub(super) fn cover(&mut self, frame: &Frame, level: usize, joint: DarkLine) {
        self.prepare(frame, level);
        let Halved { width, height, pixels } = &self.halved[level - 1];
        let around = joint.width.round().max(1.0) as usize;
        let wanted = Some((level, around, joint.contrast));
        if self.taken != wanted {
            self.taken = wanted;
            self.top_hat.take(pixels, Size { width: *width, height: *height }, around, joint.contrast);
        }
        self.covered = Some(level);
    }

    /// Returns the level that is replaced by its top-hat.
    pub(super) fn covered(&self) -> Option<usize> {
        self.covered
    }

    /// Restores the levels of the frame.
    pub(super) fn uncover(&mut self) {
        self.covered = None;
    }

    /// Reserves capacity for all levels of a frame and the top-hat of any, for joints up to `widest` pixels on their
    /// level.
    pub(super) fn make_room(&mut self, frame: &Frame, widest: f32) {
        let (mut width, mut height) = (frame.width(), frame.height());
        for level in &mut self.halved {
            (width, height) = (width / 2, height / 2);
            make_room(&mut level.pixels, width * height);
        }
        self.top_hat.make_room(Size { width: frame.width() / 2, height: frame.height() / 2 }, widest.round() as usize);
    }

    pub(super) fn coarsest(frame: &Frame) -> usize {
        let side = frame.width().min(frame.height());
        (0..=MAX_HALVINGS).rev().find(|l| side >> l >= MIN_SIDE).unwrap_or(0)
    }
}

fn whole<'a>(frame: &Frame<'a>) -> Picture<'a> {
    let grey = match frame.pixels() {
        Pixels::U8(pixels) => Grey::U8(pixels),
        Pixels::U16(pixels) => Grey::U16(pixels),
    };
    Picture { width: frame.width(), height: frame.height(), grey, is_top_hat: false }
}

impl Halved {
    fn picture(&self) -> Picture<'_> {
        Picture { width: self.width, height: self.height, grey: Grey::F32(&self.pixels), is_top_hat: false }
    }

    /// Computes sums of two by two pixels times `part`; drops an odd last row or column.
    fn halve<P: Copy>(
        &mut self,
        width: usize,
        height: usize,
        pixels: &[P],
        part: f32,
        sum: impl Fn([P; 2], [P; 2]) -> f32,
    ) {
        (self.width, self.height) = (width / 2, height / 2);
        self.pixels.resize(self.width * self.height, 0.0);
        wide(Halve { pixels, width, part, sum, out: &mut self.pixels });
    }
}

/// Sums of two by two pixels times `part`.
struct Halve<'a, P, S> {
    pixels: &'a [P],
    width: usize,
    part: f32,
    sum: S,
    out: &'a mut [f32],
}

impl<P: Copy, S: Fn([P; 2], [P; 2]) -> f32> Work for Halve<'_, P, S> {
    #[inline(always)]
    fn run(self, _: impl Simd) {
        let Self { pixels, width, part, sum, out } = self;
        for (out, rows) in out.chunks_exact_mut(width / 2).zip(pixels.chunks_exact(2 * width)) {
            let (upper, lower) = rows.split_at(width);
            let pairs = upper.as_chunks::<2>().0.iter().zip(lower.as_chunks::<2>().0);
            for (out, (a, b)) in out.iter_mut().zip(pairs) {
                *out = part * sum(*a, *b);
            }
        }
    }
}

/// Converts a coordinate of the frame to a level.
pub(super) fn to_level(at: f32, level: usize) -> f32 {
    let scale = (1usize << level) as f32;
    (at - 0.5 * (scale - 1.0)) / scale
}

/// Converts a coordinate of a level to the frame.
pub(super) fn from_level(at: f32, level: usize) -> f32 {
    let scale = (1usize << level) as f32;
    at * scale + 0.5 * (scale - 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use seamwright_testkit::Random;

    /// The top-hat is reused for the same key and recomputed for any other.
    #[test]
    fn a_top_hat_is_of_this_frame_level_width_and_depth() {
        let mut random = Random::new(7);
        let mut frame = || (0..96 * 80).map(|_| random.below(200) as u8).collect::<Vec<u8>>();
        let frames = [frame(), frame()];
        let frames = frames.each_ref().map(|pixels| Frame::new(96, 80, Pixels::U8(pixels)).unwrap());
        let shown = |levels: &Levels, frame: &Frame, level: usize| match levels.picture(frame, level).grey {
            Grey::F32(pixels) => pixels.to_vec(),
            _ => unreachable!("a top-hat is of fractions"),
        };
        let mut levels = Levels::new();
        for frame in &frames {
            levels.begin_frame();
            for (level, width, contrast) in
                [(1, 3.0, 40.0), (1, 3.0, 40.0), (1, 3.0, 20.0), (1, 5.0, 20.0), (2, 5.0, 20.0)]
            {
                let joint = DarkLine { width, contrast };
                levels.cover(frame, level, joint);
                let mut fresh = Levels::new();
                fresh.cover(frame, level, joint);
                assert_eq!(shown(&levels, frame, level), shown(&fresh, frame, level), "{level} {joint:?}");
                levels.uncover();
            }
        }
    }
}
