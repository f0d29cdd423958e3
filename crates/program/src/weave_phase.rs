//! Phase and swing of a weave along a pass.
//!
//! The phase counts by path length: by the pitch, or as the integral of the frequency divided by the requested speed.
//! It completes whole periods in each span. The torch tip is at the centre line plus the swing. `TorchPath::rate` and
//! the requested speed are those of the centre line. `WovenPath::slower` gives the path with a slower weave, or without
//! one.

use crate::pass::Pass;
use crate::path_length::SAME_POSITION_MM;
use crate::span::Span;
use crate::weave::{Swing, Weave};

/// The weave of a pass, by the pass' path length `s`.
#[derive(Debug, Clone, PartialEq)]
pub struct Weaving {
    weave: Weave,
    spans: Vec<Span>,
    /// Periods before each span.
    begun: Vec<f64>,
}

impl Weaving {
    /// The weave of `pass`, if it has one.
    pub fn new(pass: &Pass) -> Option<Self> {
        pass.weave.as_ref().map(|weave| Self::over(weave.clone(), pass.spans.clone()))
    }

    fn over(weave: Weave, spans: Vec<Span>) -> Self {
        let mut begun = vec![0.0; spans.len()];
        for i in 1..spans.len() {
            begun[i] = begun[i - 1] + weave.periods(&spans[i - 1], spans[i - 1].to_mm.get());
        }
        Self { weave, spans, begun }
    }

    /// The same, `factor` times as fast.
    #[must_use]
    pub fn faster(&self, factor: f64) -> Self {
        Self::over(self.weave.faster(factor), self.spans.clone())
    }

    /// Periods since the beginning of the pass.
    pub fn phase(&self, s: f64) -> f64 {
        let i = self.spans.partition_point(|span| span.to_mm.get() <= s).min(self.spans.len() - 1);
        self.begun[i] + self.weave.periods(&self.spans[i], s)
    }

    /// Offset of the torch from its line, mm: across towards the first part, and along in the direction of travel.
    pub fn offset(&self, s: f64) -> (f64, f64) {
        let Swing { across, along } = self.weave.figure.at(self.phase(s), self.weave.dwells());
        let (wide, long) = self.weave.reach();
        let fade = self.weave.fade(s, self.length());
        (fade * wide * across, fade * long * along)
    }

    /// Those of the [`Weaving::knots`] at which the second derivative may jump: borders of spans, for a weave by
    /// frequency.
    pub fn bends(&self) -> Vec<f64> {
        let borders = self.spans.iter().skip(1).map(|span| span.from_mm.get());
        borders.filter(|_| self.weave.frequency_hz.is_some()).collect()
    }

    /// Path lengths inside the pass that cut every period in `parts`, and the ends of dwells. If `parts` is a multiple
    /// of four, the sides lie in the middle of a part. Increasing, mm.
    pub fn cuts(&self, parts: u32) -> Vec<f64> {
        let mut cuts = self.knots();
        for (span, begun) in self.spans.iter().zip(&self.begun) {
            let end = begun + self.weave.periods(span, span.to_mm.get());
            let first = (begun * f64::from(parts) + 0.5).floor() as i64;
            let phases = (first..).map(|k| (k as f64 + 0.5) / f64::from(parts));
            let inside = phases.skip_while(|phase| phase <= begun).take_while(|phase| *phase < end);
            cuts.extend(inside.map(|phase| self.weave.place(span, phase - begun)));
        }
        cuts.sort_by(f64::total_cmp);
        cuts.dedup_by(|a, b| *a - *b < SAME_POSITION_MM);
        cuts
    }

    /// Angle of the plane across the seam in which the torch weaves, rad, as [`Weave::plane_deg`].
    pub fn plane(&self) -> f64 {
        self.weave.plane_deg.get().to_radians()
    }

    /// Path lengths inside the pass at which a third derivative of the offset may jump, increasing, mm.
    pub fn knots(&self) -> Vec<f64> {
        let length = self.length();
        let fade = self.weave.fade_mm.get().min(0.5 * length);
        let mut knots = vec![fade, length - fade];
        if self.weave.frequency_hz.is_some() {
            knots.extend(self.spans.iter().map(|span| span.from_mm.get()));
        }
        let figure = self.weave.figure.knots(self.weave.dwells());
        for (span, begun) in self.spans.iter().zip(&self.begun).filter(|_| !figure.is_empty()) {
            let end = begun + self.weave.periods(span, span.to_mm.get());
            for period in begun.floor() as i64..=end.floor() as i64 {
                let phases = figure.iter().map(|knot| period as f64 + knot);
                let inside = phases.filter(|phase| phase > begun && *phase < end);
                knots.extend(inside.map(|phase| self.weave.place(span, phase - begun)));
            }
        }
        knots.retain(|s| *s > SAME_POSITION_MM && *s < length - SAME_POSITION_MM);
        knots.sort_by(f64::total_cmp);
        knots.dedup_by(|a, b| *a - *b < SAME_POSITION_MM);
        knots
    }

    fn length(&self) -> f64 {
        self.spans.last().map_or(0.0, |span| span.to_mm.get())
    }
}

impl Pass {
    /// Offset of the weave at path length `s`: 0 in the middle, 1 at the side of the first part, -1 at that of the
    /// second; 0 without a weave. Does not allocate.
    pub fn swing_at(&self, s: f64) -> f64 {
        let Some(weave) = &self.weave else { return 0.0 };
        let mut phase = 0.0;
        for span in self.spans.iter().take_while(|span| span.from_mm.get() <= s) {
            phase += weave.periods(span, s.clamp(span.from_mm.get(), span.to_mm.get()));
        }
        weave.fade(s, self.length()) * weave.figure.at(phase, weave.dwells()).across
    }
}
