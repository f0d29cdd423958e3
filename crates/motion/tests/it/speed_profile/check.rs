//! Check of a speed profile's guarantees, independent of its computation.

use seamwright_motion::speed_profile::{Channels, ProfilePoint, SpeedProfile};

#[derive(Debug, Clone, Copy, Default)]
pub struct Found {
    /// Maximum use of speeds, accelerations and jerks, and maximum ratio of the tip's speed to the requested one.
    pub used: [f64; 4],
    /// Maximum jump of parameter, speed and acceleration between cells, each relative to its tolerance.
    pub jump: [f64; 3],
    /// Cell, part of it, channel, and limit (0 to 3) with the maximum use.
    pub at: (usize, f64, usize, usize),
}

/// Speed, acceleration and jerk of a channel with these derivatives by the parameter.
fn motion([q1, q2, q3]: [f64; 3], p: ProfilePoint) -> [f64; 3] {
    [q1 * p.v, q2 * p.v * p.v + q1 * p.a, q3 * p.v.powi(3) + 3.0 * q2 * p.v * p.a + q1 * p.j]
}

/// `s` so little nearer to `middle` that rounding does not bring it into the next piece of the path.
fn inside(s: f64, middle: f64) -> f64 {
    s + (middle - s) * 1e-9 + (middle - s).signum() * (4.0 * f64::EPSILON * s.abs()).min((middle - s).abs())
}

/// Checks `profile` along `path` at `parts + 1` samples in every cell.
pub fn check(path: &dyn Channels, profile: &SpeedProfile, parts: u32) -> Found {
    let limits = path.limits();
    let mut found = Found::default();
    let (mut d, mut d_before) = (vec![[0.0; 3]; limits.len()], vec![[0.0; 3]; limits.len()]);
    for cell in 0..profile.cells() {
        let middle = profile.in_cell(cell, 0.5).s;
        for part in 0..=parts {
            let part = f64::from(part) / f64::from(parts);
            let p = profile.in_cell(cell, part);
            let tip = path.derivatives(inside(p.s, middle), part > 0.5, &mut d);
            for (channel, (d, l)) in d.iter().zip(limits).enumerate() {
                let [v, a, j] = motion(*d, p);
                for (k, used) in [v / l.speed, a / l.acceleration, j / l.jerk].into_iter().enumerate() {
                    if used.abs() > found.used.iter().copied().fold(0.0, f64::max) {
                        found.at = (cell, part, channel, k);
                    }
                    found.used[k] = found.used[k].max(used.abs());
                }
            }
            let asked = tip * p.v / path.asked(middle);
            found.used[3] = found.used[3].max(asked);
            assert!(p.v >= 0.0 && (p.s + p.v + p.a + p.j).is_finite(), "cell {cell} at {part}: {p:?}");
        }
        if cell > 0 {
            let (a, b) = (profile.in_cell(cell - 1, 1.0), profile.in_cell(cell, 0.0));
            path.derivatives(a.s, true, &mut d_before);
            path.derivatives(b.s, false, &mut d);
            let (from, to) = path.range();
            found.jump[0] = found.jump[0].max((a.s - b.s).abs() / (to - from));
            for ((da, db), l) in d_before.iter().zip(&d).zip(limits) {
                let (a, b) = (motion(*da, a), motion(*db, b));
                found.jump[1] = found.jump[1].max((a[0] - b[0]).abs() / l.speed);
                found.jump[2] = found.jump[2].max((a[1] - b[1]).abs() / l.acceleration);
            }
        }
    }
    found
}

/// Ends reached at rest, and times, parameters and speeds that agree with each other.
pub fn check_ends(path: &dyn Channels, profile: &SpeedProfile) {
    let (from, to) = path.range();
    let duration = profile.duration();
    assert!(duration > 0.0 && duration.is_finite(), "duration {duration}");
    let (mut cursor, length) = (0, to - from);
    let (begin, end) = (profile.at(0.0, &mut cursor), profile.at(duration, &mut cursor));
    assert!((begin.s - from).abs() <= 1e-12 * length && begin.v == 0.0, "{begin:?}");
    assert_eq!((end.s, end.v, end.a), (to, 0.0, 0.0));
    // Just before its end it is very near the end.
    let last = profile.in_cell(profile.cells() - 1, 1.0);
    assert!((last.s - to).abs() <= 1e-9 * length && last.v * duration <= 1e-6 * length, "{last:?}");
    let mut before = from;
    for i in 1..20 {
        let t = duration * f64::from(i) / 20.0;
        let p = profile.at(t, &mut cursor);
        assert!(p.s >= before - 1e-12 * length, "backward at {t}");
        before = p.s;
        // At very low speed a position does not determine the time well.
        if p.v * duration > 1e-3 * length {
            assert!(
                (profile.time(p.s) - t).abs() <= 1e-9 * duration,
                "time {} of {t}, duration {duration}",
                profile.time(p.s)
            );
            assert!((profile.speed(p.s) - p.v).abs() <= 1e-8 * p.v, "speed {} of {}", profile.speed(p.s), p.v);
        }
    }
}
