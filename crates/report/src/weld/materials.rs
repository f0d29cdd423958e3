//! Base materials and weld metal, preheat and cooling time.

use super::figures::{PassFigures, WeldReport};
use super::joint_facts::capitalised;
use super::range::Range;
use crate::number::{NONE, fixed, number, quantity, significant};
use crate::{Block, Language, Table, Words as _};
use seamwright_document::Positive;
use seamwright_message::{Message, Unit};
use seamwright_motion::{PassHeat, ROOM_C};
use seamwright_program::{CarbonEquivalents, Composition, Material, Materials};
use serde::Serialize;

/// Base materials and weld metal of a weld.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MaterialsFigures {
    /// The first part.
    pub first: MaterialFigures,
    /// The second part.
    pub second: MaterialFigures,
    /// The weld metal, if it is given.
    pub weld_metal: Option<MaterialFigures>,
    /// CET that decides on the preheat, %.
    pub decisive_cet: Option<f64>,
    /// Diffusible hydrogen, ml in 100 g of weld metal.
    pub hydrogen_ml_100g: Option<f64>,
}

/// A material with its carbon equivalents.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MaterialFigures {
    /// Name.
    pub name: String,
    /// Group of ISO/TR 15608.
    pub group: Option<String>,
    /// Thickness, mm.
    pub thickness_mm: Option<f64>,
    /// Carbon equivalents, if the composition is known.
    pub carbon_equivalents: Option<CarbonEquivalents>,
}

impl MaterialFigures {
    fn of(material: &Material) -> Self {
        Self {
            name: material.name.clone(),
            group: material.group.as_ref().map(ToString::to_string),
            thickness_mm: material.thickness_mm.map(Positive::get),
            carbon_equivalents: material.composition.as_ref().map(Composition::carbon_equivalents),
        }
    }
}

impl MaterialsFigures {
    pub(super) fn new(materials: &Materials) -> Self {
        let weld_metal = materials.weld_metal.as_ref();
        Self {
            first: MaterialFigures::of(&materials.first),
            second: MaterialFigures::of(materials.second()),
            weld_metal: weld_metal.map(|metal| MaterialFigures {
                name: metal.name.clone(),
                group: None,
                thickness_mm: None,
                carbon_equivalents: metal.composition.as_ref().map(Composition::carbon_equivalents),
            }),
            decisive_cet: materials.decisive_cet(),
            hydrogen_ml_100g: weld_metal.map(|metal| metal.hydrogen_ml_100g.get()),
        }
    }

    fn table(&self, language: Language) -> Block {
        let parts = [
            ("report-first-part", Some(&self.first)),
            ("report-second-part", Some(&self.second)),
            ("report-weld-metal", self.weld_metal.as_ref()),
        ];
        let rows = parts.into_iter().filter_map(|(part, material)| Some((part, material?)));
        let none = || NONE.to_owned();
        let percent = |m: &MaterialFigures, of: fn(&CarbonEquivalents) -> f64| {
            m.carbon_equivalents.as_ref().map_or_else(none, |all| fixed(of(all), 3, language))
        };
        let mut caption = vec![Message::new("report-caption-materials")];
        let decisive = self.decisive_cet.zip(self.hydrogen_ml_100g).map(|(cet, hydrogen)| {
            let message = Message::new("report-materials-decisive").quantity("cet", cet, Unit::Percent, 3);
            message.value("hydrogen", hydrogen, Unit::One)
        });
        caption.extend(decisive);
        let caption: Vec<String> = caption.iter().map(|message| message.in_language(language)).collect();
        let table = Table::of(language, rows)
            .text("", |(part, _)| language.words(part))
            .text("report-column-name", |(_, m)| m.name.clone())
            .text("report-column-group", |(_, m)| m.group.clone().unwrap_or_else(none))
            .number("report-column-thickness", |(_, m)| m.thickness_mm.map_or_else(none, |mm| number(mm, language)))
            .number("report-column-ce", |(_, m)| percent(m, |all| all.ce_iiw))
            .number("report-column-cet", |(_, m)| percent(m, |all| all.cet))
            .number("report-column-pcm", |(_, m)| percent(m, |all| all.pcm));
        Block::Table(table.table(language.sentences(&caption)))
    }
}

impl WeldReport {
    /// Returns the materials, and preheat and cooling time of each pass.
    pub(super) fn metallurgy(&self, language: Language) -> Vec<Block> {
        let Some(materials) = &self.materials else { return Vec::new() };
        let mut blocks = vec![materials.table(language)];
        if let Some(heat) = self.passes.iter().find_map(|pass| pass.heat) {
            let caption = Message::new("report-caption-heat").quantity("thickness", heat.thickness_mm, Unit::Mm, 1);
            blocks.push(Block::Table(self.by_pass(self.heat_table(language, caption.in_language(language)), language)));
        }
        blocks
    }

    fn heat_table(&self, language: Language, caption: String) -> Table {
        let of = |pass: &PassFigures, text: &dyn Fn(&PassHeat) -> String| {
            pass.heat.as_ref().map_or_else(|| NONE.to_owned(), text)
        };
        let range = |ends: (f64, f64)| Range::from(ends).short_text(language);
        let preheat = |heat: &PassHeat| match heat.preheat_c {
            Some(needed) if needed > ROOM_C => fixed(needed, 0, language),
            Some(_) => language.words("report-no-preheat"),
            None => NONE.to_owned(),
        };
        Table::of(language, &self.passes)
            .number("report-column-heat-input", |pass| of(pass, &|heat| range(heat.heat_input_kj_mm)))
            .number("report-column-preheat", |pass| of(pass, &preheat))
            .number("report-column-work", |pass| of(pass, &|heat| range(heat.work_c)))
            .number("report-column-t85", |pass| of(pass, &|heat| range(heat.t85_s)))
            .text("report-column-heat-flow", |pass| of(pass, &|heat| heat.heat_flow.name().to_owned()))
            .table(caption)
    }

    /// Returns names of materials for the facts of the joint.
    pub(super) fn material_facts(&self, language: Language) -> Vec<(String, String)> {
        let Some(materials) = &self.materials else { return Vec::new() };
        let text = |material: &MaterialFigures| {
            let group = material.group.as_ref().map(|group| Message::new("report-material-group").text("group", group));
            let mut parts = vec![material.name.clone()];
            parts.extend(group.map(|group| group.in_language(language)));
            parts.extend(material.thickness_mm.map(|mm| quantity(mm, Unit::Mm, 5).in_language(language)));
            parts.extend(material.carbon_equivalents.map(|all| format!("CE {}", significant(all.ce_iiw, 2, language))));
            parts.retain(|part| !part.is_empty());
            parts.join(", ")
        };
        let mut facts = vec![
            (capitalised(&language.words("report-first-part")), text(&materials.first)),
            (capitalised(&language.words("report-second-part")), text(&materials.second)),
        ];
        let metal = materials.weld_metal.as_ref();
        facts.extend(metal.map(|metal| (capitalised(&language.words("report-weld-metal")), text(metal))));
        facts
    }
}
