use crate::program::Program;
use glam::DAffine3;
use schemars::JsonSchema;
use seamwright_document::{Document, DocumentError, Transform};
use seamwright_message::Message;
use serde::{Deserialize, Serialize};
use std::num::NonZeroU32;

/// The seam once more: the same seam, joint and passes at another place of the part.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SeamCopy {
    /// Name, for people.
    pub name: String,
    /// The row in which it stands, from 1; copies without one stand in row 1.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub row: Option<NonZeroU32>,
    /// The seam's frame in the part's frame.
    #[serde(default, skip_serializing_if = "Transform::is_identity")]
    pub placement: Transform,
}

impl SeamCopy {
    /// Checks the copies of a file against its own `placement`, which they replace.
    ///
    /// # Errors
    /// With the key's address: a name twice, a placement beside copies.
    pub fn check<T>(file: &Document<T>, copies: &[Self], placement: &Transform) -> Result<(), DocumentError> {
        if !copies.is_empty() && !placement.is_identity() {
            let message = Message::new("program-copies-and-placement");
            return Err(file.error_at("placement", message, Message::new("program-no-placement")));
        }
        for (i, copy) in copies.iter().enumerate() {
            if let Some(k) = copies[..i].iter().position(|other| other.name == copy.name) {
                let message = Message::new("program-name-taken").key("other", format!("copies[{k}]"));
                return Err(file.error_at(&format!("copies[{i}].name"), message, Message::new("document-own-name")));
            }
            if let Some(k) = copies[..i].iter().position(|other| other.placement == copy.placement) {
                let message = Message::new("program-placement-taken").key("other", format!("copies[{k}]"));
                let allowed = Message::new("program-own-placement");
                return Err(file.error_at(&format!("copies[{i}].placement"), message, allowed));
            }
        }
        Ok(())
    }
}

impl Program {
    /// Frame of copy `copy` of the seam: maps the seam's frame to the machine's work frame, by way of the part's. In a
    /// program without copies it is the seam itself.
    pub fn copy_in_work(&self, copy: usize) -> DAffine3 {
        let placement = self.copies.get(copy).map_or(&self.placement, |copy| &copy.placement);
        self.work_offset() * placement.affine()
    }

    /// Frame of the seam, or of the first of its copies, in the work frame.
    pub fn seam_in_work(&self) -> DAffine3 {
        self.copy_in_work(0)
    }

    /// Number of copies at which the seam is welded.
    pub fn copy_count(&self) -> usize {
        self.copies.len().max(1)
    }

    /// Name of a pass' copy, if the program has copies.
    pub fn copy_name(&self, copy: usize) -> Option<&str> {
        self.copies.get(copy).map(|copy| copy.name.as_str())
    }
}
