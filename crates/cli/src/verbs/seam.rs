use super::positive;
use crate::args::SeamArgs;
use crate::failure::Failure;
use crate::load::load;
use crate::rows::{Cell, Rows};
use seamwright_weld::{SeamCurve, SeamPoint};

const COLUMNS: [&str; 18] = [
    "s_mm",
    "phi_deg",
    "x_mm",
    "y_mm",
    "z_mm",
    "tx",
    "ty",
    "tz",
    "n1x",
    "n1y",
    "n1z",
    "n2x",
    "n2y",
    "n2z",
    "bx",
    "by",
    "bz",
    "dihedral_deg",
];

/// Points when the command line does not say.
const POINTS: u32 = 101;

pub(crate) fn run(args: &SeamArgs) -> Result<(), Failure> {
    let loaded = load(&args.job)?;
    let seam = &loaded.welding.seam;
    let length = seam.weld_length();
    let places = places(args, seam)?;
    let mut rows = Rows::new(COLUMNS.iter().map(|c| (*c).to_owned()).collect(), args.json)?;
    match places {
        Places::Angles(angles) => {
            for (s, phi) in angles {
                // The angle as asked for, not counted on from the start.
                write(&mut rows, &seam.at(s), Some(phi))?;
            }
        }
        Places::Steps { step, whole } => {
            for i in 0..=whole {
                write(&mut rows, &seam.at(i as f64 * step), None)?;
            }
            write(&mut rows, &seam.at(length), None)?;
        }
        Places::Points(n) => {
            for i in 0..n {
                write(&mut rows, &seam.at(length * f64::from(i) / f64::from(n - 1)), None)?;
            }
        }
    }
    rows.finish()
}

/// Where points are asked for.
enum Places {
    /// Path lengths with their angles, degrees.
    Angles(Vec<(f64, f64)>),
    /// Every `step` mm, `whole` times, and the end.
    Steps { step: f64, whole: u64 },
    /// So many at equal distances.
    Points(u32),
}

fn places(args: &SeamArgs, seam: &SeamCurve) -> Result<Places, Failure> {
    let length = seam.weld_length();
    if let Some(angles) = &args.phi_deg {
        let place = |phi: &f64| {
            let s = Some(phi).filter(|p| p.is_finite()).and_then(|p| seam.s_of_phi(p.to_radians()));
            let s = s.ok_or_else(|| Failure::Input(format!("--phi-deg {phi}: this seam has no such angle")))?;
            if s > length + 1e-9 {
                return Err(Failure::Input(format!("--phi-deg {phi}: this angle is not on the part that is welded")));
            }
            Ok((s, *phi))
        };
        return angles.iter().map(place).collect::<Result<_, _>>().map(Places::Angles);
    }
    if let Some(step) = args.every_mm {
        let step = positive("--every-mm", step)?;
        return Ok(Places::Steps { step, whole: (length / step - 1e-9).floor() as u64 });
    }
    match args.points.unwrap_or(POINTS) {
        n @ 0..2 => Err(Failure::Input(format!("--points {n}: not allowed\n   allowed: 2 or more"))),
        n => Ok(Places::Points(n)),
    }
}

fn write(rows: &mut Rows, p: &SeamPoint, asked_phi: Option<f64>) -> Result<(), Failure> {
    let phi = asked_phi.or(p.phi.map(f64::to_degrees)).map_or(Cell::Empty, Cell::Number);
    let mut cells = vec![Cell::Number(p.s), phi];
    for v in [p.point, p.tangent, p.n1, p.n2, p.bisector] {
        cells.extend(v.to_array().map(Cell::Number));
    }
    cells.push(Cell::Number(p.dihedral.to_degrees()));
    rows.row(&cells)
}
