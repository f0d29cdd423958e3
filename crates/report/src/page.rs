//! The report as one HTML file.

use crate::Words as _;
use crate::block::{Block, Counters, facts_list};
use crate::style::page_sheet;
use crate::text::{fit, printable};
use crate::{Language, icon};
use maud::{DOCTYPE, Markup, PreEscaped, html};
use std::fmt::Write;

/// Result of the report.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Verdict {
    /// Whether everything is in order.
    pub ok: bool,
    /// Summary, or the reasons against it.
    pub text: String,
}

/// A self-contained HTML page: without other files, and without scripts unless a table is sortable; for light and dark
/// screens and A4 paper.
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

/// Metadata of a page, closed as in XML.
const META: PreEscaped<&str> =
    PreEscaped("<meta charset=\"utf-8\"/><meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>");

/// Sorts the rows of a table by the column whose heading is clicked, or entered: numbers by value, the second time
/// backwards.
const SORTING: &str = include_str!("sorting.js");

impl Page {
    fn is_sortable(&self) -> bool {
        self.blocks.iter().any(|block| matches!(block, Block::Table(table) if table.sortable))
    }

    /// Returns the HTML text, UTF-8; well-formed as XML too.
    pub fn render(&self) -> String {
        let mut counters = Counters { language: self.language, ..Counters::default() };
        let page = html! {
            (DOCTYPE)
            html lang=(self.language.code()) {
                head {
                    (META)
                    title { (self.title) }
                    style { (PreEscaped(page_sheet())) (PreEscaped(self.paper())) }
                }
                body {
                    main {
                        header {
                            h1 { (self.title) }
                            @if !self.subtitle.is_empty() { p class="subtitle" { (self.subtitle) } }
                            @if !self.meta.is_empty() { (facts_list(&self.meta)) }
                            @if let Some(verdict) = &self.verdict { (verdict.render(self.language)) }
                        }
                        @for block in &self.blocks { (block.render(&mut counters)) }
                    }
                    @if self.is_sortable() { script { (PreEscaped(SORTING)) } }
                }
            }
        };
        printable(page.into_string())
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
    fn render(&self, language: Language) -> Markup {
        let (class, sign, word) = match self.ok {
            true => ("verdict", icon::OK, "report-in-order"),
            false => ("verdict bad", icon::ERROR, "report-not-in-order"),
        };
        html! { div class=(class) { (sign) p { strong { (language.words(word)) } (self.text) } } }
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
