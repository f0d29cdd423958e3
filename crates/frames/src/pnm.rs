//! Reads PNM files: bits, greys and colours as text or binary (P1 to P6), and PAM (P7).

use crate::decode::{DecodeError, Samples, checked_size};
use seamwright_message::Message;

/// Decodes a file that begins with `P1` to `P7`.
pub(crate) fn decode(bytes: &[u8], max_pixels: usize) -> Result<Samples, DecodeError> {
    let (kind, mut rest) = (bytes[1], Rest(&bytes[2..]));
    let header = if kind == b'7' { rest.pam_header() } else { rest.header(kind) }.ok_or(DecodeError::Kind)?;
    let Header { width, height, channels, maximum } = header;
    if !(1..=4).contains(&channels) || !(1..=65535).contains(&maximum) {
        return Err(DecodeError::Kind);
    }
    checked_size([width, height], channels * size_of::<u16>(), max_pixels)?;
    let count = width * height * channels;
    let values: Vec<u16> = match kind {
        // Black is 1.
        b'1' => std::iter::from_fn(|| rest.bit()).map(|bit| 1 - bit).take(count).collect(),
        b'2' | b'3' => std::iter::from_fn(|| rest.number()).map_while(|n| u16::try_from(n).ok()).take(count).collect(),
        b'4' => {
            let bit = |row: &[u8], x: usize| u16::from(row[x / 8] >> (7 - x % 8) & 1 == 0);
            let rows = rest.0.chunks_exact(width.div_ceil(8)).take(height);
            rows.flat_map(|row| (0..width).map(move |x| bit(row, x))).collect()
        }
        _ if maximum > 255 => {
            rest.0.as_chunks::<2>().0.iter().map(|pair| u16::from_be_bytes(*pair)).take(count).collect()
        }
        _ => rest.0.iter().map(|value| u16::from(*value)).take(count).collect(),
    };
    if values.len() < count || values.iter().any(|value| usize::from(*value) > maximum) {
        return Err(DecodeError::Broken(Message::new("cell-pixel-count")));
    }
    let scaled = |full: f32| {
        let factor = full / maximum as f32;
        values.iter().map(move |value| (f32::from(*value) * factor).round())
    };
    Ok(match maximum > 255 {
        true => Samples::U16 { width, height, channels, values: scaled(65535.0).map(|v| v as u16).collect() },
        false => Samples::U8 { width, height, channels, values: scaled(255.0).map(|v| v as u8).collect() },
    })
}

struct Header {
    width: usize,
    height: usize,
    /// Values of a pixel.
    channels: usize,
    /// Maximum value.
    maximum: usize,
}

/// The rest of the file, not read yet.
struct Rest<'a>(&'a [u8]);

impl Rest<'_> {
    fn byte(&mut self) -> Option<u8> {
        let (first, rest) = self.0.split_first()?;
        self.0 = rest;
        Some(*first)
    }

    fn skip_comment(&mut self) {
        while !matches!(self.byte(), None | Some(b'\n' | b'\r')) {}
    }

    /// Reads the next bit that is written as text. Spaces and comments before it are skipped.
    fn bit(&mut self) -> Option<u16> {
        loop {
            match self.byte()? {
                bit @ (b'0' | b'1') => return Some(u16::from(bit - b'0')),
                b'#' => self.skip_comment(),
                b' ' | b'\t'..=b'\r' => {}
                _ => return None,
            }
        }
    }

    /// Reads a whole number and the one character after it. Spaces and comments before it are skipped.
    fn number(&mut self) -> Option<usize> {
        let mut number = None;
        loop {
            match self.byte() {
                Some(b'#') => self.skip_comment(),
                Some(digit @ b'0'..=b'9') => {
                    let before: usize = number.unwrap_or(0);
                    number = Some(before.checked_mul(10)?.checked_add(usize::from(digit - b'0'))?);
                }
                Some(b' ' | b'\t'..=b'\r') if number.is_none() => {}
                Some(b' ' | b'\t'..=b'\r') | None => return number,
                Some(_) => return None,
            }
        }
    }

    fn header(&mut self, kind: u8) -> Option<Header> {
        let (width, height) = (self.number()?, self.number()?);
        let maximum = if matches!(kind, b'1' | b'4') { 1 } else { self.number()? };
        Some(Header { width, height, channels: if matches!(kind, b'3' | b'6') { 3 } else { 1 }, maximum })
    }

    /// Reads a header of lines with a word and its value.
    fn pam_header(&mut self) -> Option<Header> {
        let mut header = Header { width: 0, height: 0, channels: 0, maximum: 0 };
        loop {
            let end = self.0.iter().position(|c| *c == b'\n')?;
            let line = std::str::from_utf8(&self.0[..end]).ok()?.trim();
            self.0 = &self.0[end + 1..];
            let (word, value) = line.split_once(char::is_whitespace).unwrap_or((line, ""));
            let value = || value.trim().parse().ok();
            match word {
                "WIDTH" => header.width = value()?,
                "HEIGHT" => header.height = value()?,
                "DEPTH" => header.channels = value()?,
                "MAXVAL" => header.maximum = value()?,
                "ENDHDR" => return Some(header),
                "TUPLTYPE" | "" => {}
                comment if comment.starts_with('#') => {}
                _ => return None,
            }
        }
    }
}
