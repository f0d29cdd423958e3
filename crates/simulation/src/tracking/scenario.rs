use super::displacement::Displacement;
use super::sensor_model::SensorModel;
use super::travel::Leg;
use super::world::Placement;
use glam::DVec2;
use seamwright_executive::tracking::Seam;

/// One head in a scenario.
pub struct HeadScene {
    /// Taught seam.
    pub seam: Seam,
    /// Displacement of its seam.
    pub displacement: Displacement,
    /// Placement of its part.
    pub placement: Placement,
    /// Its sensor.
    pub sensor: SensorModel,
    /// Position of the torch from which its slide is stuck, mm.
    pub stuck_mm: Option<f64>,
}

impl HeadScene {
    /// Creates a head on a straight seam, with the usual sensor 20 mm ahead.
    #[must_use]
    pub fn straight(length_mm: f64, displacement: Displacement) -> Self {
        Self::on(Seam::straight(length_mm), displacement)
    }

    /// Creates a head on a seam, with the usual sensor 20 mm ahead.
    #[must_use]
    pub fn on(seam: Seam, displacement: Displacement) -> Self {
        let sensor = SensorModel::usual(20.0);
        Self { seam, displacement, placement: Placement::RIGHT, sensor, stuck_mm: None }
    }
}

/// A weld to be tracked.
pub struct Scenario {
    /// Name in words.
    pub name: String,
    /// Maximum speed, to which the papers' buffers are matched, mm/s.
    pub speed_mm_s: f64,
    /// Way of the torch; it starts a lead before the seam.
    pub legs: Vec<Leg>,
    /// One head or two.
    pub heads: Vec<HeadScene>,
}

impl Scenario {
    /// Creates a weld from end to end at one speed.
    #[must_use]
    pub fn steady(name: &str, speed_mm_s: f64, heads: Vec<HeadScene>) -> Self {
        let length = heads.iter().map(|h| h.seam.length_mm).fold(f64::INFINITY, f64::min);
        Self { name: name.to_owned(), speed_mm_s, legs: vec![Leg::To(length, speed_mm_s)], heads }
    }
}

/// Displaces the seams of both heads in opposite ways.
pub(super) fn opposite(displacement: &Displacement) -> [Displacement; 2] {
    let mirrored = displacement.parts.iter().map(|part| part.scaled(DVec2::new(-1.0, 0.7))).collect();
    [displacement.clone(), Displacement { parts: mirrored, tacks: displacement.tacks.clone() }]
}
