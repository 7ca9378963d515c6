//! What a capsule touches with its sides and its ends, and which way that faces.

use super::super::contact::{Bend, Plane, touched_any};
use super::std::vec::Vec;
use super::{P, capsule, feature, vec2};
use crate::num::Axis;
use crate::world::Geometry;

fn planes(at: P, size: P, geometry: Geometry) -> Vec<Plane> {
    let mut found = Vec::new();
    touched_any(&capsule(at, size, 50), &feature(geometry), &mut |plane| found.push(plane));
    found
}

/// A corner beside a flat side is a straight wall; beyond the ends of the core it is one to go
/// around.
#[test]
fn corners() {
    let corner = |p: P| Geometry::Vertex { p: vec2(p), e_in: Axis::new(2, 1), e_out: Axis::new(-2, 1) };
    let standing = |p: P| planes((0, 0), (0, 100), corner(p));
    assert_eq!(standing((50, 40)), [Plane::flat(Axis::NEG_X)]);
    assert_eq!(standing((-50, 40)), [Plane::flat(Axis::X)]);
    assert_eq!(standing((30, 140)), [Plane { normal: Axis::new(-30, -40), bend: Bend::Convex }]);
    assert_eq!(standing((-40, -30)), [Plane { normal: Axis::new(40, 30), bend: Bend::Convex }]);
    assert!(standing((60, 40)).is_empty() && standing((40, 140)).is_empty());
    let lying = |p: P| planes((100, 0), (-100, 0), corner(p));
    assert_eq!(lying((40, 50)), [Plane::flat(Axis::NEG_Y)]);
    assert_eq!(lying((130, -40)), [Plane { normal: Axis::new(-30, 40), bend: Bend::Convex }]);
}

/// A side is over a wall that it shares a height with; an end alone is beside it.
#[test]
fn walls() {
    let wall = |from: i64| Geometry::Face { a: vec2((50, from)), dir: Axis::NEG_Y, len: 20, joined: [false; 2] };
    let side = |from: i64| planes((0, 0), (0, 100), wall(from)).first().map(|plane| plane.bend);
    // From `from` up to 20 less.
    assert_eq!([side(60), side(115), side(3)], [Some(Bend::Flat); 3]);
    assert_eq!([side(130), side(-14)], [Some(Bend::End); 2]);
    assert_eq!([side(150), side(-34)], [None; 2]); // farther than the rounding distance
}
