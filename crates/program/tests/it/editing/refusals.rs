//! Refused edits, and their messages.

use seamwright_document::serde_text;
use seamwright_program::edit::{Editor, Operation};

const TEXT: &str = "schema = 1\ntitle = \"t\"\nmachine = \"m\"\n[variables]\nlift = 3\n[offsets.table]\nmove_mm = [1, 2, 3]\n\
    [seam.nozzle]\nradius_mm = 250\n[seam.nozzle.body.cylinder]\nradius_mm = 800\n\
    [[passes]]\nname = \"seam\"\nleast_speed_mm_s = 4\n[[passes.spans]]\nfrom_mm = 0\nto_mm = 10\nspeed_mm_s = 5\n\
    process = { current_a = 180 }\n[[passes.spans]]\nfrom_mm = 10\nto_mm = 20\nspeed_mm_s = 8\n\
    process = { current_a = { from = 180, to = 200 } }\n\
    [[passes]]\nname = \"poses\"\n[passes.points]\ncolumns = [\"x_mm\", \"y_mm\", \"z_mm\", \"current_a\", \"time_s\"]\n\
    start = [0, 0, 0, 5, 0]\n[[passes.points.spans]]\nalong = \"rapid\"\npoints = [[1, 0, \"= lift\", 5, 0]]\n\
    [[passes.points.spans]]\nalong = \"line\"\npoints = [[2, 0, 0, 5, 1], [3, 0, -1, 5, 1]]\n\
    [[passes]]\nname = \"axes\"\n[passes.points]\ncolumns = [\"x\", \"b\", \"time_s\"]\nstart = [0, 0, 0]\n\
    [[passes.points.spans]]\nalong = \"line\"\npoints = [[1, 0, 2]]\n\
    [[passes]]\nname = \"by speed\"\n[passes.points]\ncolumns = [\"x\", \"y\", \"z\", \"speed_mm_s\"]\nstart = [0, 0, 0, 0]\n\
    [[passes.points.spans]]\nalong = \"line\"\npoints = [[1, 0, 2, 5]]\n";

/// Operations, and words of their refusals.
const CASES: &[(&str, &str)] = &[
    (r#"{"op":"set_point","pass":9,"point":1,"set":{"x_mm":1}}"#, "there is no pass 9"),
    (r#"{"op":"set_point","pass":2,"point":4,"set":{"x_mm":1}}"#, "there is no point 4"),
    (r#"{"op":"set_point","pass":2,"point":1,"set":{"x_m":1}}"#, "did you mean `x_mm`"),
    (r#"{"op":"set_point","pass":2,"point":2,"set":{"time_s":0}}"#, "time_s = 0 is not allowed here"),
    (r#"{"op":"set_point","pass":1,"point":2,"set":{"time_s":1}}"#, "runs along the seam"),
    (r#"{"op":"insert_point","pass":2,"after":7}"#, "there is no point 7"),
    (r#"{"op":"insert_point","pass":2,"after":3}"#, "no next point"),
    (r#"{"op":"insert_point","pass":2,"after":1,"numbers":[1,2]}"#, "2 numbers for 5 columns"),
    (r#"{"op":"delete_points","pass":2,"from":0}"#, "no points 0 to 0 for"),
    (r#"{"op":"delete_points","pass":2,"from":3,"to":2}"#, "no points 3 to 2"),
    (r#"{"op":"delete_points","pass":3,"from":1}"#, "no point would be left"),
    (r#"{"op":"interpolate","pass":2,"span":2,"along":"arc","via_mm":[1,2,3]}"#, "the span has 2"),
    (r#"{"op":"interpolate","pass":2,"span":1,"along":"line"}"#, "no time or speed"),
    (r#"{"op":"interpolate","pass":2,"span":3,"along":"line"}"#, "there is no span 3"),
    (r#"{"op":"interpolate","pass":2,"span":2,"along":"spline","via_mm":[1,2,3]}"#, "belong to arcs, not to `spline`"),
    (
        r#"{"op":"interpolate","pass":3,"span":1,"along":"arc","via_mm":[1,2,3]}"#,
        "only if they include two of x, y and z",
    ),
    (r#"{"op":"interpolate","pass":4,"span":1,"along":"cubic"}"#, "a cubic needs times"),
    (r#"{"op":"set_point","pass":2,"point":2,"speeds":{"x_mm":1}}"#, "no cubic ends or starts at point 2"),
    (r#"{"op":"set_point","pass":2,"point":2,"speeds":{"current_a":1}}"#, "is not a column of the position"),
    (r#"{"op":"set_point","pass":2,"point":2}"#, "no number is given"),
    (r#"{"op":"split_span","pass":2,"point":1}"#, "no span can be split at point 1"),
    (r#"{"op":"split_span","pass":1,"s_mm":10}"#, "no span can be split at 10 mm"),
    (r#"{"op":"split_span","pass":1,"point":1}"#, "does not fit the pass"),
    (r#"{"op":"join_spans","pass":1,"span":1}"#, "do not continue each other"),
    (r#"{"op":"join_spans","pass":2,"span":1}"#, "do not continue each other"),
    (r#"{"op":"join_spans","pass":2,"span":2}"#, "there is no span 2"),
    (r#"{"op":"reverse_pass","pass":0}"#, "there is no pass 0"),
    (r#"{"op":"reverse_pass","pass":5}"#, "there is no pass 5"),
    (r#"{"op":"reverse_pass","pass":2,"seam_length_mm":100}"#, "it has no seam"),
    (r#"{"op":"shift_start","pass":2,"point":1}"#, "do not end where they start"),
    (r#"{"op":"shift_start","pass":2,"begin_mm":1}"#, "goes through points"),
    (r#"{"op":"shift_start","pass":2}"#, "the new start is missing"),
    (r#"{"op":"mirror","pass":2}"#, "axis to mirror about is missing"),
    (r#"{"op":"mirror","pass":3,"normal":[1,0,0]}"#, "are axis positions"),
    (r#"{"op":"mirror","pass":2,"axis":"x"}"#, "are poses"),
    (r#"{"op":"mirror","pass":3,"axis":"bb"}"#, "did you mean `b`"),
    (r#"{"op":"offset","pass":1,"dx_mm":1}"#, "runs along the seam"),
    (r#"{"op":"offset","pass":3,"dx_mm":1}"#, "only the machine knows"),
    (r#"{"op":"offset","pass":2,"across_mm":1}"#, "goes through points"),
    (r#"{"op":"offset","pass":1,"work_angle_deg":95}"#, "behind a face"),
    (r#"{"op":"scale_speed","points":[1,2],"factor":2}"#, "a range needs its pass"),
    (r#"{"op":"scale_speed","pass":2,"s_mm":[0,1],"factor":2}"#, "goes through points"),
    (r#"{"op":"scale_speed","pass":1,"s_mm":[15,30],"factor":2}"#, "no range from 15 mm to 30 mm"),
    (r#"{"op":"scale_speed","pass":1,"factor":0.5}"#, "minimum speed is not below"),
    (r#"{"op":"set_process","pass":1,"s_mm":[1,1],"name":"current_a","value":1}"#, "no range from 1 mm to 1 mm"),
    (r#"{"op":"set_process","pass":1,"s_mm":[0,5],"name":"voltage_v","value":1}"#, "other process values"),
    (r#"{"op":"set_process","pass":2,"name":"curent_a","value":1}"#, "did you mean `current_a`"),
    (r#"{"op":"set_process","pass":2,"name":"current_a","value":-1}"#, "current_a = -1 is not allowed"),
    (r#"{"op":"renumber","pass":1,"start":1,"step":1}"#, "runs along the seam"),
    (r#"{"op":"renumber","pass":5,"start":1,"step":1}"#, "there is no pass 5"),
    (r#"{"op":"renumber","start":2000000000,"step":1}"#, "a whole number"),
    (r#"{"op":"reduce","pass":1,"tolerance_mm":1}"#, "runs along the seam"),
    (r#"{"op":"reduce","pass":3,"tolerance_mm":1}"#, "no x, y and z"),
    (r#"{"op":"reduce","pass":8,"tolerance_mm":1}"#, "there is no pass 8"),
    (r#"{"op":"set_offset","name":"tabel"}"#, "did you mean `table`"),
    (r#"{"op":"set_offset","name":""}"#, "`` is not known"),
    (r#"{"op":"set_offset","name":"a b"}"#, "`a b` is not known"),
    (r#"{"op":"set_variable","name":"lift"}"#, "`lift` is not known"),
    (r#"{"op":"set_variable","name":"lft"}"#, "did you mean `lift`"),
    (r#"{"op":"set_variable","name":"a b","value":1}"#, "not a valid name of a variable"),
    (r#"{"op":"set_pass","pass":1}"#, "nothing is given to set"),
    (r#"{"op":"set_pass","pass":1,"arc":true}"#, "runs along the seam"),
    (r#"{"op":"set_pass","pass":7,"name":"x"}"#, "there is no pass 7"),
    (r#"{"op":"add_pass","new":{"name":"x"}}"#, "has no spans"),
    (r#"{"op":"add_pass","at":9,"new":{"name":"x"}}"#, "there is no position 9"),
    (
        r#"{"op":"add_pass","new":{"name":"x","copy":3,"spans":[{"from_mm":0,"to_mm":1,"speed_mm_s":1}]}}"#,
        "no such copy",
    ),
    (r#"{"op":"delete_pass","pass":0}"#, "there is no pass 0"),
    (r#"{"op":"delete_pass","pass":5}"#, "1 to 4"),
    (r#"{"op":"move_pass","pass":1,"to":5}"#, "there is no position 5"),
    (r#"{"op":"move_pass","pass":1,"to":0}"#, "there is no position 0"),
    (r#"{"op":"move_pass","pass":5,"to":1}"#, "there is no pass 5"),
    (r#"{"op":"duplicate_pass","pass":5}"#, "there is no pass 5"),
    (r#"{"op":"add_event","pass":1,"event":{"after":1,"gas":true}}"#, "runs along the seam"),
    (r#"{"op":"add_event","pass":2,"event":{"after":4,"gas":true}}"#, "the pass has fewer points"),
    (r#"{"op":"add_event","pass":2,"event":{"after":1,"gas":true,"wire":true}}"#, "an event does exactly one thing"),
    (r#"{"op":"delete_event","pass":2,"event":1}"#, "there is no event 1"),
    (r#"{"op":"delete_event","pass":1,"event":1}"#, "runs along the seam"),
    (r#"{"op":"delete_event","pass":6,"event":1}"#, "there is no pass 6"),
];

#[test]
fn what_cannot_be_is_refused_in_words_and_changes_nothing() {
    let mut editor = Editor::new("p.toml", TEXT).unwrap_or_else(|e| panic!("{e}"));
    for (operation, words) in CASES {
        let read: Operation = serde_json::from_str(operation).unwrap_or_else(|e| panic!("{operation}: {e}"));
        let told = editor.apply(&read).map(|r| r.words).expect_err(operation).to_string();
        assert!(told.contains(words) && told.starts_with("p.toml"), "{operation}\n{told}");
        assert!(editor.text() == TEXT && editor.history().done().is_empty());
    }
}

#[test]
fn operations_that_do_not_read_are_named() {
    let wrong = |text: &str| serde_text(&serde_json::from_str::<Operation>(text).unwrap_err().to_string());
    assert!(wrong(r#"{"op":"set_pint"}"#).contains("set_pint"));
    assert!(wrong(r#"{"op":"delete_pass"}"#).contains("missing field `pass`"));
    assert!(wrong(r#"{"op":"delete_pass","pass":1,"pas":1}"#).contains("unknown field `pas`"));
    assert!(wrong(r#"{"op":"scale_speed","factor":0}"#).contains("greater than 0"));
    assert!(wrong(r#"{"op":"duplicate_pass","pass":-1}"#).contains("-1"));
    assert!(wrong(r#"{"op":"duplicate_pass","pass":"1"}"#).contains("string"));
    assert!(wrong(r#"{"op":"set_pass","pass":1,"repeat":0}"#).contains("1 to 1000"));
}
