//! Paths with corners: sequences of straight lines and arcs, turns between them, a torch with changing attitude.

use glam::{DQuat, DVec3};
use seamwright_geometry::Pose;
use seamwright_program::TorchPath;

/// A line or an arc in the plane z = 0.
#[derive(Clone, Copy)]
pub(crate) struct Part {
    /// Turn of the heading before it, rad.
    pub(crate) turn: f64,
    pub(crate) length: f64,
    /// 1 / mm, positive to the left.
    pub(crate) curvature: f64,
    /// Rate of the torch's lean about x and y, rad/mm.
    pub(crate) lean: [f64; 2],
}

impl Part {
    pub(crate) fn line(turn_deg: f64, length: f64) -> Self {
        Self { turn: turn_deg.to_radians(), length, curvature: 0.0, lean: [0.0; 2] }
    }

    pub(crate) fn arc(length: f64, curvature: f64) -> Self {
        Self { turn: 0.0, length, curvature, lean: [0.0; 2] }
    }
}

/// Start of a part.
#[derive(Clone, Copy)]
struct Start {
    s: f64,
    point: DVec3,
    heading: f64,
    lean: [f64; 2],
}

pub(crate) struct Route {
    parts: Vec<Part>,
    starts: Vec<Start>,
}

impl Route {
    /// Creates a route from `point`, along x if the first part does not turn.
    pub(crate) fn new(point: DVec3, parts: Vec<Part>) -> Self {
        Self::leaning(point, [0.0; 2], parts)
    }

    /// Creates a route with the torch leaning about x and y (rad) at the start.
    pub(crate) fn leaning(point: DVec3, lean: [f64; 2], parts: Vec<Part>) -> Self {
        let mut next = Start { s: 0.0, point, heading: 0.0, lean };
        let mut starts = Vec::new();
        for part in &parts {
            next.heading += part.turn;
            starts.push(next);
            next = along(part, &next, part.length);
        }
        starts.push(next);
        Self { parts, starts }
    }

    /// Path lengths of the joints between parts.
    pub(crate) fn places(&self) -> Vec<f64> {
        self.starts[1..self.parts.len()].iter().map(|start| start.s).collect()
    }

    pub(crate) fn part(&self, s: f64) -> &Part {
        &self.parts[self.index(s)]
    }

    fn index(&self, s: f64) -> usize {
        self.starts[1..self.parts.len()].partition_point(|start| start.s <= s)
    }
}

/// The state `x` mm into a part.
fn along(part: &Part, start: &Start, x: f64) -> Start {
    let turned = part.curvature * x;
    // Chord of an arc: its length times sin(t / 2) / (t / 2), in the mean direction.
    let half = 0.5 * turned;
    let chord = if half.abs() < 1e-9 { x } else { x * half.sin() / half };
    let (sin, cos) = (start.heading + half).sin_cos();
    Start {
        s: start.s + x,
        point: start.point + chord * DVec3::new(cos, sin, 0.0),
        heading: start.heading + turned,
        lean: [0, 1].map(|k| start.lean[k] + part.lean[k] * x),
    }
}

impl TorchPath for Route {
    fn length(&self) -> f64 {
        self.starts[self.parts.len()].s
    }

    fn pose(&self, s: f64) -> Pose {
        let i = self.index(s);
        let Start { point, lean: [x, y], .. } = along(&self.parts[i], &self.starts[i], s - self.starts[i].s);
        Pose { point, direction: DQuat::from_rotation_x(x) * DQuat::from_rotation_y(y) * -DVec3::Z }
    }

    fn knots(&self) -> Vec<f64> {
        self.places()
    }
}
