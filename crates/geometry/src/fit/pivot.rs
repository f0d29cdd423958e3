use super::twist::axes_first;
use crate::error::Error;
use glam::{DAffine3, DMat3, DVec3};
use nalgebra::{Matrix3, SymmetricEigen};

/// Minimum number of touches: two leave one direction undetermined.
const MIN_TOUCHES: usize = 3;

/// Maximum amplification of a touch's error in the tip. Two attitudes 20 degrees apart reach it.
const MAX_AMPLIFICATION: f64 = 4.0;

/// A point of a body, found by touching one fixed point from several attitudes.
#[derive(Debug, Clone, PartialEq)]
pub struct PivotFit {
    /// The point in the body's frame, mm; 0 along undetermined directions.
    pub tip: DVec3,
    /// The fixed point in the measuring frame, mm.
    pub point: DVec3,
    /// Distance of the body's point from the fixed one at each touch, mm.
    pub residuals: Vec<f64>,
    /// Undetermined directions of the point: perpendicular unit vectors in the body's frame.
    pub unseen: Vec<DVec3>,
    /// Standard deviation of `tip` along the frame's axes, estimated from the residuals, mm; undetermined directions
    /// are not included.
    pub deviation: DVec3,
    /// Largest angle between two attitudes, rad.
    pub apart: f64,
}

/// Finds a point of a body (the tip of a tool) in its frame, from poses with that point at one fixed point: `frame *
/// tip = point` for all of them, by least squares. It is linear in both; subtracting the means over all frames
/// eliminates the fixed point. The eigenvalues of the remaining matrix give the amplification of a touch's error.
///
/// # Errors
/// [`Error::TooFewPoints`] with fewer than three frames; [`Error::Alike`] if their attitudes are too similar.
pub fn pivot(frames: &[DAffine3]) -> Result<PivotFit, Error> {
    if frames.len() < MIN_TOUCHES {
        return Err(Error::TooFewPoints { what: "geometry-points-tip", given: frames.len(), min: MIN_TOUCHES });
    }
    let n = frames.len() as f64;
    let mean = frames.iter().fold(DMat3::ZERO, |sum, f| sum + f.matrix3) * (1.0 / n);
    let middle = frames.iter().map(|f| f.translation).sum::<DVec3>() / n;
    let (mut normal, mut right) = (DMat3::ZERO, DVec3::ZERO);
    for frame in frames {
        let turned = frame.matrix3 - mean;
        normal += turned.transpose() * turned;
        right -= turned.transpose() * (frame.translation - middle);
    }
    let eigen = SymmetricEigen::new(Matrix3::from_fn(|i, j| normal.col(j)[i]));
    let apart = most_apart(frames);
    let (mut tip, mut unseen, mut variance, mut seen) = (DVec3::ZERO, Vec::new(), DVec3::ZERO, 0);
    for (value, vector) in eigen.eigenvalues.iter().zip(eigen.eigenvectors.column_iter()) {
        let along = DVec3::new(vector[0], vector[1], vector[2]);
        if *value < 1.0 / (MAX_AMPLIFICATION * MAX_AMPLIFICATION) {
            unseen.push(along);
            continue;
        }
        seen += 1;
        tip += right.dot(along) / value * along;
        variance += along * along / *value;
    }
    if seen == 0 {
        return Err(Error::Alike { apart });
    }
    let at: Vec<DVec3> = frames.iter().map(|f| f.transform_point3(tip)).collect();
    let point = at.iter().sum::<DVec3>() / n;
    let residuals: Vec<f64> = at.iter().map(|p| p.distance(point)).collect();
    // Three equations per touch; unknowns are the point and the determined directions of the tip.
    let spare = (3 * frames.len() - 3 - seen) as f64;
    let squares: f64 = residuals.iter().map(|r| r * r).sum();
    let deviation = (variance * (squares / spare)).map(f64::sqrt);
    Ok(PivotFit { tip, point, residuals, unseen: axes_first(unseen), deviation, apart })
}

/// Largest angle between two attitudes, rad.
fn most_apart(frames: &[DAffine3]) -> f64 {
    let angle = |a: &DAffine3, b: &DAffine3| {
        let turn = a.matrix3.transpose() * b.matrix3;
        let trace = turn.x_axis.x + turn.y_axis.y + turn.z_axis.z;
        (0.5 * (trace - 1.0)).clamp(-1.0, 1.0).acos()
    };
    let pairs = frames.iter().enumerate().flat_map(|(i, a)| frames[..i].iter().map(move |b| angle(a, b)));
    pairs.fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DQuat;
    use seamwright_testkit::Random;

    /// Number of attitudes, maximum turn (rad) and standard deviation of each coordinate (mm).
    struct Attitudes {
        count: usize,
        max_turn: f64,
        sigma: f64,
    }

    /// Frames of a body with its point `tip` at `point`, turned about axes from `axis`.
    fn frames(
        attitudes: &Attitudes,
        tip: DVec3,
        point: DVec3,
        random: &mut Random,
        axis: impl Fn(DVec3) -> DVec3,
    ) -> Vec<DAffine3> {
        let &Attitudes { count, max_turn, sigma } = attitudes;
        let begin = DQuat::from_scaled_axis(random.vector(3.0));
        let one = |_| {
            let turn = DQuat::from_axis_angle(axis(random.vector(1.0)).normalize(), random.within(-max_turn, max_turn));
            let rotation = begin * turn;
            let off = sigma * DVec3::from_array([0; 3].map(|_| random.normal()));
            DAffine3::from_rotation_translation(rotation, point - rotation * tip + off)
        };
        (0..count).map(one).collect()
    }

    /// Without noise the tip is exact; with noise its error matches the deviation: the mean of (error / deviation)^2 is
    /// 1.
    #[test]
    fn the_tip_comes_out_as_well_as_it_says() {
        let (mut sum, mut count) = (0.0, 0.0);
        for seed in 0..500 {
            let mut random = Random::of_case(seed);
            let (tip, point) = (random.vector(100.0), random.vector(1000.0));
            let exactly = Attitudes { count: 6 + (seed as usize % 10), max_turn: 0.9, sigma: 0.0 };
            let exact = pivot(&frames(&exactly, tip, point, &mut random, |v| v)).unwrap();
            if exact.unseen.is_empty() {
                assert!(exact.tip.distance(tip) < 1e-8 && exact.point.distance(point) < 1e-8, "{seed}");
            }
            assert!(exact.residuals.iter().all(|r| *r < 1e-8) || !exact.unseen.is_empty(), "{seed}");
            let noisy = Attitudes { sigma: 0.1, ..exactly };
            let fit = pivot(&frames(&noisy, tip, point, &mut random, |v| v)).unwrap();
            if !fit.unseen.is_empty() {
                continue;
            }
            let off = (fit.tip - tip) / fit.deviation;
            sum += off.length_squared();
            count += 3.0;
            assert!(fit.tip.distance(tip) < 5.0 * MAX_AMPLIFICATION * 0.1, "{seed}: {fit:?}");
        }
        assert!(count > 3.0 * 450.0, "{count}");
        // The deviation is estimated from few residuals; heavy tails bring the mean a little above 1.
        let mean = sum / count;
        assert!((0.9..1.4).contains(&mean), "{mean}");
    }

    /// Turned about one axis only, the tip is found across the axis and stays 0 along it.
    #[test]
    fn what_attitudes_do_not_tell_stays() {
        for seed in 0..200 {
            let mut random = Random::of_case(seed);
            let axis = random.direction();
            let (tip, point) = (random.vector(100.0), random.vector(1000.0));
            let attitudes = Attitudes { count: 8, max_turn: 0.9, sigma: 0.0 };
            let fit = pivot(&frames(&attitudes, tip, point, &mut random, |_| axis)).unwrap();
            assert_eq!(fit.unseen.len(), 1, "{seed}");
            assert!(fit.unseen[0].dot(axis).abs() > 1.0 - 1e-9, "{seed}: {fit:?}");
            assert!(fit.tip.dot(axis).abs() < 1e-8, "{seed}");
            assert!(fit.tip.distance(tip - tip.dot(axis) * axis) < 1e-8, "{seed}: {fit:?}");
        }
    }

    #[test]
    fn attitudes_that_are_alike_or_few_are_refused() {
        let mut random = Random::new(7);
        let (tip, point) = (DVec3::new(1.0, 2.0, 3.0), DVec3::new(300.0, 0.0, 50.0));
        let alike = Attitudes { count: 10, max_turn: 0.05, sigma: 0.01 };
        let alike = pivot(&frames(&alike, tip, point, &mut random, |v| v)).unwrap_err();
        let Error::Alike { apart } = alike else { panic!("{alike}") };
        assert!(apart > 0.01 && apart <= 0.1, "{apart}");
        let few = Attitudes { count: 2, max_turn: 1.0, sigma: 0.0 };
        let few = pivot(&frames(&few, tip, point, &mut random, |v| v));
        assert!(matches!(few, Err(Error::TooFewPoints { given: 2, min: 3, .. })));
    }
}
