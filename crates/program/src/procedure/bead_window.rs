use super::{PositionLimits, Procedure, QualityLevel, Run, Window};
use crate::joint::FilletOrButt;
use crate::pass::Role;
use seamwright_document::Positive;

/// The window of a bead's cross-section: what the procedure's run gives, and otherwise usual values of its process.
///
/// Usual values are those of shops and handbooks (trust: to be replaced by the qualified procedure's):
/// - heights of root and fill layers and the width above which a layer is split: prequalified limits of AWS D1.1 for
///   each process (root 10 mm at most, fill layers 6 mm, split above 16 mm);
/// - width to height of at least 1 in fill and cap layers: deeper beads tend to crack along their middle on cooling;
/// - the width of a bead without a weave: ten diameters of a gas-shielded wire, six of a submerged one, 8 mm for TIG,
///   three diameters of a covered electrode;
/// - the angle at the toes of a cap: that of the procedure's quality level by ISO 5817, or of level C.
///
/// Beams have none.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BeadWindow {
    /// Width, mm.
    pub width_mm: [f64; 2],
    /// Height, mm.
    pub height_mm: [f64; 2],
    /// Width as a multiple of the height.
    pub width_to_height: [f64; 2],
    /// Maximum width without a weave, mm.
    pub max_unwoven_mm: f64,
    /// Quality level of the weld.
    pub quality_level: QualityLevel,
    /// Minimum weld toe angle, degrees, if the procedure gives one.
    pub given_toe_deg: Option<f64>,
    /// Kind of weld, if the procedure gives one; otherwise it follows the angle between the faces.
    pub joint: Option<FilletOrButt>,
    /// Limits of positions, and the angle between faces up to which a weld is a fillet.
    pub position_limits: PositionLimits,
    /// True if the procedure gives any of these for the role: then a bead outside is an error, otherwise a warning.
    pub is_binding: bool,
}

/// Process and wire of welds without a procedure: MAG with a solid wire of 1.2 mm.
const USUAL_PROCESS: u16 = 135;
const USUAL_WIRE_MM: f64 = 1.2;

impl BeadWindow {
    /// The window of beads of `role` with a wire of `wire_mm`; `procedure` gives its process and may narrow it.
    pub fn new(procedure: Option<&Procedure>, role: Role, wire_mm: Option<Positive>) -> Self {
        let process = procedure.map_or(USUAL_PROCESS, |p| p.process.number);
        let wire = wire_mm.or_else(|| procedure?.wire_diameter_mm).map_or(USUAL_WIRE_MM, Positive::get);
        let quality_level = procedure.map_or_else(QualityLevel::default, |p| p.quality_level);
        let position_limits = procedure.map_or_else(PositionLimits::default, |p| p.position_limits);
        let joint = procedure.and_then(|p| p.joint);
        let usual = Self { quality_level, joint, position_limits, ..Self::usual(process, role, wire) };
        procedure.and_then(|p| p.run_named(role)).map_or(usual, |run| usual.narrowed(run))
    }

    fn usual(process: u16, role: Role, wire: f64) -> Self {
        let of = |width_mm, height_mm, width_to_height, max_unwoven_mm| Self {
            width_mm,
            height_mm,
            width_to_height,
            max_unwoven_mm,
            quality_level: QualityLevel::default(),
            given_toe_deg: None,
            joint: None,
            position_limits: PositionLimits::default(),
            is_binding: false,
        };
        let is_root = matches!(role, Role::Root | Role::Tack);
        match (process, is_root) {
            (51 | 52, _) => of([0.0, f64::INFINITY], [0.0, f64::INFINITY], [0.0, f64::INFINITY], f64::INFINITY),
            (121, true) => of([5.0, 16.0], [2.5, 10.0], [0.7, 4.0], 6.0 * wire),
            (121, false) => of([7.0, 28.0], [2.0, 6.0], [1.2, 8.0], 6.0 * wire),
            (15 | 141 | 142, true) => of([2.0, 8.0], [1.0, 4.0], [0.6, 5.0], 8.0),
            (15 | 141 | 142, false) => of([3.0, 12.0], [1.0, 3.5], [1.0, 7.0], 8.0),
            (111, true) => of([2.5, 10.0], [1.5, 6.0], [0.6, 5.0], 3.0 * wire),
            (111, false) => of([4.0, 16.0], [1.5, 5.0], [1.0, 6.0], 3.0 * wire),
            (_, true) => of([2.5, 12.0], [1.5, 10.0], [0.6, 5.0], 10.0 * wire),
            (_, false) => of([4.0, 16.0], [1.5, 6.0], [1.0, 6.0], 10.0 * wire),
        }
    }

    /// Minimum weld toe angle of a cap between faces with this angle, rad; degrees.
    pub fn min_toe_deg(&self, dihedral: f64) -> f64 {
        let joint = self.joint.unwrap_or_else(|| self.position_limits.joint(dihedral));
        self.given_toe_deg.unwrap_or_else(|| self.quality_level.min_toe_deg(joint))
    }

    fn narrowed(self, run: &Run) -> Self {
        let ends = |window: Option<Window>, usual: [f64; 2]| window.map_or(usual, |w| <[f64; 2]>::from(w.ends()));
        Self {
            width_mm: ends(run.bead_width_mm, self.width_mm),
            height_mm: ends(run.bead_height_mm, self.height_mm),
            width_to_height: ends(run.bead_width_to_height, self.width_to_height),
            max_unwoven_mm: run.max_unwoven_mm.map_or(self.max_unwoven_mm, Positive::get),
            given_toe_deg: run.min_toe_angle_deg.map(Positive::get),
            is_binding: run.bead_width_mm.is_some()
                || run.bead_height_mm.is_some()
                || run.bead_width_to_height.is_some()
                || run.max_unwoven_mm.is_some(),
            ..self
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::procedure::WeldingProcess;

    #[test]
    fn a_procedure_narrows_the_usual_window() {
        let text = "schema = 1\nnumber = \"1\"\ntitle = \"t\"\nprocess = 135\n[[runs]]\nname = \"cap\"\n\
                    bead_width_mm = [6, 11]\nmax_unwoven_mm = 9\n[[runs]]\nname = \"fill\"\n";
        let procedure = Procedure::read("p.toml", text).unwrap().value;
        let cap = BeadWindow::new(Some(&procedure), Role::Cap, None);
        assert_eq!((cap.width_mm, cap.max_unwoven_mm, cap.is_binding), ([6.0, 11.0], 9.0, true));
        // ISO 5817, no. 505: level C allows 100 degrees at fillets and 110 at butts.
        let right = 90f64.to_radians();
        let butt = Procedure::read(
            "p.toml",
            &text.replace("[[runs]]\nname = \"cap\"", "joint = \"butt\"\n[[runs]]\nname = \"cap\""),
        );
        let butt = BeadWindow::new(Some(&butt.unwrap().value), Role::Cap, None);
        assert!(butt.min_toe_deg(right) > cap.min_toe_deg(right));
        assert!((butt.min_toe_deg(right) - cap.min_toe_deg(3.1)).abs() < 1e-12);
        let usual = BeadWindow::new(None, Role::Cap, None);
        assert_eq!((cap.height_mm, usual.is_binding), (usual.height_mm, false));
        assert_eq!(BeadWindow::new(Some(&procedure), Role::Fill, None), BeadWindow::new(None, Role::Fill, None));
        assert!(BeadWindow::new(None, Role::Root, Positive::new(1.6)).max_unwoven_mm > usual.max_unwoven_mm);
    }

    #[test]
    fn every_process_has_a_window_that_some_bead_keeps() {
        for process in WeldingProcess::all() {
            for role in [Role::Root, Role::Fill, Role::Cap] {
                let w = BeadWindow::usual(process.number, role, 1.2);
                let width = w.max_unwoven_mm.min(w.width_mm[1]).min(w.width_to_height[1] * w.height_mm[1]);
                assert!(width >= w.width_mm[0] && w.height_mm[0] * w.width_to_height[0] <= width, "{process:?} {w:?}");
            }
        }
    }
}
