//! Frames of joints whose midline is known. [`Canvas`] paints, [`Kind`] selects the content.

mod canvas;
mod draw;

use super::random::Random;
pub use canvas::{Canvas, Disturbances, OrientedPoint, Texture};
pub use draw::{Kind, Scene, Truth, scene};
