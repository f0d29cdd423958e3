/// Ring buffer of values by cell index along the seam. A slot serves every `len`-th cell and keeps the last one
/// written, so the memory is bounded and reversing needs no special case.
#[derive(Debug, Clone)]
pub(super) struct Ring<T> {
    slots: Vec<Option<(i64, T)>>,
}

impl<T: Copy> Ring<T> {
    /// Creates a ring of at least `len` cells, rounded up to a power of two.
    pub(super) fn new(len: usize) -> Self {
        Self { slots: vec![None; len.next_power_of_two()] }
    }

    pub(super) fn len(&self) -> i64 {
        self.slots.len() as i64
    }

    /// Returns the value of cell `i`, unless it was overwritten.
    pub(super) fn get(&self, i: i64) -> Option<&T> {
        self.slots[self.slot(i)].as_ref().filter(|(at, _)| *at == i).map(|(_, value)| value)
    }

    pub(super) fn put(&mut self, i: i64, value: T) {
        let slot = self.slot(i);
        self.slots[slot] = Some((i, value));
    }

    pub(super) fn remove(&mut self, i: i64) {
        let slot = self.slot(i);
        self.slots[slot] = self.slots[slot].filter(|(at, _)| *at != i);
    }

    /// Removes all cells.
    pub(super) fn clear(&mut self) {
        self.slots.fill(None);
    }

    fn slot(&self, i: i64) -> usize {
        (i & (self.len() - 1)) as usize
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_window_of_the_last_written() {
        let mut ring = Ring::new(8);
        for i in -20..5 {
            ring.put(i, i * 10);
        }
        for i in -30..10 {
            assert_eq!(ring.get(i).copied(), (-3..5).contains(&i).then_some(i * 10), "{i}");
        }
        ring.put(-9, 7);
        assert!(ring.get(-1).is_none(), "its slot has gone to the cell eight before");
        assert_eq!(ring.get(-9), Some(&7));
        ring.remove(-1);
        assert_eq!(ring.get(-9), Some(&7), "that was another cell");
        ring.remove(-9);
        assert!(ring.get(-9).is_none());
        ring.clear();
        assert!((-30..10).all(|i| ring.get(i).is_none()));
    }
}
