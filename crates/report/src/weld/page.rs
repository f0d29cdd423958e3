use super::Plots;
use super::figures::{ClearanceFigures, PassFigures, WeldReport};
use super::limits::{axes_table, bounds_table, speed_text, uses_table};
use super::plan::PlanFigures;
use super::procedure::{positions_table, procedure_text, windows_table};
use super::tracking;
use crate::{Block, Finding, Language, Page, Severity, Table, Tile, Verdict, format_number};
use seamwright_cell::Summary;
use seamwright_program::WeldDirection;

impl WeldReport {
    /// The report as one self-contained HTML page; `source` is the job's or program's text, `date` when
    /// it is made, `plots` those of each pass.
    pub fn page(&self, plots: &[Plots], source: &str, date: &str) -> String {
        let mut blocks = vec![Block::Tiles(self.tiles()), Block::Heading("Findings".to_owned())];
        blocks.push(Block::Paragraph(self.checked()));
        blocks.push(match self.findings.is_empty() {
            true => Block::Paragraph("None: the weld can be made as asked on this machine.".to_owned()),
            false => Block::Findings(self.findings.iter().map(finding).collect()),
        });
        if let Some(order) = plots.first().and_then(|plots| plots.order.as_ref()) {
            blocks.push(Block::Heading("Order of welding".to_owned()));
            blocks.push(figure(
                order.to_svg(),
                "Passes numbered in the order of welding. Dashed: the torch in the air, drawn straight from end to start.",
            ));
            blocks.push(self.order_table());
        }
        for (i, (pass, plots)) in self.passes.iter().zip(plots).enumerate() {
            self.pass(i, pass, plots, &mut blocks);
        }
        if !self.posts.is_empty() {
            blocks.push(Block::Heading("Part programs".to_owned()));
            blocks.extend(self.posts.iter().flat_map(super::PostFigures::blocks));
        }
        blocks.push(Block::Heading("Job".to_owned()));
        blocks.push(self.data_table());
        blocks.push(Block::Code { caption: self.file.clone(), text: source.to_owned() });
        blocks.push(Block::Heading("Released".to_owned()));
        blocks.push(table(
            "To be filled in by hand",
            &["", "Name", "Date", "Signature"],
            ["Welding engineer", "Inspector"]
                .map(|who| vec![who.to_owned(), String::new(), String::new(), String::new()])
                .into(),
            4..4,
        ));
        Page {
            language: Language::English,
            title: self.title.clone(),
            subtitle: format!(
                "Weld report: {}",
                if self.simulation.is_some() { "plan and simulation" } else { "plan" }
            ),
            meta: vec![
                ("Machine".to_owned(), self.machine.title.clone()),
                ("File".to_owned(), self.file.clone()),
                ("Date".to_owned(), date.to_owned()),
                ("Made by".to_owned(), format!("Seamwright {}", self.seamwright)),
            ],
            verdict: Some(self.verdict()),
            blocks,
        }
        .render()
    }

    /// Everything about one pass; `number` counts from 0.
    fn pass(&self, number: usize, pass: &PassFigures, plots: &Plots, blocks: &mut Vec<Block>) {
        let several = self.passes.len() > 1;
        let heading = |what: &str| {
            Block::Heading(if several {
                format!("Pass {} ({}): {what}", number + 1, pass.name)
            } else {
                what.to_owned()
            })
        };
        blocks.push(heading("Seam and torch"));
        blocks.push(figure(
            plots.seam.to_svg(),
            "Seam with the torch axis asked for, in the job's frame, first-angle projection.",
        ));
        blocks.extend(plots.torch.as_ref().map(|torch| figure(
            torch.to_svg(),
            "Work angle from the bisector of the faces (positive towards the first part), travel angle, and half the angle between the faces.",
        )));
        blocks.extend(plots.process.as_ref().map(|process| {
            figure(
                process.to_svg(),
                "Process values along the pass where they change; slopes at its ends are not in it.",
            )
        }));
        if let Some(weave) = &plots.weave {
            blocks.push(figure(
                weave.to_svg(),
                "The woven path as asked, seen along the torch with the seam laid straight, the same scale along and across; the way goes to the right.",
            ));
        }
        if let Some(oscillation) = &plots.oscillation {
            blocks.push(figure(
                oscillation.to_svg(),
                "Where the deflected beam goes on the work, the same scale along and across; oscillation.csv has one period of the deflection.",
            ));
        }
        if let Some(cut) = &plots.cut {
            blocks.push(figure(
                cut.clone(),
                "The tube's end as it is cut, unrolled; cut.svg has it at true size, seen from outside, to wrap around the tube, and cut.csv its points.",
            ));
        }
        if let Some(sections) = &plots.sections {
            blocks.push(Block::Heading("Joint".to_owned()));
            blocks.push(figure(
                sections.to_svg(),
                "Cross-sections along the seam, all at one scale, the second part's face level or a butt joint's face up: beads in the order of welding, and where the wire points in each; the area is that of the groove and of the cap over it.",
            ));
        }
        if let (Some(figures), Some(drawn), Some(procedure)) = (&pass.procedure, &plots.procedure, &self.procedure) {
            blocks.push(heading("Procedure"));
            blocks.push(Block::Paragraph(procedure_text(procedure, figures)));
            if let Some(heat_input) = &drawn.heat_input {
                blocks.push(figure(
                    heat_input.to_svg(),
                    "Heat input at the planned speed between run-up and run-down, with its window; shaded where it is outside.",
                ));
            }
            blocks.push(figure(
                drawn.positions.to_svg(),
                "Welding position (ISO 6947) by slope of the travel and rotation of the weld's face, as the machine's axes turn the part.",
            ));
            blocks.push(windows_table(figures));
            blocks.push(positions_table(figures));
        }
        if !plots.taught.is_empty() {
            blocks.push(heading("Taught spans"));
        }
        for taught in &plots.taught {
            blocks.push(Block::Paragraph(taught.text.clone()));
            blocks.push(figure(
                taught.charts.to_svg(),
                "The seam as welded against the nominal one: at both joins the same place, direction and curvature.",
            ));
        }
        if let Some(clearance) = &plots.clearance {
            blocks.push(heading("Clearance"));
            if let Some(text) = pass.clearance.as_ref().and_then(nearest_text) {
                blocks.push(Block::Paragraph(text));
            }
            blocks.push(figure(
                clearance.to_svg(),
                "Least distance of torch, links, part, fixtures and zones from one another, and the bound below which none falls anywhere.",
            ));
        }
        blocks.push(heading("Speed"));
        blocks.push(Block::Paragraph(speed_text(&pass.certificate)));
        blocks.push(figure(
            plots.speed.to_svg(),
            "Speed of the tip along the seam, relative to the work; shaded where it is slower than asked, with the limit that binds.",
        ));
        blocks.push(bounds_table(&pass.certificate));
        if let Some(deviation) = &plots.deviation {
            blocks.push(figure(
                deviation.to_svg(),
                "Deviation of the simulated speed between run-up and run-down; at its start the drives settle.",
            ));
        }
        if let (Some(summary), Some(path_error), Some(following), Some(attitude)) =
            (&pass.simulation, &plots.path_error, &plots.following, &plots.attitude)
        {
            if let Some(tracked) = &plots.tracking {
                blocks.push(heading("Tracking"));
                blocks.push(Block::Paragraph(tracking::text(&summary.heads)));
                blocks.push(Block::Table(tracking::table(&summary.heads)));
                blocks.extend(tracking::beam_table(&summary.heads).map(Block::Table));
                blocks.push(figure(
                    tracked.to_svg(),
                    "Where the joint truly lies beside the planned path, how far the weld lies from it, and how well tracking knew the joint.",
                ));
            }
            blocks.push(heading("Simulated weld"));
            blocks.push(Block::Paragraph(simulation_text(summary, &self.machine.assumed_drives)));
            blocks.push(figure(path_error.to_svg(), "Distance of the true tip from the seam, normal to it."));
            blocks.push(figure(following.to_svg(), "Set-point less true position of each axis."));
            blocks.push(following_table(summary));
            if pass.plan.attitude_error_deg > 0.01 {
                blocks.push(figure(attitude.to_svg(), "Angle between the true torch direction and the one asked for."));
            }
        }
        blocks.push(heading("Axes"));
        blocks.push(figure(
            plots.axes.to_svg(),
            "Planned position, speed and acceleration of each axis against its limits.",
        ));
        blocks.push(figure(plots.jerks.to_svg(), "Planned jerk of each axis against its limit."));
        blocks.push(axes_table(&pass.plan.axes));
        blocks.push(uses_table(&pass.certificate));
    }

    /// What was looked at, and what not.
    fn checked(&self) -> String {
        let watched = self.passes.iter().find_map(|p| p.clearance.as_ref()).map(|c| c.watched.join(", "));
        let clearance = match watched {
            Some(names) => format!(
                "the distances from one another of {names}, along the passes and in the air moves, as far as the files give their shapes. Not checked: what is not in this list, parts beyond the lengths that the job gives them, cables and hoses."
            ),
            None => "nothing about collisions: the machine file has no shapes.".to_owned(),
        };
        format!(
            "Checked: reach, ranges, speeds, accelerations and jerks of the axes, that the torch axis stays clear of both faces, and {clearance}"
        )
    }

    fn verdict(&self) -> Verdict {
        let p = &self.plan;
        let held = match p.speed_held {
            true => "the asked speed from run-up to run-down".to_owned(),
            false => format!("slowed to {} mm/s where an axis needs it", number(p.least_speed_mm_s)),
        };
        let left = self.findings.iter().filter(|f| f.kind == "procedure").count();
        let kept = match (&self.procedure, left) {
            (None, _) => String::new(),
            (Some(p), 0) => format!(" Within {}.", p.number),
            (Some(p), n) => format!(" Outside {}: {n} finding{}.", p.number, if n == 1 { "" } else { "s" }),
        };
        let simulated = self.simulation.as_ref().map_or(String::new(), |s| {
            format!(
                " Simulated: path error at most {} mm of {} allowed, {}.",
                small(s.path_error_mm.max),
                number(p.tolerance.path_mm.get()),
                match s.speed_ripple {
                    Some(r) => {
                        let (found, allowed) = (small(100.0 * r), number(p.tolerance.speed_percent.get()));
                        format!("speed within {found} % of {allowed} allowed")
                    }
                    None => "too short to judge its speed".to_owned(),
                }
            )
        });
        Verdict {
            ok: self.findings.iter().all(|f| f.allowed),
            text: format!("Planned: all axes within their limits, {held}.{kept}{simulated}"),
        }
    }

    fn tiles(&self) -> Vec<Tile> {
        let p = &self.plan;
        let tile = |label: &str, value: String, unit: &str, note: String| Tile {
            label: label.to_owned(),
            value,
            unit: unit.to_owned(),
            note,
            ..Tile::default()
        };
        let length = match &self.seam {
            Some(seam) => (seam.weld_length_mm, format!("seam {} mm", number(seam.length_mm))),
            None => (p.length_mm, "through points".to_owned()),
        };
        let mut tiles = vec![
            tile("Weld length", number(length.0), "mm", length.1),
            tile("Weld time", number(p.weld_s), "s", "travel, rest to rest".to_owned()),
            tile(
                "Arc-on time",
                number(p.arc_on_s),
                "s",
                format!("whole cycle {} s, air moves {} s", number(self.total_s), number(self.air_s)),
            ),
            tile(
                "Speed, planned",
                number(p.least_speed_mm_s),
                "mm/s",
                format!("asked {}, greatest {}", p.asked(), number(p.greatest_speed_mm_s)),
            ),
        ];
        if let Some(s) = &self.simulation {
            tiles.push(tile(
                "Path error, simulated",
                small(s.path_error_mm.max),
                "mm",
                format!("greatest; RMS {} mm", small(s.path_error_mm.rms)),
            ));
            let (ripple, note) = match (&s.tip_speed_mm_s, s.speed_ripple) {
                (Some(v), Some(ripple)) => (
                    small(100.0 * ripple),
                    format!("{} to {} mm/s, RMS {} mm/s", number(v.min), number(v.max), small(v.rms)),
                ),
                _ => ("–".to_owned(), "too short a weld to judge".to_owned()),
            };
            tiles.push(tile("Speed ripple, simulated", ripple, "%", note));
        }
        tiles.push(Tile {
            severity: (p.attitude_error_deg > 0.5).then_some(Severity::Warning),
            ..tile("Attitude error", format_number(p.attitude_error_deg, 3), "deg", "greatest, of the plan".to_owned())
        });
        if let Some((least, greatest)) = p.arc_energy_kj_mm {
            let note = if greatest - least < 1e-3 * greatest {
                "U I / v, before any efficiency".to_owned()
            } else {
                format!("greatest; least {}; U I / v", format_number(least, 3))
            };
            tiles.push(tile("Arc energy", format_number(greatest, 3), "kJ/mm", note));
        }
        tiles
    }

    fn data_table(&self) -> Block {
        let length = |label: &str, value: f64| vec![label.to_owned(), number(value), "mm".to_owned()];
        let mut rows = Vec::new();
        if let Some(s) = &self.seam {
            rows.extend([
                vec!["Seam".to_owned(), s.kind.to_owned(), String::new()],
                length("Seam length", s.length_mm),
                length("Weld length", s.weld_length_mm),
                vec!["Dihedral angle, least".to_owned(), number(s.dihedral_min_deg), "deg".to_owned()],
                vec!["Dihedral angle, greatest".to_owned(), number(s.dihedral_max_deg), "deg".to_owned()],
            ]);
        }
        rows.extend([length("Run-up", self.plan.run_up_mm), length("Run-down", self.plan.run_down_mm)]);
        let (start, sequence) = (&self.plan.start, &self.plan.sequence);
        let row = |label: &str, value: f64, unit: &str| vec![label.to_owned(), number(value), unit.to_owned()];
        if self.seam.as_ref().is_some_and(|s| !["line", "T-joint", "spline"].contains(&s.kind)) {
            let direction = match start.direction {
                WeldDirection::CounterClockwise => "counter-clockwise",
                WeldDirection::Clockwise => "clockwise",
            };
            rows.push(row("Start angle", start.phi_deg.get(), "deg"));
            rows.push(vec!["Direction of welding".to_owned(), direction.to_owned(), String::new()]);
            rows.push(row("Overlap", start.overlap_mm.get(), "mm"));
        }
        rows.push(row("Gas before the arc", sequence.preflow_s.get(), "s"));
        rows.push(row("Arc on before travel", sequence.travel_delay_s.get(), "s"));
        let slopes = [("Upslope from", &sequence.upslope), ("Downslope to", &sequence.downslope)];
        for (what, slope) in slopes {
            for (name, value) in slope.iter().flat_map(|s| &s.process) {
                rows.push(row(&format!("{what} {name}"), value.get(), "as named"));
            }
            rows.extend(slope.iter().map(|s| row(&format!("{what}: time"), s.time_s.get(), "s")));
        }
        rows.push(row("Crater fill", sequence.crater_s.get(), "s"));
        rows.push(row("Gas after the arc", sequence.postflow_s.get(), "s"));
        for (name, value) in &self.plan.process {
            let (from, to) = value.ends();
            let value = if value.is_ramp() { format!("{} to {}", number(from), number(to)) } else { number(from) };
            rows.push(vec![name.clone(), value, "as named".to_owned()]);
        }
        table("Job data", &["", "Value", "Unit"], rows, 1..2)
    }
}

impl PlanFigures {
    /// The asked speed, or the range of those of several spans.
    fn asked(&self) -> String {
        let (low, high) = self.asked_speed_mm_s;
        if high > low { format!("{} to {}", number(low), number(high)) } else { number(low) }
    }
}

/// Lengths, times and positions.
pub(super) fn number(value: f64) -> String {
    format_number(value, 5)
}

/// Errors and deviations, which nobody reads to more digits.
fn small(value: f64) -> String {
    format_number(value, 2)
}

fn figure(svg: String, caption: &str) -> Block {
    Block::Figure { svg, caption: caption.to_owned() }
}

fn finding(f: &seamwright_program::Finding) -> Finding {
    let place = if f.to_mm - f.from_mm < 1e-9 {
        format!("s = {} mm", number(f.from_mm))
    } else {
        format!("s = {} to {} mm", number(f.from_mm), number(f.to_mm))
    };
    Finding {
        severity: if f.allowed { Severity::Warning } else { Severity::Error },
        text: f.message.clone(),
        place,
        cure: f.cure.clone(),
    }
}

fn simulation_text(s: &Summary, assumed: &[String]) -> String {
    let worst = s.axes.iter().max_by(|a, b| a.current.total_cmp(&b.current));
    let load = worst.map_or(String::new(), |a| {
        format!(
            " The drive with the highest load is {}: {} % of its peak.",
            a.axis,
            format_number(100.0 * a.current, 3)
        )
    });
    let assumed = match assumed {
        [] => String::new(),
        axes => format!(" The machine file describes no drive for {}: assumed ones were used.", axes.join(", ")),
    };
    format!(
        "Every axis on its position loop at the servo period, with inertia, friction, cogging, encoder steps and current limit (seed {}). It is the nominal part: no misplacement, no distortion, no fit-up error, no wire cast. Speed ripple is the greatest deviation of the tip's speed from the planned one, from half a second after the run-up to the run-down.{load}{assumed}",
        s.seed
    )
}

/// The nearest place in words.
fn nearest_text(c: &ClearanceFigures) -> Option<String> {
    let (between, at) = (c.between.as_ref()?, c.at_mm?);
    Some(format!("Nearest: {between}, {} mm apart at s = {} mm.", number(c.nearest_mm), number(at)))
}

pub(crate) fn table(caption: &str, head: &[&str], rows: Vec<Vec<String>>, numeric: std::ops::Range<usize>) -> Block {
    Block::Table(Table {
        caption: caption.to_owned(),
        head: head.iter().map(|h| (*h).to_owned()).collect(),
        numeric: (0..head.len()).map(|i| numeric.contains(&i)).collect(),
        rows,
    })
}

fn following_table(summary: &Summary) -> Block {
    let rows = summary.axes.iter().map(|a| {
        let e = &a.following_error;
        vec![
            a.axis.clone(),
            a.unit.to_owned(),
            small(e.min),
            small(e.max),
            small(e.rms),
            format_number(100.0 * a.current, 3),
        ]
    });
    let head = ["Axis", "Unit", "Least", "Greatest", "RMS", "Peak load, %"];
    table("Following error while the arc is on", &head, rows.collect(), 2..6)
}
