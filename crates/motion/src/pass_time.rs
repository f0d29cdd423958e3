//! Times that no weld takes: what follows from them (set-points, blocks, rows) would not fit any memory or patience.

use seamwright_program::{Finding, Pass};

/// Longest time of a pass or of a part of its sequence, s: more than two days. A slip of the unit or an exponent.
pub(crate) const MAX_PASS_S: f64 = 2e5;

/// A finding for every time of `pass`, the `number`-th, that is longer than any weld's.
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
        message,
        pass: number,
        from_mm,
        to_mm,
        cure,
        allowed: false,
    };
    let long = |s: f64| s.is_nan() || s > MAX_PASS_S;
    let mut all: Vec<Finding> = times
        .into_iter()
        .filter(|(_, time, _)| long(*time))
        .map(|(key, time, s)| {
            let message = format!("{key} = {time} s: no pass may take longer than {MAX_PASS_S} s");
            finding((s, s), message, format!("set {key} to at most {MAX_PASS_S}"))
        })
        .collect();
    let travel = travel_s(pass);
    if long(travel) {
        let message =
            format!("at the asked speed the travel takes {travel:.3e} s: no pass may take longer than {MAX_PASS_S} s");
        let cure = "ask for a higher speed_mm_s, or divide the weld into several passes".to_owned();
        all.push(finding((0.0, pass.length()), message, cure));
    }
    all
}

/// Time of the travel at the asked speeds, s.
fn travel_s(pass: &Pass) -> f64 {
    let time = |span: &seamwright_program::Span| {
        let (from, to) = span.speed_mm_s.ends();
        let way = span.to_mm.get() - span.from_mm.get();
        // A speed that is linear in path length: the mean of its reciprocal is a logarithm.
        let change = to / from - 1.0;
        if change.abs() < 1e-6 { way / from } else { way * change.ln_1p() / (to - from) }
    };
    pass.spans.iter().map(time).sum()
}
