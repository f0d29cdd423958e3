//! Checks that triangles form a closed surface, and orients them.

use crate::error::{ClearanceError, FARTHEST_MM};
use glam::DVec3;
use std::collections::HashMap;

/// Corners as numbers, a triangle each.
type Faces = Vec<[u32; 3]>;

/// An edge of a triangle: its lower and higher corner, the triangle, and whether it goes from low to high there.
type Edge = (u32, u32, u32, bool);

/// The triangles, consistently oriented in each piece of the surface, and one corner of each piece.
pub(super) fn closed(triangles: &[[DVec3; 3]]) -> Result<(Vec<[DVec3; 3]>, Vec<DVec3>), ClearanceError> {
    check(triangles)?;
    let (points, mut faces) = welded(triangles);
    faces.retain(|[a, b, c]| a != b && b != c && c != a);
    // Slivers with three corners on a line may close a seam between other triangles.
    let flat = |f: &[u32; 3]| {
        let [a, b, c] = f.map(|i| points[i as usize]);
        (b - a).cross(c - a) == DVec3::ZERO
    };
    let full: Faces = faces.iter().filter(|f| !flat(f)).copied().collect();
    if full.is_empty() {
        return Err(ClearanceError::NoTriangles);
    }
    let (mut faces, edges) = match paired(&points, &full) {
        Ok(edges) => (full, edges),
        Err(open) if full.len() == faces.len() => return Err(open),
        Err(open) => {
            let edges = paired(&points, &faces).map_err(|_| open)?;
            (faces, edges)
        }
    };
    let pieces = turned_alike(&mut faces, &edges);
    let corners = |f: [u32; 3]| f.map(|i| points[i as usize]);
    let pieces = pieces.into_iter().map(|f| corners(faces[f as usize])[0]).collect();
    Ok((faces.into_iter().map(corners).collect(), pieces))
}

fn check(triangles: &[[DVec3; 3]]) -> Result<(), ClearanceError> {
    for (i, corners) in triangles.iter().enumerate() {
        for p in corners {
            let farthest_mm = p.abs().max_element();
            if !p.is_finite() {
                return Err(ClearanceError::NotFinite { triangle: i + 1 });
            }
            if farthest_mm > FARTHEST_MM {
                return Err(ClearanceError::TooLarge { triangle: i + 1, farthest_mm });
            }
        }
    }
    Ok(())
}

/// Equal corners get one number.
fn welded(triangles: &[[DVec3; 3]]) -> (Vec<DVec3>, Faces) {
    let mut points = Vec::new();
    let mut numbers = HashMap::new();
    let mut number = |p: &DVec3| {
        // 0 and -0 are the same coordinate.
        let p = *p + DVec3::ZERO;
        *numbers.entry(p.to_array().map(f64::to_bits)).or_insert_with(|| {
            points.push(p);
            points.len() as u32 - 1
        })
    };
    let faces = triangles.iter().map(|[a, b, c]| [number(a), number(b), number(c)]).collect();
    (points, faces)
}

/// The edges in pairs, or the error that not all have a partner.
fn paired(points: &[DVec3], faces: &Faces) -> Result<Vec<[Edge; 2]>, ClearanceError> {
    let mut edges: Vec<Edge> = Vec::with_capacity(3 * faces.len());
    for (i, &[a, b, c]) in faces.iter().enumerate() {
        edges.extend([(a, b), (b, c), (c, a)].map(|(u, v)| (u.min(v), u.max(v), i as u32, u < v)));
    }
    edges.sort_unstable();
    let (mut pairs, mut open, mut first) = (Vec::with_capacity(edges.len() / 2), 0, None);
    for same in edges.chunk_by(|x, y| (x.0, x.1) == (y.0, y.1)) {
        if let &[x, y] = same {
            pairs.push([x, y]);
        } else {
            open += 1;
            first.get_or_insert((same[0].0, same[0].1));
        }
    }
    match first {
        None => Ok(pairs),
        Some((u, v)) => {
            let at = (points[u as usize] + points[v as usize]) / 2.0;
            Err(ClearanceError::Open { edges: open, at })
        }
    }
}

/// Reverses triangles so that neighbours agree in orientation; returns one triangle of each piece.
fn turned_alike(faces: &mut Faces, edges: &[[Edge; 2]]) -> Vec<u32> {
    let mut neighbours = vec![Vec::with_capacity(3); faces.len()];
    for [x, y] in edges {
        // Neighbours go along their edge in opposite directions.
        let agree = x.3 != y.3;
        neighbours[x.2 as usize].push((y.2, agree));
        neighbours[y.2 as usize].push((x.2, agree));
    }
    let mut turned: Vec<Option<bool>> = vec![None; faces.len()];
    let mut pieces = Vec::new();
    for start in 0..faces.len() as u32 {
        if turned[start as usize].is_some() {
            continue;
        }
        pieces.push(start);
        turned[start as usize] = Some(false);
        let mut open = vec![start];
        while let Some(i) = open.pop() {
            let here = turned[i as usize] == Some(true);
            for &(j, agree) in &neighbours[i as usize] {
                if turned[j as usize].is_none() {
                    turned[j as usize] = Some(here == agree);
                    open.push(j);
                }
            }
        }
    }
    for (face, _) in faces.iter_mut().zip(&turned).filter(|(_, t)| **t == Some(true)) {
        face.swap(1, 2);
    }
    pieces
}
