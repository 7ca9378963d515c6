//! Shapes of any kind and compounds: the answers of what is inside of them.

use tilesat::prelude::*;
use tilesat::shape::{AnyShape, Compound, CompoundError, ConvexParts};
use tilesat::{
    Aabb, CastHit, Circle, Contact, ConvexPolygon, Fx, Inside, Vec2, fx,
    query::{Manifold, Separation},
};
use tilesat_judge::cases;
use tilesat_judge::convex::ask;
use tilesat_judge::convex::generate::{CLASSES, Class, Pairs};
use tilesat_judge::convex::shape::{KINDS, Kind, MOST, Shape, pairs};
use tilesat_judge::oracle::kernel::{aabb, circle, point, segment, vec2};

type Any = AnyShape<MOST>;

fn any(shape: &Shape) -> Any {
    match *shape {
        Shape::Aabb { min, max } => aabb(min, max).into(),
        Shape::Circle { centre, radius } => circle(centre, radius).into(),
        Shape::Segment { a, b } => segment(a, b).into(),
        Shape::Capsule { a, b, radius } => ask::capsule(a, b, radius).into(),
        Shape::Turned { centre, half, direction, radius } => ask::turned(centre, half, direction, radius).into(),
        Shape::Polygon { points, count, radius } => ask::polygon(&points[..count], radius).into(),
    }
}

fn told(contact: &Contact) -> (tilesat::Axis, Fx, Vec2, Vec2, Vec2) {
    (contact.axis(), contact.depth(), contact.push_out(), contact.point_on_a(), contact.point_on_b())
}

fn cast(a: &Any, b: &Any, d: Vec2) -> (Option<CastHit>, bool, Option<tilesat::Toi>) {
    (
        a.cast_shape(b, d, Inside::Hit).unwrap(),
        a.would_hit(b, d, Inside::Hit).unwrap(),
        a.exact_toi(b, d, Inside::Hit).unwrap(),
    )
}

fn agree(a: &Shape, b: &Shape, d: (i64, i64), plain: bool) {
    let (x, y) = (any(a), any(b));
    let case = || format!("{a:?} {b:?} by {d:?}");
    assert_eq!(x.overlaps(&y), ask::overlaps(a, b), "{}", case());
    assert_eq!(x.overlaps_from(&y, &mut Separation::default()), ask::overlaps(a, b), "{}", case());
    assert_eq!(x.touches(&y), ask::touches(a, b), "{}", case());
    assert_eq!(x.contains(&y), ask::contains(a, b), "{}", case());
    assert_eq!(i64::from(x.distance(&y).to_bits()), ask::distance(a, b), "{}", case());
    let (one, other) = (x.contact(&y), ask::contact(a, b));
    assert_eq!(one.is_some(), other.is_some(), "{}", case());
    if let (Some(one), Some(other)) = (one, other) {
        assert_eq!(one.depth(), other.depth(), "{}", case());
        if !plain || !(one.is_degenerate() || other.is_degenerate()) {
            assert_eq!(one.axis().unit(), other.axis().unit(), "{}", case());
        }
    }
    let motion = vec2(d);
    let found = cast(&x, &y, motion);
    let wanted = ask::cast(a, b, d, Inside::Hit).unwrap();
    assert_eq!((found.1, found.2), (wanted.yes, wanted.exact), "{}", case());
    assert_eq!(found.0.is_some(), wanted.hit.is_some(), "{}", case());
    if !plain {
        assert_eq!(one.as_ref().map(told), other.as_ref().map(told), "{}", case());
        assert_eq!(found.0, wanted.hit, "{}", case());
        assert_eq!(x.manifold(&y), ask::manifold(a, b), "{}", case());
        let points = x.closest_points(&y).map(|(p, q)| (point(p), point(q)));
        assert_eq!(points, ask::closest_points(a, b), "{}", case());
        for p in [motion, vec2(b.vertices()[0])] {
            let about = (x.contains(&p), i64::from(x.distance(&p).to_bits()), point(x.closest_point(p)));
            assert_eq!(about, ask::about_point(a, point(p)), "{}", case());
        }
    }
}

#[test]
fn a_shape_of_any_kind_is_the_shape_inside() {
    let mut all: Vec<(Kind, Kind)> = pairs().collect();
    all.extend((0..3).flat_map(|i| (0..=i).map(move |j| (KINDS[i], KINDS[j]))));
    for pair in all {
        let is_plain = |kind: Kind| matches!(kind, Kind::Aabb | Kind::Circle | Kind::Segment);
        for class in CLASSES {
            let mut stream = Pairs::new(pair, class, 0xa11);
            for _ in 0..cases(300) {
                let (a, b) = stream.next();
                let size = [8, 1 << 12, 1 << 22][stream.random.below(3) as usize];
                let d = (stream.random.around(size), stream.random.around(size));
                agree(&a, &b, d, is_plain(pair.0) && is_plain(pair.1));
                agree(&b, &a, d, is_plain(pair.0) && is_plain(pair.1));
            }
        }
    }
}

type Group = Compound<Any, 3>;

/// A compound answers as its parts, in either order of them and of the arguments, moved and not.
#[test]
fn a_compound_is_its_parts() {
    let mut counts = [0u64; 3];
    for (k, class) in CLASSES.into_iter().cycle().take(36).enumerate() {
        let mut streams =
            [0, 1, 2].map(|i| Pairs::new((KINDS[(k + i) % 6], KINDS[(k + 2 * i + 1) % 6]), class, i as u64));
        for _ in 0..cases(300) {
            let [(a, x), (b, _), (c, _)] = streams.each_mut().map(Pairs::next);
            let size = [8, 1 << 12, 1 << 22][streams[0].random.below(3) as usize];
            let d = vec2((streams[0].random.around(size), streams[0].random.around(size)));
            let parts = [any(&a), any(&b), any(&c)];
            let x = any(&x);
            let group = Group::new(&parts).unwrap();
            let case = || format!("{parts:?} {x:?} by {d:?}");
            let turned = Group::new(&[parts[2], parts[0], parts[1]]).unwrap();
            counts[usize::from(group.overlaps(&x)) + usize::from(group.touches(&x))] += 1;
            for g in [group, turned] {
                assert_eq!(g.overlaps(&x), parts.iter().any(|p| p.overlaps(&x)), "{}", case());
                assert_eq!(x.overlaps(&g), g.overlaps(&x), "{}", case());
                assert_eq!(g.touches(&x), parts.iter().any(|p| p.touches(&x)), "{}", case());
                assert_eq!(x.touches(&g), g.touches(&x), "{}", case());
                assert_eq!(x.contains(&g), parts.iter().all(|p| x.contains(p)), "{}", case());
                assert_eq!(g.distance(&x), parts.iter().map(|p| p.distance(&x)).min().unwrap(), "{}", case());
                assert_eq!(x.distance(&g), g.distance(&x), "{}", case());
                let depth = parts.iter().filter_map(|p| p.contact(&x)).map(|c| c.depth()).max();
                assert_eq!(g.contact(&x).map(|c| c.depth()), depth, "{}", case());
                assert_eq!(x.contact(&g).map(|c| c.depth()), depth, "{}", case());
                assert_eq!(g.manifold(&x).map(|m| m.deepest().contact.depth()), depth, "{}", case());
                assert_eq!(x.manifold(&g).map(|m| m.deepest().contact.depth()), depth, "{}", case());
                assert_eq!(g.closest_points(&x).is_none(), g.touches(&x), "{}", case());
                let inside = g.overlaps(&x);
                let toi = parts.iter().filter_map(|p| p.exact_toi(&x, d, Inside::Hit).unwrap()).min();
                assert_eq!(g.exact_toi(&x, d, Inside::Hit).unwrap(), toi, "{}", case());
                let back = x.exact_toi(&g, -d, Inside::Hit).unwrap();
                assert_eq!(back, toi, "{}", case());
                let hit = g.cast_shape(&x, d, Inside::Ignore).unwrap();
                assert!(!inside || hit.is_none(), "{}", case());
            }
            assert_eq!(group.contact(&x).as_ref().map(told), turned.contact(&x).as_ref().map(told), "{}", case());
            assert_eq!(group.cast_shape(&x, d, Inside::Hit), turned.cast_shape(&x, d, Inside::Hit), "{}", case());
            assert_eq!(group.closest_points(&x), turned.closest_points(&x), "{}", case());
            // Both sides may be compounds.
            let two = Compound::<Any, 2>::new(&[x, parts[0]]).unwrap();
            assert_eq!(group.overlaps(&two), two.parts().iter().any(|p| group.overlaps(p)), "{}", case());
            assert_eq!(group.distance(&two), two.parts().iter().map(|p| group.distance(p)).min().unwrap());
        }
    }
    println!("{counts:?}");
    assert!(counts.iter().all(|n| *n > 300), "{counts:?}");
}

#[test]
fn compounds_are_checked() {
    let ball = Circle::new(Vec2::ZERO, fx!(1)).unwrap();
    assert_eq!(Compound::<Circle, 2>::new(&[]), Err(CompoundError::Empty));
    assert_eq!(Compound::<Circle, 2>::new(&[ball; 3]), Err(CompoundError::TooMany { capacity: 2 }));
    let two = Compound::<Circle, 4>::new(&[ball, ball.translated(Vec2::from_ints(5, 0)).unwrap()]).unwrap();
    assert_eq!(two.aabb(), Aabb::new(Vec2::from_ints(-1, -1), Vec2::from_ints(6, 1)).unwrap());
    assert_eq!(two.parts().len(), 2);
    let moved = two.translated(Vec2::from_ints(1, 2)).unwrap();
    assert_eq!(moved.parts()[1].centre(), Vec2::from_ints(6, 2));
    assert!(two.translated(Vec2::from_ints(8187, 0)).is_err());
    assert!(moved.contains(&Vec2::from_ints(6, 2)) && !moved.contains(&Vec2::from_ints(3, 2)));
    let hit = two.cast_ray(Vec2::from_ints(3, 0), Vec2::from_ints(9, 0), Inside::Hit).unwrap().unwrap();
    assert_eq!(hit.axis, tilesat::Axis::NEG_X);
    assert!(hit.displacement.x > fx!(0.9) && hit.displacement.x <= 1);
    let l = [(0, 0), (30, 0), (30, 10), (10, 10), (10, 30), (0, 30)].map(Vec2::from);
    let parts = ConvexParts::<4, 4>::of(&l).unwrap();
    let l = Compound::try_from(parts).unwrap();
    let (wide, ball) = (ConvexPolygon::<4>::hull(&[(0, 0), (30, 0), (0, 30)].map(Vec2::from)).unwrap(), |x, y, r| {
        Circle::new(Vec2::from_ints(x, y), Fx::from_num(r)).unwrap()
    });
    assert!(wide.overlaps(&ball(13, 13, 2)) && !l.overlaps(&ball(13, 13, 2)) && l.overlaps(&ball(13, 13, 4)));
    let _: (Option<Manifold>, Class) = (l.manifold(&ball(13, 13, 4)), Class::Near);
}
