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

#[cfg(test)]
#[allow(clippy::float_cmp, reason = "values at the sides are exactly those")]
mod tests {
    use super::*;
    use crate::arc_time::ArcTime;
    use crate::program::Program;
    use crate::weave::{Dwells, Figure};

    const TEXT: &str = "schema = 1\ntitle = \"t\"\nmachine = \"m\"\n[seam.nozzle]\nradius_mm = 250\n\
        [seam.nozzle.body.cylinder]\nradius_mm = 800\n[[passes]]\nname = \"root\"\n[passes.weave]\n\
        width_mm = 8\nfrequency_hz = 1.5\nfigure = \"trapezoid\"\ndwell_first_s = 0.15\ndwell_second_s = 0.1\n\
        at_sides = { current_a = 150 }\n\
        [[passes.spans]]\nfrom_mm = 0\nto_mm = 40\nspeed_mm_s = 3\nprocess = { current_a = 200 }\n\
        [[passes.spans]]\nfrom_mm = 40\nto_mm = 90\nspeed_mm_s = { from = 3, to = 5 }\nprocess = { current_a = 200 }\n\
        [[passes.spans]]\nfrom_mm = 90\nto_mm = 120\nspeed_mm_s = { from = 5, to = 5.00000001 }\n\
        process = { current_a = { from = 200, to = 180 } }\n";

    fn pass(text: &str) -> Pass {
        Program::read("p.toml", text).unwrap().value.passes.remove(0)
    }

    #[test]
    fn phases_are_the_integral_of_frequency_over_speed() {
        let pass = pass(TEXT);
        let weaving = Weaving::new(&pass).unwrap();
        // Midpoints of many small steps: second order.
        let (steps, length) = (120_000, 120.0);
        let h = length / f64::from(steps);
        let mut sum = 0.0;
        for i in 0..steps {
            let s = h * f64::from(i);
            assert!((weaving.phase(s) - sum).abs() < 1e-7, "{s}: {} {sum}", weaving.phase(s));
            let knot = weaving.offset(s).0 - 4.0 * pass.swing_at(s);
            assert!(knot.abs() < 1e-9, "{s}");
            sum += h * 1.5 / pass.speed_at(s + 0.5 * h);
        }
        // Knots are where the figure's are.
        let knots = weaving.knots();
        let at_figure = knots.iter().filter(|s| {
            let phase = weaving.phase(**s).rem_euclid(1.0);
            let figure = Figure::Trapezoid.knots(Dwells { first: 0.225, second: 0.15 });
            figure.iter().chain(&[1.0]).any(|knot| (phase - knot).abs() < 1e-9)
        });
        let all = 4.0 * weaving.phase(length);
        assert!((at_figure.count() as f64 - all).abs() < 4.0 && knots.len() as f64 > all);
        assert!(knots.is_sorted());
        assert!((weaving.faster(0.5).phase(100.0) - 0.5 * weaving.phase(100.0)).abs() < 1e-12);
    }

    #[test]
    fn process_values_follow_the_square_of_the_swing() {
        let pass = pass(TEXT);
        let current = |s: f64| pass.process_at("current_a", s, ArcTime::TRAVEL).unwrap();
        let mut sides = 0;
        for i in 0..9000 {
            let s = 0.01 * f64::from(i);
            let swing = pass.swing_at(s);
            assert!((current(s) - (200.0 - 50.0 * swing * swing)).abs() < 1e-9);
            if swing.abs() == 1.0 {
                assert_eq!(current(s), 150.0);
                sides += 1;
            }
        }
        // The dwells are 0.25 s of 0.667 s, between the fades.
        assert!((f64::from(sides) / 8500.0 - 0.375).abs() < 0.02, "{sides}");
        assert_eq!(current(0.0), 200.0);
    }

    #[test]
    fn wrong_weaves_have_an_address() {
        let wrong = |from: &str, to: &str| {
            assert!(TEXT.contains(from), "{from}");
            let e = Program::read("p.toml", &TEXT.replacen(from, to, 1)).unwrap_err();
            (e.key.trim_start_matches("passes[0].").to_owned(), e.message)
        };
        for (from, to, key, code) in [
            ("frequency_hz = 1.5", "", "weave", "program-weave-pitch-unclear"),
            ("frequency_hz = 1.5", "frequency_hz = 1\npitch_mm = 2", "weave", "program-weave-pitch-unclear"),
            ("\"trapezoid\"", "\"sine\"", "weave.dwell_first_s", "program-only-trapezoid-dwells"),
            ("frequency_hz = 1.5", "pitch_mm = 2", "weave.dwell_first_s", "program-dwell-needs-frequency"),
            ("= 0.15", "= 0.6", "weave.dwell_first_s", "program-dwells-too-long"),
            ("width_mm = 8", "width_mm = 8\nlength_mm = 2", "weave.length_mm", "program-figure-without-length"),
            ("{ current_a = 150", "{ voltage_v = 20", "weave.at_sides.voltage_v", "document-unknown-name"),
            ("{ current_a = 150", "{ current_a = -1", "weave.at_sides.current_a", "program-process-value-negative"),
            ("{ from = 3, to = 5 }", "4", "spans[1].speed_mm_s", "program-weave-speed-jumps"),
            ("\"root\"", "\"root\"\ncorner = { blend_mm = 0.2 }", "corner", "program-weave-at-blend"),
            ("= 0.15\ndwell_second_s = 0.1", "= 0", "weave.width_mm", ""),
        ] {
            if key == "weave.width_mm" {
                let e = Program::read("p.toml", &TEXT.replacen("width_mm = 8", "width_mm = 0", 1)).unwrap_err();
                assert!(e.key.ends_with("weave.width_mm"), "{e}");
                continue;
            }
            let (found, message) = wrong(from, to);
            assert_eq!((found.as_str(), message.code.as_ref()), (key, code), "{message}");
        }
        let fast = TEXT.replacen("= 0.15\ndwell_second_s = 0.1", "= 0", 1).replacen("1.5", "40", 1);
        let e = Program::read("p.toml", &fast).unwrap_err();
        assert_eq!(e.key, "passes[0].weave.frequency_hz");
        assert!(e.message.to_string().contains("0.0750 mm") && e.allowed.unwrap().to_string().contains("30.0000 Hz"));
    }

    #[test]
    fn programs_come_back_as_they_were_and_without_a_weave_have_no_word_of_it() {
        let program = Program::read("p.toml", TEXT).unwrap().value;
        let text = program.to_toml().unwrap();
        assert_eq!(Program::read("p.toml", &text).unwrap().value, program);
        let mut plain = program;
        plain.passes[0].weave = None;
        let text = plain.to_toml().unwrap();
        assert!(!text.contains("weave") && !text.contains("oscillation"), "{text}");
    }
}
