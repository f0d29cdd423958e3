//! The parts of a page.

use crate::icon;
use crate::text::{escape, minus};
use crate::words::Words as _;
use seamwright_message::{Language, Message};
use std::fmt::Write;

/// One part of a page, in reading order.
#[derive(Debug, Clone, PartialEq)]
pub enum Block {
    /// Key figures side by side.
    Tiles(Vec<Tile>),
    /// A section heading.
    Heading(String),
    /// Running text.
    Paragraph(String),
    /// A numbered table.
    Table(Table),
    /// A numbered drawing.
    Figure {
        /// Markup from `to_svg` of a drawing of this crate; put into the page as it is.
        svg: String,
        /// Caption of the figure.
        caption: String,
    },
    /// Findings of a check; an empty list is reported as such.
    Findings(Vec<Finding>),
    /// A listing with line numbers, such as a job file.
    Code {
        /// Caption of the listing.
        caption: String,
        /// The text; it may hold anything.
        text: String,
    },
}

/// A key figure.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Tile {
    /// Name of the figure.
    pub label: String,
    /// The number, ready to print.
    pub value: String,
    /// Its unit; may be empty.
    pub unit: String,
    /// Remark below; may be empty.
    pub note: String,
    /// Severity if the figure is out of order.
    pub severity: Option<Severity>,
}

/// Severity of a finding.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// For information.
    Note,
    /// To be reviewed.
    Warning,
    /// To be corrected.
    Error,
}

impl Severity {
    fn class(self) -> &'static str {
        match self {
            Self::Note => "note",
            Self::Warning => "warning",
            Self::Error => "error",
        }
    }

    fn word(self, language: Language) -> String {
        language.words(match self {
            Self::Note => "report-severity-note",
            Self::Warning => "report-severity-warning",
            Self::Error => "report-severity-error",
        })
    }
}

/// Result of a check.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Finding {
    /// Severity.
    pub severity: Severity,
    /// Description.
    pub text: String,
    /// Location; may be empty.
    pub place: String,
    /// Remedy; may be empty.
    pub cure: String,
}

/// A table. Rows are filled up or cut off to the columns of the head.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Table {
    /// Caption of the table.
    pub caption: String,
    /// Column headings.
    pub head: Vec<String>,
    /// Cells, row by row.
    pub rows: Vec<Vec<String>>,
    /// For each column whether it holds numbers, which are set to the right; false if missing.
    pub numeric: Vec<bool>,
}

/// The language of a page, and the numbers given to its tables and figures so far.
#[derive(Debug, Default)]
pub(crate) struct Counters {
    language: Language,
    tables: usize,
    figures: usize,
}

impl Counters {
    pub(crate) fn new(language: Language) -> Self {
        Self { language, ..Self::default() }
    }
}

impl Block {
    pub(crate) fn render(&self, out: &mut String, counters: &mut Counters) {
        let language = counters.language;
        let _ = match self {
            Self::Tiles(tiles) => {
                out.push_str("<div class=\"tiles\">\n");
                tiles.iter().for_each(|t| t.render(out, language));
                writeln!(out, "</div>")
            }
            Self::Heading(text) => writeln!(out, "<h2>{}</h2>", escape(text)),
            Self::Paragraph(text) => writeln!(out, "<p>{}</p>", escape(text)),
            Self::Table(table) => {
                counters.tables += 1;
                table.render(out, counters);
                Ok(())
            }
            Self::Figure { svg, caption } => {
                counters.figures += 1;
                let number = Message::new("report-figure").pass("number", counters.figures).in_language(language);
                let caption = numbered(&number, caption);
                writeln!(out, "<figure><div class=\"drawing\">\n{svg}</div><figcaption>{caption}</figcaption></figure>")
            }
            Self::Findings(findings) if findings.is_empty() => {
                writeln!(out, "<p>{}</p>", language.words("report-no-findings"))
            }
            Self::Findings(findings) => {
                out.push_str("<ul class=\"findings\">\n");
                findings.iter().for_each(|f| f.render(out, language));
                writeln!(out, "</ul>")
            }
            Self::Code { caption, text } => {
                let caption = escape(caption);
                let _ = write!(out, "<figure class=\"code\"><figcaption><b>{caption}</b></figcaption><pre><code>");
                for line in text.lines() {
                    let _ = write!(out, "<span class=\"row\">{}\n</span>", escape(line));
                }
                writeln!(out, "</code></pre></figure>")
            }
        };
    }
}

/// A caption with its number.
fn numbered(number: &str, caption: &str) -> String {
    format!("<b>{number}</b> {}", escape(caption)).trim_end().into()
}

impl Tile {
    fn render(&self, out: &mut String, language: Language) {
        let class = self.severity.map_or(String::new(), |s| format!(" {}", s.class()));
        let sign = self.severity.map_or("", icon::of);
        let word = self.severity.map_or(String::new(), |s| format!("{}: ", s.word(language)));
        let label = escape(&format!("{word}{}", self.label));
        let _ = write!(out, "<dl class=\"tile{class}\">{sign}<dt>{label}</dt><dd class=\"value\">");
        out.push_str(&escape(&minus(&self.value)));
        if !self.unit.is_empty() {
            let _ = write!(out, "<span class=\"unit\">{}</span>", escape(&self.unit));
        }
        out.push_str("</dd>");
        if !self.note.is_empty() {
            let _ = write!(out, "<dd class=\"remark\">{}</dd>", escape(&minus(&self.note)));
        }
        out.push_str("</dl>\n");
    }
}

impl Finding {
    fn render(&self, out: &mut String, language: Language) {
        let (sign, word) = (icon::of(self.severity), self.severity.word(language));
        let _ = write!(out, "<li>{sign}<div><p><b>{word}:</b> {}</p>", escape(&self.text));
        if !self.place.is_empty() {
            let place = Message::new("report-finding-place").text("place", &self.place).in_language(language);
            let _ = write!(out, "<p class=\"place\">{}</p>", escape(&place));
        }
        if !self.cure.is_empty() {
            let cure = Message::new("report-finding-cure").text("cure", &self.cure).in_language(language);
            let _ = write!(out, "<p>{}</p>", escape(&cure));
        }
        out.push_str("</div></li>\n");
    }
}

impl Table {
    fn is_number(&self, column: usize) -> bool {
        self.numeric.get(column).copied().unwrap_or(false)
    }

    fn render(&self, out: &mut String, counters: &Counters) {
        let number = Message::new("report-table").pass("number", counters.tables).in_language(counters.language);
        let caption = numbered(&number, &self.caption);
        let class = |column| if self.is_number(column) { " class=\"number\"" } else { "" };
        let _ = write!(out, "<div class=\"scroll\"><table><caption>{caption}</caption>\n<thead><tr>");
        for (column, text) in self.head.iter().enumerate() {
            let _ = write!(out, "<th scope=\"col\"{}>{}</th>", class(column), escape(text));
        }
        out.push_str("</tr></thead>\n<tbody>\n");
        for row in &self.rows {
            out.push_str("<tr>");
            for column in 0..self.head.len() {
                let text = row.get(column).map_or("", String::as_str);
                let text = if self.is_number(column) { minus(text) } else { text.into() };
                let _ = write!(out, "<td{}>{}</td>", class(column), escape(&text));
            }
            out.push_str("</tr>\n");
        }
        out.push_str("</tbody></table></div>\n");
    }
}
