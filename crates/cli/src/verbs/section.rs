use super::seam_positions::Places;
use crate::args::SectionArgs;
use crate::rows::{Cell, Rows};
use seamwright_message::Message;
use seamwright_program::Role;
use seamwright_project::failure::Failure;
use seamwright_project::files;
use seamwright_project::load::load;
use seamwright_report::{Drawing as _, Language, sections};
use seamwright_weld::Welding;

const HEADER: &str = "s_mm,phi_deg,dihedral_deg,groove_mm2,cap_mm2,bead,role,layer,bead_in_layer,across_mm,out_mm,\
    work_angle_deg,area_mm2,width_mm,height_mm,torch_work_angle_deg,torch_travel_angle_deg,\
    toe_second_deg,toe_first_deg";
/// Number of columns about a bead.
const OF_BEAD: usize = 10;

/// Default number of sections: every eighth of a seam welded all round, and its start again.
const SECTIONS: u32 = 9;

/// Most sections in one drawing.
const DRAWN: usize = 60;

pub(crate) fn run(args: &SectionArgs) -> Result<(), Failure> {
    let loaded = load(&args.job)?;
    let welding = &loaded.welding;
    let Some(joint) = &welding.joint else {
        let allowed = Message::new("cli-section-joint");
        return Err(welding.program.error_at("joint", Message::new("cli-section-no-joint"), allowed).into());
    };
    let seam = loaded.seam()?;
    let places = Places::new(&args.places, seam, SECTIONS)?;
    let mut rows = Rows::with_header(HEADER, args.json);
    let mut drawn = Vec::new();
    places.each(seam.weld_length(), |s, asked| {
        if drawn.len() < DRAWN {
            drawn.push(s);
        }
        let point = seam.at(s);
        let Some(section) = joint.section(&point) else { return Ok(()) };
        let phi = asked.or(point.phi.map(f64::to_degrees)).map_or(Cell::Empty, Cell::Number);
        let place = [Cell::Number(s), phi].into_iter();
        let groove = [point.dihedral.to_degrees(), section.area(), section.cap].map(Cell::Number);
        let head: Vec<Cell> = place.chain(groove).collect();
        let beads = welding.plan.as_ref().map(|plan| (plan, plan.in_order(&section, s)));
        let Some((plan, beads)) = beads else {
            let empty = [Cell::Empty; OF_BEAD];
            let toes = [Cell::Empty; 2];
            return rows.row(&[head, empty.to_vec(), torch(welding, None, (s, 0.0)).to_vec(), toes.to_vec()].concat());
        };
        beads.iter().try_for_each(|bead| {
            let mut cells = head.clone();
            cells.extend([Cell::Count(plan.number(bead) as u64), Cell::Text(plan.layers[bead.layer].role.name())]);
            cells.extend([bead.layer as u64 + 1, bead.index as u64 + 1].map(Cell::Count));
            let values = [bead.tip.x, bead.tip.y, bead.lean.to_degrees(), bead.area, bead.width, bead.height];
            cells.extend(values.map(Cell::Number));
            cells.extend(torch(welding, Some(plan.layers[bead.layer].role), (s, bead.lean)));
            cells.extend([bead.toes.second, bead.toes.first].map(|angle| Cell::Number(angle.to_degrees())));
            rows.row(&cells)
        })
    })?;
    if let Some(path) = &args.svg {
        let mut gallery = sections(welding, &drawn, Language::of_process());
        gallery.title.clone_from(&welding.program.value.title);
        files::write(path, &gallery.to_svg_standalone())?;
    }
    rows.finish()
}

/// Work angle of the torch from the faces' bisector, with the bead's `lean` (rad), and its travel angle. They are at
/// path length `s` in passes of a role.
fn torch(welding: &Welding, role: Option<Role>, (s, lean): (f64, f64)) -> [Cell<'static>; 2] {
    match welding.torch_angles(role, s) {
        Some((work, travel)) => [work + lean, travel].map(|angle| Cell::Number(angle.to_degrees())),
        None => [Cell::Empty; 2],
    }
}
