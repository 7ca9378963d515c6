//! The flags of solids that a box, a circle or a point touches, by the exact sum of two shapes.

use tilesat::scene::Shape;
use tilesat::world::{ConvexSolid, ConvexSolids, Placed, Probe};
use tilesat::{Fx, Grid, Joined, Side, Solid, Solids, TileKind, TileKinds, TileMap, Vec2, World};
use tilesat_judge::casts::judge::Forbidden;
use tilesat_judge::convex::shape::hull;
use tilesat_judge::oracle::int256::Int256;
use tilesat_judge::solids::shapes::{self, Any, Figure};
use tilesat_judge::solids::{P, disc, raw, rect, vec2};
use tilesat_judge::{Random, cases};

static KINDS: TileKinds = TileKinds::EMPTY.with(b'~', TileKind::EMPTY.with_flags(1 << 7));

fn touch(a: &Any, b: &Any) -> bool {
    let (a, b) = (Figure::of(a), Figure::of(b));
    let all: Vec<P> = a.points.iter().flat_map(|p| b.points.iter().map(|q| (q.0 - p.0, q.1 - p.1))).collect();
    Forbidden { hull: hull(&all), radius: a.radius + b.radius }.touched::<Int256>((0, 0), 0)
}

fn generic(level: &impl World, body: &impl Probe) -> u8 {
    level.flags_touched(body)
}

/// By the methods, and as the levels of generic code.
fn check<B: Probe>(boxes: &[Solid], convex: &[ConvexSolid<Any>], body: &B, as_any: &Any, at: P) -> u8 {
    let flags = |all: &mut dyn Iterator<Item = (Any, u8)>| {
        all.filter(|(solid, _)| touch(as_any, solid)).fold(0, |all, (_, flags)| all | flags)
    };
    let of_boxes = flags(&mut boxes.iter().map(|solid| (solid.shape().into(), solid.flags())));
    let of_convex = flags(&mut convex.iter().map(|solid| (solid.shape(), solid.flags())));
    let (boxes, convex) = (Solids::new(boxes), ConvexSolids::new(convex));
    assert_eq!(boxes.flags_touched(body), of_boxes, "{as_any:?}");
    assert_eq!(convex.flags_touched(body), of_convex, "{as_any:?}");
    // A cell of water beside the origin.
    let map = TileMap::on_grid(b"~", Grid::new(1, 1, Fx::from_bits(1 << 12), vec2(at)).unwrap(), &KINDS).unwrap();
    let cell: Any = rect(at, (at.0 + (1 << 12), at.1 + (1 << 12))).into();
    let of_map = if touch(as_any, &cell) { 1 << 7 } else { 0 };
    assert_eq!(map.flags_touched(body), of_map);
    let joined = Joined::new(&boxes, &convex);
    let all = Joined::new(&joined, &map);
    assert_eq!(all.flags_touched(body), of_boxes | of_convex | of_map);
    assert_eq!(generic(&all, body), all.flags_touched(body));
    // The same level, made elsewhere and placed here.
    let offset = Vec2::from_raw(-777, 4321);
    let water = TileMap::on_grid(b"~", Grid::new(1, 1, Fx::from_bits(1 << 12), vec2(at) - offset).unwrap(), &KINDS);
    let water = water.unwrap();
    assert_eq!(Placed::new(&water, offset).unwrap().flags_touched(body), of_map);
    of_boxes | of_convex | of_map
}

#[test]
fn flags_of_touched_solids() {
    let (mut r, mut found, mut none) = (Random::new(4), 0, 0);
    for _ in 0..cases(1500) {
        let coordinate = |r: &mut Random| r.around(6) << 11;
        let at = (coordinate(&mut r), coordinate(&mut r));
        let boxes: Vec<_> = (0..3)
            .map(|key| {
                let p = (coordinate(&mut r), coordinate(&mut r));
                let q = (p.0 + (r.within(1, 4) << 11), p.1 + (r.within(1, 4) << 11));
                let solid = Solid::new(rect(p, q), key).unwrap().with_flags(1 << key);
                if r.one_in(3) { solid.with_one_way(Side::Up) } else { solid }
            })
            .collect();
        let convex: Vec<_> =
            (3..6).map(|key| ConvexSolid::new(shapes::shape(&mut r), key).unwrap().with_flags(1 << key)).collect();
        let p = (coordinate(&mut r) + r.around(1), coordinate(&mut r));
        let (block, ball) = (rect(p, (p.0 + (r.below(3) << 11), p.1 + 2048)), disc(p, r.below(3) << 11));
        let flags = [
            check(&boxes, &convex, &block, &block.into(), at),
            check(&boxes, &convex, &ball, &ball.into(), at),
            check(&boxes, &convex, &vec2(p), &disc(p, 0).into(), at),
            check(&boxes, &convex, &Shape::from(ball), &ball.into(), at),
            check(&boxes, &convex, &Shape::from(block), &block.into(), at),
        ];
        assert_eq!((flags[1], flags[0]), (flags[3], flags[4]));
        found += flags.iter().filter(|flags| flags.count_ones() > 1).count();
        none += usize::from(flags[0] == 0);
        // Placed at the limit of offsets: the level is seen from outside of its own domain.
        let far = vec2((1 - (1 << 28), (1 << 28) - 1));
        let solids = ConvexSolids::new(&convex);
        let moved = Placed::new(&solids, far).unwrap();
        let there = |p: Vec2| vec2((raw(p).0 + raw(far).0, raw(p).1 + raw(far).1));
        let ball_there = tilesat::Circle::new(there(ball.centre()), ball.radius()).unwrap();
        assert_eq!(moved.flags_touched(&ball_there), solids.flags_touched(&ball));
        assert_eq!(moved.flags_touched(&there(vec2(p))), solids.flags_touched(&vec2(p)));
    }
    assert!(found > 100 && none > 100, "{found} {none}");
}
