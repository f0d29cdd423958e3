use glam::{DMat3, DVec2, DVec3};

/// A projective map of one plane to another, as produced by a pinhole camera: straight lines stay straight.
///
/// `(x, y)` goes to `(X / w, Y / w)` with `(X, Y, w) = H (x, y, 1)`. Only points where `w` is positive have an image;
/// the others are beyond the horizon.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Homography {
    matrix: DMat3,
}

impl Homography {
    /// The map that leaves every point where it is.
    pub const IDENTITY: Self = Self { matrix: DMat3::IDENTITY };

    /// The map with matrix `H`; none if it is not finite or cannot be inverted.
    pub fn new(matrix: DMat3) -> Option<Self> {
        let inverse = matrix.inverse();
        (matrix.is_finite() && inverse.is_finite() && matrix.determinant() != 0.0).then_some(Self { matrix })
    }

    /// The map from its first eight numbers, row after row; the ninth is 1, so the origin has an image.
    pub fn from_eight(h: [f64; 8]) -> Option<Self> {
        Self::new(DMat3::from_cols_array(&[h[0], h[3], h[6], h[1], h[4], h[7], h[2], h[5], 1.0]))
    }

    /// The image of `p`; none beyond the horizon.
    pub fn map(&self, p: DVec2) -> Option<DVec2> {
        let image = self.matrix * DVec3::new(p.x, p.y, 1.0);
        (image.z > 0.0).then(|| DVec2::new(image.x, image.y) / image.z)
    }

    /// The inverse map.
    pub fn inverse(&self) -> Self {
        Self { matrix: self.matrix.inverse() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn maps_there_and_back() {
        let h = Homography::from_eight([0.03, 0.002, -30.0, 0.001, -0.07, 36.0, 1e-5, -2e-4]).unwrap();
        for i in 0..100 {
            let p = DVec2::new(f64::from(i % 10) * 100.0, f64::from(i / 10) * 100.0);
            let there = h.map(p).unwrap();
            assert!(h.inverse().map(there).unwrap().distance(p) < 1e-9);
        }
        let w = |p: DVec2| 1.0 + 1e-5 * p.x - 2e-4 * p.y;
        let p = DVec2::new(200.0, 50.0);
        assert!((h.map(p).unwrap().x - (0.03 * p.x + 0.002 * p.y - 30.0) / w(p)).abs() < 1e-12);
        assert!(h.map(DVec2::new(0.0, 6000.0)).is_none(), "beyond the horizon");
    }

    #[test]
    fn what_has_no_inverse_is_refused() {
        assert!(Homography::from_eight([1.0, 2.0, 0.0, 2.0, 4.0, 0.0, 0.0, 0.0]).is_none());
        assert!(Homography::from_eight([f64::NAN, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0]).is_none());
        assert!(Homography::from_eight([1e-300, 0.0, 0.0, 0.0, 1e-300, 0.0, 0.0, 0.0]).is_none());
    }
}
