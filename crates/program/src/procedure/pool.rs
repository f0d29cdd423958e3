//! Weld pool against gravity: how much metal surface tension holds, and how a bead sags.
//!
//! **Model.** A liquid ridge along the seam, held at its toes. Its measure is the capillary length
//! `sqrt(gamma / (rho g))` of liquid steel: 4.2 mm for 1.2 N/m and 7,000 kg/m^3 (values of liquid iron with the oxygen
//! and sulphur of usual steels: Keene, International Materials Reviews 33 (1988) 1-37; Mills and Su, ibid. 51 (2006)
//! 329-351). Per mm of seam:
//! - *overhead*, the weight hangs on both toes: `A <= 2 l^2 sin(theta)`, with 45 degrees at the toes, as of a flat fillet;
//! - *across the seam*, the weight is held by the difference of the contact angles below and above (Furmidge, Journal of
//!   Colloid Science 17 (1962) 309-324): `A <= l^2 (cos(0) - cos(90))`, as the upper toe freezes and the lower one must
//!   not roll over;
//! - *downhill*, the pool runs ahead of the arc: the same along the seam, for a pool twice as long as it is wide.
//!
//! Uphill the frozen metal below carries the pool: no limit of area. Between a level weld (up to [`LEVEL`]) and a steep one
//! (from [`STEEP`]) the share of gravity that counts across and along the seam changes linearly with the slope. Where the
//! face hangs over, gravity across the seam counts at every slope. These limits are 24.7 mm^2 in PB, PD and PE. AWS D1.1
//! permits prequalified one-pass fillets of 8 mm leg (32 mm^2) in horizontal and overhead position, as a part of the bead
//! is frozen while the rest is liquid. So all limits are taken 1.3 times as large ([`FROZEN`]): 32 mm^2 in PB, PD and PE,
//! 23 mm^2 in PC, 11 mm^2 in PG (3.4 mm throat).
//!
//! **Sag.** The surface of a ridge of width `w` on a plane obeys `y'' = -p - x g_t / l^2` for small slopes, where `g_t` is
//! the part of gravity across the seam. So the slope at the lower toe grows by `w^2 g_t / (12 l^2)` and that at the
//! upper one falls by as much; the area stays.
//!
//! **Where it fails.** Arc pressure, flow and the time to freeze are not in the model: pulsed or short arcs and fast
//! freezing slag (rutile cored wire) hold more metal, hot pools of thick spray arcs less. A weave lets the metal freeze
//! in portions: its beads are not limited here. Slopes above 45 degrees are beyond the linear theory. Other metals have
//! other lengths: 6 mm for aluminium.

use super::position::Inclination;
use std::f64::consts::{FRAC_PI_4, PI};

/// Surface tension of liquid steel, N/m.
const SURFACE_TENSION_N_M: f64 = 1.2;
/// Density of liquid steel, kg/m^3.
const DENSITY_KG_M3: f64 = 7000.0;
/// Acceleration of gravity, m/s^2.
const GRAVITY_M_S2: f64 = 9.81;
/// Area of a bead as a multiple of that of its liquid part, from the fillets of AWS D1.1. Trust: remembered, to be read again
/// in the edition in force.
const FROZEN: f64 = 1.3;
/// Length of the pool as a multiple of its width.
const POOL_LENGTH: f64 = 2.0;
/// Slope in the direction of travel up to which a weld counts as level, rad: that of PA to PC in ISO 6947.
const LEVEL: f64 = 15.0 * PI / 180.0;
/// Slope from which the frozen metal below carries the pool, rad: half way to the vertical. An assumption between two known
/// ends, level and vertical, without data of its own.
const STEEP: f64 = 45.0 * PI / 180.0;

/// Square of the capillary length of liquid steel, mm^2.
fn capillary_mm2() -> f64 {
    1e6 * SURFACE_TENSION_N_M / (DENSITY_KG_M3 * GRAVITY_M_S2)
}

impl Inclination {
    /// The part of gravity across the seam, 0 to 1.
    pub fn gravity_across(&self) -> f64 {
        self.rotation.sin() * self.slope.cos()
    }

    /// Maximum area of an unwoven bead that surface tension holds in this position, mm^2; infinite in flat position
    /// and uphill. A bead that is `enclosed` by both walls of a groove cannot sag across the seam.
    pub fn max_pool_mm2(&self, enclosed: bool) -> f64 {
        let (across, outward) = (self.gravity_across(), -self.rotation.cos() * self.slope.cos());
        let steep = ((self.slope.abs() - LEVEL) / (STEEP - LEVEL)).clamp(0.0, 1.0);
        let downhill = steep * (-self.slope.sin()).max(0.0);
        let hanging = if outward > 0.0 { (outward / across.max(f64::MIN_POSITIVE)).min(1.0) } else { 0.0 };
        let limit =
            |part: f64, held: f64| if part > 0.0 { held * FROZEN * capillary_mm2() / part } else { f64::INFINITY };
        let sideways = if enclosed { f64::INFINITY } else { limit(across * (1.0 - steep).max(hanging), 1.0) };
        sideways.min(limit(outward, 2.0 * FRAC_PI_4.sin())).min(limit(downhill, 1.0 / POOL_LENGTH))
    }

    /// Change of the slope (tangent) at the toes of a bead of `width` mm: more at the lower toe, less at the upper one.
    pub fn sag(&self, width: f64) -> f64 {
        width * width * self.gravity_across() / (12.0 * capillary_mm2())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(slope: f64, rotation: f64) -> Inclination {
        Inclination { slope: f64::to_radians(slope), rotation: f64::to_radians(rotation) }
    }

    #[test]
    fn positions_hold_what_the_front_page_says() {
        assert!((capillary_mm2().sqrt() - 4.18).abs() < 0.01);
        let limit = |slope, rotation| at(slope, rotation).max_pool_mm2(false);
        assert!(limit(0.0, 0.0).is_infinite() && limit(90.0, 0.0).is_infinite() && limit(45.0, 60.0).is_infinite());
        for (slope, rotation, expected) in
            [(0.0, 45.0, 32.1), (0.0, 90.0, 22.7), (0.0, 135.0, 32.1), (0.0, 180.0, 32.1), (-90.0, 0.0, 11.4)]
        {
            assert!((limit(slope, rotation) - expected).abs() < 0.06, "{slope} {rotation}: {}", limit(slope, rotation));
        }
        // Walls carry the metal across, not overhead.
        assert!(at(0.0, 90.0).max_pool_mm2(true).is_infinite());
        assert!((at(0.0, 180.0).max_pool_mm2(true) - 32.1).abs() < 0.1);
    }

    /// The surface tension that a pool needs, the inverse of the limit, has no jump: at most 1 % of the strictest limit
    /// by 0.1 degrees.
    #[test]
    fn limits_change_evenly_with_the_position() {
        let need = |slope, rotation, enclosed| 1.0 / at(slope, rotation).max_pool_mm2(enclosed);
        let steps = |from: i32, to: i32| (10 * from..10 * to).map(|i| 0.1 * f64::from(i));
        for enclosed in [false, true] {
            for (slope, rotation) in
                steps(-90, 90).step_by(7).flat_map(|s| steps(0, 180).step_by(3).map(move |r| (s, r)))
            {
                let here = need(slope, rotation, enclosed);
                let beside = [need(slope + 0.1, rotation, enclosed), need(slope, rotation + 0.1, enclosed)];
                assert!(beside.iter().all(|n| (n - here).abs() < 0.01 / 11.4), "{slope} {rotation}: {here} {beside:?}");
            }
        }
    }

    /// The closed form of the sag against the equation of the surface, integrated numerically.
    #[test]
    fn a_bead_on_a_slope_is_steeper_below() {
        let (width, slope, at) = (9.0, 0.8, at(0.0, 90.0));
        let (n, l2) = (20_000, capillary_mm2());
        let h = width / f64::from(n);
        let x = |i: i32| -0.5 * width + h * f64::from(i);
        // y'' = -p - x / l^2 with y = 0 at both ends: the curvature p is that of the parabola of this slope.
        let p = 2.0 * slope / width;
        let second = |i: i32| -p - x(i) / l2;
        let shoot = |start: f64| {
            (0..n).fold((0.0, start), |(y, d), i| {
                let middle = 0.5 * (second(i) + second(i + 1));
                (y + h * d + 0.5 * h * h * middle, d + h * middle)
            })
        };
        // The end's height is linear in the start's slope.
        let (zero, one) = (shoot(0.0).0, shoot(1.0).0);
        let start = -zero / (one - zero);
        let end = shoot(start).1;
        assert!((start - (slope - at.sag(width))).abs() < 1e-4, "{start}");
        assert!((-end - (slope + at.sag(width))).abs() < 1e-4, "{end}");
        assert!(at.sag(width) > 0.3);
    }
}
