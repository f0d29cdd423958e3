//! Machine files of arms that are described elsewhere: URDF files, parameters of Denavit and Hartenberg, and the seven
//! lengths of ortho-parallel arms.
//!
//! Each source becomes an [`ImportedArm`], whose [text](ImportedArm::to_toml) is a machine file to read and edit: all
//! axes in the base frame with all positions at zero, as in the supplied files of arms.

mod angle;
mod axis_names;
mod dh;
mod home;
mod parts;
mod serial;
mod text;
mod urdf;
mod xml;

pub use dh::{DhConvention, DhRow, OpwArm};
use glam::{DAffine3, DVec3};
use seamwright_clearance::SolidFile;
use seamwright_document::DocumentError;
use seamwright_message::Message;

/// Part of the speed that an axis gains in a second, 1/s: sources have no accelerations, and supplied arms reach full
/// speed in a quarter of a second.
const ACCELERATION_PER_SPEED: f64 = 4.0;
/// Part of the acceleration that an axis gains in a second, 1/s.
const JERK_PER_ACCELERATION: f64 = 10.0;

/// A serial arm as it is written into a machine file; lengths in mm, angles in rad, in the base frame with all axes at
/// zero.
#[derive(Debug, Clone, PartialEq)]
pub struct ImportedArm {
    /// Short name: lower-case letters, digits, `-` and `_`.
    pub name: String,
    /// Title, for people.
    pub title: String,
    /// Source of the values, for a comment.
    pub source: String,
    /// Axes from the base to the flange.
    pub axes: Vec<ImportedAxis>,
    /// The flange.
    pub flange: DAffine3,
    /// Name of the flange in its source, for a comment.
    pub flange_name: String,
    /// The torch's frame in the flange's.
    pub tool: Option<DAffine3>,
    /// Direction of wire or beam in the torch's frame, or in the flange's without a tool.
    pub direction: DVec3,
    /// The work frame.
    pub work: DAffine3,
    /// Shapes for collision checks.
    pub shapes: Vec<ImportedShape>,
    /// Pairs of links that may touch.
    pub ignored: Vec<[String; 2]>,
    /// Parts of the source that the file does not contain, and assumptions.
    pub notes: Vec<Message>,
}

/// An axis of an imported arm.
#[derive(Debug, Clone, PartialEq)]
pub struct ImportedAxis {
    /// Name in the machine file.
    pub name: String,
    /// Name in the source.
    pub source_name: String,
    /// True for a rotary axis.
    pub is_rotary: bool,
    /// Unit direction.
    pub direction: DVec3,
    /// A point on it.
    pub at: DVec3,
    /// Lowest and highest position, mm or rad; none for a continuous axis.
    pub range: Option<[f64; 2]>,
    /// Position after homing, mm or rad.
    pub home: f64,
    /// Maximum speed, mm/s or rad/s.
    pub max_speed: f64,
    /// Maximum torque, N m, or force, N, if the source has one.
    pub effort: Option<f64>,
}

/// A shape of an imported arm.
#[derive(Debug, Clone, PartialEq)]
pub struct ImportedShape {
    /// Its link: `base` or the name of an axis.
    pub link: String,
    /// The shape in the base frame with all axes at zero.
    pub solid: SolidFile,
}

/// A mesh that an URDF file names, as found.
#[derive(Debug, Clone, PartialEq)]
pub struct FoundMesh {
    /// Name for the machine file: relative to it.
    pub name: String,
    /// Its content.
    pub bytes: Vec<u8>,
}

/// Choices of an import.
pub struct ImportOptions<'a> {
    /// Link at the base; the root if missing.
    pub base: Option<&'a str>,
    /// Link at the end; the only one, or `tool0` of several, if missing.
    pub tip: Option<&'a str>,
    /// Factor on all lengths of the source.
    pub scale: f64,
    /// True if shapes for collision checks are read.
    pub with_shapes: bool,
    /// Finds a mesh by its name in the source, or returns the names of the files that were looked for.
    pub find_mesh: &'a dyn Fn(&str) -> Result<FoundMesh, Vec<String>>,
}

impl ImportedArm {
    /// Reads the chain of a URDF file from its base to a link at its end.
    ///
    /// # Errors
    /// The first error, with line, element and cure: invalid XML, unknown or repeated names, several ends, joints
    /// without limits or that follow others, missing meshes, lengths and angles in other units.
    pub fn from_urdf(file: &str, text: &str, options: &ImportOptions<'_>) -> Result<Self, DocumentError> {
        serial::arm(&urdf::read(file, text)?, options)
    }
}

/// Name with lower-case letters, digits, `-` and `_` only; `arm` if nothing is left.
fn plain_name(name: &str) -> String {
    let plain = |c: char| match c.to_ascii_lowercase() {
        c if c.is_ascii_alphanumeric() || c == '-' || c == '_' => c,
        _ => '-',
    };
    let name: String = name.chars().map(plain).collect();
    let name = name.trim_matches('-');
    if name.is_empty() { "arm".to_owned() } else { name.to_owned() }
}
