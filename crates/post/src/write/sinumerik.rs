use super::dialect::Tongue;
use super::feed_mode::FeedMode;
use super::rs274::{arc_words, whole_turns};
use super::writer::{Problem, Writer};
use crate::part_program::{Arc, ChannelKind, Level, Move, Path};
use crate::polynomial::POWERS;

/// Siemens Sinumerik 840D.
#[derive(Default)]
pub(super) struct Sinumerik {
    /// The last block number.
    number: u32,
    mode: FeedMode,
    /// The axis square to the plane of arcs: X, Y or Z.
    plane: Option<usize>,
}

/// Folder of the programs in the control.
const FOLDER: &str = ";$PATH=/_N_WKS_DIR/_N_SEAMWRIGHT_WPD";

impl Sinumerik {
    fn block(&mut self, w: &mut Writer) {
        if w.numbered {
            if let Some(number) = w.number.take() {
                w.text.counted("N", number);
            }
            return;
        }
        self.number = self.number.saturating_add(10);
        w.text.counted("N", self.number);
    }

    fn line(&mut self, w: &mut Writer, text: &str) {
        self.block(w);
        w.text.line(text);
    }

    /// The feed to be written, after its mode: in the same block, since words that wait for the next block must meet
    /// the motion.
    fn feed(&mut self, w: &mut Writer, step: &Move, arc: Option<&Arc>, to: &[f64]) -> Option<f64> {
        let (mode, feed) = self.mode.words_before(w, step, arc, to);
        mode.into_iter().for_each(|mode| w.text.word(mode));
        feed
    }

    /// The way of an arc: G2 or G3 in a plane, or CIP through its middle.
    fn arc(&mut self, w: &mut Writer, arc: &Arc, to: &[f64]) -> Result<(), Problem> {
        let Some(square) = (0..3).find(|k| arc.normal[*k].abs() > 1.0 - 1e-9) else {
            if whole_turns(arc) > 0 {
                return Err(Problem::plain("post-slanted-arc-turns", "post-two-arcs"));
            }
            let (from, end) = (w.place(&w.here), w.place(to));
            if (end - from).dot(arc.normal).abs() > 1e-4 {
                return Err(Problem::plain("post-slanted-helix", "post-make-lines"));
            }
            w.text.word("CIP");
            Self::words(w, to, [true; 3]);
            let middle = arc.at(from, end, 0.5);
            (0..3).for_each(|k| w.text.fine(["I1=", "J1=", "K1="][k], middle[k]));
            return Ok(());
        };
        arc_words(w, &mut self.plane, square, arc);
        Self::words(w, to, std::array::from_fn(|k| k != square));
        let to_centre = arc.centre - w.place(&w.here);
        (0..3).filter(|k| *k != square).for_each(|k| w.text.fine(["I=", "J=", "K="][k], to_centre[k]));
        if whole_turns(arc) > 0 {
            w.text.counted("TURN=", whole_turns(arc));
        }
        Ok(())
    }

    /// The way of a curve: POLY with the axes that go evenly by their ends alone.
    fn curve(w: &mut Writer, index: u32, to: &[f64]) -> Result<(), Problem> {
        let (program, axes) = (w.program, w.program.axes());
        let curve = program.curves[index as usize];
        let problem = |what, cure| Err(Problem::plain(what, cure));
        let all = (1 << axes) - 1;
        if w.control.decimal_comma {
            return problem("post-polynomials-with-commas", "post-lines-and-arcs");
        }
        if curve.counted != all {
            return problem("post-polynomial-feed", "post-make-lines");
        }
        if !w.known {
            return problem("post-polynomial-start", "post-begin-pass-with-line");
        }
        w.text.word("POLY");
        let higher = |i: usize| (0..POWERS as u32).map(move |k| program.row(curve.row + k)[i]);
        let bent = |i: usize| i < axes && higher(i).any(|c| c.abs() > 0.0);
        for k in 0..w.order.len() {
            let i = w.order[k];
            if !bent(i) {
                if Self::changes(w, i, to) {
                    Self::put(w, i, to[i]);
                }
                continue;
            }
            w.text.word("PO[");
            w.text.glue(&w.control.addresses[i]);
            w.text.glue("]=(");
            w.text.number(to[i]);
            let last = higher(i).rposition(|c| c.abs() > 0.0).unwrap_or(0);
            for c in higher(i).take(last + 1) {
                w.text.glue(",");
                w.text.fine_number(c);
            }
            w.text.glue(")");
        }
        Ok(())
    }

    /// The words of a row that have changed, and those of X, Y and Z that are asked for.
    fn words(w: &mut Writer, to: &[f64], asked: [bool; 3]) {
        let xyz = w.control.axes_xyz();
        for k in 0..w.order.len() {
            let i = w.order[k];
            if Self::changes(w, i, to) || (0..3).any(|k| asked[k] && xyz[k] == Some(i)) {
                Self::put(w, i, to[i]);
            }
        }
    }

    /// Whether a channel needs a word; process values have been set before the first move.
    fn changes(w: &Writer, i: usize, to: &[f64]) -> bool {
        let process = w.control.channels[i].kind == ChannelKind::Interpolated;
        if process { w.here.get(i) != Some(&to[i]) } else { w.changes(i, to) }
    }

    /// A channel's word.
    fn put(w: &mut Writer, i: usize, value: f64) {
        w.text.word(&w.control.addresses[i]);
        w.text.glue("=");
        w.text.number(value);
    }

    /// `$A_OUT[n]=` or `$A_OUTA[n]=` at once, or with the next move.
    fn out(&mut self, w: &mut Writer, variable: &str, number: u32, at_once: bool) {
        self.block(w);
        if !at_once {
            w.text.word("WHEN TRUE DO");
        }
        w.text.counted(variable, number);
        w.text.glue("]=");
    }
}

impl Tongue for Sinumerik {
    const SUBS: Option<bool> = Some(false);

    fn first(&mut self, w: &mut Writer) {
        if w.has_subs() {
            w.text.line("%_N_WELD_MPF");
            w.text.line(FOLDER);
        }
    }

    fn head(&mut self, w: &mut Writer) {
        self.line(w, "G90 G710 G17 G40 G500 G64");
        self.plane = Some(2);
        self.block(w);
        w.all_axes("FGROUP(");
        w.text.end();
    }

    fn begin(&mut self, w: &mut Writer, number: u32, name: &str, sub: bool) {
        if sub {
            w.text.counted("%_N_PASS_", number);
            w.text.glue("_SPF");
            w.text.end();
            w.text.line(FOLDER);
            w.text.comment(name);
        }
        (self.mode, self.plane) = (FeedMode::default(), None);
    }

    fn end(&mut self, w: &mut Writer, _number: u32, sub: bool) {
        if self.mode.inverse == Some(true) {
            self.line(w, "G94");
        }
        self.mode = FeedMode::default();
        if sub {
            self.line(w, "M17");
        }
    }

    fn call(&mut self, w: &mut Writer, number: u32, name: &str) {
        w.text.counted("PASS_", number);
        w.text.comment(name);
    }

    fn tail(&mut self, w: &mut Writer) {
        self.line(w, "M30");
    }

    fn restart(&self, passes: u32) -> String {
        format!("to start again at pass N take out the calls before PASS_N; the last pass is PASS_{passes}")
    }

    fn level(&mut self, w: &mut Writer, level: Level) {
        self.line(w, if level == Level::Tip { "TRAORI" } else { "TRAFOOF" });
        if level == Level::Tip {
            // Rotary axes go evenly, as in the plan, regardless of the control's default.
            self.line(w, "ORIMKS ORIAXES");
        }
    }

    fn go(&mut self, w: &mut Writer, step: &Move, to: &[f64]) -> Result<(), Problem> {
        let arc = match step.path {
            Path::Rapid | Path::Line | Path::Curve(_) => None,
            Path::Arc(index) => Some(w.arc(index)?),
            Path::Hermite(_) | Path::Spline => {
                return Err(Problem::plain("post-only-pmac", "post-plan-again-pmac"));
            }
        };
        let rapid = step.path == Path::Rapid;
        if rapid && w.pending.is_empty() && !w.order.iter().any(|i| w.changes(*i, to)) {
            return Ok(());
        }
        self.block(w);
        let feed = if rapid { None } else { self.feed(w, step, arc.as_ref(), to) };
        if step.exact_stop {
            w.text.word("G9");
        }
        match (&arc, step.path) {
            (_, Path::Curve(index)) => Self::curve(w, index, to)?,
            (None, _) => {
                w.text.word(if rapid { "G0" } else { "G1" });
                Self::words(w, to, [false; 3]);
            }
            (Some(arc), _) => self.arc(w, arc, to)?,
        }
        if let Some(feed) = feed {
            w.text.fine("F=", feed);
        }
        w.end_move();
        Ok(())
    }

    fn set(&mut self, w: &mut Writer, channel: usize, value: f64, at_once: bool) -> Result<(), Problem> {
        let control = w.control;
        if let Some(output) = control.outputs[channel] {
            self.out(w, "$A_OUTA[", u32::from(output) + 1, at_once);
            w.text.number(value);
            w.text.comment(&control.channels[channel].name);
            return Ok(());
        }
        self.block(w);
        w.text.word("PRESETON(");
        w.text.glue(&control.addresses[channel]);
        w.text.glue(",");
        w.text.number(value);
        w.text.glue(")");
        w.text.end();
        // The next block need not repeat this value.
        if w.here.is_empty() {
            w.here = vec![f64::NAN; control.channels.len()];
        }
        w.here[channel] = value;
        Ok(())
    }

    fn output(&mut self, w: &mut Writer, output: u32, on: bool, at_once: bool) {
        self.out(w, "$A_OUT[", output + 1, at_once);
        w.text.glue(if on { "1" } else { "0" });
    }

    fn message(&mut self, w: &mut Writer, text: &str) {
        self.block(w);
        match text {
            "stop" => w.text.word("M0"),
            text => {
                w.text.word("MSG(\"");
                w.text.clean(text, true);
                w.text.glue("\")");
            }
        }
        w.text.end();
    }

    fn dwell(&mut self, w: &mut Writer, seconds: f64, why: Option<&str>) {
        self.block(w);
        w.text.valued("G4 F=", seconds);
        w.text.end_with(why);
    }
}
