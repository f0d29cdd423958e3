use seamwright_machine::Machine;
use seamwright_message::Message;
use seamwright_project::load::machine_text;
use serde::{Deserialize, Serialize};
use std::path::PathBuf;

/// The text of a machine file, so that two processes read the same machine.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct MachineSource {
    /// Name in messages: the file, or the name of a supplied machine.
    pub name: String,
    /// Contents of the file.
    pub text: String,
    /// Folder to which paths in it are relative.
    pub folder: PathBuf,
}

impl MachineSource {
    /// Reads the machine.
    ///
    /// # Errors
    /// Any fault of the text.
    pub fn read(&self) -> Result<Machine, Message> {
        machine_text(&self.name, &self.text, &self.folder).map_err(|failure| failure.message())
    }
}
