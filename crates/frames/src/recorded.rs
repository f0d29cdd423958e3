use crate::decode::decode;
use crate::error::FrameError;
use crate::{FrameSource, TimedFrame, checked_time};
use png::BitDepth;
use seamwright_message::{Message, Unit};
use seamwright_vision::Image;
use std::borrow::Cow;
use std::fmt::Write as _;
use std::fs;
use std::io::BufWriter;
use std::path::{Path, PathBuf};

/// File name of the list of frames in their folder.
pub const LIST: &str = "frames.csv";
const HEIGHT: &str = "height_mm";
/// Maximum list size, bytes.
const LARGEST_LIST: u64 = 1 << 28;
/// Maximum image file size, bytes.
const LARGEST_IMAGE: u64 = 1 << 30;

#[derive(Debug, Clone, PartialEq)]
struct Row {
    file: String,
    t_s: f64,
    axes: Vec<f64>,
    height_mm: Option<f64>,
}

/// Frames from a folder: images (PNG, JPEG, PNM; 8 or 16 bits) and the list `frames.csv`. Its columns are `file`,
/// `t_s`, one for each of the machine's axes (mm or degrees), and optionally `height_mm` (empty without a measurement).
#[derive(Debug)]
pub struct Recorded {
    folder: PathBuf,
    rows: Vec<Row>,
    next: usize,
    before: Option<f64>,
}

impl Recorded {
    /// Opens the frames in `folder`, of a machine with these axes; without axes the list has no axis columns.
    ///
    /// # Errors
    /// A missing or invalid list. Images are read when their turn comes.
    pub fn open(folder: &Path, axes: &[&str]) -> Result<Self, FrameError> {
        let path = folder.join(LIST);
        let text = String::from_utf8(read(&path, LARGEST_LIST)?).map_err(|e| FrameError::List {
            file: path.display().to_string(),
            line: 1 + e.as_bytes()[..e.utf8_error().valid_up_to()].iter().filter(|b| **b == b'\n').count(),
            message: Message::new("cell-list-no-text"),
            allowed: Message::verbatim("UTF-8"),
        })?;
        let rows = rows(&path.display().to_string(), &text, axes)?;
        Ok(Self { folder: folder.to_owned(), rows, next: 0, before: None })
    }

    /// Number of frames in the list.
    pub fn len(&self) -> usize {
        self.rows.len()
    }

    /// True if the list has no frames.
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }
}

impl FrameSource for Recorded {
    fn next(&mut self) -> Result<Option<TimedFrame>, FrameError> {
        let Some(row) = self.rows.get(self.next) else { return Ok(None) };
        let frame = self.next;
        // After an error the source is at its end.
        self.next = self.rows.len();
        let t_s = checked_time(row.t_s, &mut self.before, frame)?;
        let path = self.folder.join(&row.file);
        let bytes = read(&path, LARGEST_IMAGE)?;
        let image =
            decode(&bytes).map_err(|e| FrameError::Image { file: path.display().to_string(), why: e.message() })?;
        self.next = frame + 1;
        let axes = (!row.axes.is_empty()).then(|| row.axes.clone());
        Ok(Some(TimedFrame { t_s, image, axes, height_mm: row.height_mm }))
    }
}

fn read(path: &Path, largest: u64) -> Result<Vec<u8>, FrameError> {
    let failed = |e: &std::io::Error| FrameError::path(path, e);
    let size = fs::metadata(path).map_err(|e| failed(&e))?.len();
    if size > largest {
        let bytes = |size: u64| size as f64;
        let why = Message::new("cell-file-too-large").quantity("size", bytes(size), Unit::Byte, 0);
        let why = why.quantity("max", bytes(largest), Unit::Byte, 0);
        return Err(FrameError::Image { file: path.display().to_string(), why });
    }
    fs::read(path).map_err(|e| failed(&e))
}

fn rows(file: &str, text: &str, axes: &[&str]) -> Result<Vec<Row>, FrameError> {
    let wrong = |line: usize, message: Message, allowed: Message| FrameError::List {
        file: file.to_owned(),
        line,
        message,
        allowed,
    };
    let mut lines = text.lines().enumerate().map(|(i, line)| (i + 1, line.trim_end_matches('\r')));
    let mut wanted = vec!["file", "t_s"];
    wanted.extend(axes);
    let header: Vec<&str> = lines.next().map_or(Vec::new(), |(_, line)| line.split(',').map(str::trim).collect());
    let heights = header.len() == wanted.len() + 1 && header[wanted.len()] == HEIGHT;
    if header[..header.len().min(wanted.len())] != wanted[..] || !(heights || header.len() == wanted.len()) {
        let allowed = Message::new("cell-list-columns-allowed").text("columns", wanted.join(","));
        let message = Message::new("cell-list-columns").text("columns", header.join(","));
        return Err(wrong(1, message, allowed.text("optional", HEIGHT)));
    }
    let mut rows: Vec<Row> = Vec::new();
    for (line, text) in lines.filter(|(_, line)| !line.trim().is_empty()) {
        let cells: Vec<&str> = text.split(',').map(str::trim).collect();
        if cells.len() != header.len() {
            let allowed = Message::new("cell-list-cells-allowed").count("n", header.len());
            return Err(wrong(line, Message::new("cell-list-cells").count("n", cells.len()), allowed));
        }
        let name = cells[0];
        // Only within the folder: a foreign list must not lead to other files.
        let inside = Path::new(name).components().all(|c| matches!(c, std::path::Component::Normal(_)));
        if name.is_empty() || !inside {
            let message = Message::new("cell-list-file").text("name", name);
            return Err(wrong(line, message, Message::new("cell-list-file-allowed")));
        }
        let number = |column: usize| {
            let value = cells[column].parse::<f64>().ok().filter(|v| v.is_finite());
            let message =
                || Message::new("cell-list-number").text("column", header[column]).text("value", cells[column]);
            value.ok_or_else(|| wrong(line, message(), Message::new("document-finite-number")))
        };
        let t_s = number(1)?;
        if let Some(before) = rows.last().filter(|before| before.t_s >= t_s) {
            let message =
                Message::new("cell-list-time").value("time", t_s, Unit::S).value("before", before.t_s, Unit::S);
            return Err(wrong(line, message, Message::new("cell-list-time-allowed")));
        }
        let axes = (2..wanted.len()).map(number).collect::<Result<_, _>>()?;
        let height_mm = (heights && !cells[wanted.len()].is_empty()).then(|| number(wanted.len())).transpose()?;
        rows.push(Row { file: name.to_owned(), t_s, axes, height_mm });
    }
    match rows.is_empty() {
        true => Err(wrong(2, Message::new("cell-list-empty"), Message::new("cell-list-empty-allowed"))),
        false => Ok(rows),
    }
}

/// Writes frames into a folder in the form that [`Recorded`] reads.
#[derive(Debug)]
pub struct Recorder {
    folder: PathBuf,
    list: String,
    count: usize,
}

impl Recorder {
    /// Starts a recording in `folder`, which is made if missing, of a machine with these axes.
    ///
    /// # Errors
    /// If the folder cannot be made.
    pub fn create(folder: &Path, axes: &[&str]) -> Result<Self, FrameError> {
        fs::create_dir_all(folder).map_err(|e| FrameError::path(folder, &e))?;
        let mut header = vec!["file", "t_s"];
        header.extend(axes);
        header.push(HEIGHT);
        Ok(Self { folder: folder.to_owned(), list: format!("{}\n", header.join(",")), count: 0 })
    }

    /// Writes a frame as PNG.
    ///
    /// # Errors
    /// If the file cannot be written, or the pixels are invalid.
    pub fn add(&mut self, frame: &TimedFrame) -> Result<(), FrameError> {
        let name = format!("{:06}.png", self.count);
        let path = self.folder.join(&name);
        let invalid = |why: Message| FrameError::Image { file: path.display().to_string(), why };
        // Also says that the sides fit.
        frame.image.frame().map_err(|e| invalid(e.message()))?;
        let (depth, bytes) = match &frame.image {
            Image::U8 { pixels, .. } => (BitDepth::Eight, Cow::Borrowed(pixels.as_slice())),
            Image::U16 { pixels, .. } => (BitDepth::Sixteen, pixels.iter().flat_map(|p| p.to_be_bytes()).collect()),
        };
        let (Image::U8 { width, height, .. } | Image::U16 { width, height, .. }) = &frame.image;
        let file = fs::File::create(&path).map_err(|e| FrameError::path(&path, &e))?;
        let mut png = png::Encoder::new(BufWriter::new(file), *width as u32, *height as u32);
        png.set_depth(depth);
        // While a seam is taught, pictures come ten times a second.
        png.set_compression(png::Compression::Fast);
        let written = png.write_header().and_then(|mut png| {
            png.write_image_data(&bytes)?;
            png.finish()
        });
        written.map_err(|e| FrameError::Io { what: path.display().to_string(), why: Message::outside(&e) })?;
        let _ = write!(self.list, "{name},{}", frame.t_s);
        for value in frame.axes.iter().flatten() {
            let _ = write!(self.list, ",{value}");
        }
        let _ = writeln!(self.list, ",{}", frame.height_mm.map_or(String::new(), |h| h.to_string()));
        self.count += 1;
        Ok(())
    }

    /// Writes the list, last: without it the folder is not a recording.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn finish(self) -> Result<(), FrameError> {
        let path = self.folder.join(LIST);
        fs::write(&path, self.list).map_err(|e| FrameError::path(&path, &e))
    }
}
