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
                Grey::U8(pixels) => rest[0].halve(from.width, from.height, pixels, f32::from),
                Grey::U16(pixels) => {
                    rest[0].halve(from.width, from.height, pixels, |p| f32::from(p) / OF_16_BITS);
                }
                Grey::F32(pixels) => rest[0].halve(from.width, from.height, pixels, |p| p),
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

    /// Means of two by two pixels; an odd last row or column is left out.
    fn halve<P: Copy>(&mut self, width: usize, height: usize, pixels: &[P], grey: impl Fn(P) -> f32) {
        (self.width, self.height) = (width / 2, height / 2);
        self.pixels.clear();
        for rows in pixels.chunks_exact(2 * width).take(self.height) {
            let (upper, lower) = rows.split_at(width);
            let pairs = upper.chunks_exact(2).zip(lower.chunks_exact(2));
            self.pixels.extend(pairs.map(|(a, b)| 0.25 * (grey(a[0]) + grey(a[1]) + grey(b[0]) + grey(b[1]))));
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
