//! Sinumerik's POLY: the reader follows the control, checked by dense sums; as a program of points it moves the same.

use crate::reading::{self, MACHINE, good, refused};
use seamwright_document::Positive;
use seamwright_machine::Machine;
use seamwright_post::Dialect::{Linuxcnc, Pmac, Sinumerik};
use seamwright_post::{
    Control, Level, PartProgram, Path, ReadOptions, Segment, What, WriteOptions, play, read, to_program,
};
use seamwright_program::Along;
use seamwright_testkit::{Random, cases};
use std::fmt::Write as _;

const STEPS: usize = 20_000;

/// A block as written: for x, y, z, b and c the ends and the coefficients of the powers 2 and up of a parameter to
/// `length`.
struct Told {
    axes: [(f64, f64, [f64; 4]); 5],
    length: f64,
}

impl Told {
    fn at(&self, axis: usize, u: f64) -> f64 {
        let (from, to, higher) = self.axes[axis];
        let (p, l) = (u * self.length, self.length);
        let above = |p: f64| higher.iter().enumerate().map(|(k, a)| a * p.powi(k as i32 + 2)).sum::<f64>();
        from + (to - from - above(l)) / l * p + above(p)
    }

    /// Ways of the counted axes up to even steps of the parameter.
    fn ways(&self, counted: &[usize]) -> Vec<f64> {
        let mut ways = vec![0.0];
        for k in 0..STEPS {
            let [a, b] = [k, k + 1].map(|k| k as f64 / STEPS as f64);
            let square = |axis: &usize| (self.at(*axis, b) - self.at(*axis, a)).powi(2);
            ways.push(ways[k] + counted.iter().map(square).sum::<f64>().sqrt());
        }
        ways
    }
}

struct Case {
    text: String,
    told: Vec<Told>,
    counted: Vec<usize>,
    inverse_time: bool,
    feed: f64,
}

/// A random text that starts at zero.
fn case(seed: u32) -> Case {
    let mut random = Random::of_case(seed);
    let mut between = |low: f64, high: f64| (random.within(low, high) * 1e3).round() / 1e3;
    let inverse_time = between(0.0, 1.0) < 0.5;
    let feed = if inverse_time { between(2.0, 60.0) } else { between(100.0, 3000.0) };
    let all = between(0.0, 1.0) < 0.5;
    let mut text = format!(
        "G90 G71 {}\n{}",
        if inverse_time { "G93" } else { "G94" },
        if all { "FGROUP(X,Y,Z,B,C1)\n" } else { "" }
    );
    let names = ["X", "Y", "Z", "B", "C1"];
    let (mut here, mut told) = ([0.0; 5], Vec::new());
    for _ in 0..3 {
        let length = if between(0.0, 1.0) < 0.5 { 1.0 } else { between(0.1, 5.0) };
        let powers = 2 + (between(0.0, 2.99) as usize);
        let mut axes = [(0.0, 0.0, [0.0; 4]); 5];
        let _ = write!(text, "POLY");
        for (i, name) in names.iter().enumerate() {
            let mut higher = [0.0; 4];
            // The first three always bend, so that the counted axes always move.
            let bends = i < 3 || between(0.0, 1.0) < 0.5;
            let to = if i < 3 { here[i] + between(5.0, 40.0) } else { between(-40.0, 40.0) };
            if bends {
                for (k, a) in higher.iter_mut().enumerate().take(powers) {
                    *a = (between(-8.0, 8.0) / length.powi(k as i32 + 2) * 1e3).round() / 1e3;
                }
                let list: Vec<String> = higher[..powers].iter().map(f64::to_string).collect();
                let _ = write!(text, " PO[{name}]=({to}, {})", list.join(","));
            } else {
                let _ = write!(text, " {name}={to}");
            }
            axes[i] = (here[i], to, higher);
            here[i] = to;
        }
        let _ = writeln!(text, " PL={length} F={feed}");
        told.push(Told { axes, length });
    }
    Case { text, told, counted: if all { (0..5).collect() } else { (0..3).collect() }, inverse_time, feed }
}

fn play_all(program: &PartProgram) -> Vec<Segment> {
    play(program, &vec![0.0; program.channels.len()])
}

#[test]
fn random_polynomials_are_gone_along_evenly() {
    let machine = Machine::read("test", MACHINE).unwrap();
    let control = Control::new(&machine, Sinumerik).unwrap();
    for seed in 0..cases(100) {
        let case = case(seed);
        let program = good(Sinumerik, &case.text);
        let segments = play_all(&program);
        assert_eq!(segments.len(), case.told.len());
        for (segment, told) in segments.iter().zip(&case.told) {
            let ways = told.ways(&case.counted);
            let whole = ways[STEPS];
            let seconds = if case.inverse_time { 60.0 / case.feed } else { 60.0 * whole / case.feed };
            assert!((segment.seconds / seconds - 1.0).abs() < 1e-6, "seed {seed}: {} {seconds}", segment.seconds);
            let mut row = Vec::new();
            for k in 0..=16 {
                let f = f64::from(k) / 16.0;
                let above = ways.partition_point(|way| *way < f * whole).clamp(1, STEPS);
                let share = (f * whole - ways[above - 1]) / (ways[above] - ways[above - 1]);
                let u = ((above - 1) as f64 + share) / STEPS as f64;
                segment.at(f, &mut row);
                for (axis, value) in row.iter().enumerate().take(5) {
                    let off = (value - told.at(axis, u)).abs();
                    assert!(off < 2e-5, "seed {seed} at {f}: axis {axis} is off by {off}");
                }
            }
        }
        // Written again where all axes count.
        if case.counted.len() == 5 {
            let of = |program| seamwright_post::write(&control, program, &WriteOptions::default());
            let error = of(&program).unwrap_err().to_string();
            assert!(error.contains("start the pass with a line"), "{error}");
            let program = good(Sinumerik, &format!("G0 X0 Y0 Z0 B0 C1=0\n{}", case.text));
            let back = good(Sinumerik, &of(&program).unwrap());
            let [asked, told] = [&program, &back].map(play_all);
            assert_eq!(asked.len(), told.len());
            let (mut a, mut b) = (Vec::new(), Vec::new());
            for (asked, told) in asked.iter().zip(&told) {
                for f in [0.0, 0.3, 0.8, 1.0] {
                    asked.at(f, &mut a);
                    told.at(f, &mut b);
                    assert!(reading::near(&a, &b, 1e-6), "seed {seed}: {a:?} {b:?}");
                }
                assert!((asked.seconds - told.seconds).abs() < 1e-6);
            }
        }
    }
}

/// As a program of points, by its cubics in time.
#[test]
fn as_points_they_move_the_same() {
    let machine = Machine::read("test", MACHINE).unwrap();
    let control = Control::new(&machine, Sinumerik).unwrap();
    for (seed, level) in (0..120).map(|seed| (seed, if seed % 3 == 0 { Level::Tip } else { Level::Joint })) {
        let start = vec![0.0; control.channels.len()];
        let options = ReadOptions { level, ..ReadOptions::default() };
        let program = read(&control, "test", &case(seed).text, &options).unwrap_or_else(|e| panic!("{e}")).program;
        let segments = play_all(&program);
        let made = to_program(&machine, &control, &program, &start, "test", Positive::new(0.1).unwrap()).unwrap();
        seamwright_program::Program::read("made", &made.to_toml().unwrap()).unwrap_or_else(|e| panic!("{e}"));
        let points = made.passes[0].points.as_ref().unwrap();
        let places = if level == Level::Tip { 6 } else { 5 };
        let (mut time, mut worst) = (0.0, 0.0f64);
        let mut before = points.start.clone();
        let mut row = Vec::new();
        for span in &points.spans {
            assert_eq!(span.along, Along::Cubic);
            for (k, point) in span.points.iter().enumerate() {
                let seconds = point[point.len() - 1].get();
                for f in [0.2, 0.5, 0.7, 1.0] {
                    let now = time + f * seconds;
                    let segment = segments.iter().rfind(|s| s.begin <= now).unwrap();
                    segment.at(((now - segment.begin) / segment.seconds).min(1.0), &mut row);
                    let mut q = seamwright_machine::Joints::default();
                    for (i, axis) in machine.axes.iter().enumerate() {
                        q[i] = axis.from_file(row[i]);
                    }
                    let turned = machine.forward(&q).direction.to_array();
                    for i in 0..places {
                        let (a, b) = (before[i].get(), point[i].get());
                        let [v0, v1] = [k, k + 1].map(|k| span.speeds[k][i].get() * seconds);
                        let cubic = a + f * (v0 + f * (3.0 * (b - a) - 2.0 * v0 - v1 + f * (v0 + v1 - 2.0 * (b - a))));
                        let told = if places == 6 && i > 2 { turned[i - 3] } else { row[i] };
                        worst = worst.max((cubic - told).abs());
                    }
                }
                time += seconds;
                before.clone_from(point);
            }
        }
        assert!(worst < 1e-5, "seed {seed}: {worst}");
    }
}

#[test]
fn words_of_polynomials() {
    let program = good(
        Sinumerik,
        "G0 X1\nPOLYPATH(\"AXES\",\"VECT\")\nF600 POLY PO[Y]=(3,-1) X2\nX5\nG91 PO[X]=(1,2,3)\nG1 Z1\n",
    );
    let paths: Vec<Path> = reading::moves(&program).iter().map(|m| m.path).collect();
    assert!(matches!(paths[..], [Path::Rapid, Path::Curve(0), Path::Line, Path::Curve(1), Path::Line]), "{paths:?}");
    assert!((program.row(program.curves[0].row)[1] + 1.0).abs() < 1e-15);
    let rows = reading::rows(&program);
    assert!((rows[3][0] - 6.0).abs() < 1e-12, "{rows:?}");
    // Inches hold for coefficients too.
    let program = good(Sinumerik, "G70 F60 POLY PO[X]=(1,1,0.5)\n");
    assert!((program.row(program.curves[0].row)[0] - 25.4).abs() < 1e-12);
    assert!((program.row(program.curves[0].row + 1)[0] - 12.7).abs() < 1e-12);
}

#[test]
fn what_is_no_polynomial() {
    refused(Sinumerik, "F60 G1 PO[X]=(1,2)\n", 1, 8, "only POLY");
    refused(Sinumerik, "F60 POLY PO[]=(1,2)\n", 1, 10, "denominator");
    refused(Sinumerik, "F60 POLY PO[Q]=(1,2)\n", 1, 13, "neither an address");
    refused(Sinumerik, "F60 POLY PO[CW]=(1,2)\n", 1, 13, "only axes");
    refused(Sinumerik, "F60 POLY PO[X]=(1,2,3,4,5,6)\n", 1, 27, "above five");
    refused(Sinumerik, "F60 POLY PO[X]=(1,2 PL=1\n", 1, 21, ")");
    refused(Sinumerik, "F60 POLY PO[X]=(1,100000000)\n", 1, 19, "too large");
    refused(Sinumerik, "F60 POLY PO[X]=(1,2) PL=0\n", 1, 22, "length of a parameter");
    refused(Sinumerik, "F60 POLY PO[X]=(1,2) X=1\n", 1, 22, "twice");
    refused(Sinumerik, "POLY PO[X]=(1,2)\n", 1, 6, "F is missing");
    refused(Sinumerik, "F60 BSPLINE X1\n", 1, 5, "not read");
    refused(Sinumerik, "POLYPATH(\"VECT\")\n", 1, 1, "AXES");
}

#[test]
fn other_controls_have_none() {
    let machine = Machine::read("test", MACHINE).unwrap();
    let mut program = good(Sinumerik, "G0 X0 Y0 Z0 B0 C1=0\nF60 POLY PO[X]=(1,2)\n");
    assert!(program.steps.iter().any(|s| matches!(s.what, What::Move(m) if matches!(m.path, Path::Curve(_)))));
    for dialect in [Linuxcnc, Pmac] {
        let control = Control::new(&machine, dialect).unwrap();
        program.channels.clone_from(&control.channels);
        let error = seamwright_post::write(&control, &program, &WriteOptions::default()).unwrap_err().to_string();
        assert!(error.contains("only"), "{error}");
    }
}
