use super::composition::Composition;
use super::cooling_time::ShapeFactors;
use crate::joint::FilletOrButt;
use crate::procedure::Window;
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use seamwright_document::{Document, DocumentError, Finite, Positive, fault_in_serde};
use seamwright_message::Message;
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize};
use std::borrow::Cow;

/// Base materials and weld metal, for carbon equivalents, preheat and cooling time by EN 1011-2.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Materials {
    /// The first part: nozzle, tube, wall.
    pub first: Material,
    /// The second part: body, plate; like the first if missing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub second: Option<Material>,
    /// The weld metal.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub weld_metal: Option<WeldMetal>,
    /// Temperature of the work before the first pass, degrees Celsius, if it is not preheated; 20 if missing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub work_c: Option<Finite>,
    /// Allowed cooling time from 800 to 500 degrees Celsius, s.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub t85_s: Option<Window>,
    /// Shape factors of the cooling time; if missing those of EN 1011-2 for runs in a butt weld (0.9 and 0.9) or for a
    /// fillet (0.67 and 0.67).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub shape_factors: Option<ShapeFactors>,
}

/// A base material, by composition or group.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Material {
    /// Name, for people, like `P355GH`.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub name: String,
    /// Group of ISO/TR 15608, like `"1.2"`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub group: Option<MaterialGroup>,
    /// Thickness, mm; if missing that of the joint.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub thickness_mm: Option<Positive>,
    /// Composition, % of mass; required unless `group` is given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub composition: Option<Composition>,
}

/// The weld metal.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WeldMetal {
    /// Designation, for people, like `ISO 14341-A G 42 4 M21 3Si1`.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub name: String,
    /// Diffusible hydrogen, ml in 100 g of weld metal (ISO 3690): 5, 10 or 15 of the classes H5, H10, H15.
    pub hydrogen_ml_100g: Positive,
    /// Composition, % of mass; only carbon equivalents of the base materials count if missing.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub composition: Option<Composition>,
}

/// A group of materials of ISO/TR 15608: main group and perhaps subgroup, like `"1"` or `"8.1"`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct MaterialGroup(String);

/// Main groups: steels, aluminium, copper, nickel, titanium, zirconium, cast irons.
const GROUPS: [(u8, u8); 7] = [(1, 11), (21, 26), (31, 38), (41, 48), (51, 54), (61, 62), (71, 76)];

impl MaterialGroup {
    fn new(text: &str) -> Option<Self> {
        let (main, sub) = text.split_once('.').map_or((text, None), |(main, sub)| (main, Some(sub)));
        let digits = |part: &str| !part.starts_with('0') && part.bytes().all(|b| b.is_ascii_digit());
        let number = Some(main).filter(|main| digits(main))?.parse::<u8>().ok()?;
        let known = GROUPS.iter().any(|(first, last)| (*first..=*last).contains(&number));
        let sub = sub.is_none_or(|sub| digits(sub) && (1..=2).contains(&sub.len()));
        (known && sub).then(|| Self(text.to_owned()))
    }
}

impl std::fmt::Display for MaterialGroup {
    fn fmt(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
        f.write_str(&self.0)
    }
}

impl<'de> Deserialize<'de> for MaterialGroup {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let text = String::deserialize(deserializer)?;
        Self::new(&text).ok_or_else(|| {
            let fault = Message::new("program-material-group-invalid").text("group", text);
            D::Error::custom(fault_in_serde(&fault, &Message::new("program-material-groups")))
        })
    }
}

impl JsonSchema for MaterialGroup {
    fn schema_name() -> Cow<'static, str> {
        "MaterialGroup".into()
    }
    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "description": "A group of materials of ISO/TR 15608: main group and perhaps subgroup.",
            "type": "string", "pattern": "^[1-9][0-9]?(\\.[1-9][0-9]?)?$"
        })
    }
}

impl Materials {
    /// The second part's material: that of the first if the file has none.
    pub fn second(&self) -> &Material {
        self.second.as_ref().unwrap_or(&self.first)
    }

    /// CET that decides on the preheat, %: of the base material with the higher one, or of the weld metal and 0.03 if
    /// that is more (EN 1011-2, C.3). `None` without the composition of a base material.
    pub fn decisive_cet(&self) -> Option<f64> {
        let cet = |composition: &Composition| composition.carbon_equivalents().cet;
        let base = [&self.first, self.second()].into_iter().filter_map(|m| m.composition.as_ref()).map(cet);
        let base = base.reduce(f64::max)?;
        let filler = self.weld_metal.as_ref().and_then(|metal| metal.composition.as_ref()).map(cet);
        Some(filler.map_or(base, |filler| base.max(filler + WELD_METAL_CET)))
    }

    /// Shape factors F2 and F3 of the cooling time.
    pub fn shape_factors(&self, joint: FilletOrButt) -> (f64, f64) {
        let usual = match joint {
            FilletOrButt::Butt => (0.9, 0.9),
            FilletOrButt::Fillet => (0.67, 0.67),
        };
        self.shape_factors.map_or(usual, |given| (given.two_dimensional.get(), given.three_dimensional.get()))
    }

    /// Checks the table `path` of a file.
    ///
    /// # Errors
    /// With the key's address: a material without composition and group, a composition that is impossible.
    pub fn check<T>(&self, file: &Document<T>, path: &str) -> Result<(), DocumentError> {
        let parts = [("first", Some(&self.first)), ("second", self.second.as_ref())];
        for (key, part) in parts.into_iter().filter_map(|(key, part)| Some((key, part?))) {
            let path = format!("{path}.{key}");
            match &part.composition {
                Some(composition) => composition.check(file, &format!("{path}.composition"))?,
                None if part.group.is_none() => {
                    let allowed = Message::new("program-composition-or-group");
                    return Err(file.error_at(&path, Message::new("program-material-unknown"), allowed));
                }
                None => {}
            }
        }
        match self.weld_metal.as_ref().and_then(|metal| metal.composition.as_ref()) {
            Some(composition) => composition.check(file, &format!("{path}.weld_metal.composition")),
            None => Ok(()),
        }
    }
}

/// The weld metal's CET counts with this added, %: it has been alloyed to be as strong with less carbon.
const WELD_METAL_CET: f64 = 0.03;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn groups_are_those_of_the_standard() {
        for known in ["1", "1.2", "11.3", "8.1", "23.1", "45", "51.4", "76.1"] {
            assert_eq!(MaterialGroup::new(known).unwrap().to_string(), known);
        }
        for unknown in ["", "0", "12", "20", "1.", ".2", "1.0", "1.123", "P355", "-1", "1 .2", "300", "63"] {
            assert!(MaterialGroup::new(unknown).is_none(), "{unknown}");
        }
    }

    #[test]
    fn the_harder_part_decides() {
        let materials = |filler: &str| -> Materials {
            let text = format!(
                "first.composition = {{ C = 0.18, Mn = 1.5 }}\nsecond.composition = {{ C = 0.1, Mn = 0.5 }}\n{filler}"
            );
            toml::from_str(&text).unwrap()
        };
        let cet = |filler| materials(filler).decisive_cet().unwrap();
        assert!((cet("") - 0.33).abs() < 1e-12);
        let weak = "weld_metal = { hydrogen_ml_100g = 5, composition = { C = 0.08, Mn = 1.4 } }";
        assert!((cet(weak) - 0.33).abs() < 1e-12);
        let strong = "weld_metal = { hydrogen_ml_100g = 5, composition = { C = 0.1, Mn = 1.8, Mo = 0.5, Ni = 2 } }";
        assert!((cet(strong) - (0.1 + 0.23 + 0.05 + 0.03)).abs() < 1e-12);
        let group: Materials = toml::from_str("first.group = \"1.2\"").unwrap();
        assert_eq!(group.decisive_cet(), None);
    }
}
