use glam::{DAffine3, DVec3};
use seamwright_message::{Message, Unit};
use std::fmt;

/// A small rigid motion that measured points do not determine.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Motion {
    /// Moving along a unit vector.
    Along(DVec3),
    /// Turning about the axis through a point, and moving along it by `pitch` mm a turn.
    #[allow(missing_docs, reason = "the fields say what they are")]
    About { point: DVec3, direction: DVec3, pitch: f64 },
}

impl Motion {
    /// The same motion in another frame; `map` is rigid.
    pub(crate) fn mapped(self, map: &DAffine3) -> Self {
        match self {
            Self::Along(direction) => Self::Along(positive(map.transform_vector3(direction))),
            Self::About { point, direction, pitch } => {
                let (point, direction) = (map.transform_point3(point), positive(map.transform_vector3(direction)));
                Self::About { point, direction, pitch }
            }
        }
    }
}

/// A pitch that is rounding, mm a turn.
const NO_PITCH_MM: f64 = 1e-3;

impl Motion {
    /// Returns the description of the motion.
    pub fn message(&self) -> Message {
        // `+ 0.0` turns a rounded negative zero into zero.
        let round = |v: f64, digits: f64| (v * digits).round() / digits + 0.0;
        let vector = |v: DVec3, d: f64| format!("({}, {}, {})", round(v.x, d), round(v.y, d), round(v.z, d));
        match self {
            Self::Along(direction) => Message::new("geometry-motion-along").text("direction", vector(*direction, 1e4)),
            Self::About { point, direction, pitch } => {
                let screw = pitch.abs() > NO_PITCH_MM;
                let code = if screw { "geometry-motion-screw" } else { "geometry-motion-about" };
                let message =
                    Message::new(code).text("direction", vector(*direction, 1e4)).text("point", vector(*point, 1e2));
                if screw { message.value("pitch", round(*pitch, 1e2), Unit::Mm) } else { message }
            }
        }
    }
}

impl fmt::Display for Motion {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        self.message().fmt(f)
    }
}

/// The direction or its opposite, whichever has its largest part positive: messages then do not depend on rounding.
pub(crate) fn positive(v: DVec3) -> DVec3 {
    let largest = v.to_array().into_iter().max_by(|a, b| a.abs().total_cmp(&b.abs()));
    if largest.is_some_and(|x| x < 0.0) { -v } else { v }
}
