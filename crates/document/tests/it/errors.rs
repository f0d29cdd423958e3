//! Every kind of mistake gives its address, the value and the allowed values.

use seamwright_document::{Document, DocumentError, Finite, NonNegative, Positive, SchemaVersion};
use serde::Deserialize;
use std::collections::BTreeMap;

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(dead_code, reason = "only read")]
struct File {
    schema: SchemaVersion,
    title: Option<String>,
    nozzle: Option<Nozzle>,
    body: Option<Body>,
    #[serde(default)]
    axis: Vec<Axis>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(dead_code, reason = "only read")]
struct Nozzle {
    radius_mm: Positive,
    #[serde(default)]
    overlap_mm: NonNegative,
    #[serde(default)]
    speed_mm_s: Finite,
}

#[derive(Debug, Deserialize)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
#[allow(dead_code, reason = "only read")]
enum Body {
    Cylinder { radius_mm: Positive },
    Plane { normal: [Finite; 3] },
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
#[allow(dead_code, reason = "only read")]
struct Axis {
    name: String,
    range_mm: Option<[Finite; 2]>,
}

fn wrong(text: &str) -> DocumentError {
    let e = Document::<File>::read("job.toml", text).unwrap_err();
    println!("{e}");
    e
}

#[test]
fn a_good_file_is_read() {
    let text = "schema = 1\n[nozzle]\nradius_mm = 250\n[body.cylinder]\nradius_mm = 8e2\n";
    let d = Document::<File>::read("job.toml", text).unwrap();
    assert!((d.value.nozzle.as_ref().unwrap().radius_mm.get() - 250.0).abs() < 1e-12);
    assert!(matches!(d.value.body, Some(Body::Cylinder { .. })));
}

#[test]
fn numbers_out_of_range() {
    for (bad, shown) in [("-250", "-250"), ("0", "0"), ("nan", "nan"), ("inf", "inf"), ("-inf", "-inf"), ("0.0", "0.0")]
    {
        let e = wrong(&format!("schema = 1\n[nozzle]\nradius_mm = {bad}\n"));
        assert_eq!((e.line, e.column, e.key.as_str(), e.value.as_str()), (3, 13, "nozzle.radius_mm", shown));
        assert_eq!(e.allowed.as_ref().map(ToString::to_string).as_deref(), Some("a finite number greater than 0"));
    }
    let e = wrong("schema = 1\n[[axis]]\nname = \"x\"\n[[axis]]\nname = \"y\"\nrange_mm = [0, nan]\n");
    assert_eq!((e.line, e.key.as_str()), (6, "axis[1].range_mm[1]"));
}

#[test]
fn numbers_beyond_the_bound_of_their_unit_are_refused_where_they_stand() {
    let text = "schema = 1\n[nozzle]\nradius_mm = 9223372036854775807\n";
    let e = wrong(text);
    assert_eq!((e.line, e.column, e.key.as_str()), (3, 13, "nozzle.radius_mm"));
    assert_eq!((e.value.as_str(), e.message.to_string().as_str()), ("9223372036854775807", "this is too large"));
    assert_eq!(e.allowed.as_ref().map(ToString::to_string).as_deref(), Some("up to 1000000 mm (a kilometre)"));
    for (key, value) in [("radius_mm", "1e7"), ("radius_mm", "0x7fffffffff"), ("radius_mm = 1\nspeed_mm_s", "-1e20")] {
        let e = wrong(&format!("schema = 1\n[nozzle]\n{key} = {value}\n"));
        assert_eq!((e.value.as_str(), e.message.to_string().as_str()), (value, "this is too large"));
    }
    let e = wrong("schema = 1\n[nozzle]\nradius_mm = 1\nspeed_mm_s = 1e-300\n");
    assert_eq!((e.line, e.message.to_string().as_str()), (4, "this is too small"));
    assert!(Document::<File>::read("f", "schema = 1\n[nozzle]\nradius_mm = 1e6\nspeed_mm_s = 0\n").is_ok());
}

#[test]
fn keys_with_points_are_quoted_and_found() {
    let text = "[part.\"a.b\"]\nlift_mm = 1e9\n";
    let read = Document::<BTreeMap<String, BTreeMap<String, BTreeMap<String, f64>>>>::read("f", text);
    let e = read.unwrap_err();
    assert_eq!((e.line, e.key.as_str(), e.value.as_str()), (2, "part.\"a.b\".lift_mm", "1e9"));
}

#[test]
fn names_that_users_choose_have_no_unit() {
    #[derive(Debug, Deserialize)]
    struct Program {
        variables: BTreeMap<String, f64>,
        spare_axes: SpareAxes,
    }
    #[derive(Debug, Deserialize)]
    struct SpareAxes {
        hold: BTreeMap<String, f64>,
    }
    let text = "variables = { lift_s = 4e6 }\n[spare_axes]\nhold = { boom_s = 4000, boom_mm_s = 1e-6 }\n";
    let program = Document::<Program>::read("f", text).unwrap_or_else(|e| panic!("{e}")).value;
    assert!((program.variables["lift_s"], program.spare_axes.hold["boom_s"]) == (4e6, 4000.0));
}

#[test]
fn keys_are_found_where_they_stand() {
    let text = "schema = 1\n[nozzle]\nradius_mm = 250\n[[axis]]\nname = \"x\"\nrange_mm = [0, 9]\n";
    let d = Document::<File>::read("job.toml", text).unwrap();
    for key in ["schema", "nozzle", "nozzle.radius_mm", "axis", "axis[0].name", "axis[0].range_mm[1]"] {
        assert!(d.has(key), "{key}");
    }
    for key in ["title", "nozzle.overlap_mm", "radius_mm", "axis[1]", "axis[0].range_mm[2]", "schema.a", "schema[0]"] {
        assert!(!d.has(key), "{key}");
    }
}

#[test]
fn wrong_types() {
    let e = wrong("schema = 1\n[nozzle]\nradius_mm = \"250 mm\"\n");
    assert_eq!((e.line, e.key.as_str(), e.value.as_str()), (3, "nozzle.radius_mm", "\"250 mm\""));
    assert!(e.message.to_string().contains("string"));
    let e = wrong("schema = 1\nnozzle = 3\n");
    assert_eq!((e.line, e.key.as_str()), (2, "nozzle"));
    let e = wrong("schema = 1\n[body.plane]\nnormal = [0, 1]\n");
    assert_eq!((e.line, e.key.as_str()), (3, "body.plane.normal"));
}

#[test]
fn unknown_keys_and_units() {
    // In an enum's variant too, where the parser has other words for it.
    let e = wrong("schema = 1\n[body.cylinder]\nradius = 5\n");
    assert_eq!(
        (e.line, e.key.as_str(), e.message.to_string().as_str()),
        (3, "body.cylinder.radius", "there is no key `radius` here")
    );
    assert_eq!(
        e.help.as_ref().map(ToString::to_string).as_deref(),
        Some("did you mean `radius_mm`? This value is given in mm")
    );
    assert_eq!(e.allowed.as_ref().map(ToString::to_string).as_deref(), Some("radius_mm"));
    let e = wrong("schema = 1\n[nozzle]\nradus_mm = 250\n");
    assert_eq!((e.line, e.key.as_str()), (3, "nozzle.radus_mm"));
    assert_eq!(e.help.as_ref().map(ToString::to_string).as_deref(), Some("did you mean `radius_mm`?"));
    assert_eq!(e.allowed.as_ref().map(ToString::to_string).as_deref(), Some("radius_mm, overlap_mm, speed_mm_s"));
    let e = wrong("schema = 1\n[nozzle]\nradius_mm = 1\nspeed_mm_min = 250\n");
    assert_eq!(
        e.help.as_ref().map(ToString::to_string).as_deref(),
        Some("did you mean `speed_mm_s`? This value is given in mm/s")
    );
    let e = wrong("schema = 1\n[nozzle]\nradius_inch = 250\n");
    assert_eq!(
        e.help.as_ref().map(ToString::to_string).as_deref(),
        Some("did you mean `radius_mm`? This value is given in mm")
    );
    let e = wrong("schema = 1\n[body.cilinder]\nradius_mm = 250\n");
    assert_eq!((e.line, e.help.as_ref().map(ToString::to_string).as_deref()), (2, Some("did you mean `cylinder`?")));
    let e = wrong("schema = 1\ntitel = \"x\"\n");
    assert_eq!(e.help.as_ref().map(ToString::to_string).as_deref(), Some("did you mean `title`?"));
}

#[test]
fn missing_keys() {
    let e = wrong("title = \"x\"\n");
    assert_eq!(
        (e.key.as_str(), e.help.as_ref().map(ToString::to_string).as_deref()),
        ("schema", Some("begin the file with: schema = 1"))
    );
    let e = wrong("schema = 1\n\n[nozzle]\noverlap_mm = 2\n");
    assert_eq!((e.line, e.key.as_str()), (3, "nozzle.radius_mm"));
    let e = wrong("schema = 2\n");
    assert!(e.allowed.unwrap().to_string().starts_with('1'));
}

#[test]
fn syntax_errors_and_duplicates_have_a_line() {
    assert_eq!(wrong("schema = 1\n[nozzle\n").line, 2);
    assert_eq!(wrong("schema = 1\nschema = 1\n").line, 2);
    assert_eq!(wrong("schema = \n").line, 1);
}

#[test]
fn later_checks_point_at_their_key() {
    let text = "schema = 1\n[nozzle]\nradius_mm = 250 # mm\n[[axis]]\nname = \"x\"\n";
    let d = Document::<File>::read("job.toml", text).unwrap();
    let e = d.error_at("nozzle.radius_mm", "is larger than the body", "less than 100");
    assert_eq!((e.line, e.value.as_str(), e.column), (3, "250", 13));
    assert_eq!(d.error_at("axis[0].name", "m", "a").value, "\"x\"");
    assert_eq!(d.error_at("nozzle.gone", "m", "a").line, 2);
}
