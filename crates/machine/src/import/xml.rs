//! Elements of an XML file with the addresses of their errors.

use super::angle::{Angle, angle};
use roxmltree::{Document, Node, ParsingOptions};
use seamwright_document::DocumentError;
use seamwright_message::Message;
use std::ops::Range;

/// Maximum number of elements and texts of a file: the largest descriptions of robots have some thousands.
const MAX_NODES: u32 = 100_000;

/// Position of an element or attribute, for errors.
#[derive(Debug, Clone)]
pub(super) struct Place<'a> {
    file: &'a str,
    text: &'a str,
    span: Range<usize>,
    /// Path like `joint[elbow].limit.upper`.
    pub(super) key: String,
}

impl Place<'_> {
    /// An error here, with its cure.
    pub(super) fn error(&self, fault: Message, cure: Message) -> DocumentError {
        let mut error = DocumentError::in_text(self.file, self.text, &self.span, self.key.clone(), fault);
        // An element is no value: its address says enough.
        if error.value.starts_with('<') {
            error.value.clear();
        }
        error.help = Some(cure);
        error
    }
}

/// An element.
#[derive(Debug, Clone)]
pub(super) struct Element<'a, 'i> {
    pub(super) node: Node<'a, 'i>,
    pub(super) place: Place<'i>,
}

/// Parses the text of `file`.
pub(super) fn parse<'a>(file: &str, text: &'a str) -> Result<Document<'a>, DocumentError> {
    let options = ParsingOptions { nodes_limit: MAX_NODES, ..ParsingOptions::default() };
    Document::parse_with_options(text, options).map_err(|e| {
        let at = e.pos();
        let line_start: usize =
            text.split_inclusive('\n').take((at.row as usize).saturating_sub(1)).map(str::len).sum();
        let line = text[line_start..].split('\n').next().unwrap_or_default();
        let offset: usize = line.chars().take((at.col as usize).saturating_sub(1)).map(char::len_utf8).sum();
        let start = line_start + offset;
        let place = Place { file, text, span: start..start, key: String::new() };
        let fault = Message::new("machine-urdf-not-xml").message("why", Message::outside(&e));
        place.error(fault, Message::new("machine-urdf-cure-xml"))
    })
}

impl<'a, 'i> Element<'a, 'i> {
    /// The root of a parsed file.
    pub(super) fn root(file: &'i str, text: &'i str, document: &'a Document<'i>) -> Self {
        let node = document.root_element();
        Self { node, place: Place { file, text, span: start_tag(text, &node), key: String::new() } }
    }

    /// Children called `name`; their addresses have their names, or their numbers if they have none.
    pub(super) fn children(&self, name: &str) -> Vec<Element<'a, 'i>> {
        let nodes = self.node.children().filter(|node| node.has_tag_name(name));
        let child = |(i, node): (usize, Node<'a, 'i>)| {
            let path = match node.attribute("name") {
                Some(own) => format!("{name}[{own}]"),
                None if i > 0 => format!("{name}[{}]", i + 1),
                None => name.to_owned(),
            };
            self.inner(node, &path)
        };
        nodes.enumerate().map(child).collect()
    }

    /// The first child called `name`.
    pub(super) fn child(&self, name: &str) -> Option<Element<'a, 'i>> {
        self.node.children().find(|node| node.has_tag_name(name)).map(|node| self.inner(node, name))
    }

    fn inner(&self, node: Node<'a, 'i>, path: &str) -> Element<'a, 'i> {
        let key = if self.place.key.is_empty() { path.to_owned() } else { format!("{}.{path}", self.place.key) };
        Element { node, place: Place { key, span: start_tag(self.place.text, &node), ..self.place.clone() } }
    }

    /// Position of the attribute `name`, or of the element without it.
    pub(super) fn place_of(&self, name: &str) -> Place<'i> {
        match self.node.attribute_node(name) {
            Some(attribute) => {
                let key = format!("{}.{name}", self.place.key);
                Place { key, span: attribute.range_value(), ..self.place.clone() }
            }
            None => self.place.clone(),
        }
    }

    /// The attribute `name`, which must be there.
    pub(super) fn required(&self, name: &str) -> Result<&'a str, DocumentError> {
        self.node.attribute(name).ok_or_else(|| {
            let fault = Message::new("machine-urdf-attribute-missing").key("name", name);
            self.place.error(fault, Message::new("machine-urdf-cure-attribute").key("name", name))
        })
    }

    /// The number in the attribute `name`, if it is there.
    pub(super) fn number(&self, name: &str) -> Result<Option<f64>, DocumentError> {
        Ok(self.numbers::<1>(name)?.map(|[number]| number))
    }

    /// The numbers in the attribute `name`, if it is there.
    pub(super) fn numbers<const N: usize>(&self, name: &str) -> Result<Option<[f64; N]>, DocumentError> {
        let number = |text: &str| text.parse::<f64>().ok().filter(|value| value.is_finite());
        self.read(name, number)
    }

    /// The angles in the attribute `name`, if it is there.
    pub(super) fn angles(&self, name: &str) -> Result<Option<[Angle; 3]>, DocumentError> {
        self.read(name, angle)
    }

    fn read<T, const N: usize>(
        &self,
        name: &str,
        parse: fn(&str) -> Option<T>,
    ) -> Result<Option<[T; N]>, DocumentError> {
        let Some(text) = self.node.attribute(name) else { return Ok(None) };
        let values: Option<Vec<T>> = text.split_ascii_whitespace().map(parse).collect();
        values.and_then(|values| <[T; N]>::try_from(values).ok()).map(Some).ok_or_else(|| {
            let fault = Message::new("machine-urdf-not-numbers").count("n", N);
            self.place_of(name).error(fault, Message::new("machine-urdf-cure-numbers").count("n", N))
        })
    }
}

/// Bytes of an element without its content.
fn start_tag(text: &str, node: &Node<'_, '_>) -> Range<usize> {
    let range = node.range();
    let end = text.get(range.clone()).and_then(|element| element.find('>'));
    range.start..end.map_or(range.end, |end| range.start + end + 1)
}
