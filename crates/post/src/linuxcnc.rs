use crate::blocks::{Block, HELD_BACK, Linearisation, linearise};
use crate::number::{fixed, significant};
use crate::ramps::{ramp_breaks, rest_steps, weave_breaks};
use crate::{Error, Level};
use seamwright_machine::{AxisKind, Joints, Machine};
use seamwright_motion::air::{AirMove, Leg};
use seamwright_motion::{PassMotion, WeldMotion};
use seamwright_program::{Pass, ProcessValue, Program, TorchPath};
use std::collections::BTreeMap;
use std::fmt::Write;

/// How to write a part program.
#[derive(Debug, Clone, PartialEq)]
pub struct Options {
    /// What the control interpolates.
    pub level: Level,
    /// Greatest distance of the blocks' path from the planned one of the tip, mm.
    pub tolerance_mm: f64,
}

impl Default for Options {
    fn default() -> Self {
        Self { level: Level::Joint, tolerance_mm: 0.01 }
    }
}

/// During the travel neither upslope nor downslope.
const WELDING: (f64, f64) = (f64::INFINITY, f64::INFINITY);
/// Decimals of positions in mm and degrees.
const DECIMALS: usize = 6;
/// Part of the tolerance that is left to the control for rounding corners (G64 P).
const ROUNDING: f64 = 0.1;
/// Feed of the approach from where the torch stands back to the start of the weld, mm/min.
const APPROACH_MM_MIN: f64 = 600.0;

/// The program as a part program for LinuxCNC: G93 inverse-time blocks, outputs switched with the motion; between
/// passes the planned air moves, whose straight lines in axis space are those of G0 at joint level.
///
/// Joint level needs identity kinematics in the control (trivkins); tip level needs kinematics that match the machine
/// (for example xyzac-trt-kins), with X Y Z the torch tip in the work frame.
///
/// # Errors
/// If an axis has no fitting letter, the tolerance cannot be kept, or several passes are asked for at tip level.
pub fn linuxcnc(
    machine: &Machine,
    program: &Program,
    paths: &[&dyn TorchPath],
    motion: &WeldMotion,
    options: &Options,
) -> Result<String, Error> {
    let letters = letters(machine, options.level)?;
    if options.level == Level::Tip && motion.passes.len() > 1 {
        return Err(Error::TipPasses);
    }
    if paths.iter().any(|path| path.second(0.0).is_some()) {
        return Err(Error::TwoTorches);
    }
    // Rounding of corners by the control, and linear motion left to the next block, count against the tolerance too.
    let tolerance = (1.0 - ROUNDING - HELD_BACK) * options.tolerance_mm;
    let mut writer = Writer { out: String::new(), machine, options, letters, written: BTreeMap::new() };
    for (i, (pass, planned)) in program.passes.iter().zip(&motion.passes).enumerate() {
        let mut breaks: Vec<f64> = pass.spans.iter().skip(1).map(|s| s.from_mm.get()).collect();
        breaks.extend(pass.spans.iter().flat_map(ramp_breaks));
        breaks.extend(weave_breaks(pass));
        breaks.sort_by(f64::total_cmp);
        let cut = linearise(machine, planned, &breaks, options.level, tolerance)?;
        if i == 0 {
            writer.header(program);
        }
        writer.pass_header(&pass.name, planned, &cut);
        let before = writer.stands_back(motion.air[i].approaches, motion.air[i].legs.last().map(Leg::start));
        let after = writer.stands_back(motion.air[i + 1].retracts, motion.air[i + 1].legs.first().map(Leg::end));
        if i > 0 {
            writer.air(&motion.air[i]);
        }
        let first_middle = cut.blocks.first().map_or(0.0, |block| 0.5 * block.s);
        writer.start(&cut.start, before.as_ref(), pass, (i == 0, first_middle));
        writer.weld(&cut, pass);
        let end = cut.blocks.last().unwrap_or(&cut.start);
        writer.end(end, after.as_ref(), pass);
    }
    writer.line("M2");
    Ok(writer.out)
}

/// The axes' letters in machine-file order, checked against their kind.
fn letters(machine: &Machine, level: Level) -> Result<Vec<char>, Error> {
    machine
        .axes
        .iter()
        .map(|axis| {
            let letter = axis.letter.ok_or_else(|| Error::NoLetter { axis: axis.name.clone() })?;
            let rotary = "ABC".contains(letter);
            if rotary == (axis.kind == AxisKind::Rotary) {
                return Ok(letter);
            }
            let (kind, others) = if rotary { ("linear", "the rotary ones") } else { ("rotary", "the linear ones") };
            Err(Error::WrongLetter { axis: axis.name.clone(), letter, kind, others })
        })
        .collect::<Result<Vec<char>, Error>>()
        .and_then(
            |letters| if level == Level::Tip && !letters.contains(&'X') { Err(Error::NoTip) } else { Ok(letters) },
        )
}

struct Writer<'a> {
    out: String,
    machine: &'a Machine,
    options: &'a Options,
    letters: Vec<char>,
    /// Process values written since the pass began: the last line of each word and name.
    written: BTreeMap<(&'static str, String), String>,
}

impl Writer<'_> {
    fn line(&mut self, text: &str) {
        self.out.push_str(text);
        self.out.push('\n');
    }

    /// A comment; the control's comments may not hold parentheses or control characters.
    fn comment(&mut self, text: &str) {
        let clean: String = text.chars().map(|c| if c.is_ascii_graphic() || c == ' ' { c } else { '?' }).collect();
        let clean = clean.replace('(', "[").replace(')', "]");
        // Longer lines are cut off by the control.
        let short: String = clean.chars().take(200).collect();
        let _ = writeln!(self.out, "({short})");
    }

    fn header(&mut self, program: &Program) {
        self.comment(&format!("Seamwright {} for LinuxCNC: {}", env!("CARGO_PKG_VERSION"), program.title));
        self.comment(&format!("machine: {}", self.machine.title));
        self.comment(match self.options.level {
            Level::Joint => "joint level: every word is an axis position, kinematics must be identity [trivkins]",
            Level::Tip => "tip level: X Y Z are the torch tip in the work frame, kinematics must match the machine",
        });
        let names: Vec<String> = self
            .machine
            .axes
            .iter()
            .zip(&self.letters)
            .map(|(a, l)| format!("{l} = {} [{}]", a.name, a.unit()))
            .collect();
        self.comment(&format!("axes: {}", names.join(", ")));
        self.comment("units mm, degrees; plane XY; absolute; inverse time feed G93");
        self.comment("work offsets and tool offsets must be zero");
        self.line("G21 G17 G90 G40 G49 G80 G94");
        self.blends();
    }

    /// Lets the control round corners between blocks.
    fn blends(&mut self) {
        let tolerance = significant(ROUNDING * self.options.tolerance_mm, 3);
        self.line(&format!("G64 P{tolerance} Q0"));
    }

    fn pass_header(&mut self, name: &str, motion: &PassMotion, cut: &Linearisation) {
        self.comment(&format!(
            "{name}: travel {} mm in {} s; arc on {} s",
            fixed(motion.path.length(), 3),
            fixed(motion.law.duration(), 3),
            fixed(motion.arc_on_s(), 3)
        ));
        self.comment(&format!(
            "{} blocks, chord error {} mm of {} mm allowed",
            cut.blocks.len(),
            significant(cut.chord_error_mm, 3),
            fixed(self.options.tolerance_mm, DECIMALS)
        ));
    }

    /// The planned way from where the torch stands back after one pass to where it does before the next.
    fn air(&mut self, air: &AirMove) {
        self.comment("the planned way to the next pass");
        // The retract and the approach are written with their welds; the last place is where the approach begins.
        let skip = usize::from(air.retracts);
        let inner = air.legs.len().saturating_sub(usize::from(air.approaches));
        for leg in air.legs.iter().take(inner).skip(skip) {
            let place = Block {
                s: 0.0,
                q: *leg.end(),
                tip: self.machine.forward(leg.end()).point,
                duration: 0.0,
                turns_only: false,
                stops: false,
            };
            self.line(&format!("G0 {}", self.words(&place, false)));
        }
    }

    /// The words of a place, in the control's letters; linear words left out if `rotary_only`.
    fn words(&self, at: &Block, rotary_only: bool) -> String {
        let mut words: Vec<(char, f64)> = Vec::new();
        for (i, (axis, letter)) in self.machine.axes.iter().zip(&self.letters).enumerate() {
            let left_out = self.options.level == Level::Tip || rotary_only;
            if axis.kind == AxisKind::Rotary || !left_out {
                words.push((*letter, axis.to_file(at.q[i])));
            }
        }
        if self.options.level == Level::Tip && !rotary_only {
            words.extend([('X', at.tip.x), ('Y', at.tip.y), ('Z', at.tip.z)]);
        }
        words.sort_by_key(|(letter, _)| "XYZUVWABC".find(*letter));
        let texts: Vec<String> = words.iter().map(|(l, v)| format!("{l}{}", fixed(*v, DECIMALS))).collect();
        texts.join(" ")
    }

    /// Where the torch stands back by the plan, which has checked it; none where no axis can take it back.
    fn stands_back(&self, does: bool, q: Option<&Joints>) -> Option<Block> {
        let q = q.filter(|_| does)?;
        Some(Block {
            s: 0.0,
            q: *q,
            tip: self.machine.forward(q).point,
            duration: 0.0,
            turns_only: false,
            stops: false,
        })
    }

    fn start(&mut self, start: &Block, back: Option<&Block>, pass: &Pass, (first, first_middle): (bool, f64)) {
        match back {
            Some(back) => {
                if first {
                    self.comment(
                        "rapid to a place back from the start along the torch: make sure that the way there is clear",
                    );
                }
                self.line(&format!("G0 {}", self.words(back, false)));
                self.line(&format!("G93 G1 {} F{}", self.words(start, false), approach_feed(back, start)));
            }
            None => {
                if first {
                    self.comment("rapid to the start of the weld [no axis can lift the torch]: make sure that the way there is clear");
                }
                self.line(&format!("G0 {}", self.words(start, false)));
            }
        }
        let io = self.machine.io.clone();
        let sequence = &pass.sequence;
        self.written.clear();
        if let Some(gas) = io.gas {
            self.line(&format!("M64 P{gas} (gas on)"));
        }
        self.dwell(sequence.preflow_s.get(), "preflow");
        let delay = sequence.travel_delay_s.get();
        if delay > 0.0 {
            // Nothing moves yet: immediate outputs, repeated below in step with the motion.
            let steps = rest_steps(delay, (sequence.upslope.as_ref().map_or(0.0, |s| s.time_s.get()), 0.0));
            for (i, step) in steps.iter().enumerate() {
                self.process_values(pass, "M68", (0.0, (step.middle, f64::INFINITY)));
                if let Some(arc) = io.arc.filter(|_| i == 0) {
                    self.line(&format!("M64 P{arc} (arc on)"));
                }
                self.dwell(step.time, if step.slopes { "upslope" } else { "travel delay" });
            }
        }
        self.process_values(pass, "M67", (first_middle, WELDING));
        if let Some(arc) = io.arc {
            self.line(&format!("M62 P{arc} (arc on with the motion)"));
        }
    }

    /// Analogue outputs of the process values at path length `s` and a time since the arc went on and until it goes
    /// off, with `word` M67 (in step with the motion) or M68 (at once), where they changed.
    fn process_values(&mut self, pass: &Pass, word: &'static str, (s, clock): (f64, (f64, f64))) {
        for name in pass.spans[0].process.keys() {
            let value = pass.process_at(name, s, clock).unwrap_or(0.0);
            match self.machine.io.analog.get(name) {
                Some(output) => {
                    let line = format!("{word} E{output} Q{} ({name})", fixed(value, 4));
                    if self.written.insert((word, name.clone()), line.clone()).as_ref() != Some(&line) {
                        self.line(&line);
                    }
                }
                None if self.written.insert(("", name.clone()), String::new()).is_none() => {
                    self.comment(&format!("{name}, {value} at first: the machine file has no output for it"));
                }
                None => {}
            }
        }
    }

    fn dwell(&mut self, seconds: f64, why: &str) {
        if seconds > 0.0 {
            self.line(&format!("G4 P{} ({why})", fixed(seconds, 4)));
        }
    }

    fn weld(&mut self, cut: &Linearisation, pass: &Pass) {
        self.line("G93");
        let mut before = cut.start;
        let mut last = 0;
        for (i, block) in cut.blocks.iter().enumerate() {
            // A block has the values of its middle: of the one span that it lies in, and half a step off a ramp's at
            // most.
            let middle = 0.5 * (before.s + block.s);
            let span = pass.spans.partition_point(|span| span.to_mm.get() <= middle).min(pass.spans.len() - 1);
            let ramps = pass.spans[span].process.values().any(ProcessValue::is_ramp)
                || pass.weave.as_ref().is_some_and(|weave| !weave.at_sides.is_empty());
            if i > 0 && (span != last || ramps) {
                self.process_values(pass, "M67", (middle, WELDING));
                last = span;
            }
            let feed = significant(60.0 / block.duration, 9);
            if block.stops {
                self.line("G61.1 (exact stop)");
            }
            self.line(&format!("G1 {} F{feed}", self.words(block, block.turns_only)));
            if block.stops {
                self.blends();
            }
            before = *block;
        }
    }

    fn end(&mut self, end: &Block, back: Option<&Block>, pass: &Pass) {
        let io = self.machine.io.clone();
        let sequence = &pass.sequence;
        let crater = sequence.crater_s.get();
        let downslope = sequence.downslope.as_ref().map_or(0.0, |s| s.time_s.get());
        for step in rest_steps(crater, (0.0, downslope)) {
            if step.slopes {
                self.process_values(pass, "M68", (pass.length(), (f64::INFINITY, crater - step.middle)));
            }
            self.dwell(step.time, if step.slopes { "downslope" } else { "crater fill" });
        }
        if let Some(arc) = io.arc {
            self.line(&format!("M65 P{arc} (arc off)"));
        }
        for name in pass.spans[0].process.keys() {
            if let Some(output) = io.analog.get(name) {
                self.line(&format!("M68 E{output} Q0 ({name} off)"));
            }
        }
        self.dwell(sequence.postflow_s.get(), "postflow");
        if let Some(gas) = io.gas {
            self.line(&format!("M65 P{gas} (gas off)"));
        }
        if let Some(back) = back {
            if let Some(arc) = io.arc {
                self.line(&format!("M63 P{arc} (arc stays off)"));
            }
            self.line(&format!("G1 {} F{}", self.words(back, false), approach_feed(end, back)));
        }
        self.line("G94");
    }
}

/// Inverse-time feed of an approach or retract, 1/min.
fn approach_feed(a: &Block, b: &Block) -> String {
    fixed(APPROACH_MM_MIN / (a.tip - b.tip).length().max(1.0), DECIMALS)
}
