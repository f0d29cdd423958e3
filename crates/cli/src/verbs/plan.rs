use super::post::differences;
use super::simulate::judge;
use super::weld_summary::summary;
use crate::args::PlanArgs;
use crate::clock;
use crate::planning;
use crate::refusals::not_json;
use crate::rows::{json_text, print_either};
use seamwright_motion::WeldMotion;
use seamwright_program::Oscillation;
use seamwright_project::failure::Failure;
use seamwright_project::files::Output;
use seamwright_project::load::Loaded;
use seamwright_project::posting::PostTarget;
use seamwright_report::{Extent, Language, Plots, PostFigures, WeldReport};
use seamwright_weld::{Cut, Welding};
use std::fmt::Write;
use std::path::{Component, Path, PathBuf};

/// Points in the table of a beam's oscillation.
const OSCILLATION_POINTS: u32 = 256;

pub(crate) fn run(args: &PlanArgs) -> Result<(), Failure> {
    let loaded = planning::load(&args.job, &args.planning)?;
    // A plan that leaves its procedure is written all the same: its report shows where.
    let motion = planning::try_plan(&loaded, &args.planning)?.map_err(Failure::Findings)?;
    // Posts are made first: if one fails, no file is written.
    let mut dialects: Vec<PostTarget> = args.post.iter().map(|dialect| (*dialect).into()).collect();
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
    write_report(&mut output, &report, &plots, &loaded.welding, args.appendix.extent())?;
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
    let passes = &loaded.welding.program.value.passes;
    for (i, pass) in passes.iter().enumerate() {
        // Passes with the same oscillation share a file.
        let is_new = passes[..i].iter().all(|earlier| earlier.oscillation != pass.oscillation);
        if let Some(oscillation) = pass.oscillation.as_ref().filter(|_| is_new) {
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

/// The program for a control, as `post` writes it without options, and its proof.
fn post(loaded: &Loaded, motion: &WeldMotion, target: PostTarget) -> Result<(PostFigures, String), Failure> {
    let (text, proof) = differences(target.proven(loaded, motion))?;
    Ok((PostFigures::new(target.name(), target.file_name(), target.tolerance_mm(), proof), text))
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
    let text = program.to_toml().map_err(not_json)?;
    output.text("program.toml", &text)
}

/// Adds report.json and, in the language of the process, report.html.
pub(super) fn write_report(
    output: &mut Output,
    report: &WeldReport,
    plots: &[Plots],
    welding: &Welding,
    extent: Extent,
) -> Result<(), Failure> {
    output.text("report.json", &json_text(report)?)?;
    let language = Language::of_process();
    output.text("report.html", &report.page(plots, welding.program.text(), &clock::now(), extent, language))
}

/// Gives the files their names and prints the summary.
pub(super) fn finish(output: Output, report: &WeldReport, json: bool) -> Result<(), Failure> {
    let paths = output.finish()?;
    print_either(json, report, || summary(report, &paths))
}
