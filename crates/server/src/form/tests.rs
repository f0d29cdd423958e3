use super::*;
use crate::wire::RangeView;
use seamwright_document::Positive;
use seamwright_project::examples::EXAMPLES;
use serde_json::json;

#[allow(clippy::needless_pass_by_value, reason = "changes are written in the call")]
fn ask(text: &str, changes: Value) -> FormAnswer {
    answer(serde_json::from_value(json!({ "text": text, "changes": changes })).unwrap()).unwrap()
}

fn table<'a>(answer: &'a FormAnswer, path: &str) -> &'a FormTable {
    answer.form.as_ref().unwrap().tables.iter().find(|table| table.path == path).unwrap()
}

fn example(name: &str) -> &'static str {
    EXAMPLES.iter().find(|example| example.name == name).unwrap().text
}

/// A format with a key that no program knows.
#[derive(schemars::JsonSchema)]
#[expect(dead_code, reason = "only its schema is used")]
struct Invented {
    /// Ripples.
    ripple: Option<Ripple>,
}

/// Ripples of the cap.
#[derive(schemars::JsonSchema)]
#[expect(dead_code, reason = "only its schema is used")]
struct Ripple {
    /// Height of the ripples, mm.
    ripple_mm: Positive,
    /// Form of the ripples.
    #[schemars(default)]
    form: Option<Form>,
}

#[derive(schemars::JsonSchema)]
#[schemars(rename_all = "snake_case")]
#[expect(dead_code, reason = "only its schema is used")]
enum Form {
    Round,
    Sharp,
}

static INVENTED: LazyLock<Format> = LazyLock::new(|| Format::new::<Invented>(|_| None));

/// A new key of a type needs no other code: it can be added, has its range and help, and a change of it is in the text.
#[test]
fn a_new_key_of_a_format_is_in_its_form() {
    let ask = |text: &str, changes: Value| {
        let form = serde_json::from_value(json!({ "text": text, "changes": changes })).unwrap();
        answered(form, |_| &INVENTED).unwrap()
    };
    let empty = ask("", json!([]));
    let [ripple] = &table(&empty, "").addable[..] else { panic!("{empty:?}") };
    assert_eq!((ripple.path.as_str(), ripple.help.as_str(), ripple.is_table), ("ripple", "Ripples.", true));
    let added = ask("", json!([{ "op": "add", "path": "ripple" }, { "op": "add", "path": "ripple.form" }]));
    let [height, form] = &table(&added, "ripple").entries[..] else { panic!("{added:?}") };
    assert_eq!((height.key.as_str(), height.help.as_str()), ("ripple_mm", "Height of the ripples, mm."));
    assert_eq!(height.range, Some(RangeView { min: Some(0.0), open: true, max: Some(1e6) }));
    assert_eq!(form.choices, ["round", "sharp"]);
    let set = ask(&added.text, json!([{ "op": "set", "path": "ripple.ripple_mm", "value": 0.25 }]));
    assert!(set.text.contains("[ripple]\nripple_mm = 0.25\nform = \"round\"\n"), "{}", set.text);
}

#[test]
fn keys_of_tables_and_of_inline_tables_can_be_added_with_what_they_mean() {
    let text = example("hillside");
    let shell = "seam.nozzle.body.cylinder";
    let answer = ask(text, json!([]));
    let thickness = table(&answer, shell).addable.iter().find(|of| of.key == "thickness_mm").unwrap();
    assert!(thickness.help.contains("Thickness of the wall"));
    let made = ask(text, json!([{ "op": "add", "path": thickness.path }]));
    assert_eq!(made.text.replace("thickness_mm = 1\n", ""), text);
    assert!(table(&made, shell).addable.iter().all(|of| of.key != "thickness_mm"));
    let root = table(&answer, "beads").entries.iter().find(|entry| entry.key == "root").unwrap();
    let FormValue::Table { entries, addable } = &root.value else { panic!("{root:?}") };
    assert!(
        entries.iter().any(|entry| entry.path == "beads.root.process") && addable.iter().any(|of| of.key == "weave")
    );
    // A second kind of body is not offered.
    assert_eq!(table(&answer, "seam.nozzle.body.cylinder").kinds, Vec::<String>::new());
}

/// In every example, what a table has is not offered, and everything that is offered can be added and is still a form.
#[test]
fn everything_that_is_offered_can_be_added() {
    for example in EXAMPLES {
        let answer = ask(example.text, json!([]));
        assert_eq!(answer.wrong, None, "{}", example.name);
        for table in &answer.form.unwrap().tables {
            for of in &table.addable {
                assert!(table.entries.iter().all(|entry| entry.key != of.key), "{}: {}", example.name, of.path);
                let made = ask(example.text, json!([{ "op": "add", "path": of.path }]));
                assert!(made.form.is_some() && made.text.len() > example.text.len(), "{}: {}", example.name, of.path);
            }
        }
    }
}

#[test]
fn another_kind_of_joint_keeps_the_sizes_that_both_have() {
    let text = example("thick-saddle");
    let path = "joint.preparation.t_bevel";
    let before = ask(text, json!([]));
    assert_eq!(table(&before, path).kinds.len(), 16);
    let made = ask(text, json!([{ "op": "choose", "path": path, "kind": "bevel" }]));
    assert_eq!(made.wrong, None, "{}", made.text);
    let keys: Vec<&str> =
        table(&made, "joint.preparation.bevel").entries.iter().map(|entry| entry.key.as_str()).collect();
    assert_eq!(keys, ["prepared", "thickness_mm", "root_gap_mm", "root_face_mm", "angle_deg"]);
    assert!(made.text.contains("thickness_mm = 12   ") && made.text.contains("[tacks]\ncount = 4"));
    assert!(table(&made, "joint").removable && !table(&made, "seam.nozzle").removable);
    let without = ask(text, json!([{ "op": "remove", "path": "joint" }])).text;
    assert!(!without.contains("joint") && without.contains("\n\n[tacks]"));
}

#[test]
fn choices_and_long_lists_are_those_of_the_format() {
    let answer = ask(example("points"), json!([]));
    let span = table(&answer, "passes[0].points.spans[0]");
    let along = span.entries.iter().find(|entry| entry.key == "along").unwrap();
    assert!(along.choices.contains(&"rapid".to_owned()) && along.choices.len() == 6);
    let start = table(&answer, "passes[0].points").entries.iter().find(|entry| entry.key == "columns").unwrap();
    assert!(matches!(start.value, FormValue::Long { count } if count > MAX_ITEMS), "{start:?}");
    assert_eq!(answer.form.unwrap().passes[0].rows.len(), 8);
}

#[test]
fn what_is_wrong_has_its_line_also_where_there_is_no_form() {
    let text = example("saddle");
    let wrong = ask(&text.replace("radius_mm = 250", "radius_mm = -1"), json!([]));
    let fault = wrong.wrong.unwrap();
    assert_eq!((fault.key.as_str(), fault.line.is_some(), wrong.form.is_some()), ("seam.nozzle.radius_mm", true, true));
    let broken = ask("title = \"x\nmachine = 1\n", json!([]));
    let fault = broken.wrong.unwrap();
    assert_eq!((fault.line, broken.form), (Some(1), None));
    assert!(!fault.what.text.is_empty());
    let form = json!({ "text": text, "changes": [{ "op": "add", "path": "no.such.key" }] });
    assert_eq!(answer(serde_json::from_value(form).unwrap()).unwrap_err().message.code, "document-unfit-change");
}

#[test]
fn solids_of_every_shape_are_added_and_go_without_a_trace() {
    let text = example("saddle");
    for list in ["fixtures", "part.solids"] {
        for shape in ["box", "cylinder", "sphere", "cone", "capsule", "ellipsoid"] {
            let at = format!("{list}[0]");
            let made = ask(
                text,
                json!([
                    { "op": "insert", "path": at, "value": { "name": "x" } },
                    { "op": "add", "path": format!("{at}.shape.{shape}") },
                    { "op": "set", "path": format!("{at}.at.move_mm"), "value": [10, 20, 0] }
                ]),
            );
            assert_eq!(made.wrong, None, "{list} {shape}");
            assert_eq!(ask(&made.text, json!([{ "op": "remove", "path": at }])).text, text, "{list} {shape}");
        }
    }
}

#[test]
fn a_form_has_a_bounded_number_of_tables() {
    let many = |header: fn(usize) -> String| -> String { (0..=MAX_FORM_TABLES).map(header).collect() };
    let (passes, offsets) = (many(|_| "[[passes]]\n".into()), many(|i| format!("[offsets.o{i}]\n")));
    let tables = |text: &str| ask(text, json!([])).form.unwrap().tables.len();
    assert_eq!((tables(&passes), tables(&offsets)), (MAX_FORM_TABLES + 1, MAX_FORM_TABLES));
    assert_eq!(tables(&(passes + "[offsets.last]\n")), MAX_FORM_TABLES + 2);
}
