//! Sub-programs in the same text: Siemens' archive sections and LinuxCNC's O-words.

use super::error::{Fault, Read, Span};
use super::lexer::{Cursor, same};
use crate::control::Dialect;
use seamwright_message::Message;

/// A program within the text.
#[derive(Debug, Clone)]
pub(super) struct Program<'a> {
    pub(super) name: &'a str,
    /// Its first byte, the byte behind it, and its first line.
    pub(super) from: usize,
    pub(super) to: usize,
    pub(super) line: u32,
    /// Remark beside its name.
    pub(super) title: &'a str,
    /// Position at which the text continues behind it: byte and line.
    pub(super) after: (usize, u32),
}

/// All programs of a text, and which one is the main one.
#[derive(Debug)]
pub(super) struct Programs<'a> {
    pub(super) main: Program<'a>,
    pub(super) subs: Vec<Program<'a>>,
}

impl<'a> Programs<'a> {
    /// Looks for sub-programs in `text`.
    pub(super) fn find(text: &'a str, dialect: Dialect) -> Read<Self> {
        let whole = Program { name: "", from: 0, to: text.len(), line: 1, title: "", after: (text.len(), 0) };
        match dialect {
            Dialect::Sinumerik if text.contains("%_N_") || text.contains("%_n_") => sections(text, &whole),
            Dialect::Linuxcnc if text.contains(['o', 'O']) => Ok(Self { main: whole, subs: subroutines(text)? }),
            _ => Ok(Self { main: whole, subs: Vec::new() }),
        }
    }

    pub(super) fn sub(&self, name: &str) -> Option<usize> {
        self.subs.iter().position(|p| same(p.name, name))
    }
}

/// Lines of `text` with their first byte and number.
fn lines(text: &str) -> impl Iterator<Item = (usize, u32, &str)> {
    let start = text.as_ptr() as usize;
    text.split('\n').zip(1..).map(move |(line, number)| (line.as_ptr() as usize - start, number, line))
}

/// Programs that start with lines like `%_N_PASS_1_SPF`. The main one is the first `_MPF`, or the first of all.
fn sections<'a>(text: &'a str, whole: &Program<'a>) -> Read<Programs<'a>> {
    let mut found: Vec<(bool, Program)> = Vec::new();
    for (at, number, line) in lines(text) {
        let head = line.trim();
        if !head.get(..4).is_some_and(|start| same(start, "%_N_")) {
            let blank = head.is_empty() || head.starts_with(';');
            if found.is_empty() && !blank {
                let span = Span { from: at, to: at + line.len() };
                return Err(Fault::new(span, "post-before-first-program").allowed("post-before-first-program-allowed"));
            }
            continue;
        }
        let (name, kind) = head[4..].rsplit_once('_').unwrap_or((&head[4..], ""));
        let span = Span { from: at, to: at + line.len() };
        if let Some((_, last)) = found.last_mut() {
            last.to = at;
        }
        if found.iter().any(|(_, p)| same(p.name, name)) {
            return Err(
                Fault::new(span, Message::new("post-program-twice").text("name", name)).cure("post-program-twice-cure")
            );
        }
        if !same(kind, "MPF") && !same(kind, "SPF") {
            return Err(Fault::new(span, "post-program-kind").allowed("post-program-kind-allowed"));
        }
        let from = (at + line.len() + 1).min(text.len());
        found.push((same(kind, "MPF"), Program { name, from, to: text.len(), line: number + 1, ..whole.clone() }));
    }
    let main = found.iter().position(|(main, _)| *main).unwrap_or(0);
    let subs: Vec<Program> = found.into_iter().map(|(_, program)| program).collect();
    Ok(Programs { main: subs.get(main).unwrap_or(whole).clone(), subs })
}

/// LinuxCNC's subroutines: from `o101 sub` to `o101 endsub`.
fn subroutines(text: &str) -> Read<Vec<Program<'_>>> {
    let mut found: Vec<Program> = Vec::new();
    let mut open: Option<Program> = None;
    for (at, number, line) in lines(text) {
        let mut c = Cursor::new(text, at, at + line.len(), false);
        c.blanks();
        if !matches!(c.peek(), b'o' | b'O') {
            continue;
        }
        let word = c.at;
        let Ok((name, keyword)) = o_word(&mut c) else { continue };
        let span = c.since(word);
        if same(keyword, "sub") {
            if open.is_some() || found.iter().any(|p| same(p.name, name)) {
                let message = Message::new("post-sub-twice").text("name", name);
                return Err(Fault::new(span, message).cure("post-sub-twice-cure"));
            }
            let from = (c.end + 1).min(text.len());
            let title = remark(&mut c);
            open = Some(Program { name, from, to: from, line: number + 1, title, after: (0, 0) });
        } else if same(keyword, "endsub") {
            let Some(mut sub) = open.take().filter(|p| same(p.name, name)) else {
                return Err(Fault::new(span, Message::new("post-endsub-without-sub").text("name", name)));
            };
            sub.to = at;
            sub.after = ((at + line.len() + 1).min(text.len()), number + 1);
            found.push(sub);
        }
    }
    match open {
        None => Ok(found),
        Some(sub) => {
            let end = Span { from: sub.from.saturating_sub(1), to: sub.from };
            Err(Fault::new(end, Message::new("post-sub-without-endsub").text("name", sub.name)))
        }
    }
}

/// Name and keyword of an O-word: `o101 sub`, `o<weld> call`.
pub(super) fn o_word<'a>(c: &mut Cursor<'a>) -> Read<(&'a str, &'a str)> {
    c.at += 1;
    c.blanks();
    let from = c.at;
    let name = if c.take(b'<') {
        c.until('>').ok_or_else(|| Fault::new(c.since(from), "post-name-open"))?.trim()
    } else {
        let from = c.at;
        c.whole()?;
        c.of(c.since(from))
    };
    c.blanks();
    Ok((name, c.letters()))
}

/// The remark in round brackets or behind a semicolon that is next in the line.
pub(super) fn remark<'a>(c: &mut Cursor<'a>) -> &'a str {
    c.blanks();
    match c.peek() {
        b'(' => {
            c.at += 1;
            c.until(')').unwrap_or_default().trim()
        }
        b';' => {
            c.at += 1;
            c.rest()
        }
        _ => "",
    }
}
