use crate::error::{Field, FrameError, Part};
use crate::{FrameSource, TimedFrame, checked_time};
use seamwright_message::{Message, Unit};
use seamwright_vision::{Image, MAX_SIDE};
use std::fmt::Display;
use std::io::{Read, Write};
use std::net::{TcpStream, ToSocketAddrs};
use std::time::Duration;

const MAGIC: &[u8; 4] = b"SWFR";
/// Version of the header.
pub const VERSION: u16 = 1;
/// Length of the header, bytes.
pub const HEADER_BYTES: usize = 40;
/// Maximum number of axis positions with a frame.
pub const MAX_FRAME_AXES: u16 = 64;
/// Size of the pieces in which pixels are read, bytes, so that an invalid header cannot allocate memory without data.
const PIECE: usize = 1 << 16;

/// Frames from a byte stream: of a beam's scanner, or any camera outside of a file. `docs/reference/vision-sources.md` describes
/// the header.
#[derive(Debug)]
pub struct FrameStream<R> {
    input: R,
    what: String,
    frame: usize,
    before: Option<f64>,
    ended: bool,
}

impl FrameStream<TcpStream> {
    /// Connects to `address` (host:port); no frame within `patience` is an error.
    ///
    /// # Errors
    /// Unknown address, no connection, or no answer in time.
    pub fn connect(address: &str, patience: Duration) -> Result<Self, FrameError> {
        let failed = |e: &std::io::Error| FrameError::io(address, e);
        let mut last = std::io::Error::from(std::io::ErrorKind::AddrNotAvailable);
        for address in address.to_socket_addrs().map_err(|e| failed(&e))? {
            match TcpStream::connect_timeout(&address, patience) {
                Ok(stream) => {
                    stream.set_read_timeout(Some(patience)).map_err(|e| failed(&e))?;
                    stream.set_write_timeout(Some(patience)).map_err(|e| failed(&e))?;
                    return Ok(Self::new(stream, address.to_string()));
                }
                Err(e) => last = e,
            }
        }
        Err(failed(&last))
    }

    /// Sends a line of text to the other end.
    ///
    /// # Errors
    /// If the connection is closed.
    pub fn say(&mut self, line: &str) -> Result<(), FrameError> {
        let sent = self.input.write_all(format!("{line}\n").as_bytes());
        sent.map_err(|e| FrameError::io(&self.what, &e))
    }
}

impl<R: Read> FrameStream<R> {
    /// Reads frames from `input`, called `what` in errors.
    pub fn new(input: R, what: String) -> Self {
        Self { input, what, frame: 0, before: None, ended: false }
    }

    /// Fills `bytes`; returns how many came before the stream's end.
    fn fill(&mut self, bytes: &mut [u8]) -> Result<usize, FrameError> {
        let mut found = 0;
        while found < bytes.len() {
            match self.input.read(&mut bytes[found..]) {
                Ok(0) => break,
                Ok(n) => found += n,
                Err(e) if e.kind() == std::io::ErrorKind::Interrupted => {}
                Err(e) if matches!(e.kind(), std::io::ErrorKind::WouldBlock | std::io::ErrorKind::TimedOut) => {
                    let why = Message::new("cell-frame-late").number("frame", self.frame as f64, 0);
                    return Err(FrameError::Io { what: self.what.clone(), why });
                }
                Err(e) => return Err(FrameError::io(&self.what, &e)),
            }
        }
        Ok(found)
    }

    fn part(&mut self, part: Part, wanted: usize) -> Result<Vec<u8>, FrameError> {
        let mut bytes = Vec::new();
        while bytes.len() < wanted {
            let from = bytes.len();
            bytes.resize((from + PIECE).min(wanted), 0);
            let end = bytes.len();
            let found = self.fill(&mut bytes[from..end])?;
            if from + found < end {
                return Err(FrameError::Truncated { frame: self.frame, part, found: from + found, wanted });
            }
        }
        Ok(bytes)
    }

    fn read(&mut self) -> Result<Option<TimedFrame>, FrameError> {
        let mut bytes = [0; HEADER_BYTES];
        let found = self.fill(&mut bytes)?;
        if found == 0 {
            return Ok(None);
        }
        let frame = self.frame;
        if found < HEADER_BYTES {
            return Err(FrameError::Truncated { frame, part: Part::Header, found, wanted: HEADER_BYTES });
        }
        let header = Header::read(&bytes, frame)?;
        let t_s = checked_time(header.t_s, &mut self.before, frame)?;
        let axes = self.part(Part::Axes, 8 * usize::from(header.axes))?;
        let axes: Vec<f64> = axes.chunks_exact(8).map(|b| f64::from_le_bytes(array(b))).collect();
        if let Some(bad) = axes.iter().find(|v| !v.is_finite()) {
            return Err(FrameError::Header {
                frame,
                field: Field::Position,
                found: Message::verbatim(bad.to_string()),
                allowed: Message::new("cell-frame-position-allowed"),
            });
        }
        let Header { width, height, bits, .. } = header;
        let pixels = self.part(Part::Pixels, width * height * usize::from(bits / 8))?;
        let image = match bits {
            8 => Image::U8 { width, height, pixels },
            _ => {
                let pixels = pixels.chunks_exact(2).map(|b| u16::from_le_bytes(array(b))).collect();
                Image::U16 { width, height, pixels }
            }
        };
        image.frame().map_err(|shape| FrameError::Shape { frame, shape })?;
        self.frame += 1;
        let axes = (!axes.is_empty()).then_some(axes);
        Ok(Some(TimedFrame { t_s, image, axes, height_mm: header.height_mm }))
    }
}

impl<R: Read> FrameSource for FrameStream<R> {
    fn next(&mut self) -> Result<Option<TimedFrame>, FrameError> {
        if self.ended {
            return Ok(None);
        }
        let next = self.read();
        self.ended = !matches!(next, Ok(Some(_)));
        next
    }
}

fn array<const N: usize>(bytes: &[u8]) -> [u8; N] {
    std::array::from_fn(|i| bytes.get(i).copied().unwrap_or(0))
}

struct Header {
    width: usize,
    height: usize,
    bits: u16,
    axes: u16,
    t_s: f64,
    height_mm: Option<f64>,
}

impl Header {
    fn read(bytes: &[u8; HEADER_BYTES], frame: usize) -> Result<Self, FrameError> {
        let u16_at = |i: usize| u16::from_le_bytes(array(&bytes[i..]));
        let u32_at = |i: usize| u32::from_le_bytes(array(&bytes[i..]));
        let f64_at = |i: usize| f64::from_le_bytes(array(&bytes[i..]));
        let text = |text: &dyn Display| Message::verbatim(text.to_string());
        let wrong = |field, found, allowed| Err(FrameError::Header { frame, field, found, allowed });
        if &bytes[..4] != MAGIC {
            let found = format!("{:02x?}", &bytes[..4]);
            return wrong(Field::Magic, text(&found), text(&format!("{MAGIC:02x?}, \"SWFR\"")));
        }
        if u16_at(4) != VERSION {
            return wrong(Field::Version, text(&u16_at(4)), text(&VERSION));
        }
        let bits = u16_at(6);
        if ![8, 16].contains(&bits) {
            return wrong(Field::Depth, text(&bits), Message::new("cell-frame-depth-allowed"));
        }
        let (width, height) = (u32_at(8), u32_at(12));
        for (field, side) in [(Field::Width, width), (Field::Height, height)] {
            if side == 0 || side as usize > MAX_SIDE {
                let allowed = Message::new("document-between").value("min", 1.0, Unit::Px);
                return wrong(field, text(&side), allowed.value("max", MAX_SIDE as f64, Unit::Px));
            }
        }
        let axes = u16_at(16);
        if axes > MAX_FRAME_AXES {
            let allowed = Message::new("document-between").number("min", 0.0, 0);
            return wrong(Field::Axes, text(&axes), allowed.number("max", f64::from(MAX_FRAME_AXES), 0));
        }
        if u16_at(18) != 0 || u32_at(20) != 0 {
            return wrong(Field::Reserved, text(&format!("{:02x?}", &bytes[18..24])), text(&0));
        }
        let height_mm = f64_at(32);
        if height_mm.is_infinite() {
            return wrong(Field::WorkHeight, text(&height_mm), Message::new("cell-frame-work-height-allowed"));
        }
        let height_mm = Some(height_mm).filter(|h| !h.is_nan());
        Ok(Self { width: width as usize, height: height as usize, bits, axes, t_s: f64_at(24), height_mm })
    }
}

/// Writes a frame in the form that [`FrameStream`] reads.
///
/// # Errors
/// Those of the output; more axes than [`MAX_FRAME_AXES`] are an invalid input.
pub fn write_frame(frame: &TimedFrame, output: &mut impl Write) -> std::io::Result<()> {
    let axes = frame.axes.as_deref().unwrap_or_default();
    let count = u16::try_from(axes.len()).ok().filter(|n| *n <= MAX_FRAME_AXES);
    let count = count.ok_or(std::io::ErrorKind::InvalidInput)?;
    let (width, height, bits) = match &frame.image {
        Image::U8 { width, height, .. } => (*width, *height, 8u16),
        Image::U16 { width, height, .. } => (*width, *height, 16),
    };
    let side = |n: usize| u32::try_from(n).map_err(|_| std::io::Error::from(std::io::ErrorKind::InvalidInput));
    let mut bytes = Vec::with_capacity(HEADER_BYTES + 8 * axes.len());
    bytes.extend(MAGIC);
    bytes.extend(VERSION.to_le_bytes());
    bytes.extend(bits.to_le_bytes());
    bytes.extend(side(width)?.to_le_bytes());
    bytes.extend(side(height)?.to_le_bytes());
    bytes.extend(count.to_le_bytes());
    bytes.extend([0; 6]);
    bytes.extend(frame.t_s.to_le_bytes());
    bytes.extend(frame.height_mm.unwrap_or(f64::NAN).to_le_bytes());
    bytes.extend(axes.iter().flat_map(|v| v.to_le_bytes()));
    output.write_all(&bytes)?;
    match &frame.image {
        Image::U8 { pixels, .. } => output.write_all(pixels),
        Image::U16 { pixels, .. } => {
            let bytes: Vec<u8> = pixels.iter().flat_map(|v| v.to_le_bytes()).collect();
            output.write_all(&bytes)
        }
    }
}
