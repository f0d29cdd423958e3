use super::arm::RobotArm;
use super::play::BlendShape;
use super::program::RobotFrames;
use super::way::CircularRule;
use super::weld_values::WeldValues;
use seamwright_message::named_enum;

named_enum! {
    /// A language of robot programs.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum RobotLanguage {
        /// ABB RAPID with RobotWare Arc.
        Rapid => "rapid",
        /// KUKA Robot Language.
        Krl => "krl",
        /// FANUC teach pendant programs as text (LS).
        FanucLs => "fanuc-ls",
        /// Universal Robots URScript.
        Urscript => "urscript",
        /// Yaskawa INFORM jobs (JBI).
        Inform => "inform",
    }
}

/// FANUC: time by which CNT100 rounds a corner on either side, s: half of the acceleration time of a line. Smaller numbers
/// take that part of it.
pub(crate) const CNT_S: f64 = 0.2;
/// Yaskawa: zone of position level 1 (parameter S1CxG033), mm.
pub(crate) const POSITION_LEVEL_1_MM: f64 = 12.5;

impl RobotLanguage {
    /// Its name, for people.
    pub fn title(self) -> &'static str {
        match self {
            Self::Rapid => "ABB RAPID",
            Self::Krl => "KUKA KRL",
            Self::FanucLs => "FANUC LS",
            Self::Urscript => "Universal Robots URScript",
            Self::Inform => "Yaskawa INFORM",
        }
    }

    /// Usual name of a file in it.
    pub fn file_name(self) -> &'static str {
        match self {
            Self::Rapid => "rapid.mod",
            Self::Krl => "krl.src",
            Self::FanucLs => "fanuc.ls",
            Self::Urscript => "urscript.script",
            Self::Inform => "inform.jbi",
        }
    }

    /// The language of a file by the ending of its name.
    pub fn of_file(file: &str) -> Option<Self> {
        let ending = file.rsplit_once('.')?.1.to_ascii_lowercase();
        match ending.as_str() {
            "mod" | "modx" => Some(Self::Rapid),
            "src" => Some(Self::Krl),
            "ls" => Some(Self::FanucLs),
            "script" => Some(Self::Urscript),
            "jbi" => Some(Self::Inform),
            _ => None,
        }
    }

    /// Maximum number of external axes.
    pub fn max_externals(self) -> usize {
        match self {
            Self::Rapid | Self::Krl => 6,
            Self::FanucLs => 3,
            Self::Inform => self.max_carriers() + self.max_positioner_axes(),
            Self::Urscript => 0,
        }
    }

    /// Maximum number of axes of a positioner with which the arm is coordinated.
    pub fn max_positioner_axes(self) -> usize {
        if self == Self::Inform { 2 } else { self.max_externals() }
    }

    /// Maximum number of axes that carry the arm.
    pub fn max_carriers(self) -> usize {
        if self == Self::Inform { 3 } else { self.max_externals() }
    }

    /// Whether poses on a positioner are in a frame that stands still, and not in that of its last axis: FANUC and Yaskawa.
    pub(crate) fn has_standing_frames(self, arm: &RobotArm) -> bool {
        matches!(self, Self::FanucLs | Self::Inform) && arm.has_positioner()
    }

    /// Whether the text has times of the gas and the wire feed; otherwise these are settings of the power source.
    pub(crate) fn has_gas_and_wire(self) -> bool {
        !matches!(self, Self::FanucLs | Self::Inform)
    }

    /// Whether moves of the axes have positions of axes as targets; otherwise they have poses.
    pub(crate) fn has_joint_targets(self) -> bool {
        self != Self::Inform
    }

    /// `time_s` in the steps of the text, not shorter.
    pub(crate) fn time_s(self, time_s: f64) -> f64 {
        let per_s = if self.has_gas_and_wire() { 1e3 } else { 1e2 };
        (time_s * per_s - 1e-6).ceil() / per_s + 0.0
    }

    /// Step of currents, A.
    pub(crate) fn current_step_a(self) -> f64 {
        match self {
            Self::Inform => 1.0,
            Self::FanucLs => 0.1,
            _ => 1e-3,
        }
    }

    /// `values` as the text has them.
    pub(crate) fn values(self, values: WeldValues) -> WeldValues {
        if self.has_gas_and_wire() {
            return values;
        }
        let per_a = (1.0 / self.current_step_a()).round();
        let current_a = (values.current_a * per_a).round() / per_a;
        WeldValues { current_a, voltage_v: (values.voltage_v * 10.0).round() / 10.0, wire_feed_m_min: 0.0 }
    }

    /// Frames of tool and work as the control counts them: on FANUC and Yaskawa the base frame is at the height of the
    /// second axis.
    pub(crate) fn frames(self, arm: &RobotArm) -> RobotFrames {
        let mut work = if self.has_standing_frames(arm) { arm.work_at_zero } else { arm.work };
        if !self.has_gas_and_wire() {
            work.point.z -= arm.shoulder_height_mm;
        }
        RobotFrames { tool: arm.tool, work }
    }

    /// Whether the arm's fourth axis is parallel to the second and third; other languages need a spherical wrist, which
    /// their configuration data describe.
    pub(crate) fn has_parallel_axes(self) -> bool {
        self == Self::Urscript
    }

    /// Step of programmed speeds, mm/s.
    pub fn speed_step_mm_s(self) -> f64 {
        match self {
            Self::Rapid | Self::Krl | Self::Urscript => 0.01,
            Self::FanucLs | Self::Inform => 0.1,
        }
    }

    /// Maximum error of a position that its decimals make, mm.
    pub(crate) fn rounding_mm(self) -> f64 {
        match self {
            Self::Rapid | Self::Krl | Self::Urscript => 1e-4,
            Self::FanucLs | Self::Inform => 1e-3,
        }
    }

    /// Shape of its corner paths.
    pub(super) fn blend_shape(self) -> BlendShape {
        match self {
            Self::Urscript => BlendShape::Circle,
            _ => BlendShape::Parabola,
        }
    }

    /// Orientation and external axes along its arcs.
    pub(crate) fn circular_rule(self) -> CircularRule {
        match self {
            Self::Rapid | Self::Krl => CircularRule::Path,
            Self::Urscript => CircularRule::Work,
            Self::FanucLs | Self::Inform => CircularRule::Through,
        }
    }

    /// Whether a through-point is a whole pose in the text; otherwise only its position.
    pub(crate) fn has_whole_through_points(self) -> bool {
        matches!(self, Self::Rapid | Self::FanucLs | Self::Inform)
    }

    /// Length of a line that an arc needs at each of its ends, mm. On Yaskawa an arc starts at a point of its own to which a
    /// line leads, and the zone counts up to half of the shorter move: short lines keep the corners short.
    pub(crate) fn arc_ends_mm(self) -> Option<f64> {
        (self == Self::Inform).then_some(1.5)
    }

    /// Smallest zone beside an arc, mm: a control without it stops there.
    pub(crate) fn min_zone_mm(self) -> f64 {
        match (self.arc_ends_mm(), self.zones_mm()) {
            (Some(short_mm), _) => 0.5 * short_mm,
            (None, Some(zones)) => zones.first().copied().unwrap_or(0.0),
            (None, None) => 0.1,
        }
    }

    /// Zones of its corners, mm, increasing; `None` if any zone can be programmed, in steps of 0.1 mm.
    pub(crate) fn zones_mm(self) -> Option<&'static [f64]> {
        match self {
            // z0, z1, z5, z10.
            Self::Rapid => Some(&[0.3, 1.0, 5.0, 10.0]),
            Self::Inform => Some(&[POSITION_LEVEL_1_MM]),
            _ => None,
        }
    }
}
