//! An image or a profile, by the content of the file.

use crate::refusals::{at_most, in_file};
use glam::DVec2;
use seamwright_frames::decode;
use seamwright_message::{Message, Unit};
use seamwright_project::csv::CsvReader;
use seamwright_project::failure::Failure;
use seamwright_project::files;
use seamwright_vision::Image;
use std::path::Path;

/// Maximum number of points of a profile.
const MAX_POINTS: usize = 1_000_000;

pub(crate) enum Input {
    Image(Image),
    /// y and z, mm; not a number where it is missing.
    Profile(Vec<DVec2>),
}

/// Reads the file; `source` names it in messages.
pub(crate) fn read(path: &Path, source: &str) -> Result<Input, Failure> {
    let bytes = files::read_bytes(path, source)?;
    if is_image(&bytes) {
        return decode(&bytes).map(Input::Image).map_err(|e| Failure::input(in_file(source, &e)));
    }
    let Ok(text) = std::str::from_utf8(&bytes) else {
        let message = in_file(source, Message::new("cli-stripe-neither"));
        return Err(Failure::refused(message, Message::new("cli-stripe-formats")));
    };
    profile(text, source).map(Input::Profile)
}

/// Whether the first bytes are those of PNG, JPEG or PNM.
fn is_image(bytes: &[u8]) -> bool {
    let pnm = matches!(bytes, [b'P', b'1'..=b'7', b' ' | b'\n' | b'\r' | b'\t', ..]);
    bytes.starts_with(b"\x89PNG") || bytes.starts_with(b"\xff\xd8\xff") || pnm
}

/// Rows of y_mm and z_mm; an empty cell or `nan` is a missing point.
fn profile(text: &str, source: &str) -> Result<Vec<DVec2>, Failure> {
    let names = ["y_mm", "z_mm"];
    let (mut reader, _) = CsvReader::open(source, text.as_bytes(), &[&names])?;
    let mut points = Vec::new();
    while let Some(row) = reader.texts() {
        let row = row?;
        let mut point = [f64::NAN; 2];
        for ((value, cell), name) in point.iter_mut().zip(&row).zip(names) {
            if cell.is_empty() || cell.eq_ignore_ascii_case("nan") {
                continue;
            }
            let good = |v: &f64| v.abs() <= 1e7;
            *value = cell.parse().ok().filter(good).ok_or_else(|| {
                let allowed = Message::new("cli-stripe-position");
                reader.error(name, cell, Message::new("cli-not-a-position"), allowed)
            })?;
        }
        points.push(DVec2::from_array(point));
        if points.len() > MAX_POINTS {
            return Err(Failure::refused(
                in_file(source, Message::new("cli-too-many-points")),
                at_most(MAX_POINTS as f64, Unit::One),
            ));
        }
    }
    Ok(points)
}
