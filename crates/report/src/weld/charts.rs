use super::certificate::{CertificateFigures, IntervalFigures};
use super::chart_parts::{axis, chart, line, units};
use super::curves::SimulationCurves;
use super::limits::binds;
use super::procedure::ProcedurePlots;
use super::samples::Sample;
use super::sections::sections;
use super::taught::{TaughtPlot, taught};
use super::{cut, order, woven};
use crate::chart::{Axis, Band, Chart};
use crate::gallery::Gallery;
use crate::grid::ChartGrid;
use crate::limit::LimitLine;
use crate::names;
use crate::order::OrderDrawing;
use crate::series::{Series, Style};
use crate::views::{Mark, ThreeViews};
use crate::words::Words as _;
use seamwright_machine::Machine;
use seamwright_message::{Language, Message, Unit};
use seamwright_motion::{Leg, PassClearance, PassMotion};
use seamwright_program::{Pass, Span, TorchPath, is_beyond};
use seamwright_weld::{SeamCurve, Welding};

/// The plots of a weld.
#[derive(Debug, Clone)]
pub struct Plots {
    /// The seam with torch vectors in three views.
    pub seam: ThreeViews,
    /// Plots of the taught spans of the seam.
    pub taught: Vec<TaughtPlot>,
    /// Torch angles over path length, along a seam.
    pub torch: Option<Chart>,
    /// Process values over path length, only those that change.
    pub process: Option<ChartGrid>,
    /// Woven path of the torch tip, if the torch weaves.
    pub weave: Option<Chart>,
    /// Path of the beam on the work, if it oscillates.
    pub oscillation: Option<Chart>,
    /// Axis positions, speeds and accelerations against their limits.
    pub axes: ChartGrid,
    /// Jerk of each axis against its limit.
    pub jerks: ChartGrid,
    /// Torch-tip speed: planned, and actual if simulated.
    pub speed: Chart,
    /// Heat input and welding positions, if there is a procedure.
    pub procedure: Option<ProcedurePlots>,
    /// Minimum distance of the checked objects, if the machine file has shapes.
    pub clearance: Option<Chart>,
    /// Deviation of the actual torch-tip speed from the planned one, if simulated.
    pub deviation: Option<Chart>,
    /// Following error of each axis, if simulated.
    pub following: Option<ChartGrid>,
    /// Distance of the actual torch tip from the seam, if simulated.
    pub path_error: Option<Chart>,
    /// Joint and weld, if the joint may deviate from the plan.
    pub tracking: Option<ChartGrid>,
    /// Attitude error of the actual torch, if simulated.
    pub attitude: Option<Chart>,
    /// With the first pass, the cut end of the branch or nozzle, if known: an SVG at true size.
    pub cut: Option<String>,
    /// With the first pass, cross-sections of the joint along the seam, if the file has one.
    pub sections: Option<Gallery>,
    /// With the first pass of several, all passes in the order of welding.
    pub order: Option<OrderDrawing>,
}

/// Data of a planned pass for its plots.
pub(super) struct PlottedPass<'a> {
    /// Counted from 0.
    pub(super) index: usize,
    pub(super) motion: &'a PassMotion,
    pub(super) clearance: Option<&'a PassClearance>,
    pub(super) samples: &'a [Sample],
    pub(super) certificate: &'a CertificateFigures,
}

/// Number of torch vectors drawn along the seam.
const VECTORS: u32 = 36;

impl Plots {
    pub(super) fn new(
        machine: &Machine,
        welding: &Welding,
        planned: &PlottedPass<'_>,
        curves: Option<&SimulationCurves>,
        language: Language,
    ) -> Self {
        let PlottedPass { index: pass, motion, clearance, samples, certificate } = *planned;
        let program = &welding.program.value;
        Self {
            seam: views(welding, pass, language),
            procedure: None,
            tracking: None,
            taught: welding.seam.as_ref().map_or(Vec::new(), |seam| taught(machine, seam, motion, language)),
            clearance: clearance.map(|clearance| clearance_chart(clearance, language)),
            torch: torch(samples, language),
            process: process(&program.passes[pass], language),
            weave: welding.path(pass).along_seam().and_then(|path| woven::weave(&program.passes[pass], path, language)),
            oscillation: woven::oscillation(&program.passes[pass], language),
            axes: axes(machine, samples, language),
            jerks: jerks(machine, samples, language),
            speed: speed(motion, samples, certificate, curves, language),
            deviation: curves.map(|c| deviation(machine, motion, c, language)),
            following: curves.map(|c| following(machine, c, language)),
            path_error: curves.map(|c| {
                let errors = vec![line(language, "report-curve-normal-to-seam", c.path_error())];
                let title = "report-chart-path-error";
                chart(language, title, axis(language, "report-label-path-error", Unit::Mm), errors)
            }),
            attitude: curves.map(|c| {
                let errors = vec![line(language, "report-label-attitude-error", c.attitude())];
                let title = "report-chart-attitude";
                chart(language, title, axis(language, "report-label-attitude-error", Unit::Deg), errors)
            }),
            cut: welding.cut.as_ref().filter(|_| pass == 0).map(|cut| cut::template(cut, language)),
            sections: welding
                .joint
                .as_ref()
                .and(welding.seam.as_ref())
                .filter(|_| pass == 0)
                .map(|seam| gallery(welding, seam, language)),
            order: if pass == 0 { order::order(welding, language) } else { None },
        }
    }

    /// Returns the plots as separate files: name and SVG.
    pub fn files(&self) -> Vec<(String, String)> {
        let mut files = vec![
            ("seam.svg", self.seam.to_svg_standalone()),
            ("axes.svg", self.axes.to_svg_standalone()),
            ("jerk.svg", self.jerks.to_svg_standalone()),
            ("speed.svg", self.speed.to_svg_standalone()),
        ];
        files.extend(self.torch.as_ref().map(|c| ("torch.svg", c.to_svg_standalone())));
        files.extend(self.process.as_ref().map(|c| ("process.svg", c.to_svg_standalone())));
        if let Some(p) = &self.procedure {
            files.extend(p.heat_input.as_ref().map(|c| ("heat-input.svg", c.to_svg_standalone())));
            files.push(("position.svg", p.positions.to_svg_standalone()));
        }
        files.extend(self.weave.as_ref().map(|c| ("weave.svg", c.to_svg_standalone())));
        files.extend(self.oscillation.as_ref().map(|c| ("oscillation.svg", c.to_svg_standalone())));
        files.extend(self.clearance.as_ref().map(|c| ("clearance.svg", c.to_svg_standalone())));
        files.extend(self.deviation.as_ref().map(|c| ("speed-deviation.svg", c.to_svg_standalone())));
        files.extend(self.following.as_ref().map(|c| ("following.svg", c.to_svg_standalone())));
        files.extend(self.path_error.as_ref().map(|c| ("path-error.svg", c.to_svg_standalone())));
        files.extend(self.tracking.as_ref().map(|c| ("tracking.svg", c.to_svg_standalone())));
        files.extend(self.attitude.as_ref().map(|c| ("attitude.svg", c.to_svg_standalone())));
        files.extend(self.order.as_ref().map(|o| ("order.svg", o.to_svg_standalone())));
        files.extend(self.cut.clone().map(|svg| ("cut.svg", svg)));
        files.extend(self.sections.as_ref().map(|g| ("sections.svg", g.to_svg_standalone())));
        let mut files: Vec<_> = files.into_iter().map(|(name, svg)| (name.to_owned(), svg)).collect();
        let taught = self.taught.iter().enumerate();
        files.extend(taught.map(|(i, t)| (format!("taught-{}.svg", i + 1), t.charts.to_svg_standalone())));
        files
    }
}

/// Draws cross-sections at nine stations; on an all-round weld at every ninth of the seam.
fn gallery(welding: &Welding, seam: &SeamCurve, language: Language) -> Gallery {
    let step = if seam.all_round() { seam.length() / 9.0 } else { seam.weld_length() / 8.0 };
    let places: Vec<f64> = (0..9).map(|i| f64::from(i) * step).collect();
    sections(welding, &places, language)
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
        closed: false,
        path_name: language.words(path_name),
        vectors: vectors.collect(),
        vectors_name: language.words("report-curve-torch-axis"),
        marks: vec![
            mark("report-mark-start", 0.0),
            mark(if is_beyond(length, turn) { "report-mark-end-of-overlap" } else { "report-mark-end" }, length),
        ],
        ..ThreeViews::default()
    }
}

fn clearance_chart(clearance: &PassClearance, language: Language) -> Chart {
    let first = clearance.at_least.first().map(|c| (0.0, c.1));
    let proven = first.into_iter().chain(clearance.at_least.iter().copied()).collect();
    let series = vec![
        line(language, "report-curve-clearance", clearance.found.clone()),
        line(language, "report-curve-clearance-bound", proven).styled(Style::Dashed),
    ];
    let title = Message::new("report-chart-clearance").value("limit", clearance.cutoff_mm, Unit::Mm);
    Chart {
        title: title.in_language(language),
        ..chart(language, "", axis(language, "report-label-distance", Unit::Mm), series)
    }
}

fn torch(samples: &[Sample], language: Language) -> Option<Chart> {
    let curve = |f: fn((f64, f64, f64)) -> f64| -> Vec<(f64, f64)> {
        samples.iter().filter_map(|s| Some((s.s, f(s.angles?)))).collect()
    };
    samples.first()?.angles?;
    let series = vec![
        line(language, "report-curve-work-angle", curve(|angles| angles.0)),
        line(language, "report-curve-travel-angle", curve(|angles| angles.1)),
        line(language, "report-curve-half-dihedral", curve(|angles| 0.5 * angles.2)),
    ];
    Some(chart(language, "report-chart-torch-angles", axis(language, "report-label-angle", Unit::Deg), series))
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
        let name = names::value(language, name);
        Chart {
            title: name.clone(),
            y: Axis::new(name.as_str(), ""),
            series: vec![Series::line(name, curve)],
            ..chart(language, "", Axis::default(), Vec::new())
        }
    };
    let charts: Vec<Chart> = changing.map(chart).collect();
    let title = language.words("report-chart-process-values");
    (!charts.is_empty()).then_some(ChartGrid { title, columns: 2, charts })
}

fn axes(machine: &Machine, samples: &[Sample], language: Language) -> ChartGrid {
    let mut charts = Vec::new();
    for (i, axis) in machine.axes.iter().enumerate() {
        let range = axis.range.map_or(Vec::new(), |(l, h)| vec![axis.to_file(l), axis.to_file(h)]);
        let [unit, per_s, per_s2, _] = units(axis.unit());
        let rows = [
            ("report-label-position", unit, range),
            ("report-label-speed", per_s, both_ways(axis.to_file(axis.max_speed))),
            ("report-label-acceleration", per_s2, both_ways(axis.to_file(axis.max_acceleration))),
        ];
        for (order, (what, unit, limits)) in rows.into_iter().enumerate() {
            charts.push(axis_chart(&axis.name, what, unit, curve(samples, i, order), limits, language));
        }
    }
    ChartGrid { title: language.words("report-chart-axes"), columns: 3, charts }
}

fn jerks(machine: &Machine, samples: &[Sample], language: Language) -> ChartGrid {
    let charts = machine.axes.iter().enumerate().map(|(i, axis)| {
        let ([.., per_s3], limits) = (units(axis.unit()), both_ways(axis.to_file(axis.jerk())));
        axis_chart(&axis.name, "report-label-jerk", per_s3, curve(samples, i, 3), limits, language)
    });
    let title = language.words("report-chart-jerks");
    ChartGrid { title, columns: 3, charts: charts.collect() }
}

/// Returns position (order 0), speed, acceleration or jerk of axis `i` over path length.
fn curve(samples: &[Sample], i: usize, order: usize) -> Vec<(f64, f64)> {
    samples.iter().map(|s| (s.s, s.axes[i][order])).collect()
}

fn both_ways(limit: f64) -> Vec<f64> {
    vec![-limit, limit]
}

fn axis_chart(
    name: &str,
    what: &'static str,
    unit: Unit,
    points: Vec<(f64, f64)>,
    limits: Vec<f64>,
    language: Language,
) -> Chart {
    let limit = language.words("report-limit");
    Chart {
        title: format!("{name} {}", language.words(what)),
        limits: limits.into_iter().map(|v| LimitLine::new(&limit, v)).collect(),
        ..chart(language, "", axis(language, what, unit), vec![Series::line(name, points)])
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
        series.push(line(language, "report-curve-tip-simulated", c.tip_speed()));
    }
    series.push(line(language, "report-curve-planned", samples.iter().map(|s| (s.s, s.speed)).collect()));
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
        ..chart(language, "report-chart-speed", axis(language, "report-label-speed", Unit::MmPerS), series)
    }
}

/// Plots the speed's deviation in percent, between acceleration and deceleration phase.
fn deviation(machine: &Machine, motion: &PassMotion, curves: &SimulationCurves, language: Language) -> Chart {
    let legs = motion.profile.legs();
    let steady = |s: f64| legs.iter().any(|leg| s > leg.run_up_end && s < leg.run_down_start);
    let planned = |s: f64| motion.profile.speed(s) * motion.path.tip_rate(machine, s);
    let percent = |(s, v): (f64, f64)| (s, 100.0 * (v / planned(s) - 1.0));
    let points = curves.tip_speed().into_iter().filter(|p| steady(p.0)).map(percent).collect();
    let series = vec![line(language, "report-label-deviation", points)];
    chart(language, "report-chart-deviation", axis(language, "report-label-deviation", Unit::Percent), series)
}

fn following(machine: &Machine, curves: &SimulationCurves, language: Language) -> ChartGrid {
    let charts = machine.axes.iter().enumerate().map(|(i, of)| {
        let y = axis(language, "report-label-following-error", units(of.unit())[0]);
        let series = vec![Series::line(of.name.as_str(), curves.following(i))];
        Chart { title: of.name.clone(), ..chart(language, "", y, series) }
    });
    let title = language.words("report-chart-following");
    ChartGrid { title, columns: 2, charts: charts.collect() }
}
