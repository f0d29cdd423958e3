//! The report as one HTML file.

use crate::block::{Block, Counters};
use crate::icon;
use crate::style::page_sheet;
use crate::text::{escape, fit};
use crate::words::Words as _;
use seamwright_message::Language;
use std::fmt::Write;

/// Result of the report.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Verdict {
    /// Whether everything is in order.
    pub ok: bool,
    /// Summary, or the reasons against it.
    pub text: String,
}

/// A self-contained HTML page: without scripts or other files, for light and dark screens and A4 paper.
///
/// All text is escaped; only the markup of figures is inserted unchanged.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Page {
    /// Language of built-in texts; given texts are already in it.
    pub language: Language,
    /// Title of the document, repeated at the foot of printed pages.
    pub title: String,
    /// Line below the title; may be empty.
    pub subtitle: String,
    /// Title block: names and values.
    pub meta: Vec<(String, String)>,
    /// The result, at the top.
    pub verdict: Option<Verdict>,
    /// The content.
    pub blocks: Vec<Block>,
}

impl Page {
    /// Returns the HTML text, UTF-8; well-formed as XML too.
    pub fn render(&self) -> String {
        let title = escape(&self.title);
        let mut out = String::new();
        let _ = write!(
            out,
            "<!DOCTYPE html>\n<html lang=\"{}\">\n<head>\n<meta charset=\"utf-8\"/>\n\
             <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n\
             <title>{title}</title>\n<style>\n{}{}</style>\n</head>\n<body>\n<main>\n<header>\n<h1>{title}</h1>\n",
            self.language.code(),
            page_sheet(),
            self.paper()
        );
        if !self.subtitle.is_empty() {
            let _ = writeln!(out, "<p class=\"subtitle\">{}</p>", escape(&self.subtitle));
        }
        if !self.meta.is_empty() {
            out.push_str("<dl class=\"meta\">\n");
            for (name, value) in &self.meta {
                let _ = writeln!(out, "<div><dt>{}</dt><dd>{}</dd></div>", escape(name), escape(value));
            }
            out.push_str("</dl>\n");
        }
        if let Some(verdict) = &self.verdict {
            verdict.render(&mut out, self.language);
        }
        out.push_str("</header>\n");
        let mut counters = Counters::new(self.language);
        for block in &self.blocks {
            block.render(&mut out, &mut counters);
        }
        out.push_str("</main>\n</body>\n</html>\n");
        out
    }

    /// Returns the print style: A4 with the title and page numbers at the foot.
    fn paper(&self) -> String {
        format!(
            "@page{{size:A4;margin:15mm 14mm 17mm;\
             @bottom-left{{content:{};font:8pt sans-serif;color:#565c62}}\
             @bottom-right{{content:counter(page) \" / \" counter(pages);font:8pt sans-serif;color:#565c62}}}}\n",
            css_string(&fit(&self.title, 11.0, 560.0))
        )
    }
}

impl Verdict {
    fn render(&self, out: &mut String, language: Language) {
        let (class, sign, word) = if self.ok {
            ("verdict", icon::OK, "report-in-order")
        } else {
            ("verdict bad", icon::ERROR, "report-not-in-order")
        };
        let (word, text) = (language.words(word), escape(&self.text));
        let _ = writeln!(out, "<div class=\"{class}\">{sign}<p><strong>{word}</strong>{text}</p></div>");
    }
}

/// Returns a CSS string with numeric escapes for every character that could end it, the rule or the style element.
fn css_string(text: &str) -> String {
    let mut out = String::from("\"");
    for c in text.chars() {
        if c.is_ascii_alphanumeric() || c == ' ' {
            out.push(c);
        } else {
            let _ = write!(out, "\\{:x} ", c as u32);
        }
    }
    out.push('"');
    out
}
