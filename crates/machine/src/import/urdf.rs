//! Links and joints of a URDF file (<https://wiki.ros.org/urdf/XML>), in metres and rad as written.

use super::xml::{Element, Place, parse};
use glam::{DAffine3, DMat3, DVec3};
use seamwright_document::DocumentError;
use seamwright_message::Message;
use std::collections::BTreeMap;

/// A robot as described.
#[derive(Debug)]
pub(super) struct Robot<'a> {
    pub(super) name: String,
    /// The element `robot`.
    pub(super) place: Place<'a>,
    pub(super) links: Vec<Link<'a>>,
    pub(super) joints: Vec<Joint<'a>>,
    /// Number of angles that were multiples of 15 degrees with few digits.
    pub(super) rounded_angles: usize,
}

#[derive(Debug)]
pub(super) struct Link<'a> {
    pub(super) name: String,
    pub(super) place: Place<'a>,
    pub(super) collisions: Vec<Collision<'a>>,
    /// The joint that carries it.
    pub(super) carrier: Option<usize>,
}

#[derive(Debug)]
pub(super) struct Collision<'a> {
    pub(super) place: Place<'a>,
    pub(super) origin: DAffine3,
    pub(super) geometry: Geometry,
}

#[derive(Debug)]
pub(super) enum Geometry {
    Box(DVec3),
    Cylinder {
        radius: f64,
        length: f64,
    },
    Sphere {
        radius: f64,
    },
    Mesh {
        name: String,
        scale: DVec3,
    },
    /// Of a kind that the standard does not know.
    Other(String),
}

#[derive(Debug)]
pub(super) struct Joint<'a> {
    pub(super) name: String,
    pub(super) place: Place<'a>,
    /// Position of its type.
    pub(super) kind_place: Place<'a>,
    pub(super) kind: String,
    pub(super) parent: usize,
    pub(super) child: usize,
    pub(super) origin: DAffine3,
    /// Unit direction in the joint's frame.
    pub(super) axis: DVec3,
    pub(super) limit: Option<Limit<'a>>,
    /// The joint that it follows, and where that stands.
    pub(super) mimic: Option<(String, Place<'a>)>,
}

#[derive(Debug)]
pub(super) struct Limit<'a> {
    pub(super) place: Place<'a>,
    pub(super) upper_place: Place<'a>,
    pub(super) velocity_place: Place<'a>,
    pub(super) lower: f64,
    pub(super) upper: f64,
    pub(super) velocity: f64,
    pub(super) effort: Option<f64>,
}

/// Reads a URDF file.
pub(super) fn read<'a>(file: &'a str, text: &'a str) -> Result<Robot<'a>, DocumentError> {
    let document = parse(file, text)?;
    let root = Element::root(file, text, &document);
    if root.node.tag_name().name() != "robot" {
        let fault = Message::new("machine-urdf-root").text("name", root.node.tag_name().name());
        return Err(root.place.error(fault, Message::new("machine-urdf-cure-root")));
    }
    let macros = root.node.descendants().find(|node| node.tag_name().namespace().is_some_and(|n| n.contains("xacro")));
    if macros.is_some() || text.contains("${") {
        let cure = Message::new("machine-urdf-cure-xacro");
        return Err(root.place.error(Message::new("machine-urdf-xacro"), cure));
    }
    Reader { rounded_angles: 0 }.robot(&root)
}

struct Reader {
    rounded_angles: usize,
}

impl Reader {
    fn robot<'i>(mut self, root: &Element<'_, 'i>) -> Result<Robot<'i>, DocumentError> {
        let mut links: Vec<Link<'i>> = Vec::new();
        let mut by_name = BTreeMap::new();
        for element in root.children("link") {
            let link = self.link(&element)?;
            if by_name.insert(link.name.clone(), links.len()).is_some() {
                return Err(taken(&link.place, &link.name));
            }
            links.push(link);
        }
        let mut joints: Vec<Joint<'i>> = Vec::new();
        for element in root.children("joint") {
            let joint = self.joint(&element, &by_name)?;
            if joints.iter().any(|other| other.name == joint.name) {
                return Err(taken(&joint.place, &joint.name));
            }
            if let Some(other) = links[joint.child].carrier.replace(joints.len()) {
                let fault = Message::new("machine-urdf-two-parents").text("link", &links[joint.child].name);
                let fault = fault.text("joint", &joints[other].name);
                return Err(joint.place.error(fault, Message::new("machine-urdf-cure-tree")));
            }
            joints.push(joint);
        }
        let name = root.node.attribute("name").unwrap_or("arm").to_owned();
        Ok(Robot { name, place: root.place.clone(), links, joints, rounded_angles: self.rounded_angles })
    }

    fn link<'i>(&mut self, element: &Element<'_, 'i>) -> Result<Link<'i>, DocumentError> {
        let name = element.required("name")?.to_owned();
        let collisions =
            element.children("collision").iter().map(|c| self.collision(c)).collect::<Result<Vec<_>, _>>()?;
        Ok(Link {
            name,
            place: element.place.clone(),
            collisions: collisions.into_iter().flatten().collect(),
            carrier: None,
        })
    }

    fn collision<'i>(&mut self, element: &Element<'_, 'i>) -> Result<Option<Collision<'i>>, DocumentError> {
        let origin = self.origin(element)?;
        let shape = element.child("geometry").and_then(|g| {
            let inner = g.node.children().find(roxmltree::Node::is_element)?;
            g.child(inner.tag_name().name())
        });
        let Some(shape) = shape else { return Ok(None) };
        let size = |name: &str| -> Result<f64, DocumentError> {
            shape.required(name)?;
            let value = shape.number(name)?.unwrap_or_default();
            if value > 0.0 { Ok(value) } else { Err(not_positive(&shape.place_of(name))) }
        };
        let geometry = match shape.node.tag_name().name() {
            "box" => {
                shape.required("size")?;
                let size = DVec3::from_array(shape.numbers("size")?.unwrap_or_default());
                if size.min_element() <= 0.0 {
                    return Err(not_positive(&shape.place_of("size")));
                }
                Geometry::Box(size)
            }
            "cylinder" => Geometry::Cylinder { radius: size("radius")?, length: size("length")? },
            "sphere" => Geometry::Sphere { radius: size("radius")? },
            "mesh" => {
                let scale = shape.numbers("scale")?.map_or(DVec3::ONE, DVec3::from_array);
                Geometry::Mesh { name: shape.required("filename")?.to_owned(), scale }
            }
            other => Geometry::Other(other.to_owned()),
        };
        Ok(Some(Collision { place: shape.place.clone(), origin, geometry }))
    }

    fn joint<'i>(
        &mut self,
        element: &Element<'_, 'i>,
        links: &BTreeMap<String, usize>,
    ) -> Result<Joint<'i>, DocumentError> {
        let name = element.required("name")?.to_owned();
        let kind = element.required("type")?.to_owned();
        let end = |child: &str| -> Result<usize, DocumentError> {
            let Some(end) = element.child(child) else {
                let fault = Message::new("machine-urdf-element-missing").key("name", child);
                return Err(element.place.error(fault, Message::new("machine-urdf-cure-element").key("name", child)));
            };
            let link = end.required("link")?;
            links.get(link).copied().ok_or_else(|| {
                let known: Vec<&str> = links.keys().map(String::as_str).collect();
                unknown_link(&end.place_of("link"), link, &known)
            })
        };
        let (parent, child) = (end("parent")?, end("child")?);
        let origin = self.origin(element)?;
        // Some files give fixed joints an axis without a direction.
        let axis = element.child("axis").filter(|_| kind != "fixed");
        let axis = axis.map_or(Ok(DVec3::X), |axis| direction(&axis))?;
        let limit = element.child("limit").map(|limit| Self::limit(&limit)).transpose()?;
        let mimic = element
            .child("mimic")
            .map(|mimic| (mimic.node.attribute("joint").unwrap_or_default().to_owned(), mimic.place.clone()));
        let (place, kind_place) = (element.place.clone(), element.place_of("type"));
        Ok(Joint { name, place, kind_place, kind, parent, child, origin, axis, limit, mimic })
    }

    fn limit<'i>(element: &Element<'_, 'i>) -> Result<Limit<'i>, DocumentError> {
        let number = |name: &str| Ok::<_, DocumentError>(element.number(name)?.unwrap_or_default());
        Ok(Limit {
            place: element.place.clone(),
            upper_place: element.place_of("upper"),
            velocity_place: element.place_of("velocity"),
            lower: number("lower")?,
            upper: number("upper")?,
            velocity: number("velocity")?,
            effort: element.number("effort")?.filter(|effort| *effort > 0.0),
        })
    }

    /// The displacement of the element `origin`: turned about fixed x, y and z, then moved.
    fn origin(&mut self, element: &Element<'_, '_>) -> Result<DAffine3, DocumentError> {
        let Some(origin) = element.child("origin") else { return Ok(DAffine3::IDENTITY) };
        let translation = DVec3::from_array(origin.numbers("xyz")?.unwrap_or_default());
        let Some(angles) = origin.angles("rpy")? else { return Ok(DAffine3::from_translation(translation)) };
        self.rounded_angles += angles.iter().filter(|angle| angle.is_rounded).count();
        let [roll, pitch, yaw] = angles.map(|angle| angle.value);
        Ok(DAffine3 { matrix3: fixed_angles(roll, pitch, yaw), translation })
    }
}

/// The unit direction of an element `axis`.
fn direction(axis: &Element<'_, '_>) -> Result<DVec3, DocumentError> {
    let direction = DVec3::from_array(axis.numbers("xyz")?.unwrap_or([1.0, 0.0, 0.0]));
    direction.try_normalize().ok_or_else(|| {
        axis.place_of("xyz").error(Message::new("machine-urdf-axis-zero"), Message::new("machine-urdf-cure-axis"))
    })
}

/// The rotation by `roll`, `pitch` and `yaw` about fixed x, y and z, rad.
pub(super) fn fixed_angles(roll: f64, pitch: f64, yaw: f64) -> DMat3 {
    DMat3::from_rotation_z(yaw) * DMat3::from_rotation_y(pitch) * DMat3::from_rotation_x(roll)
}

/// The error of a name of a link that does not exist.
pub(super) fn unknown_link(place: &Place<'_>, name: &str, known: &[&str]) -> DocumentError {
    let fault = Message::new("machine-urdf-link-unknown").text("link", name);
    let mut error = place.error(fault, Message::new("machine-urdf-cure-link"));
    error.allowed = Some(Message::verbatim(known.join(", ")));
    error
}

fn taken(place: &Place<'_>, name: &str) -> DocumentError {
    let fault = Message::new("machine-urdf-name-taken").text("name", name);
    place.error(fault, Message::new("machine-urdf-cure-name"))
}

fn not_positive(place: &Place<'_>) -> DocumentError {
    place.error(Message::new("machine-urdf-size"), Message::new("machine-urdf-cure-size"))
}
