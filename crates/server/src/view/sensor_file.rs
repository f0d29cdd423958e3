use crate::wire::{HeightView, SensorSetUp, SensorValue};
use glam::DVec2;
use seamwright_geometry::MapParameters;
use seamwright_machine::{Machine, Sight};
use seamwright_project::Failure;
use seamwright_project::own_machine::{OwnMachine, Step};

/// Numbers of a sensor: tables below the sensor's, key, group, count of numbers. For maps of several kinds, the first
/// key of a kind is mandatory.
pub(crate) const SENSOR_KEYS: [(&[&str], &str, &str, u32); 13] = [
    (&["at"], "move_mm", "pose", 3),
    (&["at"], "turn", "pose", 3),
    (&["at"], "angle_deg", "pose", 1),
    (&["map", "camera"], "distance_mm", "map", 1),
    (&["map", "camera"], "angle_deg", "map", 1),
    (&["map", "camera"], "focal_px", "map", 1),
    (&["map", "camera"], "centre_px", "map", 2),
    (&["map"], "homography", "map", 8),
    (&["map", "scale"], "mm_per_px", "map", 2),
    (&["map", "scale"], "origin_px", "map", 2),
    (&[], "period_ms", "timing", 1),
    (&[], "latency_ms", "timing", 1),
    (&[], "noise_mm", "timing", 1),
];

pub(crate) fn steps<'a>(name: &'a str, tables: &[&'a str]) -> Vec<Step<'a>> {
    [&["sensors", name], tables].concat().into_iter().map(Step::Table).collect()
}

/// Returns the sensors of the machine file.
pub(crate) fn sensors_view(own: &OwnMachine, machine: &Machine) -> Result<Vec<SensorSetUp>, Failure> {
    machine
        .sensors
        .iter()
        .map(|sensor| {
            let mut values = Vec::new();
            for (tables, key, group, count) in SENSOR_KEYS {
                let numbers = own.rows(&steps(&sensor.name, tables), &[key])?.concat();
                let path = [tables, &[key]].concat().join(".");
                values.push(SensorValue { key: path, group: group.to_owned(), count, numbers });
            }
            // A map is of one kind: keys of the other kinds are not allowed.
            let kinds =
                |key: &str| ["map.camera.", "map.homography", "map.scale."].into_iter().find(|k| key.starts_with(k));
            let there: Vec<&str> =
                values.iter().filter(|value| !value.numbers.is_empty()).filter_map(|value| kinds(&value.key)).collect();
            values.retain(|value| kinds(&value.key).is_none_or(|kind| there.contains(&kind)));
            let heights = match &sensor.sight {
                Sight::Stripe(_) => Vec::new(),
                // The camera's z points away from it, that of the sensor towards it.
                Sight::Camera(camera) => camera
                    .table
                    .rows()
                    .iter()
                    .rev()
                    .map(|(height, map)| height_view(-height, map.parameters()))
                    .collect(),
            };
            let kind = if matches!(sensor.sight, Sight::Stripe(_)) { "stripe" } else { "camera" };
            let size_px = sensor.size_px.map(|n| n as u32);
            Ok(SensorSetUp { name: sensor.name.clone(), kind: kind.to_owned(), size_px, values, heights })
        })
        .collect()
}

/// Returns a plane of a camera, rounded to measurable digits.
pub(crate) fn height_view(z_mm: f64, of: &MapParameters) -> HeightView {
    let rounded = |v: f64, digits: i32| (v * 10f64.powi(digits)).round() / 10f64.powi(digits) + 0.0;
    let middle = 0.5 * DVec2::new(of.size_px.0 as f64 - 1.0, of.size_px.1 as f64 - 1.0);
    HeightView {
        z_mm: rounded(z_mm, 6),
        mm_per_px: of.mm_per_px.to_array().map(|v| rounded(v, 7)),
        centre_px: (of.centre_px != middle).then(|| of.centre_px.to_array().map(|v| rounded(v, 3))),
        rotation_deg: rounded(of.rotation.to_degrees(), 4),
        shear: rounded(of.shear, 6),
        barrel: rounded(of.barrel, 6),
    }
}
