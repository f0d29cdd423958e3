use glam::{DQuat, DVec3};
use seamwright_geometry::Pose;

/// Number of directions from which the reference is chosen.
const CANDIDATES: u32 = 200;

/// Reference of the rotation about a torch along a path: a direction across the torch for every torch direction, as
/// smooth as the torch directions are.
///
/// The shortest rotation from one fixed direction carries the reference along. It exists for every torch direction but the
/// opposite one, so that the fixed direction is chosen as far as possible from the opposites of all.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RollReference {
    from: DVec3,
    across: DVec3,
}

impl RollReference {
    /// The reference for torches in `poses`.
    pub fn new(poses: &[Pose]) -> Self {
        // The golden angle spreads any number of directions evenly over the sphere.
        let candidate = |k: u32| {
            let z = 1.0 - (2.0 * f64::from(k) + 1.0) / f64::from(CANDIDATES);
            let (sin, cos) = (2.399_963_229_728_653 * f64::from(k)).sin_cos();
            DVec3::new((1.0 - z * z).sqrt() * cos, (1.0 - z * z).sqrt() * sin, z)
        };
        let room = |from: &DVec3| poses.iter().map(|p| from.dot(p.direction)).fold(1.0, f64::min);
        let best = (0..CANDIDATES).map(candidate).max_by(|a, b| room(a).total_cmp(&room(b)));
        let from = best.unwrap_or(DVec3::Z);
        Self { from, across: from.any_orthonormal_vector() }
    }

    /// The direction across a torch of `direction` that is turned about it by `roll`, rad.
    pub fn across(&self, direction: DVec3, roll: f64) -> DVec3 {
        let across = carried(self.from, direction, self.across);
        let (sin, cos) = roll.sin_cos();
        cos * across + sin * direction.cross(across)
    }

    /// The rotation about the torch of `direction` at which `across` lies across it, rad.
    pub fn roll(&self, direction: DVec3, across: DVec3) -> f64 {
        let zero = carried(self.from, direction, self.across);
        direction.cross(zero).dot(across).atan2(zero.dot(across))
    }
}

/// `v` turned by the shortest rotation that carries the unit vector `from` to `to`.
pub(crate) fn carried(from: DVec3, to: DVec3, v: DVec3) -> DVec3 {
    let (across, cosine) = (from.cross(to), from.dot(to));
    if cosine < -1.0 + 1e-12 {
        // Every half turn across is the shortest.
        return DQuat::from_axis_angle(from.any_orthonormal_vector(), std::f64::consts::PI) * v;
    }
    cosine * v + across.cross(v) + across.dot(v) / (1.0 + cosine) * across
}

#[cfg(test)]
mod tests {
    use super::*;
    use seamwright_testkit::Random;

    fn unit(random: &mut Random) -> DVec3 {
        random.vector(1.0).normalize()
    }

    #[test]
    fn the_shortest_rotation_is_that_of_quaternions() {
        let mut random = Random::new(1);
        for _ in 0..1000 {
            let [a, b, v] = [(); 3].map(|()| unit(&mut random));
            assert!((carried(a, b, v) - DQuat::from_rotation_arc(a, b) * v).length() < 1e-9);
            assert!((carried(a, b, a) - b).length() < 1e-9);
        }
        assert!((carried(DVec3::Z, -DVec3::Z, DVec3::Z) + DVec3::Z).length() < 1e-12);
    }

    #[test]
    fn a_roll_comes_back_and_a_ring_of_torches_is_far_from_the_opposite() {
        let mut random = Random::new(2);
        let ring: Vec<Pose> = (0..360)
            .map(|k| f64::from(k).to_radians().sin_cos())
            .map(|(sin, cos)| Pose { point: DVec3::ZERO, direction: DVec3::new(cos, 0.0, sin) })
            .collect();
        let reference = RollReference::new(&ring);
        assert!(ring.iter().all(|p| p.direction.dot(reference.from) > -0.2));
        for _ in 0..1000 {
            let (direction, roll) = (unit(&mut random), random.within(-3.1, 3.1));
            let across = reference.across(direction, roll);
            assert!(across.dot(direction).abs() < 1e-9 && (across.length() - 1.0).abs() < 1e-9);
            assert!((reference.roll(direction, across) - roll).abs() < 1e-8);
        }
    }
}
