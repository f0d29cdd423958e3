//! Seams that curve through space.

use crate::allowed::{at_most, more_than, not_along};
use crate::body::tube;
use seamwright_document::{Document, DocumentError};
use seamwright_geometry::{self as geometry, CurvedEdge, FaceRule};
use seamwright_message::{Message, Unit};
use seamwright_program::{FilletOrButt, Helix, WallFaces};

/// Maximum number of turns of a helix.
const MAX_TURNS: f64 = 1000.0;

/// The edge of a seam along a helix, by the angle about its axis.
pub(crate) fn helix<T>(file: &Document<T>, h: &Helix) -> Result<CurvedEdge<geometry::Helix>, DocumentError> {
    let wrong =
        |k: &str, message: Message, allowed: Message| file.error_at(&format!("seam.helix.{k}"), message, allowed);
    let (about, axis) = (h.origin_mm.get(), h.direction.unit());
    let tube = tube(about, axis, h.zero_direction, h.radius_mm.get())
        .map_err(|e| wrong("zero_direction", e.message(), not_along("direction")))?;
    if h.pitch_mm.get().abs() <= 0.0 {
        return Err(wrong("pitch_mm", Message::new("weld-helix-without-pitch"), Message::new("weld-allowed-pitch")));
    }
    if h.turns.get() > MAX_TURNS {
        return Err(wrong("turns", Message::new("weld-helix-too-long"), at_most(MAX_TURNS, Unit::One)));
    }
    let curve = geometry::Helix::new(tube, h.pitch_mm.get(), h.turns.get())
        .map_err(|e| wrong("turns", e.message(), more_than(0.0, Unit::One)))?;
    let left = h.wall_faces == WallFaces::Left;
    let faces = match h.joint {
        FilletOrButt::Fillet => FaceRule::WallOnCylinder { about, axis, left },
        FilletOrButt::Butt => FaceRule::Cylinder { about, axis },
    };
    Ok(CurvedEdge { curve, faces })
}
