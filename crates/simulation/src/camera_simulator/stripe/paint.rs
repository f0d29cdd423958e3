use super::{StripeDisturbances, StripeScene};
use crate::camera_simulator::random::Random;
use glam::DVec2;
use seamwright_vision::Image;

/// Range in which a stripe is drawn, standard deviations.
const DRAWN: f64 = 4.0;

/// Positions per column at which the stripe is drawn, each with its share of the light: edges lie anywhere in a
/// column.
const PARTS: usize = 4;

/// Half-width of the dark line over a closed butt joint, mm, and the share of light that it takes.
const DARK_MM: f64 = 0.1;
const DARK_PART: f64 = 0.7;

/// Paints an image, layer by layer.
pub(super) struct Painter<'a> {
    scene: &'a StripeScene,
    how: &'a StripeDisturbances,
    random: Random,
    light: Vec<f32>,
}

impl<'a> Painter<'a> {
    pub(super) fn new(scene: &'a StripeScene, how: &'a StripeDisturbances, random: Random) -> Self {
        let [width, height] = scene.size_px;
        Self { scene, how, random, light: vec![0.0; width * height] }
    }

    /// Paints the stripe with its reflections; returns the true rows.
    pub(super) fn stripe(&mut self, dark: Option<DVec2>) -> Vec<Option<f64>> {
        let [width, height] = self.scene.size_px;
        let (mut rows, fine) = (self.scene.lit_rows(), self.scene.lit_at(PARTS));
        let phase = self.random.within(0.0, 6.0);
        let pitch = 200.0 / width as f64;
        for column in 0..width {
            let missing = self.random.chance(self.how.missing);
            let outlier = self.random.chance(self.how.outliers);
            let elsewhere = self.random.within(10.0, height as f64 - 10.0);
            let mut peak = self.how.peak * (1.0 + 2.0 * self.how.speckle * self.random.normal()).max(0.2);
            if missing || outlier {
                rows[column] = None;
            }
            let wave = (phase + pitch * column as f64 / 7.0).sin() * (phase + pitch * column as f64 / 3.1).cos();
            let sigma = self.how.width_px * (1.0 + self.how.width_change * wave);
            if missing {
                continue;
            }
            for row in fine[PARTS * column..PARTS * (column + 1)].iter().flatten() {
                if let (Some(dark), Some(at)) = (dark, self.scene.to_mm.map(DVec2::new(column as f64, *row))) {
                    peak *= 1.0 - DARK_PART / PARTS as f64 * (-((at.x - dark.x) / DARK_MM).powi(2)).exp();
                }
                self.slice(column, if outlier { elsewhere } else { *row }, peak / PARTS as f64, sigma);
            }
        }
        self.ghosts(&rows);
        self.speckle();
        self.blur();
        self.spatter();
        rows
    }

    /// Paints one column of a stripe.
    fn slice(&mut self, column: usize, row: f64, peak: f64, sigma: f64) {
        let [width, height] = self.scene.size_px;
        let from = (row - DRAWN * sigma).ceil().max(0.0) as usize;
        let to = ((row + DRAWN * sigma).floor().max(0.0) as usize).min(height - 1);
        for r in from..=to {
            let d = (r as f64 - row) / sigma;
            self.light[r * width + column] += (peak * (-d * d / 2.0).exp()) as f32;
        }
    }

    /// Adds the grain of coherent light.
    fn speckle(&mut self) {
        for light in self.light.iter_mut().filter(|v| **v > 0.0) {
            *light *= (1.0 + self.how.speckle * self.random.normal()).max(0.0) as f32;
        }
    }

    /// Paints pieces of stripes that cross or follow the true one.
    fn ghosts(&mut self, rows: &[Option<f64>]) {
        let [width, height] = self.scene.size_px;
        for _ in 0..self.how.ghosts {
            let long = self.random.whole(width / 16, width / 5);
            let first = self.random.whole(0, width - long);
            let (start, slope) = (self.random.within(-60.0, 60.0), self.random.within(-1.0, 1.0));
            let Some(from) = rows[first..first + long].iter().flatten().next().copied() else { continue };
            for (i, column) in (first..first + long).enumerate() {
                let row = from + start + slope * i as f64;
                if (0.0..height as f64).contains(&row) {
                    self.slice(column, row, self.how.peak * self.how.ghost_peak, self.how.width_px);
                }
            }
        }
    }

    /// Spreads light a little across the columns, as the lens does; along them, the stripe's width includes it.
    fn blur(&mut self) {
        let width = self.scene.size_px[0];
        for row in self.light.chunks_exact_mut(width) {
            let mut before = row[0];
            for i in 0..width {
                let (here, after) = (row[i], row[(i + 1).min(width - 1)]);
                row[i] = 0.25 * before + 0.5 * here + 0.25 * after;
                before = here;
            }
        }
    }

    /// Paints bright spots and streaks.
    fn spatter(&mut self) {
        let [width, height] = self.scene.size_px;
        for _ in 0..self.how.spatter {
            let mut at = DVec2::new(self.random.within(0.0, width as f64), self.random.within(0.0, height as f64));
            let flight = DVec2::from_angle(self.random.within(0.0, 6.3)) * 2.0;
            let (radius, steps) = (self.random.within(1.0, 4.0), self.random.whole(1, 12));
            for _ in 0..steps {
                let reach = 3.0 * radius;
                let rows = (at.y - reach).max(0.0) as usize..((at.y + reach).max(0.0) as usize).min(height);
                let columns = (at.x - reach).max(0.0) as usize..((at.x + reach).max(0.0) as usize).min(width);
                for r in rows {
                    for c in columns.clone() {
                        let d = DVec2::new(c as f64, r as f64).distance_squared(at) / (radius * radius);
                        self.light[r * width + c] += 400.0 * (-d / 2.0).exp() as f32;
                    }
                }
                at += flight;
            }
        }
    }

    /// Adds ambient light, glow and noise to the whole image, in grey values.
    pub(super) fn finish(mut self) -> Image {
        let [width, height] = self.scene.size_px;
        let centre = DVec2::new(self.random.within(0.0, width as f64), self.random.within(0.0, height as f64));
        let reach = 0.35 * width as f64;
        let mut pixels = Vec::with_capacity(width * height);
        let across: Vec<f64> = (0..width).map(|c| (-((c as f64 - centre.x) / reach).powi(2)).exp()).collect();
        for (r, row) in self.light.chunks_exact(width).enumerate() {
            let down = self.how.glow * (-((r as f64 - centre.y) / reach).powi(2)).exp();
            for (light, across) in row.iter().zip(&across) {
                let grey = self.how.ambient + down * across + f64::from(*light) + self.how.noise * self.random.normal();
                pixels.push(grey.round().clamp(0.0, 255.0) as u8);
            }
        }
        Image::U8 { width, height, pixels }
    }
}
