//! All tests in one program, which is compiled and linked once. Tests that measure resources of the process have
//! their own.

mod alarm_reference;
mod cycle_supervisor;
mod modbus;
#[path = "../support/modbus_cell.rs"]
mod modbus_cell;
#[path = "../support/modbus_server.rs"]
mod modbus_server;
mod robot_protocols;
mod step_drives;
