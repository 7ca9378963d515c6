//! A placed level equals the level that is built at that position, bit for bit.

use tilesat::{
    AllShapes, Axis, Body, Circle, Fx, Grid, Inside, Joined, MoveError, Moved, Mover, Outside, Path, PathKind, RayHit,
    SegmentMap, Side, Solid, Solids, TileKind, TileKinds, TileMap, TileShape, Vec2, World,
    motion::Work,
    world::{Placed, RayRules},
};
use tilesat_judge::solids::twins::translated;
use tilesat_judge::solids::{P, disc, rect, solid, vec2};
use tilesat_judge::{Random, cases};

static KINDS: TileKinds = TileKinds::EMPTY
    .with(1, TileKind::FULL)
    .with(2, TileKind::of(TileShape::SlopeBottomRight))
    .with(3, TileKind::of(TileShape::ConcaveBottomLeft))
    .with(4, TileKind::of(TileShape::ConvexTopLeft))
    .with(5, TileKind::ONE_WAY_UP);
const SIDE: i64 = 6;
const CELL: i64 = 1 << 10;
const RULES: [RayRules; 2] =
    [RayRules { inside: Inside::Ignore, one_way: true }, RayRules { inside: Inside::Hit, one_way: false }];

/// A place: near, or as far as the domain and the offset allow, on any side.
fn offset(random: &mut Random, reach: i64) -> P {
    let far = [(1 << 28) - 1, (1 << 28) - 1 - random.below(9 * CELL), random.below(reach), 0][random.below(4) as usize];
    (random.sign() * far, random.sign() * random.below(1 << 28))
}

fn check<A: World, B: World>(placed: &A, built: &B, at: P, random: &mut Random) {
    let mover = Mover::platformer(Axis::NEG_Y);
    for _ in 0..8 {
        let spot = |random: &mut Random, o: i64| {
            o + random.within(-1, SIDE + 1) * CELL + random.below(2) * random.around(CELL)
        };
        let p = (spot(random, at.0), spot(random, at.1));
        let v = vec2((random.around(4 * CELL), random.around(4 * CELL)));
        let (w, h) = (random.below(2 * CELL), random.below(2 * CELL));
        let (body, ball) = (rect(p, (p.0 + w, p.1 + h)), disc(p, w / 2));
        assert_eq!(placed.overlaps_aabb(&body), built.overlaps_aabb(&body));
        assert_eq!(placed.overlaps_circle(&ball), built.overlaps_circle(&ball));
        assert_eq!(placed.touches_aabb(&body), built.touches_aabb(&body));
        assert_eq!(placed.touches_circle(&ball), built.touches_circle(&ball));
        let (a, b): (Vec<_>, Vec<_>) = (placed.features(&body).collect(), built.features(&body).collect());
        assert_eq!(a, b);
        both(&mover, placed, built, &body, v);
        both(&mover, placed, built, &ball, v);
    }
}

fn both<A: World, B: World, C: Body + PartialEq + std::fmt::Debug>(
    m: &Mover,
    placed: &A,
    built: &B,
    body: &C,
    v: Vec2,
) {
    // A placed level may be solid beyond its domain. So the test checks its ends only where a built
    // one's are certain. Full cells that a map knows are met by their features.
    let seen = |moved: Result<Moved<C>, MoveError>| {
        moved.map(|moved| Moved { work: Work { checks: 0, features: 0, ..moved.work }, ..moved })
    };
    assert_eq!(seen(m.move_and_slide(placed, body, v)), seen(m.move_and_slide(built, body, v)), "{body:?} {v:?}");
}

/// Rays near both levels agree hit by hit. The levels' rays are separate methods.
macro_rules! rays {
    ($placed:expr, $built:expr, $at:expr, $random:expr) => {
        for rules in RULES {
            let (placed, built) = (&$placed, &$built);
            let spot = |random: &mut Random, o: i64| {
                o + random.within(-1, SIDE + 1) * CELL + random.below(2) * random.around(CELL)
            };
            let p = (spot(&mut $random, $at.0), spot(&mut $random, $at.1));
            let (o, v) = (vec2(p), vec2(($random.around(6 * CELL), $random.around(6 * CELL))));
            let a: Vec<RayHit> = placed.cast_ray_all(o, v, rules).unwrap().collect();
            let b: Vec<RayHit> = built.cast_ray_all(o, v, rules).unwrap().collect();
            assert_eq!(a, b, "{o:?} {v:?}");
            assert_eq!(placed.cast_ray(o, v, rules).unwrap(), a.first().copied());
            assert_eq!(placed.line_of_sight(o, o + v), built.line_of_sight(o, o + v));
        }
    };
}

#[test]
fn placed_levels_are_the_levels_built_there() {
    let mut random = Random::new(95);
    for _ in 0..cases(2_000) {
        let by = offset(&mut random, 90 * CELL);
        // Where the level itself is: with the offset it stays inside the domain.
        let home = (-by.0.signum() * random.below(1 << 27), random.around(1 << 20));
        let tiles: Vec<u8> = (0..SIDE * SIDE).map(|_| random.below(8) as u8 % 6).collect();
        let grid = |o: P| Grid::new(SIDE as u16, SIDE as u16, Fx::from_bits(CELL as i32), vec2(o)).unwrap();
        let (at, there) = (home, (home.0 + by.0, home.1 + by.1));
        let map = TileMap::<AllShapes>::of(&tiles, grid(at), &KINDS).unwrap();
        let built = TileMap::<AllShapes>::of(&tiles, grid(there), &KINDS).unwrap();
        let placed = Placed::new(&map, vec2(by)).unwrap();
        check(&placed, &built, there, &mut random);
        rays!(placed, built, there, random);

        let boxes: Vec<Solid> = (0..3)
            .map(|key| {
                let at = (random.below(5) * CELL, random.below(5) * CELL);
                let one = solid(at, (at.0 + random.within(1, 2) * CELL, at.1 + CELL), key);
                if random.one_in(3) { one.with_one_way(Side::Up) } else { one }
            })
            .collect();
        let at_home = |o: P| boxes.iter().map(|s| translated(s, o)).collect::<Vec<_>>();
        let (a, b) = (at_home(at), at_home(there));
        let (lists_here, lists_there) = (Solids::new(&a), Solids::new(&b));
        let lists = Placed::new(&lists_here, vec2(by)).unwrap();
        rays!(lists, lists_there, there, random);
        rays!(Joined::new(&lists, &placed), Joined::new(&lists_there, &built), there, random);

        let corners: Vec<P> = (0..3).map(|_| (random.below(SIDE * CELL), random.below(SIDE * CELL))).collect();
        let points = |o: P| corners.iter().map(|c| vec2((c.0 + o.0, c.1 + o.1))).collect::<Vec<_>>();
        let bytes = |o: P| {
            let points = points(o);
            let paths = [Path::new(PathKind::Solid, &points)];
            let mut bytes = vec![0; SegmentMap::measure(&paths, Fx::from_bits(2000)).ok()?.bytes()];
            SegmentMap::build_into(&paths, Fx::from_bits(2000), &mut bytes).ok()?;
            Some(bytes)
        };
        let (Some(a), Some(b)) = (bytes(at), bytes(there)) else { continue };
        let (a, b) = (SegmentMap::from_bytes(&a).unwrap(), SegmentMap::from_bytes(&b).unwrap());
        let moved = Placed::new(&a, vec2(by)).unwrap();
        // A polygon that moves in the level.
        check(&Joined::new(&built, &moved), &Joined::new(&built, &b), there, &mut random);
        check(&Joined::new(&moved, &placed), &Joined::new(&b, &built), there, &mut random);
        rays!(moved, b, there, random);
        rays!(Joined::new(&moved, &lists), Joined::new(&b, &lists_there), there, random);
    }
}

#[test]
fn an_offset_is_checked() {
    let map = TileMap::<AllShapes>::of(&[1], Grid::new(1, 1, Fx::from_num(16), Vec2::ZERO).unwrap(), &KINDS).unwrap();
    assert!(Placed::new(&map, vec2((1 << 28, 0))).is_err() && Placed::new(&map, vec2((0, -(1 << 28)))).is_err());
    let placed = Placed::new(&map, vec2(((1 << 28) - 1, 5))).unwrap();
    assert_eq!((placed.offset(), placed.world().width()), (vec2(((1 << 28) - 1, 5)), 1));
    // Rays reach as far as the level's own domain, relative to it.
    let (seen, beyond) = (vec2(((1 << 28) - (1 << 29), 9)), vec2(((1 << 28) - (1 << 29) - 1, 9)));
    assert!(placed.cast_ray(seen, Vec2::ZERO, Inside::Hit).is_ok());
    assert!(placed.cast_ray(beyond, Vec2::ZERO, Inside::Hit).is_err());
    // From the other end of the domain, relative to the level far outside it, a body flies as far
    // as it may.
    let end = (1 << 29) - 2000;
    for (sx, sy) in [(1, 1), (1, -1), (-1, 1), (-1, -1)] {
        let placed = Placed::new(&map, vec2((-sx * ((1 << 28) - 1), -sy * ((1 << 28) - 1)))).unwrap();
        let (p, v) = ((sx * end, sy * end), vec2((-sx * ((1 << 28) - 1), -sy * ((1 << 28) - 2))));
        let moved = Mover::new().move_and_slide(&placed, &disc(p, 1000), v).unwrap();
        assert_eq!(moved.position(), vec2(p) + v);
        let moved = Mover::new().move_and_slide(&placed, &rect((p.0 - 9, p.1 - 9), (p.0 + 9, p.1 + 9)), v).unwrap();
        assert_eq!(moved.position(), vec2((p.0 - 9, p.1 - 9)) + v);
    }
}

/// Beyond the level's own domain, nothing that the level calls solid counts as free.
#[test]
fn beyond_its_own_domain() {
    static FULL: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
    let map = TileMap::from_ascii("    \n    ", &FULL).unwrap().with_outside(Outside::Solid);
    for side in [1, -1] {
        let level = Placed::new(&map, Vec2::from_ints(-100 * side, 0)).unwrap();
        let from = Circle::new(Vec2::from_ints(8100 * side, 5), Fx::ONE).unwrap();
        assert!(!level.overlaps(&from));
        for (x, y) in [(-8, 1), (-300, 2), (-8, 0), (3, 7)] {
            let moved = Mover::new().move_and_slide(&level, &from, Vec2::from_ints(x * side, y)).unwrap();
            assert!(!level.overlaps(&moved.body), "{side} {x} {y}");
        }
    }
}
