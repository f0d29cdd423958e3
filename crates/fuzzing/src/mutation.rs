//! Random changes of inputs.

use rand_pcg::Pcg64Mcg;
use rand_pcg::rand_core::{Rng as _, SeedableRng as _};

/// Seeded random numbers. Not those of `testkit`: its tests have an allocator of their own.
#[derive(Debug, Clone)]
pub struct Random(Pcg64Mcg);

impl Random {
    /// Creates the numbers of a seed.
    pub fn new(seed: u64) -> Self {
        Self(Pcg64Mcg::seed_from_u64(seed))
    }

    /// Returns 64 random bits.
    fn bits(&mut self) -> u64 {
        self.0.next_u64()
    }

    /// Returns a whole number below `count`.
    pub fn below(&mut self, count: usize) -> usize {
        (self.bits() % count as u64) as usize
    }

    /// Returns true once in `count` times.
    pub fn one_in(&mut self, count: usize) -> bool {
        self.below(count) == 0
    }

    /// Returns one of `items`.
    pub fn one<'a, T>(&mut self, items: &'a [T]) -> &'a T {
        &items[self.below(items.len())]
    }
}

/// Numbers at the ends of ranges, and texts that are almost numbers.
const NUMBERS: [&str; 24] = [
    "0",
    "-0.0",
    "1",
    "-1",
    "1e-300",
    "1e-9",
    "0.1",
    "1e6",
    "-1e6",
    "1e9",
    "1e308",
    "1e999",
    "nan",
    "inf",
    "-inf",
    "255",
    "256",
    "65536",
    "4294967296",
    "9223372036854775807",
    "-9223372036854775808",
    "360",
    "90.0000001",
    "0x7fffffff",
];

/// The last position between two characters up to `at`.
fn floor(text: &str, at: usize) -> usize {
    (0..=at.min(text.len())).rev().find(|i| text.is_char_boundary(*i)).unwrap_or(0)
}

/// A position between two characters.
fn boundary(random: &mut Random, text: &str) -> usize {
    floor(text, random.below(text.len() + 1))
}

/// Start and end of a random line, with its line break.
fn line(random: &mut Random, text: &str) -> (usize, usize) {
    let at = boundary(random, text);
    let from = text[..at].rfind('\n').map_or(0, |i| i + 1);
    (from, text[at..].find('\n').map_or(text.len(), |i| at + i + 1))
}

/// Start and end of the first number behind a random position.
fn number(random: &mut Random, text: &str) -> Option<(usize, usize)> {
    let at = boundary(random, text);
    let from = at + text[at..].find(|c: char| c.is_ascii_digit())?;
    let is_part = |c: char| c.is_ascii_digit() || matches!(c, '.' | '_' | 'e' | 'E' | '+' | '-');
    Some((from, text[from..].find(|c| !is_part(c)).map_or(text.len(), |i| from + i)))
}

/// Changes a text at random: a number, a line, a word, a part; `others` are texts of which parts are put in. It stays
/// shorter than `max_length` unless it was longer.
pub fn mutate_text(random: &mut Random, text: &mut String, words: &[String], others: &[String], max_length: usize) {
    let start = boundary(random, text);
    let end = floor(text, start + random.below(13)).max(start);
    let mut put = None;
    match random.below(11) {
        0 | 1 => {
            if let Some((from, to)) = number(random, text) {
                text.replace_range(from..to, random.one::<&str>(&NUMBERS));
            }
        }
        2 => text.replace_range(start..end, ""),
        3 if !words.is_empty() => text.replace_range(start..end, random.one::<String>(words)),
        4 if !words.is_empty() => put = Some((start, random.one(words).clone())),
        5 => {
            let (from, to) = line(random, text);
            text.replace_range(from..to, "");
        }
        6 => {
            let (from, to) = line(random, text);
            put = Some((line(random, text).0, text[from..to].to_owned()));
        }
        7 if !others.is_empty() => {
            let other = random.one(others);
            let (from, to) = line(random, other);
            put = Some((line(random, text).0, other[from..to].to_owned()));
        }
        8 if !others.is_empty() => {
            let other = random.one(others);
            let (from, to) = (boundary(random, other), boundary(random, other));
            put = Some((start, other[from.min(to)..from.max(to)].to_owned()));
        }
        9 => put = Some((start, char::from_u32(random.below(0x3000) as u32).unwrap_or(' ').to_string())),
        _ if random.one_in(8) => text.truncate(start),
        _ => {
            let to = boundary(random, text);
            put = Some((start, text[start.min(to)..start.max(to)].to_owned()));
        }
    }
    if let Some((at, part)) = put.filter(|(_, part)| text.len() + part.len() <= max_length) {
        text.insert_str(floor(text, at), &part);
    }
}

/// Changes bytes at random: flips, cuts, doubles, and numbers at the ends of ranges.
pub fn mutate(random: &mut Random, bytes: &mut Vec<u8>, max_length: usize) {
    let start = random.below(bytes.len() + 1);
    let end = (start + random.below(9)).min(bytes.len());
    match random.below(7) {
        0 | 1 if start < bytes.len() => bytes[start] = random.bits() as u8,
        2 if start < bytes.len() => bytes[start] ^= 1 << random.below(8),
        3 => {
            let odd: u32 = *random.one(&[0, 1, 0xff, 0x7fff, 0xffff, 0x10000, 0x7fff_ffff, u32::MAX]);
            let four = if random.one_in(2) { odd.to_le_bytes() } else { odd.to_be_bytes() };
            bytes.iter_mut().skip(start).zip(four).for_each(|(byte, new)| *byte = new);
        }
        4 => drop(bytes.drain(start..end)),
        5 if bytes.len() + (end - start) <= max_length => bytes.extend_from_within(start..end),
        _ if random.one_in(8) => bytes.truncate(start),
        _ if bytes.len() < max_length => bytes.insert(start, random.bits() as u8),
        _ => {}
    }
}
