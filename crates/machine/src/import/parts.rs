//! Shapes of a robot's links for collision checks.

use super::serial::in_mm;
use super::urdf::{Collision, Geometry, Robot};
use super::{FoundMesh, ImportOptions, ImportedShape};
use glam::{DAffine3, DVec3};
use seamwright_clearance::{Mesh, ShapeFile, SolidFile, read_stl};
use seamwright_document::{DocumentError, Positive, Transform};
use seamwright_message::Message;

/// The moving body that a link belongs to.
#[derive(Debug, Clone)]
pub(super) struct Owner {
    /// `base` or the name of an axis.
    link: String,
    /// The link's frame in the base frame with all axes at zero, mm.
    frame: DAffine3,
}

impl Owner {
    /// The owner of each link; none for links that the base does not carry. Axes beside the chain stay at zero.
    pub(super) fn of(
        robot: &Robot<'_>,
        base: usize,
        chain: &[usize],
        names: &[String],
        scale: f64,
        notes: &mut Vec<Message>,
    ) -> Vec<Option<Self>> {
        let mut owners: Vec<Option<Self>> = vec![None; robot.links.len()];
        owners[base] = Some(Self { link: "base".to_owned(), frame: DAffine3::IDENTITY });
        let mut open = vec![base];
        let mut held = Vec::new();
        let moving: Vec<usize> = chain.iter().copied().filter(|&j| robot.joints[j].kind != "fixed").collect();
        while let Some(parent) = open.pop() {
            let Some(owner) = owners[parent].clone() else { continue };
            for (j, joint) in robot.joints.iter().enumerate().filter(|(_, joint)| joint.parent == parent) {
                if owners[joint.child].is_some() {
                    continue;
                }
                let axis = moving.iter().position(|&moving| moving == j);
                if axis.is_none() && joint.kind != "fixed" {
                    held.push(joint.name.as_str());
                }
                let link = axis.map_or_else(|| owner.link.clone(), |axis| names[axis].clone());
                owners[joint.child] = Some(Self { link, frame: owner.frame * in_mm(joint.origin, scale) });
                open.push(joint.child);
            }
        }
        if !held.is_empty() {
            notes.push(Message::new("machine-import-held").text("joints", held.join(", ")));
        }
        owners
    }
}

/// Shapes of all links with an owner, in the order of the source.
pub(super) fn shapes(
    robot: &Robot<'_>,
    owners: &[Option<Owner>],
    options: &ImportOptions<'_>,
    notes: &mut Vec<Message>,
) -> Result<Vec<ImportedShape>, DocumentError> {
    let mut shapes = Vec::new();
    for (link, owner) in robot.links.iter().zip(owners) {
        let Some(owner) = owner else { continue };
        for collision in &link.collisions {
            if let Some(shape) = shape(collision, options, &link.name, notes)? {
                let (shape, inner) = shape;
                let at = owner.frame * in_mm(collision.origin, super::serial::MM * options.scale) * inner;
                let at = Transform::from_affine(&at).unwrap_or_default();
                let solid = SolidFile { name: Some(link.name.clone()), shape, at };
                shapes.push(ImportedShape { link: owner.link.clone(), solid });
            }
        }
    }
    if shapes.is_empty() {
        notes.push(Message::new("machine-import-no-shapes"));
    }
    Ok(shapes)
}

/// A shape and its displacement in the frame of its element; none, with a note, if machine files have no such shape.
fn shape(
    collision: &Collision<'_>,
    options: &ImportOptions<'_>,
    link: &str,
    notes: &mut Vec<Message>,
) -> Result<Option<(ShapeFile, DAffine3)>, DocumentError> {
    let scale = super::serial::MM * options.scale;
    // Sizes are greater than 0; the fallback is for a product that overflows.
    let mm = |v: f64| Positive::new(scale * v).unwrap_or(Positive::HALF);
    let at_origin = |shape| Ok(Some((shape, DAffine3::IDENTITY)));
    match &collision.geometry {
        Geometry::Box(size) => at_origin(ShapeFile::Box { size_mm: size.to_array().map(mm) }),
        Geometry::Sphere { radius } => at_origin(ShapeFile::Sphere { radius_mm: mm(*radius) }),
        Geometry::Cylinder { radius, length } => {
            // Theirs is centred, ours stands on the origin.
            let down = DAffine3::from_translation(DVec3::new(0.0, 0.0, -0.5 * scale * length));
            Ok(Some((ShapeFile::Cylinder { radius_mm: mm(*radius), length_mm: mm(*length) }, down)))
        }
        Geometry::Other(kind) => {
            notes.push(Message::new("machine-import-shape-kind").text("link", link).text("kind", kind));
            Ok(None)
        }
        Geometry::Mesh { name, scale: stretch } => {
            if !is_stl(name) {
                notes.push(Message::new("machine-import-mesh-format").text("link", link).text("file", name));
                return Ok(None);
            }
            let found = (options.find_mesh)(name).map_err(|tried| {
                let fault = Message::new("machine-urdf-mesh-missing").text("mesh", name);
                let mut error = collision.place.error(fault, Message::new("machine-urdf-cure-mesh"));
                error.allowed = Some(Message::new("machine-urdf-mesh-tried").text("files", tried.join(", ")));
                error
            })?;
            let made = stl(&found, *stretch, scale);
            Ok(made
                .map_err(|why| {
                    let note = Message::new("machine-import-mesh-unusable").text("link", link).text("file", name);
                    notes.push(note.message("why", why));
                })
                .ok()
                .map(|shape| (shape, DAffine3::IDENTITY)))
        }
    }
}

fn is_stl(name: &str) -> bool {
    name.rsplit('.').next().is_some_and(|end| end.eq_ignore_ascii_case("stl"))
}

/// A closed mesh; or the reason why it is not one.
fn stl(found: &FoundMesh, stretch: DVec3, scale: f64) -> Result<ShapeFile, Message> {
    let same = (stretch - DVec3::splat(stretch.x)).abs().max_element() < 1e-9 * stretch.x;
    let factor = Positive::new(scale * stretch.x).filter(|_| same);
    let Some(factor) = factor else { return Err(Message::new("machine-import-mesh-stretched")) };
    let triangles = read_stl(&found.bytes, factor.get()).map_err(|e| Message::from(&e))?;
    Mesh::new(&triangles).map_err(|e| Message::from(&e))?;
    Ok(ShapeFile::Stl { file: found.name.clone(), scale: factor })
}
