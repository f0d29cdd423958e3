//! The joint in an image or a profile of a laser stripe (DUALBEAM-2013).

mod input;
mod overlay;

use super::positive;
use crate::args::stripe::{JointArg, StripeArgs};
use crate::refusals::{in_file, refused};
use crate::rows::{Cell, Rows, print_json};
use glam::DVec2;
pub(super) use input::{Input, read};
use seamwright_geometry::Homography;
use seamwright_machine::Sight;
use seamwright_message::{Language, Message, Unit};
use seamwright_project::failure::Failure;
use seamwright_project::{files, load};
use seamwright_vision::Image;
use seamwright_vision::stripe::{Features, JointKind, NoFeatures, Quantity, StripeReader, StripeTask};
use serde_json::{Map, Value, json};
use std::io::{self, Write as _};

/// Unit of positions, mm or pixels, and the map from pixels to mm.
pub(super) struct Scale {
    to_mm: Option<Homography>,
    /// The sensor's columns and rows, if it is known.
    size_px: Option<[usize; 2]>,
    /// One scale for images with square pixels.
    mm_per_px: Option<f64>,
}

impl Scale {
    /// The map of the sensor that the command line names, or its scale.
    pub(super) fn new(machine: Option<&str>, sensor: Option<&str>, mm_per_px: Option<f64>) -> Result<Self, Failure> {
        if let Some(scale) = mm_per_px {
            positive("--mm-per-px", scale)?;
        }
        let (Some(machine), Some(name)) = (machine, sensor) else {
            return Ok(Self { to_mm: None, size_px: None, mm_per_px });
        };
        let loaded = load::machine(machine)?;
        let Some(sensor) = loaded.sensor(name) else {
            let names: Vec<&str> = loaded.sensors.iter().map(|s| s.name.as_str()).collect();
            let allowed = if names.is_empty() {
                Message::new("cli-stripe-no-sensors")
            } else {
                Message::verbatim(names.join(", "))
            };
            let fault = Message::new("cli-stripe-no-such-sensor").text("machine", machine);
            return Err(refused("--sensor", name, fault, allowed));
        };
        let Sight::Stripe(stripe) = &sensor.sight else {
            let allowed = Message::new("cli-stripe-kind");
            return Err(refused("--sensor", name, Message::new("cli-stripe-sees-none"), allowed));
        };
        Ok(Self { to_mm: Some(stripe.to_mm), size_px: Some(sensor.size_px), mm_per_px })
    }

    /// Refuses an image that is not of the sensor's size.
    pub(super) fn check_size(&self, source: &str, found: [usize; 2]) -> Result<(), Failure> {
        let Some(size_px) = self.size_px.filter(|size| *size != found) else { return Ok(()) };
        let size = |code, [width, height]: [usize; 2]| {
            Message::new(code).text("width", width.to_string()).text("height", height.to_string())
        };
        let found = in_file(source, size("cli-image-size", found));
        Err(Failure::refused(found, size("cli-stripe-sensor-size", size_px)))
    }

    /// The map of an image from pixels to mm, if there is one.
    pub(super) fn of_image(&self, image: &Image) -> Option<Homography> {
        self.to_mm.or_else(|| even(self.mm_per_px?, image))
    }
}

pub(crate) fn run(args: &StripeArgs) -> Result<(), Failure> {
    let scale = Scale::new(args.machine.as_deref(), args.sensor.as_deref(), args.mm_per_px)?;
    let source = args.input.display().to_string();
    let mut reader = StripeReader::new();
    match read(&args.input, &source)? {
        Input::Profile(points) => {
            if args.machine.is_some() || args.mm_per_px.is_some() || args.overlay.is_some() {
                let message = in_file(&source, Message::new("cli-stripe-profile-in-mm"));
                return Err(Failure::refused(message, Message::new("cli-stripe-image-options")));
            }
            let task = task(args, true)?;
            let found = reader.read_profile(&points, &task);
            let turned = || -> Vec<DVec2> { points.iter().map(|p| DVec2::new(p.x, -p.y)).collect() };
            let hint = || hint(StripeReader::new().read_profile(&turned(), &task));
            write(args, &found, None, &source, &hint)
        }
        Input::Image(image) => {
            let frame = image.frame().map_err(|e| Failure::input(in_file(&source, &e)))?;
            scale.check_size(&source, [frame.width(), frame.height()])?;
            let to_mm = scale.of_image(&image);
            let task = task(args, to_mm.is_some())?;
            let found = reader.read_image(&frame, to_mm.as_ref(), &task);
            if let Some(path) = &args.overlay {
                let png = overlay::draw(&image, &reader, to_mm.as_ref(), found.as_ref().ok())?;
                files::write_with(path, |out| Ok(out.write_all(&png)?))?;
            }
            // A map is of the image as it is: upside down only the shape counts.
            let hint = || hint_of_image(&image, &self::task(args, false).ok()?);
            write(args, &found, Some(to_mm.as_ref()), &source, &hint)
        }
    }
}

/// Pixels of one size, the origin in the middle.
fn even(mm_per_px: f64, image: &Image) -> Option<Homography> {
    let frame = image.frame().ok()?;
    let [x, y] = [frame.width(), frame.height()].map(|n| mm_per_px * (n as f64 - 1.0) / 2.0);
    Homography::from_eight([mm_per_px, 0.0, -x, 0.0, -mm_per_px, y, 0.0, 0.0])
}

fn task(args: &StripeArgs, in_mm: bool) -> Result<StripeTask, Failure> {
    let joint = match args.joint {
        JointArg::Fillet => JointKind::Fillet,
        JointArg::V => JointKind::V,
        JointArg::Lap => JointKind::Lap,
        JointArg::Butt => JointKind::Butt,
        JointArg::U => JointKind::U,
        JointArg::J => JointKind::J,
    };
    let task = if in_mm { StripeTask::in_mm(joint) } else { StripeTask::in_pixels(joint) };
    match args.thickness_mm {
        Some(thickness) => Ok(task.with_thickness(positive("--thickness-mm", thickness)?)),
        None => Ok(task),
    }
}

/// Operator action if the joint is found with everything turned upside down.
fn hint(turned: Result<Features, NoFeatures>) -> Option<Message> {
    turned.ok().filter(Features::is_confident).map(|_| Message::new("cli-stripe-hint"))
}

fn hint_of_image(image: &Image, task: &StripeTask) -> Option<Message> {
    let flipped = upside_down(image);
    let frame = flipped.frame().ok()?;
    hint(StripeReader::new().read_image(&frame, None, task))
}

fn upside_down(image: &Image) -> Image {
    fn turned<T: Copy>(pixels: &[T], width: usize) -> Vec<T> {
        pixels.chunks(width.max(1)).rev().flatten().copied().collect()
    }
    match image {
        Image::U8 { width, height, pixels } => {
            Image::U8 { width: *width, height: *height, pixels: turned(pixels, *width) }
        }
        Image::U16 { width, height, pixels } => {
            Image::U16 { width: *width, height: *height, pixels: turned(pixels, *width) }
        }
    }
}

/// Writes the result; `image` has the map of an image, if it has one. If the joint must not be followed, the text of
/// `hint` follows the reason.
fn write(
    args: &StripeArgs,
    found: &Result<Features, NoFeatures>,
    image: Option<Option<&Homography>>,
    source: &str,
    hint: &dyn Fn() -> Option<Message>,
) -> Result<(), Failure> {
    let place = Place { image };
    if args.json {
        place.print(found)?;
    } else {
        place.rows(found.as_ref().ok())?;
    }
    // Errors are ignored: standard error may be closed.
    let mut err = io::stderr();
    let why = match found {
        Err(why) => Message::new("cli-stripe-no-joint").message("why", why.message()),
        Ok(f) if !f.is_confident() => {
            let unsure = match f.doubt {
                Some(doubt) => Message::new("cli-stripe-unsure-because").message("why", doubt.message()),
                None => Message::new("cli-stripe-unsure"),
            };
            unsure.number("confidence", f.confidence, 2).value("min", Features::CONFIDENT, Unit::One)
        }
        Ok(_) => return Ok(()),
    };
    if let Some(hint) = hint() {
        let _ = writeln!(err, "{hint}");
    }
    let _ = writeln!(err, "{}", in_file(source, why));
    Err(Failure::Printed)
}

struct Place<'a> {
    image: Option<Option<&'a Homography>>,
}

impl Place<'_> {
    /// Column and row, if there is an image; y and z in mm, if they are known.
    fn both(&self, p: DVec2) -> (Option<DVec2>, Option<DVec2>) {
        match self.image {
            None => (None, Some(p)),
            Some(None) => (Some(DVec2::new(p.x, -p.y)), None),
            Some(Some(to_mm)) => (to_mm.inverse().map(p), Some(p)),
        }
    }

    fn value(&self, quantity: Quantity, value: f64) -> (f64, &'static str) {
        let in_px = self.image == Some(None);
        match (quantity.power(), in_px) {
            (None, _) => (value.to_degrees(), "deg"),
            (Some(2), true) => (value, "px2"),
            (Some(2), false) => (value, "mm2"),
            (Some(_), true) => (value, "px"),
            (Some(_), false) => (value, "mm"),
        }
    }

    fn rows(&self, found: Option<&Features>) -> Result<(), Failure> {
        let header = match self.image.is_some() {
            true => "feature,x_px,y_px,confidence,value,unit,y_mm,z_mm",
            false => "feature,y_mm,z_mm,confidence,value,unit",
        };
        let mut rows = Rows::with_header(header, false);
        let Some(f) = found else { return rows.finish() };
        let mut row = |name: &str, at: DVec2, value: Option<(f64, &'static str)>| {
            let (px, mm) = self.both(at);
            let pair = |p: Option<DVec2>| p.map_or([Cell::Empty; 2], |p| [Cell::Number(p.x), Cell::Number(p.y)]);
            let mut cells = vec![Cell::Text(name)];
            cells.extend(if self.image.is_some() { pair(px) } else { pair(mm) });
            cells.push(Cell::Number(f.confidence));
            cells.extend(value.map_or([Cell::Empty; 2], |(v, unit)| [Cell::Number(v), Cell::Text(unit)]));
            if self.image.is_some() {
                cells.extend(pair(mm));
            }
            rows.row(&cells)
        };
        for (feature, at) in &f.points {
            row(feature.name(), *at, None)?;
        }
        for (quantity, value) in &f.values {
            row(quantity.name(), f.joint(), Some(self.value(*quantity, *value)))?;
        }
        rows.finish()
    }

    fn print(&self, found: &Result<Features, NoFeatures>) -> Result<(), Failure> {
        let f = match found {
            Err(why) => {
                return print_json(&json!({ "found": false, "reason": why.message().in_language(Language::English) }));
            }
            Ok(f) => f,
        };
        let mut points = Map::new();
        for (feature, at) in &f.points {
            let (px, mm) = self.both(*at);
            let mut point = Map::new();
            for (names, p) in [(["x_px", "y_px"], px), (["y_mm", "z_mm"], mm)] {
                if let Some(p) = p {
                    point.insert(names[0].to_owned(), Value::from(p.x));
                    point.insert(names[1].to_owned(), Value::from(p.y));
                }
            }
            points.insert(feature.name().to_owned(), point.into());
        }
        let mut values = Map::new();
        for (quantity, value) in &f.values {
            let (value, unit) = self.value(*quantity, *value);
            values.insert(format!("{}_{unit}", quantity.name()), Value::from(value));
        }
        print_json(&json!({
            "found": true,
            "joint": f.kind,
            "confidence": f.confidence,
            "confident": f.is_confident(),
            "doubt": f.doubt.map(|doubt| doubt.message().in_language(Language::English)),
            "points": points,
            "values": values,
        }))
    }
}
