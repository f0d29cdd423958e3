use crate::wire::{PointRow, PointsView};
use seamwright_document::{Entry, EntryValue, TableEntries};
use std::collections::HashMap;

/// Entries of the tables that have a header, by path.
type Tables<'a> = HashMap<&'a str, &'a [Entry]>;

/// Returns the entries of a table, which has a header of its own or stands in one line in the table above.
fn entries<'a>(tables: &Tables<'a>, path: &str) -> Option<&'a [Entry]> {
    if let Some(entries) = tables.get(path) {
        return Some(entries);
    }
    if path.is_empty() {
        return None;
    }
    let (path, nth) = path.strip_suffix(']').and_then(|path| path.rsplit_once('[')).unwrap_or((path, ""));
    let (above, key) = path.rsplit_once('.').unwrap_or(("", path));
    let value = value(entries(tables, above)?, key)?;
    let element = nth.parse().ok().and_then(|nth: usize| items(value).get(nth));
    if let EntryValue::Table(entries) = element.unwrap_or(value) { Some(entries) } else { None }
}

fn value<'a>(entries: &'a [Entry], key: &str) -> Option<&'a EntryValue> {
    entries.iter().find(|entry| entry.key == key).map(|entry| &entry.value)
}

fn items(value: &EntryValue) -> &[EntryValue] {
    if let EntryValue::List(items) = value { items } else { &[] }
}

fn list<'a>(entries: &'a [Entry], key: &str) -> &'a [EntryValue] {
    value(entries, key).map_or(&[], items)
}

fn text(value: &EntryValue) -> Option<String> {
    if let EntryValue::Text(text) = value { Some(text.clone()) } else { None }
}

/// Returns numbers; `None` for expressions.
fn numbers(cells: &[EntryValue]) -> Vec<Option<f64>> {
    cells.iter().map(|cell| if let EntryValue::Number(number) = cell { Some(*number) } else { None }).collect()
}

/// Returns the passes through points of a text; whether it is valid does not matter here.
pub(super) fn passes(tables: &[TableEntries]) -> Vec<PointsView> {
    let tables = &tables.iter().map(|table| (table.path.as_str(), &table.entries[..])).collect();
    let passes = (0..).map(|i| format!("passes[{i}]")).take_while(|path| entries(tables, path).is_some());
    let of = |(i, path): (usize, String)| {
        let path = format!("{path}.points");
        let points = entries(tables, &path)?;
        let spans = (0..).map_while(|i| entries(tables, &format!("{path}.spans[{i}]")));
        Some(view(i + 1, points, spans))
    };
    passes.enumerate().filter_map(of).collect()
}

fn view<'a>(pass: usize, points: &[Entry], spans: impl Iterator<Item = &'a [Entry]>) -> PointsView {
    let mut rows = Vec::new();
    let row = |along: &str, span, cells: &[EntryValue]| PointRow {
        along: along.to_owned(),
        span,
        numbers: numbers(cells),
        speeds: Vec::new(),
    };
    rows.push(row("", 0, list(points, "start")));
    for (i, span) in spans.enumerate() {
        let along = value(span, "along").and_then(text).unwrap_or_default();
        // The first speeds are those at which the span begins.
        let mut speeds = list(span, "speeds").iter().map(|speeds| numbers(items(speeds)));
        if let (Some(first), Some(before)) = (speeds.next(), rows.last_mut())
            && before.speeds.is_empty()
        {
            before.speeds = first;
        }
        for cells in list(span, "points") {
            rows.push(PointRow { speeds: speeds.next().unwrap_or_default(), ..row(&along, i + 1, items(cells)) });
        }
    }
    let columns: Vec<String> = list(points, "columns").iter().filter_map(text).collect();
    let arc = !matches!(value(points, "arc"), Some(EntryValue::Truth(false)));
    let says_place = |name: &&String| match name.as_str() {
        "x_mm" | "y_mm" | "z_mm" | "ax" | "ay" | "az" => true,
        name => !name.contains('_') && name != "n",
    };
    let is_cubic = rows.iter().any(|row| !row.speeds.is_empty());
    let moving = columns.iter().filter(|name| is_cubic && says_place(name)).cloned().collect();
    PointsView { pass, columns, arc, moving, rows }
}

#[cfg(test)]
mod tests {
    use super::*;
    use seamwright_document::TomlText;

    const TEXT: &str = "[[passes]]\n[passes.points]\ncolumns = [\"x\", \"b\", \"n\", \"current_a\", \"time_s\"]\n\
                        start = [0, 0, 0, 50, 0]\n[[passes.points.spans]]\nalong = \"cubic\"\n\
                        speeds = [[1, 2], [3, \"= v\"], [5, 6]]\npoints = [[1, 0, 10, 50, 1], [2, 0, 20, 50, 1]]\n\
                        [[passes.points.spans]]\nalong = \"line\"\npoints = [[3, 0, 30, 50, 1]]\n\
                        [[passes.points.spans]]\nalong = \"cubic\"\npoints = [[4, 0, 40, 50, 1]]\n\
                        speeds = [[7, 8], [9, 0]]\n";

    #[test]
    fn points_of_cubics_have_the_speeds_at_which_they_are_reached_or_left() {
        let passes = |text: &str| passes(&TomlText::parse("job.toml", text).unwrap().entries());
        let [pass] = &passes(TEXT)[..] else { panic!() };
        assert_eq!(pass.moving, ["x", "b"]);
        let speeds: Vec<_> = pass.rows.iter().map(|row| &row.speeds[..]).collect();
        let expected: [&[Option<f64>]; 5] = [
            &[Some(1.0), Some(2.0)],
            &[Some(3.0), None],
            &[Some(5.0), Some(6.0)],
            &[Some(7.0), Some(8.0)],
            &[Some(9.0), Some(0.0)],
        ];
        assert_eq!(speeds, expected);
        let ways: Vec<_> = pass.rows.iter().map(|row| (row.span, row.along.as_str())).collect();
        assert_eq!(ways, [(0, ""), (1, "cubic"), (1, "cubic"), (2, "line"), (3, "cubic")]);
        let in_line = "passes = [{ points = { columns = [\"x\"], arc = false, start = [0], spans = [{ along = \"line\", \
                       points = [[1], [\"= v\"]] }] } }]\n";
        let [pass] = &passes(in_line)[..] else { panic!() };
        assert_eq!((&pass.columns[..], pass.arc, pass.rows.len()), (&["x".to_owned()][..], false, 3));
        assert_eq!([&pass.rows[1].numbers, &pass.rows[2].numbers], [&[Some(1.0)], &[None]]);
        let spline = TEXT.replace("cubic", "spline").replace("speeds", "old_speeds");
        assert!(passes(&spline)[0].moving.is_empty() && passes("title = 1\n").is_empty());
    }
}
