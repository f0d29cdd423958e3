//! How fast a weave can be where the axes cannot keep the asked speed with it.

use seamwright_program::{Finding, Pass};

/// The highest frequency is found to this part.
const CLOSE: f64 = 0.01;
/// A weave is tried down to this part of what is asked.
const LEAST: f64 = 0.02;

/// Says in the findings of kind `speed` that the weave is too fast, and how fast it can be: `fits` plans the pass with a
/// weave so many times as fast and says whether the asked speed is kept. Where no slower weave helps the findings stay.
pub(crate) fn tell(findings: &mut [Finding], pass: &Pass, fits: impl Fn(f64) -> Option<bool>) {
    let Some(weave) = &pass.weave else { return };
    let mut too_fast: Vec<&mut Finding> = findings.iter_mut().filter(|f| f.kind == "speed" && !f.allowed).collect();
    if too_fast.is_empty() {
        return;
    }
    let Some(factor) = greatest(|factor| fits(factor) == Some(true)) else { return };
    let slower = weave.faster(factor);
    let (value, allowed) = match (slower.frequency_hz.map(f64::from), slower.pitch_mm.map(f64::from)) {
        (Some(frequency), _) => (
            format!("{frequency:.4} Hz"),
            format!("ask for a frequency_hz of {:.4} or a smaller width", (frequency * 1e4).floor() * 1e-4),
        ),
        (None, pitch) => {
            let pitch = pitch.unwrap_or_default();
            (
                format!("one in {pitch:.4} mm"),
                format!("ask for a pitch_mm of {:.4}, a smaller width or less speed", (pitch * 1e4).ceil() * 1e-4),
            )
        }
    };
    for f in &mut too_fast {
        f.message = format!(
            "the weave is too fast: {}; {} mm wide it can go at up to {value}",
            f.message,
            weave.width_mm.get()
        );
        f.cure = format!("{allowed}, or set weld.on_limit = \"slow\" to slow down there");
    }
}

/// The greatest factor below 1 that fits, to [`CLOSE`] and never above it, if any does: halved until one fits, then
/// bisected.
fn greatest(fits: impl Fn(f64) -> bool) -> Option<f64> {
    let (mut low, mut high) = (0.7, 1.0);
    while !fits(low) {
        (low, high) = (0.7 * low, low);
        if low < LEAST {
            return None;
        }
    }
    while high > low * (1.0 + CLOSE) {
        let middle = (low * high).sqrt();
        if fits(middle) { low = middle } else { high = middle }
    }
    Some(low)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_greatest_factor_is_found_from_below() {
        for i in 1..200 {
            let bound = f64::from(i) / 200.0;
            match greatest(|f| f <= bound) {
                Some(found) => assert!(found <= bound && found * (1.0 + CLOSE) >= bound, "{bound}: {found}"),
                None => assert!(bound < 0.03, "{bound}"),
            }
        }
    }
}
