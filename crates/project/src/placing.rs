//! The work moved in a job file, as a person would write it.
//!
//! - With a work offset in force, that offset is changed.
//! - Otherwise `[placement]` is changed, where the seam stands at one place.
//! - A job with copies or rows gets a work offset, which moves all of them.

use crate::failure::Failure;
use crate::work_offset::{put_into, rounded};
use glam::{DAffine3, DVec3};
use seamwright_document::{Document, Transform};
use seamwright_message::Message;
use seamwright_program::Program;
use toml_edit::{Array, DocumentMut, Item, Table, TableLike, Value};

/// Name of the work offset of a job with copies.
const OFFSET: &str = "reach";

/// A job's text with its work moved.
#[derive(Debug, Clone, PartialEq)]
pub struct PlacedText {
    /// The text.
    pub text: String,
    /// The key that was changed.
    pub key: String,
    /// Its new value.
    pub transform: Transform,
}

/// Moves the work of the job or program `text`, read as `program`, by the rigid displacement `by` in the work frame.
/// Comments and all other entries stay.
///
/// # Errors
/// A file in which the entry is not a table, or a displacement that no number can hold.
pub fn placed(text: &str, program: &Document<Program>, by: &DAffine3) -> Result<PlacedText, Failure> {
    let value = &program.value;
    let file = program.file();
    let to_write = |transform: &DAffine3| rounded(transform).ok_or_else(|| unchangeable(file, "placement"));
    if let Some(name) = &value.offset {
        let key = format!("offsets.{name}");
        let transform = to_write(&(*by * value.work_offset()))?;
        return set(text, &["offsets", name], &transform)
            .map(|text| PlacedText { text, key, transform })
            .ok_or_else(|| unchangeable(file, "offsets"));
    }
    if value.copies.is_empty() {
        let transform = to_write(&(*by * value.placement.affine()))?;
        let key = "placement".to_owned();
        return set(text, &["placement"], &transform)
            .map(|text| PlacedText { text, key, transform })
            .ok_or_else(|| unchangeable(file, "placement"));
    }
    let transform = to_write(by)?;
    let text = put_into(text, OFFSET, &transform).ok().flatten().ok_or_else(|| unchangeable(file, "offsets"))?;
    Ok(PlacedText { text, key: format!("offsets.{OFFSET}"), transform })
}

fn unchangeable(file: &str, table: &str) -> Failure {
    let why = Message::new("project-not-a-table").key("table", table);
    Failure::input(Message::new("project-in-file").text("file", file).message("why", why))
}

/// The text with `transform` in the table at `path`; none if it is not TOML or the entry is not a table.
fn set(text: &str, path: &[&str], transform: &Transform) -> Option<String> {
    let mut document: DocumentMut = text.parse().ok()?;
    let mut table: &mut dyn TableLike = document.as_table_mut();
    for key in path {
        table = table.entry(key).or_insert_with(|| Item::Table(Table::new())).as_table_like_mut()?;
    }
    let array = |v: DVec3| Value::from(v.to_array().into_iter().collect::<Array>());
    put(table, "move_mm", array(transform.move_mm.get()));
    match transform.turn {
        Some(turn) => {
            put(table, "turn", array(turn.unit()));
            put(table, "angle_deg", Value::from(transform.angle_deg.get()));
        }
        None => ["turn", "angle_deg"].into_iter().for_each(|key| drop(table.remove(key))),
    }
    Some(document.to_string())
}

/// Sets a value; the comment beside an old one stays.
fn put(table: &mut dyn TableLike, key: &str, mut value: Value) {
    match table.get_mut(key) {
        Some(Item::Value(old)) => {
            *value.decor_mut() = old.decor().clone();
            *old = value;
        }
        _ => drop(table.insert(key, Item::Value(value))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DQuat;
    use seamwright_weld::Welding;

    const JOB: &str = include_str!("../../../examples/ellipse.toml");

    fn moved(job: &str, by: &DAffine3) -> PlacedText {
        let before = Welding::read("job.toml", job).unwrap();
        let placed = placed(job, &before.program, by).unwrap();
        let after = Welding::read("job.toml", &placed.text).unwrap_or_else(|e| panic!("{e}\n{}", placed.text));
        let passes = before.program.value.passes.len();
        for pass in 0..passes {
            let [a, b] = [&before, &after].map(|w| {
                let path = w.path(pass);
                seamwright_program::TorchPath::pose(&path, 0.3 * seamwright_program::TorchPath::length(&path))
            });
            assert!((by.transform_point3(a.point) - b.point).length() < 1e-5, "{}", placed.text);
            assert!((by.transform_vector3(a.direction) - b.direction).length() < 1e-7);
        }
        placed
    }

    #[test]
    fn a_job_without_an_offset_gets_a_placement() {
        let by = DAffine3::from_rotation_translation(DQuat::from_rotation_z(0.3), DVec3::new(10.0, -20.5, 0.0));
        let placed = moved(JOB, &by);
        assert_eq!(placed.key, "placement");
        assert!(placed.text.contains("# eccentric angle: the point (0, 16)"));
        // Back to where it was: only the table is more.
        let back = moved(&placed.text, &by.inverse());
        let more = back.text.replace("\n[placement]\nmove_mm = [0.0, 0.0, 0.0]\n", "");
        assert_eq!(more.trim_end(), JOB.trim_end());
    }

    #[test]
    fn comments_beside_the_values_stay() {
        let job = JOB.replace(
            "[start]",
            "# on the table\n[placement]\nmove_mm = [1, 2, 0]   # measured\nangle_deg = 30 # by eye\nturn = [0, 0, 1]\n\n[start]",
        );
        let placed = moved(&job, &DAffine3::from_translation(DVec3::new(1.5, 0.0, 0.0)));
        assert!(placed.text.contains("# on the table\n[placement]\nmove_mm = [2.5, 2.0, 0.0]   # measured\n"));
        assert!(placed.text.contains("# by eye"), "{}", placed.text);
    }

    #[test]
    fn an_offset_in_force_is_changed_and_copies_get_one() {
        let offset = JOB.replace("[start]", "[offsets.table-1]\nmove_mm = [1, 2, 0] # touched\n\n[start]");
        let offset = offset.replace("machine =", "offset = \"table-1\"\nmachine =");
        let by = DAffine3::from_rotation_translation(DQuat::from_rotation_z(-0.2), DVec3::new(5.0, 6.0, 0.0));
        let placed = moved(&offset, &by);
        assert_eq!(placed.key, "offsets.table-1");
        assert!(placed.text.contains("# touched"));
        let rows = JOB.replace("[start]", "[rows]\nrows = 1\ncolumns = 2\nstep_mm = [60, 0, 0]\n\n[start]");
        assert_eq!(moved(&rows, &by).key, "offsets.reach");
    }
}
