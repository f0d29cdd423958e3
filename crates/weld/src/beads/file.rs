use super::sectors::Sector;
use crate::allowed::{at_most, between, rounded};
use crate::attitude::check_angles;
use crate::seam::SeamCurve;
use crate::stick_out;
use schemars::JsonSchema;
use seamwright_document::{Document, DocumentError, Finite, NonNegative, Positive};
use seamwright_message::{Message, Unit};
use seamwright_program::{BeadWindow, Keyed, Pass, Procedure, ProcessValues, Role, Weave, check_process, is_beyond};
use serde::{Deserialize, Serialize};
use std::f64::consts::FRAC_PI_4;

/// Name of the process value that is the wire's feed.
pub(crate) const WIRE_FEED: &str = "wire_feed_m_min";

/// Beads that fill the groove, layer by layer from the root out.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Beads {
    /// Diameter of the wire, mm. A bead's area follows from it, `wire_feed_m_min`, `deposition` and the speed.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub wire_mm: Option<Positive>,
    /// Deposition efficiency: the part of the wire that becomes weld metal, usually 0.92 to 0.99 with gas and solid wire,
    /// 0.82 to 0.88 with cored wire.
    #[serde(default = "deposition")]
    pub deposition: Positive,
    /// Quantity that follows the area of the groove along the seam.
    #[serde(default)]
    pub adapt: Adapt,
    /// Distance of neighbouring beads in a layer as a part of their width: 2/3 fills the valleys between them just so,
    /// 0.738 makes each tangent to the one before.
    #[serde(default = "spacing")]
    pub spacing_to_width: Positive,
    /// Maximum deviation of a bead's area from that of its run, percent.
    #[serde(default = "most")]
    pub most_percent: Positive,
    /// Distance between places where the beads are laid out, mm.
    #[serde(default = "station")]
    pub station_mm: Positive,
    /// Order of the beads in a layer.
    #[serde(default)]
    pub order: Order,
    /// Distance of the wire from the walls in layers of several beads, mm; three quarters of the wire if missing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub wall_mm: Option<NonNegative>,
    /// Angle by which the wire of beads beside a wall turns towards the wall, degrees.
    #[serde(default = "tilt")]
    pub wall_tilt_deg: NonNegative,
    /// Distance between the starts of successive passes on a closed seam, mm.
    #[serde(default = "stagger")]
    pub stagger_mm: NonNegative,
    /// Length of seam over which the torch steps over from one bead to the next without stopping the arc, mm, on a seam
    /// welded all round: beads of the same role that follow one another are one pass, but for the root. Without it each
    /// bead is a pass of its own.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub step_over_mm: Option<Positive>,
    /// Every other pass runs against the direction of the weld.
    #[serde(default)]
    pub alternate: bool,
    /// The shortest piece of the seam that gets a layer of its own, mm, with `adapt = "passes"`.
    #[serde(default = "shortest")]
    pub shortest_mm: Positive,
    /// Length of seam over which the other beads change where a layer starts or ends, mm, with `adapt = "passes"`.
    #[serde(default = "tie_in")]
    pub tie_in_mm: NonNegative,
    /// Factors on process values by the position on the seam, for all passes: the sectors of an orbital weld.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub sectors: Vec<Sector>,
    /// The root pass; without it the layers of `fill` begin at the root.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub root: Option<Run>,
    /// The layers between.
    pub fill: Run,
    /// The last layer; as `fill` if missing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cap: Option<Run>,
}

/// Quantity that follows the area of the groove along the seam, so that the beads always fill it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Adapt {
    /// The travel speed: slower where there is more to fill.
    #[default]
    Speed,
    /// The wire feed.
    WireFeed,
    /// The width of the weaves: as wide as the bead's room between the walls, up to the weave's `width_mm`; the speed
    /// takes up the rest.
    WeaveWidth,
    /// Layers over a part of the seam where there is more to fill; the speed takes up the rest.
    Passes,
}

/// Order of the beads in a layer.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Order {
    /// Both walls, then what is between.
    #[default]
    WallsFirst,
    /// From the first part to the second.
    FromFirst,
    /// From the second part to the first: where that one is below, each bead rests on the one before it.
    FromSecond,
}

/// Values of the passes of a kind.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Run {
    /// Speed, mm/s; that of `[weld]` if missing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub speed_mm_s: Option<Positive>,
    /// Process values that differ from those of `[weld.process]`.
    #[serde(default, skip_serializing_if = "ProcessValues::is_empty")]
    pub process: ProcessValues,
    /// Area of a bead, mm^2, where it does not follow from a wire.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub area_mm2: Option<Positive>,
    /// Wanted height of a layer, mm.
    #[serde(default = "layer")]
    pub layer_mm: Positive,
    /// Travel angle, degrees; that of `[torch]` if missing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub travel_angle_deg: Option<Finite>,
    /// Stick-out, mm; that of `[torch]` if missing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub stick_out_mm: Option<Positive>,
    /// Weave of the torch; as in `[weld]` if missing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub weave: Option<Weave>,
}

fn number(value: f64) -> Positive {
    Positive::new(value).unwrap_or(Positive::TEN)
}

fn deposition() -> Positive {
    number(0.95)
}

fn most() -> Positive {
    number(25.0)
}

fn spacing() -> Positive {
    number(0.7)
}

fn station() -> Positive {
    number(5.0)
}

fn tilt() -> NonNegative {
    NonNegative::new(12.0).unwrap_or_default()
}

fn stagger() -> NonNegative {
    NonNegative::new(20.0).unwrap_or_default()
}

fn tie_in() -> NonNegative {
    NonNegative::new(20.0).unwrap_or_default()
}

fn shortest() -> Positive {
    number(50.0)
}

fn layer() -> Positive {
    number(3.0)
}

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

/// Settings of a run.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Asked {
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

impl Asked {
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

/// Maximum length of a step-over as a part of the seam: longer ones would meet.
const MAX_STEP_OVER: f64 = 0.5;

/// No bead is wider than this many times its layer's height, or narrower than its inverse: far beyond all windows, so
/// that only mistakes are refused.
const MAX_WIDTH_TO_HEIGHT: f64 = 100.0;

/// Checks that beads of `area` (mm^2) can make layers of `layer` (mm), and lie in a procedure's window. Fails with the
/// key's address.
fn check_window<T>(
    file: &Document<T>,
    path: &str,
    window: &BeadWindow,
    (area, layer): (f64, f64),
) -> Result<(), DocumentError> {
    let [least, most] = [(area / MAX_WIDTH_TO_HEIGHT).sqrt(), (area * MAX_WIDTH_TO_HEIGHT).sqrt()];
    let layers = if window.is_binding { window.height_mm } else { [0.0, f64::INFINITY] };
    let range = [layers[0].max(least), layers[1].min(most)];
    if !(range[0]..=range[1]).contains(&layer) {
        let message = Message::new("weld-layer-height-impossible").quantity("area", area, Unit::Mm2, 1);
        let allowed = Message::new("document-between").quantity("min", range[0], Unit::Mm, 2);
        let given = format!("{path}.layer_mm");
        let key = file.given_or(&given, path);
        return Err(file.error_at(key, message, allowed.quantity("max", range[1], Unit::Mm, 2)));
    }
    // A parabola on a plane fills the least, a rectangle between walls the most.
    let [width, height] = [window.width_mm, window.height_mm];
    let areas = [2.0 / 3.0 * width[0] * height[0], width[1] * height[1]];
    if window.is_binding && !(areas[0]..=areas[1]).contains(&area) {
        let message = Message::new("weld-bead-area-beside-window").quantity("area", area, Unit::Mm2, 1);
        let allowed = Message::new("document-between").quantity("min", areas[0], Unit::Mm2, 1);
        return Err(file.error_at(path, message, allowed.quantity("max", areas[1], Unit::Mm2, 1)));
    }
    Ok(())
}

/// Maximum wire feed of process values; 0 without one.
fn fed(process: &ProcessValues) -> f64 {
    process.get(WIRE_FEED).map_or(0.0, |feed| feed.ends().0.max(feed.ends().1))
}

impl Beads {
    /// Settings of the run `name`: its own values over those of `weld`. Fails with the key's address: no area, or an
    /// area and a wire.
    pub(crate) fn asked<T>(
        &self,
        file: &Document<T>,
        name: &str,
        run: &Run,
        weld: &WeldValues,
    ) -> Result<Asked, DocumentError> {
        let path = format!("beads.{name}");
        check_process(file, &format!("{path}.process"), &run.process)?;
        if let Some(key) = run.process.keys().find(|key| !weld.process.contains_key(*key)) {
            let known: Vec<&str> = weld.process.keys().map(String::as_str).collect();
            return Err(file.unknown_name(&format!("{path}.process.{key}"), key, &known));
        }
        let mut all = weld.process.clone();
        all.extend(run.process.clone());
        check_angles(file, &path, 0.0, run.travel_angle_deg.map_or(0.0, Finite::get))?;
        if let Some(own) = run.stick_out_mm {
            stick_out::check(file, &format!("{path}.stick_out_mm"), own)?;
        }
        let speed = run.speed_mm_s.unwrap_or(weld.speed_mm_s);
        let insert = if role_of(name) == Role::Root { weld.insert_mm2 } else { 0.0 };
        let area = match (run.area_mm2, self.wire_mm) {
            (None, _) if insert > 0.0 && fed(&all) == 0.0 => 0.0,
            (Some(area), _) if self.adapt != Adapt::WireFeed => area.get(),
            (Some(_), _) => {
                let message = Message::new("weld-area-with-wire-feed");
                let allowed = Message::new("weld-allowed-no-area-with-wire-feed");
                return Err(file.error_at(&format!("{path}.area_mm2"), message, allowed));
            }
            (None, None) => {
                let message = Message::new("weld-bead-area-missing");
                return Err(file.error_at(&path, message, Message::new("weld-allowed-bead-area")));
            }
            (None, Some(wire)) => {
                let feed = all.get(WIRE_FEED).filter(|feed| !feed.is_ramp()).map(|feed| feed.ends().0);
                let Some(feed) = feed.filter(|feed| *feed > 0.0) else {
                    let message = Message::new("weld-bead-area-needs-steady-feed");
                    return Err(file.error_at(&path, message, Message::new("weld-allowed-steady-feed")));
                };
                let wire_area = FRAC_PI_4 * wire.get() * wire.get();
                wire_area * (feed * 1000.0 / 60.0) * self.deposition.get() / speed.get()
            }
        };
        let area = area + insert;
        let layer = run.layer_mm.get();
        let window = BeadWindow::new(weld.procedure, role_of(name), self.wire_mm);
        check_window(file, &path, &window, (area, layer))?;
        Ok(Asked {
            window,
            weave: run.weave.clone().or_else(|| weld.weave.cloned()),
            area,
            insert,
            area_from_wire: run.area_mm2.is_none(),
            layer,
            speed,
            process: all,
            travel_angle_deg: run.travel_angle_deg,
            stick_out_mm: run.stick_out_mm,
        })
    }

    /// Checks the weave of a finished pass against its own process values and speeds. Fails with the key's address.
    pub(crate) fn check_weave<T>(&self, file: &Document<T>, pass: &Pass) -> Result<(), DocumentError> {
        let (Some(weave), Some(role)) = (&pass.weave, pass.role) else { return Ok(()) };
        let run = match role {
            Role::Root => self.root.as_ref().map(|run| ("root", run)),
            Role::Cap => self.cap.as_ref().map(|run| ("cap", run)),
            Role::Fill | Role::Tack | Role::Cosmetic => None,
        };
        let (name, run) = run.unwrap_or(("fill", &self.fill));
        let own = run.weave.is_some().then(|| format!("beads.{name}.weave"));
        let path = own.unwrap_or_else(|| "weld.weave".to_owned());
        weave.check(file, &path, &pass.spans[0].process, Keyed { key: "weld.corner", value: &pass.corner })?;
        weave.check_speeds(file, &path, &pass.spans, |_| path.clone())
    }

    /// Checks the settings that do not depend on the groove. Fails with the key's address.
    pub(crate) fn check<T>(&self, file: &Document<T>) -> Result<(), DocumentError> {
        if self.step_over_mm.is_some() {
            if self.alternate {
                let message = Message::new("weld-step-over-with-alternate");
                return Err(file.error_at("beads.alternate", message, Message::verbatim("false")));
            }
            if self.adapt == Adapt::Passes {
                let allowed = Message::verbatim("\"speed\", \"wire_feed\", \"weave_width\"");
                return Err(file.error_at("beads.adapt", Message::new("weld-step-over-with-passes"), allowed));
            }
        }
        if self.deposition.get() > 1.0 {
            let allowed = Message::new("document-more-than-up-to").value("min", 0.0, Unit::One);
            let allowed = allowed.value("max", 1.0, Unit::One);
            return Err(file.error_at("beads.deposition", Message::new("weld-deposition-too-large"), allowed));
        }
        if self.most_percent.get() > 80.0 {
            let message = Message::new("weld-bead-range-too-large");
            return Err(file.error_at("beads.most_percent", message, at_most(80.0, Unit::Percent)));
        }
        if self.wall_tilt_deg.get() > 45.0 {
            let message = Message::new("weld-wall-tilt-too-large");
            return Err(file.error_at("beads.wall_tilt_deg", message, between(0.0, 45.0, Unit::Deg)));
        }
        if !(0.5..=1.0).contains(&self.spacing_to_width.get()) {
            let message = Message::new("weld-bead-spacing-invalid");
            return Err(file.error_at("beads.spacing_to_width", message, between(0.5, 1.0, Unit::One)));
        }
        if !(0.1..=100.0).contains(&self.station_mm.get()) {
            let message = Message::new("weld-station-distance-invalid");
            return Err(file.error_at("beads.station_mm", message, between(0.1, 100.0, Unit::Mm)));
        }
        Ok(())
    }

    /// Checks the step-over against the seam. Fails with the key's address: a seam that is not welded all round, and
    /// step-overs longer than half of it.
    pub(crate) fn check_step_over<T>(&self, file: &Document<T>, seam: &SeamCurve) -> Result<(), DocumentError> {
        let Some(length) = self.step_over_mm.map(Positive::get) else { return Ok(()) };
        let wrong = |code, allowed| Err(file.error_at("beads.step_over_mm", Message::new(code), allowed));
        if !seam.all_round() {
            return wrong("weld-step-over-needs-closed-seam", Message::new("weld-allowed-no-step-over"));
        }
        let most = MAX_STEP_OVER * seam.length();
        if is_beyond(length, most) {
            return wrong("weld-step-over-too-long", at_most(rounded(most), Unit::Mm));
        }
        Ok(())
    }

    /// Distance of the wire from the walls, mm.
    pub(crate) fn wall(&self) -> f64 {
        self.wall_mm.map_or(0.75 * self.wire_mm.map_or(1.2, Positive::get), NonNegative::get)
    }
}
