//! The joint line in one image (EBW-2004).

mod draw;

use crate::args::find_joint::FindJointArgs;
use crate::refusals::{between, in_file, not_allowed, refused};
use crate::rows::{Cell, Rows, print_json};
use seamwright_frames::decode;
use seamwright_message::{Message, Unit};
use seamwright_project::failure::Failure;
use seamwright_project::files;
use seamwright_vision::joint::{End, Follower, Joint, Options, Start, State, Zone};
use seamwright_vision::{Frame, Pixels};
use serde_json::{Value, json};
use std::io::{self, Write as _};

/// Minimum side of an image in which a joint can be followed, pixels.
const MIN_SIDE: usize = 16;
/// Widths that the follower takes, pixels.
const WIDTHS: (f64, f64) = (1.0, 400.0);

pub(crate) fn run(args: &FindJointArgs) -> Result<(), Failure> {
    let source = args.image.display().to_string();
    let image = decode(&files::read_bytes(&args.image, &source)?)
        .map_err(|e| Failure::refused(in_file(&source, &e), Message::new("cli-image-whole-file")))?;
    let frame = image.frame().map_err(|e| Failure::input(in_file(&source, &e)))?;
    check_frame(&frame, &source)?;
    let zone = zone(args, &frame)?;
    let start = start(args, &zone)?;
    let mut follower = Follower::new(Options { zone: Some(zone), ..Options::default() });
    let joint = follower.follow(&frame, &start);
    if let Some(path) = &args.overlay {
        let png = draw::draw(&frame, joint, &start, &zone)?;
        files::write_with(path, |out| Ok(out.write_all(&png)?))?;
    }
    if args.json {
        print(joint)?;
    } else {
        rows(joint)?;
    }
    // Errors are ignored: standard error may be closed.
    let mut err = io::stderr();
    let nothing = joint.rows.is_empty();
    if nothing {
        let _ = writeln!(err, "{}", in_file(&source, Message::new("cli-joint-none-at-start")));
    }
    let _ = writeln!(err, "{}", word(joint.end));
    if nothing { Err(Failure::Printed) } else { Ok(()) }
}

/// Refuses images that cannot show a joint.
fn check_frame(frame: &Frame, source: &str) -> Result<(), Failure> {
    let (width, height) = (frame.width(), frame.height());
    if width.min(height) < MIN_SIDE {
        let size = Message::new("cli-image-size").text("width", width.to_string()).text("height", height.to_string());
        let allowed = Message::new("cli-image-at-least").number("min", MIN_SIDE as f64, 0);
        return Err(Failure::refused(in_file(source, size), allowed));
    }
    let white = match frame.pixels() {
        Pixels::U8(pixels) => pixels.iter().filter(|p| **p == u8::MAX).count(),
        Pixels::U16(pixels) => pixels.iter().filter(|p| **p == u16::MAX).count(),
    };
    if white >= width * height - width * height / 1000 {
        let message = in_file(source, Message::new("cli-image-saturated"));
        return Err(Failure::refused(message, Message::new("cli-image-exposure")));
    }
    Ok(())
}

fn numbers<const N: usize>(name: &str, found: &[f64]) -> Result<[f64; N], Failure> {
    let all: Option<[f64; N]> = found.try_into().ok();
    all.filter(|all| all.iter().all(|v| v.is_finite())).ok_or_else(|| {
        let found: Vec<String> = found.iter().map(f64::to_string).collect();
        let found = found.join(",");
        not_allowed(name, found, Message::new("cli-finite-numbers").count("n", N))
    })
}

/// Detection zone of the joint: the image, or the part of it that the zone covers.
fn zone(args: &FindJointArgs, frame: &Frame) -> Result<Zone, Failure> {
    let (right, bottom) = ((frame.width() - 1) as f64, (frame.height() - 1) as f64);
    let [left, top, zone_right, zone_bottom] = match &args.zone_px {
        Some(zone) => numbers("--zone-px", zone)?,
        None => [0.0, 0.0, right, bottom],
    };
    let inside = left >= 0.0 && top >= 0.0 && zone_right <= right && zone_bottom <= bottom;
    if !inside || left >= zone_right || top >= zone_bottom {
        let found = format!("{left},{top},{zone_right},{zone_bottom}");
        let allowed = Message::new("cli-joint-zone").value("right", right, Unit::One);
        return Err(not_allowed("--zone-px", found, allowed.value("bottom", bottom, Unit::One)));
    }
    Ok(Zone { left: left as f32, top: top as f32, right: zone_right as f32, bottom: zone_bottom as f32 })
}

fn start(args: &FindJointArgs, zone: &Zone) -> Result<Start, Failure> {
    let [x, y] = numbers("--start", &args.start)?;
    let [left, top, right, bottom] = [zone.left, zone.top, zone.right, zone.bottom].map(f64::from);
    if x < left || x > right || y < top || y > bottom {
        let fault = Message::new(if args.zone_px.is_some() { "cli-outside-zone" } else { "cli-outside-image" });
        let allowed = Message::new("cli-joint-start")
            .value("left", left, Unit::One)
            .value("right", right, Unit::One)
            .value("top", top, Unit::One)
            .value("bottom", bottom, Unit::One);
        return Err(refused("--start", format!("{x},{y}"), fault, allowed));
    }
    let [direction] = numbers("--direction-deg", &[args.direction_deg])?;
    if let Some(width) = args.width_px.filter(|w| !(WIDTHS.0..=WIDTHS.1).contains(w)) {
        return Err(not_allowed("--width-px", width, between(WIDTHS.0, WIDTHS.1)));
    }
    // Whole turns are taken off before the precision is.
    let direction = (direction % 360.0).to_radians() as f32;
    Ok(Start { x: x as f32, y: y as f32, direction, width: args.width_px.map(|w| w as f32) })
}

fn word(end: End) -> &'static str {
    match end {
        End::LeftImage => "left-image",
        End::JointEnd => "joint-end",
        End::Closed => "closed",
        End::Lost => "lost",
    }
}

fn state(state: State) -> &'static str {
    match state {
        State::Seen => "seen",
        State::Coasted => "coasted",
    }
}

/// The number as its shortest decimals name it: those of single precision, no more.
fn shortest(value: f32) -> f64 {
    value.to_string().parse().unwrap_or_else(|_| f64::from(value))
}

fn rows(joint: &Joint) -> Result<(), Failure> {
    let mut rows = Rows::with_header("x_px,y_px,confidence,width_px,state", false);
    for row in &joint.rows {
        let [x, y, confidence, width] = [row.x, row.y, row.confidence, row.width].map(|v| Cell::Number(shortest(v)));
        rows.row(&[x, y, confidence, width, Cell::Text(state(row.state))])?;
    }
    rows.finish()
}

fn print(joint: &Joint) -> Result<(), Failure> {
    let row = |row: &seamwright_vision::joint::Row| {
        json!({
            "x_px": shortest(row.x),
            "y_px": shortest(row.y),
            "confidence": shortest(row.confidence),
            "width_px": shortest(row.width),
            "state": state(row.state),
        })
    };
    let rows: Vec<Value> = joint.rows.iter().map(row).collect();
    print_json(&json!({ "end": word(joint.end), "rows": rows }))
}
