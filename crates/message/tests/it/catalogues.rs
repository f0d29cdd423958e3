use fluent_syntax::ast::{Entry, Expression, InlineExpression, Pattern, PatternElement};
use fluent_syntax::parser::parse;
use seamwright_message::{AREAS, Catalogue, Language, Unit, source};
use std::collections::{BTreeMap, BTreeSet};

/// Adds the names of the arguments in `pattern`, also of those within selectors, to `names`.
fn arguments(pattern: &Pattern<&str>, names: &mut BTreeSet<String>) {
    for element in &pattern.elements {
        if let PatternElement::Placeable { expression } = element {
            of_expression(expression, names);
        }
    }
}

fn of_expression(expression: &Expression<&str>, names: &mut BTreeSet<String>) {
    match expression {
        Expression::Inline(inline) => of_inline(inline, names),
        Expression::Select { selector, variants } => {
            of_inline(selector, names);
            variants.iter().for_each(|variant| arguments(&variant.value, names));
        }
    }
}

fn of_inline(inline: &InlineExpression<&str>, names: &mut BTreeSet<String>) {
    match inline {
        InlineExpression::VariableReference { id } => {
            names.insert(id.name.to_owned());
        }
        InlineExpression::Placeable { expression } => of_expression(expression, names),
        InlineExpression::FunctionReference { arguments, .. } => {
            arguments.positional.iter().for_each(|argument| of_inline(argument, names));
        }
        _ => {}
    }
}

fn codes(language: Language) -> BTreeMap<String, BTreeSet<String>> {
    let mut codes = BTreeMap::new();
    for area in AREAS {
        let text = source(language, area);
        let resource =
            parse(text.as_ref()).unwrap_or_else(|(_, errors)| panic!("{}/{area}.ftl: {errors:?}", language.code()));
        for entry in &resource.body {
            let Entry::Message(message) = entry else { continue };
            let mut names = BTreeSet::new();
            message.value.iter().for_each(|pattern| arguments(pattern, &mut names));
            let twice = codes.insert(message.id.name.to_owned(), names);
            assert!(twice.is_none(), "{}: {} is defined twice", language.code(), message.id.name);
        }
    }
    codes
}

#[test]
fn every_code_has_every_language_with_the_same_arguments() {
    let english = codes(Language::English);
    assert!(english.len() > 30);
    for language in Language::ALL {
        let own = codes(language);
        for (code, names) in &english {
            assert_eq!(own.get(code), Some(names), "{code} in {}", language.code());
        }
        assert_eq!(own.len(), english.len(), "{} has codes that English has not", language.code());
    }
}

#[test]
fn every_unit_has_words() {
    for language in Language::ALL {
        for unit in Unit::ALL.iter().filter(|unit| **unit != Unit::One) {
            assert!(Catalogue::of(language).has(&unit.identifier()), "{} in {}", unit.identifier(), language.code());
        }
    }
}

/// Words of a pattern outside of its arguments, of at least four letters.
fn words(pattern: &Pattern<&str>, found: &mut Vec<String>) {
    for element in &pattern.elements {
        match element {
            PatternElement::TextElement { value } => {
                let quoted = value.split('`').step_by(2);
                let words = quoted.flat_map(|text| text.split(|c: char| !c.is_alphabetic()));
                found.extend(words.filter(|word| word.chars().count() > 3).map(str::to_owned));
            }
            PatternElement::Placeable { expression: Expression::Select { variants, .. } } => {
                variants.iter().for_each(|variant| words(&variant.value, found));
            }
            PatternElement::Placeable { .. } => {}
        }
    }
}

/// Codes of a language with their text as written, and whether it has words of its own.
fn texts(language: Language) -> BTreeMap<String, (String, bool)> {
    let mut texts = BTreeMap::new();
    for area in AREAS {
        let text = source(language, area);
        let Ok(resource) = parse(text.as_ref()) else { continue };
        for entry in &resource.body {
            let Entry::Message(message) = entry else { continue };
            let mut found = Vec::new();
            message.value.iter().for_each(|pattern| words(pattern, &mut found));
            texts.insert(message.id.name.to_owned(), (format!("{:?}", message.value), !found.is_empty()));
        }
    }
    texts
}

/// Words that are the same in every language: names, units, formats. One code a line.
const INTERNATIONAL: &str = include_str!("../../../../messages/international.txt");

#[test]
fn translations_differ_from_english() {
    let english = texts(Language::English);
    let international: BTreeSet<&str> = INTERNATIONAL.lines().filter(|line| !line.starts_with('#')).collect();
    let mut same = BTreeSet::new();
    for language in Language::ALL.into_iter().filter(|language| *language != Language::English) {
        for (code, (text, has_words)) in texts(language) {
            if has_words && english[&code].0 == text {
                same.insert(code);
            }
        }
    }
    let new: Vec<&String> = same.iter().filter(|code| !international.contains(code.as_str())).collect();
    assert!(new.is_empty(), "not translated: {new:?}");
    let gone: Vec<&&str> = international.iter().filter(|code| !same.contains(**code)).collect();
    assert!(gone.is_empty(), "in messages/international.txt, but translated or gone: {gone:?}");
}
