//! All tests in one program, which is compiled and linked once.

mod beam;
mod bench_tracking;
mod book;
mod certificate;
mod commands;
mod common;
mod edit;
mod find_joint;
mod follow;
mod grouped_verbs;
mod keys;
mod killed;
mod languages;
mod licences;
mod machine_check;
mod machine_tune;
mod mistakes;
#[path = "../../../executive/tests/support/modbus_server.rs"]
mod modbus_server;
#[path = "../../../executive/tests/support/modbus_welder.rs"]
mod modbus_welder;
mod move_to;
mod names;
mod order;
mod passes;
mod place;
mod procedure;
mod pulses;
mod ramps;
mod read;
mod records;
mod reduce;
mod run_cell;
mod run_modbus;
mod seams;
mod section;
mod serve;
mod speed_mistakes;
mod stopped;
mod stripe;
mod taught;
mod teach;
mod two_level;
mod verbs;
mod whole_weld;
