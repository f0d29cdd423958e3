use super::play::BlendShape;
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

    /// Maximum number of external axes.
    pub fn max_externals(self) -> usize {
        match self {
            Self::Rapid | Self::Krl => 6,
            Self::FanucLs => 3,
            Self::Urscript | Self::Inform => 0,
        }
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
    pub(crate) fn blend_shape(self) -> BlendShape {
        match self {
            Self::Urscript => BlendShape::Circle,
            _ => BlendShape::Parabola,
        }
    }

    /// Zones of its corners, mm, increasing; `None` if any zone can be programmed, in steps of 0.1 mm.
    pub(crate) fn zones_mm(self) -> Option<&'static [f64]> {
        match self {
            // z0, z1, z5, z10.
            Self::Rapid => Some(&[0.3, 1.0, 5.0, 10.0]),
            _ => None,
        }
    }
}
