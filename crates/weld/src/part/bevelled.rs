//! A nozzle whose end is prepared: the torch goes in where the edge is cut away.

use super::{Impossible, Making};
use crate::joint::SeamJoint;
use glam::{DAffine3, DVec3};
use seamwright_clearance::{Mesh, Shape, Solid};
use seamwright_program::{Member, Nozzle, Preparation};
use std::f64::consts::PI;
use std::sync::Arc;

/// Number of stations around the nozzle: its flat sides are off the round ones by 1e-5 of the radius, outwards.
const AROUND: usize = 720;

impl SeamJoint {
    /// True if the first part's edge is cut away where it stands on the second.
    pub(super) fn cuts_first(&self) -> bool {
        match &self.joint().preparation {
            Preparation::TBevel(p) => p.prepared == Member::First,
            Preparation::TJ(p) => p.prepared == Member::First,
            _ => false,
        }
    }
}

impl Making<'_> {
    /// The nozzle above its prepared edge, up to the height `top` over its origin, solid inside.
    pub(super) fn bevelled(&self, nozzle: &Nozzle, joint: &SeamJoint, top: f64) -> Result<Solid, Impossible> {
        let (origin, along) = (nozzle.origin_mm.get(), nozzle.direction.unit());
        let outside = 1.0 / (PI / AROUND as f64).cos();
        let mut rings: Vec<Vec<DVec3>> = Vec::new();
        for i in 0..AROUND {
            let p = self.seam.at(self.seam.length() * i as f64 / AROUND as f64);
            // Stations without a groove were refused when the joint was read.
            let Some(section) = joint.section(&p) else { continue };
            let edge = section.first.iter().rev().map(|c| p.point + c.x * p.towards_first + c.y * p.bisector);
            let mut ring: Vec<DVec3> = edge
                .map(|q| {
                    let foot = origin + (q - origin).dot(along) * along;
                    foot + outside * (q - foot)
                })
                .collect();
            ring.insert(0, ring[0] + (top - (ring[0] - origin).dot(along)) * along);
            rings.push(ring);
        }
        let count = rings.iter().map(Vec::len).min().unwrap_or(0);
        let mean = |k: usize| rings.iter().map(|r| (r[k] - origin).dot(along)).sum::<f64>() / rings.len() as f64;
        let (upper, lower) = (origin + top * along, origin + mean(count - 1) * along);
        let mut triangles = Vec::with_capacity(2 * AROUND * (count + 1));
        for (i, ring) in rings.iter().enumerate() {
            let next = &rings[(i + 1) % rings.len()];
            triangles.push([ring[0], next[0], upper]);
            for k in 1..count {
                triangles.extend([[ring[k], next[k], ring[k - 1]], [next[k], next[k - 1], ring[k - 1]]]);
            }
            triangles.push([next[count - 1], ring[count - 1], lower]);
        }
        Ok(Solid::new("nozzle", Shape::Mesh(Arc::new(Mesh::new(&triangles)?)), DAffine3::IDENTITY)?)
    }
}
