//! Decodes image files to grey pictures.

use image::{DynamicImage, ImageFormat, ImageReader, Limits};
use seamwright_message::{Message, display_by_message};
use seamwright_vision::{Image, MAX_SIDE};
use std::io::Cursor;

/// Reasons why bytes do not decode.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum DecodeError {
    /// Unknown image format.
    Kind,
    /// A damaged or truncated file, or an invalid header.
    Broken(Message),
    /// Pixels of a depth other than 8 or 16 bits.
    Depth(u8),
}

impl DecodeError {
    /// Returns its message.
    pub fn message(&self) -> Message {
        match self {
            Self::Kind => Message::new("cell-image-format"),
            Self::Broken(why) => Message::new("cell-image-broken").message("why", why.clone()),
            Self::Depth(bits) => Message::new("cell-image-depth").number("bits", f64::from(*bits), 0),
        }
    }
}

display_by_message!(DecodeError);

/// Decodes a PNG, JPEG or PNM file of 8 or 16 bits to a grey picture; colours become their brightness (Rec. 709).
///
/// # Errors
/// Another format, a damaged file, a picture larger than [`MAX_SIDE`] to a side.
pub fn decode(bytes: &[u8]) -> Result<Image, DecodeError> {
    let broken = |e: image::ImageError| DecodeError::Broken(Message::outside(&e));
    let mut reader = ImageReader::new(Cursor::new(bytes)).with_guessed_format().map_err(|_| DecodeError::Kind)?;
    if reader.format().is_none() {
        return Err(DecodeError::Kind);
    }
    if reader.format() == Some(ImageFormat::Jpeg) && !is_whole_jpeg(bytes) {
        return Err(DecodeError::Broken(Message::new("cell-jpeg-truncated")));
    }
    let mut limits = Limits::default();
    limits.max_image_width = u32::try_from(MAX_SIDE).ok();
    limits.max_image_height = u32::try_from(MAX_SIDE).ok();
    reader.limits(limits);
    let picture = reader.decode().map_err(broken)?;
    let (width, height) = (picture.width() as usize, picture.height() as usize);
    Ok(match picture {
        DynamicImage::ImageLuma16(_)
        | DynamicImage::ImageLumaA16(_)
        | DynamicImage::ImageRgb16(_)
        | DynamicImage::ImageRgba16(_) => Image::U16 { width, height, pixels: picture.into_luma16().into_raw() },
        DynamicImage::ImageRgb32F(_) | DynamicImage::ImageRgba32F(_) => return Err(DecodeError::Depth(32)),
        _ => Image::U8 { width, height, pixels: picture.into_luma8().into_raw() },
    })
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
