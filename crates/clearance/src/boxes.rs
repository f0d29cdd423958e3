//! Axis-aligned bounding boxes in a tree, for meshes.

use glam::DVec3;

#[derive(Debug, Clone, Copy)]
pub(crate) struct Bounds {
    pub(crate) low: DVec3,
    pub(crate) high: DVec3,
}

impl Bounds {
    pub(crate) const EMPTY: Self = Self { low: DVec3::INFINITY, high: DVec3::NEG_INFINITY };

    pub(crate) fn with(self, p: DVec3) -> Self {
        Self { low: self.low.min(p), high: self.high.max(p) }
    }

    pub(crate) fn joined(self, other: &Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    pub(crate) fn centre(&self) -> DVec3 {
        (self.low + self.high) / 2.0
    }

    pub(crate) fn half(&self) -> DVec3 {
        (self.high - self.low) / 2.0
    }

    /// Square of the distance between two boxes; 0 if they touch.
    pub(crate) fn distance_squared(&self, other: &Self) -> f64 {
        (self.low - other.high).max(other.low - self.high).max(DVec3::ZERO).length_squared()
    }

    /// Maximum component along `direction` of the points inside.
    pub(crate) fn reach(&self, direction: DVec3) -> f64 {
        self.centre().dot(direction) + self.half().dot(direction.abs())
    }
}

/// A node: a leaf holds the items `first..first + count`, a fork (count 0) the nodes `first` and `first + 1`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Node {
    pub(crate) bounds: Bounds,
    pub(crate) first: u32,
    pub(crate) count: u32,
}

const LEAF: usize = 4;

/// The tree over items with these boxes, root first, and the order of the items in its leaves. Halved at the median of
/// the longest side, so the depth is log2 of the number of items.
pub(crate) fn tree(items: &[Bounds]) -> (Vec<Node>, Vec<u32>) {
    let mut order: Vec<u32> = (0..items.len() as u32).collect();
    let mut nodes = vec![Node { bounds: Bounds::EMPTY, first: 0, count: 0 }];
    let mut open = vec![(0, 0, items.len())];
    while let Some((node, from, to)) = open.pop() {
        let part = &mut order[from..to];
        let bounds = part.iter().fold(Bounds::EMPTY, |b, &i| b.joined(&items[i as usize]));
        if part.len() <= LEAF {
            nodes[node] = Node { bounds, first: from as u32, count: part.len() as u32 };
            continue;
        }
        let spread = part.iter().fold(Bounds::EMPTY, |b, &i| b.with(items[i as usize].centre())).half();
        let axis = spread.max_position();
        let middle = part.len() / 2;
        let key = |i: &u32| items[*i as usize].centre()[axis];
        part.select_nth_unstable_by(middle, |a, b| key(a).total_cmp(&key(b)));
        let first = nodes.len();
        nodes[node] = Node { bounds, first: first as u32, count: 0 };
        nodes.push(Node { bounds, first: 0, count: 0 });
        nodes.push(Node { bounds, first: 0, count: 0 });
        open.push((first, from, from + middle));
        open.push((first + 1, from + middle, to));
    }
    (nodes, order)
}
