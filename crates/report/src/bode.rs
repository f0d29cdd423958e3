//! A Bode plot: magnitude and phase over logarithmic frequency, with the margins drawn in.

use crate::number::Significant as _;
use crate::{Axis, Chart, ChartGrid, Language, LimitLine, Series, Style, Words as _};
use seamwright_message::{Message, Unit};

/// Magnitude and phase of an open loop, with its margins.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Bode {
    /// Language of built-in texts; the title is already in it.
    pub language: Language,
    /// Heading.
    pub title: String,
    /// Frequency (Hz), magnitude (dB) and phase (degrees), in order of frequency.
    pub lines: Vec<(f64, f64, f64)>,
    /// Gain margin (dB) and the frequency (Hz) where the phase crosses -180 degrees; not finite without a crossing.
    pub gain_margin: (f64, f64),
    /// Phase margin (degrees) and the frequency (Hz) where the magnitude crosses 1; not finite without a crossing.
    pub phase_margin: (f64, f64),
}

/// Height of each plot area, px.
const HIGH: f64 = 200.0;
/// Colours of response, gain margin and phase margin.
const COLOURS: [usize; 3] = [0, 1, 2];
/// Minimum magnitude shown, dB; lower values do not describe the loop and would squash the rest.
const LOWEST_DB: f64 = -60.0;

impl Bode {
    /// Returns the two plots, on one axis of frequency.
    pub fn grid(&self) -> ChartGrid {
        // Beyond the last magnitude above the minimum there is only noise.
        let count = self.lines.iter().rposition(|l| l.1 >= LOWEST_DB).map_or(0, |i| i + 1);
        Self { lines: self.lines[..count].to_vec(), ..self.clone() }.shown()
    }

    fn shown(&self) -> ChartGrid {
        let top = self.lines.iter().map(|l| l.1).fold(0.0, f64::max);
        let low = self.lines.iter().map(|l| l.1).fold(0.0, f64::min).max(LOWEST_DB);
        let phases = || self.lines.iter().map(|l| l.2);
        let steps = |v: f64, up: f64| 45.0 * ((v / 45.0 + up).floor());
        let (lowest, highest) = (phases().fold(-180.0, f64::min), phases().fold(-90.0, f64::max));
        let chart = |label, unit, range, series, limit| Chart {
            language: self.language,
            x: Axis::of(self.language, "report-bode-frequency", Unit::Hz),
            y: Axis::of(self.language, label, unit),
            series,
            limits: vec![limit],
            y_range: Some(range),
            log_x: true,
            height: Some(HIGH),
            ..Chart::default()
        };
        let magnitude = chart(
            "report-bode-magnitude",
            Unit::Db,
            (10.0 * (low / 10.0 - 0.2).floor(), 10.0 * (top / 10.0 + 0.2).ceil()),
            self.magnitudes(),
            LimitLine::new(self.language.words("report-bode-crossover"), 0.0),
        );
        let range = (steps(lowest, 0.0).max(-540.0), steps(highest, 1.0));
        let phase = chart("report-bode-phase", Unit::Deg, range, self.phases(), LimitLine::new("", -180.0));
        ChartGrid { title: self.title.clone(), columns: 1, charts: vec![magnitude, phase] }
    }

    /// Returns a dashed vertical line at a frequency, empty unless all values are finite.
    fn marker(name: String, colour: usize, at_hz: f64, ends: (f64, f64)) -> Series {
        let finite = at_hz.is_finite() && ends.0.is_finite() && ends.1.is_finite();
        let points = if finite { vec![(at_hz, ends.0), (at_hz, ends.1)] } else { Vec::new() };
        Series::line(name, points).styled(Style::Dashed).coloured(colour)
    }

    fn names(&self) -> [String; 2] {
        let text = |codes: [&'static str; 2], (margin, hz): (f64, f64), unit| {
            let message = match margin.is_finite() {
                true => {
                    let message = Message::new(codes[0]).significant("margin", margin, unit, 3);
                    message.significant("frequency", hz, Unit::Hz, 3)
                }
                false => Message::new(codes[1]),
            };
            message.in_language(self.language)
        };
        [
            text(["report-bode-gain-margin", "report-bode-gain-unbounded"], self.gain_margin, Unit::Db),
            text(["report-bode-phase-margin", "report-bode-phase-unbounded"], self.phase_margin, Unit::Deg),
        ]
    }

    fn magnitudes(&self) -> Vec<Series> {
        let [gain, phase] = self.names();
        let (margin, at) = self.gain_margin;
        vec![
            Series::line(self.language.words("report-bode-open-loop"), self.lines.iter().map(|l| (l.0, l.1)).collect())
                .coloured(COLOURS[0]),
            Self::marker(gain, COLOURS[1], at, (-margin, 0.0)),
            // Named in both plots, drawn in the other plot.
            Self::marker(phase, COLOURS[2], f64::NAN, (0.0, 0.0)),
        ]
    }

    fn phases(&self) -> Vec<Series> {
        let [gain, phase] = self.names();
        let (margin, at) = self.phase_margin;
        // Phase of the curve there; the margin counts from -180 degrees, or from its equivalent whole turns away.
        let reached = self.lines.windows(2).find(|w| w[0].0 <= at && at <= w[1].0).map_or(f64::NAN, |w| {
            let part = (at / w[0].0).ln() / (w[1].0 / w[0].0).ln();
            w[0].2 + part * (w[1].2 - w[0].2)
        });
        let half_turn = 360.0 * ((reached + 180.0) / 360.0).round() - 180.0;
        let ends = if margin.is_finite() { (reached, half_turn) } else { (f64::NAN, f64::NAN) };
        vec![
            Series::line(self.language.words("report-bode-open-loop"), self.lines.iter().map(|l| (l.0, l.2)).collect())
                .coloured(COLOURS[0]),
            Self::marker(gain, COLOURS[1], f64::NAN, (0.0, 0.0)),
            Self::marker(phase, COLOURS[2], at, ends),
        ]
    }
}
