//! Bodies cast through polygons, walls and one-way chains, alone and joined to tiles. They agree
//! with the mover, and the way up to the hit is free. Without a hit the whole way is free.
//!
//! `TILESAT_CASES` sets the number of casts (default 6 000).

use tilesat::{
    Joined, Path, PathKind, RangeError, SegmentMap, TileKind, TileKinds, TileMap, Vec2, World,
    motion::BodyHit,
    world::{Placed, RayRules},
};
use tilesat_judge::levels_cast::{P, PASSED, SEEN, as_the_mover, disc, raw, rect};
use tilesat_judge::{Random, cases};

const fn at(x: i16, y: i16) -> Vec2 {
    Vec2::from_ints(x, y)
}

const HILL: [Vec2; 5] = [at(0, 90), at(30, 60), at(50, 70), at(70, 40), at(100, 90)];
const SPIKE: [Vec2; 3] = [at(110, 20), at(118, 20), at(114, 80)];
const WALL: [Vec2; 3] = [at(20, 20), at(40, 35), at(60, 10)];
const LEDGE: [Vec2; 2] = [at(100, 50), at(80, 55)];

static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL).with(b'-', TileKind::ONE_WAY_UP);

/// The calls that every level has.
trait Castable: World {
    fn cast<B: tilesat::Body>(&self, b: &B, d: Vec2, rules: RayRules) -> Result<Option<BodyHit<B>>, RangeError>;
}

impl Castable for SegmentMap<'_> {
    fn cast<B: tilesat::Body>(&self, b: &B, d: Vec2, rules: RayRules) -> Result<Option<BodyHit<B>>, RangeError> {
        self.cast_shape(b, d, rules)
    }
}

impl<A: World, C: World> Castable for Joined<'_, A, C> {
    fn cast<B: tilesat::Body>(&self, b: &B, d: Vec2, rules: RayRules) -> Result<Option<BodyHit<B>>, RangeError> {
        self.cast_shape(b, d, rules)
    }
}

impl<W: World> Castable for Placed<'_, W> {
    fn cast<B: tilesat::Body>(&self, b: &B, d: Vec2, rules: RayRules) -> Result<Option<BodyHit<B>>, RangeError> {
        self.cast_shape(b, d, rules)
    }
}

fn check<W: Castable, B: tilesat::Body + PartialEq + core::fmt::Debug>(
    world: &W,
    body: &B,
    d: P,
    moved: impl Fn(P) -> B,
    overlaps: impl Fn(&B) -> bool,
) -> bool {
    let found = world.cast(body, raw(d), SEEN).unwrap();
    as_the_mover(world, body, raw(d), found.as_ref());
    let solid = world.cast(body, raw(d), PASSED).unwrap();
    assert!(solid.is_none_or(|f| !f.hit.one_way && f.hit.toi >= found.unwrap().hit.toi), "{body:?} by {d:?}");
    // Sixteenths are points of the lattice.
    let until = solid.map_or(1 << 30, |f| f.hit.toi.raw());
    for k in (0..=16).filter(|k| k << 26 <= until) {
        let there = moved((d.0 / 16 * i64::from(k), d.1 / 16 * i64::from(k)));
        assert!(!overlaps(&there), "{k} sixteenths of the way: {body:?} by {d:?}");
    }
    assert!(found.is_none_or(|f| !overlaps(&f.body)), "ends inside: {body:?} by {d:?}");
    found.is_some()
}

fn run<W: Castable>(world: &W, seed: u64) {
    let r = &mut Random::new(seed);
    let px = |n: i64| n << 16;
    let (mut done, mut hits) = (0, 0);
    while done < cases(6_000) / 3 {
        let p = (r.within(px(-20), px(140)), r.within(px(-10), px(110)));
        let d = (r.around(px(160)) / 16 * 16, r.around(px(160)) / 16 * 16);
        let size = r.within(0, px(14));
        let hit = if r.one_in(2) {
            let body = |by: P| disc((p.0 + by.0, p.1 + by.1), size / 2);
            let overlaps = |b: &tilesat::Circle| world.overlaps_circle(b);
            if overlaps(&body((0, 0))) {
                continue;
            }
            check(world, &body((0, 0)), d, body, overlaps)
        } else {
            let body = |by: P| rect((p.0 + by.0, p.1 + by.1), (p.0 + by.0 + size, p.1 + by.1 + px(9)));
            let overlaps = |b: &tilesat::Aabb| world.overlaps_aabb(b);
            if overlaps(&body((0, 0))) {
                continue;
            }
            check(world, &body((0, 0)), d, body, overlaps)
        };
        done += 1;
        hits += u64::from(hit);
    }
    assert!(hits > done / 4, "{hits} of {done}");
}

#[test]
fn segments_alone_and_joined() {
    let paths = [
        Path::new(PathKind::Solid, &HILL),
        Path::new(PathKind::Solid, &SPIKE),
        Path::new(PathKind::Wall, &WALL),
        Path::new(PathKind::OneWay, &LEDGE),
    ];
    let mut bytes = heapless::Vec::<u8, 4096>::new();
    let map = SegmentMap::build_vec(&paths, tilesat::Fx::lit("16"), &mut bytes).unwrap();
    run(&map, 1);
    let tiles = TileMap::from_ascii("........\n#.......\n......#.\n...--...\n........\n########\n", &KINDS).unwrap();
    run(&Joined::new(&tiles, &map), 2);
    run(&Placed::new(&map, at(-3, 5)).unwrap(), 3);
}
