//! Solids in TOML and meshes in STL: parsing, and the messages for mistakes.

use crate::common;
use seamwright_testkit::{Random, cases};

use glam::{DAffine3, DVec3};
use seamwright_clearance::{ClearanceError, Mesh, Shape, Solid, SolidFile, nearest, read_stl};
use seamwright_document::{Document, DocumentError};
use std::io::{Error, ErrorKind};

#[derive(Debug, serde::Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    solid: Vec<SolidFile>,
}

fn build(text: &str, stl: Option<&[u8]>) -> Result<Vec<Solid>, DocumentError> {
    let document = Document::<File>::read("cell.toml", text)?;
    let load = |name: &str| match stl {
        Some(bytes) if name == "part.stl" => Ok(bytes.to_vec()),
        _ => Err(Error::new(ErrorKind::NotFound, "no such file")),
    };
    let solids = document.value.solid.iter().enumerate();
    solids.map(|(i, s)| s.build(&document, &format!("solid[{i}]"), &load)).collect()
}

fn ascii(triangles: &[[DVec3; 3]]) -> String {
    let facet = |t: &[DVec3; 3]| {
        let vertices: String = t.iter().map(|p| format!("  vertex {} {:e} {}\n", p.x, p.y, p.z)).collect();
        format!(" facet normal 0 0 0\n  outer loop\n{vertices}  endloop\n endfacet\n")
    };
    format!("solid a box\n{}endsolid a box\n", triangles.iter().map(facet).collect::<String>())
}

fn binary(triangles: &[[DVec3; 3]]) -> Vec<u8> {
    let mut bytes = b"solid is what some write here, yet it is binary".to_vec();
    bytes.resize(80, 0);
    bytes.extend((triangles.len() as u32).to_le_bytes());
    for t in triangles {
        bytes.extend([0; 12]);
        bytes.extend(t.iter().flat_map(DVec3::to_array).flat_map(|v| (v as f32).to_le_bytes()));
        bytes.extend([0; 2]);
    }
    bytes
}

fn cube() -> Vec<[DVec3; 3]> {
    common::box_triangles(DVec3::new(2.0, 4.0, 6.0))
}

#[test]
fn every_shape_is_read_and_placed() {
    let text = r#"
solid = [
  { shape.box = { size_mm = [2, 4, 6] }, at.move_mm = [10, 0, 0] },
  { shape.sphere = { radius_mm = 2 }, name = "ball" },
  { shape.cylinder = { radius_mm = 2, length_mm = 3 }, at = { turn = [1, 0, 0], angle_deg = 90 } },
  { shape.cone = { radius_mm = 2, length_mm = 3 } },
  { shape.cone = { radius_mm = 0, top_radius_mm = 5, length_mm = 3 } },
  { shape.capsule = { radius_mm = 2, length_mm = 4 } },
  { shape.ellipsoid = { semi_axes_mm = [1, 2, 3] } },
  { shape.half_space = {}, at.move_mm = [0, 0, -7] },
  { shape.half_space = { normal = [-2, 0, 0] } },
  { shape.stl = { file = "part.stl", scale = 10 } },
]"#;
    let solids = build(text, Some(ascii(&cube()).as_bytes())).unwrap_or_else(|e| panic!("{e}"));
    let names: Vec<_> = solids.iter().map(Solid::name).collect();
    let expected =
        ["box", "ball", "cylinder", "cone", "cone", "capsule", "ellipsoid", "half-space", "half-space", "part.stl"];
    assert_eq!(names, expected);
    // Distances from a point far out along x, y and z.
    let from = |p: DVec3, k: usize| {
        let point = common::solid(Shape::Sphere { radius: 1e-9 }, DAffine3::from_translation(p));
        nearest(&point, &DAffine3::IDENTITY, &solids[k], &DAffine3::IDENTITY, f64::MAX).unwrap().distance
    };
    let expected = [
        [89.0, 98.5, 97.0f64],
        [98.0; 3],
        [98.0, 100.0, 98.0],
        [98.0, 98.0, 97.0],
        [95.0474, 95.0474, 97.0],
        [98.0197, 98.0197, 96.0],
        [99.0, 98.0, 97.0],
        [7.0, 7.0, 107.0],
        [0.0, 0.0, 0.0],
        [90.0, 80.0, 70.0],
    ];
    for (k, [x, y, z]) in expected.into_iter().enumerate() {
        let y = if k == 0 { (99.0f64 - 1.0).hypot(9.0) } else { y };
        let z = if k == 0 { 97f64.hypot(9.0) } else { z };
        for (p, d) in [(DVec3::X, x), (DVec3::Y, y), (DVec3::Z, z)] {
            let p = p * 100.0;
            assert!((from(p, k) - d).abs() < 1e-3, "{k} {p}: {} {d}", from(p, k));
        }
    }
    assert!((from(DVec3::X * -100.0, 8) - 100.0).abs() < 1e-6);
}

#[test]
fn solids_are_written_as_they_are_read() {
    let text = "name = \"tip\"\n\n[shape.cone]\nradius_mm = 2\ntop_radius_mm = 1\nlength_mm = 3.5\n";
    let solid: SolidFile = toml::from_str(text).unwrap();
    assert_eq!(toml::to_string(&solid).unwrap(), text);
}

#[test]
fn mistakes_in_toml_have_an_address_and_a_cure() {
    for (solid, key, says) in [
        ("shape.box = { size_mm = [1, 0, 2] }", "solid[0].shape.box.size_mm", "greater than 0"),
        ("shape.box = { size_mm = [1, 2] }", "solid[0].shape.box.size_mm", "3"),
        ("shape.box = { size_mm = [1, 2, 1e9] }", "solid[0].shape.box", "10000000 mm"),
        ("shape.capsule = { radius_mm = 3, length_mm = 5 }", "solid[0].shape.capsule.length_mm", "twice the radius"),
        ("shape.cone = { radius_mm = 0, length_mm = 5 }", "solid[0].shape.cone", "one radius above 0"),
        ("shape.cone = { radius = 1, length_mm = 5 }", "solid[0].shape.cone.radius", "did you mean `radius_mm`"),
        ("shape.ball = { radius_mm = 1 }", "solid[0].shape.ball", "sphere"),
        ("shape = {}", "solid[0].shape", "exactly one"),
        ("shape.sphere = { radius_mm = 1 }, colour = 1", "solid[0].colour", "there is no key `colour`"),
        ("name = \"a\"", "solid[0].shape", "the key `shape` is missing"),
        ("shape.stl = { file = \"other.stl\" }", "solid[0].shape.stl.file", "could not be read: no such file"),
        ("shape.half_space = { normal = [0, 0, 0] }", "solid[0].shape.half_space.normal", "no length"),
    ] {
        let error = build(&format!("solid = [\n {{ {solid} }},\n]"), None).unwrap_err();
        assert!(error.line == 2 || solid == "shape = {}", "{error}");
        assert!(error.to_string().contains(says), "{says}: {error}");
        assert!(error.key.starts_with(key) || key.starts_with(&error.key), "{key}: {} {error}", error.key);
    }
}

#[test]
fn ascii_and_binary_are_the_same() {
    let text = ascii(&cube());
    let crlf = text.replace('\n', "\r\n").to_uppercase();
    for bytes in [text.as_bytes(), crlf.as_bytes(), &binary(&cube()), &[&binary(&cube())[..], b"more"].concat()] {
        let read = read_stl(bytes, 1.0).unwrap();
        assert_eq!(read, cube());
        assert_eq!(read_stl(bytes, 25.4).unwrap()[3][1], cube()[3][1] * 25.4);
        assert_eq!(Mesh::new(&read).unwrap().bounds().1, DVec3::new(1.0, 2.0, 3.0));
    }
}

#[test]
fn every_mistake_in_an_stl_is_named() {
    let text = ascii(&cube());
    let with = |change: fn(&mut Vec<[DVec3; 3]>)| {
        let mut triangles = cube();
        change(&mut triangles);
        binary(&triangles)
    };
    let cut = text.find("endsolid").unwrap();
    let cases: Vec<(&str, Vec<u8>, &str, &str)> = vec![
        ("text", b"PK\x03\x04 a zip file, say".to_vec(), "this is not an STL file", "ASCII or binary"),
        ("empty", Vec::new(), "this is not an STL file", "ASCII or binary"),
        ("prose", b"solid state physics\nis a science\n and so on\n".to_vec(), "unknown word `is a science`", "ASCII"),
        ("words", text.replace("vertex 1 ", "vertex one ").into_bytes(), "must have three numbers", "ASCII"),
        (
            "corners",
            text.replacen("endloop\n endfacet\n", "vertex 1 2 3\n endfacet\n", 1).into_bytes(),
            "4 corners",
            "",
        ),
        ("cut binary", binary(&cube())[..400].to_vec(), "truncated: 6 of 12 triangles", "copy or export it again"),
        ("cut ascii", text.as_bytes()[..cut].to_vec(), "`endsolid` is missing after 12", "export it again"),
        ("cut word", text.as_bytes()[..cut / 2].to_vec(), "`endsolid` is missing after", "export it again"),
        (
            "nan",
            with(|t| t[4][1].x = f64::NAN),
            "triangle 5 has a corner that is not a finite",
            "export the file again",
        ),
        ("infinite", with(|t| t[4][1].x = f64::INFINITY), "triangle 5 has a corner that is not", "export"),
        ("large", with(|t| t[2][0].x = 3e7), "triangle 3 has a corner 3.000e7 mm from the origin", "`scale`"),
        ("nothing", binary(&[]), "has no triangles", "at least four triangles"),
        ("nothing", b"solid\nendsolid".to_vec(), "has no triangles", "at least four triangles"),
        ("points", with(|t| t.iter_mut().for_each(|t| *t = [t[0]; 3])), "has no triangles", ""),
        ("hole", with(|t| t.truncate(11)), "not closed: 3 edges", "close the holes"),
        ("place", with(|t| t.truncate(11)), "at (", "as one solid"),
        ("twice", with(|t| t.push(t[0])), "not closed: 3 edges", "close the holes"),
    ];
    for (what, bytes, says, cure) in cases {
        let error = build("[[solid]]\nshape.stl = { file = \"part.stl\" }", Some(&bytes)).unwrap_err();
        let text = error.to_string();
        assert!(text.contains(says) && text.contains(cure), "{what}: {text}");
        assert_eq!((error.line, error.key.as_str()), (2, "solid[0].shape.stl.file"), "{what}: {text}");
    }
    // The reported point is on the open edge.
    let mut open = cube();
    open.truncate(11);
    let Err(ClearanceError::Open { edges: 3, at }) = Mesh::new(&open) else { panic!() };
    let gone = cube()[11];
    let middles = [[0, 1], [1, 2], [2, 0]].map(|[i, j]| (gone[i] + gone[j]) / 2.0);
    assert!(middles.iter().any(|m| m.distance(at) < 1e-12), "{at}");
}

#[test]
fn no_bytes_are_a_panic() {
    let mut random = Random::new(31);
    let whole = [ascii(&cube()).into_bytes(), binary(&cube())];
    let mut read = 0;
    for case in 0..cases(4000) {
        let mut bytes = whole[case % 2].clone();
        for _ in 0..1 + case % 5 {
            let at = random.below(bytes.len());
            bytes[at] = random.below(256) as u8;
        }
        if case % 7 == 0 {
            bytes.truncate(random.below(bytes.len()));
        }
        let mesh = read_stl(&bytes, 1.0).and_then(|t| Mesh::new(&t));
        read += usize::from(mesh.is_ok());
    }
    assert!(read > 100, "{read}");
}

#[test]
fn triangles_without_area_and_turned_ones_do_no_harm() {
    let mut triangles = cube();
    let [a, b, _] = triangles[0];
    triangles.push([a, a, b]);
    triangles.push([a, (a + b) / 2.0, b]);
    assert_eq!(Mesh::new(&triangles).unwrap().triangles().len(), 12);
    // A sliver that joins a split edge to a whole one is kept.
    let mut split = cube();
    let [a, b, c] = split.swap_remove(0);
    let middle = (a + b) / 2.0;
    split.extend([[a, middle, c], [middle, b, c], [a, b, middle]]);
    assert_eq!(Mesh::new(&split).unwrap().triangles().len(), 14);
    // With reversed triangles the inside stays inside.
    for i in 0..12 {
        let mut turned = cube();
        turned[i].swap(0, 1);
        turned[(i * 5 + 3) % 12].swap(1, 2);
        let mesh = Mesh::new(&turned).unwrap();
        assert!(mesh.contains(DVec3::new(0.3, 0.2, 0.1)) && !mesh.contains(DVec3::new(0.3, 0.2, 3.1)));
    }
}

#[test]
fn shapes_that_cannot_be_are_refused() {
    let new = |shape: Shape, pose: DAffine3| Solid::new("", shape, pose).map(|_| ());
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(new(Shape::Sphere { radius: bad }, DAffine3::IDENTITY), Err(ClearanceError::Size { .. })));
    }
    let nan = Shape::Cone { radius: 1.0, top_radius: f64::NAN, length: 1.0 };
    assert!(new(nan, DAffine3::IDENTITY).is_err());
    let ball = Shape::Sphere { radius: 1.0 };
    let mirrored = DAffine3::from_scale(DVec3::new(1.0, 1.0, -1.0));
    for pose in [mirrored, DAffine3::from_scale(DVec3::splat(2.0)), DAffine3::from_translation(DVec3::NAN)] {
        assert_eq!(new(ball.clone(), pose), Err(ClearanceError::NotRigid));
    }
}
