//! The style sheets: colours for light and dark, rules for drawings and for the page.
//!
//! The rules name colours as custom properties. The page defines these; in a standalone SVG plain colours replace them,
//! because most drawing programs do not support custom properties.
//!
//! Series colours follow Okabe and Ito, "Color Universal Design" (2008). They are darkened on white and lightened on
//! black to a contrast of 3 or more to the plot area.

use std::fmt::Write;

const CHART: &str = include_str!("chart.css");
const PAGE: &str = include_str!("page.css");

const FACE: &str = "system-ui,-apple-system,\"Segoe UI\",\"Helvetica Neue\",Arial,\"Liberation Sans\",sans-serif";
const MONO: &str = "ui-monospace,\"SF Mono\",Consolas,\"Liberation Mono\",\"DejaVu Sans Mono\",monospace";

/// A colour: the name of its custom property, and its value in each theme.
#[derive(Clone, Copy)]
struct Colour {
    name: &'static str,
    light: &'static str,
    dark: &'static str,
}

const fn colour(name: &'static str, light: &'static str, dark: &'static str) -> Colour {
    Colour { name, light, dark }
}

/// Colours of drawings and pages.
const COLOURS: [Colour; 20] = [
    colour("--back", "#f4f5f6", "#191b1d"),
    colour("--area", "#ffffff", "#202326"),
    colour("--ink", "#1d1f21", "#e4e6e8"),
    colour("--quiet", "#565c62", "#a3a9af"),
    colour("--faint", "#7d848a", "#7f868c"),
    colour("--strong", "#565c62", "#a3a9af"),
    colour("--edge", "#b4babf", "#4c5359"),
    colour("--grid", "#e4e7e9", "#30353a"),
    colour("--band", "#eceef0", "#2b2f34"),
    colour("--outline", "#8d949a", "#7b8288"),
    colour("--c1", "#0072b2", "#56b4e9"),
    colour("--c2", "#b97700", "#e69f00"),
    colour("--c3", "#00835f", "#2bbf95"),
    colour("--c4", "#b0588a", "#e093bd"),
    colour("--c5", "#2f8fc4", "#9bcdf0"),
    colour("--c6", "#4d4d4d", "#c4c4c4"),
    colour("--c7", "#7a4fb5", "#bda4f0"),
    colour("--c8", "#a0522d", "#d9a07a"),
    colour("--limit", "#c4281c", "#ff7a6b"),
    colour("--fault", "#c4281c", "#e5483a"),
];

/// The warning colour is equal in both themes: yellow contrasts with grey and with black.
const WARN: (&str, &str) = ("--warn", "#f0b400");

#[derive(Clone, Copy)]
enum Theme {
    Light,
    Dark,
}

impl Theme {
    fn of(self, colour: Colour) -> &'static str {
        match self {
            Self::Light => colour.light,
            Self::Dark => colour.dark,
        }
    }

    fn properties(self) -> String {
        COLOURS.iter().fold(format!("{}:{};", WARN.0, WARN.1), |mut css, c| {
            let _ = write!(css, "{}:{};", c.name, self.of(*c));
            css
        })
    }

    /// Returns the drawing rules with every custom property replaced by its value.
    fn plain_rules(self) -> String {
        COLOURS
            .iter()
            .fold(CHART.replace("var(--face)", FACE), |css, c| css.replace(&format!("var({})", c.name), self.of(*c)))
    }
}

/// Returns the style sheet of a page. Paper is white in both themes.
pub(crate) fn page_sheet() -> String {
    format!(
        ":root{{color-scheme:light dark;--face:{FACE};--mono:{MONO};{}}}\n\
         @media screen and (prefers-color-scheme:dark){{:root{{{}}}}}\n\
         @media print{{:root{{color-scheme:light;--back:#ffffff}}}}\n{CHART}{PAGE}",
        Theme::Light.properties(),
        Theme::Dark.properties(),
    )
}

/// Returns the style sheet embedded in a standalone SVG.
pub(crate) fn svg_sheet() -> String {
    format!(
        "\n{}@media screen and (prefers-color-scheme:dark){{\n{}}}\n",
        Theme::Light.plain_rules(),
        Theme::Dark.plain_rules()
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_custom_property_is_defined() {
        assert!(!svg_sheet().contains("var("));
        let page = page_sheet();
        for used in page.split("var(").skip(1) {
            let name = used.split(')').next().unwrap();
            assert!(page.contains(&format!("{name}:")), "{name}");
        }
        assert!(!page.contains(['<', '&']) && !svg_sheet().contains(['<', '&']));
    }

    /// Relative luminance (WCAG 2).
    fn luminance(colour: &str) -> f64 {
        let part = |i: usize| {
            let c = f64::from(u8::from_str_radix(&colour[i..i + 2], 16).unwrap()) / 255.0;
            if c <= 0.04045 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) }
        };
        0.2126 * part(1) + 0.7152 * part(3) + 0.0722 * part(5)
    }

    #[test]
    fn colours_are_legible_on_their_ground() {
        let find = |name: &str| *COLOURS.iter().find(|c| c.name == name).unwrap();
        for theme in [Theme::Light, Theme::Dark] {
            for (name, ground, least) in [
                ("--ink", "--back", 7.0),
                ("--quiet", "--back", 4.5),
                ("--limit", "--area", 4.5),
                ("--c1", "--area", 3.0),
                ("--c2", "--area", 3.0),
                ("--c3", "--area", 3.0),
                ("--c4", "--area", 3.0),
                ("--c5", "--area", 3.0),
                ("--c6", "--area", 3.0),
            ] {
                let a = luminance(theme.of(find(name))) + 0.05;
                let b = luminance(theme.of(find(ground))) + 0.05;
                let contrast = a.max(b) / a.min(b);
                assert!(contrast >= least, "{name} on {ground}: {contrast:.2}");
            }
        }
    }
}
