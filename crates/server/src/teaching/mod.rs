//! Teaching by camera on the cell's machine: a separate thread follows the joint and moves the axes by jog commands.
//!
//! Frames come from the machine's camera, at the address in its file. A simulated cell without live frames uses the
//! camera simulator: it shows the seam, distorted by a seed, from the true axis positions.
//! The machine moves only while the page that opened the session has control and sends heartbeats. Jogging by hand
//! pauses the session.

mod axis_motion;
mod cameras;
mod crawl;
mod program;
mod rig;
mod state;

pub(crate) use cameras::Cameras;
#[cfg(test)]
pub(crate) use crawl::DISTORTION;
pub(crate) use program::program;
pub(crate) use state::{Open, Teaching};

use crate::http::Panel;
use crate::refusal::{Lack, lack};
use crate::wire::TeachOrder;
use glam::{DVec2, DVec3};
use seamwright_machine::Machine;
use seamwright_message::{Message, Unit};
use state::Wish;
use std::sync::Arc;

/// Minimum and maximum step between frames, mm.
const STEPS_MM: (f64, f64) = (1.0, 100.0);
/// Maximum length of a tack that may be passed without asking, mm.
const MAX_TACK_MM: f64 = 100.0;

/// Handles an order of the page `station`, which has control.
/// Fails if the order is invalid in this phase, or its numbers are not allowed.
pub(crate) fn order(panel: &Arc<Panel>, station: u32, order: &TeachOrder) -> Result<(), Lack> {
    let teaching = &panel.teaching;
    match order {
        TeachOrder::Open { .. } => open(panel, station, order),
        TeachOrder::Here { px, at } => {
            let point = match (px, at) {
                (Some(px), None) => teaching.seen_at(DVec2::from_array(*px)),
                (None, Some(at)) => Some(DVec3::from_array(*at)),
                (None, None) => teaching.middle(),
                _ => return Err(lack("value", Message::new("server-teach-point"))),
            };
            let point = point.ok_or_else(|| lack("value", Message::new("server-teach-no-work")))?;
            teaching.here(station, point)
        }
        TeachOrder::End {} => teaching.end_here(),
        TeachOrder::Pause {} => teaching.pause("operator"),
        TeachOrder::Resume {} => teaching.resume(station),
        TeachOrder::Stop {} => teaching.wish(Wish::Stop),
    }
}

fn open(panel: &Arc<Panel>, station: u32, order: &TeachOrder) -> Result<(), Lack> {
    let TeachOrder::Open { step_mm, longest_tack_mm, seed, tack_mm } = *order else {
        return Err(lack("value", Message::new("server-teach-order")));
    };
    for (what, value, (least, most)) in
        [("step_mm", step_mm, STEPS_MM), ("longest_tack_mm", longest_tack_mm, (f64::MIN_POSITIVE, MAX_TACK_MM))]
    {
        if !(least..=most).contains(&value) {
            return Err(lack(
                "value",
                Message::new("server-teach-range")
                    .key("key", what)
                    .value("value", value, Unit::Mm)
                    .quantity("min", least, Unit::Mm, 0)
                    .value("max", most, Unit::Mm),
            ));
        }
    }
    if tack_mm.is_some_and(|(from, to)| !(from.is_finite() && to.is_finite() && from < to)) {
        return Err(lack("value", Message::new("server-teach-tack")));
    }
    let sees = |machine: &Machine| machine.devices.is_empty() || machine.sensors.iter().any(|s| s.frames.is_some());
    if !panel.cell.hub.machine().is_some_and(|machine| sees(&machine)) {
        return Err(lack("work", Message::new("server-teach-real-devices")));
    }
    let work = panel.cell.hub.work();
    let work = work.ok_or_else(|| lack("work", Message::new("server-teach-no-program")))?;
    panel.teaching.open(&panel.cell.hub, station, &work)?;
    let open = Open { job: work.job.clone(), step_mm, longest_tack_mm, seed, tack_mm };
    let panel = Arc::clone(panel);
    std::thread::spawn(move || crawl::run(&panel, &open));
    Ok(())
}
