//! STL bytes, ASCII and binary, to triangles.

use crate::error::ClearanceError;
use glam::DVec3;
use seamwright_message::Message;

/// Bytes before the first triangle of a binary file: 80 of arbitrary text and the number of triangles.
const HEADER: usize = 84;
/// Bytes of a triangle in a binary file: a normal and three corners of three numbers, and two arbitrary bytes.
const RECORD: usize = 50;

/// Reads the triangles of an STL file, ASCII or binary, their coordinates multiplied by `scale`. Normals are ignored.
///
/// # Errors
/// Bytes that are not an STL file, a truncated file, coordinates that are not finite, no triangles.
pub fn read_stl(bytes: &[u8], scale: f64) -> Result<Vec<[DVec3; 3]>, ClearanceError> {
    // Binary headers may also start with `solid`: the length decides.
    let triangles = match binary_count(bytes) {
        Some(count) if HEADER + RECORD * count == bytes.len() => binary(bytes, scale),
        _ if starts_like_text(bytes) => ascii(bytes, scale)?,
        Some(count) if HEADER + RECORD * count < bytes.len() && count > 0 => binary(bytes, scale),
        Some(count) if plausible(bytes, count) => {
            let found = (bytes.len() - HEADER) / RECORD;
            let why = Message::new("clearance-stl-triangles-missing").count("found", found).count("count", count);
            return Err(ClearanceError::CutShort(why));
        }
        _ => return Err(ClearanceError::NotStl(Message::new("clearance-stl-no-header"))),
    };
    if triangles.is_empty() {
        return Err(ClearanceError::NoTriangles);
    }
    match triangles.iter().position(|t| t.iter().any(|p| !p.is_finite())) {
        Some(i) => Err(ClearanceError::NotFinite { triangle: i + 1 }),
        None => Ok(triangles),
    }
}

fn starts_like_text(bytes: &[u8]) -> bool {
    let text = bytes.trim_ascii_start();
    text.get(..5).is_some_and(|w| w.eq_ignore_ascii_case(b"solid")) && !bytes.iter().take(400).any(|b| *b == 0)
}

fn binary_count(bytes: &[u8]) -> Option<usize> {
    let count = bytes.get(80..HEADER)?.try_into().ok()?;
    usize::try_from(u32::from_le_bytes(count)).ok()
}

/// True for a plausible count of a truncated file: its full size is below 10 GB, and zero bytes are among the first, as
/// in any binary file of numbers.
fn plausible(bytes: &[u8], count: usize) -> bool {
    count < 200_000_000 && bytes.iter().take(400).any(|b| *b == 0)
}

fn binary(bytes: &[u8], scale: f64) -> Vec<[DVec3; 3]> {
    let count = binary_count(bytes).unwrap_or(0);
    let number = |b: &[u8]| f64::from(f32::from_le_bytes([b[0], b[1], b[2], b[3]])) * scale;
    let point = |b: &[u8]| DVec3::new(number(&b[..4]), number(&b[4..8]), number(&b[8..12]));
    bytes[HEADER..].chunks_exact(RECORD).take(count).map(|r| [&r[12..24], &r[24..36], &r[36..48]].map(point)).collect()
}

/// Reads an ASCII file, line by line. An error in its last line counts as a truncated file.
fn ascii(bytes: &[u8], scale: f64) -> Result<Vec<[DVec3; 3]>, ClearanceError> {
    let text = String::from_utf8_lossy(bytes);
    let mut triangles = Vec::new();
    let mut corners = Vec::new();
    let mut ended = false;
    let mut lines = text.trim_end().lines().enumerate().peekable();
    while let Some((i, line)) = lines.next() {
        let read = read_line(line, scale, &mut corners, &mut triangles, &mut ended);
        if let Err(why) = read {
            if lines.peek().is_none() {
                break;
            }
            return Err(ClearanceError::NotStl(why.text("line", (i + 1).to_string())));
        }
    }
    if !ended || !corners.is_empty() {
        let why = Message::new("clearance-stl-no-endsolid").count("count", triangles.len());
        return Err(ClearanceError::CutShort(why));
    }
    Ok(triangles)
}

fn read_line(
    line: &str,
    scale: f64,
    corners: &mut Vec<DVec3>,
    triangles: &mut Vec<[DVec3; 3]>,
    ended: &mut bool,
) -> Result<(), Message> {
    let mut words = line.split_whitespace();
    match words.next().map(str::to_ascii_lowercase).as_deref() {
        Some("vertex") => corners.push(corner(words).ok_or(Message::new("clearance-stl-corner"))? * scale),
        Some("endfacet") => {
            let three = <[DVec3; 3]>::try_from(std::mem::take(corners));
            let corners = |c: Vec<DVec3>| Message::new("clearance-stl-facet").count("corners", c.len());
            triangles.push(three.map_err(corners)?);
        }
        Some("endsolid") => *ended = true,
        Some("solid") => *ended = false,
        None | Some("facet" | "outer" | "endloop") => {}
        Some(_) => {
            let word: String = line.trim().chars().take(40).collect();
            return Err(Message::new("clearance-stl-word").text("word", word));
        }
    }
    Ok(())
}

fn corner<'a>(words: impl Iterator<Item = &'a str>) -> Option<DVec3> {
    let numbers: Vec<f64> = words.map(|w| w.parse().ok()).collect::<Option<_>>()?;
    <[f64; 3]>::try_from(numbers).ok().map(DVec3::from_array)
}
