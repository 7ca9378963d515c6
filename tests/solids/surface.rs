//! The surface of a list of solids is that of the union of its boxes. A level of boxes on a lattice
//! moves bodies like the level of tiles with the same full cells, alone, and joined with tiles that
//! contain a part of them.

use tilesat::world::{Geometry, Near, OneWay, Placed};
use tilesat::{
    Aabb, Axis, Body, Fx, Grid, Inside, Joined, Mover, RangeError, RayHit, Solid, Solids, TileKind, TileKinds, TileMap,
    Toi, Vec2, World,
};
use tilesat_judge::solids::{P, disc, rect, solid, vec2};
use tilesat_judge::{Random, cases};

static KINDS: TileKinds = TileKinds::EMPTY.with(1, TileKind::FULL);
const SIDE: i64 = 6;
const CELL: i64 = 1 << 10;

struct Scene {
    boxes: Vec<Solid>,
    union: Vec<u8>,
    /// A part of the union, as tiles. `rest` is a part of the boxes that covers the remainder.
    part: Vec<u8>,
    rest: Vec<Solid>,
}

fn scene(random: &mut Random) -> Scene {
    let mut s = Scene { boxes: vec![], union: vec![0; 36], part: vec![0; 36], rest: vec![] };
    for key in 0..random.within(1, 7) {
        let (x, y) = (random.below(SIDE), random.below(SIDE));
        let (w, h) = (random.within(1, (SIDE - x).min(3)), random.within(1, (SIDE - y).min(3)));
        let one = solid((x * CELL, y * CELL), ((x + w) * CELL, (y + h) * CELL), key as u16);
        s.boxes.push(one);
        let tiles = random.one_in(2);
        if !tiles || random.one_in(4) {
            s.rest.push(one);
        }
        for (j, i) in (y..y + h).flat_map(|j| (x..x + w).map(move |i| (j, i))) {
            s.union[(j * SIDE + i) as usize] = 1;
            if tiles {
                s.part[(j * SIDE + i) as usize] = 1;
            }
        }
    }
    s
}

/// On the lattice of cells, give or take a unit or two.
fn place(random: &mut Random) -> i64 {
    random.within(-1, SIDE + 1) * CELL + [0, CELL / 2, random.around(2), random.around(CELL)][random.below(4) as usize]
}

fn motion(random: &mut Random) -> P {
    let one = |random: &mut Random| match random.below(4) {
        0 => 0,
        1 => random.within(-4, 4) * CELL,
        2 => random.around(5),
        _ => random.around(6 * CELL),
    };
    (one(random), one(random))
}

fn check<W: World, V: World, B: Body + PartialEq + std::fmt::Debug>(
    tiles: &W,
    boxes: &V,
    body: &B,
    v: Vec2,
    case: &str,
) {
    let mover = Mover::platformer(Axis::NEG_Y);
    let (a, b) = (mover.move_and_slide(tiles, body, v), mover.move_and_slide(boxes, body, v));
    match (a, b) {
        (Ok(a), Ok(b)) => {
            assert_eq!(
                (a.body, a.velocity, a.remaining),
                (b.body, b.velocity, b.remaining),
                "{case} {v:?}\n{a:?}\n{b:?}"
            );
            assert_eq!((a.floor, a.wall, a.ceiling), (b.floor, b.wall, b.ceiling), "{case} {v:?}\n{a:?}\n{b:?}");
        }
        (a, b) => assert_eq!(a.map(|m| m.body), b.map(|m| m.body), "{case}"),
    }
}

#[test]
fn boxes_are_the_level_that_their_union_is() {
    let mut random = Random::new(61);
    for _ in 0..cases(4_000) {
        let s = scene(&mut random);
        let grid = Grid::new(SIDE as u16, SIDE as u16, Fx::from_bits(CELL as i32), Vec2::ZERO).unwrap();
        let (union, part) =
            (TileMap::on_grid(&s.union, grid, &KINDS).unwrap(), TileMap::on_grid(&s.part, grid, &KINDS).unwrap());
        let (boxes, rest) = (Solids::new(&s.boxes), Solids::new(&s.rest));
        let (one, other) = (Joined::new(&part, &rest), Joined::new(&rest, &part));
        for _ in 0..10 {
            let (p, v) = ((place(&mut random), place(&mut random)), vec2(motion(&mut random)));
            let size = [1, CELL / 2, CELL, random.within(1, 2 * CELL)];
            let size = (size[random.below(4) as usize], size[random.below(4) as usize]);
            let body = rect(p, (p.0 + size.0, p.1 + size.1));
            let case = format!("{:?} {:?} {:?} {body:?}", s.boxes, s.part, s.rest);
            assert_eq!(union.overlaps(&body), boxes.overlaps(&body), "{case}");
            assert_eq!(union.touches(&body), boxes.touches(&body), "{case}");
            check(&union, &boxes, &body, v, &case);
            check(&union, &one, &body, v, &case);
            check(&union, &other, &body, v, &case);
            let body = disc(p, size.0);
            let case = format!("{:?} {:?} {:?} {body:?}", s.boxes, s.part, s.rest);
            assert_eq!(union.overlaps(&body), boxes.overlaps(&body), "{case}");
            assert_eq!(union.touches(&body), boxes.touches(&body), "{case}");
            check(&union, &boxes, &body, v, &case);
            check(&union, &one, &body, v, &case);
            check(&union, &other, &body, v, &case);
        }
    }
}

/// The nearest point of boxes, and of boxes at another place, is that of the tiles. From inside,
/// parts of boxes that another one covers are surface, too.
#[test]
fn the_nearest_point_is_that_of_the_union() {
    let mut random = Random::new(63);
    let grid = Grid::new(SIDE as u16, SIDE as u16, Fx::from_bits(CELL as i32), Vec2::ZERO).unwrap();
    let (mut found, by) = (0, vec2((70_000, -30_000)));
    for _ in 0..cases(3_000) {
        let s = scene(&mut random);
        let (union, boxes) = (TileMap::on_grid(&s.union, grid, &KINDS).unwrap(), Solids::new(&s.boxes));
        let placed = Placed::new(&boxes, by).unwrap();
        for _ in 0..8 {
            let p = vec2((place(&mut random), place(&mut random)));
            let within = Fx::from_bits(random.below(3 * CELL) as i32);
            let nearest = |near: Result<Option<Near>, RangeError>| {
                near.unwrap().map(|near| (near.point, near.distance, near.axis, near.inside))
            };
            let got = nearest(boxes.closest_point(p, within, OneWay::Ignore));
            let moved = nearest(placed.closest_point(p + by, within, OneWay::Ignore));
            assert_eq!(moved.map(|(point, d, axis, inside)| (point - by, d, axis, inside)), got);
            let expected = nearest(union.closest_point(p, within, OneWay::Ignore));
            if !union.overlaps(&Aabb::new(p, p).unwrap()) {
                // A tie goes to a face, and those of boxes end elsewhere than those of cells.
                let spot = |near: (Vec2, Fx, Axis, bool)| (near.1, near.3);
                assert_eq!(got.map(spot), expected.map(spot), "{:?} {p} {within}", s.boxes);
                found += u32::from(got.is_some());
            }
        }
    }
    assert!(found > 1_000, "{found}");
}

/// Rays from anywhere on the lattice of half cells, also from the seams and from covered parts of
/// faces, see the same in the tiles of the union, in the boxes, and in two levels with a part each.
#[test]
fn rays_see_the_union() {
    let mut random = Random::new(64);
    let grid = Grid::new(SIDE as u16, SIDE as u16, Fx::from_bits(CELL as i32), Vec2::ZERO).unwrap();
    let (mut starts, mut inside) = (0, 0);
    for _ in 0..cases(5_000) {
        let s = scene(&mut random);
        let (boxes, rest) = (Solids::new(&s.boxes), Solids::new(&s.rest));
        let (union, part) =
            (TileMap::on_grid(&s.union, grid, &KINDS).unwrap(), TileMap::on_grid(&s.part, grid, &KINDS).unwrap());
        let (one, other) = (Joined::new(&part, &rest), Joined::new(&boxes, &part));
        for _ in 0..30 {
            let mut half = || random.within(-1, 2 * SIDE + 1) * CELL / 2;
            let (o, e) = (vec2((half(), half())), vec2((half(), half())));
            let seen = |hit: Result<Option<RayHit>, RangeError>| {
                hit.unwrap().map(|hit| (hit.toi, hit.point, hit.axis, hit.inside))
            };
            let expected = seen(union.cast_ray(o, e - o, Inside::Hit));
            let got = [boxes.cast_ray(o, e - o, Inside::Hit), one.cast_ray(o, e - o, Inside::Hit)];
            for got in got.into_iter().chain([other.cast_ray(o, e - o, Inside::Hit)]) {
                assert_eq!(seen(got), expected, "{:?} {:?} {:?} {o} {e}", s.boxes, s.part, s.rest);
            }
            starts += u32::from(expected.is_some_and(|hit| hit.0 == Toi::ZERO));
            inside += u32::from(expected.is_some_and(|hit| hit.3));
        }
    }
    assert!(starts > 10_000 && inside > 5_000, "{starts} {inside}");
}

#[test]
fn two_flush_boxes_show_no_seam() {
    let pair = [solid((0, 0), (10, 10), 1), solid((10, 0), (25, 10), 2)];
    let all = rect((-100, -100), (100, 100));
    let (mut faces, mut corners) = (0, vec![]);
    for f in Solids::new(&pair).features(&all) {
        match f.geometry {
            Geometry::Face { a, dir, joined, .. } => {
                faces += 1;
                // Each of the two floors continues in the other one.
                let seam = dir == Axis::X && joined == [a == vec2((10, 0)), a == vec2((0, 0))];
                assert!(seam || dir == Axis::NEG_X || joined == [false; 2], "{f:?}");
            }
            Geometry::Vertex { p, .. } => corners.push(p),
            _ => panic!("{f:?}"),
        }
    }
    assert_eq!((faces, corners.len()), (6, 4));
    assert!(!corners.contains(&vec2((10, 0))) && !corners.contains(&vec2((10, 10))));
}

#[test]
fn the_list_s_order_changes_no_motion() {
    let mut random = Random::new(62);
    for _ in 0..cases(2_000) {
        let s = scene(&mut random);
        let mut shuffled = s.boxes.clone();
        random.shuffle(&mut shuffled);
        let (a, b) = (Solids::new(&s.boxes), Solids::new(&shuffled));
        for _ in 0..4 {
            let (p, v) = ((place(&mut random), place(&mut random)), vec2(motion(&mut random)));
            let case = format!("{:?} {p:?}", s.boxes);
            check(&a, &b, &rect(p, (p.0 + CELL / 2, p.1 + 300)), v, &case);
            check(&a, &b, &disc(p, CELL / 2), v, &case);
        }
    }
}
