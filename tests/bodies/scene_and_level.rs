//! Casts through a level and among bodies at once: what is first, and an end that is free in both.
//! Blocks are judged as boxes by the exact sums of two shapes; other levels by their overlap test.

use super::scene_queries::Set;
use super::sums::{cast_time, sum};
use tilesat::query::Overlaps;
use tilesat::scene::{FirstHit, SceneCast, Shape, SortSweepScene};
use tilesat::world::RayRules;
use tilesat::{
    AllShapes, Blocks, Circle, Inside, Quantity, SceneBody, TileKind, TileKinds, TileMap, TileShape, Toi, Vec2,
    world::ShapeSet,
};
use tilesat_judge::casts::judge::ONE;
use tilesat_judge::oracle::int256::Int256;
use tilesat_judge::solids::shapes::Any;
use tilesat_judge::solids::{P, disc, raw, rect, vec2};
use tilesat_judge::{Random, cases, enough};

const N: usize = 8;
/// A cell, in raw units.
const CELL: i64 = 16 << 16;
/// Cells of a side.
const SIDE: i64 = 6;

const BLOCKS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
static KINDS: TileKinds = BLOCKS;
static ALL: TileKinds = BLOCKS
    .with(b'/', TileKind::of(TileShape::SlopeBottomRight))
    .with(b'\\', TileKind::of(TileShape::SlopeBottomLeft))
    .with(b'(', TileKind::of(TileShape::ConvexTopLeft))
    .with(b')', TileKind::of(TileShape::ConcaveBottomRight))
    .with(b'-', TileKind::ONE_WAY_UP);

fn rows(r: &mut Random, tiles: &[u8]) -> String {
    let tile = |r: &mut Random| if r.one_in(4) { tiles[r.below(tiles.len() as i64) as usize] } else { b'.' };
    (0..SIDE).map(|_| (0..SIDE).map(|_| char::from(tile(r))).collect::<String>() + "\n").collect()
}

/// The solid cells of rows of blocks.
fn cells(rows: &str) -> Vec<Any> {
    let solid = |(i, _): &(usize, u8)| {
        let (x, y) = (*i as i64 % (SIDE + 1), *i as i64 / (SIDE + 1));
        rect((x * CELL, y * CELL), ((x + 1) * CELL, (y + 1) * CELL)).into()
    };
    rows.bytes().enumerate().filter(|(_, tile)| *tile == b'#').map(|one| solid(&one)).collect()
}

fn place(r: &mut Random) -> P {
    (r.within(CELL, (SIDE - 1) * CELL), r.within(CELL, (SIDE - 1) * CELL))
}

fn shape(r: &mut Random, at: P) -> Shape {
    let (w, h) = (r.within(1, 6 << 16), r.within(1, 6 << 16));
    if r.one_in(2) { rect((at.0 - w, at.1 - h), (at.0 + w, at.1 + h)).into() } else { disc(at, w).into() }
}

/// A ball that meets a corner of a cell, or passes it, as it moves by `d`.
fn to_corner(r: &mut Random, d: P) -> Shape {
    let corner = (r.within(1, SIDE - 1) * CELL, r.within(1, SIDE - 1) * CELL);
    let radius = r.within(1, 6 << 16);
    let (x, y) = aside(r, (-d.0, -d.1), radius);
    disc((corner.0 + x - d.0 / 2, corner.1 + y - d.1 / 2), radius).into()
}

/// A vector of a length, within the quadrant of `d`.
fn aside(r: &mut Random, d: P, length: i64) -> P {
    let (x, y) = (r.within(0, 1 << 20) * d.0.signum(), r.within(1, 1 << 20) * d.1.signum());
    let whole = (x * x + y * y).isqrt().max(1);
    (length * x / whole, length * y / whole)
}

/// A body that the shape touches where it is after `by`, give or take a raw unit or two.
fn touching(r: &mut Random, moving: &Shape, by: P, d: P) -> Shape {
    let ahead = |d: i64, size: i64| if d < 0 { -size } else { size };
    let jitter = (r.around(2), r.around(2));
    let c = raw(moving.centre());
    let c = (c.0 + by.0 + jitter.0, c.1 + by.1 + jitter.1);
    let size = r.within(1, 8 << 16);
    let half = moving.aabb().size().x.to_bits() as i64 / 2;
    match r.below(3) {
        0 => {
            let (x, y) = aside(r, d, half + size);
            disc((c.0 + x, c.1 + y), size).into()
        }
        1 => {
            let near = c.0 + ahead(d.0, half);
            rect((near, c.1 - size), (near + ahead(d.0, size), c.1 + size)).into()
        }
        _ => {
            let near = c.1 + ahead(d.1, half);
            rect((c.0 - size, near), (c.0 + size, near + ahead(d.1, size))).into()
        }
    }
}

#[derive(Default, Debug)]
struct Seen {
    walls: u64,
    bodies: u64,
    /// The end of the cast that is first is inside of the other one.
    traps: u64,
    inside: u64,
    /// The end is not that of the first cast.
    moved: u64,
}

struct Case<'t, S: ShapeSet> {
    rows: &'t str,
    level: &'t TileMap<'t, S>,
    scene: SortSweepScene<N>,
    bodies: Vec<Shape>,
    moving: Shape,
    d: P,
    rules: RayRules,
}

impl<S: ShapeSet> Case<'_, S> {
    fn ask(&self) -> Option<SceneCast> {
        self.scene.cast_shape_in(self.level, self.moving, vec2(self.d), self.rules, |_, _| true).unwrap()
    }

    /// The hit of the level alone: its time, displacement, and whether it starts inside.
    fn wall(&self) -> Option<(Toi, Vec2, bool)> {
        let d = vec2(self.d);
        match self.moving {
            Shape::Aabb(it) => {
                let found = self.level.cast_shape(&it, d, self.rules).unwrap()?;
                Some((found.hit.toi, found.body.min() - it.min(), found.inside))
            }
            Shape::Circle(it) => {
                let found = self.level.cast_shape(&it, d, self.rules).unwrap()?;
                Some((found.hit.toi, found.body.centre() - it.centre(), found.inside))
            }
        }
    }

    fn told(&self) -> String {
        format!("{:?} by {:?} with {:?} among {:?} in\n{}", self.moving, self.d, self.rules, self.bodies, self.rows)
    }

    /// The bodies that a position overlaps.
    fn overlapped(&self, shape: &Shape) -> Vec<usize> {
        let at = shape.any();
        (0..self.bodies.len()).filter(|&i| sum(&at, &self.bodies[i].any()).holds::<Int256>((0, 0))).collect()
    }

    fn check(&self, seen: &mut Seen) -> Option<SceneCast> {
        let (found, wall) = (self.ask(), self.wall());
        let body = |b: &Shape| cast_time(&self.moving.any(), &b.any(), self.d, self.rules.inside);
        let body = self.bodies.iter().filter_map(body).min();
        let wall_first = wall.is_some_and(|(toi, ..)| body.is_none_or(|body| i64::from(toi.raw()) <= body));
        let Some(found) = found else {
            assert!(wall.is_none() && body.is_none(), "{}", self.told());
            return None;
        };
        let first = match found.first {
            FirstHit::Level(hit) => {
                assert!(wall_first && wall.map(|(toi, _, inside)| (toi, inside)) == Some((hit.toi, found.inside)));
                seen.walls += 1;
                wall.unwrap().1
            }
            FirstHit::Body(hit) => {
                assert!(!wall_first && body == Some(hit.hit.toi.raw().into()), "{}", self.told());
                assert_eq!(hit.hit.inside, found.inside);
                seen.bodies += 1;
                hit.hit.displacement
            }
        };
        assert!(found.first.toi() == Toi::ZERO || !found.inside);
        seen.inside += u64::from(found.inside);
        let end = self.moving.translated(found.displacement).unwrap();
        let (at_start, at_end) = (self.overlapped(&self.moving), self.overlapped(&end));
        assert!(at_end.iter().all(|i| at_start.contains(i)), "ends in a body: {}", self.told());
        let starts_inside = self.moving.overlaps_level(self.level);
        assert!(starts_inside || !end.overlaps_level(self.level), "ends in the level: {}", self.told());
        if !starts_inside && at_start.is_empty() && found.displacement != first {
            seen.moved += 1;
            let trap = self.moving.translated(first).unwrap();
            seen.traps += u64::from(trap.overlaps_level(self.level) || !self.overlapped(&trap).is_empty());
        }
        Some(found)
    }
}

/// Near ties, and what is judged of each.
fn ties<S: ShapeSet>(
    seed: u64,
    tiles: &[u8],
    kinds: &'static TileKinds,
    judge: impl Fn(&Case<'_, S>, Option<SceneCast>),
) -> Seen {
    let (mut r, mut seen) = (Random::new(seed), Seen::default());
    for _ in 0..cases(400) {
        let text = rows(&mut r, tiles);
        let map = TileMap::from_ascii(&text, &TileKinds::EMPTY).unwrap();
        let level = map.with_kinds::<S>(kinds).unwrap();
        for _ in 0..16 {
            let inside = if r.one_in(8) { Inside::Ignore } else { Inside::Hit };
            let rules = RayRules { inside, one_way: r.one_in(2) };
            let start = |r: &mut Random| {
                let (at, d) = (place(r), (r.around(3 * CELL), r.around(3 * CELL)));
                let moving = if r.one_in(3) { shape(r, at) } else { to_corner(r, d) };
                Case {
                    rows: &text,
                    level: &level,
                    scene: SortSweepScene::empty(),
                    bodies: Vec::new(),
                    moving,
                    d,
                    rules,
                }
            };
            let mut case = start(&mut r);
            // Mostly one that is free and hits the level.
            for _ in 0..r.below(12) {
                if case.wall().is_some_and(|(.., inside)| !inside) {
                    break;
                }
                case = start(&mut r);
            }
            let by = case.wall().map_or(case.d, |(_, by, _)| raw(by));
            for key in 0..r.within(1, 2) as u32 {
                let body = touching(&mut r, &case.moving, by, case.d);
                if r.one_in(8) || !body.overlaps(&case.moving) {
                    case.scene.insert(&SceneBody::of(body, key)).unwrap();
                    case.bodies.push(body);
                }
            }
            let found = case.check(&mut seen);
            judge(&case, found);
        }
    }
    println!("{seen:?}");
    seen
}

/// Every motion that is free is found free. The end is near the exact time of the first hit.
#[test]
fn among_blocks() {
    let seen = ties::<Blocks>(1, b"#", &KINDS, |case, found| {
        // A level passes all that hangs together with what it ignores.
        if case.rules.inside == Inside::Ignore && case.moving.overlaps_level(case.level) {
            return;
        }
        let all: Vec<_> = cells(case.rows).into_iter().chain(case.bodies.iter().map(Set::any)).collect();
        let first = all.iter().filter_map(|it| cast_time(&case.moving.any(), it, case.d, case.rules.inside)).min();
        assert_eq!(found.is_some(), first.is_some(), "{}", case.told());
        let (Some(found), Some(first)) = (found, first) else { return };
        let exact = |d: i64| i64::try_from(i128::from(d) * i128::from(first) / i128::from(ONE)).unwrap();
        let end = raw(found.displacement);
        let short = (exact(case.d.0) - end.0).abs().max((exact(case.d.1) - end.1).abs());
        assert!(short <= 8, "{short} raw short: {}", case.told());
        if case.rules.inside == Inside::Hit && !found.inside {
            let way = |it: &Any| sum(&case.moving.any(), it).met::<Int256>(end, ONE);
            assert!(!all.iter().any(way), "the way is not free: {}", case.told());
        }
    });
    assert!(enough(seen.walls > 1000 && seen.bodies > 1000 && seen.traps > 2 && seen.inside > 100), "{seen:?}");
}

#[test]
fn among_all_shapes() {
    let seen = ties::<AllShapes>(2, b"##/\\()-", &ALL, |case, found| {
        let Some(found) = found else { return };
        let again = case.scene.cast_shape_in(case.level, case.moving, found.displacement, case.rules, |_, _| true);
        assert!(found.inside || again == Ok(None), "{}", case.told());
    });
    assert!(enough(seen.walls > 1000 && seen.bodies > 1000 && seen.traps > 10 && seen.inside > 100), "{seen:?}");
}

/// Rays: the level first at the same time, or else the earlier one.
#[test]
fn rays() {
    let (mut r, mut seen) = (Random::new(3), [0; 3]);
    for _ in 0..cases(2000) {
        let text = rows(&mut r, b"#");
        let map = TileMap::from_ascii(&text, &KINDS).unwrap();
        let (o, d) = (place(&mut r), (r.around(3 * CELL), r.around(3 * CELL)));
        let d = [(d.0, 0), (0, d.1), d][r.below(3) as usize];
        let wall = map.cast_ray(vec2(o), vec2(d), Inside::Hit).unwrap();
        let point = Shape::from(disc(o, 0));
        let by = wall.map_or(d, |wall| raw(wall.point - vec2(o)));
        let mut scene = SortSweepScene::<N>::empty();
        let body = match touching(&mut r, &point, by, d) {
            Shape::Aabb(it) => SceneBody::new(it, 1),
            Shape::Circle(it) => SceneBody::new(it, 1),
        };
        let body = scene.insert(&body).unwrap();
        let alone = scene.cast_ray(vec2(o), vec2(d), Inside::Hit, |_, _| true).unwrap();
        let both = scene.cast_ray_in(&map, vec2(o), vec2(d), Inside::Hit, |_, _| true).unwrap();
        let first = match (wall, alone) {
            (Some(wall), Some(hit)) if hit.hit.toi < wall.toi => Some(FirstHit::Body(hit)),
            (Some(wall), hit) => {
                seen[0] += usize::from(hit.is_some_and(|hit| hit.hit.toi == wall.toi));
                Some(FirstHit::Level(wall))
            }
            (None, hit) => hit.map(FirstHit::Body),
        };
        assert_eq!(both, first, "{o:?} {d:?} {:?} in\n{text}", scene.body(body));
        if let Some(both) = both {
            seen[1 + usize::from(both.body() == Some(body))] += 1;
            let way = i64::from(both.toi().raw());
            let exact = (d.0 * way / ONE, d.1 * way / ONE);
            let end = raw(both.point(vec2(o)) - vec2(o));
            assert!((end.0 - exact.0).abs() <= 2 && (end.1 - exact.1).abs() <= 2);
            assert!(both.toi() == Toi::ZERO || vec2(d).x.to_bits() as i64 * i64::from(both.axis().x) <= 0 || d.1 != 0);
        }
        let unwanted = scene.cast_ray_in(&map, vec2(o), vec2(d), Inside::Hit, |it, _| it != body).unwrap();
        assert_eq!(unwanted, wall.map(FirstHit::Level));
    }
    assert!(enough(seen.iter().all(|&count| count > 50)), "{seen:?}");
}

/// A ball that meets a corner of the level and a fixed ball at nearly the same time. The
/// displacement up to the ball alone ends in the corner, by a raw unit.
#[test]
fn a_trap() {
    let level = TileMap::from_ascii("....\n..#.\n....\n", &KINDS).unwrap();
    let mut scene = SortSweepScene::<N>::empty();
    let ball = scene.insert(&SceneBody::fixed(disc((2_476_002, 868_597), 4 << 16), 1)).unwrap();
    let hero = disc((1_183_242, 1_078_705), 3 << 16);
    let d = vec2((2_086_722, -524_850));
    let alone = scene.cast_shape(&hero, d, Inside::Hit, |_, _| true).unwrap().unwrap();
    let wall = level.cast_shape(&hero, d, Inside::Hit).unwrap();
    assert!(wall.is_none_or(|wall| wall.hit.toi > alone.hit.toi));
    assert!(level.overlaps(&hero.translated(alone.hit.displacement).unwrap()));
    let both = scene.cast_shape_in(&level, hero, d, Inside::Hit, |_, _| true).unwrap().unwrap();
    let end = hero.translated(both.displacement).unwrap();
    assert!(both.first.body() == Some(ball) && !level.overlaps(&end));
    assert!((both.displacement - alone.hit.displacement).x.to_bits().abs() <= 2);
}

#[test]
fn refusals() {
    let level = TileMap::from_ascii(".", &KINDS).unwrap();
    let scene = SortSweepScene::<N>::empty();
    let ball = Circle::new(Vec2::ZERO, tilesat::fx!(4)).unwrap();
    let never = |_, _: &SceneBody| -> bool { panic!("a refused question") };
    let cast = |d| scene.cast_shape_in(&level, ball, d, Inside::Hit, never).unwrap_err().what;
    assert_eq!(
        (cast(Vec2::from_raw(1 << 28, 0)), cast(Vec2::from_raw(0, -1 << 28))),
        (Quantity::MotionX, Quantity::MotionY)
    );
    let ray = |o, d| scene.cast_ray_in(&level, o, d, Inside::Hit, never).unwrap_err().what;
    assert_eq!(ray(Vec2::ZERO, Vec2::from_raw(1 << 29, 0)), Quantity::EndX);
    assert_eq!(ray(Vec2::from_raw(0, 1 << 29), Vec2::ZERO), Quantity::Y);
}
