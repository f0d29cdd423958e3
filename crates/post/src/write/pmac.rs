use super::dialect::Tongue;
use super::number::fixed;
use super::options::Feed;
use super::writer::{Problem, Writer};
use crate::part_program::{Arc, Move, Path};

/// Delta Tau's Turbo PMAC.
#[derive(Default)]
pub(super) struct Pmac {
    /// The move mode, if this pass has set it.
    mode: Option<Mode>,
    /// The last time (ms) or feed in this mode.
    time: Option<f64>,
    feed: Option<f64>,
    /// The last normal vector written.
    normal: Option<[f64; 3]>,
    /// Whether the last line with an effect is a move.
    moved: bool,
}

#[derive(Clone, Copy, PartialEq)]
enum Mode {
    Rapid,
    Linear,
    Circle(u32),
    Pvt,
    Spline,
}

/// Number of the motion program.
const PROGRAM: u32 = 1;

impl Pmac {
    /// Goes over to a mode; lines have no time for acceleration of their own.
    fn mode(&mut self, w: &mut Writer, mode: Mode) {
        if self.mode == Some(mode) {
            return;
        }
        let blends = |mode: Option<Mode>| matches!(mode, Some(Mode::Linear | Mode::Circle(_)));
        let added = if blends(self.mode) || !blends(Some(mode)) { "" } else { " TA0 TS0" };
        match mode {
            Mode::Rapid => w.text.word("RAPID"),
            Mode::Linear => w.text.word("LINEAR"),
            Mode::Circle(way) => w.text.counted("CIRCLE", way),
            Mode::Spline => w.text.word("SPLINE1"),
            Mode::Pvt => {}
        }
        w.text.glue(added);
        if mode != Mode::Pvt {
            w.text.end();
        }
        if !(blends(self.mode) && blends(Some(mode))) {
            (self.time, self.feed) = (None, None);
        }
        self.mode = Some(mode);
    }

    /// Time or feed of a line or an arc.
    fn pace(&mut self, w: &mut Writer, step: &Move, arc: Option<&Arc>, to: &[f64]) {
        let feed = if w.options.feed == Feed::PerMinute { w.feed(step, arc, to) } else { None };
        match feed {
            Some(_) if self.feed == feed => {}
            Some(value) => {
                bracketed(w, "F", value);
                (self.feed, self.time) = (feed, None);
            }
            None => self.time(w, "TM", step.seconds),
        }
    }

    /// A time in ms, if it is another one.
    fn time(&mut self, w: &mut Writer, word: &str, seconds: f64) {
        let ms = (seconds * 1e9).round() / 1e6;
        if self.time != Some(ms) {
            bracketed(w, word, ms);
            (self.time, self.feed) = (Some(ms), None);
        }
    }

    /// The mode, normal and centre of an arc, and its words.
    fn arc(&mut self, w: &mut Writer, step: &Move, index: u32, to: &[f64]) -> Result<(), Problem> {
        let arc = w.arc(index)?;
        if super::rs274::whole_turns(&arc) > 0 {
            return Err(Problem::plain("post-arc-more-than-turn", "post-split-arc"));
        }
        // By the control's rule a thumb along the vector makes fingers show clockwise, so the usual planes have
        // negative ones.
        let axis = (0..3).find(|k| arc.normal[*k].abs() > 1.0 - 1e-9);
        let sign = axis.map_or(1.0, |k| -arc.normal[k].signum());
        let normal = axis.map_or(arc.normal * sign, |k| -glam::DVec3::AXES[k]);
        self.mode(w, Mode::Circle(if sign * arc.sweep > 0.0 { 1 } else { 2 }));
        if self.normal != Some(normal.to_array()) {
            w.text.word("NORMAL");
            for (k, letter) in ["I", "J", "K"].iter().enumerate().filter(|(k, _)| normal[*k].abs() > 5e-7) {
                w.text.valued(letter, normal[k]);
            }
            w.text.end();
            self.normal = Some(normal.to_array());
        }
        self.pace(w, step, Some(&arc), to);
        let xyz = w.control.axes_xyz();
        w.words(to, |i| xyz.contains(&Some(i)));
        let to_centre = arc.centre - w.place(&w.here);
        for (k, letter) in ["I", "J", "K"].iter().enumerate().filter(|(k, _)| xyz[*k].is_some() && axis != Some(*k)) {
            w.text.fine(letter, to_centre[k]);
        }
        Ok(())
    }

    /// Waits for the end of the move before: the control executes lines ahead of the motion, and `=` would set values
    /// then.
    fn rest(&mut self, w: &mut Writer) {
        if std::mem::take(&mut self.moved) {
            w.text.line("DWELL0");
        }
    }

    fn state(&mut self, w: &mut Writer) {
        w.text.word("ABS TA0 TS0");
        if w.options.feed == Feed::PerMinute {
            w.all_axes("FRAX(");
        }
        w.text.end();
        *self = Self::default();
    }
}

/// A word with its value in brackets, which may be any number.
fn bracketed(w: &mut Writer, word: &str, value: f64) {
    w.text.word(word);
    w.text.glue("(");
    w.text.number(value);
    w.text.glue(")");
}

impl Tongue for Pmac {
    const SUBS: Option<bool> = None;

    fn head(&mut self, w: &mut Writer) {
        w.text.comment("axis definitions: put counts per mm and degree before the letters; circles need I5113 above 0");
        w.text.line("&1");
        for (k, address) in w.control.addresses.iter().take(w.program.axes()).enumerate() {
            w.text.counted("#", k as u32 + 1);
            w.text.glue("->");
            w.text.glue(address);
            w.text.end();
        }
        w.text.word("I5190=1000");
        w.text.comment("feeds per second");
        w.text.counted("OPEN PROG ", PROGRAM);
        w.text.line("CLEAR");
        if w.passes() == 0 {
            self.state(w);
        }
    }

    fn begin(&mut self, w: &mut Writer, number: u32, name: &str, _sub: bool) {
        w.text.counted("N", 1000 * number);
        w.text.comment(name);
        self.state(w);
    }

    fn end(&mut self, _w: &mut Writer, _number: u32, _sub: bool) {}

    fn tail(&mut self, w: &mut Writer) {
        w.text.line("CLOSE");
    }

    fn restart(&self, passes: u32) -> String {
        let last = fixed(f64::from(PROGRAM) + 0.01 * f64::from(passes), 2);
        format!("to start again at pass N: &1 B{PROGRAM}.0N R [line N1000 times N]; the last pass is B{last}")
    }

    fn wait(&mut self, w: &mut Writer) {
        self.rest(w);
    }

    fn go(&mut self, w: &mut Writer, step: &Move, to: &[f64]) -> Result<(), Problem> {
        match step.path {
            Path::Rapid => {
                if !w.order.iter().any(|i| w.changes(*i, to)) {
                    return Ok(());
                }
                self.mode(w, Mode::Rapid);
                w.words(to, |_| false);
            }
            Path::Line => {
                self.mode(w, Mode::Linear);
                self.pace(w, step, None, to);
                w.words(to, |_| false);
            }
            Path::Arc(index) => self.arc(w, step, index, to)?,
            Path::Hermite(speeds) => {
                self.mode(w, Mode::Pvt);
                self.time(w, "PVT", step.seconds);
                let speeds = w.program.row(speeds);
                for k in 0..w.order.len() {
                    let i = w.order[k];
                    w.text.valued(&w.control.addresses[i], to[i]);
                    w.text.glue(":");
                    w.text.number(speeds[i]);
                }
            }
            Path::Curve(_) => {
                return Err(Problem::plain("post-only-sinumerik", "post-plan-again-sinumerik"));
            }
            Path::Spline => {
                self.mode(w, Mode::Spline);
                // The one counts if I42 is 1, the other if it is 0.
                let before = self.time;
                self.time(w, "TA", step.seconds);
                if before != self.time {
                    self.time = None;
                    self.time(w, "TM", step.seconds);
                }
                w.words(to, |_| false);
            }
        }
        w.text.end();
        self.moved = !step.exact_stop;
        if step.exact_stop {
            w.text.word("DWELL0");
            w.text.comment("exact stop");
        }
        Ok(())
    }

    fn set(&mut self, w: &mut Writer, channel: usize, value: f64, at_once: bool) -> Result<(), Problem> {
        let control = w.control;
        if at_once {
            self.rest(w);
        }
        match control.outputs[channel] {
            Some(output) => w.text.counted("M", 101 + u32::from(output)),
            None => w.text.word(&control.addresses[channel]),
        }
        w.text.glue(if at_once { "=" } else { "==" });
        w.text.number(value);
        w.text.comment(&control.channels[channel].name);
        Ok(())
    }

    fn output(&mut self, w: &mut Writer, output: u32, on: bool, at_once: bool) {
        if at_once {
            self.rest(w);
        }
        w.text.counted("M", 1 + output);
        w.text.glue(if at_once { "=" } else { "==" });
        w.text.glue(if on { "1" } else { "0" });
    }

    fn message(&mut self, w: &mut Writer, text: &str) {
        w.text.word("SEND\"");
        w.text.clean(text, true);
        w.text.glue("\"");
        w.text.end();
    }

    fn dwell(&mut self, w: &mut Writer, seconds: f64, why: Option<&str>) {
        self.moved = false;
        bracketed(w, "DWELL", 1e3 * seconds);
        w.text.end_with(why);
    }
}
