//! Setup of sensors: the map from a camera's pixels to mm, from a picture of a grid, and numbers of the machine file.

use super::answer::{Answer, Refused};
use super::panel::{Panel, Shared};
use super::setup::{Changed, ChangedPart, OfCell, of_cell, tell};
use crate::cell::Change;
use crate::limits::MAX_PICTURE_PX;
use crate::users::Session;
use crate::view::{SENSOR_KEYS, height_view, sensors_view, steps};
use crate::wire::{HeightView, SensorAnswer, SensorChange, SensorsView};
use axum::Json;
use axum::body::Bytes;
use axum::extract::{Query, State};
use axum::http::header;
use axum::response::{IntoResponse as _, Response};
use seamwright_frames::{Overlay, decode_up_to};
use seamwright_geometry::{HeightTable, MapParameters};
use seamwright_machine::{Machine, Sensor, Sight};
use seamwright_message::{Message, Unit};
use seamwright_project::own_machine::{OwnMachine, Setting, Step};
use seamwright_simulation::camera_simulator::plate;
use seamwright_vision::Image;
use seamwright_vision::camera::{Dot, Grid, GridError, identify};
use serde::Deserialize;
use std::sync::Arc;

/// Maximum RMS deviation of dots from the fitted map, pixels. Beyond it they are not those of the grid, or not sharp.
const LIMIT_PX: f64 = 0.3;
/// Maximum relative change of the scale. Beyond it pitch, height or sensor is a different one.
const FAR: f64 = 0.1;
/// Maximum number of planes of a camera.
const MAX_HEIGHTS: usize = 100;

/// Parameters of a picture of a grid.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Plate {
    /// The sensor.
    name: String,
    /// Pitch of the dots, mm.
    pitch_mm: f64,
    /// The plate's z in the sensor's frame, mm.
    z_mm: f64,
    /// Seed of a simulated picture.
    #[serde(default)]
    seed: u64,
}

/// Returns a camera of the machine, and its current map at the plate's height.
fn camera<'a>(machine: &'a Machine, of: &Plate) -> Result<(&'a Sensor, MapParameters), Refused> {
    let sensor = sensor(machine, &of.name)?;
    let Sight::Camera(camera) = &sensor.sight else {
        return Err(Message::new("server-no-camera").text("sensor", &of.name).into());
    };
    if !of.pitch_mm.is_finite() || of.pitch_mm <= 0.0 || !of.z_mm.is_finite() {
        let message = Message::new("server-grid").value("pitch", of.pitch_mm, Unit::Mm).value("z", of.z_mm, Unit::Mm);
        return Err(message.into());
    }
    let believed = nearest(&camera.table, -of.z_mm).map_err(|e| Refused::input(e.message()))?;
    Ok((sensor, believed))
}

fn nearest(table: &HeightTable, height: f64) -> Result<MapParameters, seamwright_geometry::HeightError> {
    let (low, high) = table.range();
    table.at(height.clamp(low, high)).map(|map| *map.parameters())
}

fn sensor<'a>(machine: &'a Machine, name: &str) -> Result<&'a Sensor, Refused> {
    let names = || machine.sensors.iter().map(|s| s.name.as_str()).collect::<Vec<_>>().join(", ");
    let found = machine.sensors.iter().find(|sensor| sensor.name == name);
    found.ok_or_else(|| Refused::input(Message::new("server-no-sensor").text("sensor", name).text("allowed", names())))
}

fn view(of: &OfCell, panel: &Panel) -> Result<SensorsView, Refused> {
    let sensors = sensors_view(&of.own, &of.machine)?;
    let simulated = of.machine.devices.is_empty();
    Ok(SensorsView { file: of.file(panel), pending: of.pending(panel), simulated, sensors })
}

pub(super) async fn sensors(State(panel): Shared) -> Answer<SensorsView> {
    panel.run(|panel| &panel.drawing, move |on| view(&of_cell(on)?, on)).await.map(Json)
}

pub(super) async fn picture(State(panel): Shared, Query(asked): Query<Plate>) -> Result<Response, Refused> {
    let painted = move |on: &Arc<Panel>| {
        let machine = of_cell(on)?.machine;
        let (sensor, believed) = camera(&machine, &asked)?;
        let count: usize = sensor.size_px.iter().product();
        if !machine.devices.is_empty() || count > MAX_PICTURE_PX {
            return Err(Message::new("server-not-simulated").count("max", MAX_PICTURE_PX).into());
        }
        let (image, _) = plate(&believed, asked.pitch_mm, asked.seed).map_err(|e| Refused::input(e.message()))?;
        let frame = image.frame().map_err(|e| Refused::server(e.message()))?;
        Overlay::of(&frame).png().map_err(Refused::server)
    };
    let png = panel.run(|panel| &panel.drawing, painted).await?;
    Ok(([(header::CONTENT_TYPE, "image/png")], png).into_response())
}

pub(super) async fn find(State(panel): Shared, Query(asked): Query<Plate>, png: Bytes) -> Answer<SensorAnswer> {
    let found = move |on: &Arc<Panel>| {
        let machine = of_cell(on)?.machine;
        let (sensor, believed) = camera(&machine, &asked)?;
        let most = MAX_PICTURE_PX.max(sensor.size_px.iter().product());
        Ok(match decode_up_to(&png, most) {
            Ok(image) => seen(&image, sensor, &believed, &asked),
            Err(e) => none("picture", vec![], e.message()),
        })
    };
    panel.run(|panel| &panel.drawing, found).await.map(Json)
}

fn none(verdict: &str, of: Vec<String>, message: Message) -> SensorAnswer {
    SensorAnswer { verdict: verdict.to_owned(), of, message: message.into(), ..SensorAnswer::default() }
}

fn seen(image: &Image, sensor: &Sensor, believed: &MapParameters, plate: &Plate) -> SensorAnswer {
    let frame = match image.frame() {
        Ok(frame) => frame,
        Err(e) => return none("picture", vec![], e.message()),
    };
    let (has, [width, height]) = ([frame.width(), frame.height()], sensor.size_px);
    if has != sensor.size_px {
        let of = [has, [width, height]].map(|size| format!("{} x {}", size[0], size[1]));
        let message = Message::new("server-picture-size").text("pixels", &of[0]).text("allowed", &of[1]);
        return none("size", of.to_vec(), message);
    }
    let grid = Grid { pitch_mm: plate.pitch_mm, centre_px: Some(believed.centre_px), limit_px: LIMIT_PX };
    let found = match identify(&frame, &grid) {
        Ok(found) => found,
        Err(e) => return refused(&e),
    };
    let mut is = *found.map.parameters();
    // A grid is ambiguous by quarter turns: the one nearest to the current map is chosen.
    let quarter = std::f64::consts::FRAC_PI_2;
    is.rotation += quarter * ((believed.rotation - is.rotation) / quarter).round();
    let change = ((is.mm_per_px - believed.mm_per_px) / believed.mm_per_px).abs().max_element();
    let far = change > FAR;
    let dot = |dot: &Dot| [dot.px.x, dot.px.y, dot.off_px.x, dot.off_px.y];
    SensorAnswer {
        verdict: if far { "far" } else { "good" }.to_owned(),
        of: if far { vec![format!("{:.0}", 100.0 * change)] } else { vec![] },
        message: if far {
            Message::new("server-scale-differs").quantity("difference", 100.0 * change, Unit::Percent, 0).into()
        } else {
            Message::default().into()
        },
        was: Some(height_view(plate.z_mm, believed)),
        found: Some(height_view(plate.z_mm, &is)),
        dots: found.dots.iter().map(dot).collect(),
        rms_px: found.rms_px,
        max_px: found.max_px,
    }
}

fn refused(e: &GridError) -> SensorAnswer {
    let (verdict, of) = match *e {
        GridError::Plain(part) => ("plain", vec![format!("{part:.1}")]),
        GridError::Few { found } => ("few", vec![found.to_string()]),
        GridError::Tangled { x, y } => ("tangled", vec![format!("{x:.0}"), format!("{y:.0}")]),
        GridError::Corner(part) => ("corner", vec![format!("{part:.0}")]),
        GridError::Residual { rms, max } => ("residual", vec![format!("{rms:.2}"), format!("{max:.2}")]),
        GridError::Pitch(_) | GridError::Map(_) => ("map", vec![]),
    };
    none(verdict, of, e.message())
}

pub(super) async fn keep(
    State(panel): Shared,
    session: Session,
    Json(asked): Json<SensorChange>,
) -> Answer<SensorsView> {
    let kept = move |panel: &Arc<Panel>| {
        let of = of_cell(panel)?;
        let name = &sensor(&of.machine, &asked.name)?.name;
        let before = of.own.text.clone();
        let mut text = before.clone();
        let (mut old, mut new) = (Vec::new(), Vec::new());
        for (key, numbers) in &asked.values {
            let own = OwnMachine { path: of.own.path.clone(), text };
            let (tables, last) = known(key, numbers)?;
            let table = steps(name, tables);
            old.push(format!("{key} {:?}", own.rows(&table, &[last])?.concat()));
            new.push(format!("{key} {numbers:?}"));
            let setting =
                if let [one] = numbers[..] { Setting::Number(Some(one)) } else { Setting::Row(numbers.clone()) };
            text = own.with(&table, &[(last, setting)])?;
        }
        if let Some(heights) = &asked.heights {
            let own = OwnMachine { path: of.own.path.clone(), text };
            let had = sensors_view(&of.own, &of.machine)?.into_iter().find(|s| s.name == *name);
            let had = had.map_or_else(Vec::new, |sensor| sensor.heights);
            old.push(format!("heights {had:?}"));
            new.push(format!("heights {heights:?}"));
            text = with_heights(&own, name, had.len(), heights)?;
        }
        let name = name.clone();
        let kept = of.keep(text)?;
        let view = view(&kept, panel)?;
        let part = ChangedPart { kind: Changed::Sensor, name: &name, file: &view.file };
        tell(panel, &session.user, part, Change { old: &old.join(", "), new: &new.join(", ") });
        Ok(view)
    };
    panel.run(|panel| &panel.planning, kept).await.map(Json)
}

/// Returns the tables and the key of a sensor's number, if one with this name and length exists.
fn known(key: &str, numbers: &[f64]) -> Result<(&'static [&'static str], &'static str), Refused> {
    let path = |(tables, key, ..): &(&[&str], &str, &str, u32)| [tables, &[*key][..]].concat().join(".");
    let Some(row) = SENSOR_KEYS.iter().find(|row| path(row) == key) else {
        let allowed: Vec<String> = SENSOR_KEYS.iter().map(path).collect();
        return Err(Message::new("server-no-sensor-key").text("key", key).text("allowed", allowed.join(", ")).into());
    };
    if !numbers.is_empty() && numbers.len() != row.3 as usize {
        return Err(Message::new("server-number-count")
            .text("key", key)
            .count("n", numbers.len())
            .count("allowed", row.3 as usize)
            .into());
    }
    Ok((row.0, row.1))
}

/// Returns the text with these planes. If their number is unchanged they are changed individually, which keeps comments
/// between them.
fn with_heights(own: &OwnMachine, name: &str, had: usize, heights: &[HeightView]) -> Result<String, Refused> {
    if heights.len() > MAX_HEIGHTS {
        return Err(Message::new("server-too-many-planes").count("n", heights.len()).count("max", MAX_HEIGHTS).into());
    }
    let rows: Vec<Vec<(&str, Setting)>> = heights.iter().map(row).collect();
    let map = steps(name, &["map"]);
    if rows.len() != had {
        return Ok(own.with(&map, &[("heights", Setting::Tables(rows))])?);
    }
    let mut own = OwnMachine { path: own.path.clone(), text: own.text.clone() };
    for (i, row) in rows.iter().enumerate() {
        own.text = own.with(&[&map[..], &[Step::Nth("heights", i)]].concat(), row)?;
    }
    Ok(own.text)
}

/// Returns a plane as entries of the file: zeros are left out.
fn row(of: &HeightView) -> Vec<(&'static str, Setting)> {
    let number = |v: f64| Setting::Number((v != 0.0).then_some(v));
    vec![
        ("z_mm", Setting::Number(Some(of.z_mm))),
        ("mm_per_px", Setting::Row(of.mm_per_px.to_vec())),
        ("centre_px", Setting::Row(of.centre_px.map_or_else(Vec::new, |c| c.to_vec()))),
        ("rotation_deg", number(of.rotation_deg)),
        ("shear", number(of.shear)),
        ("barrel", number(of.barrel)),
    ]
}
