//! The work moved in a job file, as a person would write it.
//!
//! - With a work offset in force, that offset is changed.
//! - Otherwise `[placement]` is changed, where the seam stands at one place.
//! - A job with copies or rows gets a work offset, which moves all of them.
//!
//! The base of a machine is moved in its machine file: the first `[[work]]` step is displaced the other way, because the
//! chains to torch and work both start at the base. Frames and shapes of the base go with it.

use crate::failure::Failure;
use crate::work_offset::{put_into, rounded};
use glam::{DAffine3, DVec3};
use seamwright_document::{Document, Transform};
use seamwright_machine::MachineFile;
use seamwright_message::Message;
use seamwright_program::Program;
use toml_edit::{Array, DocumentMut, InlineTable, Item, Table, TableLike, Value};

/// Name of the work offset of a job with copies.
const OFFSET: &str = "reach";

/// The text of a job with its work moved, or of a machine file with its base moved.
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

/// Key of the displacement from the base to the work.
const FIRST_STEP: &str = "work[0].fixed";

/// Moves the base of the machine `text`, read as `machine` from `file`, by the rigid displacement `by` in the base frame.
/// Comments and all other entries stay.
///
/// # Errors
/// A file in which `work` is not an array of tables, or a displacement that no number can hold.
pub fn placed_base(text: &str, file: &str, machine: &MachineFile, by: &DAffine3) -> Result<PlacedText, Failure> {
    let first = machine.work.first().and_then(|step| step.fixed);
    let moved = by.inverse() * first.unwrap_or_default().affine();
    let transform = rounded(&moved).ok_or_else(|| unchangeable(file, FIRST_STEP))?;
    let text = match first {
        Some(_) => set_first_step(text, &transform),
        None => Some(with_first_step(text, &transform)),
    };
    let text = text.ok_or_else(|| unchangeable(file, FIRST_STEP))?;
    Ok(PlacedText { text, key: FIRST_STEP.to_owned(), transform })
}

/// The text with `transform` in the first `[[work]]` step; none if the step is not a table.
fn set_first_step(text: &str, transform: &Transform) -> Option<String> {
    let mut document: DocumentMut = text.parse().ok()?;
    let step = document.get_mut("work")?.as_array_of_tables_mut()?.get_mut(0)?;
    write(step.get_mut("fixed")?.as_table_like_mut()?, transform);
    Some(document.to_string())
}

/// The text with a new first `[[work]]` step.
fn with_first_step(text: &str, transform: &Transform) -> String {
    let step = format!("[[work]]\nfixed = {}\n\n", inline(transform));
    let mut at = 0;
    for line in text.split_inclusive('\n') {
        if line.trim_start().starts_with("[[work]]") {
            return format!("{}{step}{}", &text[..at], &text[at..]);
        }
        at += line.len();
    }
    format!("{}\n\n{}\n", text.trim_end(), step.trim_end())
}

/// The displacement as an inline table.
pub fn inline(transform: &Transform) -> String {
    let mut table = InlineTable::new();
    write(&mut table, transform);
    table.to_string().trim().to_owned()
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
    write(table, transform);
    Some(document.to_string())
}

/// Writes `transform` into a table; comments beside old values stay.
fn write(table: &mut dyn TableLike, transform: &Transform) {
    let array = |v: DVec3| Value::from(v.to_array().into_iter().collect::<Array>());
    put(table, "move_mm", array(transform.move_mm.get()));
    match transform.turn {
        Some(turn) => {
            put(table, "turn", array(turn.unit()));
            put(table, "angle_deg", Value::from(transform.angle_deg.get()));
        }
        None => ["turn", "angle_deg"].into_iter().for_each(|key| drop(table.remove(key))),
    }
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
    use seamwright_machine::Machine;
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

    /// The frames of torch and work of `text` in the base frame at home.
    fn home_frames(text: &str) -> [DAffine3; 2] {
        let machine = Machine::read("m.toml", text).unwrap_or_else(|e| panic!("{e}\n{text}"));
        let home = machine.home();
        let base = machine.links.named().iter().find(|frame| frame.name == "base").unwrap();
        let work_in_base = (machine.link_frames(&home)[machine.links.base()] * base.zero).inverse();
        [work_in_base * machine.mount_frame(0, &home), work_in_base]
    }

    /// Moving the base by T leaves the torch where it is in the base frame, and moves the work by the inverse of T.
    #[test]
    fn a_moved_base_is_the_work_moved_the_other_way() {
        let by = DAffine3::from_rotation_translation(DQuat::from_rotation_z(0.3), DVec3::new(10.0, -20.5, 35.0));
        for name in ["irb-2600", "irb-2600-positioner", "irb-2600-rail", "ur10e", "saddle-4axis", "table-tilting-xyzac"]
        {
            let before = seamwright_machine::shipped(name).unwrap().text;
            let file = seamwright_machine::MachineFile::read("m.toml", before).unwrap().value;
            let placed = placed_base(before, "m.toml", &file, &by).unwrap();
            let ([torch, work], [moved_torch, moved_work]) = (home_frames(before), home_frames(&placed.text));
            assert!(moved_torch.abs_diff_eq(torch, 1e-9), "{name}");
            assert!(moved_work.abs_diff_eq(by.inverse() * work, 1e-5), "{name}: {}", placed.text);
            let comments = |text: &str| text.lines().filter(|line| line.contains('#')).count();
            assert_eq!(comments(&placed.text), comments(before), "{name}");
        }
    }
}
