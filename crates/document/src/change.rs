//! Changes of single entries of a text. Everything else stays byte by byte: comments, order, layout, ends of lines.

use crate::entries::TomlText;
use crate::error::DocumentError;
use crate::key_path::{Step, path_of, steps, written_key};
use schemars::JsonSchema;
use seamwright_message::Message;
use serde::Deserialize;
use serde_json::Value as Given;
use std::ops::Range;
use toml_edit::{Array, InlineTable, Item, Table, TableLike, Value};

/// A change of an entry; paths are those of errors, like `passes[0].points.start[2]`.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(tag = "op", rename_all = "snake_case", deny_unknown_fields)]
pub enum Change {
    /// Sets a value, or adds a key with its value: a table to the root under its own header, otherwise in one line.
    Set {
        /// Path of the value.
        path: String,
        /// Number, text, truth, list or table.
        value: Given,
    },
    /// Removes a key, a table with all tables within it, or an element of a list.
    Remove {
        /// Its path.
        path: String,
    },
    /// Inserts an element into a list before the one at the path, or behind the last one.
    Insert {
        /// Path of the new element.
        path: String,
        /// A value; a table in a list of tables.
        value: Given,
    },
    /// Moves an element of a list.
    Move {
        /// Path of the element.
        path: String,
        /// Its new index.
        to: usize,
    },
    /// Gives a key another name; its value stays.
    Rename {
        /// Path of the key.
        path: String,
        /// The new key.
        key: String,
    },
}

impl Change {
    fn path(&self) -> &str {
        match self {
            Self::Set { path, .. }
            | Self::Remove { path }
            | Self::Insert { path, .. }
            | Self::Move { path, .. }
            | Self::Rename { path, .. } => path,
        }
    }
}

impl TomlText {
    /// Makes changes one after the other; `file` is the name in errors.
    ///
    /// # Errors
    /// A path that is not there, or a change that its place does not allow.
    pub fn changed(self, file: &str, changes: &[Change]) -> Result<Self, DocumentError> {
        changes.iter().try_fold(self, |text, change| {
            let refused = |code| DocumentError::at_key(file, change.path(), Message::new(code));
            let steps = steps(change.path()).ok_or_else(|| refused("document-no-such-entry"))?;
            let source = Source { text: &text.text, root: &text.root };
            let made = source.change(change, &steps).map_err(|Refusal(code)| refused(code))?;
            // Proves that the result is still TOML.
            Self::parse(file, &made)
        })
    }
}

/// Code of the reason why a change is not made.
struct Refusal(&'static str);

const MISSING: Refusal = Refusal("document-no-such-entry");
const UNFIT: Refusal = Refusal("document-unfit-change");

#[derive(Clone, Copy)]
enum Node<'a> {
    Table(&'a Table),
    Tables(&'a toml_edit::ArrayOfTables),
    Value(&'a Value),
}

impl<'a> Node<'a> {
    fn of(item: &'a Item) -> Option<Self> {
        match item {
            Item::None => None,
            Item::Value(value) => Some(Self::Value(value)),
            Item::Table(table) => Some(Self::Table(table)),
            Item::ArrayOfTables(list) => Some(Self::Tables(list)),
        }
    }

    fn step(self, step: &Step) -> Option<Self> {
        match (self, step) {
            (Self::Table(table), Step::Key(key)) => Self::of(table.get(key)?),
            (Self::Value(Value::InlineTable(table)), Step::Key(key)) => table.get(key).map(Self::Value),
            (Self::Tables(list), Step::Nth(nth)) => list.get(*nth).map(Self::Table),
            (Self::Value(Value::Array(list)), Step::Nth(nth)) => list.get(*nth).map(Self::Value),
            _ => None,
        }
    }
}

/// A table under a header of its own.
struct Block {
    steps: Vec<Step>,
    header: Range<usize>,
    /// From the comments directly above its header to its last value, and comments below that belong to no other table.
    range: Range<usize>,
}

struct Source<'a> {
    text: &'a str,
    root: &'a Table,
}

impl<'a> Source<'a> {
    fn change(&self, change: &Change, steps: &[Step]) -> Result<String, Refusal> {
        match change {
            Change::Set { value, .. } => self.set(steps, value),
            Change::Remove { .. } => self.remove(steps),
            Change::Insert { value, .. } => self.insert(steps, value),
            Change::Move { to, .. } => self.moved(steps, *to),
            Change::Rename { key, .. } => self.rename(steps, key),
        }
    }

    fn find(&self, steps: &[Step]) -> Option<Node<'a>> {
        steps.iter().try_fold(Node::Table(self.root), Node::step)
    }

    /// The list or table above the last step.
    fn above<'s>(&self, steps: &'s [Step]) -> Result<(Node<'a>, &'s Step), Refusal> {
        let (last, above) = steps.split_last().ok_or(MISSING)?;
        Ok((self.find(above).ok_or(MISSING)?, last))
    }

    fn with(&self, range: Range<usize>, by: &str) -> String {
        [&self.text[..range.start], by, &self.text[range.end..]].concat()
    }

    fn newline(&self) -> &'static str {
        if self.text.contains("\r\n") { "\r\n" } else { "\n" }
    }

    fn line_start(&self, at: usize) -> usize {
        self.text[..at].rfind('\n').map_or(0, |i| i + 1)
    }

    /// End of the line, in front of its line break.
    fn line_end(&self, at: usize) -> usize {
        let end = self.text[at..].find('\n').map_or(self.text.len(), |i| at + i);
        if self.text[at..end].ends_with('\r') { end - 1 } else { end }
    }

    fn next_line(&self, at: usize) -> usize {
        self.text[at..].find('\n').map_or(self.text.len(), |i| at + i + 1)
    }

    fn is_comment(&self, line: usize) -> bool {
        self.text[line..].trim_start_matches([' ', '\t']).starts_with('#')
    }

    /// Begin of the comments directly above a line, not above `floor`. Comments at the top are the file's.
    fn with_comments(&self, line: usize, floor: usize) -> usize {
        let mut start = line;
        while start > floor {
            let above = self.line_start(start - 1);
            if above < floor || !self.is_comment(above) {
                break;
            }
            start = above;
        }
        if start == 0 { line } else { start }
    }

    /// End of a comma behind an element, or of the element.
    fn with_comma(&self, end: usize) -> usize {
        let behind = self.text[end..].trim_start();
        if behind.starts_with(',') { self.text.len() - behind.len() + 1 } else { end }
    }

    /// The lines of the `nth` element of a list with the comments above, if no other element shares them.
    fn own_lines(&self, elements: &[Range<usize>], nth: usize) -> Option<Range<usize>> {
        let own = elements.get(nth)?;
        let (line, end) = (self.line_start(own.start), self.next_line(own.end));
        let behind = self.text[own.end..end].trim_start().trim_start_matches(',').trim_start();
        let is_alone = self.text[line..own.start].trim().is_empty() && (behind.is_empty() || behind.starts_with('#'));
        let floor = nth.checked_sub(1).map_or(0, |before| self.next_line(elements[before].end));
        is_alone.then(|| self.with_comments(line, floor)..end)
    }

    fn set(&self, steps: &[Step], value: &Given) -> Result<String, Refusal> {
        match self.find(steps) {
            Some(Node::Value(Value::InlineTable(old))) if old.is_dotted() => return Err(UNFIT),
            Some(Node::Value(old)) => return Ok(self.with(old.span().ok_or(UNFIT)?, &written(value)?)),
            Some(_) => return Err(UNFIT),
            None => {}
        }
        let known = (0..steps.len()).rev().find(|n| self.find(&steps[..*n]).is_some()).unwrap_or(0);
        let (above, left) = (self.find(&steps[..known]).ok_or(MISSING)?, &steps[known..]);
        let keys: Option<Vec<&str>> =
            left.iter().map(|step| if let Step::Key(key) = step { Some(key.as_str()) } else { None }).collect();
        let keys = keys.ok_or(MISSING)?;
        let (key, inner) = keys.split_first().ok_or(MISSING)?;
        let wrap = |value: Given, key: &&str| Given::Object([((*key).to_owned(), value)].into_iter().collect());
        let value = inner.iter().rev().fold(value.clone(), wrap);
        match above {
            Node::Table(_) if known == 0 && value.is_object() => self.with_sections(key, &value),
            Node::Table(table) => self.with_line(table, &steps[..known], key, &value),
            Node::Value(Value::InlineTable(table)) => {
                let cells = cells(table)?.into_iter().map(|(_, value)| value).collect::<Vec<_>>();
                let whole = table.span().ok_or(UNFIT)?;
                let entry = format!("{} = {}", written_key(key), written(&value)?);
                let spaced = if cells.is_empty() { format!(" {entry} ") } else { entry };
                Ok(self.inserted(&whole, &cells, cells.len(), &spaced))
            }
            _ => Err(UNFIT),
        }
    }

    /// The text with a table under its own header behind everything else.
    fn with_sections(&self, key: &str, value: &Given) -> Result<String, Refusal> {
        let mut sections = Vec::new();
        write_sections(&written_key(key), value, &mut sections)?;
        let newline = self.newline();
        let sections = sections.join("\n").replace('\n', newline);
        let above = self.text.trim_end();
        let gap = if above.is_empty() { String::new() } else { newline.repeat(2) };
        Ok(format!("{above}{gap}{sections}"))
    }

    /// The text with another key behind the values of a table, in a line of its own.
    fn with_line(&self, table: &Table, steps: &[Step], key: &str, value: &Given) -> Result<String, Refusal> {
        let own = table.iter().filter_map(|(key, item)| {
            let key = table.key(key)?.span()?;
            Some((key, item.as_value()?.span()?))
        });
        let (key, value) = (written_key(key), written(value)?);
        let newline = self.newline();
        let Some((last_key, last)) = own.max_by_key(|(_, value)| value.end) else {
            let block = self.blocks().into_iter().find(|block| block.steps == steps);
            let Some(block) = block else {
                return if steps.is_empty() {
                    Ok(format!("{key} = {value}{newline}{}", self.text))
                } else {
                    Err(UNFIT)
                };
            };
            let at = self.line_end(block.header.end);
            return Ok(self.with(at..at, &format!("{newline}{key} = {value}")));
        };
        // A dotted key names its table: so does the one under it.
        let prefix = &self.text[self.line_start(last_key.start)..last_key.start];
        let at = self.line_end(last.end);
        Ok(self.with(at..at, &format!("{newline}{prefix}{key} = {value}")))
    }

    fn remove(&self, steps: &[Step]) -> Result<String, Refusal> {
        let (above, last) = self.above(steps)?;
        match (above, last, self.find(steps).ok_or(MISSING)?) {
            (Node::Value(Value::Array(list)), Step::Nth(nth), _) => Ok(self.without(&items(list), *nth)),
            (Node::Value(Value::InlineTable(table)), Step::Key(key), _) => {
                let cells = cells(table)?;
                let nth = cells.iter().position(|(of, _)| of == key).ok_or(UNFIT)?;
                Ok(self.without(&cells.into_iter().map(|(_, range)| range).collect::<Vec<_>>(), nth))
            }
            (Node::Table(table), Step::Key(key), Node::Value(value)) => {
                let key = table.key(key).and_then(toml_edit::Key::span).ok_or(UNFIT)?;
                let value = value.span().ok_or(UNFIT)?;
                Ok(self.with(self.line_start(key.start)..self.next_line(value.end), ""))
            }
            _ => self.without_table(steps),
        }
    }

    /// The text without a table, those within it, their comments, and the blank lines behind them.
    fn without_table(&self, steps: &[Step]) -> Result<String, Refusal> {
        let mut ranges: Vec<Range<usize>> =
            self.blocks().into_iter().filter(|block| block.steps.starts_with(steps)).map(|block| block.range).collect();
        if let Some(Node::Table(table)) = self.find(steps)
            && table.is_dotted()
        {
            self.dotted_lines(table, &mut ranges);
        }
        if ranges.is_empty() {
            return Err(UNFIT);
        }
        ranges.sort_by_key(|range| range.start);
        let mut left = self.text.to_owned();
        for range in ranges.into_iter().rev() {
            let behind = left[range.end..].to_owned();
            left.truncate(range.start);
            left.push_str(behind.trim_start_matches(['\n', '\r']));
        }
        Ok(format!("{}{}", left.trim_end(), self.newline()))
    }

    fn dotted_lines(&self, table: &Table, ranges: &mut Vec<Range<usize>>) {
        for (key, item) in table.iter() {
            match (item, table.key(key).and_then(toml_edit::Key::span), item.span()) {
                (Item::Table(inner), ..) if inner.is_dotted() => self.dotted_lines(inner, ranges),
                (Item::Value(_), Some(key), Some(value)) => {
                    ranges.push(self.line_start(key.start)..self.next_line(value.end));
                }
                _ => {}
            }
        }
    }

    /// The text without an element of a list or of an inline table, its comments, and the comma that is left over.
    fn without(&self, elements: &[Range<usize>], nth: usize) -> String {
        let Some(own) = elements.get(nth) else { return self.text.to_owned() };
        if let Some(lines) = self.own_lines(elements, nth) {
            return self.with(lines, "");
        }
        let (end, line) = (self.with_comma(own.end), self.line_start(own.start));
        let before = nth.checked_sub(1).and_then(|before| elements.get(before)).filter(|before| before.end >= line);
        match (elements.get(nth + 1), before) {
            (Some(next), _) if next.start <= self.line_end(end) => self.with(own.start..next.start, ""),
            // The comment of a line is that of all its elements.
            (_, Some(before)) => self.with(before.end..own.end, ""),
            (Some(_), None) => self.with(own.start..self.line_end(end), ""),
            (None, None) => self.with(own.start..end, ""),
        }
    }

    fn insert(&self, steps: &[Step], value: &Given) -> Result<String, Refusal> {
        let (last, list) = steps.split_last().ok_or(MISSING)?;
        let Step::Nth(nth) = last else { return Err(UNFIT) };
        match self.find(list) {
            Some(Node::Value(Value::Array(array))) if *nth <= array.len() => {
                let whole = array.span().ok_or(UNFIT)?;
                Ok(self.inserted(&whole, &items(array), *nth, &written(value)?))
            }
            Some(Node::Tables(tables)) if *nth <= tables.len() => {
                let extents = self.extents(list, tables.len());
                let at = extents.get(*nth).map_or_else(|| extents.last().map(|e| e.end), |e| Some(e.start));
                Ok(self.with_element(at.ok_or(UNFIT)?, list, value)?)
            }
            None if *nth == 0 && list.iter().all(|step| matches!(step, Step::Key(_))) => {
                self.with_element(self.text.len(), list, value)
            }
            _ => Err(MISSING),
        }
    }

    /// The text with an element of a list of tables at a place between others.
    fn with_element(&self, at: usize, list: &[Step], value: &Given) -> Result<String, Refusal> {
        let header = header_of(list);
        let mut lines = format!("[[{header}]]\n");
        for (key, value) in value.as_object().ok_or(UNFIT)? {
            lines += &format!("{} = {}\n", written_key(key), written(value)?);
        }
        let newline = self.newline();
        let (before, behind) = (self.text[..at].trim_end(), self.text[at..].trim_start_matches(['\n', '\r']));
        let gap = |text: &str| if text.is_empty() { "" } else { newline };
        let lines = lines.replace('\n', newline);
        Ok(format!("{before}{}{}{lines}{}{behind}", gap(before), gap(before), gap(behind)))
    }

    /// The text with another element before the `nth` of a list or of an inline table, `whole` with its brackets.
    fn inserted(&self, whole: &Range<usize>, elements: &[Range<usize>], nth: usize, by: &str) -> String {
        let own_line = |element: &Range<usize>| {
            let start = self.line_start(element.start);
            self.text[start..element.start].trim().is_empty().then_some(start..element.start)
        };
        match (elements.get(nth), elements.last()) {
            (Some(next), _) => match (own_line(next), self.own_lines(elements, nth)) {
                (Some(indent), lines) => {
                    let at = lines.map_or(indent.start, |lines| lines.start);
                    self.with(at..at, &format!("{}{by},{}", &self.text[indent], self.newline()))
                }
                (None, _) => self.with(next.start..next.start, &format!("{by}, ")),
            },
            (None, Some(last)) => {
                let Some(indent) = own_line(last).filter(|indent| indent.start > whole.start) else {
                    return self.with(last.end..last.end, &format!(", {by}"));
                };
                let comma = self.with_comma(last.end);
                let [first, second] = if comma > last.end { ["", ","] } else { [",", ""] };
                let end = self.line_end(comma);
                let at = if end < whole.end { end } else { comma };
                let line = format!("{}{}{by}{second}", self.newline(), &self.text[indent]);
                self.with(last.end..at, &format!("{first}{}{line}", &self.text[last.end..at]))
            }
            (None, None) if self.text[whole.start + 1..whole.end - 1].trim().is_empty() => {
                self.with(whole.start + 1..whole.end - 1, by)
            }
            (None, None) => self.with(whole.end - 1..whole.end - 1, by),
        }
    }

    fn moved(&self, steps: &[Step], to: usize) -> Result<String, Refusal> {
        let (above, last) = self.above(steps)?;
        let Step::Nth(nth) = last else { return Err(UNFIT) };
        let elements = match above {
            Node::Value(Value::Array(list)) => items(list),
            Node::Tables(list) => self.extents(&steps[..steps.len() - 1], list.len()),
            _ => return Err(UNFIT),
        };
        let (Some(last), true) = (elements.last(), *nth < elements.len() && to < elements.len()) else {
            return Err(MISSING);
        };
        let is_list = matches!(above, Node::Value(_));
        // Comments move along with elements that have lines of their own.
        let lines: Option<Vec<_>> = (0..elements.len()).map(|i| self.own_lines(&elements, i)).collect();
        let lines = lines.filter(|_| is_list);
        let slots = lines.as_ref().unwrap_or(&elements);
        let mut order: Vec<&Range<usize>> = slots.iter().collect();
        let own = order.remove(*nth);
        order.insert(to, own);
        let mut text = self.text.to_owned();
        for (slot, from) in slots.iter().zip(order).rev() {
            let mut element = self.text[from.clone()].to_owned();
            if lines.is_some() && from.contains(&last.start) && self.with_comma(last.end) == last.end {
                element.insert(last.end - from.start, ',');
            }
            // The last table of a file may lack the end of its line.
            if !is_list && !element.ends_with('\n') {
                element += self.newline();
            }
            text.replace_range(slot.clone(), &element);
        }
        Ok(text)
    }

    /// Positions of the elements of a list of tables, with the tables within them.
    fn extents(&self, list: &[Step], count: usize) -> Vec<Range<usize>> {
        let mut extents: Vec<Option<Range<usize>>> = vec![None; count];
        for block in self.blocks().into_iter().filter(|block| block.steps.starts_with(list)) {
            let Some(Step::Nth(nth)) = block.steps.get(list.len()) else { continue };
            let Some(extent) = extents.get_mut(*nth) else { continue };
            let start = extent.as_ref().map_or(block.range.start, |extent| extent.start);
            *extent = Some(start..block.range.end);
        }
        extents.into_iter().map_while(|extent| extent).collect()
    }

    fn rename(&self, steps: &[Step], key: &str) -> Result<String, Refusal> {
        let (above, last) = self.above(steps)?;
        let Step::Key(old) = last else { return Err(UNFIT) };
        if above.step(&Step::Key(key.to_owned())).is_some() {
            return Err(UNFIT);
        }
        let span = match (above, self.find(steps).ok_or(MISSING)?) {
            (Node::Value(Value::InlineTable(table)), _) => TableLike::key(table, old).and_then(toml_edit::Key::span),
            (Node::Table(table), Node::Value(_)) => table.key(old).and_then(toml_edit::Key::span),
            _ => None,
        };
        if let Some(span) = span {
            return Ok(self.with(span, &written_key(key)));
        }
        let mut text = self.text.to_owned();
        let blocks = self.blocks().into_iter().filter(|block| block.steps.starts_with(steps)).collect::<Vec<_>>();
        for Block { steps: mut of, header, .. } in blocks.into_iter().rev() {
            let bracket = if matches!(of.last(), Some(Step::Nth(_))) { ["[[", "]]"] } else { ["[", "]"] };
            of[steps.len() - 1] = Step::Key(key.to_owned());
            text.replace_range(header, &[bracket[0], &header_of(&of), bracket[1]].concat());
        }
        if text == self.text { Err(UNFIT) } else { Ok(text) }
    }

    /// All tables with headers, in their order.
    fn blocks(&self) -> Vec<Block> {
        let mut blocks = Vec::new();
        headers(self.root, &mut Vec::new(), &mut blocks);
        blocks.sort_by_key(|block: &Block| block.header.start);
        let mut floor = 0;
        for block in &mut blocks {
            let start = self.with_comments(self.line_start(block.header.start), floor);
            let mut end = self.next_line(block.range.end);
            let mut below = end;
            while below < self.text.len() && self.is_comment(below) {
                below = self.next_line(below);
            }
            if self.text[below..].lines().next().is_none_or(|line| line.trim().is_empty()) {
                end = below;
            }
            block.range = start..end;
            floor = end;
        }
        blocks
    }
}

/// Adds the tables with headers; each `range` ends with its last value.
fn headers(table: &Table, path: &mut Vec<Step>, blocks: &mut Vec<Block>) {
    if let Some(header) = crate::entries::header(table).filter(|_| !path.is_empty()) {
        let end = last_value(table).max(header.end);
        blocks.push(Block { steps: path.clone(), header, range: 0..end });
    }
    for (key, item) in table.iter() {
        path.push(Step::Key(key.to_owned()));
        match item {
            Item::Table(inner) => headers(inner, path, blocks),
            Item::ArrayOfTables(list) => {
                for (nth, inner) in list.iter().enumerate() {
                    path.push(Step::Nth(nth));
                    headers(inner, path, blocks);
                    path.pop();
                }
            }
            Item::Value(_) | Item::None => {}
        }
        path.pop();
    }
}

/// End of the last value of a table, also under dotted keys; 0 without any.
fn last_value(table: &Table) -> usize {
    let end = |(_, item): (&str, &Item)| match item {
        Item::Value(value) => value.span().map_or(0, |span| span.end),
        Item::Table(inner) if inner.is_dotted() => last_value(inner),
        _ => 0,
    };
    table.iter().map(end).max().unwrap_or(0)
}

/// The keys of a path, as a header has them.
fn header_of(steps: &[Step]) -> String {
    let keys: Vec<Step> = steps.iter().filter(|step| matches!(step, Step::Key(_))).cloned().collect();
    path_of(&keys)
}

fn items(list: &Array) -> Vec<Range<usize>> {
    list.iter().filter_map(Value::span).collect()
}

/// The entries of an inline table, each with its key. Refuses those with dotted keys, whose parts may lie apart.
fn cells(table: &InlineTable) -> Result<Vec<(String, Range<usize>)>, Refusal> {
    if table.iter().any(|(_, value)| matches!(value, Value::InlineTable(inner) if inner.is_dotted())) {
        return Err(UNFIT);
    }
    let cell = |(key, value): (&str, &Value)| {
        Some((key.to_owned(), TableLike::key(table, key)?.span()?.start..value.span()?.end))
    };
    Ok(table.iter().filter_map(cell).collect())
}

fn written(value: &Given) -> Result<String, Refusal> {
    Ok(match value {
        Given::Null => return Err(UNFIT),
        Given::Bool(truth) => truth.to_string(),
        // Its float format always has a point or an exponent.
        Given::Number(number) if number.is_f64() => format!("{:?}", number.as_f64().unwrap_or_default()),
        Given::Number(number) => number.to_string(),
        Given::String(text) => Value::from(text.as_str()).to_string(),
        Given::Array(list) => format!("[{}]", list.iter().map(written).collect::<Result<Vec<_>, _>>()?.join(", ")),
        Given::Object(table) if table.is_empty() => "{}".to_owned(),
        Given::Object(table) => {
            let entry = |(key, value): (&String, &Given)| Ok(format!("{} = {}", written_key(key), written(value)?));
            format!("{{ {} }}", table.iter().map(entry).collect::<Result<Vec<_>, _>>()?.join(", "))
        }
    })
}

/// Adds a table and those within it under headers; one that holds only tables has none.
fn write_sections(header: &str, value: &Given, sections: &mut Vec<String>) -> Result<(), Refusal> {
    let table = value.as_object().ok_or(UNFIT)?;
    let mut own = String::new();
    for (key, value) in table.iter().filter(|(_, value)| !value.is_object()) {
        own += &format!("{} = {}\n", written_key(key), written(value)?);
    }
    if !own.is_empty() || table.is_empty() {
        sections.push(format!("[{header}]\n{own}"));
    }
    for (key, value) in table.iter().filter(|(_, value)| value.is_object()) {
        write_sections(&format!("{header}.{}", written_key(key)), value, sections)?;
    }
    Ok(())
}

#[cfg(test)]
mod tests;
