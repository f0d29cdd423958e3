use std::collections::BTreeMap;
use ts_rs::{Config, TS, TypeVisitor};

/// TypeScript declarations by the name of their type, each with the types that it uses.
#[derive(Default)]
pub(super) struct Declarations(pub(super) BTreeMap<String, String>);

impl TypeVisitor for Declarations {
    fn visit<T: TS + 'static + ?Sized>(&mut self) {
        let config = Config::default();
        // Only types of our own have a path; numbers, lists and options are written in place.
        let (name, is_own) = (T::ident(&config), T::output_path().is_some());
        if is_own && !self.0.contains_key(&name) {
            self.0.insert(name, format!("{}export {}\n", T::docs().unwrap_or_default(), T::decl(&config)));
            T::visit_dependencies(self);
        }
        T::visit_generics(self);
    }
}
