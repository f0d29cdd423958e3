//! Passes through points: the motion of the tip between them.

use crate::jobs::read;
use glam::DVec3;
use proptest::prelude::*;
use seamwright_program::TorchPath;

/// A program of one span through points, at a speed to each.
fn spline(along: &str, places: &[DVec3], speeds: &[f64]) -> String {
    let mut text = "schema = 1\ntitle = \"t\"\nmachine = \"m\"\n[[passes]]\nname = \"p\"\n[passes.points]\n".to_owned();
    let first = places[0];
    text += "columns = [\"x_mm\", \"y_mm\", \"z_mm\", \"ax\", \"ay\", \"az\", \"speed_mm_s\"]\n";
    text += &format!("start = [{}, {}, {}, 0, 0, -1, 0]\n[[passes.points.spans]]\n", first.x, first.y, first.z);
    text += &format!("along = \"{along}\"\npoints = [\n");
    for (p, v) in places[1..].iter().zip(speeds) {
        text += &format!("[{}, {}, {}, 0, 0, -1, {v}],\n", p.x, p.y, p.z);
    }
    text + "]\n"
}

/// The tip's way over a range of the path, by small chords.
fn way(path: &dyn TorchPath, from: f64, to: f64) -> f64 {
    const PARTS: usize = 400;
    let tip = |k: usize| path.pose(from + (to - from) * k as f64 / PARTS as f64).point;
    (0..PARTS).map(|k| tip(k).distance(tip(k + 1))).sum()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]
    /// From point to point of a spline the tip's mean speed is that of the point, within 0.1 %.
    #[test]
    fn a_spline_is_as_fast_as_asked(
        // It bends at each point, so none is left out of a taught run.
        steps in prop::collection::vec((10.0..30.0, any::<bool>(), 0.3..0.7, -0.4..0.4), 3..10),
        speeds in prop::collection::vec(4.0..10.0, 9),
        taught in any::<bool>(),
        one_speed in any::<bool>(),
    ) {
        let mut places = vec![DVec3::ZERO];
        let mut heading = 0.0f64;
        for (step, left, turn, climb) in &steps {
            heading += if *left { *turn } else { -turn };
            places.push(places[places.len() - 1] + *step * DVec3::new(heading.cos(), heading.sin(), *climb));
        }
        let speeds = if one_speed { vec![speeds[0]; 9] } else { speeds };
        let text = spline(if taught { "taught" } else { "spline" }, &places, &speeds);
        let welding = read(&text);
        let path = welding.path(0);
        let pace = welding.program.value.passes[0].speed_at(0.5 * path.length());
        let points = path.points().unwrap();
        for k in 0..steps.len() {
            let (from, to) = (points.reached(k).unwrap(), points.reached(k + 1).unwrap());
            prop_assert!(path.pose(to).point.distance(places[k + 1]) < 1e-9);
            let speed = way(&path, from, to) / (to - from) * pace;
            prop_assert!((speed / speeds[k] - 1.0).abs() < 1e-3, "{k}: {speed} for {}", speeds[k]);
        }
        if one_speed {
            let whole = way(&path, 0.0, path.length());
            prop_assert!((whole / path.length() - 1.0).abs() < 1e-3, "{whole} mm, {} by the path", path.length());
        }
    }
}
