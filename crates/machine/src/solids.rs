use crate::file::ZoneKind;
use seamwright_clearance::Solid;

/// Solids of the machine file. Solids are given in the work frame with all axes at zero; a point of link `l` is then at
/// `link_frames(q)[l] * point`.
#[derive(Debug, Clone, Default)]
pub struct LinkSolids {
    /// Each with its link.
    pub solids: Vec<(usize, Solid)>,
    /// Minimum distance of two links, mm.
    pub least_mm: f64,
    /// Pairs of links that may touch.
    pub(crate) ignored: Vec<(usize, usize)>,
    /// Permitted and forbidden volumes.
    pub zones: Vec<Zone>,
}

/// A permitted or forbidden volume.
#[derive(Debug, Clone)]
pub struct Zone {
    /// Name for reports.
    pub name: String,
    /// Permitted or forbidden.
    pub kind: ZoneKind,
    /// Its link.
    pub link: usize,
    /// Names of the watched links, `part` and `fixtures`; none: all groups that move relative to it.
    pub(crate) watch: Option<Vec<String>>,
    /// Minimum distance or margin, mm.
    pub least_mm: f64,
    /// Its volume, like [`LinkSolids::solids`].
    pub solids: Vec<Solid>,
}
