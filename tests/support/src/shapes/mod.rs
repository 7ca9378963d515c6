//! Levels of all shapes as sets of points of the plane, and bodies judged against them, written
//! from the definitions: polygons by their corners, discs by their centres, whole sets and what is
//! left of a cell; no frames, no forms, no clamped indices.

pub mod build;
pub mod contact;
pub mod judge;
pub mod level;
pub mod met;
pub mod region;
