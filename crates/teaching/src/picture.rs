//! The last frame with the joint found in it, as in Fig. 4 of EBW-2004.

use crate::events::Command;
use crate::run::Look;
use crate::settings::Settings;
use crate::work_shape::Row;
use glam::{DVec2, DVec3};
use seamwright_frames::{COASTED, CROSS, MOTION, Overlay, ZONE, sureness};
use seamwright_geometry::HeightTable;
use seamwright_message::Message;
use seamwright_vision::Image;

/// Half the length of an arm of the cross, and of the mark at the start of the midline, pixels.
const ARMS: (i32, f64) = (14, 24.0);
/// Two pixels thick.
const THICK: [f64; 2] = [0.0, 1.0];

/// A frame and its overlay, pixels.
pub struct Picture {
    image: Image,
    rows: Vec<Row>,
    aim: Option<(DVec2, DVec2)>,
    /// The middle of the beam or of the camera.
    cross: Option<DVec2>,
    /// Target of the next move.
    to: Option<DVec2>,
}

impl Picture {
    /// The picture of `look`, with the map `table` of the camera.
    pub fn of(look: &Look, table: &HeightTable) -> Self {
        let back = look.view.camera.inverse();
        let to = match look.next {
            Command::Move(pose) => table.to_px(back.transform_point3(pose.point)).ok(),
            _ => None,
        };
        Self {
            image: look.frame.image.clone(),
            rows: look.found.rows.clone(),
            aim: look.aim.map(|aim| (aim.start, aim.direction)),
            cross: table.to_px(DVec3::Z * look.view.height.unwrap_or(0.0)).ok(),
            to,
        }
    }

    /// A frame without a search, of work at `height` (mm in the camera's frame): the cross alone.
    pub fn plain(image: Image, table: &HeightTable, height: f64) -> Self {
        Self { image, rows: Vec::new(), aim: None, cross: table.to_px(DVec3::Z * height).ok(), to: None }
    }

    /// As PNG.
    ///
    /// # Errors
    /// An invalid frame.
    pub fn png(&self) -> Result<Vec<u8>, Message> {
        let frame = self.image.frame().map_err(|e| e.message())?;
        let mut picture = Overlay::of(&frame);
        let least = Settings::default().confidence;
        for pair in self.rows.windows(2) {
            let colour = if pair[1].seen { sureness(pair[1].confidence, least) } else { COASTED };
            picture.line(pair[0].px, pair[1].px, &[-1.0, 0.0, 1.0], colour);
        }
        if let Some((start, direction)) = self.aim {
            // The follower has no zone of its own: the whole frame is.
            picture.zone(DVec2::ZERO, DVec2::new((frame.width() - 1) as f64, (frame.height() - 1) as f64));
            let across = 0.5 * ARMS.1 * direction.perp();
            picture.line(start - across, start + across, &THICK, ZONE);
            picture.line(start, start + ARMS.1 * direction, &THICK, ZONE);
        }
        if let Some(cross) = self.cross {
            picture.cross(cross, CROSS, ARMS.0);
            if let Some(to) = self.to {
                // Beside the midline, so that neither hides the other.
                let aside = 10.0 * (to - cross).perp().normalize_or_zero();
                picture.arrow(cross + aside, to + aside, MOTION);
            }
        }
        picture.png()
    }
}
