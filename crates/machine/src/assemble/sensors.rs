//! Sensors and their maps from pixels to mm.

use crate::file::File;
use crate::links::Links;
use crate::sensor::{CameraSensor, PixelMapFile, Sensor, SensorFile, SensorKind, Sight, StripeSensor};
use glam::{DMat3, DVec2, DVec3};
use seamwright_document::{DocumentError, Finite, Positive};
use seamwright_geometry::{HeightTable, Homography, MapParameters, PlaneMap};
use seamwright_message::{Message, Unit};

const MAX_PX: u16 = 16384;

const USUAL_PERIOD_S: f64 = 0.1;
/// Default latency from an exposure to the result, s, and its noise, mm.
const USUAL_LATENCY_S: f64 = 0.015;
const USUAL_NOISE_MM: f64 = 0.02;

pub(super) fn sensors(file: &File, links: &Links) -> Result<Vec<Sensor>, DocumentError> {
    file.value.sensors.iter().map(|(name, sensor)| build(file, links, name, sensor)).collect()
}

fn build(file: &File, links: &Links, name: &str, sensor: &SensorFile) -> Result<Sensor, DocumentError> {
    let path = format!("sensors.{name}");
    let Some(frame) = links.frame(&sensor.on) else {
        let names: Vec<&str> = links.named().iter().map(|f| f.name.as_str()).collect();
        return Err(file.unknown_name(&format!("{path}.on"), &sensor.on, &names));
    };
    if let Some(i) = sensor.size_px.iter().position(|n| !(1..=MAX_PX).contains(n)) {
        let message = Message::new(["machine-image-width", "machine-image-height"][i]);
        let allowed = Message::new("machine-image-size").text("max", MAX_PX.to_string());
        return Err(file.error_at(&format!("{path}.size_px"), message, allowed));
    }
    let size_px = sensor.size_px.map(usize::from);
    let sight = match sensor.kind {
        SensorKind::Stripe => Sight::Stripe(StripeSensor { to_mm: map(file, &path, sensor)? }),
        SensorKind::Camera => Sight::Camera(CameraSensor { table: heights(file, &path, sensor)? }),
    };
    let period_s = sensor.period_ms.map_or(USUAL_PERIOD_S, |p| p.get() * 1e-3);
    Ok(Sensor {
        name: name.to_owned(),
        link: frame.link,
        zero: frame.zero * sensor.at.affine(),
        size_px,
        period_s,
        latency_s: sensor.latency_ms.map_or(USUAL_LATENCY_S, |p| p.get() * 1e-3),
        noise_mm: sensor.noise_mm.map_or(USUAL_NOISE_MM, Positive::get),
        sight,
        frames: frames(file, &path, sensor)?,
    })
}

fn frames(file: &File, path: &str, sensor: &SensorFile) -> Result<Option<String>, DocumentError> {
    let Some(source) = &sensor.frames else { return Ok(None) };
    let wrong = |code| {
        let allowed = Message::new("machine-frames-form");
        Err(file.error_at(&format!("{path}.frames"), Message::new(code), allowed))
    };
    if sensor.kind != SensorKind::Camera {
        return wrong("machine-frames-of-stripe");
    }
    let address = source.strip_prefix("tcp://").unwrap_or_default();
    match address.rsplit_once(':') {
        Some((host, port)) if !host.is_empty() && port.parse::<u16>().is_ok_and(|port| port > 0) => {
            Ok(Some(address.to_owned()))
        }
        _ => wrong("machine-frames-invalid"),
    }
}

fn map(file: &File, path: &str, sensor: &SensorFile) -> Result<Homography, DocumentError> {
    let Some(map) = &sensor.map else {
        return Err(file.fault_at(path, "machine-stripe-map-missing", "machine-stripe-maps"));
    };
    let [last_column, last_row] = sensor.size_px.map(|n| f64::from(n) - 1.0);
    let middle = DVec2::new(last_column, last_row) / 2.0;
    let place = |p: &Option<[Finite; 2]>| p.map_or(middle, |p| DVec2::from_array(p.map(Finite::get)));
    let (key, found) = match map {
        PixelMapFile::Camera { distance_mm, angle_deg, focal_px, centre_px } => {
            if angle_deg.get() >= 90.0 {
                let key = format!("{path}.map.camera.angle_deg");
                let allowed = Message::new("document-strictly-between").value("min", 0.0, Unit::Deg);
                let allowed = allowed.value("max", 90.0, Unit::Deg);
                return Err(file.error_at(&key, Message::new("machine-camera-angle"), allowed));
            }
            let found = camera(distance_mm.get(), angle_deg.get().to_radians(), focal_px.get(), place(centre_px));
            ("camera", found)
        }
        PixelMapFile::Homography(h) => ("homography", Homography::from_eight(h.map(Finite::get))),
        PixelMapFile::Scale { mm_per_px, origin_px } => {
            let [y, z] = mm_per_px.map(Finite::get);
            let origin = place(origin_px);
            ("scale", Homography::from_eight([y, 0.0, -y * origin.x, 0.0, -z, z * origin.y, 0.0, 0.0]))
        }
        PixelMapFile::Heights(_) => {
            return Err(file.fault_at(&format!("{path}.map.heights"), "machine-map-of-camera", "machine-stripe-maps"));
        }
    };
    let key = format!("{path}.map.{key}");
    let Some(found) = found else {
        return Err(file.fault_at(&key, "machine-map-singular", "machine-map-invertible"));
    };
    let corners = [(0.0, 0.0), (last_column, 0.0), (0.0, last_row), (last_column, last_row)];
    if let Some((column, row)) = corners.into_iter().find(|&(x, y)| found.map(DVec2::new(x, y)).is_none()) {
        let message = Message::new("machine-map-horizon").number("column", column, 0).number("row", row, 0);
        return Err(file.error_at(&key, message, Message::new("machine-map-every-pixel")));
    }
    Ok(found)
}

fn heights(file: &File, path: &str, sensor: &SensorFile) -> Result<HeightTable, DocumentError> {
    let Some(PixelMapFile::Heights(rows)) = &sensor.map else {
        let path = if sensor.map.is_some() { format!("{path}.map") } else { path.to_owned() };
        let message = Message::new("machine-camera-map-missing");
        return Err(file.error_at(&path, message, "map.heights = [{ z_mm = .., mm_per_px = .. }]"));
    };
    let key = format!("{path}.map.heights");
    let [columns, rows_px] = sensor.size_px.map(f64::from);
    let size_px = (usize::from(sensor.size_px[0]), usize::from(sensor.size_px[1]));
    let mut table = Vec::new();
    for (i, row) in rows.iter().enumerate() {
        let middle = DVec2::new(columns - 1.0, rows_px - 1.0) / 2.0;
        let parameters = MapParameters {
            size_px,
            centre_px: row.centre_px.map_or(middle, |c| DVec2::from_array(c.map(Finite::get))),
            mm_per_px: DVec2::from_array(row.mm_per_px.map(Positive::get)),
            rotation: row.rotation_deg.get().to_radians(),
            shear: row.shear.get(),
            barrel: row.barrel.get(),
        };
        let map = PlaneMap::new(parameters).map_err(|e| file.error_at(&format!("{key}[{i}]"), &e, ""))?;
        // The camera's z points away from it, the sensor's z towards it.
        table.push((-row.z_mm.get(), map));
    }
    if let [(_, map)] = table.as_slice() {
        return Ok(HeightTable::telecentric(*map));
    }
    if let Some(i) = (1..table.len()).find(|&i| table[i].0 >= table[i - 1].0) {
        return Err(file.fault_at(&format!("{key}[{i}].z_mm"), "machine-heights-order", "machine-more-than-before"));
    }
    table.reverse();
    HeightTable::new(table).map_err(|e| file.error_at(&key, &e, Message::new("machine-heights-rows")))
}

/// From pixels to the plane x = 0 for a camera at `distance` (mm) from the origin in the plane y = 0, on the side of
/// positive x at `angle` (rad) from z, that looks at the origin with its rows along y: z points up in its images.
fn camera(distance: f64, angle: f64, focal: f64, centre: DVec2) -> Option<Homography> {
    let (sin, cos) = angle.sin_cos();
    // A point (0, y, z) of the plane has the camera's coordinates y to the right, -z sin(angle) down, and
    // distance - z cos(angle) in depth.
    let seen = DMat3::from_cols(DVec3::X, DVec3::new(0.0, -sin, -cos), DVec3::new(0.0, 0.0, distance));
    let lens = DMat3::from_cols(DVec3::X * focal, DVec3::Y * focal, DVec3::new(centre.x, centre.y, 1.0));
    Homography::new(lens * seen).map(|to_px| to_px.inverse())
}
