use pulp::{Arch, NullaryFnOnce};

/// Does `work` in the widest registers of this processor: its `call` and what is inlined in it, always. Numbers are the same on all
/// processors: nothing is contracted or summed in another order.
pub(super) fn wide<W: NullaryFnOnce>(work: W) -> W::Output {
    Arch::new().dispatch(work)
}
