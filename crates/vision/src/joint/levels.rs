use crate::{Frame, Pixels};

/// Times a frame is halved at most.
pub(super) const MOST: usize = 5;
/// Grey values below this are noise: their logarithms go along evenly.
const DARK: f32 = 4.0;
/// A level has at least this many pixels a side.
const LEAST_SIDE: usize = 32;

/// What a level keeps of the light.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Light {
    /// The frame's grey values.
    Given,
    /// Their logarithms: a joint that is a part as light as the metal is as deep in the shade as in the light.
    Logarithm,
}

/// A frame halved again and again: on one level each joint is some pixels wide, and noise is averaged over the rest.
#[derive(Debug, Clone)]
pub(super) struct Levels {
    light: Light,
    /// The levels up to this one are those of the frame.
    prepared: Option<usize>,
    /// The frame's logarithms, if the levels are made of them.
    logarithms: Halved,
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
        Self {
            light: Light::Given,
            prepared: None,
            logarithms: Halved::default(),
            halved: vec![Halved::default(); MOST],
        }
    }

    /// Another frame comes next.
    pub(super) fn begin_frame(&mut self) {
        self.prepared = None;
    }

    /// Halves `frame` up to `level`, if that was not done since it began.
    pub(super) fn prepare(&mut self, frame: &Frame, level: usize, light: Light) {
        if self.light == light && self.prepared.is_some_and(|prepared| prepared >= level) {
            return;
        }
        (self.light, self.prepared) = (light, Some(level));
        // The first frame is the last to allocate, whatever a later one shows.
        self.logarithms.pixels.reserve((frame.width() * frame.height()).saturating_sub(self.logarithms.pixels.len()));
        if light == Light::Logarithm {
            self.logarithms.take_logarithms(frame);
        }
        for k in 0..level.min(MOST) {
            let (before, rest) = self.halved.split_at_mut(k);
            let first = || if light == Light::Given { whole(frame) } else { self.logarithms.picture() };
            let from = before.last().map_or_else(first, Halved::picture);
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
        match (level, self.light) {
            (0, Light::Given) => whole(frame),
            (0, Light::Logarithm) => self.logarithms.picture(),
            (level, _) => self.halved[level - 1].picture(),
        }
    }

    /// How many nats lighter one grey value of a picture of these levels is than another; of light as it is given, the first
    /// term of the logarithm's series in the difference over the sum: 1 % less at 0.35 nats, 4 % at 0.7.
    pub(super) fn nats(&self, from: f32, to: f32) -> f32 {
        match self.light {
            Light::Given => 2.0 * (to - from) / (to + from + 2.0 * DARK),
            Light::Logarithm => (to - from) / per_nat(),
        }
    }

    /// The coarsest level that is still a picture.
    pub(super) fn coarsest(frame: &Frame) -> usize {
        let side = frame.width().min(frame.height());
        (0..=MOST).rev().find(|l| side >> l >= LEAST_SIDE).unwrap_or(0)
    }
}

/// Grey values to one nat of light where they are logarithms.
fn per_nat() -> f32 {
    255.0 / (1.0 + 255.0 / DARK).ln()
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

    /// Takes the logarithms of a frame's grey values, 0 to 255 again.
    fn take_logarithms(&mut self, frame: &Frame) {
        (self.width, self.height) = (frame.width(), frame.height());
        self.pixels.clear();
        let logarithm = |g: f32| per_nat() * (1.0 + g / DARK).ln();
        let table: [f32; 257] = std::array::from_fn(|g| logarithm(g as f32));
        match frame.pixels() {
            Pixels::U8(pixels) => self.pixels.extend(pixels.iter().map(|p| table[usize::from(*p)])),
            Pixels::U16(pixels) => self.pixels.extend(pixels.iter().map(|p| {
                let grey = f32::from(*p) * (1.0 / OF_16_BITS);
                let (low, part) = (grey as usize, grey.fract());
                table[low] + part * (table[low + 1] - table[low])
            })),
        }
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

#[cfg(test)]
mod tests {
    use super::*;

    /// The same part of the light is the same step, but for noise near black; 8 and 16 bits are alike.
    #[test]
    fn logarithms_of_light() {
        let eight: Vec<u8> = (0..=255).collect();
        let sixteen: Vec<u16> = eight.iter().map(|p| 257 * u16::from(*p)).collect();
        let of = |pixels: Pixels| {
            let mut levels = Levels::new();
            levels.prepare(&Frame::new(16, 16, pixels).unwrap(), 0, Light::Logarithm);
            levels.logarithms.pixels.clone()
        };
        let (a, b) = (of(Pixels::U8(&eight)), of(Pixels::U16(&sixteen)));
        assert!(a.iter().zip(&b).all(|(a, b)| (a - b).abs() < 1e-3));
        assert_eq!((a[0], a[255].round()), (0.0, 255.0));
        assert!(a.is_sorted());
        let (bright, dark) = (a[240] - a[120], a[48] - a[24]);
        assert!((dark / bright - 1.0).abs() < 0.1, "{dark} for {bright}");
    }
}
