//! Arguments of `seamwright machine import` and `machine new`.

use clap::{Args, Subcommand};
use glam::{DAffine3, DMat3, DVec3};
use seamwright_machine::DhRow;
use std::path::PathBuf;

#[derive(Debug, Args)]
#[command(after_help = "Example: seamwright machine import robot.urdf --tool 90,0,330,0,35,0 -o robot.toml
Lengths of URDF are in metres and angles in rad; machine files are in mm and degrees.
Exit code 2 if the file is invalid, with line, element and cure.")]
pub(crate) struct ImportArgs {
    /// URDF file; expand xacro files first
    pub(crate) file: PathBuf,
    /// Link at the base; the root of the tree if missing
    #[arg(long, value_name = "LINK")]
    pub(crate) base: Option<String>,
    /// Link that carries the torch; the only end of the tree, or `tool0` of several, if missing
    #[arg(long, value_name = "LINK")]
    pub(crate) tip: Option<String>,
    /// Factor on all lengths: 0.001 for a file in mm
    #[arg(long, default_value_t = 1.0, value_name = "F")]
    pub(crate) scale: f64,
    /// Folder of a package that meshes are in, as `--package ur_description=../ur`; repeatable
    #[arg(long, value_name = "NAME=DIR", value_parser = package)]
    pub(crate) package: Vec<Package>,
    /// Leave out shapes for collision checks
    #[arg(long)]
    pub(crate) no_shapes: bool,
    #[command(flatten)]
    pub(crate) arm: ArmArgs,
}

#[derive(Debug, Args)]
#[command(after_help = "Example: seamwright machine new arm --opw 150,-115,0,445,700,795,85 -o arm.toml")]
pub(crate) struct NewArgs {
    #[command(subcommand)]
    pub(crate) kind: NewKind,
}

#[derive(Debug, Subcommand)]
pub(crate) enum NewKind {
    /// Write the machine file of an arm from its parameters
    Arm(Box<NewArmArgs>),
}

#[derive(Debug, Args)]
#[command(group(clap::ArgGroup::new("parameters").required(true).args(["dh", "opw"])),
    after_help = "Examples:
  seamwright machine new arm --opw 150,-115,0,445,700,795,85 --offsets-deg 0,0,-90,0,0,0 -o arm.toml
  seamwright machine new arm --dh '0,90,180.7,0; -612.7,0,0,0; -571.55,0,0,0; 0,90,174.15,0; 0,-90,119.85,0; 0,0,116.55,0'
Ranges of ±180 degrees (±1000 mm) and speeds of 180 deg/s (500 mm/s) are assumed where none are given.")]
pub(crate) struct NewArmArgs {
    /// Rows of Denavit and Hartenberg: a, alpha, d, theta in mm and degrees, a row for each axis; `linear` as fifth value
    /// for a linear axis
    #[arg(long, value_name = "A,ALPHA,D,THETA;..", value_delimiter = ';', value_parser = dh_row, allow_hyphen_values = true)]
    pub(crate) dh: Vec<DhRow>,
    /// The rows are Craig's: about and along x before about and along z
    #[arg(long, requires = "dh")]
    pub(crate) modified: bool,
    /// Lengths of an ortho-parallel arm with a spherical wrist, mm
    #[arg(long, value_name = "A1,A2,B,C1,C2,C3,C4", value_parser = seven, allow_hyphen_values = true)]
    pub(crate) opw: Option<[f64; 7]>,
    /// Offsets of its axes: the model's angle is the sign times the position, less the offset
    #[arg(long, value_name = "O1,..,O6", value_parser = six, allow_hyphen_values = true, requires = "opw")]
    pub(crate) offsets_deg: Option<[f64; 6]>,
    /// Signs of its axes, 1 or -1
    #[arg(long, value_name = "S1,..,S6", value_parser = signs, allow_hyphen_values = true, requires = "opw")]
    pub(crate) signs: Option<[f64; 6]>,
    /// Range of every axis, degrees or mm
    #[arg(long, value_name = "LOW,HIGH;..", value_delimiter = ';', value_parser = pair, allow_hyphen_values = true)]
    pub(crate) ranges: Vec<[f64; 2]>,
    /// Highest speed of every axis, degrees/s or mm/s
    #[arg(long, value_name = "V,V,..", value_delimiter = ',')]
    pub(crate) speeds: Vec<f64>,
    #[command(flatten)]
    pub(crate) arm: ArmArgs,
}

/// The folder of a package.
#[derive(Debug, Clone)]
pub(crate) struct Package {
    pub(crate) name: String,
    pub(crate) folder: PathBuf,
}

/// Options of every new file of an arm.
#[derive(Debug, Args)]
pub(crate) struct ArmArgs {
    /// The torch's frame in the flange's: mm, then roll, pitch and yaw about fixed x, y and z, degrees
    #[arg(long, value_name = "X,Y,Z[,ROLL,PITCH,YAW]", value_parser = frame, allow_hyphen_values = true)]
    pub(crate) tool: Option<DAffine3>,
    /// Direction of wire or beam in the torch's frame
    #[arg(long, default_value = "0,0,1", value_name = "X,Y,Z", value_parser = direction, allow_hyphen_values = true)]
    pub(crate) direction: DVec3,
    /// The work frame in the base frame, as --tool; the base frame if missing
    #[arg(long, value_name = "X,Y,Z[,ROLL,PITCH,YAW]", value_parser = frame, allow_hyphen_values = true)]
    pub(crate) work: Option<DAffine3>,
    /// Home position of every axis, mm or degrees; away from singularities and collisions if missing
    #[arg(long, value_name = "A,B,..", value_delimiter = ',', allow_hyphen_values = true)]
    pub(crate) home: Vec<f64>,
    /// Name and title of the machine; those of the source if missing
    #[arg(long)]
    pub(crate) name: Option<String>,
    /// Machine file; standard output if missing
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,
}

fn package(text: &str) -> Result<Package, String> {
    let (name, folder) = text.split_once('=').ok_or("NAME=DIR")?;
    Ok(Package { name: name.to_owned(), folder: PathBuf::from(folder) })
}

fn numbers(text: &str) -> Option<Vec<f64>> {
    let finite = |n: &str| n.trim().parse().ok().filter(|n: &f64| n.is_finite());
    text.split(',').map(finite).collect()
}

fn frame(text: &str) -> Result<DAffine3, String> {
    match numbers(text).as_deref() {
        Some([x, y, z]) => Ok(DAffine3::from_translation(DVec3::new(*x, *y, *z))),
        Some([x, y, z, roll, pitch, yaw]) => {
            let [roll, pitch, yaw] = [roll, pitch, yaw].map(|angle| angle.to_radians());
            let turned = DMat3::from_rotation_z(yaw) * DMat3::from_rotation_y(pitch) * DMat3::from_rotation_x(roll);
            Ok(DAffine3 { matrix3: turned, translation: DVec3::new(*x, *y, *z) })
        }
        _ => Err("three lengths, or three lengths and three angles".to_owned()),
    }
}

fn direction(text: &str) -> Result<DVec3, String> {
    let given = numbers(text).and_then(|numbers| <[f64; 3]>::try_from(numbers).ok());
    let unit = given.and_then(|v| DVec3::from_array(v).try_normalize());
    unit.ok_or_else(|| "three finite numbers X,Y,Z, not all 0".to_owned())
}

fn array<const N: usize>(text: &str) -> Result<[f64; N], String> {
    let given = numbers(text).and_then(|numbers| <[f64; N]>::try_from(numbers).ok());
    given.ok_or_else(|| format!("finite numbers with commas between them; count: {N}"))
}

fn seven(text: &str) -> Result<[f64; 7], String> {
    array(text)
}

fn six(text: &str) -> Result<[f64; 6], String> {
    array(text)
}

fn signs(text: &str) -> Result<[f64; 6], String> {
    let signs: [f64; 6] = array(text)?;
    if signs.iter().all(|sign| (sign.abs() - 1.0).abs() < f64::EPSILON) {
        Ok(signs)
    } else {
        Err("six numbers 1 or -1".to_owned())
    }
}

fn pair(text: &str) -> Result<[f64; 2], String> {
    let [low, high] = array(text)?;
    if low < high { Ok([low, high]) } else { Err("LOW,HIGH with LOW below HIGH".to_owned()) }
}

fn dh_row(text: &str) -> Result<DhRow, String> {
    let (row, is_linear) = match text.trim().strip_suffix(",linear") {
        Some(row) => (row, true),
        None => (text, false),
    };
    let [a, alpha, d, theta] = array(row).map_err(|_| "A,ALPHA,D,THETA in mm and degrees".to_owned())?;
    Ok(DhRow { a, alpha: alpha.to_radians(), d, theta: theta.to_radians(), is_linear })
}
