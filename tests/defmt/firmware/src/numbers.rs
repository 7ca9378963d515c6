//! Numbers, shapes, pair queries, errors.

use crate::tell;
use tilesat::prelude::*;
use tilesat::{
    Aabb, Axis, Capsule, Circle, ConvexPolygon, Filter, Fx, Inside, LayerMask, OrientedBox, Quantity, RangeError,
    Ratio, Segment, Toi, Vec2,
    error::{PolygonError, Truncated},
    query::{Part, Separation},
    shape::{AnyShape, Compound, CompoundError, ConvexParts, PartsError},
};

pub(crate) fn tell_all() {
    // Both signs, halves, and digits below the fourth decimal.
    tell(&Vec2::new(Fx::lit("-0.75"), Fx::lit("8191.99999")));
    tell(&Axis::new(-3, 4));
    tell(&Axis::new(-3, 4).unit());
    tell(&Toi::from_raw(1 << 28).unwrap());
    tell(&Ratio::percent(75).unwrap());

    let aabb = Aabb::new(Vec2::from_ints(-2, 3), Vec2::from_ints(10, 11)).unwrap();
    let circle = Circle::new(Vec2::from_ints(11, 7), Fx::lit("2.5")).unwrap();
    let wall = Segment::new(Vec2::from_ints(40, 0), Vec2::from_ints(40, 20)).unwrap();
    tell(&aabb);
    tell(&circle);
    tell(&wall);
    tell(&Capsule::new(Vec2::from_ints(0, 1), Vec2::from_ints(0, 4), Fx::lit("1.5")).unwrap());
    tell(&OrientedBox::new(Vec2::from_ints(1, 2), Vec2::from_ints(10, 5), Axis::new(3, 4)).unwrap());
    let corners = [Vec2::from_ints(0, 0), Vec2::from_ints(4, 0), Vec2::from_ints(0, 4)];
    tell(&ConvexPolygon::<4>::new(&corners).unwrap());
    let error: PolygonError = ConvexPolygon::<4>::new(&corners[..2]).unwrap_err();
    tell(&error);
    let parts = ConvexParts::<4, 2>::of(&corners).unwrap();
    tell(&parts);
    let error: PartsError = ConvexParts::<4, 2>::of(&corners[..2]).unwrap_err();
    tell(&error);
    tell(&AnyShape::<4>::from(circle));
    tell(&Compound::<Circle, 1>::new(&[circle]).unwrap());
    let error: CompoundError = Compound::<Circle, 1>::new(&[]).unwrap_err();
    tell(&error);
    tell(&circle.contact(&aabb).unwrap());
    let resting = aabb.manifold(&circle).unwrap();
    tell(&resting);
    tell(resting.deepest());
    tell(&Part::Corner(3));
    tell(&Separation::default());
    tell(&Inside::Ignore);
    tell(&circle.cast_shape(&wall, Vec2::from_ints(53, 0), Inside::Hit).unwrap().unwrap());
    tell(&circle.cast_moving(Vec2::from_ints(40, 0), &wall, Vec2::from_ints(-13, 0), Inside::Hit).unwrap().unwrap());

    tell(&Quantity::Radius);
    let error: RangeError = Circle::new(Vec2::ZERO, Fx::NEG_ONE).unwrap_err();
    tell(&error);
    tell(&Truncated { seen: 9, kept: 4 });
    tell(&LayerMask::layer(3));
    tell(&Filter::new(LayerMask::layer(0), LayerMask::ALL).with_group(-2).with_sensor(true));
}
