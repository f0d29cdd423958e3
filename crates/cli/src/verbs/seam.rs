use super::seam_positions::Places;
use crate::args::SeamArgs;
use crate::rows::{Cell, Rows};
use seamwright_project::failure::Failure;
use seamwright_project::load::load;
use seamwright_weld::SeamPoint;

const HEADER: &str = "s_mm,phi_deg,x_mm,y_mm,z_mm,tx,ty,tz,n1x,n1y,n1z,n2x,n2y,n2z,bx,by,bz,dihedral_deg";

/// Default number of points.
const POINTS: u32 = 101;

pub(crate) fn run(args: &SeamArgs) -> Result<(), Failure> {
    let loaded = load(&args.job)?;
    let seam = loaded.seam()?;
    let places = Places::new(&args.places, seam, POINTS)?;
    let mut rows = Rows::with_header(HEADER, args.json);
    places.each(seam.weld_length(), |s, phi| write(&mut rows, &seam.at(s), phi))?;
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
