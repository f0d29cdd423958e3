//! Arguments of `seamwright machine import` and `machine new`.

use clap::Args;
use glam::{DAffine3, DMat3, DVec3};
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
    /// Name of the machine; that of the source if missing
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

pub(crate) fn numbers(text: &str) -> Option<Vec<f64>> {
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
