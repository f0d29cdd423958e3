//! Outputs of a pass whose ways are reordered stay on over the same ways.

use seamwright_program::edit::Editor;
use serde_json::{Value, json};

/// Points after which output 1 goes on and off once the operations were applied to a closed run of ten ways, from those
/// before.
fn reordered(steps: &[(usize, bool)], operations: &[Value]) -> Vec<(usize, bool)> {
    let events = steps.iter().map(|(after, on)| format!("{{ after = {after}, output = 1, on = {on} }}"));
    let rows = (1..=10).map(|k| format!("[{}, 0, 0, 1]", k % 10));
    let text = format!(
        "schema = 1\ntitle = \"t\"\nmachine = \"m\"\n[[passes]]\nname = \"root\"\n[passes.points]\n\
         columns = [\"x_mm\", \"y_mm\", \"z_mm\", \"time_s\"]\nstart = [0, 0, 0, 0]\nevents = [{}]\n\
         [[passes.points.spans]]\nalong = \"line\"\npoints = [{}]\n",
        events.collect::<Vec<_>>().join(", "),
        rows.collect::<Vec<_>>().join(", ")
    );
    let mut editor = Editor::new("p.toml", &text).unwrap_or_else(|e| panic!("{e}"));
    for operation in operations {
        editor.apply(&serde_json::from_value(operation.clone()).unwrap()).unwrap_or_else(|e| panic!("{e}"));
    }
    let points = editor.program().passes[0].points.as_ref().unwrap();
    points.events.iter().map(|event| (event.after, event.on.unwrap())).collect()
}

#[test]
fn what_is_on_stays_on() {
    let reverse = json!({"op": "reverse_pass", "pass": 1});
    let turned = |steps: &[(usize, bool)]| reordered(steps, std::slice::from_ref(&reverse));
    assert_eq!(turned(&[(3, true), (7, false)]), [(3, true), (7, false)]);
    assert_eq!(turned(&[(2, true), (3, false)]), [(7, true), (8, false)]);
    assert_eq!(turned(&[(0, true), (10, false)]), [(0, true), (10, false)]);
    assert_eq!(turned(&[(0, true)]), [(0, true)]);
    assert_eq!(turned(&[(4, true)]), [(0, true), (6, false)]);
    let twice = reordered(&[(4, true)], &[reverse.clone(), reverse.clone()]);
    assert_eq!(twice, [(0, false), (4, true), (10, false)]);
    assert_eq!(turned(&[(10, true)]), [(10, true)]);
    let shifted = |steps: &[(usize, bool)]| reordered(steps, &[json!({"op": "shift_start", "pass": 1, "point": 4})]);
    assert_eq!(shifted(&[(0, true), (10, false)]), [(0, true), (10, false)]);
    assert_eq!(shifted(&[(2, true), (5, false)]), [(0, true), (1, false), (8, true), (10, false)]);
}
