//! The example jobs that ship inside the program.

/// An example.
pub struct Example {
    /// Its short name.
    pub name: &'static str,
    /// Its TOML.
    pub text: &'static str,
}

/// Distortions of parts that ship inside the program: see `simulate --distortion`.
pub const DISTORTIONS: &[Example] = &[
    Example { name: "misplaced", text: include_str!("../../../examples/distortions/misplaced.toml") },
    Example { name: "half-ring", text: include_str!("../../../examples/distortions/half-ring.toml") },
];

/// Returns the example called `name`.
pub fn example(name: &str) -> Option<&'static Example> {
    EXAMPLES.iter().find(|example| example.name == name)
}

macro_rules! examples {
    ($($name:literal),*) => {
        &[$(Example { name: $name, text: include_str!(concat!("../../../examples/", $name, ".toml")) }),*]
    };
}

/// All examples; the first is the one that runs without a verb.
pub const EXAMPLES: &[Example] = examples![
    "first-weld",
    "saddle",
    "head-nozzle",
    "ellipse",
    "tube-plate",
    "trunnion-saddle",
    "oblique-girth",
    "half-ring",
    "t-joint",
    "spline",
    "points",
    "knuckle-nozzle",
    "set-in-nozzle",
    "y-branch",
    "taught-saddle",
    "hillside",
    "thick-saddle",
    "weave",
    "radiator",
    "narrow-gap-girth"
];
