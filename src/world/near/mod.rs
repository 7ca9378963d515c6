//! What of a level's surface is near: contacts, and the nearest point.

pub(in crate::world) mod closest;
pub(in crate::world) mod contact_box;
pub(in crate::world) mod contact_circle;
pub(in crate::world) mod contacts;
pub(in crate::world) mod measure;
