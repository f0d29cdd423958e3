use crate::ZoneKind;
use seamwright_clearance::Solid;

/// Everything solid that the machine file describes. Solids are given in the work frame with all axes at zero; a
/// point of link `l` is then at `link_frames(q)[l] * point`.
#[derive(Debug, Clone, Default)]
pub struct LinkSolids {
    /// Each with its link.
    pub solids: Vec<(usize, Solid)>,
    /// Least distance of two links, mm.
    pub least_mm: f64,
    /// Pairs of links that may touch.
    pub(crate) ignored: Vec<(usize, usize)>,
    /// Permitted and forbidden volumes.
    pub zones: Vec<Zone>,
}

/// A volume to stay in or to keep out of.
#[derive(Debug, Clone)]
pub struct Zone {
    /// Name, for people.
    pub name: String,
    /// Stay in, or keep out.
    pub kind: ZoneKind,
    /// The link that it is fixed to.
    pub link: usize,
    /// Names of links, `part` and `fixtures` that it holds for; none: everything that moves against it.
    pub(crate) watch: Option<Vec<String>>,
    /// Least distance or room, mm.
    pub least_mm: f64,
    /// Its volume, like [`LinkSolids::solids`].
    pub solids: Vec<Solid>,
}
