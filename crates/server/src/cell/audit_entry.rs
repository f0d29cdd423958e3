use seamwright_record::Moment;
use seamwright_record::library::AuditEntry;

/// Maximum number of characters of a field of the audit log.
pub(super) const MAX_FIELD_CHARS: usize = 500;

/// Returns true for invisible characters and those that change the look of text: controls, direction marks.
pub(crate) fn hides(c: char) -> bool {
    c.is_control()
        || matches!(c, '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2060}'..='\u{206f}' | '\u{feff}')
}

/// Returns foreign text as one line, with hidden characters escaped.
pub(crate) fn plain(text: &str) -> String {
    let mut out = String::new();
    for (i, c) in text.chars().enumerate() {
        match c {
            _ if i == MAX_FIELD_CHARS => {
                out.push('…');
                break;
            }
            c if hides(c) => out.extend(c.escape_default()),
            c => out.push(c),
        }
    }
    out
}

/// Old and new value of an audited change; both empty if nothing was changed.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Change<'a> {
    pub(crate) old: &'a str,
    pub(crate) new: &'a str,
}

/// Creates an entry from columns that are [`stored`](super::stored_message::stored) already.
pub(super) fn entry(user: &str, station: &str, command: &str, change: Change<'_>, result: &str) -> AuditEntry {
    AuditEntry {
        at: Moment::now(),
        user: plain(user),
        station: station.to_owned(),
        command: command.to_owned(),
        old: plain(change.old),
        new: plain(change.new),
        result: result.to_owned(),
    }
}
