//! Values of a run of beads, from its table and from the weld.

use super::file::{Adapt, Beads, Run, WIRE_FEED};
use crate::attitude::check_angles;
use crate::stick_out;
use seamwright_document::{Document, DocumentError, Finite, Positive};
use seamwright_message::{Message, Unit};
use seamwright_program::{BeadWindow, Procedure, ProcessValues, Role, Weave, check_process};
use std::f64::consts::FRAC_PI_4;

/// Values of the weld that its runs have by default.
#[derive(Debug, Clone, Copy)]
pub(crate) struct WeldValues<'a> {
    pub(crate) speed_mm_s: Positive,
    pub(crate) process: &'a ProcessValues,
    /// Its procedure, which gives the windows of beads.
    pub(crate) procedure: Option<&'a Procedure>,
    /// Its weave.
    pub(crate) weave: Option<&'a Weave>,
    /// Area of the consumable insert that the root pass fuses, mm^2; 0 without one.
    pub(crate) insert_mm2: f64,
}

/// Values of a run: its own over those of the weld.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct RunValues {
    /// Area of a bead, mm^2.
    pub(crate) area: f64,
    /// The part of it that is a consumable insert, mm^2.
    pub(crate) insert: f64,
    /// True if the area follows from the wire.
    pub(crate) area_from_wire: bool,
    /// Height of a layer, mm.
    pub(crate) layer: f64,
    /// Speed, mm/s.
    pub(crate) speed: Positive,
    pub(crate) process: ProcessValues,
    pub(crate) travel_angle_deg: Option<Finite>,
    pub(crate) stick_out_mm: Option<Positive>,
    pub(crate) weave: Option<Weave>,
    /// Window of its beads.
    pub(crate) window: BeadWindow,
}

/// A root pass over an insert lays at least this part of its wire: speed or wire feed do not change without bounds where
/// the insert alone nearly fills the root.
const MIN_WIRE_PART: f64 = 0.2;

impl RunValues {
    /// The metal that the wire adds to a bead of `area` (mm^2), as a part of what it adds to the run's; 1 where an
    /// insert is the only filler.
    pub(crate) fn wire_part(&self, area: f64) -> f64 {
        let wire = self.area - self.insert;
        match self.insert > 0.0 {
            true if wire <= 0.0 => 1.0,
            true => ((area - self.insert) / wire).max(MIN_WIRE_PART),
            false => area / self.area,
        }
    }
}

/// The role of the beads of a run.
fn role_of(run: &str) -> Role {
    match run {
        "root" => Role::Root,
        "cap" => Role::Cap,
        _ => Role::Fill,
    }
}

/// No bead is wider than this many times its layer's height, or narrower than its inverse: far beyond all windows, so
/// that only mistakes are refused.
const MAX_WIDTH_TO_HEIGHT: f64 = 100.0;

/// Checks that beads of `area` (mm^2) can make layers of `layer` (mm). Beads outside their window are findings of the plan.
/// Fails with the key's address.
fn check_layer<T>(file: &Document<T>, path: &str, area: f64, layer: f64) -> Result<(), DocumentError> {
    let [least, most] = [(area / MAX_WIDTH_TO_HEIGHT).sqrt(), (area * MAX_WIDTH_TO_HEIGHT).sqrt()];
    if (least..=most).contains(&layer) {
        return Ok(());
    }
    let message = Message::new("weld-layer-height-impossible").quantity("area", area, Unit::Mm2, 1);
    let allowed = Message::new("document-between").quantity("min", least, Unit::Mm, 2);
    let given = format!("{path}.layer_mm");
    let key = file.given_or(&given, path);
    Err(file.error_at(key, message, allowed.quantity("max", most, Unit::Mm, 2)))
}

/// A run with the values of the weld that it inherits.
struct RunSettings<'a, T> {
    beads: &'a Beads,
    file: &'a Document<T>,
    /// The run's address.
    path: String,
    run: &'a Run,
    /// Process values of the weld, with those of the run in their place.
    process: ProcessValues,
    speed: Positive,
    /// Area of the consumable insert that the run fuses, mm^2; 0 without one.
    insert: f64,
}

impl<T> RunSettings<'_, T> {
    /// Checks the run's own values. Fails with the key's address.
    fn check(&self, weld: &WeldValues) -> Result<(), DocumentError> {
        let Self { file, path, run, .. } = self;
        check_process(file, &format!("{path}.process"), &run.process)?;
        if let Some(key) = run.process.keys().find(|key| !weld.process.contains_key(*key)) {
            let known: Vec<&str> = weld.process.keys().map(String::as_str).collect();
            return Err(file.unknown_name(&format!("{path}.process.{key}"), key, &known));
        }
        check_angles(file, path, 0.0, run.travel_angle_deg.map_or(0.0, Finite::get))?;
        run.stick_out_mm.map_or(Ok(()), |own| stick_out::check(file, &format!("{path}.stick_out_mm"), own))
    }

    /// True if an insert is the only filler.
    fn is_insert_only(&self) -> bool {
        let feed = self.process.get(WIRE_FEED).map_or(0.0, |feed| feed.ends().0.max(feed.ends().1));
        self.insert > 0.0 && feed == 0.0
    }

    /// Area that the wire adds to a bead, mm^2. Fails with the key's address: no area, or an area and a wire.
    fn filler_area(&self) -> Result<f64, DocumentError> {
        let wrong = |key: &str, code, allowed| {
            Err(self.file.error_at(&format!("{}{key}", self.path), Message::new(code), Message::new(allowed)))
        };
        match (self.run.area_mm2, self.beads.wire_mm) {
            (None, _) if self.is_insert_only() => Ok(0.0),
            (Some(area), _) if self.beads.adapt != Adapt::WireFeed => Ok(area.get()),
            (Some(_), _) => wrong(".area_mm2", "weld-area-with-wire-feed", "weld-allowed-no-area-with-wire-feed"),
            (None, None) => wrong("", "weld-bead-area-missing", "weld-allowed-bead-area"),
            (None, Some(wire)) => {
                let feed = self.process.get(WIRE_FEED).filter(|feed| !feed.is_ramp()).map(|feed| feed.ends().0);
                let Some(feed) = feed.filter(|feed| *feed > 0.0) else {
                    return wrong("", "weld-bead-area-needs-steady-feed", "weld-allowed-steady-feed");
                };
                let wire_area = FRAC_PI_4 * wire.get() * wire.get();
                Ok(wire_area * (feed * 1000.0 / 60.0) * self.beads.deposition.get() / self.speed.get())
            }
        }
    }
}

impl Beads {
    /// Values of the run `name`: its own over those of `weld`. Fails with the key's address: no area, or an
    /// area and a wire.
    pub(crate) fn run_values<T>(
        &self,
        file: &Document<T>,
        name: &str,
        run: &Run,
        weld: &WeldValues,
    ) -> Result<RunValues, DocumentError> {
        let mut process = weld.process.clone();
        process.extend(run.process.clone());
        let settings = RunSettings {
            beads: self,
            file,
            path: format!("beads.{name}"),
            run,
            process,
            speed: run.speed_mm_s.unwrap_or(weld.speed_mm_s),
            insert: if role_of(name) == Role::Root { weld.insert_mm2 } else { 0.0 },
        };
        settings.check(weld)?;
        let (insert, layer) = (settings.insert, run.layer_mm.get());
        let area = settings.filler_area()? + insert;
        check_layer(file, &settings.path, area, layer)?;
        Ok(RunValues {
            window: BeadWindow::new(weld.procedure, role_of(name), self.wire_mm),
            weave: run.weave.clone().or_else(|| weld.weave.cloned()),
            area,
            insert,
            area_from_wire: run.area_mm2.is_none(),
            layer,
            speed: settings.speed,
            process: settings.process,
            travel_angle_deg: run.travel_angle_deg,
            stick_out_mm: run.stick_out_mm,
        })
    }
}
