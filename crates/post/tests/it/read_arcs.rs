//! Arcs: every way to write them, and typical errors of reading. Checked against the circle itself: each point of the
//! arc is at its radius, it turns the right way, and it takes the time of its length.

use crate::reading::{good, moves, near, refused, rows};
use glam::DVec3;
use seamwright_post::Dialect::{Grblhal, Linuxcnc, Pmac, Sinumerik};
use seamwright_post::{Arc, Dialect, PartProgram, Path};
use seamwright_testkit::{Random, cases};
use std::f64::consts::{PI, TAU};

/// The arc of the last move, with its start and end.
fn last_arc(program: &PartProgram) -> (Arc, DVec3, DVec3, f64) {
    let moves = moves(program);
    let m = moves.last().unwrap();
    let Path::Arc(index) = m.path else { panic!("{m:?}") };
    let place = |row: &[f64]| DVec3::new(row[0], row[1], row[2]);
    let rows = rows(program);
    let start = if rows.len() > 1 { place(&rows[rows.len() - 2]) } else { DVec3::ZERO };
    (program.arcs[index as usize], start, place(rows.last().unwrap()), m.seconds)
}

/// Checks centre (across the axis), axis and sweep.
fn is(dialect: Dialect, text: &str, centre: [f64; 3], axis: [f64; 3], degrees: f64) {
    let (arc, start, end, _) = last_arc(&good(dialect, text));
    let (centre, axis) = (DVec3::from(centre), DVec3::from(axis));
    assert!((arc.normal - axis).length() < 1e-9, "{text}: {arc:?}");
    assert!((arc.centre - centre).reject_from(axis).length() < 1e-6, "{text}: {arc:?}");
    assert!((arc.sweep.to_degrees() - degrees).abs() < 1e-6, "{text}: {} degrees", arc.sweep.to_degrees());
    assert!((arc.at(start, end, 0.0) - start).length() < 1e-9, "{text}");
    assert!((arc.at(start, end, 1.0) - end).length() < 0.05, "{text}: {} {end}", arc.at(start, end, 1.0));
}

const UP: [f64; 3] = [0.0, 0.0, 1.0];
const DOWN: [f64; 3] = [0.0, 0.0, -1.0];

#[test]
fn quarter_circles_in_every_dialect() {
    let text = "G94 F60 G0 X10 Y0\nG3 X0 Y10 I-10 J0\n";
    for dialect in [Sinumerik, Linuxcnc, Grblhal] {
        is(dialect, text, [0.0; 3], UP, 90.0);
        is(dialect, &text.replace("G3", "G2"), [0.0; 3], DOWN, 270.0);
        assert!((last_arc(&good(dialect, text)).3 - 5.0 * PI).abs() < 1e-9);
    }
    is(Linuxcnc, "F60 G0 X10\nG90.1 G3 X0 Y10 I0 J0\n", [0.0; 3], UP, 90.0);
    is(Sinumerik, "F60 G0 X10\nG3 X0 Y10 I=AC(0) J=AC(0)\n", [0.0; 3], UP, 90.0);
    is(Sinumerik, "F60 G0 X10\nG3 X0 Y10 CR=10\n", [0.0; 3], UP, 90.0);
    is(Sinumerik, "F60 G0 X10\nG3 X0 Y10 AR=90\n", [0.0; 3], UP, 90.0);
    is(Sinumerik, "F60 G0 X10\nG3 I-10 J0 AR=90\n", [0.0; 3], UP, 90.0);
    let (_, _, end, _) = last_arc(&good(Sinumerik, "F60 G0 X10\nG3 I-10 J0 AR=90\n"));
    assert!((end - DVec3::new(0.0, 10.0, 0.0)).length() < 1e-12);
    let pmac = "RAPID X10 Y0\nF1 CIRCLE2 X0 Y10 I-10 J0\n";
    is(Pmac, pmac, [0.0; 3], UP, 90.0);
    is(Pmac, &pmac.replace('2', "1"), [0.0; 3], DOWN, 270.0);
    is(Pmac, "RAPID X10 Y0\nTM100 CIRCLE2 X0 Y10 R10\n", [0.0; 3], UP, 90.0);
}

#[test]
fn full_circles() {
    for dialect in [Sinumerik, Linuxcnc, Grblhal] {
        is(dialect, "F60 G0 X10\nG3 X10 Y0 I-10\n", [0.0; 3], UP, 360.0);
        is(dialect, "F60 G0 X10\nG2 I-10 J0\n", [0.0; 3], DOWN, 360.0);
    }
    is(Pmac, "RAPID X10\nTM100 CIRCLE1 X10 I-10\n", [0.0; 3], DOWN, 360.0);
    is(Sinumerik, "F60 G0 X10\nG3 I-10 TURN=2\n", [0.0; 3], UP, 1080.0);
    is(Linuxcnc, "F60 G0 X10\nG3 I-10 P3\n", [0.0; 3], UP, 1080.0);
    is(Linuxcnc, "F60 G0 X10\nG3 X0 Y10 I-10 P2\n", [0.0; 3], UP, 450.0);
}

/// An end a little before or behind the start: a tiny arc, or one of nearly a full turn; no circle more.
#[test]
fn tiny_arcs_are_no_circles() {
    let (c, s) = (10.0 * 1e-4f64.cos(), 10.0 * 1e-4f64.sin());
    for dialect in [Sinumerik, Linuxcnc, Grblhal] {
        let at = |g: &str, y: f64| format!("F60 G0 X10\n{g} X{c:.9} Y{y:.9} I-10\n");
        let tiny = 1e-4f64.to_degrees();
        is(dialect, &at("G3", s), [0.0; 3], UP, tiny);
        is(dialect, &at("G3", -s), [0.0; 3], UP, 360.0 - tiny);
        is(dialect, &at("G2", -s), [0.0; 3], DOWN, tiny);
        is(dialect, &at("G2", s), [0.0; 3], DOWN, 360.0 - tiny);
    }
}

#[test]
fn arcs_by_radius() {
    let at = |r: &str| format!("F60 G0 X10\nG3 X0 Y10 {r}\n");
    for dialect in [Linuxcnc, Grblhal] {
        is(dialect, &at("R10"), [0.0; 3], UP, 90.0);
        is(dialect, &at("R-10"), [10.0, 10.0, 0.0], UP, 270.0);
        // Half a circle exactly, where the root may be of a hair below zero.
        is(dialect, "F60 G0 X10\nG2 X-10 R10\n", [0.0; 3], DOWN, 180.0);
        refused(dialect, "F60 G0 X10\nG3 X10 Y0 R5\n", 2, 11, "must end away from its start");
        refused(dialect, "F60 G0 X10\nG3 R5\n", 2, 4, "must end away from its start");
        refused(dialect, &at("R7"), 2, 11, "too small");
        refused(dialect, &at("R10 I-10"), 2, 15, "not both");
    }
    is(Sinumerik, &at("CR=-10"), [10.0, 10.0, 0.0], UP, 270.0);
    refused(Sinumerik, &at("CR=7"), 2, 11, "too small");
    refused(Sinumerik, "F60 G0 X10\nG3 CR=7\n", 2, 4, "must end away from its start");
    // LinuxCNC takes a radius too short by a micrometre; grblHAL does not.
    is(Linuxcnc, "F60 G0 X10\nG2 X-10 R9.999\n", [0.0; 3], DOWN, 180.0);
    refused(Grblhal, "F60 G0 X10\nG2 X-10 R9.999\n", 2, 9, "too small");
}

#[test]
fn planes() {
    // G18 turns from Z to X, G19 from Y to Z.
    let axes = [("G17", "X0 Y10 I-10", UP), ("G18", "X0 Z-10 I-10", [0.0, 1.0, 0.0])];
    for (plane, words, axis) in axes {
        for dialect in [Sinumerik, Linuxcnc, Grblhal] {
            is(dialect, &format!("F60 G0 X10\n{plane} G3 {words}\n"), [0.0; 3], axis, 90.0);
        }
    }
    is(Linuxcnc, "F60 G0 Y10\nG19 G3 Y0 Z10 J-10\n", [0.0; 3], [1.0, 0.0, 0.0], 90.0);
    is(Linuxcnc, "F60 G0 X10\nG18 G3 X0 Z-10 R10\n", [0.0; 3], [0.0, 1.0, 0.0], 90.0);
    refused(Linuxcnc, "F60 G0 X10\nG3 X0 Y10 I-10 K1\n", 2, 16, "the plane is G17");
    refused(Sinumerik, "F60 G0 X10\nG18 G3 X0 Z-10 J1\n", 2, 16, "the plane is G18");
    is(Pmac, "RAPID Y10\nNORMAL I-1 TM10 CIRCLE2 Y0 Z10 J-10\n", [0.0; 3], [1.0, 0.0, 0.0], 90.0);
    // A tilted plane: about (0, 1, 1), from X to the direction between Z and -Y.
    let text = "RAPID X10\nNORMAL J1 K1 TM10 CIRCLE1 X0 Y7.071067812 Z-7.071067812 I-10\n";
    is(Pmac, text, [0.0; 3], [0.0, 0.5f64.sqrt(), 0.5f64.sqrt()], 90.0);
}

#[test]
fn helices_and_axes_that_go_along() {
    for dialect in [Sinumerik, Linuxcnc, Grblhal] {
        let turn = if dialect == Sinumerik { "TURN=1" } else { "P2" };
        let c = if dialect == Sinumerik { "C1=90" } else { "C90" };
        let text = format!("G93 G0 X10 Z5\nG3 X0 Y10 Z15 I-10 {turn} {c} B30 F6\n");
        let program = good(dialect, &text);
        let (arc, start, end, seconds) = last_arc(&program);
        assert!((arc.sweep - 2.5 * PI).abs() < 1e-9 && (seconds - 10.0).abs() < 1e-9);
        let half = arc.at(start, end, 0.5);
        // Half of 450 degrees is 225: back to x = y = -7.07.
        let angle = 225f64.to_radians();
        assert!((half - DVec3::new(10.0 * angle.cos(), 10.0 * angle.sin(), 10.0)).length() < 1e-9);
        assert_eq!(rows(&program)[1][3..5], [30.0, 90.0]);
    }
    // The feed counts the helix' length on LinuxCNC, with the rotary axes on grblHAL.
    let text = "G94 G0 X10\nG3 X-10 Z10 I-10 B40 F600\n";
    let helix = (10.0 * PI).hypot(10.0);
    assert!((last_arc(&good(Linuxcnc, text)).3 - 0.1 * helix).abs() < 1e-9);
    assert!((last_arc(&good(Grblhal, text)).3 - 0.1 * helix.hypot(40.0)).abs() < 1e-9);
    assert!((last_arc(&good(Sinumerik, text)).3 - 0.1 * helix).abs() < 1e-9);
}

#[test]
fn inches() {
    for dialect in [Linuxcnc, Grblhal] {
        let text = "G20 G93 G0 X1\nG3 X0 Y1 I-1 F6\n";
        is(dialect, text, [0.0; 3], UP, 90.0);
        is(dialect, &text.replace("I-1", "R1"), [0.0; 3], UP, 90.0);
        assert!((last_arc(&good(dialect, text)).1.x - 25.4).abs() < 1e-12);
    }
    is(Sinumerik, "G70 F60 G0 X1\nG3 X0 Y1 CR=1\n", [0.0; 3], UP, 90.0);
}

#[test]
fn through_a_point() {
    let text = "F60 G0 X10\nCIP X-10 Y0 I1=0 J1=10 K1=0\n";
    is(Sinumerik, text, [0.0; 3], UP, 180.0);
    is(Sinumerik, &text.replace("J1=10", "J1=-10"), [0.0; 3], DOWN, 180.0);
    is(Sinumerik, "F60 G0 X10\nCIP X0 Y-10 I1=-10 J1=0\n", [0.0; 3], UP, 270.0);
    // Increments: from the start.
    is(Sinumerik, "F60 G0 X10\nG91 CIP X-20 I1=-10 J1=10\n", [0.0; 3], UP, 180.0);
    is(Sinumerik, "F60 G0 X10\nCIP X-10 Z0 I1=0 K1=10\n", [0.0; 3], [0.0, -1.0, 0.0], 180.0);
    refused(Sinumerik, "F60 G0 X10\nCIP X-10 I1=0 J1=0\n", 2, 10, "on a line");
    refused(Sinumerik, "F60 G0 X10\nCIP X-10 I1=0 J1=10 CR=5\n", 2, 21, "no centre");
    refused(Sinumerik, "F60 G0 X10\nG3 X-10 I1=0 J1=10\n", 2, 9, "only CIP");
}

/// Ends off the circle: taken as far as each control takes them.
#[test]
fn ends_off_the_circle() {
    let off = |by: f64| format!("F60 G0 X10\nG3 X0 Y{:.6} I-10\n", 10.0 + by);
    for (dialect, most) in [(Sinumerik, 0.01), (Linuxcnc, 0.02 * 2f64.sqrt()), (Grblhal, 0.01)] {
        is(dialect, &off(0.98 * most), [0.0; 3], UP, 90.0);
        is(dialect, &off(-0.98 * most), [0.0; 3], UP, 90.0);
        refused(dialect, &off(1.02 * most), 2, 18, "off its circle");
        refused(dialect, &off(-1.02 * most), 2, 17, "off its circle");
    }
    // 0.1 % of large radii; grblHAL half a millimetre at most.
    let large = |by: f64| format!("F60 G0 X1000\nG3 X0 Y{:.6} I-1000\n", 1000.0 + by);
    for (dialect, most) in [(Sinumerik, 1.0), (Linuxcnc, 1.0), (Grblhal, 0.5)] {
        good(dialect, &large(0.99 * most));
        refused(dialect, &large(1.02 * most), 2, 20, "off its circle");
    }
    // PMAC makes a spiral.
    let (arc, start, end, _) = last_arc(&good(Pmac, "RAPID X10\nTM10 CIRCLE2 X0 Y12 I-10\n"));
    assert!((arc.at(start, end, 1.0) - end).length() < 1e-9);
    assert!((arc.at(start, end, 0.5).length() - 11.0).abs() < 1e-9);
    refused(Linuxcnc, "F60 G0 X10\nG3 X0 Y10 I0\n", 2, 11, "starts at its own centre");
    refused(Linuxcnc, "F60 G0 X10\nG3 X0 Y10\n", 2, 1, "centre or radius of this arc is missing");
    refused(Linuxcnc, "F60 G0 X10\nG90.1 G3 X0 Y10 I0\n", 2, 17, "J is missing");
}

#[test]
fn angles_of_arcs() {
    refused(Sinumerik, "F60 G0 X10\nG3 X0 Y10 AR=360\n", 2, 11, "invalid angle");
    refused(Sinumerik, "F60 G0 X10\nG3 X0 Y10 AR=-5\n", 2, 11, "invalid angle");
    refused(Sinumerik, "F60 G0 X10\nG3 AR=90\n", 2, 4, "must end away from its start");
    refused(Sinumerik, "F60 G0 X10\nG3 X0 I-10 AR=90\n", 2, 7, "not all three");
    refused(Sinumerik, "F60 G0 X10\nG3 X0 CR=5 AR=90\n", 2, 12, "not both");
}

/// Random arcs written in every way a dialect has, against the circle that they were made from.
#[test]
fn random_arcs_come_back() {
    let mut random = Random::new(3);
    for case in 0..cases(4000) {
        let dialect = Dialect::ALL[case % 4];
        let (radius, from) = (random.within(1.0, 300.0), random.within(0.0, TAU));
        let sweep = random.within(0.002, TAU - 0.002) * if random.chance(0.5) { 1.0 } else { -1.0 };
        let plane = random.below(3);
        let axes = [[1, 2], [2, 0], [0, 1]][plane];
        let centre = random.vector(99.0);
        let on = |angle: f64| {
            let mut p = centre;
            p[axes[0]] += radius * angle.cos();
            p[axes[1]] += radius * angle.sin();
            p
        };
        let (start, mut end) = (on(from), on(from + sweep));
        end[plane] += if random.chance(0.3) { random.within(-20.0, 20.0) } else { 0.0 };
        let (letters, offsets) = (["X", "Y", "Z"], ["I", "J", "K"]);
        let by_centre: String = axes.iter().map(|k| format!(" {}{:.9}", offsets[*k], centre[*k] - start[*k])).collect();
        let signed = if sweep.abs() > PI { -radius } else { radius };
        let way = match (dialect, random.below(3)) {
            (Sinumerik, 0) => format!(" CR={signed:.9}"),
            (Sinumerik, 1) => format!(" AR={:.9}", sweep.abs().to_degrees()),
            (Linuxcnc | Grblhal | Pmac, 0) => format!(" R{signed:.9}"),
            _ => by_centre,
        };
        let to: String = (0..3).map(|k| format!(" {}{:.9}", letters[k], end[k])).collect();
        let to_start: String = (0..3).map(|k| format!(" {}{:.9}", letters[k], start[k])).collect();
        let text = if dialect == Pmac {
            let normal = ["I-1", "J-1", "K-1"][plane];
            let circle = if sweep < 0.0 { "CIRCLE1" } else { "CIRCLE2" };
            format!("RAPID{to_start}\nNORMAL {normal}\nF10 {circle}{to}{way}\n")
        } else {
            let g = if sweep < 0.0 { "G2" } else { "G3" };
            format!("G94 F600 G0{to_start}\nG{} {g}{to}{way}\n", 19 - plane)
        };
        let program = good(dialect, &text);
        let (arc, a, b, seconds) = last_arc(&program);
        // Near half and full circles the radius determines the centre poorly.
        let loose = 1e-3 + 1e-6 * radius / (sweep.abs() - PI).abs().max(1e-6);
        assert!((arc.sweep - sweep.abs()).abs() < loose, "{text}: {} {}", arc.sweep, sweep.abs());
        let mut axis = DVec3::ZERO;
        axis[plane] = sweep.signum();
        assert!((arc.normal - axis).length() < 1e-12, "{text}: {arc:?}");
        for f in [0.0, 0.3, 0.7, 1.0] {
            let mut expected = on(from + f * sweep);
            expected[plane] += f * (end[plane] - start[plane]);
            let off = (arc.at(a, b, f) - expected).length();
            assert!(off < 1e-6 * (1.0 + radius) + radius * loose, "{text}: off by {off} at {f}");
        }
        let length = (radius * sweep).hypot(end[plane] - start[plane]);
        assert!(near(&[seconds], &[0.1 * length], 0.1 * radius * loose + 1e-6), "{text}: {seconds} {}", 0.1 * length);
    }
}
