//! A work offset in a job file.

use glam::{DAffine3, DVec3};
use seamwright_document::{Direction, Finite, Point, Transform};
use toml_edit::{Array, DocumentMut, Item, Table, TomlError, value};

/// The offset as it is written: to a millionth of a mm, which is beyond any machine.
pub fn rounded(offset: &DAffine3) -> Option<Transform> {
    let exact = Transform::from_affine(offset)?;
    let angle_deg = Finite::new(round(exact.angle_deg.get(), 1e9))?;
    let turned = angle_deg.get() != 0.0;
    let turn = exact.turn.filter(|_| turned).and_then(|d| Direction::new(each(d.unit(), 1e9)));
    Some(Transform { move_mm: Point::new(each(exact.move_mm.get(), 1e6))?, turn, angle_deg })
}

fn round(v: f64, digits: f64) -> f64 {
    // `+ 0.0` turns a rounded negative zero into zero.
    (v * digits).round() / digits + 0.0
}

fn each(v: DVec3, digits: f64) -> DVec3 {
    DVec3::new(round(v.x, digits), round(v.y, digits), round(v.z, digits))
}

/// The text of a job or program with `offset` under `name`, in force; `None` if its `offsets` is not a table.
///
/// # Errors
/// A text that is not TOML.
pub fn put_into(text: &str, name: &str, offset: &Transform) -> Result<Option<String>, TomlError> {
    let mut document: DocumentMut = text.parse()?;
    Ok(put(&mut document, name, offset).map(|()| document.to_string()))
}

/// Writes `offset` into a job or program under `name`, replacing one of that name, and makes it the one in force.
/// `None` if the file's `offsets` is not a table.
fn put(document: &mut DocumentMut, name: &str, offset: &Transform) -> Option<()> {
    document["offset"] = value(name);
    let offsets = document.entry("offsets").or_insert_with(|| {
        let mut parent = Table::new();
        parent.set_implicit(true);
        Item::Table(parent)
    });
    let mut table = table(offset);
    let offsets = offsets.as_table_like_mut()?;
    match offsets.get_mut(name) {
        // The table keeps its position and the comment over it.
        Some(Item::Table(old)) => {
            *table.decor_mut() = old.decor().clone();
            table.set_position(old.position());
            *old = table;
        }
        _ => {
            offsets.insert(name, Item::Table(table));
        }
    }
    Some(())
}

fn table(offset: &Transform) -> Table {
    let array = |v: DVec3| value(v.to_array().into_iter().collect::<Array>());
    let mut table = Table::new();
    table["move_mm"] = array(offset.move_mm.get());
    if let Some(turn) = offset.turn {
        table["turn"] = array(each(turn.unit(), 1e9));
        table["angle_deg"] = value(offset.angle_deg.get());
    }
    table
}

/// The lines to paste into a job.
pub fn fragment(name: &str, offset: &Transform) -> String {
    let mut document = DocumentMut::new();
    put(&mut document, name, offset).map_or_else(String::new, |()| document.to_string())
}
