use fluent_syntax::ast::{Entry, Expression, InlineExpression, Pattern, PatternElement};
use fluent_syntax::parser::parse;
use seamwright_message::{Language, source};
use std::fmt::Write;
use std::path::Path;

/// Areas whose messages people search for, with their titles. Labels of pages and of the panel are not among them.
const AREAS: [(&str, &str); 18] = [
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
    ("schedule", "Schedules of many seams"),
    ("study", "Studies of tolerances"),
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

/// A page of the book below `docs/reference/`.
struct Page {
    file: String,
    text: String,
}

/// The page of an area: each code with its English, cause and cure; then those that are parts of other messages.
fn page(area: &str, title: &str) -> Page {
    let catalogue = source(Language::English, area);
    let resource = parse(catalogue.as_ref()).unwrap();
    let mut text = format!("# {title}\n\n{MADE}");
    let mut parts = String::new();
    for entry in &resource.body {
        let Entry::Message(message) = entry else { continue };
        let code = message.id.name;
        let mut words = String::new();
        message.value.iter().for_each(|value| pattern(value, &mut words));
        // Arguments are in italics, also where the words put them in code.
        let words = words.trim().replace("`*", "*").replace("*`", "*");
        if message.attributes.is_empty() {
            let _ = writeln!(parts, "| `{code}` | {words} |");
            continue;
        }
        let _ = write!(text, "\n## `{code}` {{#{code}}}\n\n> {words}\n");
        for attribute in &message.attributes {
            let name = match attribute.id.name {
                "cause" => "Cause",
                "cure" => "Cure",
                other => panic!("{code} has the attribute .{other}; allowed: .cause, .cure"),
            };
            let mut words = String::new();
            pattern(&attribute.value, &mut words);
            let _ = write!(text, "\n**{name}:** {}\n", words.trim());
        }
    }
    if !parts.is_empty() {
        let _ = write!(text, "\n## Other texts\n\n| code | text |\n|---|---|\n{parts}");
    }
    Page { file: format!("messages/{area}.md"), text }
}

const MADE: &str =
    "Arguments are in italics. This page is made from the catalogues in `messages/en/`; do not edit it.\n";

fn reference() -> Vec<Page> {
    let mut text = "# Messages\n\nFindings, errors of files, refusals, alarms and events have a code. Enter it in the search field, or open the page of\nits first word. Each code has its English text, the cause and the cure.\n\n| codes | page |\n|---|---|\n".to_owned();
    for (area, title) in AREAS {
        let _ = writeln!(text, "| `{}-...` | [{title}](messages/{area}.md) |", area.trim_end_matches('s'));
    }
    let index = Page { file: "messages.md".to_owned(), text };
    std::iter::once(index).chain(AREAS.map(|(area, title)| page(area, title))).collect()
}

/// The pages in the book are those of the catalogues; `SEAMWRIGHT_BLESS=1` writes them.
#[test]
fn the_reference_of_messages_is_current() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/reference");
    for Page { file, text } in reference() {
        let path = folder.join(&file);
        if std::env::var_os("SEAMWRIGHT_BLESS").is_some() {
            std::fs::create_dir_all(folder.join("messages")).unwrap();
            std::fs::write(&path, &text).unwrap();
        }
        let current = std::fs::read_to_string(&path).unwrap_or_default();
        assert!(current == text, "docs/reference/{file}: run this test with SEAMWRIGHT_BLESS=1");
    }
}
