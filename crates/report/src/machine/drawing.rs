use super::canvas::Canvas;
use super::outlines::outlines;
use crate::glyph;
use crate::layout::{self, HEAD, Layout, Map, TITLE, whole};
use crate::legend::{Entry, ROW};
use crate::projection::Projection::Pictorial;
use crate::svg::{Anchor, Rect, Svg};
use crate::text::width;
use crate::{Drawing, Language, Words as _};
use seamwright_machine::check::Side;
use seamwright_machine::{AxisKind, Machine};
use seamwright_message::Message;

/// A machine at home in its base frame, with position and positive sense of every axis. It has three views in
/// first-angle projection and a small pictorial one.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct MachineDrawing {
    /// Language of built-in texts.
    pub language: Language,
    /// Heading; may be empty.
    pub title: String,
    /// Outlines of shapes: further polylines in the base frame, mm, drawn thin below everything else.
    pub outlines: Vec<Vec<[f64; 3]>>,
    pub(super) axes: Vec<DrawnAxis>,
    /// Lines from the base through the axes to the torch tips and to the work.
    pub(super) links: Vec<Vec<[f64; 3]>>,
    /// Name, torch tip and beam direction of each head.
    pub(super) heads: Vec<(String, [f64; 3], [f64; 3])>,
    /// Origin of the work frame.
    pub(super) work: [f64; 3],
    /// Direction opposite to gravity.
    pub(super) up: [f64; 3],
}

#[derive(Debug, Clone, PartialEq)]
pub(super) struct DrawnAxis {
    /// Name, and letter if it differs.
    pub(super) label: String,
    /// Whether it carries the work.
    pub(super) moves_work: bool,
    pub(super) rotary: bool,
    pub(super) at: [f64; 3],
    /// Positive direction of motion or rotation axis of the carried part.
    pub(super) direction: [f64; 3],
    /// Both ends of the stroke from `at`, mm; only of linear axes.
    pub(super) stroke: (f64, f64),
}

/// Maximum ratio of drawn strokes to the size of the structure, unless the structure is small.
const STROKES: f64 = 1.15;

/// Maximum ratio of a stroke to its cut length up to which it is drawn whole.
const WHOLE: f64 = 1.8;

/// Ratio to the second longest stroke below which the structure is small.
const SMALL: f64 = 0.25;

pub(super) fn along(at: [f64; 3], direction: [f64; 3], by: f64) -> [f64; 3] {
    std::array::from_fn(|i| at[i] + by * direction[i])
}

impl MachineDrawing {
    /// Draws the machine with its axes at home, with texts in this language.
    pub fn new(machine: &Machine, language: Language) -> Self {
        let home = machine.home();
        let skeleton = machine.skeleton(&home);
        let drawn = skeleton.axes.iter().map(|place| {
            let axis = &machine.axes[place.axis];
            let letter = axis.letter.filter(|l| axis.name != l.to_lowercase().to_string());
            let stroke = match (axis.kind, axis.range) {
                (AxisKind::Linear, Some((low, high))) => (low - home[place.axis], high - home[place.axis]),
                _ => (0.0, 0.0),
            };
            DrawnAxis {
                label: letter.map_or_else(|| axis.name.clone(), |l| format!("{} ({l})", axis.name)),
                moves_work: place.side == Side::Work,
                rotary: axis.kind == AxisKind::Rotary,
                at: place.at.to_array(),
                direction: place.direction.to_array(),
                stroke,
            }
        });
        Self {
            language,
            title: Message::new("report-machine-title").text("machine", &machine.title).in_language(language),
            outlines: outlines(machine),
            axes: drawn.collect(),
            links: skeleton.links.iter().map(|l| l.iter().copied().map(Into::into).collect()).collect(),
            heads: skeleton
                .heads
                .iter()
                .map(|(name, tip)| (name.clone(), tip.point.to_array(), tip.direction.to_array()))
                .collect(),
            work: skeleton.work.translation.to_array(),
            up: machine.up.to_array(),
        }
    }

    fn structure(&self) -> impl Iterator<Item = [f64; 3]> {
        self.links.iter().flatten().chain(self.outlines.iter().flatten()).copied().filter(whole)
    }

    /// Returns the bounds of the drawing. Strokes that are long compared with the structure are cut, so that one long
    /// gantry does not make everything else too small.
    fn extent(&self) -> [[f64; 3]; 2] {
        let mut low = [f64::INFINITY; 3];
        let mut high = [f64::NEG_INFINITY; 3];
        let mut take = |p: [f64; 3]| {
            for i in 0..3 {
                (low[i], high[i]) = (low[i].min(p[i]), high[i].max(p[i]));
            }
        };
        self.structure().for_each(&mut take);
        let size = (0..3).map(|i| high[i] - low[i]).fold(0.0, f64::max);
        let strokes = |a: &DrawnAxis| a.stroke.0.abs().max(a.stroke.1.abs());
        let mut halves: Vec<f64> = self.axes.iter().map(strokes).collect();
        halves.sort_by(f64::total_cmp);
        let longest = halves.last().copied().unwrap_or(0.0);
        let second = halves.iter().rev().nth(1).copied().unwrap_or(longest);
        let most = if size < SMALL * second { STROKES * second } else { STROKES * size };
        // A slightly longer stroke is not cut.
        let most = if longest < WHOLE * most { f64::INFINITY } else { most };
        let (from, to) = (low, high);
        for axis in &self.axes {
            for end in [axis.stroke.0, axis.stroke.1] {
                let p = along(axis.at, axis.direction, end);
                let cut: [f64; 3] =
                    std::array::from_fn(|i| p[i].clamp(0.5 * (from[i] + to[i]) - most, 0.5 * (from[i] + to[i]) + most));
                for i in 0..3 {
                    (low[i], high[i]) = (low[i].min(cut[i]), high[i].max(cut[i]));
                }
            }
        }
        [low, high]
    }

    /// Returns the bounds with room for symbols and names around them, also in a flat direction.
    fn with_room([low, high]: [[f64; 3]; 2]) -> [[f64; 3]; 2] {
        let widest = (0..3).map(|i| high[i] - low[i]).fold(1e-3, f64::max);
        let room = |i: usize| (0.07 * widest).max(0.5 * (0.5 * widest - (high[i] - low[i])));
        [std::array::from_fn(|i| low[i] - room(i)), std::array::from_fn(|i| high[i] + room(i))]
    }

    /// Returns the points of the pictorial view: structure and strokes within the extent.
    fn seen_in(&self, [low, high]: [[f64; 3]; 2]) -> impl Iterator<Item = [f64; 3]> {
        let ends = self.axes.iter().flat_map(|a| [a.stroke.0, a.stroke.1].map(|by| along(a.at, a.direction, by)));
        let ends = ends.map(move |p| std::array::from_fn(|i| p[i].clamp(low[i], high[i])));
        self.structure().chain(ends)
    }

    fn entries(&self) -> Vec<Entry> {
        let curve =
            |class: &str, code| Entry::Curve { class: class.into(), dots: false, name: self.language.words(code) };
        let mut entries = Vec::new();
        if self.axes.iter().any(|a| !a.moves_work) {
            entries.push(curve("line fat c1", "report-machine-moves-torch"));
        }
        if self.axes.iter().any(|a| a.moves_work) {
            entries.push(curve("line fat c2", "report-machine-moves-work"));
        }
        entries.push(curve("line fat c3", "report-machine-beam"));
        entries.push(curve("line outline", "report-machine-links"));
        entries
    }
}

impl Drawing for MachineDrawing {
    fn label(&self) -> String {
        if self.title.is_empty() { self.language.words("report-machine") } else { self.title.clone() }
    }

    fn draw(&self) -> (Svg, f64) {
        let mut svg = Svg::default();
        let top = TITLE + layout::draw_head(&mut svg, &self.title, self.entries());
        symbols(&mut svg, top + 12.0, self.language);
        let extent = self.extent();
        let [low, high] = Self::with_room(extent);
        let corners = (0..8).map(|k| std::array::from_fn(|i| if k >> i & 1 == 1 { high[i] } else { low[i] }));
        let layout = Layout::new(corners, top + ROW + 8.0 + HEAD);
        let pictorial = |frame: Rect| Map::fitting(Pictorial, self.seen_in(extent), frame.inset(52.0));
        layout.draw_views(&mut svg, self.language, pictorial, |svg, map, frame| {
            svg.clipped(frame, |svg| Canvas::new(svg, map, frame).draw(self));
        });
        (svg, layout.bottom())
    }
}

fn symbols(svg: &mut Svg, baseline: f64, language: Language) {
    let y = baseline - 4.5;
    let mut x = 0.0;
    let mut entry = |svg: &mut Svg, lead: f64, code| {
        let text = language.words(code);
        svg.text("quiet", x + lead, baseline, Anchor::Start, &text);
        x += lead + width(&text, 12.0) + 18.0;
        x
    };
    svg.circle("symbol", 7.0, y, 5.5);
    svg.circle("symbol-dot", 7.0, y, 1.8);
    let next = entry(svg, 20.0, "report-machine-towards");
    svg.circle("symbol", next + 7.0, y, 5.5);
    svg.path("symbol", &glyph::cross(next + 7.0, y, 3.9));
    let next = entry(svg, 20.0, "report-machine-away");
    svg.line("bar symbol-bar", next, y, next + 26.0, y);
    let next = entry(svg, 34.0, "report-machine-stroke");
    svg.path("symbol", &glyph::zigzag((next + 8.0, y), (1.0, 0.0)));
    let next = entry(svg, 20.0, "report-machine-cut");
    svg.circle("mark", next + 4.0, y, 2.8);
    entry(svg, 13.0, "report-machine-home");
}
