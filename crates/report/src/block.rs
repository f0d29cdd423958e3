//! The parts of a page.

use crate::Words as _;
use crate::text::minus;
use crate::{Drawing, Language, icon};
use maud::{Markup, PreEscaped, html};
use seamwright_message::{Message, Unit};

/// One part of a page, in reading order.
#[derive(Debug, Clone, PartialEq)]
pub enum Block {
    /// Key figures side by side.
    Tiles(Vec<Tile>),
    /// A section heading.
    Heading(String),
    /// A section heading that begins a printed page.
    Page(String),
    /// Names and values side by side.
    Facts(Vec<(String, String)>),
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
    /// Drawings that take a part of a printed page only.
    Small(Vec<Block>),
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
    /// True if a click on a heading sorts the rows by that column.
    pub sortable: bool,
}

pub(crate) fn heading(code: &'static str, language: Language) -> Block {
    Block::Heading(language.words(code))
}

/// Returns the sections that are not empty, each below its heading.
pub(crate) fn sections(
    sections: impl IntoIterator<Item = (&'static str, Vec<Block>)>,
    language: Language,
) -> impl Iterator<Item = Block> {
    let full = sections.into_iter().filter(|(_, content)| !content.is_empty());
    full.flat_map(move |(code, content)| std::iter::once(heading(code, language)).chain(content))
}

pub(crate) fn paragraph(code: &'static str, language: Language) -> Block {
    Block::Paragraph(language.words(code))
}

pub(crate) fn figure(drawing: &dyn Drawing, caption: &'static str, language: Language) -> Block {
    Block::Figure { svg: drawing.to_svg(), caption: language.words(caption) }
}

pub(crate) fn tile(language: Language, label: &'static str, unit: Unit, value: String, note: String) -> Tile {
    Tile { label: language.words(label), value, unit: language.symbol(unit), note, ..Tile::default() }
}

/// Returns a form to be signed, with the names of those who sign.
pub(crate) fn signatures(signers: [(&'static str, String); 2], language: Language) -> Block {
    Table::of(language, signers)
        .text("", |(role, _)| language.words(role))
        .text("report-column-name", |(_, name)| name.clone())
        .text("report-column-date", |_| String::new())
        .text("report-column-signature", |_| String::new())
        .captioned("report-caption-by-hand")
}

/// A table under construction, with a row for each item.
pub(crate) struct TableOf<T> {
    language: Language,
    items: Vec<T>,
    table: Table,
}

impl<T> TableOf<T> {
    /// Adds a column of texts under the words of the code `head`.
    pub(crate) fn text(self, head: &'static str, cell: impl FnMut(&T) -> String) -> Self {
        let head = self.language.words(head);
        self.column(head, false, cell)
    }

    /// Adds a column of numbers under the words of the code `head`.
    pub(crate) fn number(self, head: &'static str, cell: impl FnMut(&T) -> String) -> Self {
        let head = self.language.words(head);
        self.column(head, true, cell)
    }

    /// Adds a column under a ready heading.
    pub(crate) fn column(mut self, head: String, numeric: bool, cell: impl FnMut(&T) -> String) -> Self {
        self.table.head.push(head);
        self.table.numeric.push(numeric);
        for (row, cell) in self.table.rows.iter_mut().zip(self.items.iter().map(cell)) {
            row.push(cell);
        }
        self
    }

    pub(crate) fn table(self, caption: String) -> Table {
        Table { caption, ..self.table }
    }

    /// Returns the table under the words of the code `caption`.
    pub(crate) fn captioned(self, caption: &'static str) -> Block {
        let caption = self.language.words(caption);
        Block::Table(self.table(caption))
    }
}

/// The language of a page, and the numbers given to its tables and figures so far.
#[derive(Debug, Default)]
pub(crate) struct Counters {
    pub(crate) language: Language,
    pub(crate) tables: usize,
    pub(crate) figures: usize,
}

impl Block {
    pub(crate) fn render(&self, counters: &mut Counters) -> Markup {
        let language = counters.language;
        match self {
            Self::Tiles(tiles) => html! { div class="tiles" { @for tile in tiles { (tile.render(language)) } } },
            Self::Heading(text) => html! { h2 { (text) } },
            Self::Page(text) => html! { h2 class="page" { (text) } },
            Self::Facts(facts) => facts_list(facts),
            Self::Paragraph(text) => html! { p { (text) } },
            Self::Table(table) => {
                counters.tables += 1;
                let number = Message::new("report-table").pass("number", counters.tables).in_language(language);
                table.render(&numbered(&number, &table.caption))
            }
            Self::Figure { svg, caption } => {
                counters.figures += 1;
                let number = Message::new("report-figure").pass("number", counters.figures).in_language(language);
                html! {
                    figure { div class="drawing" { (PreEscaped(svg)) } figcaption { (numbered(&number, caption)) } }
                }
            }
            Self::Small(blocks) => html! { div class="small" { @for block in blocks { (block.render(counters)) } } },
            Self::Findings(findings) if findings.is_empty() => html! { p { (language.words("report-no-findings")) } },
            Self::Findings(findings) => html! {
                ul class="findings" { @for finding in findings { (finding.render(language)) } }
            },
            Self::Code { caption, text } => html! {
                figure class="code" {
                    figcaption { b { (caption) } }
                    pre { code { @for line in text.lines() { span class="row" { (line) "\n" } } } }
                }
            },
        }
    }
}

/// Renders names and values as in a title block.
pub(crate) fn facts_list(facts: &[(String, String)]) -> Markup {
    html! { dl class="meta" { @for (name, value) in facts { div { dt { (name) } dd { (minus(value)) } } } } }
}

fn numbered(number: &str, caption: &str) -> Markup {
    html! { b { (number) } @if !caption.is_empty() { " " (caption) } }
}

impl Tile {
    fn render(&self, language: Language) -> Markup {
        let class = self.severity.map_or("tile".to_owned(), |s| format!("tile {}", s.class()));
        html! {
            dl class=(class) {
                @if let Some(severity) = self.severity { (icon::of(severity)) }
                dt { @if let Some(severity) = self.severity { (severity.word(language)) ": " } (self.label) }
                dd class="value" {
                    (minus(&self.value))
                    @if !self.unit.is_empty() { span class="unit" { (self.unit) } }
                }
                @if !self.note.is_empty() { dd class="remark" { (minus(&self.note)) } }
            }
        }
    }
}

impl Finding {
    fn render(&self, language: Language) -> Markup {
        let place = Message::new("report-finding-place").text("place", &self.place).in_language(language);
        let cure = Message::new("report-finding-cure").text("cure", &self.cure).in_language(language);
        html! {
            li {
                (icon::of(self.severity))
                div {
                    p { b { (self.severity.word(language)) ":" } " " (self.text) }
                    @if !self.place.is_empty() { p class="place" { (place) } }
                    @if !self.cure.is_empty() { p { (cure) } }
                }
            }
        }
    }
}

impl Table {
    pub(crate) fn of<T>(language: Language, items: impl IntoIterator<Item = T>) -> TableOf<T> {
        let items: Vec<T> = items.into_iter().collect();
        let rows = vec![Vec::new(); items.len()];
        TableOf { language, items, table: Self { rows, ..Self::default() } }
    }

    fn is_number(&self, column: usize) -> bool {
        self.numeric.get(column).copied().unwrap_or(false)
    }

    fn cell(&self, row: &[String], column: usize) -> String {
        let text = row.get(column).map_or("", String::as_str);
        if self.is_number(column) { minus(text) } else { text.into() }
    }

    fn render(&self, caption: &Markup) -> Markup {
        let class = |column| self.is_number(column).then_some("number");
        html! {
            div class="scroll" {
                table class=[self.sortable.then_some("sortable")] {
                    caption { (caption) }
                    thead {
                        tr { @for (i, text) in self.head.iter().enumerate() { th scope="col" class=[class(i)] { (text) } } }
                    }
                    tbody {
                        @for row in &self.rows {
                            tr { @for i in 0..self.head.len() { td class=[class(i)] { (self.cell(row, i)) } } }
                        }
                    }
                }
            }
        }
    }
}
