use super::charts::{axis, line};
use crate::Phrases as _;
use crate::{Chart, Language, LimitLine, format_number};
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
    Some(Chart {
        language,
        title: language.fill("Woven path of the tip over the first {0} mm", &[&format_number(drawn, 3)]),
        x: axis(language, "along the seam", "mm"),
        y: axis(language, "across", "mm"),
        series: vec![line(language, "tip", (0..=places as u32).map(place).collect())],
        limits: [("first part", wide), ("second part", -wide)]
            .map(|(name, y)| LimitLine::new(language.say(name), y))
            .to_vec(),
        equal_aspect: true,
        ..Chart::default()
    })
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
    Some(Chart {
        language,
        title: language.fill(
            "Path of the beam on the work over {0} periods: {1} mm a period at {2} mm/s",
            &[&TURNS.to_string(), &format_number(oscillation.advance(speed), 4), &format_number(speed, 4)],
        ),
        x: axis(language, "along the seam", "mm"),
        y: axis(language, "across", "mm"),
        series: vec![line(language, "beam", (0..=places).map(place).collect())],
        equal_aspect: true,
        ..Chart::default()
    })
}
