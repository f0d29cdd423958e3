//! Time of what must be fast, from the geometry of a seam to a row of a trace. `make bench` prints it; a part
//! of a name on the command line chooses.

mod beads;
mod clearance;
mod feed_override;
mod fine;
mod inverse;
mod jog;
mod joint;
mod measure;
mod plan;
mod position_loop;
mod pulses;
mod read;
mod reduce;
mod redundancy;
mod seam_point;
mod speed_profile;
mod stripe;
mod trace;
mod write;

fn main() {
    beads::beads();
    clearance::clearance();
    feed_override::benches();
    feed_override::runs();
    fine::benches();
    inverse::inverse();
    inverse::arms();
    inverse::numeric();
    jog::benches();
    joint::joint();
    plan::benches();
    position_loop::ten_loops();
    pulses::benches();
    read::reads();
    reduce::benches();
    redundancy::benches();
    seam_point::seam_point();
    speed_profile::profiles();
    speed_profile::finely();
    stripe::stripe();
    trace::rows();
    write::bench();
}
