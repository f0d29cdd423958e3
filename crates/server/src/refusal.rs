//! Reasons why the cell refuses a command, and the panel's words for names of the cell.

use crate::wire::LackView;
use seamwright_message::{Catalogue, Language, Message};

/// Reason why a command is refused.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Lack {
    /// Stable key.
    pub(crate) key: &'static str,
    pub(crate) message: Message,
}

pub(crate) fn lack(key: &'static str, message: impl Into<Message>) -> Lack {
    Lack { key, message: message.into() }
}

impl From<Lack> for LackView {
    fn from(lack: Lack) -> Self {
        Self { key: lack.key.to_owned(), message: lack.message.into() }
    }
}

/// Returns the panel's words for a name of the cell in a group of words, like `mode` and `dry run`. A name without words
/// is shown as it is.
pub(crate) fn panel_word(group: &str, name: &str) -> Message {
    known(group, name).unwrap_or_else(|| Message::verbatim(name))
}

/// Returns the panel's words for an action of the table of permissions.
pub(crate) fn action_word(action: &str) -> Message {
    known("action", action).unwrap_or_else(|| panel_word("do", action))
}

fn known(group: &str, name: &str) -> Option<Message> {
    let name: String = name.chars().filter(|c| *c != ',').map(|c| if " _.".contains(c) { '-' } else { c }).collect();
    let code = format!("panel-{group}-{name}");
    Catalogue::of(Language::English).has(&code).then(|| Message { code: code.into(), arguments: Vec::new() })
}
