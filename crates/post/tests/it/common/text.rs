//! A small reader of the four dialects, for tests: lines to words, words to rows and times.

#![allow(dead_code, reason = "each test uses a part")]
#![allow(clippy::float_cmp, reason = "codes are whole numbers")]

use glam::DVec3;
use seamwright_post::{Control, Dialect};
use std::f64::consts::TAU;

/// Content read from a text.
#[derive(Default)]
pub(crate) struct Read {
    /// The row after each line of motion.
    pub(crate) rows: Vec<Vec<f64>>,
    /// Time of each of them, s; 0 for rapid ones.
    pub(crate) times: Vec<f64>,
    /// All dwells, s.
    pub(crate) dwells: f64,
    /// Lines that are neither comments nor empty.
    pub(crate) lines: usize,
}

/// The address and the value of each word: `X=1.5`, `X1.5`, `X1.5:2` (two values), `TM(5)`.
fn words(line: &str, comma: bool) -> Vec<(String, Vec<f64>)> {
    let number = |text: &str| -> f64 {
        let text = if comma { text.replace(',', ".") } else { text.to_owned() };
        let digits = text.trim_start_matches('-');
        assert!(digits.starts_with(|c: char| c.is_ascii_digit()) && !digits.ends_with('.'), "{line}");
        assert!(digits.split('.').nth(1).is_none_or(|d| d.len() <= 9 && !d.ends_with('0')), "{line}");
        assert!(text != "-0" && !digits.contains(['e', 'E', '-', '+']), "{line}");
        text.parse().unwrap_or_else(|_| panic!("{text} in {line}"))
    };
    line.split_whitespace()
        .filter(|word| !["ABS", "CIP", "CLEAR"].contains(word))
        .map(|word| match word.split_once('=') {
            Some((address, value)) => (address.to_owned(), vec![number(value)]),
            None => {
                let at = word.find(|c: char| c.is_ascii_digit() || c == '-' || c == '(').unwrap_or(word.len());
                let values = word[at..].trim_start_matches('(').trim_end_matches(')');
                (word[..at].to_owned(), values.split(':').filter(|v| !v.is_empty()).map(number).collect())
            }
        })
        .collect()
}

/// The line without its comment; comments must be closed.
fn bare(dialect: Dialect, line: &str) -> &str {
    match dialect {
        Dialect::Linuxcnc | Dialect::Grblhal => match line.split_once('(') {
            Some((code, rest)) => {
                assert!(rest.ends_with(')') && !rest[..rest.len() - 1].contains(['(', ')']), "{line}");
                code
            }
            None => line,
        },
        _ => line.split(';').next().unwrap(),
    }
    .trim()
}

/// Beginnings of Siemens' lines that hold no words.
#[rustfmt::skip]
const SINUMERIK: [&str; 10] = [
    "%_N_", "$A_OUT", "WHEN TRUE DO $A_OUT", "FGROUP(", "PRESETON(", "TRAORI", "TRAFOOF", "ORIMKS", "PASS_", "MSG(",
];

fn is_other(dialect: Dialect, line: &str) -> bool {
    let starts: &[&str] = match dialect {
        Dialect::Sinumerik => &SINUMERIK,
        Dialect::Linuxcnc => &["o1"],
        Dialect::Grblhal => &[],
        Dialect::Pmac => &["&1", "#", "I5190=", "OPEN PROG 1 CLEAR", "CLOSE", "M", "SEND", "ABS"],
    };
    starts.iter().any(|s| line.starts_with(s))
}

/// Reads a text and checks its form line by line.
pub(crate) fn read(control: &Control, text: &str) -> Read {
    let longest = match control.dialect {
        Dialect::Linuxcnc | Dialect::Pmac => 255,
        Dialect::Grblhal => 256,
        Dialect::Sinumerik => 512,
    };
    let mut read = Read::default();
    let mut row = vec![f64::NAN; control.channels.len()];
    let (mut inverse, mut mode, mut time, mut feed) = (None, String::new(), 0.0, f64::NAN);
    let (mut vector, mut clockwise) = (DVec3::ZERO, true);
    for line in text.lines() {
        assert!(line.is_ascii() && line.len() <= longest && line.trim_end() == line, "{line}");
        let line = bare(control.dialect, line);
        let line = match line.split_once(' ') {
            Some((n, rest)) if n.starts_with('N') && n[1..].parse::<u32>().is_ok() => rest,
            _ => line,
        };
        if line.is_empty() || line.starts_with('N') && control.dialect == Dialect::Pmac && !line.starts_with("NORMAL") {
            continue;
        }
        read.lines += 1;
        if is_other(control.dialect, line) {
            continue;
        }
        let words = words(line, control.decimal_comma);
        let value = |address: &str| words.iter().find(|(a, _)| a == address).map(|(_, v)| v[0]);
        let has = |address: &str, number: f64| words.iter().any(|(a, v)| a == address && v[0] == number);
        for (code, on) in [(93.0, true), (94.0, false)] {
            if has("G", code) {
                inverse = Some(on);
            }
        }
        if line.starts_with("NORMAL") {
            vector = DVec3::from_array(["I", "J", "K"].map(|letter| value(letter).unwrap_or(0.0)));
        }
        if let Some(turn) = value("CIRCLE") {
            clockwise = turn == 1.0;
        }
        // A right thumb along the vector has fingers that show clockwise.
        let normal = Some(if clockwise { vector } else { -vector });
        if control.dialect == Dialect::Pmac {
            if let Some(word) = ["RAPID", "LINEAR", "CIRCLE", "PVT", "SPLINE"].iter().find(|m| line.starts_with(**m)) {
                mode = (*word).to_owned();
            }
            if let Some(ms) = value("TM").or(value("PVT")) {
                time = 1e-3 * ms;
                feed = f64::NAN;
            }
            feed = value("F").unwrap_or(feed);
            read.dwells += value("DWELL").map_or(0.0, |ms| 1e-3 * ms);
        } else if has("G", 4.0) {
            read.dwells += value("P").or(value("F")).unwrap();
            continue;
        } else {
            feed = value("F").unwrap_or(feed);
        }
        let before = row.clone();
        let mut any = false;
        for (address, values) in &words {
            let channel = (!address.is_empty()).then(|| control.addresses.iter().position(|a| a == address)).flatten();
            let known =
                ["G", "F", "I", "J", "K", "I1", "J1", "K1", "TM", "TA", "TS", "TURN", "P", "PVT", "M", "E", "Q", "L"];
            let modes = ["RAPID", "LINEAR", "CIRCLE", "SPLINE", "NORMAL", "DWELL", "S"];
            assert!(
                channel.is_some() || known.contains(&address.as_str()) || modes.contains(&address.as_str()),
                "{line}"
            );
            if let Some(i) = channel.filter(|i| !control.addresses[*i].is_empty()) {
                row[i] = values[0];
                any = true;
                let pvt = mode == "PVT" && control.dialect == Dialect::Pmac;
                assert_eq!(values.len(), if pvt { 2 } else { 1 }, "{line}");
            }
        }
        let moves = ["G0", "G1", "G2", "G3", "CIP"].iter().any(|g| line.split(' ').any(|w| w == *g));
        if !moves && (control.dialect != Dialect::Pmac || !any) {
            continue;
        }
        let rapid = has("G", 0.0) || (control.dialect == Dialect::Pmac && mode == "RAPID");
        let way = || way(control, &before, &row, &words, normal.filter(|_| mode == "CIRCLE"), &value);
        let seconds = match (control.dialect, inverse) {
            _ if rapid => 0.0,
            (Dialect::Pmac, _) if feed.is_nan() => time,
            (Dialect::Pmac, _) => way() / feed,
            (Dialect::Linuxcnc, Some(true)) => 60.0 * way() / (way() * value("F").unwrap()).max(0.1),
            (_, Some(true)) => 60.0 / value("F").unwrap(),
            (_, Some(false)) => 60.0 * way() / feed,
            (_, None) => panic!("{line}"),
        };
        assert!(rapid || seconds > 0.0, "{line}");
        read.rows.push(row.clone());
        read.times.push(seconds);
    }
    read
}

/// The way that a feed counts: LinuxCNC X Y Z if they move, else A B C; the others all axes.
fn way(
    control: &Control,
    before: &[f64],
    row: &[f64],
    words: &[(String, Vec<f64>)],
    normal: Option<DVec3>,
    value: &dyn Fn(&str) -> Option<f64>,
) -> f64 {
    let is = |i: usize, letters: &str| {
        use seamwright_post::ChannelKind::{Linear, Rotary};
        matches!(control.channels[i].kind, Linear | Rotary) && letters.contains(control.addresses[i].as_str())
    };
    let sum =
        |letters: &str| (0..row.len()).filter(|i| is(*i, letters)).map(|i| (row[i] - before[i]).powi(2)).sum::<f64>();
    let place = |row: &[f64]| {
        let axis = |letter: &str| control.addresses.iter().position(|a| a == letter);
        DVec3::from_array(["X", "Y", "Z"].map(|letter| axis(letter).map_or(0.0, |i| row[i])))
    };
    let (from, to) = (place(before), place(row));
    let centre = from + DVec3::from_array(["I", "J", "K"].map(|letter| value(letter).unwrap_or(0.0)));
    let coded = |code: f64| words.iter().any(|w| w.0 == "G" && w.1[0] == code);
    let square = ["I", "J", "K"].iter().position(|letter| value(letter).is_none()).map_or(DVec3::Z, |k| DVec3::AXES[k]);
    let linear = if let Some(i) = value("I1") {
        through(from, DVec3::new(i, value("J1").unwrap(), value("K1").unwrap()), to).powi(2)
    } else if coded(2.0) {
        round(from, to, centre, -square).powi(2)
    } else if coded(3.0) {
        round(from, to, centre, square).powi(2)
    } else if let Some(normal) = normal {
        round(from, to, centre, normal).powi(2)
    } else {
        sum("XYZ")
    };
    let axis = |i: usize| !matches!(control.addresses[i].as_str(), "X" | "Y" | "Z") && is(i, &control.addresses[i]);
    let others = (0..row.len()).filter(|i| axis(*i)).map(|i| (row[i] - before[i]).powi(2)).sum::<f64>();
    match control.dialect {
        Dialect::Linuxcnc if linear > 0.0 => linear.sqrt(),
        _ => (linear + others).sqrt(),
    }
}

/// Length of the arc or helix from `a` to `b` round `centre`, right-handed about `normal`.
fn round(a: DVec3, b: DVec3, centre: DVec3, normal: DVec3) -> f64 {
    let n = normal.normalize();
    let (u, v) = ((a - centre).reject_from_normalized(n), (b - centre).reject_from_normalized(n));
    assert!((u.length() - v.length()).abs() < 1e-5 * u.length().max(1.0), "{u} {v}");
    let angle = u.cross(v).dot(n).atan2(u.dot(v)).rem_euclid(TAU);
    (angle * u.length()).hypot((b - a).dot(n))
}

/// Length of the arc through three points: twice the radius times the angles over both parts' chords.
fn through(a: DVec3, middle: DVec3, b: DVec3) -> f64 {
    let (p, q, r) = (a.distance(middle), middle.distance(b), a.distance(b));
    let radius = p * q * r / (2.0 * (middle - a).cross(b - a).length());
    let part = |chord: f64| 2.0 * radius * (0.5 * chord / radius).min(1.0).asin();
    part(p) + part(q)
}
