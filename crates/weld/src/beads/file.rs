use super::sectors::Sector;
use crate::allowed::{at_most, between, rounded};
use crate::seam::SeamCurve;
use schemars::JsonSchema;
use seamwright_document::{Document, DocumentError, Finite, NonNegative, Positive};
use seamwright_message::{Message, Unit};
use seamwright_program::{Keyed, Pass, ProcessValues, Role, Weave, is_beyond};
use serde::{Deserialize, Serialize};

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

/// Diameters of wires, mm: beyond micro-wires and the thickest electrodes of submerged arcs (6.4 mm); a strip counts by the
/// wire of its area.
const WIRES_MM: [f64; 2] = [0.1, 12.0];
/// Minimum length of a step-over, mm: on a shorter one the torch would go across the seam, not along it.
const MIN_STEP_OVER_MM: f64 = 10.0;
/// Maximum length of a step-over as a part of the seam: longer ones would meet.
const MAX_STEP_OVER: f64 = 0.5;

impl Beads {
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
        if let Some(wire) = self.wire_mm.filter(|wire| !(WIRES_MM[0]..=WIRES_MM[1]).contains(&wire.get())) {
            let message = Message::new("weld-wire-implausible").value("wire", wire.get(), Unit::Mm);
            return Err(file.error_at("beads.wire_mm", message, between(WIRES_MM[0], WIRES_MM[1], Unit::Mm)));
        }
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
        if length < MIN_STEP_OVER_MM.min(most) {
            return wrong("weld-step-over-too-short", between(MIN_STEP_OVER_MM.min(most), rounded(most), Unit::Mm));
        }
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
