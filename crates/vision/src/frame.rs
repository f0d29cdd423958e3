use seamwright_message::{Message, display_by_message};

/// Maximum width and height of a frame, pixels.
pub const MAX_SIDE: usize = 16384;

/// Errors of a frame's size and pixel count.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FrameError {
    /// A side is 0 or above 16384 pixels.
    Size {
        /// Pixels per row.
        width: usize,
        /// Rows.
        height: usize,
    },
    /// The number of pixels is not width times height.
    Count {
        /// Pixels per row.
        width: usize,
        /// Rows.
        height: usize,
        /// Pixels given.
        found: usize,
    },
}

display_by_message!(FrameError);

impl FrameError {
    /// Returns the description of the error.
    pub fn message(&self) -> Message {
        let sized = |code, width, height| Message::new(code).count("width", width).count("height", height);
        match *self {
            Self::Size { width, height } => sized("vision-frame-size", width, height).count("max", MAX_SIDE),
            Self::Count { width, height, found } => {
                sized("vision-frame-pixels", width, height).count("found", found).count("needed", width * height)
            }
        }
    }
}

/// Grey values of a frame, row by row from the top.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Pixels<'a> {
    /// 8 bits per pixel.
    U8(&'a [u8]),
    /// 16 bits per pixel; 65535 is white, whatever the camera's bit depth.
    U16(&'a [u16]),
}

impl Pixels<'_> {
    fn len(&self) -> usize {
        match self {
            Pixels::U8(pixels) => pixels.len(),
            Pixels::U16(pixels) => pixels.len(),
        }
    }
}

/// Size of a picture, pixels.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Size {
    /// Pixels per row.
    pub(crate) width: usize,
    /// Rows.
    pub(crate) height: usize,
}

/// A borrowed grey picture. Pixel centres have integer coordinates: x to the right, y down, (0, 0) the first pixel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frame<'a> {
    width: usize,
    height: usize,
    pixels: Pixels<'a>,
}

impl<'a> Frame<'a> {
    /// Creates a frame of `width` x `height` pixels.
    ///
    /// # Errors
    /// If a side is 0 or above 16384, or the number of pixels is not width times height.
    pub fn new(width: usize, height: usize, pixels: Pixels<'a>) -> Result<Self, FrameError> {
        if !(1..=MAX_SIDE).contains(&width) || !(1..=MAX_SIDE).contains(&height) {
            return Err(FrameError::Size { width, height });
        }
        if pixels.len() != width * height {
            return Err(FrameError::Count { width, height, found: pixels.len() });
        }
        Ok(Self { width, height, pixels })
    }

    /// Pixels per row.
    #[must_use]
    pub fn width(&self) -> usize {
        self.width
    }

    /// Rows.
    #[must_use]
    pub fn height(&self) -> usize {
        self.height
    }

    /// Returns the width and height.
    pub(crate) fn size(&self) -> Size {
        Size { width: self.width, height: self.height }
    }

    /// The grey values.
    #[must_use]
    pub fn pixels(&self) -> Pixels<'a> {
        self.pixels
    }
}

/// A grey picture that owns its pixels.
#[derive(Debug, Clone, PartialEq)]
pub enum Image {
    /// 8 bits per pixel.
    U8 {
        /// Pixels per row.
        width: usize,
        /// Rows.
        height: usize,
        /// Grey values, row by row.
        pixels: Vec<u8>,
    },
    /// 16 bits per pixel; 65535 is white.
    U16 {
        /// Pixels per row.
        width: usize,
        /// Rows.
        height: usize,
        /// Grey values, row by row.
        pixels: Vec<u16>,
    },
}

impl Image {
    /// Returns the picture as a frame.
    ///
    /// # Errors
    /// As [`Frame::new`].
    pub fn frame(&self) -> Result<Frame<'_>, FrameError> {
        match self {
            Self::U8 { width, height, pixels } => Frame::new(*width, *height, Pixels::U8(pixels)),
            Self::U16 { width, height, pixels } => Frame::new(*width, *height, Pixels::U16(pixels)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pixels_fill_the_frame_or_are_refused() {
        let pixels = [0u8; 12];
        assert!(Frame::new(4, 3, Pixels::U8(&pixels)).is_ok());
        assert_eq!(Frame::new(5, 3, Pixels::U8(&pixels)), Err(FrameError::Count { width: 5, height: 3, found: 12 }));
        assert_eq!(Frame::new(0, 3, Pixels::U8(&[])), Err(FrameError::Size { width: 0, height: 3 }));
        assert!(Frame::new(MAX_SIDE + 1, 1, Pixels::U16(&[])).is_err());
    }
}
