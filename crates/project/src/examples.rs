//! The example jobs that ship inside the program.

/// An example job.
pub struct Example {
    /// Its short name.
    pub name: &'static str,
    /// Its TOML.
    pub text: &'static str,
}

macro_rules! examples {
    ($($name:literal),*) => {
        &[$(Example { name: $name, text: include_str!(concat!("../../../examples/", $name, ".toml")) }),*]
    };
}

/// All examples; the first is the one that runs without a verb.
pub const EXAMPLES: &[Example] = examples![
    "saddle",
    "head-nozzle",
    "ellipse",
    "tube-plate",
    "trunnion-saddle",
    "oblique-girth",
    "half-ring",
    "t-joint",
    "knuckle-nozzle",
    "set-in-nozzle",
    "y-branch",
    "taught-saddle",
    "hillside",
    "thick-saddle",
    "weave",
    "radiator"
];
