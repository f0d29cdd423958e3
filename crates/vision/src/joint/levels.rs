use crate::{Frame, Pixels};

/// Times a frame is halved at most.
pub(super) const MOST: usize = 5;
/// A level has at least this many pixels a side.
const LEAST_SIDE: usize = 32;

/// A frame halved again and again: on one level each joint is some pixels wide, and noise is averaged over the rest.
#[derive(Debug, Clone)]
pub(super) struct Levels {
    halved: Vec<Halved>,
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
        Self { halved: vec![Halved::default(); MOST] }
    }

    /// Halves `frame` up to `level`.
    pub(super) fn prepare(&mut self, frame: &Frame, level: usize) {
        for k in 0..level.min(MOST) {
            let (before, rest) = self.halved.split_at_mut(k);
            let from = before.last().map_or_else(|| whole(frame), Halved::picture);
            match from.grey {
                Grey::U8(pixels) => {
                    rest[0].halve(from.width, from.height, pixels, 0.25, |[a, b], [c, d]| {
                        // The greatest sum is 1020.
                        f32::from(u16::from(a) + u16::from(b) + u16::from(c) + u16::from(d))
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
        if level == 0 { whole(frame) } else { self.halved[level - 1].picture() }
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
    Picture { width: frame.width(), height: frame.height(), grey }
}

impl Halved {
    fn picture(&self) -> Picture<'_> {
        Picture { width: self.width, height: self.height, grey: Grey::F32(&self.pixels) }
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
        for (out, rows) in self.pixels.chunks_exact_mut(self.width).zip(pixels.chunks_exact(2 * width)) {
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
