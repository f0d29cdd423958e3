//! Weaving of the torch, and the figures that it or a deflected beam goes through.

use crate::at_corner::AtCorner;
use crate::keyed::Keyed;
use crate::process::ProcessValues;
use crate::span::Span;
use schemars::JsonSchema;
use seamwright_document::{Document, DocumentError, Finite, NonNegative, Positive};
use seamwright_message::{Message, Unit};
use serde::{Deserialize, Serialize};
use std::f64::consts::TAU;

/// Sharpness of a triangle's tips: the sine of half the angle that its sides leave open to rounding.
const SHARP: f64 = 0.97;

/// Largest part of a period that may be spent in dwells.
const MAX_DWELL: f64 = 0.9;

/// Steepest plane of a weave, degrees: steeper ones go along the torch rather than across.
const MAX_PLANE_DEG: f64 = 80.0;

/// Maximum number of periods in a pass; more are a mistake.
const MAX_PERIODS: f64 = 2e5;

/// Minimum way along the seam for one period, mm; less is a mistake.
const MIN_PITCH_MM: f64 = 0.1;

/// Speeds of spans that meet differ by less than this part: rounding.
const SAME_SPEED: f64 = 1e-9;

/// A motion to and fro across the weld while it goes on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Figure {
    /// Across as a sine.
    #[default]
    Sine,
    /// Across at an even speed, with rounded tips.
    Triangle,
    /// Across and, at each side, a dwell.
    Trapezoid,
    /// Round and round.
    Circle,
    /// A lying eight: twice along for once across.
    Eight,
}

/// Weaving of the torch.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Weave {
    /// The figure.
    #[serde(default)]
    pub figure: Figure,
    /// Width from side to side, mm.
    pub width_mm: Positive,
    /// Angle of the plane in which it goes to and fro, degrees: 0 is square to the torch; positive lifts the side of the
    /// first part towards the torch.
    #[serde(default)]
    pub plane_deg: Finite,
    /// Length along the seam of a circle or an eight, mm; as wide as it is long if missing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub length_mm: Option<Positive>,
    /// Way along the seam for one period, mm. Either this or the frequency.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pitch_mm: Option<Positive>,
    /// Periods a second at the asked speed along the seam.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub frequency_hz: Option<Positive>,
    /// Dwell at the side of the first part, s; of a trapezoid.
    #[serde(default)]
    pub dwell_first_s: NonNegative,
    /// Dwell at the side of the second part, s.
    #[serde(default)]
    pub dwell_second_s: NonNegative,
    /// The weave widens and narrows over this way at the ends of the pass, mm.
    #[serde(default = "fade")]
    pub fade_mm: NonNegative,
    /// Process values at the sides; between them they go over to those of the pass in the middle.
    #[serde(default, skip_serializing_if = "ProcessValues::is_empty")]
    pub at_sides: ProcessValues,
}

fn fade() -> NonNegative {
    NonNegative::new(5.0).unwrap_or_default()
}

/// Offset of a figure: 1 is the whole way to the side of the first part, or as far ahead as it goes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Swing {
    /// Across the weld, towards the first part.
    pub across: f64,
    /// Along it, ahead.
    pub along: f64,
}

/// Dwells of a trapezoid, as parts of its period.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dwells {
    /// Dwell at the side of the first part.
    pub first: f64,
    /// Dwell at the side of the second part.
    pub second: f64,
}

impl Dwells {
    /// No dwells.
    pub const NONE: Self = Self { first: 0.0, second: 0.0 };

    /// Part of the period from one side to the other.
    fn way(self) -> f64 {
        0.5 * (1.0 - self.first - self.second)
    }
}

impl Figure {
    /// Offset of the figure at a phase (1 is a period); only a trapezoid has `dwells`. Twice continuously
    /// differentiable; outside [`Figure::knots`] any number of times.
    pub fn at(self, phase: f64, dwells: Dwells) -> Swing {
        let phase = phase.rem_euclid(1.0);
        let (sin, cos) = (TAU * phase).sin_cos();
        let across = match self {
            Self::Sine | Self::Circle | Self::Eight => sin,
            Self::Triangle => (SHARP * sin).asin() / SHARP.asin(),
            Self::Trapezoid => trapezoid(phase, dwells),
        };
        let along = match self {
            Self::Circle => cos,
            Self::Eight => 2.0 * sin * cos,
            _ => 0.0,
        };
        Swing { across, along }
    }

    /// Phases within a period at which a third derivative jumps.
    pub fn knots(self, dwells: Dwells) -> Vec<f64> {
        let way = dwells.way();
        match self {
            Self::Trapezoid => vec![0.0, way, way + dwells.first, 2.0 * way + dwells.first],
            _ => Vec::new(),
        }
    }

    /// True if it goes along too.
    pub fn is_round(self) -> bool {
        matches!(self, Self::Circle | Self::Eight)
    }
}

/// From the side of the second part across, a dwell, back, and a dwell.
fn trapezoid(phase: f64, dwells: Dwells) -> f64 {
    let (way, first) = (dwells.way(), dwells.first);
    let smooth = |t: f64| t * t * t * (10.0 + t * (6.0 * t - 15.0));
    if phase < way {
        2.0 * smooth(phase / way) - 1.0
    } else if phase < way + first {
        1.0
    } else if phase < 2.0 * way + first {
        1.0 - 2.0 * smooth((phase - way - first) / way)
    } else {
        -1.0
    }
}

impl Weave {
    /// Checks the weave at `path` of a file; `process` are the values of the pass, `corner` is its behaviour at corners.
    ///
    /// # Errors
    /// With the key's address: neither pitch nor frequency or both, dwells without a trapezoid or longer than the
    /// period. Also values at the sides that the pass does not have, and corners that are to be blended.
    pub fn check<T>(
        &self,
        file: &Document<T>,
        path: &str,
        process: &ProcessValues,
        corner: Keyed<AtCorner>,
    ) -> Result<(), DocumentError> {
        if matches!(corner.value, AtCorner::BlendMm(_)) {
            let message = Message::new("program-weave-at-blend");
            return Err(file.error_at(corner.key, message, Message::new("program-corner-or-no-weave")));
        }
        let wrong = |key: &str, code, allowed: Message| {
            Err(file.error_at(&format!("{path}.{key}"), Message::new(code), allowed))
        };
        if self.pitch_mm.is_some() == self.frequency_hz.is_some() {
            let allowed = Message::new("program-either").key("first", "pitch_mm").key("second", "frequency_hz");
            return Err(file.error_at(path, Message::new("program-weave-pitch-unclear"), allowed));
        }
        let dwell = self.dwell_first_s.get() + self.dwell_second_s.get();
        if dwell > 0.0 {
            let key = if self.dwell_first_s.get() > 0.0 { "dwell_first_s" } else { "dwell_second_s" };
            if self.figure != Figure::Trapezoid {
                return wrong(key, "program-only-trapezoid-dwells", Message::new("program-no-dwell-or-trapezoid"));
            }
            match self.frequency_hz {
                None => {
                    let allowed = Message::new("program-frequency-instead-of-pitch");
                    return wrong(key, "program-dwell-needs-frequency", allowed);
                }
                Some(frequency) if dwell * frequency.get() > MAX_DWELL => {
                    let most = MAX_DWELL / frequency.get();
                    let allowed = Message::new("program-dwells-together").quantity("max", most, Unit::S, 4);
                    return wrong(key, "program-dwells-too-long", allowed);
                }
                _ => {}
            }
        }
        if self.plane_deg.get().abs() > MAX_PLANE_DEG {
            let allowed = Message::new("document-between");
            let allowed = allowed.value("min", -MAX_PLANE_DEG, Unit::Deg).value("max", MAX_PLANE_DEG, Unit::Deg);
            return wrong("plane_deg", "program-weave-along-torch", allowed);
        }
        if self.length_mm.is_some() && !self.figure.is_round() {
            return wrong("length_mm", "program-figure-without-length", Message::new("program-figures-with-length"));
        }
        crate::process::check_process(file, &format!("{path}.at_sides"), &self.at_sides)?;
        if let Some(name) = self.at_sides.iter().find_map(|(name, value)| value.is_ramp().then_some(name)) {
            return wrong(&format!("at_sides.{name}"), "program-sides-not-steady", Message::new("document-number"));
        }
        if let Some(name) = self.at_sides.keys().find(|name| !process.contains_key(*name)) {
            let known: Vec<&str> = process.keys().map(String::as_str).collect();
            return Err(file.unknown_name(&format!("{path}.at_sides.{name}"), name, &known));
        }
        Ok(())
    }

    /// Checks the weave at `path` of a file against the speeds of a pass' spans, whose addresses `speed_at` gives.
    ///
    /// # Errors
    /// With the key's address: periods that are too short, or a jump of the speed between spans with a weave by
    /// frequency.
    pub fn check_speeds<T>(
        &self,
        file: &Document<T>,
        path: &str,
        spans: &[Span],
        speed_at: impl Fn(usize) -> String,
    ) -> Result<(), DocumentError> {
        let slowest = spans.iter().map(|span| span.speed_mm_s.ends()).fold(f64::INFINITY, |v, (a, b)| v.min(a).min(b));
        let (key, pitch, allowed) = match (self.frequency_hz, self.pitch_mm) {
            (Some(frequency), _) => {
                let most = slowest / MIN_PITCH_MM;
                let allowed = Message::new("program-frequency-at-speed").quantity("max", most, Unit::Hz, 4);
                ("frequency_hz", slowest / frequency.get(), allowed.value("speed", slowest, Unit::MmPerS))
            }
            (None, pitch) => {
                let allowed = Message::new("document-at-least").value("min", MIN_PITCH_MM, Unit::Mm);
                ("pitch_mm", pitch.map_or(slowest, Positive::get), allowed)
            }
        };
        if pitch < MIN_PITCH_MM {
            let message = Message::new("program-weave-period-short").quantity("pitch", pitch, Unit::Mm, 4);
            return Err(file.error_at(&format!("{path}.{key}"), message, allowed));
        }
        let periods: f64 = spans.iter().map(|span| self.periods(span, span.to_mm.get())).sum();
        if periods > MAX_PERIODS {
            let message = Message::new("program-weave-periods").number("periods", periods, 0);
            let allowed = Message::new("program-up-to-periods").number("max", MAX_PERIODS, 0);
            return Err(file.error_at(&format!("{path}.{key}"), message, allowed));
        }
        let jump = (1..spans.len()).find(|&i| {
            let (before, after) = (spans[i - 1].speed_mm_s.ends().1, spans[i].speed_mm_s.ends().0);
            (after - before).abs() > SAME_SPEED * before
        });
        match jump.filter(|_| self.frequency_hz.is_some()) {
            None => Ok(()),
            Some(i) => {
                let before = spans[i - 1].speed_mm_s.ends().1;
                let message = Message::new("program-weave-speed-jumps");
                let allowed = Message::new("program-span-speed-or-pitch").value("speed", before, Unit::MmPerS);
                Err(file.error_at(&speed_at(i), message, allowed))
            }
        }
    }

    /// Periods from the beginning of `span`, part of a pass, to path length `s` of that: by the pitch, or at the
    /// frequency and the asked speed `v`, the integral of `f / v(s)`.
    pub(crate) fn periods(&self, span: &Span, s: f64) -> f64 {
        let (from, to) = (span.from_mm.get(), span.to_mm.get());
        let way = s - from;
        let Some(frequency) = self.frequency_hz else {
            return way / self.pitch_mm.map_or(f64::INFINITY, Positive::get);
        };
        let (v, end) = span.speed_mm_s.ends();
        let growth = (end - v) / (v * (to - from)) * way;
        frequency.get() * way / v * log_part(growth)
    }

    /// Path length at which `periods` have passed since the beginning of `span`: the inverse of [`Weave::periods`].
    pub(crate) fn place(&self, span: &Span, periods: f64) -> f64 {
        let (from, to) = (span.from_mm.get(), span.to_mm.get());
        let Some(frequency) = self.frequency_hz else {
            return from + periods * self.pitch_mm.map_or(f64::INFINITY, Positive::get);
        };
        let (v, end) = span.speed_mm_s.ends();
        let (time, slope) = (periods / frequency.get(), (end - v) / (to - from));
        let x = slope * time;
        // (e^x - 1) / x, by its series where the quotient would lose digits.
        let part = if x.abs() < 1e-5 { 1.0 + x * (0.5 + x / 6.0) } else { x.exp_m1() / x };
        from + v * time * part
    }

    /// The same weave, `factor` times as fast; dwells take the seconds that they take.
    #[must_use]
    pub fn faster(&self, factor: f64) -> Self {
        let times = |value: Option<Positive>, factor: f64| value.and_then(|v| Positive::new(v.get() * factor));
        let (frequency_hz, pitch_mm) = (times(self.frequency_hz, factor), times(self.pitch_mm, 1.0 / factor));
        Self { frequency_hz, pitch_mm, ..self.clone() }
    }

    /// Parts of a period in the dwells at the sides of the first and the second part.
    pub fn dwells(&self) -> Dwells {
        let of = |dwell: NonNegative| dwell.get() * self.frequency_hz.map_or(0.0, Positive::get);
        Dwells { first: of(self.dwell_first_s), second: of(self.dwell_second_s) }
    }

    /// Half the width and half the length, mm.
    pub fn reach(&self) -> (f64, f64) {
        let width = self.width_mm.get();
        (0.5 * width, 0.5 * self.length_mm.map_or(width, Positive::get))
    }

    /// Part of the weave's width at `s` of a pass of this length: 0 at the ends, 1 between the fades; twice
    /// continuously differentiable.
    pub fn fade(&self, s: f64, length: f64) -> f64 {
        let fade = self.fade_mm.get().min(0.5 * length);
        let t = if fade > 0.0 { (s.min(length - s) / fade).clamp(0.0, 1.0) } else { 1.0 };
        t * t * t * (10.0 + t * (6.0 * t - 15.0))
    }
}

/// `ln(1 + x) / x`, by its series where the quotient would lose digits.
fn log_part(x: f64) -> f64 {
    if x.abs() < 1e-5 { 1.0 - x * (0.5 - x / 3.0) } else { x.ln_1p() / x }
}
