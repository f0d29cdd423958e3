//! Reads parsed values into types. TOML's own deserializer makes the code of each type several times, for arrays, dates
//! and places in the text as well; of our formats that is a minute of compiling. This one calls only what a type asks
//! for, with one kind of error.

use serde::de::value::StrDeserializer;
use serde::de::{
    DeserializeSeed, Deserializer, EnumAccess, Error, Expected, MapAccess, SeqAccess, Unexpected, VariantAccess,
    Visitor,
};
use std::fmt;
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeString, DeTable, DeValue};

/// A fault in serde's words, with the byte range of the value or key.
#[derive(Debug)]
pub(crate) struct Fault {
    pub(crate) message: String,
    pub(crate) span: Option<Range<usize>>,
}

impl Fault {
    /// Places a fault that has no place yet.
    fn at(mut self, span: Range<usize>) -> Self {
        self.span.get_or_insert(span);
        self
    }
}

impl Error for Fault {
    fn custom<T: fmt::Display>(message: T) -> Self {
        Self { message: message.to_string(), span: None }
    }
}

impl std::error::Error for Fault {}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(&self.message)
    }
}

/// A value in the text.
#[derive(Clone, Copy)]
pub(crate) struct Node<'a>(pub(crate) &'a Spanned<DeValue<'a>>);

impl<'a> Node<'a> {
    /// Reads the value into a type.
    pub(crate) fn read<'de, T: DeserializeSeed<'de>>(self, seed: T) -> Result<T::Value, Fault> {
        seed.deserialize(self).map_err(|fault| fault.at(self.0.span()))
    }

    fn value(self) -> &'a DeValue<'a> {
        self.0.get_ref()
    }

    fn number<'de, V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        match self.value() {
            DeValue::Integer(n) => match i64::from_str_radix(n.as_str(), n.radix()) {
                Ok(n) => visitor.visit_i64(n),
                Err(_) => match u64::from_str_radix(n.as_str(), n.radix()) {
                    Ok(n) => visitor.visit_u64(n),
                    Err(_) => Err(self.mistaken(&visitor)),
                },
            },
            DeValue::Float(n) => match n.as_str().parse::<f64>() {
                Ok(value) if !value.is_infinite() || n.as_str().contains("inf") => visitor.visit_f64(value),
                _ => Err(Fault::custom("floating-point number overflowed")),
            },
            _ => Err(self.mistaken(&visitor)),
        }
    }

    /// The fault of a value of another type than `expected`.
    fn mistaken(self, expected: &dyn Expected) -> Fault {
        let found = match self.value() {
            DeValue::String(text) => Unexpected::Str(text),
            DeValue::Integer(n) => match i128::from_str_radix(n.as_str(), n.radix()) {
                Ok(n) => match (i64::try_from(n), u64::try_from(n)) {
                    (Ok(n), _) => Unexpected::Signed(n),
                    (_, Ok(n)) => Unexpected::Unsigned(n),
                    _ => return Fault::invalid_type(Unexpected::Other(&format!("integer `{n}` as i128")), expected),
                },
                Err(_) => return Fault::custom("integer number overflowed"),
            },
            DeValue::Float(n) => Unexpected::Float(n.as_str().parse().unwrap_or(f64::NAN)),
            DeValue::Boolean(is) => Unexpected::Bool(*is),
            DeValue::Array(_) => Unexpected::Seq,
            DeValue::Datetime(_) | DeValue::Table(_) => Unexpected::Map,
        };
        Fault::invalid_type(found, expected)
    }
}

/// Methods for the types of numbers.
macro_rules! numbers {
    ($($method:ident)*) => {$(
        fn $method<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
            self.number(visitor)
        }
    )*};
}

/// Methods of types that are made of one kind of value.
macro_rules! only {
    ($($kind:ident $($method:ident($($name:ident: $type:ty),*))+ => $visit:expr;)*) => {$($(
        fn $method<V: Visitor<'de>>(self, $($name: $type,)* visitor: V) -> Result<V::Value, Fault> {
            match self.value() {
                DeValue::$kind(value) => $visit(visitor, value),
                _ => Err(self.mistaken(&visitor)),
            }
        }
    )+)*};
}

impl<'de> Deserializer<'de> for Node<'_> {
    type Error = Fault;

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        match self.value() {
            DeValue::String(text) => visitor.visit_str(text),
            DeValue::Integer(_) | DeValue::Float(_) => self.number(visitor),
            DeValue::Boolean(is) => visitor.visit_bool(*is),
            DeValue::Array(items) => visitor.visit_seq(Items::of(items)),
            DeValue::Table(table) => visitor.visit_map(Entries::of(table)),
            DeValue::Datetime(_) => Err(self.mistaken(&visitor)),
        }
    }

    numbers! {
        deserialize_i8 deserialize_i16 deserialize_i32 deserialize_i64 deserialize_u8 deserialize_u16 deserialize_u32
        deserialize_u64 deserialize_f32 deserialize_f64
    }

    only! {
        Boolean deserialize_bool() => |visitor: V, is: &bool| visitor.visit_bool(*is);
        String deserialize_str() deserialize_string() deserialize_char() deserialize_identifier()
            => |visitor: V, text: &DeString| visitor.visit_str(text);
        Array deserialize_seq() => |visitor: V, items| visitor.visit_seq(Items::of(items));
        Table deserialize_map() deserialize_struct(_name: &'static str, _fields: &'static [&'static str])
            => |visitor: V, table| visitor.visit_map(Entries::of(table));
    }

    /// Also fails for more items than `len`: a visitor of few items does not ask for the others.
    fn deserialize_tuple<V: Visitor<'de>>(self, len: usize, visitor: V) -> Result<V::Value, Fault> {
        match self.value() {
            DeValue::Array(items) if items.len() > len => Err(Fault::invalid_length(items.len(), &visitor)),
            DeValue::Array(items) => visitor.visit_seq(Items::of(items)),
            _ => Err(self.mistaken(&visitor)),
        }
    }

    fn deserialize_tuple_struct<V: Visitor<'de>>(
        self,
        _: &'static str,
        len: usize,
        visitor: V,
    ) -> Result<V::Value, Fault> {
        self.deserialize_tuple(len, visitor)
    }

    fn deserialize_option<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        visitor.visit_some(self)
    }

    fn deserialize_newtype_struct<V: Visitor<'de>>(self, _: &'static str, visitor: V) -> Result<V::Value, Fault> {
        visitor.visit_newtype_struct(self)
    }

    fn deserialize_enum<V: Visitor<'de>>(
        self,
        _: &'static str,
        _: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Fault> {
        let span = self.0.span();
        match self.value() {
            DeValue::String(name) => visitor.visit_enum(Variant { name, span, content: None }),
            DeValue::Table(table) => match (table.iter().next(), table.len()) {
                (Some((name, content)), 1) => visitor.visit_enum(Variant {
                    name: name.get_ref(),
                    span: name.span(),
                    content: Some(Node(content)),
                }),
                (None, _) => Err(Fault::custom("wanted exactly 1 element, found 0 elements")),
                _ => Err(Fault::custom("wanted exactly 1 element, more than 1 element")),
            },
            _ => Err(Fault::custom("wanted string or table")),
        }
    }

    fn deserialize_ignored_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Fault> {
        visitor.visit_unit()
    }

    serde::forward_to_deserialize_any! { bytes byte_buf unit unit_struct }
}

/// The items of an array.
struct Items<'a>(std::slice::Iter<'a, Spanned<DeValue<'a>>>);

impl<'a> Items<'a> {
    fn of(items: &'a [Spanned<DeValue<'a>>]) -> Self {
        Self(items.iter())
    }
}

impl<'de> SeqAccess<'de> for Items<'_> {
    type Error = Fault;

    fn next_element_seed<T: DeserializeSeed<'de>>(&mut self, seed: T) -> Result<Option<T::Value>, Fault> {
        self.0.next().map(|item| Node(item).read(seed)).transpose()
    }

    fn size_hint(&self) -> Option<usize> {
        Some(self.0.len())
    }
}

/// The entries of a table, and the content of the entry whose key was read.
struct Entries<'a> {
    rest: toml::map::Iter<'a, Spanned<DeString<'a>>, Spanned<DeValue<'a>>>,
    content: Option<Node<'a>>,
}

impl<'a> Entries<'a> {
    fn of(table: &'a DeTable<'a>) -> Self {
        Self { rest: table.iter(), content: None }
    }
}

impl<'de> MapAccess<'de> for Entries<'_> {
    type Error = Fault;

    fn next_key_seed<K: DeserializeSeed<'de>>(&mut self, seed: K) -> Result<Option<K::Value>, Fault> {
        let Some((key, content)) = self.rest.next() else { return Ok(None) };
        self.content = Some(Node(content));
        seed.deserialize(StrDeserializer::new(key.get_ref())).map(Some).map_err(|fault: Fault| fault.at(key.span()))
    }

    fn next_value_seed<T: DeserializeSeed<'de>>(&mut self, seed: T) -> Result<T::Value, Fault> {
        let content = self.content.take();
        content.ok_or_else(|| Fault::custom("a value without its key")).and_then(|content| content.read(seed))
    }

    fn size_hint(&self) -> Option<usize> {
        Some(self.rest.len())
    }
}

/// A variant of an enum: its name alone, or a table with its name and content.
struct Variant<'a> {
    name: &'a str,
    span: Range<usize>,
    content: Option<Node<'a>>,
}

impl<'de> EnumAccess<'de> for Variant<'_> {
    type Error = Fault;
    type Variant = Self;

    fn variant_seed<T: DeserializeSeed<'de>>(self, seed: T) -> Result<(T::Value, Self), Fault> {
        let name = seed.deserialize(StrDeserializer::new(self.name));
        name.map_err(|fault: Fault| fault.at(self.span.clone())).map(|name| (name, self))
    }
}

impl<'a> Variant<'a> {
    /// The content of a variant that has one.
    fn content(&self, expected: &str) -> Result<Node<'a>, Fault> {
        self.content.ok_or_else(|| Fault::invalid_type(Unexpected::UnitVariant, &expected))
    }
}

impl<'de> VariantAccess<'de> for Variant<'_> {
    type Error = Fault;

    fn unit_variant(self) -> Result<(), Fault> {
        let Some(content) = self.content else { return Ok(()) };
        let message = match content.value() {
            DeValue::Array(items) if items.is_empty() => return Ok(()),
            DeValue::Table(table) if table.is_empty() => return Ok(()),
            DeValue::Array(_) => "expected empty array".to_owned(),
            DeValue::Table(_) => "expected empty table".to_owned(),
            other => format!("expected table, found {}", other.type_str()),
        };
        Err(Fault::custom(message).at(content.0.span()))
    }

    fn newtype_variant_seed<T: DeserializeSeed<'de>>(self, seed: T) -> Result<T::Value, Fault> {
        self.content("newtype variant")?.read(seed)
    }

    fn tuple_variant<V: Visitor<'de>>(self, len: usize, visitor: V) -> Result<V::Value, Fault> {
        let content = self.content("tuple variant")?;
        content.deserialize_tuple(len, visitor).map_err(|fault| fault.at(content.0.span()))
    }

    fn struct_variant<V: Visitor<'de>>(self, fields: &'static [&'static str], visitor: V) -> Result<V::Value, Fault> {
        let content = self.content("struct variant")?;
        content.refuse_other_keys(fields)?;
        content.deserialize_struct("", fields, visitor).map_err(|fault| fault.at(content.0.span()))
    }
}

impl Node<'_> {
    /// Refuses keys of a table other than `fields`.
    fn refuse_other_keys(self, fields: &[&str]) -> Result<(), Fault> {
        let DeValue::Table(table) = self.value() else { return Ok(()) };
        let others: Vec<_> = table.keys().filter(|key| !fields.contains(&key.get_ref().as_ref())).collect();
        let Some(first) = others.first() else { return Ok(()) };
        let names: Vec<&str> = others.iter().map(|key| key.get_ref().as_ref()).collect();
        let message = format!("unexpected keys in table: {}, available keys: {}", names.join(", "), fields.join(", "));
        Err(Fault::custom(message).at(first.span()))
    }
}
