//! Check of a machine file: drawing and page.

mod canvas;
mod drawing;
mod outlines;
mod page;
mod tables;

pub use drawing::MachineDrawing;
pub use page::{check_page, check_text};
