//! Shapes: small `Copy` values with private fields, built by checked constructors, so that a shape that exists is inside the domain.

mod aabb;
mod circle;
mod segment;

pub use aabb::Aabb;
pub use circle::Circle;
pub use segment::Segment;
