//! All tests in one program, which is compiled and linked once. Tests that measure resources of the process have
//! their own.

mod beam;
#[path = "../common/mod.rs"]
mod common;
mod corners;
mod devices;
mod elastic;
mod executive;
mod executive_tracked;
mod fault_injection;
mod groove;
mod homing;
mod joint;
mod missed_cycles;
#[path = "../../../executive/tests/support/modbus_cell.rs"]
mod modbus_cell;
#[path = "../../../executive/tests/support/modbus_server.rs"]
mod modbus_server;
mod robot_looped;
mod robot_sockets;
mod shutdown;
mod simulate;
mod stripe;
mod teaching;
mod tracked;
mod tracking;
mod tracking_stripes;
