//! Step and direction pulses of a job. The motion is played up to three times, since it is not stored: for the speeds
//! that decide the microstepping, to check every pulse before writing, and to write.

mod check;
mod motors;
mod play;
mod summary;
mod timer;

use super::positive;
use crate::args::PulsesArgs;
use crate::planning;
use crate::progress::Progress;
use crate::refusals::refused;
use crate::rows::{Cell, Rows, print_json, print_text};
use check::{Checked, check};
use play::Play;
use seamwright_message::{Language, Message};
use seamwright_motion::pulses::Edge;
use seamwright_project::failure::Failure;
use seamwright_project::files;
use seamwright_record::{VcdAxis, VcdWriter, Wire};
use std::io::Write;
use std::path::Path;
use summary::Summary;
use timer::{Clock, Stepped};

pub(crate) fn run(args: &PulsesArgs) -> Result<(), Failure> {
    if let Some(path) = args.output.as_deref().filter(|p| p.extension().is_none_or(|e| e != "vcd")) {
        let allowed = Message::new("cli-pulses-vcd");
        return Err(refused("-o", path.display(), Message::new("cli-pulses-not-vcd"), allowed));
    }
    let loaded = planning::load(&args.job, &args.planning)?;
    let period = args.period_ms.map_or(Ok(loaded.machine.servo_period_s * 1e3), |ms| positive("--period-ms", ms))?;
    let clock = Clock::new(period, args.tick_ns)?;
    let Some(mut stepped) = Stepped::all(&loaded.machine, &clock)? else {
        let message = Message::new("cli-pulses-no-stepper").text("machine", &loaded.machine.name);
        let allowed = Message::new("cli-pulses-machine");
        return Err(loaded.welding.program.error_at("machine", message, allowed).into());
    };
    let motion = planning::plan(&loaded, &args.planning)?;
    loaded.check_count(&motion, clock.period_s())?;
    let writes = args.output.is_some() || !args.json;
    let mut play = Play {
        motion: &motion,
        clock,
        home: args.air,
        progress: Progress::new(
            "cli-progress-pulses",
            motion.count(clock.period_s(), args.air) * if writes { 3 } else { 2 },
        ),
    };
    play.choose(&mut stepped)?;
    let checked = check(&mut play, &stepped, args.motors)?;
    let summary = Summary::new(&loaded, &clock, &stepped, &checked);
    match &args.output {
        Some(path) => vcd(path, &mut play, &stepped, &checked, &summary)?,
        None if !args.json => csv(&mut play, &stepped)?,
        None => {}
    }
    drop(play);
    if args.json {
        print_json(&summary)?;
    } else if args.output.is_some() {
        print_text(&summary.text())?;
    } else {
        // Standard output has the pulses; remarks go to standard error.
        summary.remarks().for_each(print_note);
    }
    let lost = checked.lost(&stepped);
    if lost.is_empty() { Ok(()) } else { Err(Failure::Findings(lost)) }
}

/// A remark on standard error; errors are ignored.
fn print_note(remark: &Message) {
    let note = Message::new("cli-pulses-note").message("note", remark.clone());
    let _ = writeln!(std::io::stderr().lock(), "{note}");
}

/// Pulses and changes of direction as rows on standard output.
fn csv(play: &mut Play, stepped: &[Stepped]) -> Result<(), Failure> {
    let mut rows = Rows::with_header("t_s,axis,event,direction,steps", false);
    let clock = play.clock;
    let mut state: Vec<(f64, f64)> = Vec::new();
    play.pulses(stepped, |_, lines, event| {
        if state.is_empty() {
            state = lines.generators().map(|g| (0.0, g.start() as f64)).collect();
        }
        let (direction, steps) = &mut state[event.axis];
        let name = match event.edge {
            Edge::Fall => return Ok(()),
            Edge::Direction(positive) => {
                *direction = if positive { 1.0 } else { -1.0 };
                "direction"
            }
            Edge::Rise => {
                *steps += *direction;
                "step"
            }
        };
        let cells = [
            Cell::Number(clock.seconds(event.tick)),
            Cell::Text(&stepped[event.axis].name),
            Cell::Text(name),
            Cell::Number(*direction),
            Cell::Number(*steps),
        ];
        rows.row(&cells)
    })?;
    rows.finish()
}

/// The lines as a value change dump.
fn vcd(path: &Path, play: &mut Play, stepped: &[Stepped], checked: &Checked, summary: &Summary) -> Result<(), Failure> {
    let clock = play.clock;
    let axes: Vec<VcdAxis> = stepped
        .iter()
        .zip(summary.axis_messages())
        .zip(&checked.positive)
        .map(|((axis, about), positive)| VcdAxis {
            name: axis.name.clone(),
            positive: *positive,
            about: about.in_language(Language::English),
        })
        .collect();
    files::write_with(path, |out| {
        let mut vcd = VcdWriter::new(out, summary.job(), &axes)?;
        play.pulses(stepped, |_, _, event| {
            let (wire, value) = match event.edge {
                Edge::Fall => (Wire::Step, false),
                Edge::Direction(positive) => (Wire::Direction, positive),
                Edge::Rise => (Wire::Step, true),
            };
            Ok(vcd.change(clock.nanoseconds(event.tick), event.axis, wire, value)?)
        })?;
        vcd.finish(clock.nanoseconds(checked.periods * clock.ticks))?;
        Ok(())
    })
}
