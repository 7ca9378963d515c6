//! Boxes that move beside a level: platforms, doors, crushers.

pub(super) mod features;
pub(super) mod list;
pub(super) mod ray;
pub(super) mod solid;
