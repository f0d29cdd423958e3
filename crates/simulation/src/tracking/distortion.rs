//! Distortion files: true position of a part, and its bending during the weld.

use super::displacement::{Displacement, Part};
use super::world::Placement;
use glam::{DQuat, DVec2};
use seamwright_document::{Direction, Document, DocumentError, Finite, NonNegative, Point, Positive, SchemaVersion};
use seamwright_message::{Message, Unit};
use serde::Deserialize;
use std::f64::consts::TAU;

/// Differences between a part and its plan. Directions along the seam are those of the torch. Lateral points to the
/// left of the travel direction, seen along the height; height points away from the work.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
struct DistortionFile {
    #[serde(rename = "schema")]
    _schema: SchemaVersion,
    /// Placement of the whole part.
    #[serde(default)]
    placement: PlacementFile,
    /// Displacements of the seam; all of them add up.
    #[serde(default)]
    displacement: Vec<DisplacementFile>,
    /// Start and end of tacks on the joint by path length, mm: they hide the joint.
    #[serde(default)]
    tacks_mm: Vec<[NonNegative; 2]>,
}

/// Rigid motion of the part away from its planned pose, in the work frame.
#[derive(Debug, Clone, PartialEq, Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
struct PlacementFile {
    shift_mm: Point,
    turn: Option<Direction>,
    angle_deg: Finite,
    /// A point of the rotation axis; the middle of the seam if missing.
    about_mm: Option<Point>,
}

/// Displacements along a seam; lengths and positions by path length from the start of the weld, mm.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
struct DisplacementFile {
    /// Head whose seam is displaced, counted from 1; all heads if missing.
    head: Option<u8>,
    shift: Option<By>,
    step: Option<StepFile>,
    ramp: Option<RampFile>,
    /// On a closed seam the length is changed to the nearest one that closes.
    wave: Option<WaveFile>,
    out_of_round: Option<RoundFile>,
    bend: Option<BendFile>,
    sag: Option<SagFile>,
    gap: Option<GapFile>,
    heat: Option<HeatFile>,
}

#[derive(Debug, Clone, Copy, PartialEq, Default, Deserialize)]
#[serde(deny_unknown_fields, default)]
struct By {
    lateral_mm: Finite,
    height_mm: Finite,
}

impl By {
    fn get(self) -> DVec2 {
        DVec2::new(self.lateral_mm.get(), self.height_mm.get())
    }
}

#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
struct StepFile {
    at_mm: NonNegative,
    by: By,
}

#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
struct RampFile {
    from_mm: NonNegative,
    to_mm: Positive,
    by: By,
}

#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
struct WaveFile {
    length_mm: Positive,
    by: By,
    #[serde(default)]
    phase_deg: Finite,
}

/// Periodic radius of a closed seam.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
struct RoundFile {
    /// Maximum minus minimum diameter (ovality), mm.
    by_mm: Positive,
    /// Periods of the radius per turn: 2 is oval.
    lobes: Option<u8>,
    #[serde(default)]
    phase_deg: Finite,
}

/// A slow bend, determined by the simulation's seed.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
struct BendFile {
    most_mm: Positive,
}

#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
struct SagFile {
    from_mm: NonNegative,
    to_mm: Positive,
    by_mm: Finite,
}

#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
struct GapFile {
    from_mm: NonNegative,
    /// mm of gap per mm of seam.
    slope: Positive,
    most_mm: Positive,
}

#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
struct HeatFile {
    by: By,
    ahead_mm: Positive,
    behind_mm: Positive,
}

/// Keys of a displacement.
const DISPLACEMENTS: &str = "shift, step, ramp, wave, out_of_round, bend, sag, gap, heat";

/// Differences between a part and its plan.
#[derive(Debug, Clone, PartialEq)]
pub struct Distortion(DistortionFile);

impl Distortion {
    /// Reads a distortion file.
    ///
    /// # Errors
    /// The first invalid value, with its address.
    pub fn read(file: &str, text: &str) -> Result<Self, DocumentError> {
        let document = Document::<DistortionFile>::read(file, text)?;
        let DistortionFile { displacement, tacks_mm, placement, .. } = &document.value;
        let ends = |at: String, from: f64, to: f64| {
            let range = Message::new("cell-empty-range").value("from", from, Unit::Mm).value("to", to, Unit::Mm);
            (from >= to).then(|| document.error_at(&at, range, Message::new("cell-allowed-range")))
        };
        for (i, one) in displacement.iter().enumerate() {
            let ramp = one.ramp.as_ref().map(|r| ("ramp", r.from_mm.get(), r.to_mm.get()));
            let sag = one.sag.as_ref().map(|s| ("sag", s.from_mm.get(), s.to_mm.get()));
            for (key, from, to) in ramp.into_iter().chain(sag) {
                if let Some(error) = ends(format!("displacement[{i}].{key}"), from, to) {
                    return Err(error);
                }
            }
            if one.head.is_some_and(|head| !(1..=2).contains(&head)) {
                let allowed = Message::new("cell-allowed-heads");
                return Err(document.error_at(
                    &format!("displacement[{i}].head"),
                    Message::new("cell-no-head"),
                    allowed,
                ));
            }
            if one.parts(100.0, 0).is_empty() {
                let message = Message::new("cell-empty-displacement");
                return Err(document.error_at(&format!("displacement[{i}]"), message, DISPLACEMENTS));
            }
        }
        for (i, [from, to]) in tacks_mm.iter().enumerate() {
            if let Some(error) = ends(format!("tacks_mm[{i}]"), from.get(), to.get()) {
                return Err(error);
            }
        }
        if placement.angle_deg.get() != 0.0 && placement.turn.is_none() {
            let allowed = Message::new("cell-allowed-turn");
            return Err(document.error_at("placement.angle_deg", Message::new("cell-turn-missing"), allowed));
        }
        Ok(Self(document.value))
    }

    /// Returns the placement of the part; `middle` is that of the seam.
    #[must_use]
    pub fn placement(&self, middle: glam::DVec3) -> Placement {
        let PlacementFile { shift_mm, turn, angle_deg, about_mm } = &self.0.placement;
        let angle = angle_deg.get().to_radians();
        Placement {
            shift: shift_mm.get(),
            turn: turn.map_or(DQuat::IDENTITY, |axis| DQuat::from_axis_angle(axis.unit(), angle)),
            about: about_mm.map_or(middle, Point::get),
        }
    }

    /// Returns the displacement of the seam of head `head` (from 0); a closed seam has the circumference `round_mm`.
    #[must_use]
    pub fn displacement(&self, head: usize, length_mm: f64, round_mm: Option<f64>, seed: u64) -> Displacement {
        let mine = |d: &&DisplacementFile| d.head.is_none_or(|n| usize::from(n) == head + 1);
        let parts = self.0.displacement.iter().filter(mine);
        let parts = parts.flat_map(|d| d.parts(round_mm.unwrap_or(length_mm), seed.wrapping_add(head as u64)));
        let parts = parts.map(|part| round_mm.map_or(part, |round| closed(part, round)));
        let tacks = self.0.tacks_mm.iter().map(|[from, to]| (from.get(), to.get()));
        Displacement { parts: parts.collect(), tacks: tacks.collect() }
    }
}

/// Gives a wave on a closed seam the nearest length that returns to the start.
fn closed(part: Part, round_mm: f64) -> Part {
    match part {
        Part::Wave { length_mm, size, phase } => {
            Part::Wave { length_mm: round_mm / (round_mm / length_mm).round().max(1.0), size, phase }
        }
        other => other,
    }
}

impl DisplacementFile {
    fn parts(&self, length_mm: f64, seed: u64) -> Vec<Part> {
        let phase = |deg: Finite| DVec2::splat(deg.get().to_radians());
        let one = [
            self.shift.map(|by| Part::Shift(by.get())),
            self.step.as_ref().map(|s| Part::Step { at_mm: s.at_mm.get(), by: s.by.get() }),
            self.ramp.as_ref().map(|r| Part::Ramp { from_mm: r.from_mm.get(), to_mm: r.to_mm.get(), by: r.by.get() }),
            self.wave.as_ref().map(|w| Part::Wave {
                length_mm: w.length_mm.get(),
                size: w.by.get(),
                phase: phase(w.phase_deg),
            }),
            self.out_of_round.as_ref().map(|r| Part::Wave {
                length_mm: length_mm / f64::from(r.lobes.unwrap_or(2).max(1)),
                // A diameter has two radii.
                size: DVec2::new(0.25 * r.by_mm.get(), 0.0),
                phase: phase(r.phase_deg) + DVec2::splat(TAU / 4.0),
            }),
            self.sag.as_ref().map(|s| Part::Sag {
                from_mm: s.from_mm.get(),
                to_mm: s.to_mm.get(),
                by_mm: s.by_mm.get(),
            }),
            self.gap.as_ref().map(|g| Part::Gap {
                from_mm: g.from_mm.get(),
                slope: g.slope.get(),
                most_mm: g.most_mm.get(),
            }),
            self.heat.as_ref().map(|h| Part::Heat {
                by: h.by.get(),
                ahead_mm: h.ahead_mm.get(),
                behind_mm: h.behind_mm.get(),
            }),
        ];
        let bend = self.bend.as_ref().map(|b| Displacement::bend(length_mm, b.most_mm.get(), seed).parts);
        one.into_iter().flatten().chain(bend.into_iter().flatten()).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;

    #[test]
    fn everything_adds_up() {
        let text = "schema = 1\ntacks_mm = [[10, 25]]\n[placement]\nshift_mm = [1, 2, 3]\nturn = [0, 0, 2]\nangle_deg = 90\n\
                    [[displacement]]\nshift = { lateral_mm = 0.5 }\nstep = { at_mm = 50, by = { height_mm = 1 } }\n\
                    [[displacement]]\nhead = 2\nramp = { from_mm = 0, to_mm = 100, by = { lateral_mm = 2 } }\n\
                    [[displacement]]\nhead = 1\nout_of_round = { by_mm = 1 }\n";
        let distortion = Distortion::read("d.toml", text).unwrap();
        let placement = distortion.placement(DVec3::X);
        assert_eq!((placement.shift, placement.about), (DVec3::new(1.0, 2.0, 3.0), DVec3::X));
        assert!((placement.turn * DVec3::X).distance(DVec3::Y) < 1e-12);
        let [first, second] = [0, 1].map(|head| distortion.displacement(head, 120.0, Some(100.0), 1));
        // Oval: the radius is maximum at the start, minimum a quarter of the way round.
        assert!(first.at(0.0, 0.0).distance(DVec2::new(0.75, 0.0)) < 1e-12);
        assert!(first.at(25.0, 0.0).distance(DVec2::new(0.25, 0.0)) < 1e-12);
        assert!(second.at(60.0, 0.0).distance(DVec2::new(0.5 + 1.2, 1.0)) < 1e-12);
        let wave =
            "schema = 1\n[[displacement]]\nwave = { length_mm = 30, by = { height_mm = 1 } }\nbend = { most_mm = 2 }";
        let wave = Distortion::read("d.toml", wave).unwrap();
        for seed in 0..20 {
            let wave = wave.displacement(0, 120.0, Some(100.0), seed);
            assert!(wave.at(0.0, 0.0).distance(wave.at(100.0, 0.0)) < 1e-9, "it closes");
        }
        assert!(first.is_tacked(12.0) && !second.is_tacked(30.0));
    }

    #[test]
    fn what_cannot_be_is_refused() {
        let bad = [
            ("[[displacement]]\nramp = { from_mm = 5, to_mm = 5, by = {} }", "displacement[0].ramp"),
            ("[[displacement]]\nhead = 1", "out_of_round"),
            ("[[displacement]]\nhead = 3\nshift = {}", "head"),
            ("[[displacement]]\nshfit = {}", "shift"),
            ("tacks_mm = [[5, 1]]", "tacks_mm[0]"),
            ("[placement]\nangle_deg = 3", "axis"),
            ("[placement]\nshift_mm = [1, 2]", "shift_mm"),
        ];
        for (text, named) in bad {
            let error = Distortion::read("d.toml", &format!("schema = 1\n{text}\n")).unwrap_err().to_string();
            assert!(error.contains(named) && error.contains("d.toml"), "{text}: {error}");
        }
    }
}
