//! Cost of a seam point by path length: position, tangent, both normals, bisector, dihedral angle. Aim: 100 ns.

use crate::measure::time;
use seamwright_weld::Welding;
use std::hint::black_box;

const EXAMPLES: [(&str, &str); 3] = [
    ("saddle", include_str!("../../../../examples/saddle.toml")),
    ("head nozzle", include_str!("../../../../examples/head-nozzle.toml")),
    ("ellipse", include_str!("../../../../examples/ellipse.toml")),
];

pub(crate) fn seam_point() {
    for (name, text) in EXAMPLES {
        let welding = Welding::read(name, text).unwrap();
        let places: Vec<f64> =
            (0..997).map(|i| (f64::from(i) * 0.618).fract() * welding.seam.as_ref().unwrap().length()).collect();
        let mut i = 0;
        time(&format!("seam point with frame, {name}"), || {
            i = (i + 1) % places.len();
            black_box(welding.seam.as_ref().unwrap().at(black_box(places[i])))
        });
    }
}
