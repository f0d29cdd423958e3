use super::error::{Fault, Span};
use super::lexer::same;
use crate::control::{Code, Control};
use seamwright_message::Message;

/// Finds channels and codes by their names in the program.
#[derive(Debug)]
pub(super) struct Addresses {
    /// Channel of each capital letter that is an address.
    letters: [Option<u16>; 26],
    /// Channels of longer addresses.
    names: Vec<(String, u16)>,
    codes: Vec<(u8, u32, Code)>,
    /// The channels X, Y and Z, where there are.
    pub(super) xyz: [Option<usize>; 3],
}

impl Addresses {
    pub(super) fn new(control: &Control) -> Self {
        let mut found = Self { letters: [None; 26], names: Vec::new(), codes: Vec::new(), xyz: [None; 3] };
        for (address, channel) in control.addresses.iter().zip(0u16..) {
            match address.as_bytes() {
                [] => {}
                [letter] if letter.is_ascii_uppercase() => found.letters[usize::from(letter - b'A')] = Some(channel),
                _ => found.names.push((address.clone(), channel)),
            }
        }
        found.xyz = ["x", "y", "z"].map(|name| control.channel(name));
        for (text, code) in &control.codes {
            let number = text.get(1..).and_then(|n| n.parse::<f64>().ok());
            if let (Some(letter), Some(number)) = (text.bytes().next(), number) {
                found.codes.push((letter, (10.0 * number).round() as u32, code.clone()));
            }
        }
        found
    }

    /// Channel whose address is this letter.
    #[inline]
    pub(super) fn letter(&self, letter: u8) -> Option<usize> {
        self.letters.get(usize::from((letter & !0x20).wrapping_sub(b'A'))).copied().flatten().map(usize::from)
    }

    /// Channel whose address is `name`.
    #[inline]
    pub(super) fn name(&self, name: &str) -> Option<usize> {
        match name.as_bytes() {
            [letter] => self.letter(*letter),
            _ => self.names.iter().find(|(n, _)| same(n, name)).map(|(_, channel)| usize::from(*channel)),
        }
    }

    /// Effect of the machine's own code, if this is one: `number` in tenths.
    #[inline]
    pub(super) fn code(&self, letter: u8, number: u32) -> Option<&Code> {
        self.codes.iter().find(|(l, n, _)| (*l, *n) == (letter, number)).map(|(_, _, code)| code)
    }
}

pub(super) fn no_address(control: &Control, span: Span, name: &str) -> Box<Fault> {
    let addresses: Vec<&str> = control.addresses.iter().map(String::as_str).filter(|a| !a.is_empty()).collect();
    let dialect = control.dialect.name();
    let allowed = Message::new("post-addresses-allowed").text("addresses", addresses.join(" "));
    Fault::unknown(span, Message::new("post-no-address").text("name", name))
        .allowed(allowed.text("dialect", dialect))
        .cure(Message::new("post-addresses-cure").text("dialect", dialect))
}
