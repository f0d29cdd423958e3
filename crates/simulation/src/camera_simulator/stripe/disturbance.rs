/// Disturbances of stripe images, all seeded.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StripeDisturbances {
    /// Peak of the stripe, grey values; clipped at 255.
    pub peak: f64,
    /// Half-width of the stripe as a standard deviation, pixels, and its relative change along the stripe.
    pub width_px: f64,
    /// See `width_px`.
    pub width_change: f64,
    /// Speckle: relative variation of the stripe's grey values from pixel to pixel; twice that from column to column.
    pub speckle: f64,
    /// Noise of every pixel, grey values.
    pub noise: f64,
    /// Ambient light, grey values.
    pub ambient: f64,
    /// Glow of the arc, grey values at its brightest.
    pub glow: f64,
    /// Reflections of a second bounce: pieces of false stripes.
    pub ghosts: usize,
    /// Their brightness as part of the stripe's.
    pub ghost_peak: f64,
    /// Spots and streaks of spatter.
    pub spatter: usize,
    /// Share of the columns in which the stripe is missing.
    pub missing: f64,
    /// Share of the columns in which it appears elsewhere.
    pub outliers: f64,
}

impl StripeDisturbances {
    /// A dark room.
    pub const CLEAN: Self = Self {
        peak: 180.0,
        width_px: 2.2,
        width_change: 0.0,
        speckle: 0.0,
        noise: 2.0,
        ambient: 8.0,
        glow: 0.0,
        ghosts: 0,
        ghost_peak: 0.0,
        spatter: 0,
        missing: 0.0,
        outliers: 0.0,
    };

    /// A stripe on ground steel: speckle, ambient light.
    pub const USUAL: Self = Self { width_change: 0.3, speckle: 0.2, noise: 4.0, ambient: 20.0, ..Self::CLEAN };

    /// Beside a burning arc on bright steel: glow, saturated spots, reflections, spatter.
    pub const ROUGH: Self =
        Self { peak: 420.0, glow: 90.0, ghosts: 3, ghost_peak: 0.7, spatter: 25, width_px: 2.6, ..Self::USUAL };

    /// The usual disturbances with 10 % outliers and 20 % of the columns missing.
    pub const HOLED: Self = Self { missing: 0.2, outliers: 0.1, ..Self::USUAL };
}
