use super::map::{ReachCell, ReachMap};
use crate::Language;
use seamwright_machine::Machine;
use seamwright_message::Message;
use seamwright_motion::reach::{FaultKind, Judged, Moved, Pivot, ReachGrid, SearchResult};
use serde::{Serialize, Serializer};

/// Figures of a search for placements, as JSON has them.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ReachFigures {
    /// Title of the job.
    pub title: String,
    /// Name of the machine.
    pub machine: String,
    /// Subject of the placements: `work`, in the work frame, or `base`, in the base frame.
    #[serde(serialize_with = "by_name")]
    pub moved: Moved,
    /// A point of the axis about which placements turn, in that frame, mm.
    pub pivot_mm: [f64; 3],
    /// Direction of that axis, against gravity, in that frame.
    pub up: [f64; 3],
    /// True if budget or cancellation ended the search early.
    pub cut_off: bool,
    /// The best placement that the planner has planned.
    pub best: Option<BestPlacement>,
    /// Every placement: the present one, the grid, the local search, those that were planned.
    pub placements: Vec<PlacementRow>,
}

/// A planned placement.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct BestPlacement {
    /// The placement with its margin.
    #[serde(flatten)]
    pub row: PlacementRow,
    /// Minimum distance of an axis from an end of its range in the plan, as a fraction of the range.
    pub planned_range_margin: f64,
    /// The axis with it; none if no axis has a range.
    pub planned_axis: Option<String>,
    /// Minimum clearance along the passes, mm; none if nothing is watched.
    pub clearance_mm: Option<f64>,
    /// Key of the job or machine file that holds the placement.
    pub key: String,
    /// Its value: displacement, mm.
    pub move_mm: [f64; 3],
    /// Its value: direction of the axis of rotation; none without a rotation.
    pub turn: Option<[f64; 3]>,
    /// Its value: angle of rotation, degrees.
    pub angle_deg: f64,
}

/// A judged placement, relative to the present one.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PlacementRow {
    /// Displacement, mm.
    pub x_mm: f64,
    /// The same along y.
    pub y_mm: f64,
    /// The same along z.
    pub z_mm: f64,
    /// Rotation about the vertical, degrees.
    pub turn_deg: f64,
    /// True if the axes follow the whole seam.
    pub weldable: bool,
    /// Rank: 0 to 1 if weldable, negative otherwise.
    pub score: f64,
    /// Minimum distance of an axis from an end of its range, as a fraction of the range.
    pub range_margin: Option<f64>,
    /// Minimum distance from a singular attitude, 0 to 1.
    pub singular_margin: Option<f64>,
    /// Maximum use of an axis' speed, as a fraction of its limit.
    pub speed_use: Option<f64>,
    /// Kind of the reason of a failure: reach, range, jump, speed or position.
    pub fault: Option<&'static str>,
    /// The axis with the minimum margin, or that is the reason of the failure.
    pub axis: Option<String>,
    /// Pass of that station, from 1.
    pub pass: Option<usize>,
    /// Path length of that station in the pass, mm.
    pub s_mm: Option<f64>,
    /// Reason of a failure.
    #[serde(serialize_with = "in_english")]
    pub reason: Option<Message>,
    /// Cells of the grid.
    #[serde(skip)]
    pub cell: Option<[usize; 4]>,
}

// Serde passes fields by reference.
#[allow(clippy::trivially_copy_pass_by_ref)]
fn by_name<S: Serializer>(moved: &Moved, out: S) -> Result<S::Ok, S::Error> {
    moved.name().serialize(out)
}

fn in_english<S: Serializer>(message: &Option<Message>, out: S) -> Result<S::Ok, S::Error> {
    message.as_ref().map(|message| message.in_language(Language::English)).serialize(out)
}

impl PlacementRow {
    /// Figures of a placement judged on `machine`.
    pub fn new(machine: &Machine, judged: &Judged) -> Self {
        let [x_mm, y_mm, z_mm, turn] = judged.placement.coordinates();
        let (margin, fault) = (judged.judgement.margin(), judged.judgement.fault());
        let nearest = margin.and_then(|m| m.nearest);
        let axis = nearest.map(|n| n.axis).or(fault.and_then(|f| f.axis));
        Self {
            x_mm,
            y_mm,
            z_mm,
            turn_deg: turn.to_degrees(),
            weldable: margin.is_some(),
            score: judged.judgement.score(),
            range_margin: margin.map(|m| m.range),
            singular_margin: margin.and_then(|m| m.singular),
            speed_use: margin.map(|m| m.speed_use),
            fault: fault.map(|f| f.kind.name()),
            axis: axis.and_then(|i| machine.axes.get(i)).map(|axis| axis.name.clone()),
            pass: nearest.map(|n| n.pass).or(fault.map(|f| f.pass)),
            s_mm: nearest.map(|n| n.s).or(fault.map(|f| f.s)),
            reason: fault.map(|f| f.reason.clone()),
            cell: judged.cell,
        }
    }

    /// Word for a map's cell: the axis, or the kind of a failure without one.
    fn label(&self, language: Language) -> String {
        let kind = || self.fault.map_or_else(String::new, |kind| kind_words(kind).in_language(language));
        self.axis.clone().unwrap_or_else(kind)
    }
}

/// Words for the kind of a failure.
pub(super) fn kind_words(kind: &str) -> Message {
    Message::new(match kind {
        k if k == FaultKind::Range.name() => "report-reach-kind-range",
        k if k == FaultKind::Jump.name() => "report-reach-kind-jump",
        k if k == FaultKind::Speed.name() => "report-reach-kind-speed",
        k if k == FaultKind::Position.name() => "report-reach-kind-position",
        _ => "report-reach-kind-reach",
    })
}

impl ReachFigures {
    /// Figures of `search` on `machine` for the job called `title`.
    pub fn new(title: &str, machine: &Machine, pivot: &Pivot, search: &SearchResult) -> Self {
        Self {
            title: title.to_owned(),
            machine: machine.name.clone(),
            moved: Moved::Work,
            pivot_mm: pivot.point.to_array(),
            up: pivot.up.to_array(),
            cut_off: !search.is_complete,
            best: None,
            placements: search.judged.iter().map(|judged| PlacementRow::new(machine, judged)).collect(),
        }
    }

    /// Number of weldable placements.
    pub fn weldable(&self) -> usize {
        self.placements.iter().filter(|row| row.weldable).count()
    }

    /// The map over x and y: in each cell the best placement of the grid.
    pub fn map(&self, grid: &ReachGrid, language: Language) -> ReachMap {
        let [x, y, ..] = grid.spans;
        let values = |span: seamwright_motion::reach::ReachSpan| (0..span.cells()).map(|i| span.at(i)).collect();
        let mut best: std::collections::BTreeMap<[usize; 2], &PlacementRow> = std::collections::BTreeMap::new();
        for row in &self.placements {
            let Some([column, line, ..]) = row.cell else { continue };
            let other = best.entry([column, line]).or_insert(row);
            if row.score > other.score {
                *other = row;
            }
        }
        let cell = |([column, row], judged): ([usize; 2], &PlacementRow)| ReachCell {
            column,
            row,
            margin: judged.range_margin,
            label: judged.label(language),
        };
        ReachMap {
            language,
            title: Message::new("report-reach-title").text("machine", &self.machine).in_language(language),
            key: Message::new("report-reach-key").in_language(language),
            columns: values(x),
            rows: values(y),
            cells: best.into_iter().map(cell).collect(),
            best: self.best.as_ref().map(|best| (best.row.x_mm, best.row.y_mm)),
        }
    }

    /// The placements as CSV.
    pub fn csv(&self) -> String {
        let mut text =
            "x_mm,y_mm,z_mm,turn_deg,weldable,score,range_margin,singular_margin,speed_use,fault,axis,pass,s_mm\n"
                .to_owned();
        for row in &self.placements {
            let number = |v: Option<f64>| v.map_or_else(String::new, |v| format!("{v:.4}"));
            let cells = [
                format!("{:.3}", row.x_mm + 0.0),
                format!("{:.3}", row.y_mm + 0.0),
                format!("{:.3}", row.z_mm + 0.0),
                format!("{:.3}", row.turn_deg + 0.0),
                row.weldable.to_string(),
                format!("{:.4}", row.score),
                number(row.range_margin),
                number(row.singular_margin),
                number(row.speed_use),
                row.fault.unwrap_or_default().to_owned(),
                row.axis.clone().unwrap_or_default(),
                row.pass.map_or_else(String::new, |pass| pass.to_string()),
                row.s_mm.map_or_else(String::new, |s| format!("{s:.3}")),
            ];
            text += &cells.join(",");
            text.push('\n');
        }
        text
    }
}
