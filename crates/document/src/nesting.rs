//! Depth of tables and lists within each other, checked before a text is parsed.

use crate::document::error_at_span;
use crate::error::DocumentError;
use seamwright_message::Message;
use toml_parser::Source;
use toml_parser::lexer::TokenKind;

/// Maximum number of tables and lists within each other, counting each part of a key, below a header and in the header
/// itself: our formats need less than ten.
///
/// The parser bounds brackets and parts of a key apart. Both together nest thousands of tables in a text of some KiB:
/// to drop these takes more stack than a thread has, which ends the program.
pub(crate) const MAX_NESTING: usize = 32;

/// Refuses a text that nests too deeply to be parsed; `file` is its name in errors.
///
/// # Errors
/// A nested table, list or key beyond the limit, with its line.
pub fn check_nesting(file: &str, text: &str) -> Result<(), DocumentError> {
    // Levels outside of each open bracket, and levels here.
    let (mut outside, mut here) = (Vec::new(), 0);
    for token in Source::new(text).lex() {
        match token.kind() {
            TokenKind::LeftSquareBracket | TokenKind::LeftCurlyBracket => {
                outside.push(here);
                here += 1;
            }
            // One without an opening one is wrong syntax, which the parser reports.
            TokenKind::RightSquareBracket | TokenKind::RightCurlyBracket => here = outside.pop().unwrap_or(here),
            // Of a key, or the decimal point of a number, which counts for nothing else.
            TokenKind::Dot => here += 1,
            TokenKind::Comma => here = outside.last().map_or(here, |levels| levels + 1),
            TokenKind::Newline if outside.is_empty() => here = 0,
            _ => {}
        }
        if here > MAX_NESTING {
            let span = token.span().start()..token.span().end();
            let message = Message::new("document-nested");
            let allowed = Message::new("document-nesting").number("max", MAX_NESTING as f64, 0);
            return Err(error_at_span(file, text, &span, message, allowed));
        }
    }
    Ok(())
}
