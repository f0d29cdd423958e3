use super::window::halve;
use crate::joint::FilletOrButt;
use crate::path_length::is_beyond;
use glam::DVec3;
use schemars::JsonSchema;
use seamwright_document::{Document, DocumentError, NonNegative};
use seamwright_message::{Message, Unit};
use serde::{Deserialize, Serialize};
use std::fmt;

/// A welding position of ISO 6947.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "UPPERCASE")]
pub enum WeldingPosition {
    /// Flat.
    Pa,
    /// Horizontal-vertical.
    Pb,
    /// Horizontal.
    Pc,
    /// Horizontal overhead.
    Pd,
    /// Overhead.
    Pe,
    /// Vertical up.
    Pf,
    /// Vertical down.
    Pg,
}

impl WeldingPosition {
    /// All of them, in the order of their letters.
    pub const ALL: [Self; 7] = [Self::Pa, Self::Pb, Self::Pc, Self::Pd, Self::Pe, Self::Pf, Self::Pg];
}

impl fmt::Display for WeldingPosition {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(["PA", "PB", "PC", "PD", "PE", "PF", "PG"][*self as usize])
    }
}

/// Inclination of a weld against gravity at one station.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Inclination {
    /// Slope S of the direction of travel, rad: positive uphill.
    pub slope: f64,
    /// Rotation rho of the weld's face about its axis, rad: 0 with the face up, pi with the face down. 0 for a vertical
    /// weld, which has no rotation.
    pub rotation: f64,
}

impl Inclination {
    /// Inclination of a weld, from unit vectors in one frame: `tangent` (direction of travel), `face` (from the root to
    /// the middle of the face) and `up` against gravity.
    pub fn new(tangent: DVec3, face: DVec3, up: DVec3) -> Self {
        let (rise, level) = (tangent.dot(up), tangent.cross(up).length());
        let face = face.reject_from_normalized(tangent);
        let up = up.reject_from_normalized(tangent);
        Self { slope: rise.atan2(level), rotation: face.cross(up).length().atan2(face.dot(up)) }
    }
}

/// Limits of each welding position, degrees. Missing limits take the production ranges of ISO 6947, which ASME IX
/// (QW-461) also has.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct PositionLimits {
    /// Up to this slope, uphill or downhill, the rotation alone decides; 15 if missing.
    pub level_slope_deg: NonNegative,
    /// From this slope on the weld is vertical, whatever its rotation, which means nothing there; 80 if missing.
    pub vertical_slope_deg: NonNegative,
    /// Rotations of butt welds.
    pub butt: ButtLimits,
    /// Rotations of fillet welds.
    pub fillet: FilletLimits,
    /// A position is kept along a weld until its limits are passed by more than this; 4 if missing.
    pub hysteresis_deg: NonNegative,
    /// Maximum angle between the faces at which the weld counts as a fillet, unless `joint` decides; 135 if missing.
    pub fillet_up_to_deg: NonNegative,
}

/// Maximum rotation of the positions of butt welds, degrees. Overhead (PE) goes from there to 180.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct ButtLimits {
    /// Of PA; 30 if missing.
    pub pa_deg: NonNegative,
    /// Of PC, and of sloping PF and PG; 100 if missing.
    pub pc_deg: NonNegative,
}

/// Maximum rotation of the positions of fillet welds, degrees. Overhead (PE) goes from there to 180.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct FilletLimits {
    /// Of PA; 30 if missing.
    pub pa_deg: NonNegative,
    /// Of PB; 55 if missing.
    pub pb_deg: NonNegative,
    /// Of PC, and of sloping PF and PG; 100 if missing.
    pub pc_deg: NonNegative,
    /// Of PD; 145 if missing.
    pub pd_deg: NonNegative,
}

fn degrees(value: f64) -> NonNegative {
    NonNegative::new(value).unwrap_or_default()
}

impl Default for PositionLimits {
    fn default() -> Self {
        Self {
            level_slope_deg: degrees(15.0),
            vertical_slope_deg: degrees(80.0),
            butt: ButtLimits::default(),
            fillet: FilletLimits::default(),
            hysteresis_deg: degrees(4.0),
            fillet_up_to_deg: degrees(135.0),
        }
    }
}

impl Default for ButtLimits {
    fn default() -> Self {
        Self { pa_deg: degrees(30.0), pc_deg: degrees(100.0) }
    }
}

impl Default for FilletLimits {
    fn default() -> Self {
        Self { pa_deg: degrees(30.0), pb_deg: degrees(55.0), pc_deg: degrees(100.0), pd_deg: degrees(145.0) }
    }
}

/// A stretch of a pass in one position.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct PositionStretch {
    /// The position.
    pub position: WeldingPosition,
    /// Path length at its start, mm.
    pub from_mm: f64,
    /// Path length at which it ends, mm.
    pub to_mm: f64,
}

impl PositionLimits {
    /// The kind of weld at an angle between the faces, rad.
    pub fn joint(&self, dihedral: f64) -> FilletOrButt {
        let is_fillet = dihedral.to_degrees() <= self.fillet_up_to_deg.get();
        if is_fillet { FilletOrButt::Fillet } else { FilletOrButt::Butt }
    }

    /// True if all values are the defaults.
    pub fn is_usual(&self) -> bool {
        *self == Self::default()
    }

    /// The range of rotation of `position`, degrees; `None` if welds of that joint have no such position.
    fn rotations(&self, joint: FilletOrButt, position: WeldingPosition) -> Option<(f64, f64)> {
        use WeldingPosition as P;
        let (butt, fillet) = (&self.butt, &self.fillet);
        let (low, high) = match (joint, position) {
            (FilletOrButt::Butt, P::Pb | P::Pd) => return None,
            (FilletOrButt::Butt, P::Pa) => (0.0, butt.pa_deg.get()),
            (FilletOrButt::Butt, P::Pc) => (butt.pa_deg.get(), butt.pc_deg.get()),
            (FilletOrButt::Butt, P::Pe) => (butt.pc_deg.get(), 180.0),
            (FilletOrButt::Butt, P::Pf | P::Pg) => (0.0, butt.pc_deg.get()),
            (FilletOrButt::Fillet, P::Pa) => (0.0, fillet.pa_deg.get()),
            (FilletOrButt::Fillet, P::Pb) => (fillet.pa_deg.get(), fillet.pb_deg.get()),
            (FilletOrButt::Fillet, P::Pc) => (fillet.pb_deg.get(), fillet.pc_deg.get()),
            (FilletOrButt::Fillet, P::Pd) => (fillet.pc_deg.get(), fillet.pd_deg.get()),
            (FilletOrButt::Fillet, P::Pe) => (fillet.pd_deg.get(), 180.0),
            (FilletOrButt::Fillet, P::Pf | P::Pg) => (0.0, fillet.pc_deg.get()),
        };
        Some((low, high))
    }

    /// Excess of a weld over the limits of `position`, degrees, the maximum of slope and rotation; negative or 0 within
    /// them, infinite if the position does not exist.
    pub fn beyond(&self, joint: FilletOrButt, position: WeldingPosition, at: Inclination) -> f64 {
        use WeldingPosition as P;
        let (slope, rotation) = (at.slope.to_degrees(), at.rotation.to_degrees());
        let (level, vertical) = (self.level_slope_deg.get(), self.vertical_slope_deg.get());
        let Some((low, high)) = self.rotations(joint, position) else { return f64::INFINITY };
        let turned = (low - rotation).max(rotation - high);
        match position {
            P::Pa | P::Pb | P::Pc => turned.max(slope.abs() - level),
            P::Pd | P::Pe => turned.max(slope.abs() - vertical),
            P::Pf => turned.max(level - slope).min(vertical - slope),
            P::Pg => turned.max(level + slope).min(vertical + slope),
        }
    }

    /// The position of a weld; on a limit that of the earlier letter.
    pub fn position(&self, joint: FilletOrButt, at: Inclination) -> WeldingPosition {
        let beyond = |p: &WeldingPosition| self.beyond(joint, *p, at);
        // The ranges meet without a gap: to rounding, the minimum is 0 or below.
        let least = WeldingPosition::ALL.iter().map(beyond).fold(f64::INFINITY, f64::min).max(0.0);
        WeldingPosition::ALL.into_iter().find(|p| beyond(p) <= least).unwrap_or(WeldingPosition::Pa)
    }

    /// The positions along a pass, one after the other: `at` is its inclination at a path length (mm), evaluated at
    /// `places`, which increase.
    ///
    /// A position goes on until its limits are exceeded by more than the hysteresis. The next one then starts where the
    /// weld comes within its limits (found by halving, to rounding). So no station exceeds the limits of its position
    /// by more than the hysteresis.
    pub fn along(&self, joint: FilletOrButt, places: &[f64], at: impl Fn(f64) -> Inclination) -> Vec<PositionStretch> {
        let (Some(&first), Some(&last)) = (places.first(), places.last()) else { return Vec::new() };
        let lies: Vec<Inclination> = places.iter().map(|s| at(*s)).collect();
        let mut all = Vec::new();
        let mut now = PositionStretch { position: self.position(joint, lies[0]), from_mm: first, to_mm: last };
        for (i, lie) in lies.iter().enumerate() {
            if self.beyond(joint, now.position, *lie) <= self.hysteresis_deg.get() {
                continue;
            }
            let position = self.position(joint, *lie);
            let outside = |k: &usize| places[*k] <= now.from_mm || self.beyond(joint, position, lies[*k]) > 0.0;
            let before = (0..i).rev().find(outside).unwrap_or(0);
            let within = |s: f64| self.beyond(joint, position, at(s)) <= 0.0;
            let from_mm = halve(places[before], places[before + 1], within).max(now.from_mm);
            if is_beyond(from_mm, now.from_mm) {
                all.push(PositionStretch { to_mm: from_mm, ..now });
                now.from_mm = from_mm;
            }
            now.position = position;
        }
        all.push(now);
        all
    }

    /// Checks the limits at `path` of a file: they increase and leave every position a range. Fails with the key's
    /// address.
    pub(super) fn check<T>(&self, file: &Document<T>, path: &str) -> Result<(), DocumentError> {
        let (butt, fillet) = (&self.butt, &self.fillet);
        let rising: [&[(&str, NonNegative)]; 3] = [
            &[("butt.pa_deg", butt.pa_deg), ("butt.pc_deg", butt.pc_deg)],
            &[
                ("fillet.pa_deg", fillet.pa_deg),
                ("fillet.pb_deg", fillet.pb_deg),
                ("fillet.pc_deg", fillet.pc_deg),
                ("fillet.pd_deg", fillet.pd_deg),
            ],
            &[("level_slope_deg", self.level_slope_deg), ("vertical_slope_deg", self.vertical_slope_deg)],
        ];
        for (row, end) in rising.into_iter().zip([180.0, 180.0, 90.0]) {
            for (i, (key, value)) in row.iter().enumerate() {
                let after = i.checked_sub(1).map_or(0.0, |before| row[before].1.get());
                if value.get() <= after || value.get() >= end {
                    let message = Message::new("program-limits-increase");
                    let allowed = Message::new("document-strictly-between");
                    let allowed = allowed.value("min", after, Unit::Deg).value("max", end, Unit::Deg);
                    return Err(file.error_at(&format!("{path}.{key}"), message, allowed));
                }
            }
        }
        let room = 90.0 - self.vertical_slope_deg.get();
        if self.hysteresis_deg.get() >= room {
            let message = Message::new("program-hysteresis-too-large");
            let allowed = Message::new("document-less-than").value("max", room, Unit::Deg);
            return Err(file.error_at(&format!("{path}.hysteresis_deg"), message, allowed));
        }
        Ok(())
    }
}
