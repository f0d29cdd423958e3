//! Numbers and counts beyond all sense are refused where they stand, before anything is made of them.

use crate::jobs::{changed, read, refusal};
use seamwright_message::Message;

const HILLSIDE: &str = include_str!("../../../../examples/hillside.toml");

#[test]
fn slips_of_the_trial_are_refused_at_their_key() {
    let trial = [
        (
            include_str!("../../../../tests/data/field-trial/sec-seam-hang.toml"),
            "joint.preparation.t_bevel.thickness_mm",
        ),
        (
            include_str!("../../../../tests/data/field-trial/sec-bead-memory.toml"),
            "joint.preparation.t_bevel.thickness_mm",
        ),
        (include_str!("../../../../tests/data/field-trial/sec-check-oom.toml"), "weld.speed_mm_s"),
        (include_str!("../../../../tests/data/field-trial/sec-motion-hang.toml"), "sequence.postflow_s"),
        (include_str!("../../../../tests/data/field-trial/sec-motion-hang2.toml"), "sequence.travel_delay_s"),
    ];
    for (text, key) in trial {
        assert_eq!(refusal(text).key, key);
    }
}

#[test]
fn a_groove_of_too_many_beads_is_refused_before_they_are_made() {
    let e = refusal(&changed(HILLSIDE, &[("thickness_mm = 8 ", "thickness_mm = 8000 ")]));
    assert_eq!((e.key.as_str(), e.value.as_str()), ("joint.preparation.t_bevel.thickness_mm", "8000"));
    // If the bead is the mistake, its run is named.
    let e =
        refusal(&changed(HILLSIDE, &[("fill = { layer_mm = 3.5 }", "fill = { layer_mm = 3e-4, area_mm2 = 1e-9 }")]));
    assert_eq!(e.key, "beads.fill");
    let e = refusal(&changed(HILLSIDE, &[("wire_mm = 1.2", "wire_mm = 1e-6")]));
    assert!(e.key.starts_with("beads"), "{e}");
}

#[test]
fn counts_that_several_keys_multiply_to_are_refused_at_one_of_them() {
    // Along a seam of 200 m beads are laid out at every tenth of a millimetre.
    let big = [
        ("radius_mm = 60", "radius_mm = 30000"),
        ("radius_mm = 150", "radius_mm = 90000"),
        ("wire_mm = 1.2", "wire_mm = 1.2\nstation_mm = 0.1"),
    ];
    assert_eq!(refusal(&changed(HILLSIDE, &big)).key, "beads.station_mm");
    // A thousand copies of many beads.
    let rows = "[rows]\nrows = 10\ncolumns = 100\nstep_mm = [400, 0, 0]\nrow_step_mm = [0, 400, 0]\n[joint]";
    let e = refusal(&changed(HILLSIDE, &[("[joint]", rows), ("wire_mm = 1.2", "wire_mm = 1.2\nstation_mm = 0.2")]));
    assert!(["weld-too-many-rows", "weld-too-many-passes"].contains(&e.message.code.as_ref()), "{e}");
    // A step that puts the copies too far away.
    let far = rows.replace("400, 0, 0", "9e6, 0, 0");
    assert_eq!(refusal(&changed(HILLSIDE, &[("[joint]", &far)])).key, "rows.step_mm");
}

/// A line of this length with a butt joint to fill.
fn line(length_mm: f64, preparation: &str, beads: &str) -> String {
    format!(
        "schema = 1\ntitle = \"t\"\nmachine = \"m\"\n[seam.line]\nstart_mm = [0, 0, 0]\nend_mm = [{length_mm}, 0, 0]\n\
         first_normal = [0, 0, 1]\nsecond_normal = [0, 0, 1]\n[joint]\npreparation.{preparation}\n[beads]\n{beads}\n\
         [weld]\nspeed_mm_s = 5\n"
    )
}

const ROWS: &str = "[rows]\nrows = 10\ncolumns = 100\nstep_mm = [400, 0, 0]\nrow_step_mm = [0, 400, 0]\n";

#[test]
fn tacks_and_welds_are_counted_together() {
    let job = format!(
        "schema = 1\ntitle = \"t\"\nmachine = \"m\"\n{ROWS}[seam.circle]\nradius_mm = 100\n[tacks]\nlength_mm = 10\n\
         count = 8\n[order]\nparts = \"quadrants\"\n[weld]\nspeed_mm_s = 5\n"
    );
    let e = refusal(&job);
    assert_eq!(e.key, "order");
    assert_eq!(e.message, Message::new("weld-too-many-passes").count("passes", 12_000));
    // Two tacks less are as many passes as a program holds.
    assert_eq!(read(&job.replace("count = 8", "count = 6")).program.value.passes.len(), 10_000);
    // Of tacks in a groove each has the rows of the root bead: counted before they are made.
    let groove = line(3000.0, "square = { thickness_mm = 3, root_gap_mm = 1 }", "fill = { area_mm2 = 3 }");
    // Rows that are alike would be one.
    let gaps = "[[joint.fit_up]]\ns_mm = 0\nroot_gap_mm = 1\n[[joint.fit_up]]\ns_mm = 3000\nroot_gap_mm = 1.2\n";
    let e = refusal(&format!("{groove}{ROWS}{gaps}[tacks]\nlength_mm = 1\ncount = 7\n"));
    assert!(e.key == "tacks" && e.message.code == "weld-too-many-rows", "{e}");
}

#[test]
fn refusals_of_many_rows_name_a_table_of_the_file() {
    let stations: String =
        (0..4100).map(|i| format!("[[weld.at]]\ns_mm = {}\nspeed_mm_s = {}\n", i, 5 + i % 2)).collect();
    let weld = "first_normal = [0, 0, 1]\nsecond_normal = [0, 0, 1]\n[weld]\nspeed_mm_s = 5\n";
    let seam = format!("[seam.line]\nstart_mm = [0, 0, 0]\nend_mm = [4100, 0, 0]\n{weld}");
    let job = format!("schema = 1\ntitle = \"t\"\nmachine = \"m\"\n{ROWS}{seam}{stations}");
    let e = refusal(&job);
    assert!(e.key == "rows" && e.message.code == "weld-too-many-rows", "{e}");
    let copies: String =
        (0..1000).map(|i| format!("[[copies]]\nname = \"{i}\"\nplacement.move_mm = [0, {i}, 0]\n")).collect();
    assert_eq!(refusal(&job.replace(ROWS, &copies)).key, "copies");
}

#[test]
fn too_many_stations_at_the_default_distance_are_refused_at_the_beads() {
    let square = "square = { thickness_mm = 3, root_gap_mm = 1 }";
    let stations = line(200_000.0, square, "fill = { area_mm2 = 3 }");
    assert_eq!(refusal(&stations).key, "beads");
    let positions = line(50_000.0, "square = { thickness_mm = 300, root_gap_mm = 12 }", "fill = { area_mm2 = 30 }");
    assert_eq!(refusal(&positions).key, "beads");
    for text in [stations, positions] {
        assert_eq!(refusal(&text.replace("[beads]", "[beads]\nstation_mm = 4.9")).key, "beads.station_mm");
    }
}

/// Thousands of layers, each of which may be left out at each station: work that grows with their product, no faster.
#[test]
fn layers_left_out_of_a_thick_groove_are_chosen_in_seconds() {
    let beads = "adapt = \"passes\"\nmost_percent = 80\nfill = { layer_mm = 0.1, area_mm2 = 1 }";
    let job = line(1000.0, "square = { thickness_mm = 300, root_gap_mm = 12 }", beads);
    let fit_up =
        "[[joint.fit_up]]\ns_mm = 0\nroot_gap_mm = 12\n[[joint.fit_up]]\ns_mm = 1000\nroot_gap_mm = 6\n[beads]";
    let begin = std::time::Instant::now();
    for text in [job.clone(), job.replace("[beads]", fit_up)] {
        let plan = read(&text).plan.unwrap();
        assert!(plan.count() > 2000, "{}", plan.count());
        println!("{} beads, {:?}", plan.count(), begin.elapsed());
    }
    // A minute in an optimised build would be a fault of the order of growth; tests run unoptimised.
    assert!(begin.elapsed().as_secs() < 120, "{:?}", begin.elapsed());
}

#[test]
fn a_pass_of_more_than_a_day_is_refused_at_its_speed() {
    let job =
        "schema = 1\ntitle = \"t\"\nmachine = \"m\"\n[seam.circle]\nradius_mm = 100\n[weld]\nspeed_mm_s = 0.005\n";
    assert_eq!(refusal(job).key, "weld.speed_mm_s");
    assert_eq!(refusal(&job.replace("0.005", "1e-20")).message.code, "document-too-small");
    let e = refusal(&changed(HILLSIDE, &[("speed_mm_s = 5,", "speed_mm_s = 0.001, area_mm2 = 20,")]));
    assert_eq!(e.key, "beads.root.speed_mm_s");
}

#[test]
fn seams_of_more_than_a_kilometre_are_refused() {
    let job = |seam: &str| format!("schema = 1\ntitle = \"t\"\nmachine = \"m\"\n{seam}\n[weld]\nspeed_mm_s = 5\n");
    let e = refusal(&job(
        "[seam.line]\nstart_mm = [-9e6, 0, 0]\nend_mm = [9e6, 0, 0]\nfirst_normal = [0, 0, 1]\nsecond_normal = [0, 0, 1]",
    ));
    assert_eq!(e.key, "seam");
    assert_eq!(refusal(&job("[seam.helix]\nradius_mm = 1000\npitch_mm = 10\nturns = 900")).key, "seam");
    assert_eq!(refusal(&job("[seam.circle]\nradius_mm = 1e7")).key, "seam.circle.radius_mm");
}

#[test]
fn programs_of_too_many_passes_are_refused_before_they_are_repeated() {
    let span = "[[passes.spans]]\nfrom_mm = 0\nto_mm = 100\nspeed_mm_s = 5\n";
    let pass = |repeat: u32| format!("[[passes]]\nname = \"p\"\nrepeat = {repeat}\n{span}");
    let text = format!(
        "schema = 1\ntitle = \"t\"\nmachine = \"m\"\n[seam.circle]\nradius_mm = 100\n{}",
        (0..11).map(|_| pass(1000)).collect::<String>()
    );
    assert_eq!(refusal(&text).key, "passes[10].repeat");
}
