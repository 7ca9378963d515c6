//! Two tile maps as one level, against the raster of their union: the remaining faces and corners,
//! and the ends of bodies.

use std::collections::BTreeSet;
use tilesat::{
    Aabb, Axis, Circle, Fx, Grid, Inside, Joined, Mover, Outside, TileKind, TileKinds, TileMap, Vec2, World,
    world::{Feature, Geometry},
};
use tilesat_judge::{Random, cases};

type Point = (i64, i64);

static KINDS: TileKinds = TileKinds::EMPTY.with(1, TileKind::FULL);

/// A map whose cells are squares of `side` units of the raster, its first corner at `at` units.
#[derive(Clone, Debug)]
struct Part {
    at: Point,
    side: i64,
    size: Point,
    outside: Outside,
    tiles: Vec<u8>,
}

/// Both maps, the raw length of a unit and the position of the raster's origin.
#[derive(Clone, Debug)]
struct Scene {
    parts: [Part; 2],
    unit: i64,
    origin: Point,
}

/// The raster covers all maps of a scene and some units around them.
const WINDOW: std::ops::Range<i64> = -8..24;

impl Part {
    fn random(random: &mut Random, outside: Outside) -> Self {
        let side = random.within(1, 3);
        let size = (random.within(1, 4), random.within(1, 4));
        let at = (random.within(0, 6), random.within(0, 6));
        let density = random.within(2, 9);
        let tiles = (0..size.0 * size.1).map(|_| u8::from(random.below(10) < density)).collect();
        Self { at, side, size, outside, tiles }
    }

    fn map(&self, scene: &Scene) -> TileMap<'_> {
        let origin = scene.raw(self.at);
        let cell = Fx::from_bits((self.side * scene.unit) as i32);
        let grid = Grid::new(self.size.0 as u16, self.size.1 as u16, cell, vec2(origin)).unwrap();
        TileMap::on_grid(&self.tiles, grid, &KINDS).unwrap().with_outside(self.outside)
    }

    /// Whether a unit square is solid.
    fn full(&self, (x, y): Point) -> bool {
        let (c, r) = ((x - self.at.0).div_euclid(self.side), (y - self.at.1).div_euclid(self.side));
        let inside = (0..self.size.0).contains(&c) && (0..self.size.1).contains(&r);
        match self.outside {
            Outside::Empty if !inside => false,
            Outside::Solid if !inside => true,
            _ => self.tiles[(r.clamp(0, self.size.1 - 1) * self.size.0 + c.clamp(0, self.size.0 - 1)) as usize] == 1,
        }
    }
}

fn vec2((x, y): Point) -> Vec2 {
    Vec2::from_raw(x as i32, y as i32)
}

fn point(v: Vec2) -> Point {
    let (x, y) = v.raw();
    (i64::from(x), i64::from(y))
}

fn dir(a: Axis) -> Point {
    (i64::from(a.x), i64::from(a.y))
}

fn add(a: Point, b: Point, k: i64) -> Point {
    (a.0 + k * b.0, a.1 + k * b.1)
}

fn everything() -> Aabb {
    let end = (1 << 29) - 1;
    Aabb::new(vec2((-end, -end)), vec2((end, end))).unwrap()
}

impl Scene {
    fn random(random: &mut Random) -> Self {
        // One of both may be a room, or continue for ever.
        let outside = [Outside::Empty, Outside::Empty, Outside::Solid, Outside::Edge][random.below(4) as usize];
        let mut parts = [Part::random(random, outside), Part::random(random, Outside::Empty)];
        if random.one_in(2) {
            parts.swap(0, 1);
        }
        let unit = [256, 258, 300, 1 << 16, 7 << 17][random.below(5) as usize];
        let far = (1i64 << 29) - 40 * unit;
        let origin = [(0, 0), (-far, far), (random.around(far), random.around(far))][random.below(3) as usize];
        Self { parts, unit, origin }
    }

    fn raw(&self, p: Point) -> Point {
        (self.origin.0 + p.0 * self.unit, self.origin.1 + p.1 * self.unit)
    }

    /// Its position on the raster, in units.
    fn units(&self, p: Point) -> Point {
        let of = |v: i64, o: i64| {
            assert_eq!((v - o).rem_euclid(self.unit), 0);
            (v - o) / self.unit
        };
        (of(p.0, self.origin.0), of(p.1, self.origin.1))
    }

    /// The one map of units.
    fn whole<'a>(&self, tiles: &'a [u8]) -> TileMap<'a> {
        let count = (WINDOW.end - WINDOW.start) as u16;
        let first = vec2(self.raw((WINDOW.start, WINDOW.start)));
        let grid = Grid::new(count, count, Fx::from_bits(self.unit as i32), first).unwrap();
        TileMap::on_grid(tiles, grid, &KINDS).unwrap()
    }

    /// The unit square of a point that lies toward `u` and `v`, two of the four directions along
    /// the axes.
    fn square(p: Point, u: Point, v: Point) -> Point {
        let (x, y) = (u.0 + v.0, u.1 + v.1);
        (if x < 0 { p.0 - 1 } else { p.0 }, if y < 0 { p.1 - 1 } else { p.1 })
    }

    /// The part of a map's feature that the other map leaves, from the raster.
    fn left(&self, f: &Feature, other: usize) -> Option<Feature> {
        let other = &self.parts[other];
        let full = |p: Point, u: Point, v: Point| other.full(Self::square(p, u, v));
        match f.geometry {
            Geometry::Face { a, dir: along, len, joined } => {
                let (along, len) = (dir(along), i64::from(len));
                let (out, back) = ((along.1, -along.0), (-along.0, -along.1));
                let steps = |raw: Point| {
                    let beyond = raw.0.abs().max(raw.1.abs()) == (1 << 29) - 1;
                    if beyond { None } else { Some(self.units(raw)) }
                };
                let (raw_a, raw_b) = (point(a), add(point(a), along, len));
                let (start, end) = (steps(raw_a), steps(raw_b));
                // A face that goes on for ever is bare far away.
                let bare = match (start, end) {
                    (Some(s), Some(_)) => (0..len / self.unit).any(|k| !full(add(s, along, k), along, out)),
                    _ => true,
                };
                let goes_on = |at: Option<Point>, ahead: Point, back: Point| {
                    let Some(p) = at else { return false };
                    let behind = (-out.0, -out.1);
                    !full(p, back, out) && (full(p, ahead, out) || full(p, ahead, behind))
                };
                let joined = [joined[0] || goes_on(start, back, along), joined[1] || goes_on(end, along, back)];
                let geometry =
                    Geometry::Face { a, dir: Axis::new(along.0 as i32, along.1 as i32), len: len as i32, joined };
                bare.then_some(Feature { geometry, ..*f })
            }
            Geometry::Vertex { p, e_in, e_out } => {
                let p = self.units(point(p));
                let (e_in, e_out) = (dir(e_in), dir(e_out));
                let back = (-e_in.0, -e_in.1);
                let own = full(p, back, e_out);
                let others =
                    full(p, e_in, e_out) || full(p, back, (-e_out.0, -e_out.1)) || full(p, e_in, (-e_out.0, -e_out.1));
                let first = f.source == 0;
                (!others && (first || !own)).then_some(*f)
            }
            _ => panic!("a feature that no block has"),
        }
    }
}

/// Comparable.
fn key(f: &Feature) -> String {
    format!("{f:?}")
}

/// Exactly the faces with a bare unit, exactly the corners of both together, and joints where the
/// solid continues.
#[test]
fn what_is_left_is_what_the_raster_shows() {
    let mut random = Random::new(31);
    let (mut hidden, mut kept) = (0u64, 0u64);
    for _ in 0..cases(15_000) {
        let scene = Scene::random(&mut random);
        let maps = [scene.parts[0].map(&scene), scene.parts[1].map(&scene)];
        let pair = Joined::new(&maps[0], &maps[1]);
        let mut expected = BTreeSet::new();
        for (source, map) in maps.iter().enumerate() {
            for f in map.features(&everything()) {
                let f = Feature { source: source as u8, ..f };
                match scene.left(&f, 1 - source) {
                    Some(f) => {
                        kept += 1;
                        assert!(expected.insert(key(&f)));
                    }
                    None => hidden += 1,
                }
            }
        }
        let got: Vec<_> = pair.features(&everything()).map(|f| key(&f)).collect();
        let set: BTreeSet<_> = got.iter().cloned().collect();
        let difference: Vec<_> = set.symmetric_difference(&expected).map(|f| (expected.contains(f), f)).collect();
        assert!(difference.is_empty() && got.len() == set.len(), "{scene:?}\n(expected, piece): {difference:#?}");
        // A region gives no other pieces than the whole.
        let a = (random.within(-2, 20), random.within(-2, 20));
        let b = add(a, (random.within(0, 6), random.within(0, 6)), 1);
        let region = Aabb::new(vec2(scene.raw(a)), vec2(scene.raw(b))).unwrap();
        assert!(pair.features(&region).all(|f| expected.contains(&key(&f))));
    }
    println!("{kept} pieces left, {hidden} hidden");
    assert!(hidden > kept / 20);
}

/// The union's tiles as one map of units.
fn union(scene: &Scene) -> Vec<u8> {
    let solid = |x: i64, y: i64| scene.parts.iter().any(|p| p.full((x, y)));
    WINDOW.flat_map(|y| WINDOW.map(move |x| u8::from(solid(x, y)))).collect()
}

fn same<B: tilesat::Body + std::fmt::Debug + PartialEq>(
    mover: &Mover,
    pair: &impl World,
    whole: &impl World,
    body: &B,
    v: Vec2,
    scene: &Scene,
) -> bool {
    let (got, expected) = (mover.move_and_slide(pair, body, v), mover.move_and_slide(whole, body, v));
    match (got, expected) {
        (Ok(got), Ok(expected)) => {
            let all = |m: &tilesat::Moved<B>| {
                let hits: Vec<_> = m.hits.iter().map(|h| (h.toi, h.axis)).collect();
                (m.position(), m.velocity, m.remaining, m.floor, m.wall, m.ceiling, hits)
            };
            assert_eq!(all(&got), all(&expected), "{scene:?}\n{body:?} by {v:?}");
            !got.hits.is_empty()
        }
        (got, expected) => {
            assert_eq!(got.err(), expected.err(), "{scene:?}\n{body:?} by {v:?}");
            false
        }
    }
}

/// Bodies go through both maps as through the one map of units, bit for bit.
#[test]
fn bodies_move_as_through_the_union() {
    let mut random = Random::new(32);
    let (mut hits, mut moves) = (0u64, 0u64);
    for _ in 0..cases(2_000) {
        let mut scene = Scene::random(&mut random);
        for part in &mut scene.parts {
            part.outside = Outside::Empty;
        }
        let maps = [scene.parts[0].map(&scene), scene.parts[1].map(&scene)];
        let pair = Joined::new(&maps[0], &maps[1]);
        let tiles = union(&scene);
        let whole = scene.whole(&tiles);
        for _ in 0..40 {
            let at = scene.raw((random.within(-1, 12), random.within(-1, 12)));
            let at = add(at, (random.around(2), random.around(2)), 1);
            let at =
                if random.one_in(2) { at } else { add(at, (random.below(scene.unit), random.below(scene.unit)), 1) };
            let speed = |random: &mut Random| match random.below(3) {
                0 => random.sign() * random.magnitude(scene.unit * 6),
                _ => random.around(scene.unit * 8),
            };
            let v = vec2((speed(&mut random), speed(&mut random)));
            let mover = Mover::platformer(Axis::NEG_Y);
            let extent = |random: &mut Random| match random.below(3) {
                0 => scene.unit * random.within(1, 2),
                1 => scene.unit / 2 + random.around(1),
                _ => random.within(1, 2 * scene.unit),
            };
            hits += u64::from(if random.one_in(2) {
                let (w, h) = (extent(&mut random), extent(&mut random));
                let body = Aabb::new(vec2(at), vec2(add(at, (w, h), 1))).unwrap();
                moves += u64::from(!whole.overlaps(&body));
                same(&mover, &pair, &whole, &body, v, &scene)
            } else {
                let body = Circle::new(vec2(at), Fx::from_bits(extent(&mut random) as i32)).unwrap();
                moves += u64::from(!whole.overlaps(&body));
                same(&mover, &pair, &whole, &body, v, &scene)
            });
        }
    }
    println!("{moves} moves, {hits} with hits");
    assert!(hits > moves / 8);
}

/// Rays see the same as in the one map of units, wherever they start.
#[test]
fn rays_see_the_union() {
    let mut random = Random::new(33);
    let (mut hits, mut done) = (0u64, 0u64);
    while done < cases(60_000) {
        let mut scene = Scene::random(&mut random);
        for part in &mut scene.parts {
            part.outside = Outside::Empty;
        }
        let maps = [scene.parts[0].map(&scene), scene.parts[1].map(&scene)];
        let pair = Joined::new(&maps[0], &maps[1]);
        let tiles = union(&scene);
        let whole = scene.whole(&tiles);
        for _ in 0..40 {
            let place = |random: &mut Random| {
                let p = scene.raw((random.within(-1, 12), random.within(-1, 12)));
                match random.below(3) {
                    0 => p,
                    1 => add(p, (random.around(1), random.around(1)), 1),
                    _ => add(p, (random.below(scene.unit), random.below(scene.unit)), 1),
                }
            };
            let (o, e) = (place(&mut random), place(&mut random));
            let e = [e, e, (o.0, e.1), (e.0, o.1)][random.below(4) as usize];
            let motion = vec2(add(e, o, -1));
            let got = pair.cast_ray(vec2(o), motion, Inside::Hit).unwrap();
            let expected = whole.cast_ray(vec2(o), motion, Inside::Hit).unwrap();
            let all = |h: tilesat::RayHit| (h.toi, h.point, h.axis, h.inside);
            assert_eq!(got.map(all), expected.map(all), "{scene:?}\n{o:?} to {e:?}");
            assert_eq!(pair.line_of_sight(vec2(o), vec2(e)), Ok(expected.is_none()));
            hits += u64::from(got.is_some());
            done += 1;
        }
    }
    println!("{done} rays, {hits} hit");
    assert!(hits > done / 8);
}
