//! Limits of the time of a pass: set-points, blocks and rows of longer ones would exceed memory and acceptable run
//! time.

use crate::SpeedLaw;
use seamwright_program::{Finding, Pass};

/// Maximum time of a pass or of a part of its sequence, s: more than two days. Longer times come from a wrong unit or
/// exponent.
pub(crate) const MAX_PASS_S: f64 = 2e5;

/// Reports every time of `pass`, the `number`-th, above [`MAX_PASS_S`].
pub(crate) fn too_long(pass: &Pass, number: usize) -> Vec<Finding> {
    let sequence = &pass.sequence;
    let times = [
        ("sequence.preflow_s", sequence.preflow_s.get(), 0.0),
        ("sequence.travel_delay_s", sequence.travel_delay_s.get(), 0.0),
        ("sequence.crater_s", sequence.crater_s.get(), pass.length()),
        ("sequence.postflow_s", sequence.postflow_s.get(), pass.length()),
    ];
    let finding = |(from_mm, to_mm): (f64, f64), message: String, cure: String| Finding {
        kind: "time",
        message: message.into(),
        pass: number,
        from_mm,
        to_mm,
        cure: Some(cure.into()),
        allowed: false,
    };
    let mut all: Vec<Finding> = times
        .into_iter()
        .filter(|(_, time, _)| is_too_long(*time))
        .map(|(key, time, s)| {
            let message = format!("{key} = {time} s: no pass may take longer than {MAX_PASS_S} s");
            finding((s, s), message, format!("set {key} to at most {MAX_PASS_S}"))
        })
        .collect();
    let travel = pass.travel_s();
    if is_too_long(travel) {
        let message =
            format!("at the asked speed the travel takes {travel:.3e} s: no pass may take longer than {MAX_PASS_S} s");
        let cure = "ask for a higher speed_mm_s, or divide the weld into several passes".to_owned();
        all.push(finding((0.0, pass.length()), message, cure));
    }
    all
}

/// Reports a travel of a pass, `length` mm long, that takes more than [`MAX_PASS_S`] within the limits of the axes.
pub(crate) fn travels_too_long(law: &SpeedLaw, length: f64, pass: usize) -> Option<Finding> {
    let travel = law.duration();
    is_too_long(travel).then(|| Finding {
        kind: "time",
        message: format!(
            "with the limits of the axes the travel takes {travel:.3e} s: no pass may take longer than {MAX_PASS_S} s"
        )
        .into(),
        pass,
        from_mm: 0.0,
        to_mm: length,
        cure: Some(
            "give the machine's axes higher speeds and accelerations, or divide the weld into several passes".into(),
        ),
        allowed: false,
    })
}

fn is_too_long(s: f64) -> bool {
    s.is_nan() || s > MAX_PASS_S
}
