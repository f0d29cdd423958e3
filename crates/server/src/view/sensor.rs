use crate::wire::SensorView;
use glam::{DVec2, DVec3};
use seamwright_machine::{Sensor, Sight};

pub(super) fn sensor(sensor: &Sensor) -> SensorView {
    let kind = match sensor.sight {
        Sight::Stripe(_) => "stripe",
        Sight::Camera(_) => "camera",
    };
    let corners: Option<Vec<DVec3>> = corners(sensor).into_iter().map(|px| seen(sensor, px)).collect();
    let field = corners.unwrap_or_default().into_iter().map(|p| sensor.zero.transform_point3(p).to_array());
    let (name, kind, frames) = (sensor.name.clone(), kind.to_owned(), sensor.frames.is_some());
    SensorView { name, kind, link: sensor.link, field: field.collect(), frames }
}

/// Centres of the picture's corner pixels, in order around it.
fn corners(sensor: &Sensor) -> [DVec2; 4] {
    let [width, height] = sensor.size_px.map(|n| n as f64 - 1.0);
    [DVec2::ZERO, DVec2::new(width, 0.0), DVec2::new(width, height), DVec2::new(0.0, height)]
}

/// Returns the point that a pixel sees, in the sensor's frame, mm; `None` outside its map.
fn seen(sensor: &Sensor, px: DVec2) -> Option<DVec3> {
    match &sensor.sight {
        Sight::Stripe(stripe) => stripe.to_mm.map(px).map(|p| DVec3::new(0.0, p.x, p.y)),
        Sight::Camera(camera) => {
            // The camera's frame is the sensor's turned about x by half a turn.
            let (low, high) = camera.table.range();
            let p = camera.table.to_point(px, 0.0_f64.clamp(low, high)).ok()?;
            Some(DVec3::new(p.x, -p.y, -p.z))
        }
    }
}
