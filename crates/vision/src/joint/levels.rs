use super::make_room;
use super::top_hat::TopHat;
use crate::wide::{Simd, Work, wide};
use crate::{Frame, Pixels};

/// Times a frame is halved at most.
pub(super) const MOST: usize = 5;
/// A level has at least this many pixels a side.
const LEAST_SIDE: usize = 32;

/// A frame halved again and again: on one level each joint is some pixels wide, and noise is averaged over the rest.
#[derive(Debug, Clone)]
pub(super) struct Levels {
    /// The levels up to this one are those of the frame.
    prepared: Option<usize>,
    halved: Vec<Halved>,
    /// The top-hat of this level takes its place.
    covered: Option<usize>,
    /// The level, squares and depth that the top-hat was taken for since the frame began.
    taken: Option<(usize, usize, f32)>,
    top_hat: TopHat,
}

#[derive(Debug, Clone, Default)]
struct Halved {
    width: usize,
    height: usize,
    pixels: Vec<f32>,
}

/// Grey values of a level, 0 to 255 whatever they are kept as.
#[derive(Debug, Clone, Copy)]
pub(super) struct Picture<'a> {
    pub(super) width: usize,
    pub(super) height: usize,
    pub(super) grey: Grey<'a>,
    pub(super) is_top_hat: bool,
}

#[derive(Debug, Clone, Copy)]
pub(super) enum Grey<'a> {
    U8(&'a [u8]),
    U16(&'a [u16]),
    F32(&'a [f32]),
}

/// What 16 bits are divided by.
pub(super) const OF_16_BITS: f32 = 257.0;

impl Levels {
    pub(super) fn new() -> Self {
        Self {
            prepared: None,
            halved: vec![Halved::default(); MOST],
            covered: None,
            taken: None,
            top_hat: TopHat::default(),
        }
    }

    /// Another frame comes next.
    pub(super) fn begin_frame(&mut self) {
        (self.prepared, self.covered, self.taken) = (None, None, None);
    }

    /// Halves `frame` up to `level`, if that was not done since it began.
    pub(super) fn prepare(&mut self, frame: &Frame, level: usize) {
        if self.prepared.is_some_and(|prepared| prepared >= level) {
            return;
        }
        self.prepared = Some(level);
        for k in 0..level.min(MOST) {
            let (before, rest) = self.halved.split_at_mut(k);
            let from = before.last().map_or_else(|| whole(frame), Halved::picture);
            match from.grey {
                Grey::U8(pixels) => {
                    rest[0].halve(from.width, from.height, pixels, 0.25, |[a, b], [c, d]| {
                        // Pairs are taken apart as one number, several of them at a time. The greatest sum is 1020.
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

    /// A level that was prepared; 0 is the frame itself.
    pub(super) fn picture<'a>(&'a self, frame: &Frame<'a>, level: usize) -> Picture<'a> {
        match level {
            _ if self.covered == Some(level) => self.top_hat.picture(),
            0 => whole(frame),
            level => self.halved[level - 1].picture(),
        }
    }

    /// From now on `level` (1 at least) is its top-hat, for a joint of this width there and so many grey values deep.
    pub(super) fn cover(&mut self, frame: &Frame, level: usize, (width, contrast): (f32, f32)) {
        self.prepare(frame, level);
        let Halved { width: columns, height: rows, pixels } = &self.halved[level - 1];
        let around = width.round().max(1.0) as usize;
        let wanted = Some((level, around, contrast));
        if self.taken != wanted {
            self.taken = wanted;
            self.top_hat.take(pixels, (*columns, *rows), around, contrast);
        }
        self.covered = Some(level);
    }

    /// The level that is a top-hat.
    pub(super) fn covered(&self) -> Option<usize> {
        self.covered
    }

    /// The levels are those of the frame again.
    pub(super) fn uncover(&mut self) {
        self.covered = None;
    }

    /// Room for all levels of a frame, and the top-hat of any, for joints up to so many pixels wide on theirs.
    pub(super) fn make_room(&mut self, frame: &Frame, widest: f32) {
        let (mut width, mut height) = (frame.width(), frame.height());
        for level in &mut self.halved {
            (width, height) = (width / 2, height / 2);
            make_room(&mut level.pixels, width * height);
        }
        self.top_hat.make_room((frame.width() / 2, frame.height() / 2), widest.round() as usize);
    }

    /// The coarsest level that is still a picture.
    pub(super) fn coarsest(frame: &Frame) -> usize {
        let side = frame.width().min(frame.height());
        (0..=MOST).rev().find(|l| side >> l >= LEAST_SIDE).unwrap_or(0)
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

    /// Sums of two by two pixels times `part`; an odd last row or column is left out.
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

/// A place of the frame on a level, along one axis, and back.
pub(super) fn to_level(at: f32, level: usize) -> f32 {
    let scale = (1usize << level) as f32;
    (at - 0.5 * (scale - 1.0)) / scale
}

/// See [`to_level`].
pub(super) fn from_level(at: f32, level: usize) -> f32 {
    let scale = (1usize << level) as f32;
    at * scale + 0.5 * (scale - 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::random;

    /// A top-hat is taken once for what stays the same, and anew for all else.
    #[test]
    fn a_top_hat_is_of_this_frame_level_width_and_depth() {
        let mut random = random();
        let mut frame = || (0..96 * 80).map(|_| (200.0 * random()) as u8).collect::<Vec<u8>>();
        let frames = [frame(), frame()];
        let frames = frames.each_ref().map(|pixels| Frame::new(96, 80, Pixels::U8(pixels)).unwrap());
        let shown = |levels: &Levels, frame: &Frame, level: usize| match levels.picture(frame, level).grey {
            Grey::F32(pixels) => pixels.to_vec(),
            _ => unreachable!("a top-hat is of fractions"),
        };
        let mut levels = Levels::new();
        for frame in &frames {
            levels.begin_frame();
            for (level, joint) in
                [(1, (3.0, 40.0)), (1, (3.0, 40.0)), (1, (3.0, 20.0)), (1, (5.0, 20.0)), (2, (5.0, 20.0))]
            {
                levels.cover(frame, level, joint);
                let mut fresh = Levels::new();
                fresh.cover(frame, level, joint);
                assert_eq!(shown(&levels, frame, level), shown(&fresh, frame, level), "{level} {joint:?}");
                levels.uncover();
            }
        }
    }
}
