use super::*;
use serde_json::json;

fn changed(text: &str, change: Given) -> Result<String, DocumentError> {
    let changes = [serde_json::from_value(change).unwrap()];
    Ok(TomlText::parse("x.toml", text)?.changed("x.toml", &changes)?.text)
}

fn make(text: &str, change: Given) -> String {
    changed(text, change).unwrap()
}

#[allow(clippy::needless_pass_by_value, reason = "values are written in the call")]
fn set(text: &str, path: &str, value: Given) -> String {
    make(text, json!({ "op": "set", "path": path, "value": value }))
}

fn remove(text: &str, path: &str) -> String {
    make(text, json!({ "op": "remove", "path": path }))
}

#[allow(clippy::needless_pass_by_value, reason = "values are written in the call")]
fn insert(text: &str, path: &str, value: Given) -> String {
    make(text, json!({ "op": "insert", "path": path, "value": value }))
}

#[test]
fn a_value_is_set_and_everything_else_stays() {
    let text = "# top\r\na = 1   # one\r\n[t]\r\nb = [ 1,\t2 ]\r\nc = { x = 1, y = { z = \"q\" } } # c\r\n";
    assert_eq!(set(text, "a", json!(2.5)), text.replace("a = 1", "a = 2.5"));
    assert_eq!(set(text, "t.b[1]", json!(-3)), text.replace("\t2", "\t-3"));
    assert_eq!(set(text, "t.c.y.z", json!("a \"b\"")).matches("a \"b\"").count(), 1);
    assert_eq!(set(text, "t.b", json!([true, 1e30])), text.replace("[ 1,\t2 ]", "[true, 1e30]"));
}

#[test]
fn a_key_is_added_to_the_table_that_it_belongs_to() {
    assert_eq!(set("a = 1\n[t]\nb = 2\n", "c", json!(3)), "a = 1\nc = 3\n[t]\nb = 2\n");
    assert_eq!(set("[t]\nx.b = 2 # why\n", "t.x.c", json!(3)), "[t]\nx.b = 2 # why\nx.c = 3\n");
    assert_eq!(set("[t]\nb = [\n 1,\n 2,\n]", "t.c", json!(3)), "[t]\nb = [\n 1,\n 2,\n]\nc = 3");
    assert_eq!(set("[t]\n[u]\n", "t.c", json!(3)), "[t]\nc = 3\n[u]\n");
    assert_eq!(set("a = 1\r\n", "b", json!(3)), "a = 1\r\nb = 3\r\n");
    assert_eq!(set("r = { a = 1 } # r\n", "r.w", json!({ "x": 1 })), "r = { a = 1, w = { x = 1 } } # r\n");
    assert_eq!(set("r = {}\n", "r.a", json!(1)), "r = { a = 1 }\n");
    assert_eq!(set("[[f]]\nn = 1\n", "f[0].at.move_mm", json!([1, 2])), "[[f]]\nn = 1\nat = { move_mm = [1, 2] }\n");
    let joint = json!({ "cap_mm": 0, "preparation": { "v": { "angle_deg": 60 } } });
    let added = "a = 1\n\n[joint]\ncap_mm = 0\n\n[joint.preparation.v]\nangle_deg = 60\n";
    assert_eq!(set("a = 1\n", "joint", joint), added);
    assert_eq!(remove(added, "joint"), "a = 1\n");
}

#[test]
fn what_is_removed_takes_its_own_lines_along() {
    assert_eq!(remove("a = 1\nb = 2 # two\nc = 3\n", "b"), "a = 1\nc = 3\n");
    assert_eq!(remove("r = { a = 1, b = 2, c = 3 }\n", "r.b"), "r = { a = 1, c = 3 }\n");
    assert_eq!(remove("r = { a = 1, b = 2 }\n", "r.b"), "r = { a = 1 }\n");
    assert_eq!(remove("l = [\n  1, # a\n  2, # b\n]\n", "l[0]"), "l = [\n  2, # b\n]\n");
    assert_eq!(remove("l = [1, 2, 3]\n", "l[2]"), "l = [1, 2]\n");
    let text = "[a]\nx = 1\n\n# of b\n[b]\ny = [\n  [1, 2],\n]\n";
    assert_eq!(remove(text, "a"), "# of b\n[b]\ny = [\n  [1, 2],\n]\n");
    assert_eq!(remove(text, "b"), "[a]\nx = 1\n");
    assert_eq!(remove("[[f]]\nat.x = 1\nat.y = 2\nn = 1\n", "f[0].at"), "[[f]]\nn = 1\n");
}

#[test]
fn comments_stay_with_what_they_describe() {
    // Tables: those directly above go along, those of others and of the file stay.
    let text = "# file\n[a]\nx = 1\n# y = 2\n\n# loose\n\n# of b\n[b]\nx = 1\n\n# end\n";
    assert_eq!(remove(text, "a"), "# file\n# loose\n\n# of b\n[b]\nx = 1\n\n# end\n");
    assert_eq!(remove(text, "b"), "# file\n[a]\nx = 1\n# y = 2\n\n# loose\n\n# end\n");
    let list = "t = 1\n\n# one\n[[f]]\nn = 1\n\n# two\n[[f]]\nn = 2\n";
    let swapped = "t = 1\n\n# two\n[[f]]\nn = 2\n\n# one\n[[f]]\nn = 1\n";
    assert_eq!(make(list, json!({ "op": "move", "path": "f[0]", "to": 1 })), swapped);
    // Elements of lists.
    let lines = "l = [\n  # one\n  1, # a\n  # two\n  2 # b\n]\n";
    assert_eq!(remove(lines, "l[0]"), "l = [\n  # two\n  2 # b\n]\n");
    assert_eq!(insert(lines, "l[1]", json!(3)), "l = [\n  # one\n  1, # a\n  3,\n  # two\n  2 # b\n]\n");
    assert_eq!(insert(lines, "l[2]", json!(3)), "l = [\n  # one\n  1, # a\n  # two\n  2, # b\n  3\n]\n");
    let moved = make(lines, json!({ "op": "move", "path": "l[1]", "to": 0 }));
    assert_eq!(moved, "l = [\n  # two\n  2, # b\n  # one\n  1, # a\n]\n");
    assert_eq!(remove("l = [1, # a\n  # two\n  2]\n", "l[0]"), "l = [\n  # two\n  2]\n");
    assert_eq!(remove("l = [1, 2, # both\n  3]\n", "l[1]"), "l = [1, # both\n  3]\n");
    assert_eq!(remove("l = [\n  1, # a\n  2]\n", "l[1]"), "l = [\n  1, # a\n  ]\n");
    assert_eq!(remove("l = [1,]\n", "l[0]"), "l = []\n");
    assert_eq!(insert("l = [\n  # none\n]\n", "l[0]", json!(1)), "l = [\n  # none\n1]\n");
}

#[test]
fn elements_of_lists_are_inserted_removed_and_moved() {
    assert_eq!(insert("l = [1, 3]\n", "l[1]", json!(2)), "l = [1, 2, 3]\n");
    assert_eq!(insert("l = []\n", "l[0]", json!(2)), "l = [2]\n");
    let rows = "l = [\n  [1, 2], # a\n  [3, 4],\n]\n";
    let longer = insert(rows, "l[2]", json!([5, 6]));
    assert_eq!(longer, "l = [\n  [1, 2], # a\n  [3, 4],\n  [5, 6],\n]\n");
    assert_eq!(remove(&longer, "l[2]"), rows);
    assert_eq!(make("l = [1, 2, 3]\n", json!({ "op": "move", "path": "l[0]", "to": 2 })), "l = [2, 3, 1]\n");
    let text = "t = 1\n\n# one\n[[f]]\nn = 1\n\n# two\n[[f]]\nn = 2\n[f.at]\nx = 1\n\n[w]\n";
    let third = insert(text, "f[2]", json!({ "n": 3 }));
    assert_eq!(third, text.replace("[w]", "[[f]]\nn = 3\n\n[w]"));
    assert_eq!(remove(&third, "f[2]"), text);
    assert!(!remove(text, "f[1]").contains("x = 1"));
    assert_eq!(insert("a = 1\n", "f[0]", json!({ "n": 1 })), "a = 1\n\n[[f]]\nn = 1\n");
    let moved = make(text, json!({ "op": "move", "path": "f[1]", "to": 0 }));
    let order: Vec<usize> = ["n = 2", "x = 1", "n = 1"].iter().map(|line| moved.find(line).unwrap()).collect();
    assert!(order.is_sorted() && moved.contains("# two\n[[f]]\nn = 2"), "{moved}");
}

#[test]
fn a_key_gets_another_name() {
    let rename = |text: &str, path: &str| make(text, json!({ "op": "rename", "path": path, "key": "z" }));
    assert_eq!(rename("[a.b] # why\nx = 1\n[a.b.c]\n", "a.b"), "[a.z] # why\nx = 1\n[a.z.c]\n");
    assert_eq!(rename("s = { b = { x = 1 } }\n", "s.b"), "s = { z = { x = 1 } }\n");
    assert_eq!(rename("s.b = { x = 1 }\n", "s.b"), "s.z = { x = 1 }\n");
}

#[test]
fn what_is_not_there_or_does_not_fit_is_refused() {
    let text = "a = 1\n[t]\nl = [1]\n";
    for (change, code) in [
        (json!({ "op": "remove", "path": "b" }), "document-no-such-entry"),
        (json!({ "op": "remove", "path": "t.l[1]" }), "document-no-such-entry"),
        (json!({ "op": "set", "path": "t", "value": 1 }), "document-unfit-change"),
        (json!({ "op": "set", "path": "a.b", "value": 1 }), "document-unfit-change"),
        (json!({ "op": "set", "path": "a", "value": null }), "document-unfit-change"),
        (json!({ "op": "rename", "path": "a", "key": "t" }), "document-unfit-change"),
        (json!({ "op": "insert", "path": "t.l[5]", "value": 1 }), "document-no-such-entry"),
        (json!({ "op": "remove", "path": "a b" }), "document-no-such-entry"),
    ] {
        assert_eq!(changed(text, change.clone()).unwrap_err().message.code, code, "{change}");
    }
}

#[test]
fn dotted_keys_in_an_inline_table_are_left_to_the_text() {
    for change in [json!({ "op": "set", "path": "r.a", "value": 5 }), json!({ "op": "set", "path": "r.c", "value": 5 })]
    {
        assert!(changed("r = { a.b = 1 }\n", change).is_err());
    }
}

#[test]
fn the_last_table_of_a_file_without_a_last_end_of_line_moves() {
    let text = "[[f]]\nn = 1\n[[f]]\nn = 2";
    let moved = make(text, json!({ "op": "move", "path": "f[1]", "to": 0 }));
    assert_eq!(moved, "[[f]]\nn = 2\n[[f]]\nn = 1\n");
}
