use crate::frame::Size;

/// Length of a vector in pixels. Unlike `f32::hypot` it omits the slow protection against overflow.
pub(super) fn length([x, y]: [f32; 2]) -> f32 {
    (x * x + y * y).sqrt()
}

/// A predicted axis: an arc, in pixels of a level.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Axis {
    pub(super) at: [f32; 2],
    /// Heading, rad.
    pub(super) heading: f32,
    /// Change of heading, rad/px.
    pub(super) curvature: f32,
}

/// A position and the unit tangent there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Station {
    pub(super) at: [f32; 2],
    pub(super) tangent: [f32; 2],
}

impl Axis {
    /// Returns true if the axis is within a picture of this size after `length` pixels.
    pub(super) fn stays_within(&self, length: f32, size: Size) -> bool {
        let [x, y] = self.station(length).at;
        (0.0..=(size.width - 1) as f32).contains(&x) && (0.0..=(size.height - 1) as f32).contains(&y)
    }

    /// Returns the position and tangent after `s` pixels.
    pub(super) fn station(&self, s: f32) -> Station {
        let turn = s * self.curvature;
        // Chord of an arc: its direction is that of half the turn.
        let chord = s * (1.0 - turn * turn / 24.0);
        let (sin, cos) = (self.heading + turn / 2.0).sin_cos();
        let (tangent_sin, tangent_cos) = (self.heading + turn).sin_cos();
        Station { at: [self.at[0] + chord * cos, self.at[1] + chord * sin], tangent: [tangent_cos, tangent_sin] }
    }
}

impl Axis {
    /// Returns `count` stations a pixel apart, the first after `from` pixels.
    pub(super) fn stations(&self, from: f32, count: usize) -> impl ExactSizeIterator<Item = Station> {
        let mut next = self.station(from);
        // From one station to the next the tangent turns twice by half of the angle; the chord lies between.
        let (sin, cos) = (0.5 * self.curvature).sin_cos();
        let half = move |[x, y]: [f32; 2]| [x * cos - y * sin, x * sin + y * cos];
        let chord = 1.0 - self.curvature * self.curvature / 24.0;
        (0..count).map(move |_| {
            let here = next;
            let along = half(here.tangent);
            next = Station { at: [0, 1].map(|k| here.at[k] + chord * along[k]), tangent: half(along) };
            here
        })
    }

    /// Returns a function from a point to its distances along the axis and to its right, pixels; valid for half a turn.
    pub(super) fn along_and_across(&self) -> impl Fn([f32; 2]) -> (f32, f32) {
        let Self { at: [x0, y0], heading, curvature } = *self;
        let ((sin, cos), radius) = (heading.sin_cos(), 1.0 / curvature);
        move |[x, y]| {
            let (x, y) = (x - x0, y - y0);
            let (u, v) = (x * cos + y * sin, y * cos - x * sin);
            if curvature.abs() < 1e-4 {
                return (u, v - 0.5 * curvature * u * u);
            }
            // The centre is at (0, radius).
            let along = radius * angle(u * radius.signum(), (radius - v) * radius.signum());
            (along, radius - radius.signum() * length([u, radius - v]))
        }
    }
}

/// Fast `f32::atan2`, accurate to a millionth: small angles by their series.
pub(super) fn angle(y: f32, x: f32) -> f32 {
    let ratio = y / x;
    if x > 0.0 && ratio.abs() < 0.3 {
        let square = ratio * ratio;
        ratio * (1.0 - square * (1.0 / 3.0 - square * (1.0 / 5.0 - square * (1.0 / 7.0 - square * (1.0 / 9.0)))))
    } else {
        y.atan2(x)
    }
}

impl Station {
    /// Returns the position `across` pixels to the right.
    #[inline(always)]
    pub(super) fn beside(&self, across: f32) -> [f32; 2] {
        let [cos, sin] = self.tangent;
        [self.at[0] - across * sin, self.at[1] + across * cos]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stations_are_a_pixel_apart() {
        for curvature in [0.0, 0.002, -0.03, 0.03] {
            let axis = Axis { at: [300.0, -12.0], heading: 2.1, curvature };
            let all = axis.stations(-10.0, 48);
            assert_eq!(all.len(), 48);
            for (i, station) in all.enumerate() {
                let alone = axis.station(i as f32 - 10.0);
                for k in 0..2 {
                    // The chord formula for a long arc is accurate to a few hundredths of a pixel.
                    assert!((station.at[k] - alone.at[k]).abs() < 0.05, "{curvature} {i}");
                    assert!((station.tangent[k] - alone.tangent[k]).abs() < 1e-5, "{curvature} {i}");
                }
            }
        }
    }

    #[test]
    fn angles_are_those_of_the_library() {
        for i in -3000..3000 {
            let expected = i as f32 * 0.001;
            let (sin, cos) = expected.sin_cos();
            assert!((angle(70.0 * sin, 70.0 * cos) - expected).abs() < 1e-6, "{expected}");
        }
    }

    #[test]
    fn places_beside_the_axis_are_found_where_they_were_put() {
        for curvature in [0.0, 5e-5, 0.002, -0.01, 0.03, -0.03] {
            let axis = Axis { at: [30.0, -12.0], heading: 2.1, curvature };
            for s in [-40.0, -7.0, 0.0, 13.0, 44.0] {
                for across in [-6.0, 0.0, 4.5] {
                    let (along, beside) = axis.along_and_across()(axis.station(s).beside(across));
                    // The chord formula for an arc is accurate to a few hundredths of a pixel.
                    assert!((along - s).abs() < 0.1 && (beside - across).abs() < 0.1, "{curvature} {s} {across}");
                }
            }
        }
    }
}
