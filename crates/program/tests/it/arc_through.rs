//! Arcs and helices through three places.

use glam::DVec3;
use proptest::prelude::*;
use seamwright_program::{ArcThrough, tip_way};

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]
    #[test]
    fn three_places_of_a_helix_give_it_back(
        centre in prop::array::uniform3(-500.0..500.0), axis in prop::array::uniform3(-1.0..1.0),
        out in prop::array::uniform3(-100.0..100.0), sweep in 0.01..6.2, rise in -50.0..50.0,
    ) {
        let axis = DVec3::from(axis).try_normalize().unwrap_or(DVec3::Z);
        let out = DVec3::from(out).reject_from_normalized(axis);
        prop_assume!(out.length() > 1.0);
        let helix = ArcThrough { centre: DVec3::from(centre), axis, out, sweep, rise };
        let again = ArcThrough::new(helix.at(0.0), helix.at(0.5), helix.at(1.0), Some(axis)).unwrap();
        for k in 0..=20 {
            let f = f64::from(k) / 20.0;
            prop_assert!(helix.at(f).distance(again.at(f)) < 1e-6, "{}", helix.at(f).distance(again.at(f)));
        }
        let length = (sweep * out.length()).hypot(rise);
        prop_assert!((tip_way(|f| helix.at(f)) - length).abs() < 1e-3 * length);
    }
}
