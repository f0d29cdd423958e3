//! Data outside a job's file: tables in files, and the torch poses of its machine's axes.

use crate::points::MachineAxes;
use glam::{DAffine3, DVec3};
use seamwright_document::{Direction, Document, DocumentError, Point};
use seamwright_message::Message;
use seamwright_program::{Seam, Spline, Taught};
use std::sync::Arc;

/// Reason why data from outside are missing.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Wrong {
    /// Description of the fault.
    pub message: Message,
    /// Allowed values.
    pub allowed: Message,
}

/// Access to files and machines, for a crate without either.
pub trait Outside {
    /// The bytes of `file`, as the job names it. Errors: any error of reading.
    fn bytes(&self, file: &str) -> std::io::Result<Vec<u8>>;

    /// Rows of the point table `file`, as the job names it: three numbers (mm), six or nine (with one or two normals).
    /// Errors: an unreadable file, or one with other columns.
    fn table(&self, file: &str) -> Result<Vec<Vec<f64>>, Wrong>;

    /// The torch tip (mm) in the work frame of `machine`, as the job names it. `axes` are positions in mm or degrees,
    /// in the machine file's order. Errors: no such machine, another number of axes, positions out of range.
    fn tip(&self, machine: &str, axes: &[f64]) -> Result<DVec3, Wrong>;

    /// The axes of `machine`, as the job names it. Errors: no such machine.
    fn axes(&self, _machine: &str) -> Result<Arc<dyn MachineAxes>, Wrong> {
        let allowed = Message::new("weld-allowed-tip-coordinates");
        Err(Wrong { message: Message::new("weld-no-machine-here"), allowed })
    }
}

/// No files: for jobs that hold all data themselves.
#[derive(Debug, Clone, Copy, Default)]
pub struct NoFiles;

impl Outside for NoFiles {
    fn bytes(&self, _file: &str) -> std::io::Result<Vec<u8>> {
        Err(std::io::ErrorKind::NotFound.into())
    }

    fn table(&self, _file: &str) -> Result<Vec<Vec<f64>>, Wrong> {
        Err(Wrong { message: Message::new("weld-no-files-here"), allowed: Message::verbatim("`points_mm`") })
    }

    fn tip(&self, _machine: &str, _axes: &[f64]) -> Result<DVec3, Wrong> {
        Err(Wrong { message: Message::new("weld-no-machine-here"), allowed: Message::verbatim("`points_mm`") })
    }
}

/// Loads the points that are outside `file`. The keys that named them stay until [`forget`], for errors. Fails with the
/// key's address: faults outside, points given twice.
pub(crate) fn fetch<T>(
    file: &Document<T>,
    seam: Option<&mut Seam>,
    taught: &mut [Taught],
    machine: &str,
    seam_in_work: DAffine3,
    outside: &dyn Outside,
) -> Result<(), DocumentError> {
    let spline = seam.and_then(|seam| match seam {
        Seam::Spline(spline) => Some(spline),
        _ => None,
    });
    if let Some(spline) = spline {
        table(file, spline, outside)?;
    }
    let to_seam = seam_in_work.inverse();
    for (i, span) in taught.iter_mut().enumerate() {
        if !span.axes.is_empty() && !span.points_mm.is_empty() {
            let path = format!("taught[{i}].axes");
            let allowed = Message::new("weld-allowed-points-or-axes");
            return Err(file.error_at(&path, Message::new("weld-points-twice"), allowed));
        }
        for (k, row) in span.axes.iter().enumerate() {
            let wrong = |w: Wrong| file.error_at(&format!("taught[{i}].axes[{k}]"), w.message, w.allowed);
            let row: Vec<f64> = row.iter().map(|v| v.get()).collect();
            let point = Point::new(to_seam.transform_point3(outside.tip(machine, &row).map_err(wrong)?));
            span.points_mm.push(point.ok_or_else(|| wrong(infinite()))?);
        }
    }
    Ok(())
}

fn infinite() -> Wrong {
    Wrong { message: Message::new("weld-position-not-finite"), allowed: Message::new("weld-allowed-finite-numbers") }
}

fn table<T>(file: &Document<T>, spline: &mut Spline, outside: &dyn Outside) -> Result<(), DocumentError> {
    let Some(name) = &spline.file else { return Ok(()) };
    let path = "seam.spline.file";
    let given = [
        ("points_mm", !spline.points_mm.is_empty()),
        ("first_normals", !spline.first_normals.is_empty()),
        ("second_normals", !spline.second_normals.is_empty()),
    ];
    if let Some((key, _)) = given.into_iter().find(|(_, given)| *given) {
        let message = Message::new("weld-file-and-points").key("key", key);
        return Err(file.error_at(path, message, Message::new("weld-allowed-points-in-file-or-job")));
    }
    let rows = outside.table(name).map_err(|w| file.error_at(path, w.message, w.allowed))?;
    for (i, row) in rows.iter().enumerate() {
        let wrong = |code: &'static str| {
            let message = Message::new(code).text("file", name).text("point", (i + 1).to_string());
            file.error_at(path, message, Message::new("weld-allowed-coordinates-and-normals"))
        };
        let mut vectors = row.chunks_exact(3).map(DVec3::from_slice);
        let point = vectors.next().and_then(Point::new).ok_or_else(|| wrong("weld-table-point-not-finite"))?;
        spline.points_mm.push(point);
        for (normals, v) in [&mut spline.first_normals, &mut spline.second_normals].into_iter().zip(vectors) {
            normals.push(Direction::new(v).ok_or_else(|| wrong("weld-table-normal-without-length"))?);
        }
    }
    Ok(())
}

/// Leaves out the names of loaded files, so that a program file holds all data itself.
pub(crate) fn forget(seam: &mut Option<Seam>, taught: &mut [Taught]) {
    if let Some(Seam::Spline(spline)) = seam {
        spline.file = None;
    }
    taught.iter_mut().for_each(|span| span.axes.clear());
}
