//! Pose of a part from touched points: a plane with two marks on it, or a face and a round in a chuck.

use super::datums::plane_line_point;
use crate::error::Error;
use glam::{DAffine3, DMat3, DVec2, DVec3};
use std::f64::consts::TAU;

/// Minimum arc over which a round must be touched, rad; on less, its centre is uncertain.
const MIN_ARC: f64 = TAU / 3.0;
/// Maximum number of Gauss-Newton steps to the circle of least squares; a few suffice after a good first guess.
const STEPS: usize = 50;

/// The part's frame in the work frame, and the residuals of the points.
#[derive(Debug, Clone, PartialEq)]
pub struct Placing {
    /// The part's frame in the work frame.
    pub transform: DAffine3,
    /// Distances of the points from their features, mm, positive outside: first list, second, third.
    pub residuals: [Vec<f64>; 3],
    /// Radius of the round, mm, if there is one.
    pub radius_mm: Option<f64>,
}

/// Frame of the plane with x along `along`, the plane's height along its normal, and the residuals.
fn plane(points: &[DVec3], radius: f64, nominal: &DAffine3, along: DVec3) -> Result<(DMat3, f64, Vec<f64>), Error> {
    let from = points.first().copied().unwrap_or_default();
    let fit = plane_line_point(points, &[from, from + along], &[from], radius, nominal)?;
    let z = fit.transform.matrix3.z_axis;
    Ok((fit.transform.matrix3, fit.transform.translation.dot(z), fit.plane))
}

/// The part's frame from touches of the plane z = 0, of its origin and of a point on its x axis. Touches are centres of
/// a ball of `radius` mm, or points with 0. The normal points as in `nominal`; marks are touched with the ball on the
/// plane.
///
/// # Errors
/// [`Error::TooFewPoints`] with fewer than 3, 1 and 1; [`Error::OneLine`] if those of the plane lie on a line,
/// [`Error::OnePosition`] if both marks coincide.
pub fn three_points(
    [face, origin, direction]: [&[DVec3]; 3],
    radius: f64,
    nominal: &DAffine3,
) -> Result<Placing, Error> {
    for (what, given) in [("geometry-points-origin", origin), ("geometry-points-direction", direction)] {
        if given.is_empty() {
            return Err(Error::TooFewPoints { what, given: 0, min: 1 });
        }
    }
    let mean = |points: &[DVec3]| points.iter().sum::<DVec3>() / points.len() as f64;
    let (o, d) = (mean(origin), mean(direction));
    let fit = plane_line_point(face, &[o, d], &[o], radius, nominal)?;
    let z = fit.transform.matrix3.z_axis;
    let height = fit.transform.translation.dot(z);
    // The marks decide the direction of x, not the nominal placement.
    let x = fit.transform.matrix3.x_axis;
    let x = if (d - o).dot(x) < 0.0 { -x } else { x };
    let at = o + (height - o.dot(z)) * z;
    let over = |points: &[DVec3]| points.iter().map(|p| p.dot(z) - height - radius).collect();
    Ok(Placing {
        transform: DAffine3::from_mat3_translation(DMat3::from_cols(x, z.cross(x), z), at),
        residuals: [fit.plane, over(origin), over(direction)],
        radius_mm: None,
    })
}

/// The part's frame from touches (centres of a ball of `radius` mm, or points with 0) of its face z = 0 and of a round
/// about its z axis: the axis of a chuck that holds it. The normal points as in `nominal`; the turn about the axis is
/// kept from it.
///
/// # Errors
/// [`Error::TooFewPoints`] with fewer than 3 and 3; [`Error::OneLine`] if those of the face or of the round lie on a
/// line; [`Error::ShortArc`] for a round touched on less than a third of it.
pub fn chuck(face: &[DVec3], round: &[DVec3], radius: f64, nominal: &DAffine3) -> Result<Placing, Error> {
    if round.len() < 3 {
        return Err(Error::TooFewPoints { what: "geometry-points-circle", given: round.len(), min: 3 });
    }
    let (frame, height, residuals) = plane(face, radius, nominal, 100.0 * nominal.matrix3.x_axis)?;
    let flat: Vec<DVec2> = round.iter().map(|p| (frame.transpose() * *p).truncate()).collect();
    let (middle, r) = circle(&flat).ok_or(Error::OneLine { what: "geometry-points-circle" })?;
    let gap = widest_gap(&flat, middle);
    if TAU - gap < MIN_ARC {
        return Err(Error::ShortArc { touched: TAU - gap, min: MIN_ARC });
    }
    Ok(Placing {
        transform: DAffine3::from_mat3_translation(frame, frame * middle.extend(height)),
        residuals: [residuals, flat.iter().map(|p| p.distance(middle) - r).collect(), vec![]],
        radius_mm: Some(r - radius),
    })
}

/// Widest angle between neighbouring points about `middle`, rad.
fn widest_gap(points: &[DVec2], middle: DVec2) -> f64 {
    let mut angles: Vec<f64> = points.iter().map(|p| (*p - middle).to_angle()).collect();
    angles.sort_by(f64::total_cmp);
    let round = angles.last().zip(angles.first()).map_or(TAU, |(last, first)| first + TAU - last);
    angles.windows(2).map(|pair| pair[1] - pair[0]).fold(round, f64::max)
}

/// The circle of least squares of distances: centre and radius. Starts from the linear fit (I. Kasa, 1976), then
/// Gauss-Newton.
fn circle(points: &[DVec2]) -> Option<(DVec2, f64)> {
    let n = points.len() as f64;
    let mean = points.iter().sum::<DVec2>() / n;
    let own: Vec<DVec2> = points.iter().map(|p| *p - mean).collect();
    let size = (own.iter().map(|p| p.length_squared()).sum::<f64>() / n).sqrt();
    let own: Vec<DVec2> = own.iter().map(|p| *p / size).collect();
    let solved = |rows: &dyn Fn(DVec2) -> (DVec3, f64)| {
        let (mut normal, mut right) = (DMat3::ZERO, DVec3::ZERO);
        for p in &own {
            let (row, value) = rows(*p);
            normal += DMat3::from_cols(row.x * row, row.y * row, row.z * row);
            right += value * row;
        }
        (normal.determinant() > 1e-9 * n.powi(3)).then(|| normal.inverse() * right)
    };
    let guess = solved(&|p| (DVec3::new(2.0 * p.x, 2.0 * p.y, 1.0), p.length_squared()))?;
    let mut middle = guess.truncate();
    let mut r = (guess.z + middle.length_squared()).max(0.0).sqrt();
    for _ in 0..STEPS {
        let step = solved(&|p| {
            let away = p - middle;
            ((-away.normalize_or_zero()).extend(-1.0), -(away.length() - r))
        })?;
        (middle, r) = (middle + step.truncate(), r + step.z);
        if step.length() < 1e-14 {
            break;
        }
    }
    (middle.is_finite() && r.is_finite()).then_some((mean + size * middle, size * r))
}

#[cfg(test)]
mod tests {
    use super::*;
    use seamwright_testkit::Random;

    /// A frame that is turned by up to 60 degrees and moved by up to a metre.
    fn frame(random: &mut Random) -> DAffine3 {
        let axis = (random.vector(1.0) + 2.0 * DVec3::Z).normalize();
        DAffine3::from_axis_angle(axis, random.within(-1.0, 1.0)) * DAffine3::from_translation(random.vector(1000.0))
    }

    fn near(a: &DAffine3, b: &DAffine3) -> bool {
        a.abs_diff_eq(*b, 1e-7)
    }

    #[test]
    fn three_points_give_back_the_frame_that_they_were_made_from() {
        for seed in 0..200 {
            let mut random = Random::of_case(seed);
            let (part, radius) = (frame(&mut random), if seed % 2 == 0 { 0.0 } else { 1.5 });
            let on = |x: f64, y: f64| part.transform_point3(DVec3::new(x, y, radius));
            let face = [on(0.0, 0.0), on(200.0, 3.0), on(-20.0, 150.0), on(80.0, 90.0)];
            let (o, d) = (on(0.0, 0.0), on(if seed % 3 == 0 { 30.0 } else { 250.0 }, 0.0));
            // The nominal pose is tilted, and turned about the normal.
            let nominal = part
                * DAffine3::from_rotation_x(random.within(-0.2, 0.2))
                * DAffine3::from_rotation_z(random.within(-3.0, 3.0));
            let found = three_points([&face, &[o], &[d]], radius, &nominal).unwrap();
            assert!(near(&found.transform, &part), "{seed}: {:?} {part:?}", found.transform);
            assert!(found.residuals.iter().flatten().all(|r| r.abs() < 1e-7), "{seed}: {:?}", found.residuals);
            // A mark touched half a millimetre too high shows in the residual and moves nothing.
            let high = o + 0.5 * part.matrix3.z_axis;
            let found = three_points([&face, &[high], &[d]], radius, &nominal).unwrap();
            assert!((found.residuals[1][0] - 0.5).abs() < 1e-7);
            assert!(near(&found.transform, &part), "{seed}");
        }
    }

    #[test]
    fn a_chuck_gives_back_its_axis() {
        for seed in 0..200 {
            let mut random = Random::of_case(1000 + seed);
            let (part, ball) = (frame(&mut random), random.unit());
            let r = random.within(10.0, 110.0);
            let first = random.within(-3.0, 3.0);
            let on = |p: DVec3| part.transform_point3(p);
            let face: Vec<DVec3> = (0..4)
                .map(|i| {
                    let turn = DVec2::from_angle(first + 1.4 * f64::from(i)) * (0.7 * r);
                    on(turn.extend(ball))
                })
                .collect();
            let count = 3 + seed % 5;
            let round: Vec<DVec3> = (0..count)
                .map(|i| {
                    let at = DVec2::from_angle(first + 4.0 * f64::from(i) / f64::from(count)) * (r + ball);
                    on(at.extend(random.within(-40.0, 0.0)))
                })
                .collect();
            // The turn about the axis is the nominal one, however the axis leans.
            let found = chuck(&face, &round, ball, &part).unwrap();
            assert!(near(&found.transform, &part), "{seed}: {:?} {part:?}", found.transform);
            assert!((found.radius_mm.unwrap() - r).abs() < 1e-7, "{seed}");
            let nominal = DAffine3::from_translation(DVec3::new(5.0, -3.0, 1.0)) * part;
            let found = chuck(&face, &round, ball, &nominal).unwrap();
            assert!(near(&found.transform, &part), "{seed}: {:?} {part:?}", found.transform);
        }
    }

    /// The circle is that of least squares: no slightly different circle fits better.
    #[test]
    fn no_circle_beside_it_is_nearer_to_the_points() {
        for seed in 0..100 {
            let mut random = Random::of_case(5000 + seed);
            let points: Vec<DVec2> = (0..9)
                .map(|i| DVec2::from_angle(0.6 * f64::from(i)) * random.within(39.0, 41.0) + DVec2::new(300.0, -70.0))
                .collect();
            let (middle, r) = circle(&points).unwrap();
            let cost = |m: DVec2, r: f64| points.iter().map(|p| (p.distance(m) - r).powi(2)).sum::<f64>();
            let least = cost(middle, r);
            for _ in 0..50 {
                let aside = cost(middle + random.vector(0.01).truncate(), r + random.within(-0.01, 0.01));
                assert!(aside >= least - 1e-12, "{seed}");
            }
        }
    }

    #[test]
    fn what_tells_nothing_is_refused() {
        let nominal = DAffine3::IDENTITY;
        let p = DVec3::new;
        let face = [p(0.0, 0.0, 0.0), p(100.0, 0.0, 0.0), p(0.0, 100.0, 0.0)];
        let line = [p(0.0, 0.0, 0.0), p(50.0, 0.0, 0.0), p(100.0, 0.0, 0.0)];
        let (o, d) = ([p(0.0, 0.0, 0.0)], [p(100.0, 0.0, 0.0)]);
        assert!(three_points([&face, &o, &d], 0.0, &nominal).is_ok());
        for [a, b, c] in
            [[&line[..], &o, &d], [&face, &o, &o], [&face, &[], &d], [&face, &o, &[]], [&face[..2], &o, &d]]
        {
            assert!(three_points([a, b, c], 0.0, &nominal).is_err());
        }
        let on = |angles: &[f64]| -> Vec<DVec3> {
            angles.iter().map(|a| (50.0 * DVec2::from_angle(a.to_radians())).extend(-5.0)).collect()
        };
        assert!(chuck(&face, &on(&[0.0, 60.0, 130.0]), 0.0, &nominal).is_ok());
        for bad in [on(&[0.0, 40.0, 110.0]), on(&[0.0, 120.0]), on(&[10.0, 10.0, 10.0]), line.to_vec()] {
            assert!(chuck(&face, &bad, 0.0, &nominal).is_err(), "{bad:?}");
        }
        assert!(chuck(&line, &on(&[0.0, 120.0, 240.0]), 0.0, &nominal).is_err());
    }
}
