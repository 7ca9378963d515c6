//! Levels of all shapes as sets of points of the plane, and bodies judged against them. Written
//! from the definitions: polygons by their corners, discs by their centres, whole sets and the rest
//! of a cell. No frames, no forms, no clamped indices.

pub mod build;
pub mod contact;
pub mod judge;
pub mod level;
pub mod met;
pub mod region;
