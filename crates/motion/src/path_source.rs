use seamwright_program::TorchPath;

/// Path under a changed one: the pass' own, or the one with a slower weave that was made from it.
pub(crate) enum PathSource<'a> {
    Lent(&'a dyn TorchPath),
    Own(Box<dyn TorchPath + 'a>),
}

impl PathSource<'_> {
    pub(crate) fn get(&self) -> &dyn TorchPath {
        match self {
            Self::Lent(path) => *path,
            Self::Own(path) => &**path,
        }
    }

    /// The same with the weave slower by `factor`; unchanged without a weave.
    pub(crate) fn slower(&self, factor: f64) -> PathSource<'_> {
        let path = self.get();
        path.weave().map_or(PathSource::Lent(path), |weave| PathSource::Own(weave.slower(factor)))
    }
}
