//! Process values by the position on the seam, for all passes: the sectors of an orbital weld.

use super::file::{Adapt, Beads, WIRE_FEED};
use crate::allowed::on_weld;
use crate::seam::SeamCurve;
use schemars::JsonSchema;
use seamwright_document::{Document, DocumentError, Finite, NonNegative, Positive};
use seamwright_message::{Message, Unit};
use seamwright_program::{ProcessValues, is_beyond, is_same_position};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// Factors on the process values of all passes at one position; linear in between.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Sector {
    /// Path length from the start of the weld, mm; or `phi_deg`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub s_mm: Option<NonNegative>,
    /// Angle phi on the seam, degrees; or `s_mm`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub phi_deg: Option<Finite>,
    /// Factors by the name of the process value.
    pub factors: BTreeMap<String, Positive>,
}

/// The factors along a seam.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Sectors {
    /// Positions, increasing, with their factors.
    rows: Vec<(f64, BTreeMap<String, f64>)>,
    /// The seam's length if it is welded all round.
    period: Option<f64>,
}

impl Sectors {
    /// The sectors of `beads` on their seam, for process values of these names. Fails with the key's address: a position
    /// given twice or not at all or not on the weld, unknown names, rows of different names, a wire feed that already
    /// follows the area.
    pub(crate) fn new<T>(
        file: &Document<T>,
        beads: &Beads,
        seam: &SeamCurve,
        process: &ProcessValues,
    ) -> Result<Self, DocumentError> {
        let mut rows = Vec::new();
        for (i, sector) in beads.sectors.iter().enumerate() {
            let path = format!("beads.sectors[{i}]");
            if let Some(name) = sector.factors.keys().find(|name| !process.contains_key(*name)) {
                let known: Vec<&str> = process.keys().map(String::as_str).collect();
                return Err(file.unknown_name(&format!("{path}.factors.{name}"), name, &known));
            }
            if beads.adapt == Adapt::WireFeed && sector.factors.contains_key(WIRE_FEED) {
                let allowed = Message::new("weld-allowed-no-feed-factor");
                let key = format!("{path}.factors.{WIRE_FEED}");
                return Err(file.error_at(&key, Message::new("weld-feed-follows-area"), allowed));
            }
            if sector.factors.keys().ne(beads.sectors[0].factors.keys()) {
                let message = Message::new("weld-sectors-unequal");
                let allowed = Message::new("weld-allowed-same-factors");
                return Err(file.error_at(&format!("{path}.factors"), message, allowed));
            }
            let factors = sector.factors.iter().map(|(name, factor)| (name.clone(), factor.get())).collect();
            rows.push((sector.position(file, &path, seam)?, factors));
        }
        rows.sort_by(|a: &(f64, _), b| a.0.total_cmp(&b.0));
        if let Some(pair) = rows.windows(2).find(|pair| is_same_position(pair[0].0, pair[1].0)) {
            let message = Message::new("weld-sectors-at-one-place").quantity("s", pair[0].0, Unit::Mm, 1);
            return Err(file.error_at("beads.sectors", message, Message::new("weld-allowed-sectors-apart")));
        }
        Ok(Self { rows, period: seam.all_round().then(|| seam.length()) })
    }

    /// True if a sector changes the process value `name`.
    pub(crate) fn changes(&self, name: &str) -> bool {
        self.rows.first().is_some_and(|row| row.1.contains_key(name))
    }

    /// Factor of the process value `name` at path length `s` of the seam, mm; 1 without sectors.
    pub(crate) fn factor(&self, name: &str, s: f64) -> f64 {
        let (Some(first), Some(last)) = (self.rows.first(), self.rows.last()) else { return 1.0 };
        let value = |row: &(f64, BTreeMap<String, f64>)| row.1.get(name).copied().unwrap_or(1.0);
        let s = self.period.map_or(s, |period| first.0 + (s - first.0).rem_euclid(period));
        let i = self.rows.partition_point(|row| row.0 <= s);
        let Some(low) = i.checked_sub(1).map(|k| &self.rows[k]) else { return value(first) };
        let (high, to) = match (self.rows.get(i), self.period) {
            (Some(high), _) => (high, high.0),
            (None, Some(period)) => (first, first.0 + period),
            (None, None) => return value(last),
        };
        value(low) + (value(high) - value(low)) * (s - low.0) / (to - low.0)
    }

    /// Path lengths of a pass from `begin` in a `sense` along the seam, up to `length`, at which a sector begins.
    pub(crate) fn places(&self, begin: f64, sense: f64, length: f64) -> Vec<f64> {
        let mut places = Vec::new();
        for (at, _) in &self.rows {
            let Some(period) = self.period else {
                places.push(sense * (at - begin));
                continue;
            };
            let first = (sense * (at - begin)).rem_euclid(period);
            places.extend((0..).map(|turn| first + f64::from(turn) * period).take_while(|s| *s < length));
        }
        places.retain(|s| is_beyond(*s, 0.0) && is_beyond(length, *s));
        places.sort_by(f64::total_cmp);
        places
    }
}

impl Sector {
    fn position<T>(&self, file: &Document<T>, path: &str, seam: &SeamCurve) -> Result<f64, DocumentError> {
        let end = if seam.all_round() { seam.length() } else { seam.weld_length() };
        let (key, s) = match (self.s_mm, self.phi_deg) {
            (Some(s), None) => ("s_mm", Some(s.get())),
            (None, Some(phi)) => ("phi_deg", seam.s_of_phi(phi.get().to_radians())),
            _ => {
                let message = Message::new("weld-sector-position-unclear");
                return Err(file.error_at(path, message, Message::new("weld-allowed-s-or-phi")));
            }
        };
        s.filter(|s| !is_beyond(*s, end)).ok_or_else(|| {
            let message = Message::new("weld-position-beside-weld");
            file.error_at(&format!("{path}.{key}"), message, on_weld(end, false))
        })
    }
}
