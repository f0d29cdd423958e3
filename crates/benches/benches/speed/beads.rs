//! From job to program: all passes of a saddle 1,580 mm long, laid out every mm. Aim: 20 ms for 12 passes; growth with
//! passes and length no more than linear.

use crate::measure::time;
use seamwright_weld::Welding;
use std::hint::black_box;

/// The saddle of SADDLE-2020 with its joint, beads of `area` mm^2 laid out every `step` mm.
fn job(area: f64, step: f64) -> String {
    format!(
        "schema = 1\ntitle = \"saddle\"\nmachine = \"saddle-4axis\"\n[seam.nozzle]\nradius_mm = 250\n\
         [seam.nozzle.body.cylinder]\nradius_mm = 800\n[start]\nphi_deg = 20\n[joint]\ncap_mm = 1.5\n\
         [joint.preparation.t_bevel]\nthickness_mm = 16\ncut_deg = 45\nroot_gap_mm = 2\nroot_face_mm = 1\nleg_mm = 6\n\
         [beads]\nstation_mm = {step}\nroot = {{ area_mm2 = 14 }}\nfill = {{ area_mm2 = {area} }}\n\
         [weld]\nspeed_mm_s = 10\n"
    )
}

pub(crate) fn beads() {
    for (area, step) in [(20.0, 1.0), (9.5, 1.0), (20.0, 2.0)] {
        let text = job(area, step);
        let passes = Welding::read("job", &text).unwrap().program.value.passes.len();
        time(&format!("job to program/{passes} passes, every {step} mm"), || {
            black_box(Welding::read("job", black_box(&text)).unwrap())
        });
    }
}
