//! Shapes on links, and zones.

use crate::file::{File, Load, ZoneKind};
use crate::links::Links;
use crate::solids::{LinkSolids, Zone};
use seamwright_clearance::{Solid, SolidFile};
use seamwright_document::{DocumentError, Positive};
use seamwright_message::Message;

/// Names of the groups that a job adds to the machine.
const FROM_JOB: [&str; 2] = ["part", "fixtures"];

/// Default minimum distance of two links, mm.
const MIN_LINK_DISTANCE_MM: f64 = 5.0;

/// Default minimum distance from a zone's surface, mm.
const MIN_ZONE_MARGIN_MM: f64 = 1.0;

pub(super) fn solids(file: &File, links: &Links, load: Load) -> Result<LinkSolids, DocumentError> {
    let m = &file.value;
    let mut all = LinkSolids {
        solids: Vec::new(),
        least_mm: m.clearance.least_mm.map_or(MIN_LINK_DISTANCE_MM, Positive::get),
        ignored: Vec::new(),
        zones: Vec::new(),
    };
    for (name, shapes) in &m.shapes {
        let path = format!("shapes.{name}");
        let frame = links.frame(name).ok_or_else(|| unknown(file, links, &path, name, &[]))?;
        for solid in build(file, &path, shapes, load)? {
            let named = format!("{name}: {}", solid.name());
            let placed = Solid::new(named, solid.shape().clone(), frame.zero * *solid.pose());
            all.solids.push((frame.link, placed.map_err(|e| file.error_at(&path, &e, ""))?));
        }
    }
    for (i, pair) in m.clearance.ignore.iter().enumerate() {
        let [a, b] = [0, 1].map(|k| {
            let path = format!("clearance.ignore[{i}][{k}]");
            links.frame(&pair[k]).map(|f| f.link).ok_or_else(|| unknown(file, links, &path, &pair[k], &[]))
        });
        all.ignored.push((a?, b?));
    }
    for (i, zone) in m.zones.iter().enumerate() {
        let path = format!("zones[{i}]");
        let on = zone.on.as_deref().unwrap_or("base");
        let frame = links.frame(on).ok_or_else(|| unknown(file, links, &format!("{path}.on"), on, &[]))?;
        for (k, name) in zone.watch.iter().flatten().enumerate() {
            if links.frame(name).is_none() && !FROM_JOB.contains(&name.as_str()) {
                return Err(unknown(file, links, &format!("{path}.watch[{k}]"), name, &FROM_JOB));
            }
            let bare = |f: &crate::links::NamedFrame| !all.solids.iter().any(|(link, _)| *link == f.link);
            if links.frame(name).is_some_and(bare) {
                let message = Message::new("machine-zone-watches-nothing").text("link", name);
                let allowed = Message::new("machine-shapes-first").text("link", name);
                return Err(file.error_at(&format!("{path}.watch[{k}]"), message, allowed));
            }
        }
        if zone.solids.is_empty() {
            return Err(file.fault_at(&format!("{path}.solids"), "machine-zone-empty", "machine-zone-solids"));
        }
        let mut placed = Vec::new();
        for (k, solid) in build(file, &format!("{path}.solids"), &zone.solids, load)?.into_iter().enumerate() {
            let key = format!("{path}.solids[{k}]");
            if zone.kind == ZoneKind::Permitted && !solid.is_zone() {
                let message = Message::new("machine-zone-shape");
                return Err(file.error_at(&key, message, "box, cylinder, sphere, half_space"));
            }
            let moved = Solid::new(zone.name.clone(), solid.shape().clone(), frame.zero * *solid.pose());
            placed.push(moved.map_err(|e| file.error_at(&key, &e, ""))?);
        }
        all.zones.push(Zone {
            name: zone.name.clone(),
            kind: zone.kind,
            link: frame.link,
            watch: zone.watch.clone(),
            least_mm: zone.least_mm.map_or(MIN_ZONE_MARGIN_MM, Positive::get),
            solids: placed,
        });
    }
    Ok(all)
}

fn build(file: &File, path: &str, shapes: &[SolidFile], load: Load) -> Result<Vec<Solid>, DocumentError> {
    shapes.iter().enumerate().map(|(i, s)| s.build(file, &format!("{path}[{i}]"), load)).collect()
}

fn unknown(file: &File, links: &Links, path: &str, name: &str, more: &[&str]) -> DocumentError {
    let names = links.named().iter().map(|f| f.name.as_str()).chain(more.iter().copied());
    file.unknown_name(path, name, &names.collect::<Vec<_>>())
}
