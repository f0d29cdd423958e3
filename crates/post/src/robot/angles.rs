//! Orientations as the controls write them.
//!
//! | control | form |
//! |---|---|
//! | ABB | unit quaternion q1 q2 q3 q4, the scalar part first |
//! | KUKA | A B C: about z, then about the new y, then about the new x (Z-Y'-X'') |
//! | FANUC | W P R: about the fixed x, y and z, in this order |
//! | Yaskawa | Rx Ry Rz: about the fixed x, y and z, in this order |
//! | Universal Robots | rotation vector: unit axis times angle in rad |
//!
//! Z-Y'-X'' and fixed X-Y-Z are the same rotation with the angles in opposite order: `Rz(a) Ry(b) Rx(c)`.

use glam::{DMat3, DQuat, DVec3};
use std::f64::consts::PI;

/// Cosine of the angle about y below which the axes of the other two coincide.
const ALIGNED: f64 = 1e-9;

/// Angles about z, y and x (rad) with `turn = Rz(z) Ry(y) Rx(x)`; y within a quarter turn. Where the axes of z and x
/// coincide, x is 0.
pub fn euler_zyx(turn: DQuat) -> [f64; 3] {
    let m = DMat3::from_quat(turn);
    let (x, y, z) = (m.x_axis, m.y_axis, m.z_axis);
    let cos_y = x.x.hypot(x.y);
    let about_y = (-x.z).atan2(cos_y);
    if cos_y < ALIGNED {
        return [(-y.x).atan2(y.y), about_y, 0.0];
    }
    [x.y.atan2(x.x), about_y, y.z.atan2(z.z)]
}

/// The rotation `Rz(z) Ry(y) Rx(x)` of angles in rad.
pub fn from_euler_zyx([z, y, x]: [f64; 3]) -> DQuat {
    DQuat::from_rotation_z(z) * DQuat::from_rotation_y(y) * DQuat::from_rotation_x(x)
}

/// Axis times angle (rad), at most half a turn.
pub fn rotation_vector(turn: DQuat) -> DVec3 {
    let turn = if turn.w < 0.0 { -turn } else { turn };
    let sine = turn.xyz().length();
    if sine < 1e-300 {
        return DVec3::ZERO;
    }
    let angle = 2.0 * sine.atan2(turn.w);
    turn.xyz() * (angle.min(PI) / sine)
}

/// The rotation about the direction of `vector` by its length, rad.
pub fn from_rotation_vector(vector: DVec3) -> DQuat {
    DQuat::from_scaled_axis(vector)
}

#[cfg(test)]
mod tests {
    use super::*;
    use seamwright_testkit::{Random, cases};
    use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2};

    fn random_turn(random: &mut Random) -> DQuat {
        let axis = random.vector(1.0).normalize();
        DQuat::from_axis_angle(axis, random.within(-PI, PI))
    }

    fn is_same(a: DQuat, b: DQuat) -> bool {
        1.0 - a.dot(b).abs() < 1e-12
    }

    /// Matrices multiplied out by hand: a quarter turn about z takes x to y; the rows of `Rz Ry Rx` in closed form.
    #[test]
    fn angles_are_those_of_the_closed_form() {
        let mut random = Random::new(31);
        for _ in 0..cases(2000) {
            let [a, b, c] = [(); 3].map(|()| random.within(-1.5, 1.5));
            let ((sa, ca), (sb, cb), (sc, cc)) = (a.sin_cos(), b.sin_cos(), c.sin_cos());
            let x = DVec3::new(ca * cb, sa * cb, -sb);
            let y = DVec3::new(ca * sb * sc - sa * cc, sa * sb * sc + ca * cc, cb * sc);
            let z = DVec3::new(ca * sb * cc + sa * sc, sa * sb * cc - ca * sc, cb * cc);
            let turn = from_euler_zyx([a, b, c]);
            for (unit, column) in [(DVec3::X, x), (DVec3::Y, y), (DVec3::Z, z)] {
                assert!((turn * unit - column).length() < 1e-14);
            }
            let back = euler_zyx(turn);
            assert!(back.iter().zip([a, b, c]).all(|(u, v)| (u - v).abs() < 1e-9), "{back:?}");
        }
        // KUKA: A 90 alone turns about z. FANUC: W 90 alone turns about x.
        assert!((from_euler_zyx([FRAC_PI_2, 0.0, 0.0]) * DVec3::X - DVec3::Y).length() < 1e-15);
        assert!((from_euler_zyx([0.0, 0.0, FRAC_PI_2]) * DVec3::Y - DVec3::Z).length() < 1e-15);
        // KUKA: B turns about the y axis that A has turned.
        let both = from_euler_zyx([FRAC_PI_2, FRAC_PI_2, 0.0]);
        assert!((both * DVec3::X + DVec3::Z).length() < 1e-15);
        assert!((both * DVec3::Z - DVec3::Y).length() < 1e-15);
    }

    #[test]
    fn angles_come_back_where_axes_coincide() {
        let mut random = Random::new(32);
        for _ in 0..cases(500) {
            let (z, x) = (random.within(-PI, PI), random.within(-PI, PI));
            for y in [FRAC_PI_2, -FRAC_PI_2] {
                let turn = from_euler_zyx([z, y, x]);
                assert!(is_same(from_euler_zyx(euler_zyx(turn)), turn));
            }
        }
    }

    #[test]
    fn orientations_come_back() {
        let mut random = Random::new(33);
        for _ in 0..cases(5000) {
            let turn = random_turn(&mut random);
            assert!(is_same(from_euler_zyx(euler_zyx(turn)), turn));
            assert!(is_same(from_rotation_vector(rotation_vector(turn)), turn));
            let vector = random.vector(1.0).normalize() * random.within(0.01, 3.1);
            assert!((rotation_vector(from_rotation_vector(vector)) - vector).length() < 1e-12);
        }
        assert_eq!(rotation_vector(DQuat::IDENTITY), DVec3::ZERO);
    }

    /// ABB: q1 is the cosine of half the angle. A quarter turn about x is [0.7071, 0.7071, 0, 0].
    #[test]
    fn quaternions_have_the_scalar_first_on_abb() {
        let turn = DQuat::from_rotation_x(FRAC_PI_2);
        assert!((turn.w - FRAC_1_SQRT_2).abs() < 1e-15 && (turn.x - FRAC_1_SQRT_2).abs() < 1e-15);
    }
}
