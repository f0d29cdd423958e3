use super::routes::routes;
use crate::wire::{FromCell, ToCell, Trouble};
use std::collections::BTreeMap;
use ts_rs::{Config, TS, TypeVisitor};

/// TypeScript declarations by the name of their type, each with the types that it uses.
#[derive(Default)]
pub(super) struct Declarations(BTreeMap<String, String>);

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

/// Returns the TypeScript declarations of all types that cross the wire, generated from the routes and the socket.
pub fn typescript() -> String {
    let mut declarations = Declarations::default();
    declarations.visit::<ToCell>();
    declarations.visit::<FromCell>();
    declarations.visit::<Trouble>();
    for shape in routes().into_iter().flat_map(|route| [route.body, route.answer]).flatten() {
        (shape.declare)(&mut declarations);
    }
    let version = env!("CARGO_PKG_VERSION");
    let types: Vec<String> = declarations.0.into_values().collect();
    format!("// Types of the REST interface and the WebSocket of Seamwright {version}.\n\n{}", types.join("\n"))
}

#[cfg(test)]
mod tests {
    /// The panel's type check finds what is missing otherwise.
    #[test]
    fn types_of_routes_and_of_the_socket_are_declared_once() {
        let text = super::typescript();
        for name in ["Status", "AlarmView", "UserRow", "Trouble", "RefusedView", "AskView", "PathPoint"] {
            assert_eq!(text.matches(&format!("export type {name} = ")).count(), 1, "{name}");
        }
    }
}
