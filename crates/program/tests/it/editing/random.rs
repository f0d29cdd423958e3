//! Random programs of both kinds with comments and expressions in many layouts, and random operations on them.

use seamwright_program::Program;
use seamwright_program::edit::Operation;
use seamwright_testkit::Random;
use serde_json::{Value, json};
use std::fmt::Write;

/// Writes programs; counts its comments so that each is known.
pub(crate) struct Writer<'a> {
    pub(crate) random: &'a mut Random,
    pub(crate) out: String,
    pub(crate) comments: usize,
}

impl Writer<'_> {
    /// Sometimes a comment line, indented.
    fn line(&mut self, indent: &str) {
        if self.random.below(4) == 0 {
            self.comments += 1;
            writeln!(self.out, "{indent}# line {}.", self.comments).unwrap();
        }
    }

    /// Ends the line, sometimes with a comment.
    fn behind(&mut self) {
        if self.random.below(4) == 0 {
            self.comments += 1;
            write!(self.out, " # behind {}.", self.comments).unwrap();
        }
        self.out.push('\n');
    }

    fn key(&mut self, key: &str, value: &str) {
        self.line("");
        write!(self.out, "{key} = {value}").unwrap();
        self.behind();
    }

    fn head(&mut self, header: &str) {
        if self.random.yes() {
            self.out.push('\n');
        }
        self.line("");
        self.out += header;
        self.behind();
    }

    /// A number, sometimes as an expression over the variables.
    fn value(&mut self, low: f64, high: f64) -> String {
        let value = self.random.number(low, high);
        match self.random.below(12) {
            0 => format!("\"= {value:?} + off - off\""),
            1 => format!("\"= two * {:?}\"", value / 2.0),
            _ if value.fract() == 0.0 && self.random.yes() => format!("{value:.0}"),
            _ => format!("{value:?}"),
        }
    }

    fn ramp(&mut self, low: f64, high: f64) -> String {
        if self.random.below(3) == 0 {
            format!("{{ from = {}, to = {} }}", self.value(low, high), self.value(low, high))
        } else {
            self.value(low, high)
        }
    }

    fn seam_pass(&mut self, i: usize) {
        self.head("[[passes]]");
        self.key("name", &format!("\"seam {i}\""));
        if self.random.yes() {
            let begin = self.value(0.0, 300.0);
            self.key("begin_mm", &begin);
        }
        if self.random.below(3) == 0 {
            let times = *self.random.one(&["2", "\"= two\""]);
            self.key("repeat", times);
        }
        let count = 1 + self.random.below(4);
        let mut from = 0.0;
        for _ in 0..count {
            let to = from + self.random.number(1.0, 200.0);
            self.head("[[passes.spans]]");
            self.key("from_mm", &format!("{from:?}"));
            self.key("to_mm", &format!("{to:?}"));
            let speed = self.ramp(3.0, 12.0);
            self.key("speed_mm_s", &speed);
            let (current, voltage) = (self.ramp(100.0, 300.0), self.value(20.0, 30.0));
            if self.random.yes() {
                self.key("process", &format!("{{ current_a = {current}, voltage_v = {voltage} }}"));
            } else {
                self.head("[passes.spans.process]");
                self.key("current_a", &current);
                self.key("voltage_v", &voltage);
            }
            from = to;
        }
    }

    fn points_pass(&mut self, i: usize) {
        let mut columns: Vec<&str> = match self.random.below(3) {
            0 => vec!["x_mm", "y_mm", "z_mm"],
            1 => vec!["x_mm", "y_mm", "z_mm", "ax", "ay", "az"],
            _ => vec!["x", "y", "z", "b"],
        };
        let poses = columns.len() == 6;
        columns.push("current_a");
        let stepped = self.random.below(3) == 0;
        if stepped {
            columns.push("wire_m_min");
        }
        if self.random.yes() {
            columns.push("n");
        }
        let timed = self.random.yes();
        columns.push(if timed { "time_s" } else { "speed_mm_s" });
        self.head("[[passes]]");
        self.key("name", &format!("\"points {i}\""));
        self.head("[passes.points]");
        self.key("columns", &format!("{columns:?}"));
        if stepped {
            self.key("stepped", "[\"wire_m_min\"]");
        }
        let start = self.row(&columns, poses, true);
        self.key("start", &start);
        let closed = self.random.yes();
        let spans = 1 + self.random.below(4);
        let counts: Vec<usize> = (0..spans).map(|_| 1 + self.random.below(5)).collect();
        let all = ["line", "line", "arc", "spline", "taught", "rapid", "cubic", "cubic"];
        let all = if timed { &all[..] } else { &all[..6] };
        let kinds: Vec<&str> = (0..spans).map(|_| *self.random.one(all)).collect();
        let counts: Vec<usize> = counts.into_iter().zip(&kinds).map(|(n, k)| if *k == "arc" { 1 } else { n }).collect();
        let inline = self.random.below(4) == 0;
        self.events(counts.iter().sum(), inline);
        for (k, (kind, count)) in kinds.iter().zip(&counts).enumerate() {
            self.head("[[passes.points.spans]]");
            self.key("along", &format!("\"{kind}\""));
            if *kind == "line" && self.random.below(5) == 0 {
                self.key("stops", "true");
            }
            if *kind == "arc" {
                let via: Vec<String> = (0..3).map(|_| self.value(-100.0, 100.0)).collect();
                self.key("via_mm", &format!("[{}]", via.join(", ")));
                if self.random.yes() {
                    self.key("normal", "[0, 0, 1]");
                }
            }
            if *kind == "cubic" {
                let places = columns.iter().take_while(|c| !c.starts_with("current")).count();
                let speeds: Vec<String> = (0..=*count).map(|_| self.speeds(places)).collect();
                self.rows("speeds", &speeds);
            }
            let mut rows: Vec<String> = (0..*count).map(|_| self.row(&columns, poses, *kind == "rapid")).collect();
            if closed && k + 1 == spans {
                let last = rows.last_mut().unwrap();
                let cells: Vec<&str> = last[1..last.len() - 1].split(", ").collect();
                let start: Vec<&str> = start[1..start.len() - 1].split(", ").collect();
                let place = columns.iter().take_while(|c| !c.starts_with("current")).count();
                *last = format!("[{}]", [&start[..place], &cells[place..]].concat().join(", "));
            }
            self.rows("points", &rows);
        }
    }

    fn speeds(&mut self, places: usize) -> String {
        let cells: Vec<String> = (0..places).map(|_| self.value(-30.0, 30.0)).collect();
        format!("[{}]", cells.join(", "))
    }

    fn row(&mut self, columns: &[&str], poses: bool, stands: bool) -> String {
        let last = columns.len() - 1;
        let cells: Vec<String> = (0..=last)
            .map(|i| match columns[i] {
                _ if i == last && stands => "0".to_owned(),
                _ if i == last => self.value(0.1, 9.0),
                "n" => (10 * self.random.below(99)).to_string(),
                "current_a" => self.value(50.0, 300.0),
                "wire_m_min" => self.random.below(3).to_string(),
                "az" if poses => self.random.number(-1.0, -0.2).min(-0.1).to_string(),
                "ax" | "ay" => self.value(-0.5, 0.5),
                _ => self.value(-100.0, 100.0),
            })
            .collect();
        format!("[{}]", cells.join(", "))
    }

    fn rows(&mut self, key: &str, rows: &[String]) {
        if self.random.below(3) == 0 {
            self.key(key, &format!("[{}]", rows.join(", ")));
            return;
        }
        self.line("");
        write!(self.out, "{key} = [").unwrap();
        self.behind();
        let comma = self.random.yes();
        for (i, row) in rows.iter().enumerate() {
            self.line("    ");
            let end = if i + 1 < rows.len() || comma { "," } else { "" };
            write!(self.out, "    {row}{end}").unwrap();
            self.behind();
        }
        self.line("  ");
        self.out += "]";
        self.behind();
    }

    fn events(&mut self, count: usize, inline: bool) {
        let mut events = Vec::new();
        for _ in 0..self.random.below(4) {
            let after = self.random.below(count + 1);
            let what = match self.random.below(4) {
                0 => format!("gas = {}", self.random.yes()),
                1 => format!("wire = {}", self.random.yes()),
                2 => format!("output = {}|on = {}", 1 + self.random.below(2), self.random.yes()),
                _ => format!("message = \"at {after}\""),
            };
            events.push(format!("after = {after}|{what}"));
        }
        if inline && !events.is_empty() {
            let all: Vec<String> = events.iter().map(|e| format!("{{ {} }}", e.replace('|', ", "))).collect();
            self.key("events", &format!("[{}]", all.join(", ")));
            return;
        }
        for event in events {
            self.head("[[passes.points.events]]");
            for pair in event.split('|') {
                let (key, value) = pair.split_once(" = ").unwrap();
                self.key(key, value);
            }
        }
    }
}

/// A random program's text, and how many comments it has.
pub(crate) fn program(random: &mut Random) -> (String, usize) {
    let mut w = Writer { random, out: String::new(), comments: 0 };
    w.line("");
    w.key("schema", "1");
    w.key("title", "\"= no expression\"");
    w.key("machine", "\"torch-5axis\"");
    w.key("offset", "\"table\"");
    w.head("[variables]");
    w.key("two", "2");
    w.key("off", "0.125");
    w.head("[offsets.table]");
    w.key("move_mm", "[1, 2, 3]");
    w.head("[offsets.chuck]");
    w.key("angle_deg", "30");
    w.head("[seam.nozzle]");
    w.key("radius_mm", "250");
    w.head("[seam.nozzle.body.cylinder]");
    w.key("radius_mm", "\"= 400 * two\"");
    for i in 0..1 + w.random.below(3) {
        if w.random.below(3) == 0 { w.seam_pass(i) } else { w.points_pass(i) }
    }
    w.line("");
    (w.out, w.comments)
}

fn range(random: &mut Random, low: usize, count: usize) -> [usize; 2] {
    let (a, b) = (low + random.below(count.max(low) + 1 - low), low + random.below(count.max(low) + 1 - low));
    [a.min(b), a.max(b)]
}

/// A random operation that is not in `without`; most are possible.
pub(crate) fn operation(random: &mut Random, program: &Program, without: &[&str]) -> Operation {
    loop {
        let value = any(random, program);
        if without.iter().any(|name| value["op"] == **name) {
            continue;
        }
        return serde_json::from_value(value.clone()).unwrap_or_else(|e| panic!("{e}: {value}"));
    }
}

fn any(random: &mut Random, program: &Program) -> Value {
    let passes = program.passes.len();
    let i = random.below(passes);
    let (pass, p) = (i + 1, &program.passes[i]);
    match random.below(8) {
        0 => return of_passes(random, passes, pass),
        1 => return of_all(random),
        _ => {}
    }
    match &p.points {
        Some(points) => {
            let (count, spans) = (points.count(), points.spans.len());
            of_points(random, pass, (count, spans))
        }
        None => {
            let length = p.length();
            let (a, b) = (random.within(0.0, length), random.within(0.0, length));
            let s = [a.min(b), a.max(b)];
            match random.below(8) {
                0 => json!({"op": "split_span", "pass": pass, "s_mm": a}),
                1 => json!({"op": "join_spans", "pass": pass, "span": 1 + random.below(p.spans.len())}),
                2 => json!({"op": "reverse_pass", "pass": pass, "seam_length_mm": 1600.0}),
                3 => json!({"op": "shift_start", "pass": pass, "begin_mm": a}),
                4 => json!({"op": "scale_speed", "pass": pass, "s_mm": s, "factor": random.number(0.5, 2.0)}),
                5 => json!({"op": "offset", "pass": pass, "across_mm": a / 100.0, "out_mm": 1, "work_angle_deg": 2}),
                6 => json!({"op": "set_process", "pass": pass, "s_mm": s, "name": "current_a", "value": 150}),
                _ => json!({"op": "set_process", "pass": pass, "s_mm": s, "name": "current_a",
                    "value": {"from": 100, "to": random.number(1.0, 200.0)}}),
            }
        }
    }
}

fn of_passes(random: &mut Random, passes: usize, pass: usize) -> Value {
    match random.below(5) {
        0 => json!({"op": "set_pass", "pass": pass, "name": "other", "role": "fill", "repeat": 3}),
        1 => json!({"op": "delete_pass", "pass": pass}),
        2 => json!({"op": "move_pass", "pass": pass, "to": 1 + random.below(passes)}),
        3 => json!({"op": "duplicate_pass", "pass": pass}),
        _ => json!({"op": "add_pass", "at": pass, "new": {"name": "new", "points": {
            "columns": ["x_mm", "y_mm", "z_mm", "time_s"], "start": [0, 0, 0, 0],
            "spans": [{"along": "line", "points": [[1, 2, 3, 4], [5, 6, 7, 8]]}]}}}),
    }
}

fn of_all(random: &mut Random) -> Value {
    match random.below(7) {
        0 => json!({"op": "set_offset", "name": random.one(&["table", "chuck"])}),
        1 => json!({"op": "set_offset"}),
        2 => json!({"op": "set_variable", "name": random.one(&["off", "new"]), "value": random.number(0.0, 3.0)}),
        3 => json!({"op": "format"}),
        4 => json!({"op": "scale_speed", "factor": random.number(0.5, 2.0)}),
        5 => json!({"op": "renumber", "start": 10, "step": 10}),
        _ => json!({"op": "shift_start", "phi_deg": random.number(0.0, 360.0)}),
    }
}

fn of_points(random: &mut Random, pass: usize, (count, spans): (usize, usize)) -> Value {
    let point = random.below(count + 1);
    let span = 1 + random.below(spans);
    let points = range(random, 1, count);
    match random.below(19) {
        18 => json!({"op": "set_point", "pass": pass, "point": point, "speeds": {"x_mm": random.number(-9.0, 9.0)}}),
        0 => json!({"op": "set_point", "pass": pass, "point": point, "set": {"current_a": random.number(0.0, 99.0)}}),
        1 => json!({"op": "insert_point", "pass": pass, "after": point}),
        2 => json!({"op": "delete_points", "pass": pass, "from": points[0], "to": points[1]}),
        3 => {
            json!({"op": "interpolate", "pass": pass, "span": span, "along": random.one(&["line", "spline", "cubic", "taught"])})
        }
        4 => {
            json!({"op": "interpolate", "pass": pass, "span": span, "along": "arc", "via_mm": [1, 2, random.number(-9.0, 9.0)]})
        }
        5 => json!({"op": "split_span", "pass": pass, "point": point}),
        6 => json!({"op": "join_spans", "pass": pass, "span": span}),
        7 => json!({"op": "reverse_pass", "pass": pass}),
        8 => json!({"op": "shift_start", "pass": pass, "point": point}),
        9 => json!({"op": "mirror", "pass": pass, "at_mm": [1, 0, 2], "normal": [1, random.number(-2.0, 2.0), 0.5]}),
        10 => json!({"op": "mirror", "pass": pass, "axis": random.one(&["x", "b"]), "about": random.number(-9.0, 9.0)}),
        11 => json!({"op": "scale_speed", "pass": pass, "points": points, "factor": random.number(0.5, 2.0)}),
        12 => {
            json!({"op": "offset", "pass": pass, "points": points, "dx_mm": 1, "dy_mm": random.number(-2.0, 2.0), "dz_mm": -1})
        }
        13 => json!({"op": "set_process", "pass": pass, "points": points, "name": "current_a",
            "value": {"from": 100, "to": random.number(1.0, 200.0)}}),
        14 => json!({"op": "renumber", "pass": pass, "start": random.below(9), "step": 5}),
        15 => json!({"op": "reduce", "pass": pass, "tolerance_mm": random.within(0.1, 60.0), "axis_tolerance": 200}),
        16 => json!({"op": "add_event", "pass": pass, "event": {"after": point, "message": "hm"}}),
        _ => json!({"op": "delete_event", "pass": pass, "event": 1}),
    }
}
