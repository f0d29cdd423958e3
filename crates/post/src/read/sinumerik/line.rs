use crate::read::error::Span;
use crate::read::lines::Flow;
use crate::read::motion::Block;

/// Words of a line, beside the channels.
#[derive(Debug, Default)]
pub(super) struct Line {
    pub(super) block: Block,
    /// A bit for each modal group of which there was a code.
    pub(super) groups: u32,
    pub(super) feed: Option<(f64, Span)>,
    pub(super) dwell: Option<Span>,
    /// M0, M1, M2, M17 and M30.
    pub(super) stop: Option<u32>,
    /// Whether there was a word beside the block number.
    pub(super) begun: bool,
    pub(super) flow: Option<Flow>,
}
