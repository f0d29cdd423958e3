use seamwright_document::DocumentError;
use seamwright_message::{Message, display_by_message};
use seamwright_program::Finding;

/// Reason why a seam cannot be taught.
#[derive(Debug)]
pub enum Error {
    /// A fault at an address of a job or program.
    Document(Box<DocumentError>),
    /// The machine cannot weld the nominal seam.
    Findings(Vec<Finding>),
    /// Another reason.
    Refused(Message),
}

impl Error {
    /// Returns its message.
    pub fn message(&self) -> Message {
        match self {
            Self::Document(error) => error.to_message(),
            Self::Findings(findings) => {
                Message::lines(findings.iter().map(|finding| finding.message.clone()).collect())
            }
            Self::Refused(message) => message.clone(),
        }
    }
}

display_by_message!(Error);

impl From<DocumentError> for Error {
    fn from(error: DocumentError) -> Self {
        Self::Document(Box::new(error))
    }
}
