use glam::DVec2;
use seamwright_geometry::{MapError, PlaneMap};
use seamwright_message::{Message, Unit, display_by_message};

/// Minimum dots of a usable picture.
pub(crate) const FEWEST_DOTS: usize = 25;

/// A grid of dark dots on a lighter plate, perpendicular to the optical axis, with rows and columns at right angles.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grid {
    /// Distance between neighbouring dots, mm.
    pub pitch_mm: f64,
    /// Pixel where the optical axis meets the plate; the frame's middle if `None`.
    pub centre_px: Option<DVec2>,
    /// Maximum RMS distance of the dots from the map, pixels; above it the picture is rejected.
    pub limit_px: f64,
}

/// A map and how well it fits the picture.
#[derive(Debug, Clone, PartialEq)]
pub struct Identified {
    /// The map.
    pub map: PlaneMap,
    /// The dots that were found.
    pub dots: Vec<Dot>,
    /// RMS distance of the dots from their positions by the map, pixels.
    pub rms_px: f64,
    /// Maximum of these distances, pixels.
    pub max_px: f64,
}

/// A dot of the grid in the picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dot {
    /// Detected position, pixels.
    pub px: DVec2,
    /// Offset from the detected position to the position by the map, pixels.
    pub off_px: DVec2,
}

/// Reason why a picture gives no map.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum GridError {
    /// Invalid pitch.
    Pitch(f64),
    /// Too little contrast.
    Plain(f64),
    /// Too few connected dots.
    Few {
        /// Number of dots found.
        found: usize,
    },
    /// Two paths through the grid assign different crossings to one dot.
    Tangled {
        /// Pixels to the right, in the picture.
        x: f64,
        /// Pixels down, in the picture.
        y: f64,
    },
    /// The dots cover only a part of the frame.
    Corner(f64),
    /// The dots fit no map.
    Residual {
        /// RMS distance, pixels.
        rms: f64,
        /// Maximum distance, pixels.
        max: f64,
    },
    /// The fitted parameters form an invalid map.
    Map(MapError),
}

display_by_message!(GridError);

impl From<MapError> for GridError {
    fn from(error: MapError) -> Self {
        Self::Map(error)
    }
}

impl GridError {
    /// Returns the description of the reason.
    pub fn message(&self) -> Message {
        let new = Message::new;
        match *self {
            Self::Pitch(pitch) => new("vision-grid-pitch").value("pitch", pitch, Unit::Mm),
            Self::Plain(part) => new("vision-grid-plain").quantity("contrast", part, Unit::Percent, 1),
            Self::Few { found } => new("vision-grid-few-dots").count("found", found).count("min", FEWEST_DOTS),
            Self::Tangled { x, y } => new("vision-grid-tangled").number("x", x, 0).number("y", y, 0),
            Self::Corner(part) => new("vision-grid-corner").quantity("part", part, Unit::Percent, 0),
            Self::Residual { rms, max } => {
                new("vision-grid-residual").quantity("rms", rms, Unit::Px, 2).quantity("max", max, Unit::Px, 2)
            }
            Self::Map(error) => new("vision-grid-map").message("why", error.message()),
        }
    }
}
