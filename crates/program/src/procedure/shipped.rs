/// A procedure file that ships with the program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ShippedProcedure {
    /// Name used in job files.
    pub name: &'static str,
    /// The file's text.
    pub text: &'static str,
}

macro_rules! ship {
    ($($name:literal),*) => {
        &[$(ShippedProcedure {
            name: $name,
            text: include_str!(concat!("../../../../examples/procedures/", $name, ".toml")),
        }),*]
    };
}

/// All procedure files that ship.
pub const PROCEDURES: &[ShippedProcedure] = ship!["135-saddle", "121-girth"];

/// The shipped procedure file called `name`.
pub fn shipped_procedure(name: &str) -> Option<ShippedProcedure> {
    PROCEDURES.iter().copied().find(|p| p.name == name)
}
