use super::declarations::Declarations;
use super::routes::routes;
use crate::wire::{FromCell, ToCell, Trouble};
use ts_rs::TypeVisitor as _;

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
