//! Decodes image files to grey pictures.

use crate::pnm;
use seamwright_message::{Message, display_by_message};
use seamwright_vision::{FrameError, Image, MAX_SIDE};
use std::io::Cursor;
use zune_core::bytestream::ZCursor;
use zune_core::colorspace::ColorSpace;
use zune_core::options::DecoderOptions;
use zune_jpeg::JpegDecoder;

/// Maximum memory of a picture's decoded values, bytes: a small file can decode to a large picture.
const MAX_BYTES: usize = 512 << 20;

/// Reasons why bytes do not decode.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum DecodeError {
    /// Unknown image format, or an invalid header.
    Kind,
    /// A damaged or truncated file, or a picture that is too large.
    Broken(Message),
}

impl DecodeError {
    /// Returns its message.
    pub fn message(&self) -> Message {
        match self {
            Self::Kind => Message::new("cell-image-format"),
            Self::Broken(why) => Message::new("cell-image-broken").message("why", why.clone()),
        }
    }
}

display_by_message!(DecodeError);

/// Decodes a PNG, JPEG or PNM file of 8 or 16 bits to a grey picture; colours become their brightness (Rec. 709).
///
/// # Errors
/// Another format, a damaged file, a picture larger than [`MAX_SIDE`](seamwright_vision::MAX_SIDE) to a side or than
/// 512 MiB.
pub fn decode(bytes: &[u8]) -> Result<Image, DecodeError> {
    decode_up_to(bytes, MAX_SIDE * MAX_SIDE)
}

/// Decodes the same, if the picture has at most `max_pixels`: one from elsewhere, in a program that has no memory to
/// spare.
///
/// # Errors
/// See [`decode`]; a larger picture.
pub fn decode_up_to(bytes: &[u8], max_pixels: usize) -> Result<Image, DecodeError> {
    let samples = match bytes {
        [0x89, b'P', b'N', b'G', ..] => decode_png(bytes, max_pixels),
        [0xff, 0xd8, 0xff, ..] => decode_jpeg(bytes, max_pixels),
        [b'P', b'1'..=b'7', ..] => pnm::decode(bytes, max_pixels),
        _ => Err(DecodeError::Kind),
    }?;
    Ok(samples.grey())
}

/// Values of a picture, row by row and pixel by pixel: grey, or red, green and blue; after them perhaps the opacity.
pub(crate) enum Samples {
    U8 { width: usize, height: usize, channels: usize, values: Vec<u8> },
    U16 { width: usize, height: usize, channels: usize, values: Vec<u16> },
}

impl Samples {
    fn grey(self) -> Image {
        fn brightness<T: Copy + Into<u32>>(pixel: &[T]) -> u32 {
            match *pixel {
                [red, green, blue, ..] => (2126 * red.into() + 7152 * green.into() + 722 * blue.into() + 5000) / 10_000,
                _ => pixel[0].into(),
            }
        }
        match self {
            Self::U8 { width, height, channels: 1, values } => Image::U8 { width, height, pixels: values },
            Self::U16 { width, height, channels: 1, values } => Image::U16 { width, height, pixels: values },
            Self::U8 { width, height, channels, values } => {
                let pixels = values.chunks_exact(channels).map(|pixel| brightness(pixel) as u8).collect();
                Image::U8 { width, height, pixels }
            }
            Self::U16 { width, height, channels, values } => {
                let pixels = values.chunks_exact(channels).map(|pixel| brightness(pixel) as u16).collect();
                Image::U16 { width, height, pixels }
            }
        }
    }
}

/// Refuses a picture before its pixels are read: a side of 0 or above [`MAX_SIDE`](seamwright_vision::MAX_SIDE), or
/// values of more than [`MAX_BYTES`], or more than `max_pixels`.
pub(crate) fn checked_size(
    [width, height]: [usize; 2],
    bytes_a_pixel: usize,
    max_pixels: usize,
) -> Result<(), DecodeError> {
    let sides = (1..=MAX_SIDE).contains(&width) && (1..=MAX_SIDE).contains(&height);
    match sides && width * height * bytes_a_pixel <= MAX_BYTES && width * height <= max_pixels {
        true => Ok(()),
        false => Err(DecodeError::Broken(FrameError::Size { width, height }.message())),
    }
}

fn broken(e: impl std::fmt::Display) -> DecodeError {
    DecodeError::Broken(Message::outside(&e))
}

fn decode_png(bytes: &[u8], max_pixels: usize) -> Result<Samples, DecodeError> {
    let mut decoder = png::Decoder::new(Cursor::new(bytes));
    let info = decoder.read_header_info().map_err(broken)?;
    let (width, height) = (info.width as usize, info.height as usize);
    // Fewer bits become 8, of at most four colours.
    let bytes_a_pixel = match info.bit_depth {
        png::BitDepth::Sixteen => 2 * info.color_type.samples(),
        _ => 4,
    };
    checked_size([width, height], bytes_a_pixel, max_pixels)?;
    // Fewer bits become 8, a palette its colours.
    decoder.set_transformations(png::Transformations::EXPAND);
    let mut reader = decoder.read_info().map_err(broken)?;
    // The decoder takes whole colours for granted, and up to 256 of them.
    let colours = reader.info().palette.as_ref().map_or(0, |palette| palette.len());
    if colours % 3 != 0 || colours > 3 * 256 {
        return Err(DecodeError::Kind);
    }
    let mut values = vec![0; reader.output_buffer_size().unwrap_or(0)];
    reader.next_frame(&mut values).map_err(broken)?;
    let (colour, depth) = reader.output_color_type();
    let channels = colour.samples();
    Ok(match depth {
        png::BitDepth::Sixteen => {
            let values = values.as_chunks::<2>().0.iter().map(|pair| u16::from_be_bytes(*pair)).collect();
            Samples::U16 { width, height, channels, values }
        }
        _ => Samples::U8 { width, height, channels, values },
    })
}

fn decode_jpeg(bytes: &[u8], max_pixels: usize) -> Result<Samples, DecodeError> {
    if !is_whole_jpeg(bytes) {
        return Err(DecodeError::Broken(Message::new("cell-jpeg-truncated")));
    }
    let options = DecoderOptions::default().set_strict_mode(false);
    let options = options.set_max_width(usize::MAX).set_max_height(usize::MAX);
    let mut decoder = JpegDecoder::new_with_options(ZCursor::new(bytes), options);
    decoder.decode_headers().map_err(broken)?;
    let (width, height) = decoder.dimensions().unwrap_or_default();
    let colours = match decoder.input_colorspace() {
        Some(grey @ (ColorSpace::Luma | ColorSpace::LumaA)) => grey,
        _ => ColorSpace::RGB,
    };
    checked_size([width, height], colours.num_components(), max_pixels)?;
    decoder.set_options(options.jpeg_set_out_colorspace(colours));
    let values = decoder.decode().map_err(broken)?;
    Ok(Samples::U8 { width, height, channels: colours.num_components(), values })
}

/// Returns true if a JPEG file contains the end of its picture. Decoders fill a truncated picture with grey, in which a
/// joint would be lost without a reported reason. Segments are skipped by their lengths up to the scan, because one may
/// hold a small picture with an end of its own. Within the scan the end marker cannot occur.
fn is_whole_jpeg(bytes: &[u8]) -> bool {
    const SCAN: u8 = 0xda;
    const END: u8 = 0xd9;
    let mut at = 2;
    while let Some([0xff, marker, high, low]) = bytes.get(at..at + 4) {
        match *marker {
            // Fill bytes before a marker.
            0xff => at += 1,
            SCAN => return bytes[at..].windows(2).any(|pair| pair == [0xff, END]),
            _ => at += 2 + usize::from(u16::from_be_bytes([*high, *low])),
        }
    }
    false
}
