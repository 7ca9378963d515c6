//! Pictures: a list of marks, drawn to a PNG or written as SVG.
#![allow(clippy::cast_precision_loss, reason = "drawing only; nothing here flows back into what is drawn")]

pub mod backdrop;
mod canvas;
pub mod ink;
pub mod marks;
pub mod png;
pub mod sketch;
pub mod solid;
pub mod surface;
pub mod svg;
