/// A predicted axis: an arc in pixels of a level.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Axis {
    pub(super) at: [f32; 2],
    /// Heading, rad.
    pub(super) heading: f32,
    /// Change of heading, rad/px.
    pub(super) curvature: f32,
}

/// A place and the unit tangent there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Station {
    pub(super) at: [f32; 2],
    pub(super) tangent: [f32; 2],
}

impl Axis {
    /// Its place and tangent after `s` pixels.
    pub(super) fn station(&self, s: f32) -> Station {
        let turn = s * self.curvature;
        // Chord of an arc: the mean direction is that of half the turn.
        let chord = s * (1.0 - turn * turn / 24.0);
        let (sin, cos) = (self.heading + turn / 2.0).sin_cos();
        let (tangent_sin, tangent_cos) = (self.heading + turn).sin_cos();
        Station { at: [self.at[0] + chord * cos, self.at[1] + chord * sin], tangent: [tangent_cos, tangent_sin] }
    }
}

impl Station {
    /// The place `across` pixels to its right.
    pub(super) fn beside(&self, across: f32) -> [f32; 2] {
        let [cos, sin] = self.tangent;
        [self.at[0] - across * sin, self.at[1] + across * cos]
    }
}
