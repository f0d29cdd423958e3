use fluent_syntax::ast::{Entry, Expression, InlineExpression, Pattern, PatternElement};
use fluent_syntax::parser::parse;
use seamwright_message::{Language, source};
use std::fmt::Write;
use std::path::Path;

/// Areas whose messages people search for, with their titles. Labels of pages and of the panel are not among them.
const AREAS: [(&str, &str); 16] = [
    ("document", "Files in general"),
    ("program", "Programs, procedures and edits"),
    ("weld", "Jobs: seams, joints, beads, parts"),
    ("machine", "Machine files, reach, machine check"),
    ("motion", "Findings about motion and their cures"),
    ("geometry", "Geometry"),
    ("clearance", "Solids and distances"),
    ("post", "Part programs"),
    ("vision", "Images and stripes"),
    ("tracking", "Teaching and tracking"),
    ("cell", "The cell: commands, devices, events"),
    ("alarms", "Alarms"),
    ("record", "Records"),
    ("project", "Files, folders, planning"),
    ("server", "The panel's server"),
    ("cli", "The command line"),
];

fn expression(expression: &Expression<&str>, text: &mut String) {
    match expression {
        Expression::Inline(InlineExpression::VariableReference { id }) => {
            let _ = write!(text, "*{}*", id.name);
        }
        Expression::Inline(InlineExpression::StringLiteral { value }) => text.push_str(value),
        Expression::Inline(_) => text.push('…'),
        // The last variant is the one of any number.
        Expression::Select { variants, .. } => {
            if let Some(last) = variants.last() {
                pattern(&last.value, text);
            }
        }
    }
}

/// Appends the words of `of`, arguments in italics.
fn pattern(of: &Pattern<&str>, text: &mut String) {
    for element in &of.elements {
        match element {
            PatternElement::TextElement { value } => {
                text.push_str(&value.replace('\n', " ").replace('|', "\\|").replace('*', "\\*").replace('<', "&lt;"));
            }
            PatternElement::Placeable { expression: inner } => expression(inner, text),
        }
    }
}

/// The reference of messages: each code with its English, and cause and cure where the catalogue has them.
fn reference() -> String {
    let mut page = "# Messages\n\nFindings, errors of files, refusals and events print a code. Search for it here.\nArguments are in italics. This page is made from `messages/en/`; do not edit it.\n".to_owned();
    for (area, title) in AREAS {
        let _ = write!(page, "\n## {title}\n\n| code | message |\n|---|---|\n");
        let text = source(Language::English, area);
        let resource = parse(text.as_ref()).unwrap();
        for entry in &resource.body {
            let Entry::Message(message) = entry else { continue };
            let mut words = String::new();
            message.value.iter().for_each(|value| pattern(value, &mut words));
            for attribute in &message.attributes {
                let _ = write!(words, "<br>*{}*: ", attribute.id.name);
                pattern(&attribute.value, &mut words);
            }
            let _ = writeln!(page, "| `{}` | {} |", message.id.name, words.trim());
        }
    }
    page
}

/// The page in the book is that of the catalogues; `SEAMWRIGHT_BLESS=1` writes it.
#[test]
fn the_reference_of_messages_is_current() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/reference/messages.md");
    let reference = reference();
    if std::env::var_os("SEAMWRIGHT_BLESS").is_some() {
        std::fs::write(&path, &reference).unwrap();
    }
    let current = std::fs::read_to_string(&path).unwrap_or_default();
    assert!(current == reference, "docs/reference/messages.md: run this test with SEAMWRIGHT_BLESS=1");
}
