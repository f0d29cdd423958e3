use crate::wire::{PointRow, PointsView};
use serde::Deserialize;
use serde::de::IgnoredAny;

/// As much of a program as its points need; whether it is valid does not matter here.
#[derive(Deserialize)]
struct Text {
    #[serde(default)]
    passes: Vec<Pass>,
}

#[derive(Deserialize)]
struct Pass {
    points: Option<Points>,
}

#[derive(Deserialize)]
struct Points {
    #[serde(default)]
    columns: Vec<String>,
    #[serde(default = "yes")]
    arc: bool,
    #[serde(default)]
    start: Vec<Cell>,
    #[serde(default)]
    spans: Vec<Span>,
}

#[derive(Deserialize)]
struct Span {
    #[serde(default)]
    along: String,
    #[serde(default)]
    points: Vec<Vec<Cell>>,
    #[serde(default)]
    speeds: Vec<Vec<Cell>>,
}

#[derive(Deserialize)]
#[serde(untagged)]
enum Cell {
    Number(f64),
    Expression(IgnoredAny),
}

fn yes() -> bool {
    true
}

fn numbers(cells: &[Cell]) -> Vec<Option<f64>> {
    cells.iter().map(|cell| if let Cell::Number(number) = cell { Some(*number) } else { None }).collect()
}

/// Returns the passes through points of a text.
pub(super) fn passes(text: &str) -> Vec<PointsView> {
    let passes = toml::from_str::<Text>(text).map(|text| text.passes).unwrap_or_default();
    let of = |(i, pass): (usize, Pass)| pass.points.map(|points| view(i + 1, points));
    passes.into_iter().enumerate().filter_map(of).collect()
}

fn view(pass: usize, points: Points) -> PointsView {
    let mut rows = Vec::new();
    let row = |along: &str, span, cells: &[Cell]| PointRow {
        along: along.to_owned(),
        span,
        numbers: numbers(cells),
        speeds: Vec::new(),
    };
    rows.push(row("", 0, &points.start));
    for (i, span) in points.spans.iter().enumerate() {
        // The first speeds are those at which the span begins.
        let mut speeds = span.speeds.iter().map(|speeds| numbers(speeds));
        if let (Some(first), Some(before)) = (speeds.next(), rows.last_mut())
            && before.speeds.is_empty()
        {
            before.speeds = first;
        }
        for cells in &span.points {
            rows.push(PointRow { speeds: speeds.next().unwrap_or_default(), ..row(&span.along, i + 1, cells) });
        }
    }
    let says_place = |name: &&String| match name.as_str() {
        "x_mm" | "y_mm" | "z_mm" | "ax" | "ay" | "az" => true,
        name => !name.contains('_') && name != "n",
    };
    let is_cubic = rows.iter().any(|row| !row.speeds.is_empty());
    let moving = points.columns.iter().filter(|name| is_cubic && says_place(name)).cloned().collect();
    PointsView { pass, columns: points.columns, arc: points.arc, moving, rows }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "[[passes]]\n[passes.points]\ncolumns = [\"x\", \"b\", \"n\", \"current_a\", \"time_s\"]\n\
                        start = [0, 0, 0, 50, 0]\n[[passes.points.spans]]\nalong = \"cubic\"\n\
                        speeds = [[1, 2], [3, \"= v\"], [5, 6]]\npoints = [[1, 0, 10, 50, 1], [2, 0, 20, 50, 1]]\n\
                        [[passes.points.spans]]\nalong = \"line\"\npoints = [[3, 0, 30, 50, 1]]\n\
                        [[passes.points.spans]]\nalong = \"cubic\"\npoints = [[4, 0, 40, 50, 1]]\n\
                        speeds = [[7, 8], [9, 0]]\n";

    #[test]
    fn points_of_cubics_have_the_speeds_at_which_they_are_reached_or_left() {
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
        let spline = TEXT.replace("cubic", "spline").replace("speeds", "old_speeds");
        assert!(passes(&spline)[0].moving.is_empty() && passes("title = 1\n").is_empty());
    }
}
