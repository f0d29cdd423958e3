//! Least-squares fit of the map to the dots.

use super::crossings::Crossing;
use super::identified::{Dot, Grid, GridError, Identified};
use crate::frame::Size;
use glam::{DMat2, DVec2};
use nalgebra::{SMatrix, SVector};
use seamwright_geometry::{MapParameters, PlaneMap};

/// Pixels per mm (four numbers, by columns), offset in undistorted pixels, barrel distortion.
const UNKNOWNS: usize = 7;

/// Maximum iterations; a few are enough from the linear start.
const STEPS: usize = 50;

pub(super) fn fit(crossings: &[Crossing], size: Size, grid: &Grid) -> Result<Identified, GridError> {
    let centre = grid.centre_px.unwrap_or(0.5 * DVec2::new(size.width as f64 - 1.0, size.height as f64 - 1.0));
    let radius = 0.5 * size.width as f64;
    // Scaled to pitches and radii, so that all unknowns are about 1.
    let model = Model { centre, radius, crossings };
    let unknowns = model.solve();
    let dots: Vec<Dot> = crossings.iter().map(|c| Dot { px: c.px, off_px: model.at(&unknowns, c).0 - c.px }).collect();
    let (sum, max) = dots
        .iter()
        .map(|dot| dot.off_px.length_squared())
        .fold((0.0, 0.0), |(sum, max): (f64, f64), d| (sum + d, max.max(d)));
    let (rms, max) = ((sum / crossings.len() as f64).sqrt(), f64::sqrt(max));
    if rms.is_nan() || rms > grid.limit_px {
        return Err(GridError::Residual { rms, max });
    }
    let to_px = DMat2::from_cols_slice(&unknowns.as_slice()[..4]) * (radius / grid.pitch_mm);
    let map = PlaneMap::new(parameters(to_px.inverse(), unknowns[6], size, centre))?;
    Ok(Identified { map, dots, rms_px: rms, max_px: max })
}

/// Decomposes a matrix of mm per pixel into scale, rotation and shear.
fn parameters(to_mm: DMat2, barrel: f64, size: Size, centre_px: DVec2) -> MapParameters {
    let rotation = to_mm.x_axis.y.atan2(to_mm.x_axis.x);
    let square = DMat2::from_angle(-rotation) * to_mm;
    MapParameters {
        size_px: (size.width, size.height),
        centre_px,
        mm_per_px: DVec2::new(square.x_axis.x, square.y_axis.y),
        rotation,
        shear: square.y_axis.x / square.y_axis.y,
        barrel,
    }
}

struct Model<'a> {
    centre: DVec2,
    radius: f64,
    crossings: &'a [Crossing],
}

type Unknowns = SVector<f64, UNKNOWNS>;

impl Model<'_> {
    /// Returns a crossing's position by the map, in pixels, and its derivatives.
    fn at(&self, u: &Unknowns, crossing: &Crossing) -> (DVec2, [DVec2; UNKNOWNS]) {
        let g = crossing.place.as_dvec2();
        let n = DVec2::new(u[0], u[1]) * g.x + DVec2::new(u[2], u[3]) * g.y + DVec2::new(u[4], u[5]);
        let r2 = n.length_squared();
        let by = |d: DVec2| self.radius * ((1.0 + u[6] * r2) * d + 2.0 * u[6] * n.dot(d) * n);
        let derivatives = [
            by(DVec2::X * g.x),
            by(DVec2::Y * g.x),
            by(DVec2::X * g.y),
            by(DVec2::Y * g.y),
            by(DVec2::X),
            by(DVec2::Y),
            self.radius * r2 * n,
        ];
        (self.centre + self.radius * (1.0 + u[6] * r2) * n, derivatives)
    }

    /// Gauss-Newton iteration from the map without distortion, which is a linear problem.
    fn solve(&self) -> Unknowns {
        let mut u = Unknowns::zeros();
        for step in 0..STEPS {
            // The first step solves the linear problem, without barrel distortion.
            let unknowns = if step == 0 { UNKNOWNS - 1 } else { UNKNOWNS };
            let mut normal = SMatrix::<f64, UNKNOWNS, UNKNOWNS>::zeros();
            let mut right = Unknowns::zeros();
            for crossing in self.crossings {
                let (place, derivatives) = self.at(&u, crossing);
                let off = crossing.px - place;
                for i in 0..unknowns {
                    right[i] += derivatives[i].dot(off);
                    for j in 0..unknowns {
                        normal[(i, j)] += derivatives[i].dot(derivatives[j]);
                    }
                }
            }
            for i in unknowns..UNKNOWNS {
                normal[(i, i)] = 1.0;
            }
            let Some(change) = normal.cholesky().map(|c| c.solve(&right)) else { break };
            u += change;
            if step > 0 && change.amax() < 1e-13 {
                break;
            }
        }
        u
    }
}
