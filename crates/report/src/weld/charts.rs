use super::axis_units::units;
use super::certificate::IntervalFigures;
use super::limits::binds;
use super::samples::Sample;
use super::taught::{TaughtPlot, taught};
use super::{
    CertificateFigures, SimulationCurves, cut_template, map, procedure, sections, tracking, weave_charts, welding_order,
};
use crate::block::figure;
use crate::{
    Axis, Band, Block, Chart, ChartGrid, Drawing, Gallery, Language, LimitLine, Mark, Series, Style, ThreeViews,
    Words as _, value_names,
};
use seamwright_machine::Machine;
use seamwright_message::{Message, Unit};
use seamwright_motion::procedure::PassProcedure;
use seamwright_motion::{Leg, PassClearance, PassMotion};
use seamwright_program::{Pass, Run, Span, TorchPath, is_beyond};
use seamwright_simulation::Summary;
use seamwright_weld::{SeamCurve, Welding};

/// The plots of a pass.
#[derive(Default)]
pub struct Plots {
    plots: Vec<Plot>,
    taught: Vec<TaughtPlot>,
}

struct Plot {
    /// Name of its file, without the ending.
    name: &'static str,
    caption: &'static str,
    picture: Picture,
}

enum Picture {
    Drawing(Box<dyn Drawing>),
    /// Markup at true size, equal in pages and files.
    Ready(String),
}

/// Data of a planned pass for its plots.
pub(super) struct PlottedPass<'a> {
    /// Counted from 0.
    pub(super) index: usize,
    pub(super) motion: &'a PassMotion,
    pub(super) clearance: Option<&'a PassClearance>,
    pub(super) samples: &'a [Sample],
    pub(super) certificate: &'a CertificateFigures,
    pub(super) procedure: Option<(&'a PassProcedure, Option<&'a Run>)>,
    /// The simulated pass, if it was simulated.
    pub(super) curves: Option<&'a SimulationCurves>,
    pub(super) summary: Option<&'a Summary>,
}

/// Number of places at which the extremes of the dihedral angle are looked for.
const STATIONS: u32 = 720;
/// Number of torch vectors drawn along the seam.
const VECTORS: u32 = 36;

impl Plots {
    pub(super) fn new(machine: &Machine, welding: &Welding, planned: &PlottedPass<'_>, language: Language) -> Self {
        let PlottedPass { index, motion, samples, certificate, curves, .. } = *planned;
        let pass = &welding.program.value.passes[index];
        let first = index == 0;
        let mut plots = Self::default();
        plots.add("seam", "report-caption-seam", Some(views(welding, index, language)));
        plots.add(
            "axes",
            "report-caption-axes",
            Some(axes(machine, samples, &[0, 1, 2], "report-chart-axes", language)),
        );
        plots.add("jerk", "report-caption-jerks", Some(axes(machine, samples, &[3], "report-chart-jerks", language)));
        let speeds = speed(motion, samples, certificate, curves, language);
        plots.add("speed", "report-caption-speed", Some(speeds));
        plots.add("torch", "report-caption-torch-angles", torch(samples, language));
        plots.add("process", "report-caption-process-values", process(pass, language));
        if let Some((held, run)) = planned.procedure {
            plots.add("heat-input", "report-caption-heat-input", procedure::heat_input(held, language));
            plots.add("position", "report-caption-positions", Some(procedure::positions(held, run, language)));
        }
        let woven = welding.path(index).along_seam().and_then(|path| weave_charts::weave(pass, path, language));
        plots.add("weave", "report-caption-weave", woven);
        plots.add("oscillation", "report-caption-oscillation", weave_charts::oscillation(pass, language));
        plots.add("clearance", "report-caption-clearance", planned.clearance.map(|c| clearance_chart(c, language)));
        if let Some(c) = curves {
            plots.add("speed-deviation", "report-caption-deviation", Some(deviation(machine, motion, c, language)));
            plots.add("following", "report-caption-following", Some(following(machine, c, language)));
            let errors = vec![Series::named(language, "report-curve-normal-to-seam", c.path_error.points())];
            let distance = Axis::of(language, "report-label-path-error", Unit::Mm);
            let path_error = Chart::along(language, "report-chart-path-error", distance, errors);
            plots.add("path-error", "report-caption-path-error", Some(path_error));
            let tracked = planned.summary.and_then(|summary| tracking::charts(c, &summary.heads, language));
            plots.add("tracking", "report-caption-tracking", tracked);
            let errors = vec![Series::named(language, "report-label-attitude-error", c.attitude.points())];
            let angle = Axis::of(language, "report-label-attitude-error", Unit::Deg);
            let attitude = Chart::along(language, "report-chart-attitude", angle, errors);
            plots.add("attitude", "report-caption-attitude", Some(attitude));
        }
        if first {
            // On one seam the map shows the order too.
            let spread = welding.seam.is_none() || welding.program.value.copies.len() > 1;
            let order = if spread { welding_order::order(welding, language) } else { None };
            plots.add("order", "report-caption-order", order);
            plots.add("map", "report-caption-map", map::map(welding, language));
        }
        if let Some(cut) = welding.cut.as_ref().filter(|_| first) {
            let picture = Picture::Ready(cut_template::template(cut, language));
            plots.plots.push(Plot { name: "cut", caption: "report-caption-cut", picture });
        }
        let jointed = welding.joint.as_ref().and(welding.seam.as_ref()).filter(|_| first);
        plots.add("section", "report-caption-sections", jointed.map(|seam| extremes(welding, seam, language)));
        plots.add("sections", "report-caption-sections", jointed.map(|seam| gallery(welding, seam, language)));
        plots.taught = welding.seam.as_ref().map_or(Vec::new(), |seam| taught(machine, seam, motion, language));
        plots
    }

    fn add(&mut self, name: &'static str, caption: &'static str, drawing: Option<impl Drawing + 'static>) {
        let picture = drawing.map(|drawing| Picture::Drawing(Box::new(drawing)));
        self.plots.extend(picture.map(|picture| Plot { name, caption, picture }));
    }

    /// Returns the plots as separate files: name and SVG.
    pub fn files(&self) -> Vec<(String, String)> {
        let plots = self.plots.iter().map(|plot| {
            let svg = match &plot.picture {
                Picture::Drawing(drawing) => drawing.to_svg_standalone(),
                Picture::Ready(svg) => svg.clone(),
            };
            (format!("{}.svg", plot.name), svg)
        });
        let taught = self.taught.iter().zip(1..);
        plots.chain(taught.map(|(t, i)| (format!("taught-{i}.svg"), t.charts.to_svg_standalone()))).collect()
    }

    /// Returns the figures of these names, without those that the pass does not have.
    pub(super) fn figures(&self, names: &[&str], language: Language) -> Vec<Block> {
        let named = names.iter().filter_map(|name| self.plots.iter().find(|plot| plot.name == *name));
        let figure = |plot: &Plot| match &plot.picture {
            Picture::Drawing(drawing) => figure(drawing.as_ref(), plot.caption, language),
            Picture::Ready(svg) => Block::Figure { svg: svg.clone(), caption: language.words(plot.caption) },
        };
        named.map(figure).collect()
    }

    /// Returns text and figure of each taught span.
    pub(super) fn taught(&self, language: Language) -> Vec<Block> {
        let both =
            |t: &TaughtPlot| [Block::Paragraph(t.text.clone()), figure(&t.charts, "report-caption-taught", language)];
        self.taught.iter().flat_map(both).collect()
    }
}

/// Draws cross-sections at nine stations; on an all-round weld at every ninth of the seam.
fn gallery(welding: &Welding, seam: &SeamCurve, language: Language) -> Gallery {
    let step = if seam.all_round() { seam.length() / 9.0 } else { seam.weld_length() / 8.0 };
    let places: Vec<f64> = (0..9).map(|i| f64::from(i) * step).collect();
    sections(welding, &places, language)
}

/// Dihedral angles that differ by less make alike cross-sections, rad.
const ALIKE: f64 = 0.02;

/// Draws the cross-section at the start, or those where the faces are farthest apart and nearest if these differ.
fn extremes(welding: &Welding, seam: &SeamCurve, language: Language) -> Gallery {
    let length = if seam.all_round() { seam.length() } else { seam.weld_length() };
    let places = (0..STATIONS).map(|i| length * f64::from(i) / f64::from(STATIONS));
    let angles: Vec<(f64, f64)> = places.map(|s| (seam.at(s).dihedral, s)).collect();
    let least = angles.iter().copied().reduce(|a, b| if b.0 < a.0 { b } else { a });
    let most = angles.iter().copied().reduce(|a, b| if b.0 > a.0 { b } else { a });
    match (least, most) {
        (Some(least), Some(most)) if most.0 - least.0 > ALIKE => sections(welding, &[most.1, least.1], language),
        _ => sections(welding, &[0.0], language),
    }
}

fn views(welding: &Welding, pass: usize, language: Language) -> ThreeViews {
    let path = welding.path(pass);
    let length = path.length();
    let seam = path.along_seam();
    // One turn, in the seam's frame and without a weave; points in the work frame.
    let turn = seam.map_or(length, |path| path.seam.length());
    let drawn = length.min(turn);
    let torch = |s: f64| match seam {
        Some(path) => path.torch_at(&path.seam_point(s)),
        None => (path.pose(s).point, -path.pose(s).direction),
    };
    let at = |s: f64| torch(s).0.to_array();
    // Torch vectors long enough to read on the seam's scale.
    let size = (0..=64).map(|i| (torch(drawn * f64::from(i) / 64.0).0 - torch(0.0).0).length());
    let vector = 0.18 * size.fold(0.0, f64::max);
    let vectors = (0..VECTORS).map(|i| {
        let (tip, axis) = torch(drawn * f64::from(i) / f64::from(VECTORS));
        (tip.to_array(), (tip + vector * axis).to_array())
    });
    let mark = |label, s| Mark { label: language.words(label), at: at(s) };
    let path_name = match seam {
        Some(path) if path.bead.is_some() => "report-curve-bead",
        Some(_) => "report-curve-seam",
        None => "report-curve-path",
    };
    ThreeViews {
        language,
        title: language.words("report-heading-seam"),
        path: (0..=720).map(|i| at(drawn * f64::from(i) / 720.0)).collect(),
        path_name: language.words(path_name),
        vectors: vectors.collect(),
        vectors_name: language.words("report-curve-torch-axis"),
        marks: vec![
            mark("report-mark-start", 0.0),
            mark(if is_beyond(length, turn) { "report-mark-end-of-overlap" } else { "report-mark-end" }, length),
        ],
    }
}

fn clearance_chart(clearance: &PassClearance, language: Language) -> Chart {
    let first = clearance.at_least.first().map(|c| (0.0, c.1));
    let proven = first.into_iter().chain(clearance.at_least.iter().copied()).collect();
    let series = vec![
        Series::named(language, "report-curve-clearance", clearance.found.clone()),
        Series::named(language, "report-curve-clearance-bound", proven).styled(Style::Dashed),
    ];
    let title = Message::new("report-chart-clearance").value("limit", clearance.cutoff_mm, Unit::Mm);
    Chart {
        title: title.in_language(language),
        ..Chart::along(language, "", Axis::of(language, "report-label-distance", Unit::Mm), series)
    }
}

fn torch(samples: &[Sample], language: Language) -> Option<Chart> {
    let curve = |f: fn((f64, f64, f64)) -> f64| -> Vec<(f64, f64)> {
        samples.iter().filter_map(|s| Some((s.s, f(s.angles?)))).collect()
    };
    samples.first()?.angles?;
    let series = vec![
        Series::named(language, "report-curve-work-angle", curve(|angles| angles.0)),
        Series::named(language, "report-curve-travel-angle", curve(|angles| angles.1)),
        Series::named(language, "report-curve-half-dihedral", curve(|angles| 0.5 * angles.2)),
    ];
    Some(Chart::along(
        language,
        "report-chart-torch-angles",
        Axis::of(language, "report-label-angle", Unit::Deg),
        series,
    ))
}

/// Returns charts of the process values that change along the pass; `None` if all are constant.
fn process(pass: &Pass, language: Language) -> Option<ChartGrid> {
    let ends = |name: &String| -> Vec<(f64, f64)> {
        let of = |span: &Span| {
            let (from, to) = span.process.get(name)?.ends();
            Some([(span.from_mm.get(), from), (span.to_mm.get(), to)])
        };
        pass.spans.iter().filter_map(of).flatten().collect()
    };
    let names = pass.spans.first()?.process.keys();
    let curves = names.map(|name| (name, ends(name)));
    let changing = curves.filter(|(_, curve)| curve.iter().any(|p| (p.1 - curve[0].1).abs() > 0.0));
    let chart = |(name, curve): (&String, Vec<(f64, f64)>)| {
        let name = value_names::value(language, name);
        Chart {
            title: name.clone(),
            y: Axis::new(name.as_str(), ""),
            series: vec![Series::line(name, curve)],
            ..Chart::along(language, "", Axis::default(), Vec::new())
        }
    };
    let charts: Vec<Chart> = changing.map(chart).collect();
    let title = language.words("report-chart-process-values");
    (!charts.is_empty()).then_some(ChartGrid { title, columns: 2, charts })
}

/// Plots these orders of every axis, from 0: position, speed, acceleration, jerk.
fn axes(machine: &Machine, samples: &[Sample], orders: &[usize], title: &'static str, language: Language) -> ChartGrid {
    let axis_charts = |i| orders.iter().map(move |order| axis_chart(machine, samples, i, *order, language));
    let charts = (0..machine.axes.len()).flat_map(axis_charts);
    ChartGrid { title: language.words(title), columns: 3, charts: charts.collect() }
}

fn axis_chart(machine: &Machine, samples: &[Sample], i: usize, order: usize, language: Language) -> Chart {
    let axis = &machine.axes[i];
    let both_ways = |limit: f64| Some((-limit, limit));
    let (label, limits) = match order {
        0 => ("report-label-position", axis.range),
        1 => ("report-label-speed", both_ways(axis.max_speed)),
        2 => ("report-label-acceleration", both_ways(axis.max_acceleration)),
        _ => ("report-label-jerk", both_ways(axis.jerk())),
    };
    let limit = |value: f64| LimitLine::new(language.words("report-limit"), axis.to_file(value));
    let points = samples.iter().map(|s| (s.s, s.axes[i][order])).collect();
    let y = Axis::of(language, label, units(axis.unit())[order]);
    Chart {
        title: format!("{} {}", axis.name, language.words(label)),
        limits: limits.into_iter().flat_map(|(low, high)| [limit(low), limit(high)]).collect(),
        ..Chart::along(language, "", y, vec![Series::line(axis.name.as_str(), points)])
    }
}

/// Returns stretches between acceleration and deceleration phase that are slower than requested, each named by the
/// bound at its slowest point.
fn slowed(certificate: &CertificateFigures, language: Language) -> Vec<Band> {
    let mut runs: Vec<Vec<&IntervalFigures>> = vec![Vec::new()];
    for interval in &certificate.intervals {
        match runs.last_mut() {
            Some(run) if interval.between && interval.axis.is_some() => run.push(interval),
            _ => runs.push(Vec::new()),
        }
    }
    let band = |run: &Vec<&IntervalFigures>| {
        let slowest = run.iter().min_by(|a, b| a.least_speed_mm_s.total_cmp(&b.least_speed_mm_s))?;
        Some(Band { label: binds(slowest, language), from: run[0].from_mm, to: run[run.len() - 1].to_mm })
    };
    runs.iter().filter_map(band).collect()
}

fn speed(
    motion: &PassMotion,
    samples: &[Sample],
    certificate: &CertificateFigures,
    curves: Option<&SimulationCurves>,
    language: Language,
) -> Chart {
    let mut series = Vec::new();
    if let Some(c) = curves {
        series.push(Series::named(language, "report-curve-tip-simulated", c.tip_speed.points()));
    }
    series.push(Series::named(language, "report-curve-planned", samples.iter().map(|s| (s.s, s.speed)).collect()));
    let band = |label, from, to| Band { label: language.words(label), from, to };
    let ends = |leg: &Leg| {
        [
            band("report-acceleration-phase", leg.from, leg.run_up_end),
            band("report-deceleration-phase", leg.run_down_start, leg.to),
        ]
    };
    let mut bands: Vec<Band> = motion.profile.legs().iter().flat_map(ends).collect();
    bands.extend(slowed(certificate, language));
    // Omits narrow bands, whose names would only cover the curve.
    let wide = 0.01 * motion.path.length();
    Chart {
        bands: bands.into_iter().filter(|b| b.to - b.from > wide).collect(),
        ..Chart::along(language, "report-chart-speed", Axis::of(language, "report-label-speed", Unit::MmPerS), series)
    }
}

/// Plots the speed's deviation in percent, between acceleration and deceleration phase.
fn deviation(machine: &Machine, motion: &PassMotion, curves: &SimulationCurves, language: Language) -> Chart {
    let legs = motion.profile.legs();
    let steady = |s: f64| legs.iter().any(|leg| s > leg.run_up_end && s < leg.run_down_start);
    let planned = |s: f64| motion.profile.speed(s) * motion.path.tip_rate(machine, s);
    let percent = |(s, v): (f64, f64)| (s, 100.0 * (v / planned(s) - 1.0));
    let points = curves.tip_speed.points().into_iter().filter(|p| steady(p.0)).map(percent).collect();
    let series = vec![Series::named(language, "report-label-deviation", points)];
    Chart::along(
        language,
        "report-chart-deviation",
        Axis::of(language, "report-label-deviation", Unit::Percent),
        series,
    )
}

fn following(machine: &Machine, curves: &SimulationCurves, language: Language) -> ChartGrid {
    let charts = machine.axes.iter().enumerate().map(|(i, of)| {
        let y = Axis::of(language, "report-label-following-error", units(of.unit())[0]);
        let series = vec![Series::line(of.name.as_str(), curves.following[i].points())];
        Chart { title: of.name.clone(), ..Chart::along(language, "", y, series) }
    });
    let title = language.words("report-chart-following");
    ChartGrid { title, columns: 2, charts: charts.collect() }
}
