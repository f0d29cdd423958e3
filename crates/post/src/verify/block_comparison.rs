use crate::control::Control;
use crate::part_program::{ChannelKind, Event, PartProgram, Path, What};
use crate::play::{Segment, play};
use seamwright_message::{Message, Unit};

/// A block of motion as read back, with its data in the program that it was written from.
pub(super) struct Block {
    pub(super) told: Segment,
    /// Whether the arc is on, as asked.
    pub(super) arc: bool,
    /// The pass it belongs to, counted from 0.
    pub(super) pass: usize,
    pub(super) rapid: bool,
}

/// All blocks, and the maximum difference found.
pub(super) struct Same {
    pub(super) blocks: Vec<Block>,
    pub(super) rounding: f64,
}

/// Times differ by the digits of feeds: this part, and this much, s.
const TIME: (f64, f64) = (1e-6, 2e-6);
/// Values further apart than this are others.
const OTHER: f64 = 1e-3;

/// Compares the request with the text read back: the same blocks in the same order, to the same positions, at the same
/// times, with the same outputs between them. Errors: a description of the first difference.
pub(super) fn same(control: &Control, asked: &PartProgram, told: &PartProgram, start: &[f64]) -> Result<Same, Message> {
    let [of_asked, of_told] = [asked, told].map(|program| moves(program, start));
    let passes = passes(asked);
    let arc = control.switches_arc();
    let mut same = Same { blocks: Vec::new(), rounding: 0.0 };
    for (k, (a, t)) in of_asked.iter().zip(&of_told).enumerate() {
        let differs = |fault: Message| {
            let line = told.steps[t.step].line;
            let message = Message::new("post-in-block").text("block", (k + 1).to_string());
            Err(message.text("line", line.to_string()).message("fault", fault))
        };
        // A rest in which an output changes is a block without motion.
        let level = |s: &Segment| s.level.filter(|_| goes(asked, s));
        if level(a) != level(t) {
            return differs(Message::new("post-moves-at-rest"));
        }
        if arc && a.arc != t.arc {
            return differs(Message::new(if t.arc { "post-arc-is-on" } else { "post-arc-is-off" }));
        }
        if (a.seconds - t.seconds).abs() > TIME.0 * a.seconds + TIME.1 {
            let times = Message::new("post-other-time").value("found", t.seconds, Unit::S);
            return differs(times.value("planned", a.seconds, Unit::S));
        }
        for (i, channel) in asked.channels.iter().enumerate() {
            let ends = [(a.start(), t.start()), (a.end(), t.end())];
            for (a, t) in ends {
                let off = (a[i] - t[i]).abs();
                if off > OTHER {
                    let values = Message::new("post-other-value").text("name", &channel.name);
                    return differs(values.value("found", t[i], Unit::One).value("planned", a[i], Unit::One));
                }
                same.rounding = same.rounding.max(off);
            }
        }
        if a.is_move() {
            same.rounding = same.rounding.max(between(a, t));
            if same.rounding > OTHER {
                return differs(Message::new("post-other-path"));
            }
        }
        let rapid = matches!(asked.steps[a.step].what, What::Move(m) if m.path == Path::Rapid);
        same.blocks.push(Block { told: t.clone(), arc: a.arc, pass: passes[a.step], rapid });
    }
    if of_asked.len() != of_told.len() {
        return Err(Message::new("post-block-count").count("found", of_told.len()).count("planned", of_asked.len()));
    }
    let [a, t] = [asked, told].map(|program| events(control, program));
    if a != t {
        let differs = a.iter().zip(&t).find(|(a, t)| a != t);
        return Err(match differs {
            Some((a, t)) => {
                Message::new("post-other-output").message("found", t.message()).message("planned", a.message())
            }
            None => Message::new("post-output-count").count("found", t.len()).count("planned", a.len()),
        });
    }
    Ok(same)
}

/// Whether an axis or a value that goes with the axes moves.
fn goes(program: &PartProgram, segment: &Segment) -> bool {
    let moves = |i: usize| segment.start()[i].to_bits() != segment.end()[i].to_bits();
    (0..program.channels.len()).any(|i| program.channels[i].kind != ChannelKind::Stepped && moves(i))
}

/// Segments with motion or of some duration.
fn moves(program: &PartProgram, start: &[f64]) -> Vec<Segment> {
    play(program, start).into_iter().filter(|s| s.seconds > 0.0 || s.start() != s.end()).collect()
}

/// The pass that each step belongs to.
fn passes(program: &PartProgram) -> Vec<usize> {
    let mut pass: Option<usize> = None;
    let of = |step: &crate::part_program::Step| {
        if matches!(step.what, What::Pass(_)) {
            pass = Some(pass.map_or(0, |pass| pass + 1));
        }
        pass.unwrap_or(0)
    };
    program.steps.iter().map(of).collect()
}

/// Events in order, without messages.
fn events<'a>(control: &Control, program: &'a PartProgram) -> Vec<&'a Event> {
    let of = |step: &'a crate::part_program::Step| match &step.what {
        What::Event { event: Event::Message(_), .. } => None,
        What::Event { event: Event::Arc(_), .. } if !control.switches_arc() => None,
        What::Event { event, .. } => Some(event),
        _ => None,
    };
    let mut events: Vec<&Event> = program.steps.iter().filter_map(of).collect();
    // LinuxCNC gets an event at once and with the motion; the two count as one.
    events.dedup();
    events
}

/// Maximum difference between two segments inside them.
fn between(a: &Segment, t: &Segment) -> f64 {
    let (mut asked, mut told) = (Vec::new(), Vec::new());
    let mut most = 0.0f64;
    for f in [0.25, 0.5, 0.75] {
        a.at(f, &mut asked);
        t.at(f, &mut told);
        most = asked.iter().zip(&told).map(|(a, t)| (a - t).abs()).fold(most, f64::max);
    }
    most
}
