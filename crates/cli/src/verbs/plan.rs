use super::post::proven;
use super::simulate::judge;
use crate::args::PlanArgs;
use crate::clock;
use crate::failure::{Failure, places_text, severity_word};
use crate::files::{Output, written_text};
use crate::load::{Loaded, load};
use crate::planning;
use crate::rows::{print_json, print_text};
use seamwright_cell::Summary;
use seamwright_cell::tracking::BeamSummary;
use seamwright_motion::WeldMotion;
use seamwright_post::{Control, Dialect, Feed, Options};
use seamwright_program::{Oscillation, group_findings};
use seamwright_report::{Language, PassFigures, Plots, PostFigures, WeldReport};
use seamwright_weld::{Cut, Welding};
use std::fmt::Write;
use std::path::{Component, Path, PathBuf};

/// Points in the table of a beam's oscillation.
const OSCILLATION_POINTS: u32 = 256;

pub(crate) fn run(args: &PlanArgs) -> Result<(), Failure> {
    let loaded = load(&args.job)?;
    // A plan that leaves its procedure is written all the same: its report shows where.
    let motion = planning::try_plan(&loaded, &args.planning)?.map_err(Failure::Findings)?;
    // Posts are made first: if one fails, no file is written.
    let mut dialects: Vec<Dialect> = args.post.iter().map(|dialect| (*dialect).into()).collect();
    dialects.dedup();
    let posts = dialects.into_iter().map(|dialect| post(&loaded, &motion, dialect));
    let posts: Vec<(PostFigures, String)> = posts.collect::<Result<_, _>>()?;
    let mut output = Output::new(&args.output.clone().unwrap_or_else(|| usual_output(&args.job)))?;
    let (mut report, plots) = WeldReport::new(&loaded.machine, &loaded.welding, &motion, None, Language::of_process());
    for (figures, text) in posts {
        output.text(&figures.file, &text)?;
        report.posts.push(figures);
    }
    write_program(&mut output, &loaded)?;
    write_report(&mut output, (&report, &plots), &loaded.welding, Language::of_process())?;
    for (i, plots) in plots.iter().enumerate().filter(|_| args.plots) {
        for (name, svg) in plots.files() {
            // The first pass's plots have the plain names.
            let name = if i == 0 { name } else { format!("pass-{}-{name}", i + 1) };
            output.text(&format!("plots/{name}"), &svg)?;
        }
    }
    if let Some(cut) = &loaded.welding.cut {
        output.text("cut.csv", &cut_table(cut))?;
    }
    for (i, pass) in loaded.welding.program.value.passes.iter().enumerate() {
        if let Some(oscillation) = &pass.oscillation {
            let name = if i == 0 { "oscillation.csv".to_owned() } else { format!("pass-{}-oscillation.csv", i + 1) };
            output.text(&name, &oscillation_table(oscillation))?;
        }
    }
    finish(output, &report, args.json)?;
    judge(report)
}

/// Default output of a plan: a folder with the name of the job, in `out`.
fn usual_output(job: &Path) -> PathBuf {
    Path::new("out").join(job.file_stem().unwrap_or(job.as_os_str()))
}

/// The part program for a control, as `post` writes it without options, and its proof.
fn post(loaded: &Loaded, motion: &WeldMotion, dialect: Dialect) -> Result<(PostFigures, String), Failure> {
    let control = Control::new(&loaded.machine, dialect).map_err(|e| Failure::input(e.to_string()))?;
    let options = Options::default();
    let (text, proof) = proven(loaded, motion, &control, &options, Feed::InverseTime)?;
    let name = match dialect {
        Dialect::Sinumerik => "sinumerik.mpf",
        Dialect::Linuxcnc => "linuxcnc.ngc",
        Dialect::Grblhal => "grblhal.nc",
        Dialect::Pmac => "pmac.pmc",
    };
    Ok((PostFigures::new(dialect, name, options.tolerance_mm, proof), text))
}

/// The end of a tube as it is cut, point by point.
fn cut_table(cut: &Cut) -> String {
    let mut text = "side,phi_deg,around_mm,height_mm,dihedral_deg\n".to_owned();
    let sides = [Some(("outside", &cut.outside)), cut.inside.as_ref().map(|inside| ("inside", inside))];
    for (side, unrolled) in sides.into_iter().flatten() {
        for p in &unrolled.points {
            let (phi, dihedral) = (p.phi.to_degrees(), p.dihedral.to_degrees());
            // Writing to a String cannot fail.
            let _ = writeln!(text, "{side},{phi},{},{},{dihedral}", p.around, p.height);
        }
    }
    text
}

/// One period of a beam's deflection, for a function generator.
fn oscillation_table(oscillation: &Oscillation) -> String {
    let mut text = "t_us,across_mm,along_mm\n".to_owned();
    for i in 0..OSCILLATION_POINTS {
        let phase = f64::from(i) / f64::from(OSCILLATION_POINTS);
        let (across, along) = oscillation.at(phase);
        // Writing to a String cannot fail.
        let _ = writeln!(text, "{:.4},{across:.6},{along:.6}", 1e6 * phase / oscillation.frequency_hz.get());
    }
    text
}

/// Adds program.toml, the machine file if it is not a shipped one, and the STL files that are named. So the folder is
/// complete.
pub(super) fn write_program(output: &mut Output, loaded: &Loaded) -> Result<(), Failure> {
    let mut program = loaded.welding.program.value.clone();
    if let Some(path) = &loaded.machine_file {
        let name = path.file_name().map_or("machine.toml".into(), |n| n.to_string_lossy().into_owned());
        output.copy(&name, path)?;
        program.machine = name;
    }
    for (name, path) in &loaded.stl_files {
        // A file outside this folder is only found by its original name.
        let stays = Path::new(name).components().all(|c| matches!(c, Component::Normal(_) | Component::CurDir));
        if stays {
            output.copy(name, path)?;
        }
    }
    let text = program.to_toml().map_err(|e| Failure::environment(e.to_string()))?;
    output.text("program.toml", &text)
}

/// Adds report.json and, in this language, report.html.
pub(super) fn write_report(
    output: &mut Output,
    (report, plots): (&WeldReport, &[Plots]),
    welding: &Welding,
    language: Language,
) -> Result<(), Failure> {
    let json = serde_json::to_string_pretty(report).map_err(|e| Failure::environment(e.to_string()))?;
    output.text("report.json", &(json + "\n"))?;
    output.text("report.html", &report.page(plots, welding.program.text(), &clock::now(), language))
}

/// Gives the files their names and prints the summary.
pub(super) fn finish(output: Output, report: &WeldReport, json: bool) -> Result<(), Failure> {
    let paths = output.finish()?;
    if json { print_json(report) } else { print_text(&summary(report, &paths)) }
}

/// Deviation of the weld from a seam that is elsewhere than planned: tracked, and without.
fn tracking(text: &mut String, s: &Summary) {
    for head in &s.heads {
        let (p99, most) = (head.miss_p99_mm, head.miss_most_mm);
        let (plain_p99, plain_most) = (head.untracked_p99_mm, head.untracked_most_mm);
        let _ = match head.tracked {
            _ if !s.welded => Ok(()),
            true => writeln!(
                text,
                "  {:<12} {p99:.3} mm from the joint for 99 % of the weld, {most:.3} mm at most; untracked {plain_p99:.3} and {plain_most:.3} mm",
                head.head
            ),
            false => writeln!(
                text,
                "  {:<12} {p99:.3} mm from the joint for 99 % of the weld, {most:.3} mm at most; not tracked",
                head.head
            ),
        };
        if let Some(beam) = head.beam.as_ref().filter(|_| s.welded) {
            let _ = writeln!(text, "               {}", beam_line(beam));
        }
        if let Some(at) = head.stopped_mm {
            let _ = writeln!(text, "  {:<12} stopped at {at:.1} mm", if s.welded { "" } else { &head.head });
        }
        for alarm in &head.alarms {
            let _ = writeln!(text, "               at {:.1} mm: {}", alarm.at_mm, alarm.text());
        }
    }
}

/// Correction by a beam.
fn beam_line(beam: &BeamSummary) -> String {
    let by = if beam.replayed { "replayed: " } else { "" };
    let fit = beam.fit.map_or_else(String::new, |fit| {
        format!("; nine of ten of {} points within {:.3} mm of what is stored", fit.points, fit.within_mm)
    });
    format!(
        "{by}deflected by up to {:.3} of {} mm, gun carried by {:.3} mm; beam away {:.2} % of the time, {:.1} ms at most{fit}",
        beam.deflected_mm, beam.range_mm, beam.carried_mm, beam.away_percent, beam.longest_away_ms
    )
}

fn summary(r: &WeldReport, paths: &[PathBuf]) -> String {
    let mut text = format!("{}\n", r.title);
    // Writing to a String cannot fail.
    let _ = writeln!(text, "  machine      {}", r.machine.title);
    if let Some(seam) = &r.seam {
        let _ = writeln!(text, "  seam         {:.3} mm, weld {:.3} mm", seam.length_mm, seam.weld_length_mm);
    }
    if let [pass] = r.passes.as_slice() {
        only_pass(&mut text, pass);
    } else {
        several_passes(&mut text, r);
    }
    let totals = &r.totals;
    let energy = totals.arc_energy_kj.filter(|kj| *kj > 0.0).map(|kj| format!("{kj:.1} kJ arc energy"));
    let wire = totals.wire_m.filter(|m| *m > 0.0).map(|m| format!("{m:.2} m of wire"));
    let takes: Vec<String> = energy.into_iter().chain(wire).collect();
    if !takes.is_empty() {
        let _ = writeln!(text, "  takes        {}", takes.join(", "));
    }
    let _ = writeln!(text, "  air moves    {:.2} s, home to home {:.2} s", r.air_s, r.total_s);
    for group in group_findings(&r.findings) {
        let word = severity_word(group.finding);
        let _ = writeln!(text, "  {word:<12} {} ({})", group.message, places_text(&group));
    }
    for line in written_text(paths) {
        let _ = writeln!(text, "  wrote        {line}");
    }
    text
}

/// The only pass of a weld, in many lines.
fn only_pass(text: &mut String, pass: &PassFigures) {
    let p = &pass.plan;
    let _ = writeln!(
        text,
        "  speed        {:.4} to {:.4} mm/s planned, {} to {} asked",
        p.least_speed_mm_s, p.greatest_speed_mm_s, p.asked_speed_mm_s.0, p.asked_speed_mm_s.1
    );
    let _ = writeln!(
        text,
        "  time         {:.2} s travel, {:.2} s arc on, {:.2} s in all",
        p.weld_s, p.arc_on_s, p.total_s
    );
    if let Some(s) = &pass.simulation {
        simulated(text, s);
    }
    if let Some(energy) = energy_text(pass) {
        let _ = writeln!(text, "  energy       {energy}");
    }
    if let Some(clearance) = clearance_text(pass) {
        let _ = writeln!(text, "  clearance    {clearance}");
    }
}

/// Several passes: totals, then a line each, and the results of simulated ones.
fn several_passes(text: &mut String, r: &WeldReport) {
    let totals = &r.totals;
    let _ = writeln!(text, "  passes       {}, {:.3} mm in all", totals.passes, totals.length_mm);
    let _ = writeln!(
        text,
        "  time         {:.2} s travel, {:.2} s arc on, {:.2} s in all",
        totals.weld_s, totals.arc_on_s, totals.total_s
    );
    for (number, pass) in (1..).zip(&r.passes) {
        let p = &pass.plan;
        let mut parts = vec![
            format!("{:.1} mm", p.length_mm),
            format!("{:.3} to {:.3} mm/s", p.least_speed_mm_s, p.greatest_speed_mm_s),
            format!("{:.2} s", p.weld_s),
        ];
        parts.extend(energy_text(pass));
        parts.extend(clearance_text(pass).map(|clearance| format!("clearance {clearance}")));
        let _ = writeln!(text, "  pass {number:<7} {}: {}", pass.name, parts.join(", "));
        if let Some(s) = &pass.simulation {
            simulated(text, s);
        }
    }
}

/// Arc energy and, with a procedure, heat input of a pass.
fn energy_text(pass: &PassFigures) -> Option<String> {
    let range = |(low, high): (f64, f64)| match high - low < 1e-3 * high {
        true => format!("{high:.3} kJ/mm"),
        false => format!("{low:.3} to {high:.3} kJ/mm"),
    };
    let energy = pass.plan.arc_energy_kj_mm.map(|energy| format!("arc energy {}", range(energy)));
    let heat = pass.heat_input_kj_mm().map(|heat| format!("heat input {}", range(heat)));
    let both: Vec<String> = energy.into_iter().chain(heat).collect();
    (!both.is_empty()).then(|| both.join(", "))
}

fn clearance_text(pass: &PassFigures) -> Option<String> {
    let c = pass.clearance.as_ref()?;
    let between = c.between.as_deref().unwrap_or("nothing watched comes nearer");
    Some(format!("{:.2} mm: {between}", c.nearest_mm))
}

/// Result of a simulated pass.
fn simulated(text: &mut String, s: &Summary) {
    if !s.welded {
        let _ = writeln!(text, "  welded       nothing of it (simulated)");
        return tracking(text, s);
    }
    let e = &s.path_error_mm;
    let _ = writeln!(text, "  path error   {:.4} mm greatest, {:.4} mm RMS (simulated)", e.max, e.rms);
    tracking(text, s);
    let _ = match &s.tip_speed_mm_s {
        Some(v) => writeln!(
            text,
            "  tip speed    {:.4} to {:.4} mm/s, RMS deviation {:.4} mm/s (simulated)",
            v.min, v.max, v.rms
        ),
        None => writeln!(text, "  tip speed    too short a weld to judge"),
    };
    for a in &s.axes {
        let f = &a.following_error;
        let worst = f.min.abs().max(f.max.abs());
        let _ = writeln!(text, "  axis {:<7} following error {worst:.5} {}, RMS {:.5}", a.axis, a.unit, f.rms);
    }
}
