//! Random programs written by a small writer of the test's own, and read back: rows, times, steps and their order.

#![allow(clippy::float_cmp, reason = "numbers as written come back exactly")]

use crate::reading::{self, near};
use seamwright_post::Dialect::{self, Grblhal, Linuxcnc, Pmac, Sinumerik};
use seamwright_post::{ChannelKind, Control, Event, Path, ReadOptions, What, read};
use seamwright_testkit::{Random, cases};
use std::fmt::Write;

/// Command written by the test, which the reader must find again.
#[derive(Debug, Clone, PartialEq)]
enum Told {
    Move { row: Vec<f64>, path: &'static str, seconds: f64, exact_stop: bool },
    Set(usize, f64, bool),
    Event(Event, bool),
    Dwell(f64),
}

/// A writer: the text so far, the modal state of the control, and the commands written.
struct Writer<'a> {
    control: &'a Control,
    random: &'a mut Random,
    text: String,
    told: Vec<Told>,
    row: Vec<f64>,
    incremental: bool,
    inverse: bool,
    inch: bool,
    exact: bool,
    feed: Option<f64>,
    number: u32,
}

impl Writer<'_> {
    fn dialect(&self) -> Dialect {
        self.control.dialect
    }

    /// A number with at most four decimals, in one of the forms that mean it.
    fn number(&mut self, value: f64) -> String {
        let mut text = format!("{value:.4}");
        if self.random.chance(0.5) {
            text = text.trim_end_matches('0').trim_end_matches('.').to_owned();
        }
        if text.starts_with("0.") && self.random.chance(0.3) {
            text.remove(0);
        }
        if value >= 0.0 && self.random.chance(0.1) {
            text.insert(0, '+');
        }
        text
    }

    /// Address and value; now and then as an expression.
    fn word(&mut self, address: &str, value: f64) -> String {
        let number = self.number(value);
        let (sum, one) = (self.random.chance(0.1), format!("{:.4}", value - 1.0));
        match self.dialect() {
            Sinumerik if sum => format!("{address}=1+({one})"),
            Sinumerik if address.len() > 1 || self.random.chance(0.5) => format!("{address}={number}"),
            Linuxcnc if sum => format!("{address}[1+{one}]"),
            Pmac if sum => format!("{address}(1+({one}))"),
            _ => format!("{address}{number}"),
        }
    }

    fn line(&mut self, words: &[String]) {
        if self.random.chance(0.3) && self.dialect() != Pmac {
            self.number += 10;
            let _ = write!(self.text, "N{} ", self.number);
        }
        let between = if self.random.chance(0.2) { "  " } else { " " };
        self.text += &words.join(between);
        if self.random.chance(0.05) {
            self.text += if self.dialect() == Sinumerik || self.dialect() == Pmac { " ; remark" } else { " (remark)" };
        }
        self.text += if self.random.chance(0.1) { "\r\n" } else { "\n" };
    }

    fn modes(&mut self) {
        let pmac = self.dialect() == Pmac;
        match self.random.below(if pmac { 1 } else { 4 }) {
            0 => {
                self.incremental = !self.incremental;
                let word = match (pmac, self.incremental) {
                    (true, true) => "INC",
                    (true, false) => "ABS",
                    (false, true) => "G91",
                    (false, false) => "G90",
                };
                self.line(&[word.into()]);
            }
            1 => {
                self.inverse = !self.inverse;
                self.feed = None;
                self.line(&[if self.inverse { "G93" } else { "G94" }.into()]);
            }
            2 => {
                self.inch = !self.inch;
                let words = if self.dialect() == Sinumerik { ["G71", "G70"] } else { ["G21", "G20"] };
                self.line(&[words[usize::from(self.inch)].into()]);
            }
            _ if self.dialect() == Grblhal => {}
            _ => {
                self.exact = !self.exact;
                let words = if self.dialect() == Sinumerik { ["G642", "G60"] } else { ["G64 P0.01 Q0", "G61"] };
                self.line(&[words[usize::from(self.exact)].into()]);
            }
        }
    }

    /// The time that the control takes, worked out here once more.
    fn seconds(&self, to: &[f64], f: f64) -> f64 {
        let axes = 5;
        let way = |set: &[usize]| set.iter().map(|i| (to[*i] - self.row[*i]).powi(2)).sum::<f64>().sqrt();
        let (xyz, all) = (way(&[0, 1, 2]), way(&(0..axes).collect::<Vec<_>>()));
        let every =
            way(&(0..to.len()).filter(|i| self.control.channels[*i].kind != ChannelKind::Stepped).collect::<Vec<_>>());
        if self.dialect() == Pmac {
            return 1e-3 * f;
        }
        if every == 0.0 {
            return 0.0;
        }
        let least = |per_minute: f64| per_minute.max(0.1);
        match (self.dialect(), self.inverse) {
            (Linuxcnc, true) => {
                let way = if xyz > 0.0 { xyz } else { all };
                60.0 * way / least(f * way)
            }
            (_, true) => 60.0 / f,
            (Linuxcnc, false) if xyz > 0.0 => 60.0 * xyz / least(if self.inch { 25.4 * f } else { f }),
            (Linuxcnc, false) => 60.0 * all / least(f),
            (Grblhal, false) => 60.0 * all / if self.inch { 25.4 * f } else { f },
            (_, false) => 60.0 * if xyz > 0.0 { xyz } else { every } / f,
        }
    }

    fn motion(&mut self) {
        let rapid = self.random.chance(0.2);
        let pmac = self.dialect() == Pmac;
        let mut words = vec![match (pmac, rapid) {
            (true, true) => "RAPID".to_owned(),
            (true, false) => "LINEAR".to_owned(),
            (false, true) => ["G0", "G00"][self.random.below(2)].to_owned(),
            (false, false) => ["G1", "G01"][self.random.below(2)].to_owned(),
        }];
        let mut to = self.row.clone();
        let interpolated: Vec<usize> =
            (0..to.len()).filter(|i| self.control.channels[*i].kind != ChannelKind::Stepped).collect();
        let mut any = false;
        let mut said = Vec::new();
        for i in interpolated {
            if self.random.chance(0.5) && any {
                continue;
            }
            any = true;
            let length = self.control.channels[i].kind == ChannelKind::Linear;
            let unit = if self.inch && length { 25.4 } else { 1.0 };
            let value = (self.random.within(-200.0, 200.0) * 1e4).round() / 1e4;
            to[i] = if self.incremental { self.row[i] + unit * value } else { unit * value };
            said.push(self.word(&self.control.addresses[i].clone(), value));
        }
        let f = (self.random.within(0.01, 900.0) * 1e4).round() / 1e4;
        let needs =
            !rapid && (self.feed.is_none() || self.random.chance(0.5) || (self.inverse && self.dialect() != Sinumerik));
        if needs {
            self.feed = Some(f);
            let word = if pmac { format!("TM({f:.4})") } else { self.word("F", f) };
            if pmac { words.push(word) } else { said.push(word) }
        }
        if !pmac {
            for i in (1..said.len()).rev() {
                said.swap(i, self.random.below(i + 1));
            }
        }
        words.extend(said);
        let once = self.dialect() == Sinumerik && self.random.chance(0.1);
        if once {
            words.push("G9".into());
        }
        self.line(&words);
        let seconds = if rapid { 0.0 } else { self.seconds(&to, self.feed.unwrap()) };
        self.row.clone_from(&to);
        let path = if rapid { "rapid" } else { "line" };
        self.told.push(Told::Move { row: to, path, seconds, exact_stop: self.exact || once });
    }

    fn output(&mut self) {
        let (at_once, on, output) = (self.random.chance(0.5), self.random.chance(0.5), self.random.below(6));
        let digit = u8::from(on);
        let text = match (self.dialect(), at_once) {
            (Sinumerik, true) => format!("$A_OUT[{}]={digit}", output + 1),
            (Sinumerik, false) => format!("WHEN TRUE DO $A_OUT[{}]={digit}", output + 1),
            (Pmac, true) => format!("M{}={digit}", output + 1),
            (Pmac, false) => format!("M{}=={digit}", output + 1),
            (_, at_once) => format!("M{} P{output}", 63 - i32::from(on) + 2 * i32::from(at_once)),
        };
        self.line(&[text]);
        let event = match output {
            0 => Event::Arc(on),
            1 => Event::Gas(on),
            2 => Event::Wire(on),
            _ => Event::Output(output as u16, on),
        };
        self.told.push(Told::Event(event, at_once));
    }

    fn value(&mut self) {
        let (at_once, output) = (self.random.chance(0.5), self.random.below(2));
        let value = (self.random.within(0.0, 400.0) * 1e4).round() / 1e4;
        let number = self.number(value);
        let text = match (self.dialect(), at_once) {
            (Sinumerik, true) => format!("$A_OUTA[{}]={number}", output + 1),
            (Sinumerik, false) => format!("WHEN TRUE DO $A_OUTA[{}]={number}", output + 1),
            (Pmac, true) => format!("M{}={number}", output + 101),
            (Pmac, false) => format!("M{}=={number}", output + 101),
            (_, true) => format!("M68 E{output} Q{number}"),
            (_, false) => format!("M67 E{output} Q{number}"),
        };
        self.line(&[text]);
        let channel = self.control.channel(["current_a", "voltage_v"][output]).unwrap();
        self.row[channel] = value;
        self.told.push(Told::Set(channel, value, at_once));
    }

    fn dwell(&mut self) {
        let seconds = (self.random.within(0.001, 5.0) * 1e4).round() / 1e4;
        let text = match self.dialect() {
            Sinumerik => format!("G4 F{seconds:.4}"),
            Pmac => format!("DWELL({:.4})", 1e3 * seconds),
            _ => format!("G4 P{seconds:.4}"),
        };
        self.line(&[text]);
        // Siemens' F of a dwell is no feed; with G93 the others need it in every block.
        self.told.push(Told::Dwell(seconds));
    }
}

fn same(told: &Told, what: &What, row: impl Fn(u32) -> Vec<f64>) -> bool {
    match (told, what) {
        (Told::Move { row: to, path, seconds, exact_stop }, What::Move(m)) => {
            near(&row(m.row), to, 1e-7)
                && matches!((*path, m.path), ("rapid", Path::Rapid) | ("line", Path::Line))
                && (m.seconds - seconds).abs() <= 1e-9 * (1.0 + seconds)
                && m.exact_stop == *exact_stop
        }
        (Told::Set(channel, value, at_once), What::Set { channel: c, value: v, at_once: a }) => {
            usize::from(*c) == *channel && (v - value).abs() < 1e-12 && a == at_once
        }
        (Told::Event(event, at_once), What::Event { event: e, at_once: a }) => e == event && a == at_once,
        (Told::Dwell(seconds), What::Dwell(s)) => (s - seconds).abs() < 1e-9,
        _ => false,
    }
}

#[test]
fn random_programs_come_back() {
    let mut random = Random::new(5);
    let controls = Dialect::ALL.map(reading::control);
    for case in 0..cases(4000) {
        let control = &controls[case % 4];
        let mut writer = Writer {
            control,
            row: vec![0.0; control.channels.len()],
            random: &mut random,
            text: String::new(),
            told: Vec::new(),
            incremental: false,
            inverse: false,
            inch: false,
            exact: false,
            feed: None,
            number: 0,
        };
        for _ in 0..writer.random.below(30) + 1 {
            match writer.random.below(10) {
                0 => writer.modes(),
                1 => writer.output(),
                2 => writer.value(),
                3 => writer.dwell(),
                _ => writer.motion(),
            }
        }
        let (text, told) = (writer.text, writer.told);
        let reading = read(control, "random", &text, &ReadOptions::default()).unwrap_or_else(|e| panic!("{text}\n{e}"));
        let program = &reading.program;
        let steps: Vec<&What> =
            program.steps.iter().map(|s| &s.what).filter(|w| !matches!(w, What::Comment(_))).collect();
        assert_eq!(steps.len(), told.len(), "{text}\n{steps:?}");
        for (told, what) in told.iter().zip(&steps) {
            assert!(same(told, what, |row| program.row(row).to_vec()), "{text}\n{told:?}\n{what:?}");
        }
    }
}

/// Numbers of any length and form are those of the standard library.
#[test]
fn random_numbers_are_rounded_correctly() {
    let mut random = Random::new(9);
    let control = reading::control(Linuxcnc);
    let mut text = String::new();
    let mut expected = Vec::new();
    for _ in 0..cases(20_000) {
        let digits = random.below(25);
        let decimals = random.below(25 - digits);
        let mut number: String = (0..digits.min(6)).map(|_| char::from(b'0' + random.below(10) as u8)).collect();
        if decimals > 0 || number.is_empty() {
            number.push('.');
            number.extend((0..decimals.max(1)).map(|_| char::from(b'0' + random.below(10) as u8)));
        }
        let sign = ["", "-", "+"][random.below(3)];
        expected.push(format!("{sign}{number}").trim_start_matches('+').parse::<f64>().unwrap());
        let _ = writeln!(text, "G0 X{sign}{number}");
    }
    let program = read(&control, "numbers", &text, &ReadOptions::default()).unwrap_or_else(|e| panic!("{e}")).program;
    for ((row, value), line) in reading::rows(&program).iter().zip(&expected).zip(text.lines()) {
        assert!(row[0].to_bits() == value.to_bits() || (row[0] == 0.0 && *value == 0.0), "{line}: {} {value}", row[0]);
    }
}
