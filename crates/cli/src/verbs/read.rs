//! A part program or a robot program as a weld program.

use super::positive;
use crate::args::post::LevelArg;
use crate::args::read::ReadArgs;
use crate::refusals::{in_file, not_json, of_option, refused};
use crate::rows::{print_json, print_text};
use seamwright_document::Positive;
use seamwright_message::{Language, Message, Unit};
use seamwright_post::robot::{ImportedRobot, RobotImport, RobotLanguage, read_robot, robot_to_program};
use seamwright_post::{Control, Dialect, LeftOut, Level, ReadOptions, Reading, What, read, to_program};
use seamwright_program::Program;
use seamwright_project::failure::Failure;
use seamwright_project::posting::PostTarget;
use seamwright_project::{files, load, posting};
use serde::Serialize;
use std::io::{self, Write as _};

/// Maximum of a corner that a torch may cut off: the default tolerance of a pass.
const WIDEST_MM: f64 = 0.5;

/// Result of reading, for other programs.
#[derive(Debug, Serialize)]
struct Summary<'a> {
    seamwright: &'static str,
    file: &'a str,
    dialect: &'static str,
    machine: &'a str,
    moves: usize,
    seconds: f64,
    passes: Vec<PassSummary<'a>>,
    left_out: Vec<String>,
    notes: Vec<String>,
}

#[derive(Debug, Serialize)]
struct PassSummary<'a> {
    name: &'a str,
    arc: bool,
    points: usize,
}

pub(crate) fn run(args: &ReadArgs) -> Result<(), Failure> {
    let blend = positive("--blend-mm", args.blend_mm)?;
    let blend = Positive::new(blend).filter(|_| blend <= WIDEST_MM).ok_or_else(|| {
        let allowed = Message::new("cli-up-to-pass-tolerance").value("max", WIDEST_MM, Unit::One);
        refused("--blend-mm", blend, Message::new("cli-too-far"), allowed)
    })?;
    let machine = load::machine(&args.machine)?;
    let text = files::read(&args.file)?;
    let file = args.file.display().to_string();
    let target = args.dialect.map(PostTarget::from);
    let target = target.or_else(|| RobotLanguage::of_file(&file).map(PostTarget::Robot));
    let dialect = match target {
        Some(PostTarget::Robot(language)) => {
            let import = RobotImport { machine: &machine, machine_name: &args.machine, language, blend_mm: blend };
            return robot(args, &file, &text, &import);
        }
        Some(PostTarget::Machine(dialect)) => dialect,
        None => Dialect::guess(&file, &text),
    };
    let control = Control::new(&machine, dialect).map_err(|e| Failure::input(in_file(&args.machine, &e)))?;
    let start = posting::start(&machine, &control);
    let level = match args.level {
        LevelArg::Joint => Level::Joint,
        LevelArg::Tip => Level::Tip,
    };
    let options = ReadOptions { lenient: args.lenient, level, start: Some(start.clone()) };
    let mut reading = read(&control, &file, &text, &options).map_err(|e| Failure::input(Message::outside(&e)))?;
    if reading.program.title == file {
        // A text without a title has the name of its file.
        let name = args.file.file_name().unwrap_or_default();
        reading.program.title = name.to_string_lossy().into_owned();
    }
    let program = to_program(&machine, &control, &reading.program, &start, &args.machine, blend)
        .map_err(|e| Failure::input(in_file(&file, &e)))?;
    let written = written(&file, &program)?;
    let (moves, seconds) = moves(&reading);
    let Reading { left_out, notes, .. } = &reading;
    let counts = Counts { file: &file, dialect: dialect.name(), moves, seconds, left_out, notes };
    describe(&counts, &program)?;
    write(args, &written, || summary(args, &counts, &program))
}

/// File and dialect of what was read, its moves and their time, texts left out and notes.
struct Counts<'a> {
    file: &'a str,
    dialect: &'static str,
    moves: usize,
    seconds: f64,
    left_out: &'a [LeftOut],
    notes: &'a [Message],
}

/// Reads a robot program.
fn robot(args: &ReadArgs, file: &str, text: &str, import: &RobotImport) -> Result<(), Failure> {
    if args.lenient {
        return Err(Failure::Input(of_option("--lenient", Message::new("cli-not-for-robots"))));
    }
    let read = read_robot(import.language, file, text).map_err(|e| Failure::Input(e.located()))?;
    let mut imported = robot_to_program(&read, import).map_err(|e| Failure::input(in_file(file, &e)))?;
    if imported.program.title.is_empty() {
        let name = args.file.file_name().unwrap_or_default();
        imported.program.title = name.to_string_lossy().into_owned();
    }
    let ImportedRobot { program, moves, seconds } = &imported;
    let written = written(file, program)?;
    let without_frames = Message::new("post-robot-no-frames").text("machine", &import.machine.name);
    let notes: &[Message] = if read.frames.is_none() { &[without_frames] } else { &[] };
    let counts =
        Counts { file, dialect: import.language.name(), moves: *moves, seconds: *seconds, left_out: &[], notes };
    describe(&counts, program)?;
    write(args, &written, || summary(args, &counts, program))
}

/// The text of the program. All other verbs must accept it, so it is read back.
fn written(file: &str, program: &Program) -> Result<String, Failure> {
    let written = program.to_toml().map_err(not_json)?;
    Program::read(file, &written)?;
    Ok(written)
}

fn write<'a>(args: &ReadArgs, written: &str, summary: impl FnOnce() -> Summary<'a>) -> Result<(), Failure> {
    if let Some(path) = &args.output {
        files::write(path, written)?;
    }
    match (args.json, &args.output) {
        (true, _) => print_json(&summary()),
        (false, None) => print_text(written),
        (false, Some(_)) => Ok(()),
    }
}

fn moves(reading: &Reading) -> (usize, f64) {
    let moves = reading.program.steps.iter().filter_map(|step| match step.what {
        What::Move(m) => Some(m.seconds),
        _ => None,
    });
    moves.fold((0, 0.0), |(count, sum), seconds| (count + 1, sum + seconds))
}

/// Reports on standard error the texts that were read and left out.
fn describe(counts: &Counts, program: &Program) -> Result<(), Failure> {
    let mut err = io::stderr().lock();
    let passes = program.passes.len();
    let Counts { file, dialect, moves, seconds, left_out, notes } = *counts;
    let read = Message::new("cli-import").text("file", file).text("dialect", dialect).count("moves", moves);
    let read = read.quantity("time", seconds, Unit::S, 3).number("passes", passes as f64, 0);
    writeln!(err, "{read}")?;
    for note in notes {
        writeln!(err, "{}", Message::new("project-note").message("note", note.clone()))?;
    }
    for left in left_out {
        let place = format!("{file}:{}:{}", left.line, left.column);
        let line = Message::new("cli-import-left-out").text("place", place).text("words", &left.text);
        writeln!(err, "{}", line.message("why", left.why.clone()))?;
    }
    Ok(())
}

fn summary<'a>(args: &'a ReadArgs, counts: &Counts<'a>, program: &'a Program) -> Summary<'a> {
    let left_out = counts.left_out.iter();
    let english = |message: &Message| message.in_language(Language::English);
    Summary {
        seamwright: env!("CARGO_PKG_VERSION"),
        file: counts.file,
        dialect: counts.dialect,
        machine: &args.machine,
        moves: counts.moves,
        seconds: counts.seconds,
        passes: program
            .passes
            .iter()
            .map(|pass| PassSummary {
                name: &pass.name,
                arc: pass.has_arc(),
                points: pass.points.as_ref().map_or(0, seamwright_program::Points::count),
            })
            .collect(),
        left_out: left_out.map(|l| format!("{}:{}: {}: {}", l.line, l.column, l.text, english(&l.why))).collect(),
        notes: counts.notes.iter().map(english).collect(),
    }
}
