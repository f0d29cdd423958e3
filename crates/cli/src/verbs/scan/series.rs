//! The table of a series of profiles, and the points of each.

use crate::refusals::{at_most, in_file};
use crate::verbs::stripe::{Input, Scale, read as read_input};
use glam::{DVec2, DVec3};
use seamwright_message::{Message, Unit};
use seamwright_program::{is_beyond, is_same_position};
use seamwright_project::csv::CsvReader;
use seamwright_project::failure::Failure;
use seamwright_project::files;
use seamwright_vision::stripe::StripeReader;
use seamwright_weld::SeamCurve;
use std::path::Path;

/// Maximum number of profiles of a series.
const MAX_ROWS: usize = 10_000;
/// Maximum distance of a sensor's position from the seam, mm.
const MAX_BESIDE_MM: f64 = 50.0;
/// Distance of the positions from which the nearest one on the seam is searched, mm.
const COARSE_MM: f64 = 2.0;

/// A row of the series.
pub(super) struct Row {
    /// Path length from the start of the weld, mm.
    pub(super) s: f64,
    /// Name of the file as in the table; empty if the profile is missing.
    pub(super) file: String,
}

/// Reads the table at `path`, sorted along the seam.
pub(super) fn read(path: &Path, seam: &SeamCurve) -> Result<Vec<Row>, Failure> {
    let source = path.display().to_string();
    let text = files::read(path)?;
    let (by_length, by_position) = (["s_mm", "file"], ["x_mm", "y_mm", "z_mm", "file"]);
    let (mut reader, set) = CsvReader::open(&source, text.as_bytes(), &[&by_length, &by_position])?;
    let names: &[&str] = if set == 0 { &by_length[..1] } else { &by_position[..3] };
    let end = seam.weld_length();
    let mut rows: Vec<Row> = Vec::new();
    while let Some(cells) = reader.texts() {
        let cells = cells?;
        let mut numbers = [0.0; 3];
        for ((number, cell), name) in numbers.iter_mut().zip(&cells).zip(names) {
            let good = |v: &f64| v.is_finite();
            *number = cell.parse().ok().filter(good).ok_or_else(|| {
                let message = Message::new("project-not-a-finite-number");
                reader.error(name, cell, message, Message::new("document-number"))
            })?;
        }
        let s = if set == 0 {
            numbers[0]
        } else {
            let (s, beside) = nearest(seam, DVec3::from_array(numbers));
            if beside > MAX_BESIDE_MM {
                let message = Message::new("cli-scan-beside-seam").quantity("distance", beside, Unit::Mm, 1);
                return Err(reader.error("x_mm", &cells[..3].join(","), message, at_most(MAX_BESIDE_MM, Unit::Mm)));
            }
            s
        };
        if s < 0.0 || is_beyond(s, end) {
            let allowed = Message::new("document-between").value("min", 0.0, Unit::Mm);
            let allowed = allowed.quantity("max", end, Unit::Mm, 3);
            return Err(reader.error(names[0], &cells[0], Message::new("weld-position-beside-weld"), allowed));
        }
        if rows.iter().any(|row| is_same_position(row.s, s)) {
            let message = Message::new("cli-scan-same-position");
            return Err(reader.error(names[0], &cells[0], message, Message::new("cli-scan-one-profile")));
        }
        if rows.len() == MAX_ROWS {
            let message = in_file(&source, Message::new("cli-too-many-points"));
            return Err(Failure::refused(message, at_most(MAX_ROWS as f64, Unit::One)));
        }
        rows.push(Row { s: s.min(end), file: cells.last().cloned().unwrap_or_default() });
    }
    rows.sort_by(|a, b| a.s.total_cmp(&b.s));
    Ok(rows)
}

/// Path length of the point of the seam nearest to `at` in the seam's frame, and their distance, mm.
fn nearest(seam: &SeamCurve, at: DVec3) -> (f64, f64) {
    let distance = |s: f64| seam.at(s).point.distance(at);
    let count = (seam.weld_length() / COARSE_MM).ceil().max(1.0) as u32;
    let step = seam.weld_length() / f64::from(count);
    let coarse = (0..=count).map(|i| step * f64::from(i)).min_by(|a, b| distance(*a).total_cmp(&distance(*b)));
    let coarse = coarse.unwrap_or_default();
    let (mut low, mut high) = ((coarse - step).max(0.0), (coarse + step).min(seam.weld_length()));
    // Each step takes a third of the interval: 2 mm become 0.1 micrometres.
    for _ in 0..45 {
        let (a, b) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
        if distance(a) < distance(b) { high = b } else { low = a }
    }
    let s = 0.5 * (low + high);
    (s, distance(s))
}

/// The points (y, z) of a row's profile or image, mm, or the reason why it has none.
pub(super) fn points(
    row: &Row,
    folder: &Path,
    scale: &Scale,
    reader: &mut StripeReader,
) -> Result<Result<Vec<DVec2>, Message>, Failure> {
    if row.file.is_empty() {
        return Ok(Err(Message::new("cli-scan-no-profile")));
    }
    let path = folder.join(&row.file);
    let source = path.display().to_string();
    let image = match read_input(&path, &source)? {
        Input::Profile(points) => return Ok(Ok(points)),
        Input::Image(image) => image,
    };
    let frame = image.frame().map_err(|e| Failure::input(in_file(&source, &e)))?;
    scale.check_size(&source, [frame.width(), frame.height()])?;
    let Some(to_mm) = scale.of_image(&image) else {
        let message = in_file(&source, Message::new("cli-scan-needs-scale"));
        return Err(Failure::refused(message, Message::new("cli-scan-scales")));
    };
    let chain = match reader.trace(&frame) {
        Ok(chain) => chain,
        Err(why) => return Ok(Err(why.message())),
    };
    Ok(Ok(chain.iter().filter_map(|p| to_mm.map(p.at)).collect()))
}
