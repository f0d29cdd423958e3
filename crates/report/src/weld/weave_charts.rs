use crate::number::Significant as _;
use crate::{Axis, Chart, Language, LimitLine, Series, Words as _};
use seamwright_message::{Message, Unit};
use seamwright_program::Pass;
use seamwright_weld::PassPath;

/// Number of drawn weave periods, minimum and maximum drawn length (mm), and number of points per period.
const PERIODS: f64 = 6.0;
const DRAWN_MM: (f64, f64) = (20.0, 60.0);
const PLACES: f64 = 96.0;

/// Number of drawn oscillation periods.
const TURNS: u32 = 5;

/// Draws the woven path of the first centimetres of a pass, seen along the torch with the seam laid straight. Both
/// scales are equal; `None` without a weave.
pub(super) fn weave(pass: &Pass, path: &PassPath, language: Language) -> Option<Chart> {
    let (weave, weaving) = (pass.weave.as_ref()?, path.weaving.as_ref()?);
    let length = pass.length();
    let start = 1e-3 * length;
    let pitch = start / weaving.phase(start);
    let drawn = (weave.fade_mm.get() + PERIODS * pitch).clamp(DRAWN_MM.0, DRAWN_MM.1).min(length);
    let places = (PLACES * weaving.phase(drawn)).ceil().max(PLACES);
    let place = |i: u32| {
        let s = drawn * f64::from(i) / places;
        let (across, along) = path.woven(s).unwrap_or_default();
        (s + along, across)
    };
    let (wide, _) = weave.reach();
    let title = Message::new("report-chart-weave").significant("length", drawn, Unit::Mm, 3);
    let points = (0..=places as u32).map(place).collect();
    let limits = [("report-first-part", wide), ("report-second-part", -wide)];
    Some(Chart {
        limits: limits.map(|(name, y)| LimitLine::new(language.words(name), y)).to_vec(),
        ..flat(&title, Series::named(language, "report-curve-tip", points), language)
    })
}

/// Plots a path across and along the seam, at equal scales.
fn flat(title: &Message, path: Series, language: Language) -> Chart {
    Chart {
        language,
        title: title.in_language(language),
        x: Axis::of(language, "report-label-along-seam", Unit::Mm),
        y: Axis::of(language, "report-label-across", Unit::Mm),
        series: vec![path],
        equal_aspect: true,
        ..Chart::default()
    }
}

/// Draws the beam's path on the work over several periods at the pass' first speed, at equal scales; `None` without an
/// oscillation.
pub(super) fn oscillation(pass: &Pass, language: Language) -> Option<Chart> {
    let oscillation = pass.oscillation.as_ref()?;
    let speed = pass.speed_at(0.0);
    let places = TURNS * 128;
    let place = |i: u32| {
        let (across, along) = oscillation.on_work(f64::from(TURNS) * f64::from(i) / f64::from(places), speed);
        (along, across)
    };
    let title = Message::new("report-chart-oscillation")
        .count("n", TURNS as usize)
        .significant("advance", oscillation.advance(speed), Unit::Mm, 4)
        .significant("speed", speed, Unit::MmPerS, 4);
    Some(flat(&title, Series::named(language, "report-curve-beam", (0..=places).map(place).collect()), language))
}
