//! Levels of all shapes as sets of points of the plane, and bodies judged against them, written from the definitions: polygons by their corners,
//! discs by their centres, whole sets and what is left of a cell; no frames, no forms, no clamped indices.

#![allow(dead_code, reason = "each test file uses its own part")]

pub(crate) mod build;
pub(crate) mod contact;
pub(crate) mod judge;
pub(crate) mod level;
pub(crate) mod region;
