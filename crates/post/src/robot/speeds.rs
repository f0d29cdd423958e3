//! Speeds of lines in the steps that a language has, so that the pass takes the planned time.

/// Part of the time of a pass by which lines may run ahead or behind before their speed changes.
const TIME_PART: f64 = 0.000_3;
/// Maximum lead or lag that this may make, mm.
const LAG_MM: f64 = 0.2;

/// A line's length and the time at which it ends.
#[derive(Debug, Clone, Copy)]
pub(super) struct Timed {
    pub(super) length_mm: f64,
    pub(super) end_s: f64,
}

/// Speeds of `lines`, multiples of `step_mm_s`. The speed of a line is kept for the next one while the time stays near
/// the planned one and the speed within `max_deviation` of it.
pub(super) fn speeds(lines: &[Timed], step_mm_s: f64, max_deviation: f64) -> Vec<f64> {
    let total = lines.last().map_or(0.0, |line| line.end_s);
    let (mut played, mut planned, mut last) = (0.0, 0.0, 0.0);
    let mut all = Vec::with_capacity(lines.len());
    for line in lines {
        let mean = line.length_mm / (line.end_s - planned);
        let late = |speed: f64| played + line.length_mm / speed - line.end_s;
        let allowed = (TIME_PART * total).min(LAG_MM / mean);
        let near = max_deviation.max(step_mm_s / mean);
        let keeps = last > 0.0 && late(last).abs() <= allowed && (last / mean - 1.0).abs() <= near;
        if !keeps {
            let [below, above] = stepped(mean, step_mm_s);
            last = if late(below).abs() < late(above).abs() { below } else { above };
        }
        played += line.length_mm / last;
        planned = line.end_s;
        all.push(last);
    }
    all
}

/// The multiples of `step` below and above, at least one.
fn stepped(speed: f64, step: f64) -> [f64; 2] {
    // A quotient of whole numbers is the decimal that is written.
    let per_unit = (1.0 / step).round();
    let steps = speed * per_unit;
    let [below, above] = match (steps - steps.round()).abs() < 1e-3 {
        true => [steps.round(); 2],
        false => [steps.floor(), steps.ceil()],
    };
    [below, above].map(|steps| steps.max(1.0) / per_unit)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_time_is_kept_with_few_changes() {
        for (speed, step) in [(6.0, 0.01), (6.35, 0.1), (4.2333, 0.1), (11.987, 0.01), (0.4, 0.01)] {
            let lines: Vec<Timed> =
                (1..=200).map(|k| Timed { length_mm: 2.0, end_s: f64::from(k) * 2.0 / speed }).collect();
            let all = speeds(&lines, step, 0.05);
            let time: f64 = all.iter().map(|v| 2.0 / v).sum();
            assert!((time * speed / 400.0 - 1.0).abs() < 5e-4, "{speed}: {time}");
            assert!(all.iter().all(|v| (v / speed - 1.0).abs() < 0.05 && (v / step - (v / step).round()).abs() < 1e-6));
        }
        let even: Vec<Timed> = (1..=50).map(|k| Timed { length_mm: 3.0, end_s: 0.5 * f64::from(k) }).collect();
        assert!(speeds(&even, 0.1, 0.01).iter().all(|v| (v - 6.0).abs() < 1e-12));
    }
}
