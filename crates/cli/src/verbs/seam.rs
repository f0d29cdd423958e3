use super::positive;
use crate::args::SeamArgs;
use crate::failure::Failure;
use crate::load::load;
use crate::rows::{Cell, Rows};
use seamwright_weld::SeamPoint;

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
    let mut rows = Rows::new(COLUMNS.iter().map(|c| (*c).to_owned()).collect(), args.json)?;
    if let Some(angles) = &args.phi_deg {
        for phi in angles {
            let s = Some(phi).filter(|p| p.is_finite()).and_then(|p| seam.s_of_phi(p.to_radians()));
            let s = s.ok_or_else(|| Failure::Input(format!("--phi-deg {phi}: this seam has no such angle")))?;
            // The angle as asked for, not counted on from the start.
            write(&mut rows, &seam.at(s), Some(*phi))?;
        }
    } else if let Some(step) = args.every_mm {
        let step = positive("--every-mm", step)?;
        let whole = (length / step - 1e-9).floor() as u64;
        for i in 0..=whole {
            write(&mut rows, &seam.at(i as f64 * step), None)?;
        }
        write(&mut rows, &seam.at(length), None)?;
    } else {
        let n = args.points.unwrap_or(POINTS);
        if n < 2 {
            return Err(Failure::Input(format!("--points {n}: not allowed\n   allowed: 2 or more")));
        }
        for i in 0..n {
            write(&mut rows, &seam.at(length * f64::from(i) / f64::from(n - 1)), None)?;
        }
    }
    rows.finish()
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
