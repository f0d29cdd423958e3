//! History of edits of a text, for undo: patches of the changes, not copies of the text.

use seamwright_document::DocumentError;
use seamwright_message::Message;
use serde::{Deserialize, Deserializer, Serialize};

/// One edit: the position in the text, and the text there before and after.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Patch {
    /// Description of the edit.
    #[serde(deserialize_with = "message_or_text")]
    pub name: Message,
    /// Bytes before the edit's position.
    pub at: usize,
    /// Text before the edit.
    pub removed: String,
    /// Text after the edit.
    pub inserted: String,
}

/// Reads the name of an edit: a message, or the text of a history from before edits had messages.
fn message_or_text<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Message, D::Error> {
    #[derive(Deserialize)]
    #[serde(untagged)]
    enum Name {
        Text(String),
        Message(Message),
    }
    Ok(match Name::deserialize(deserializer)? {
        Name::Text(text) => Message::verbatim(text),
        Name::Message(message) => message,
    })
}

impl Patch {
    /// The edit from `before` to `after`: their common start and end are left out.
    pub fn between(name: Message, before: &str, after: &str) -> Self {
        let same = |(a, b): &(u8, u8)| a == b;
        let mut at = before.bytes().zip(after.bytes()).take_while(same).count();
        while !before.is_char_boundary(at) || !after.is_char_boundary(at) {
            at -= 1;
        }
        let (old, new) = (&before[at..], &after[at..]);
        let mut end = old.bytes().rev().zip(new.bytes().rev()).take_while(same).count();
        while !old.is_char_boundary(old.len() - end) || !new.is_char_boundary(new.len() - end) {
            end -= 1;
        }
        let (removed, inserted) = (&old[..old.len() - end], &new[..new.len() - end]);
        Self { name, at, removed: removed.to_owned(), inserted: inserted.to_owned() }
    }

    /// `text` after the edit; `None` if the removed text is not there.
    fn applied(&self, text: &str) -> Option<String> {
        exchanged(text, self.at, &self.removed, &self.inserted)
    }

    /// `text` before the edit; `None` if the inserted text is not there.
    fn undone(&self, text: &str) -> Option<String> {
        exchanged(text, self.at, &self.inserted, &self.removed)
    }
}

/// Replaces the `from` at `at` of `text` by `to`; in a text that was changed since, the only `from` in it.
fn exchanged(text: &str, at: usize, from: &str, to: &str) -> Option<String> {
    let here = text.get(at..).is_some_and(|rest| rest.starts_with(from));
    let alone = || text.find(from).filter(|i| !from.is_empty() && text.rfind(from) == Some(*i));
    let at = if here { at } else { alone()? };
    Some([&text[..at], to, &text[at + from.len()..]].concat())
}

/// Edits of a text in order, those undone last.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct History {
    patches: Vec<Patch>,
    pub(super) done: usize,
}

/// The first line of a history as a file.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Head {
    /// Version of the format.
    history: u32,
    /// Number of edits that are done; the others are undone.
    done: usize,
    /// Of the text, as it is with these done.
    checksum: String,
}

/// FNV-1a, 64 bits: detects a text that was changed by hand; it does not protect against forgery.
fn checksum(text: &str) -> String {
    let step = |hash: u64, byte: u8| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
    format!("{:016x}", text.bytes().fold(0xcbf2_9ce4_8422_2325, step))
}

impl History {
    /// Adds an edit behind those that are done; those undone are forgotten.
    pub fn push(&mut self, patch: Patch) {
        self.patches.truncate(self.done);
        self.patches.push(patch);
        self.done += 1;
    }

    /// The edits that are done, the first one first.
    pub fn done(&self) -> &[Patch] {
        &self.patches[..self.done]
    }

    /// The edits undone, the next one to be done again first.
    pub fn undone(&self) -> &[Patch] {
        &self.patches[self.done..]
    }

    /// `text` before the last edit, and that edit's name; `None` if there is no edit to undo, or the text differs from
    /// that of the history.
    pub fn undo(&mut self, text: &str) -> Option<(String, Message)> {
        let patch = self.patches.get(self.done.checked_sub(1)?)?;
        let text = patch.undone(text)?;
        self.done -= 1;
        Some((text, patch.name.clone()))
    }

    /// `text` with the next edit redone, and that edit's name; `None` as for [`History::undo`].
    pub fn redo(&mut self, text: &str) -> Option<(String, Message)> {
        let patch = self.patches.get(self.done)?;
        let text = patch.applied(text)?;
        self.done += 1;
        Some((text, patch.name.clone()))
    }

    /// As JSON lines: a head with a checksum of `text`, the text with all edits that are done, and a line an edit.
    ///
    /// # Errors
    /// Not expected: texts and numbers have a JSON form.
    pub fn to_json_lines(&self, text: &str) -> Result<String, serde_json::Error> {
        let head = Head { history: 1, done: self.done, checksum: checksum(text) };
        let mut out = serde_json::to_string(&head)? + "\n";
        for patch in &self.patches {
            out += &serde_json::to_string(patch)?;
            out.push('\n');
        }
        Ok(out)
    }

    /// Reads the lines of [`History::to_json_lines`], with `file` as their name in errors. Returns also whether the
    /// history is that of `text`: false if the text was changed since.
    ///
    /// # Errors
    /// The fault of a line.
    pub fn from_json_lines(file: &str, lines: &str, text: &str) -> Result<(Self, bool), DocumentError> {
        let empty = seamwright_document::Document::<toml::Table>::read(file, "")?;
        let wrong = |line: usize, fault: Message| {
            let message = Message::new("program-history-line").number("line", line as f64, 0).message("fault", fault);
            empty.error_at("", message, Message::new("program-history-format"))
        };
        let unreadable = |line: usize, e: &serde_json::Error| wrong(line, Message::outside(&e));
        let mut rest = lines.lines().enumerate().filter(|(_, line)| !line.trim().is_empty());
        let head = rest.next().ok_or_else(|| wrong(1, Message::new("program-history-empty")))?;
        let head: Head = serde_json::from_str(head.1).map_err(|e| unreadable(1, &e))?;
        let patch = |(i, line): (usize, &str)| serde_json::from_str(line).map_err(|e| unreadable(i + 1, &e));
        let patches: Vec<Patch> = rest.map(patch).collect::<Result<_, _>>()?;
        if head.history != 1 || head.done > patches.len() {
            return Err(wrong(1, Message::new("program-history-head")));
        }
        let is_same = head.checksum == checksum(text);
        Ok((Self { patches, done: head.done }, is_same))
    }

    /// Bytes that it keeps.
    pub fn size(&self) -> usize {
        let name = |message: &Message| size_of_val(message.arguments.as_slice());
        let of = |patch: &Patch| name(&patch.name) + patch.removed.len() + patch.inserted.len();
        self.patches.iter().map(of).sum::<usize>() + self.patches.len() * size_of::<Patch>()
    }
}
