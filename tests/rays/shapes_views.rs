//! Other views of the same scene: as blocks, mirrored, transposed, shifted. The hits are the same,
//! bit for bit.

use tilesat::{Axis, Blocks, Inside, Outside, RayHit, TileKind, TileKinds, TileMap, TileShape, Vec2, world::RayRules};
use tilesat_judge::rays::cast::Scene;
use tilesat_judge::rays::generate::ray;
use tilesat_judge::rays::level::Level;
use tilesat_judge::rays::solid::{Point, Solid};
use tilesat_judge::{Random, cases};

fn vec2(p: Point) -> Vec2 {
    Vec2::from_raw(p.0 as i32, p.1 as i32)
}

fn rules(random: &mut Random) -> RayRules {
    RayRules { inside: [Inside::Ignore, Inside::Hit][random.below(2) as usize], one_way: random.one_in(2) }
}

static BLOCKS: TileKinds = {
    let mut kinds = TileKinds::EMPTY.with(1, TileKind::FULL).with(65, TileKind::FULL.with_flags(65));
    let mut id = 34;
    while id < 38 {
        kinds = kinds.with(id, TileKind::of(TileShape::ALL[id as usize]));
        id += 1;
    }
    kinds
};

/// A level of blocks gives the same answers with a set with slopes and without, for one hit and for
/// all.
#[test]
fn blocks_are_the_same_in_any_set() {
    let mut random = Random::new(11);
    let mut done = 0;
    while done < cases(100_000) {
        let mut level = Level::random(&mut random);
        for id in &mut level.tiles {
            *id = match *id {
                0..=10 => 0,
                34..=37 => *id,
                64.. => 65,
                _ => 1,
            };
        }
        let (scene, shaped) = (Scene::new(&level), level.map());
        let blocks = TileMap::<Blocks>::of(&level.tiles, shaped.grid(), &BLOCKS).unwrap().with_outside(level.outside);
        for _ in 0..50 {
            let ((o, d), rules) = (ray(&mut random, &level, &scene), rules(&mut random));
            let (o, d) = (vec2(o), vec2(d));
            let key = |h: RayHit| (h.toi, h.point, h.axis, h.inside, h.one_way);
            let first = blocks.cast_ray(o, d, rules).unwrap();
            let case = || format!("{level:?}\nfrom {:?} by {:?}, {rules:?}", o.raw(), d.raw());
            assert_eq!(first.map(key), shaped.cast_ray(o, d, rules).unwrap().map(key), "{}", case());
            let all: Vec<_> = blocks.cast_ray_all(o, d, rules).unwrap().map(key).collect();
            assert_eq!(first.map(key), all.first().copied(), "{}", case());
            assert!(all.into_iter().eq(shaped.cast_ray_all(o, d, rules).unwrap().map(key)), "{}", case());
            done += 1;
        }
    }
}

/// What each shape is in a mirror, found by its solid.
fn turned_id(id: u8, turn: impl Fn(Point) -> Point, one_way: [u8; 4]) -> u8 {
    let flags = id & 64;
    let shape = id & 63;
    if shape >= 34 {
        return flags | one_way[usize::from(shape - 34)];
    }
    let key = |id: u8, turn: &dyn Fn(Point) -> Point| match Solid::of(id, (0, 0), (4, 4)) {
        Solid::Polygon(points) => {
            let mut points: Vec<Point> = points.into_iter().map(turn).collect();
            points.sort_unstable();
            (points, None)
        }
        Solid::Round { centre, convex, .. } => (vec![turn(centre)], Some(convex)),
    };
    let wanted = key(shape, &turn);
    flags | (0..34).find(|&other| key(other, &|p| p) == wanted).unwrap()
}

/// Whether two normals at this point can be equally good in all but their side.
fn is_vertex(level: &Level, p: Vec2) -> bool {
    let on = |v: i32, origin: i64| (i64::from(v) - origin) % (level.cell / 2) == 0;
    on(p.raw().0, level.origin.0) && on(p.raw().1, level.origin.1)
}

#[test]
fn mirrored_transposed_and_moved_scenes_give_the_same_bits() {
    let mut random = Random::new(12);
    let mut done = 0;
    while done < cases(30_000) {
        let level = Level::random(&mut random);
        let (w, h) = (level.width, level.height);
        let mirror: Vec<u8> = (0..=255)
            .map(|id| if id & 63 < 38 && id < 128 { turned_id(id, |p| (4 - p.0, p.1), [34, 37, 36, 35]) } else { 0 })
            .collect();
        let swap: Vec<u8> = (0..=255)
            .map(|id| if id & 63 < 38 && id < 128 { turned_id(id, |p| (p.1, p.0), [37, 36, 35, 34]) } else { 0 })
            .collect();
        let at = |c: i64, r: i64| level.tiles[(r * w + c) as usize];
        let mirrored = Level {
            origin: (-level.end().0, level.origin.1),
            tiles: (0..w * h).map(|i| mirror[usize::from(at(w - 1 - i % w, i / w))]).collect(),
            ..level.clone()
        };
        let transposed = Level {
            width: h,
            height: w,
            origin: (level.origin.1, level.origin.0),
            tiles: (0..w * h).map(|i| swap[usize::from(at(i / h, i % h))]).collect(),
            ..level.clone()
        };
        // The ends of the domain are the ends of repeated bands.
        let by = if level.outside == Outside::Edge { (0, 0) } else { (random.around(99), random.around(99)) };
        let inside = |v: i64| v.abs() < (1 << 29) - 100;
        let moved = Level { origin: (level.origin.0 + by.0, level.origin.1 + by.1), ..level.clone() };
        let can_move =
            inside(level.origin.0) && inside(level.origin.1) && inside(level.end().0) && inside(level.end().1);
        let scene = Scene::new(&level);
        for _ in 0..40 {
            let ((o, d), rules) = (ray(&mut random, &level, &scene), rules(&mut random));
            let case = || format!("{level:?}\nfrom {o:?} by {d:?}, {rules:?}");
            let cast = |level: &Level, o, d| -> Vec<RayHit> {
                level.map().cast_ray_all(vec2(o), vec2(d), rules).unwrap().collect()
            };
            let hits = cast(&level, o, d);

            let other = cast(&mirrored, (-o.0, o.1), (-d.0, d.1));
            assert_eq!(hits.len(), other.len(), "mirror: {}", case());
            for (a, b) in hits.iter().zip(&other) {
                let back = |v: Vec2| Vec2::from_raw(-v.raw().0, v.raw().1);
                assert_eq!(
                    (a.toi, a.point, a.inside, a.cells),
                    (b.toi, back(b.point), b.inside, b.cells),
                    "mirror: {}",
                    case()
                );
                // Straight along y, a ridge has two equally good normals.
                if d.0 != 0 {
                    assert_eq!(a.axis, Axis::new(-b.axis.x, b.axis.y), "mirror: {}", case());
                }
            }

            let other = cast(&transposed, (o.1, o.0), (d.1, d.0));
            assert_eq!(hits.len(), other.len(), "transposed: {}", case());
            for (a, b) in hits.iter().zip(&other) {
                let back = |v: Vec2| Vec2::new(v.y, v.x);
                assert_eq!(
                    (a.toi, a.point, a.inside, a.cells),
                    (b.toi, back(b.point), b.inside, b.cells),
                    "transposed: {}",
                    case()
                );
                // Normals more along x come first, where there are several.
                if !a.inside && !is_vertex(&level, a.point) {
                    assert_eq!(a.axis, Axis::new(b.axis.y, b.axis.x), "transposed: {}", case());
                }
            }

            let o = (o.0 + by.0, o.1 + by.1);
            if can_move && inside(o.0) && inside(o.1) && inside(o.0 + d.0) && inside(o.1 + d.1) {
                let mut other = cast(&moved, o, d);
                for hit in &mut other {
                    hit.point = Vec2::from_raw(hit.point.raw().0 - by.0 as i32, hit.point.raw().1 - by.1 as i32);
                }
                assert_eq!(hits, other, "moved: {}", case());
            }
            done += 1;
        }
    }
}
