//! Nooks: walls and solids that meet in a point, and a box with a corner at or near it.
//!
//! A wall has no solid behind it. So the point itself must stop a corner that would leave between
//! the ends of two faces, and only that. Exhaustive for walls of sixteen directions.

use tilesat::{Aabb, Fx, Mover, Path, PathKind, Response, SegmentMap, Vec2};

type P = (i64, i64);

/// The length of a lattice step, and of a step of a motion.
const FAR: i64 = 3000;
const STEPS: i64 = 16;

fn at((x, y): P) -> Vec2 {
    Vec2::from_raw(x as i32, y as i32)
}

fn directions() -> Vec<P> {
    let all = (-2..=2).flat_map(|x| (-2..=2).map(move |y| (x, y)));
    all.filter(|&(x, y)| (x % 2 != 0 || y % 2 != 0) && (x, y) != (0, 0)).collect()
}

/// Walls from the origin, and a solid with a corner there.
fn level(rays: &[P], solid: Option<[P; 2]>) -> Vec<u8> {
    let far = |(x, y): P| at((x * FAR, y * FAR));
    let walls: Vec<[Vec2; 2]> = rays.iter().map(|&ray| [far(ray), Vec2::ZERO]).collect();
    let solid = solid.map(|[a, b]| [Vec2::ZERO, far(a), far(b)]);
    let mut paths: Vec<Path> = walls.iter().map(|path| Path::new(PathKind::Wall, path)).collect();
    paths.extend(solid.iter().map(|path| Path::new(PathKind::Solid, path)));
    let mut bytes = vec![0; 1 << 13];
    let used = SegmentMap::build_into(&paths, Fx::from_bits(4096), &mut bytes).unwrap();
    bytes.truncate(used);
    bytes
}

/// A box in a quadrant of the origin, with its corner there.
fn in_quadrant((sx, sy): P, (width, height): P) -> Aabb {
    let (x, y) = (sx * width, sy * height);
    Aabb::new(at((x.min(0), y.min(0))), at((x.max(0), y.max(0)))).unwrap()
}

fn moved(body: &Aabb, (x, y): P) -> Aabb {
    body.translated(at((x, y))).unwrap()
}

/// Moves a box in steps of `v`: it stops exactly before the first place where it overlaps.
fn check(map: &SegmentMap, start: &Aabb, v: P, told: &mut (u32, u32)) {
    if map.overlaps(start) {
        return;
    }
    let mover = Mover::new().with_response(Response::Touch);
    let out = mover.move_and_slide(map, start, at((v.0 * STEPS, v.1 * STEPS))).unwrap();
    let place = |k: i64| moved(start, (v.0 * k, v.1 * k));
    let overlaps = (1..=STEPS).find(|&k| map.overlaps(&place(k)));
    let hit = out.hits.first().map(|hit| (i64::from(hit.toi.raw()) * STEPS) >> 30);
    match (overlaps, hit) {
        (Some(k), Some(used)) => {
            assert!(used < k, "{start:?} by {v:?} hits after {used} steps, overlaps at {k}");
            told.0 += 1;
        }
        (Some(k), None) => panic!("{start:?} by {v:?} overlaps at step {k}, and ends at {:?}", out.body),
        (None, Some(used)) => panic!("{start:?} by {v:?} hits nothing after {used} steps"),
        (None, None) => {
            assert_eq!(out.body, place(STEPS), "{start:?} by {v:?}");
            told.1 += 1;
        }
    }
}

#[test]
fn a_corner_stops_in_a_nook_of_walls() {
    let rays = directions();
    let mut told = (0, 0);
    let mut all = |map: &SegmentMap| {
        for quadrant in [(1, 1), (1, -1), (-1, 1), (-1, -1)] {
            let body = in_quadrant(quadrant, (1000, 700));
            for v in (-3..=3).flat_map(|x| (-3..=3).map(move |y| (x, y))).filter(|&v| v != (0, 0)) {
                check(map, &body, v, &mut told);
                check(map, &moved(&body, (-5 * v.0, -5 * v.1)), v, &mut told);
            }
        }
    };
    for (i, &a) in rays.iter().enumerate() {
        for (k, &b) in rays.iter().enumerate().skip(i + 1) {
            all(&SegmentMap::from_bytes(&level(&[a, b], None)).unwrap());
            for &c in rays.iter().skip(k + 1) {
                all(&SegmentMap::from_bytes(&level(&[a, b, c], None)).unwrap());
            }
        }
    }
    println!("{} stopped, {} free", told.0, told.1);
    assert!(told.0 > 50_000 && told.1 > 10_000, "{told:?}");
}

/// A box without width or height stops before the solid beside a wall, from all sides.
#[test]
fn a_bar_stops_in_a_nook_of_a_wall_and_a_solid() {
    let (rays, mover, mut stopped) = (directions(), Mover::new().with_response(Response::Touch), 0);
    let bars = [(900, 0), (-900, 0), (0, 900), (0, -900)].map(|(x, y): P| {
        let (lo, hi) = ((x.min(0), y.min(0)), (x.max(0), y.max(0)));
        Aabb::new(at(lo), at(hi)).unwrap()
    });
    let velocities = || (-3..=3).flat_map(|x| (-3..=3).map(move |y| (x, y))).filter(|&v| v != (0, 0));
    for (i, &a) in rays.iter().enumerate() {
        for &b in rays.iter().skip(i + 1).filter(|b| a.0 * b.1 != a.1 * b.0) {
            for &wall in &rays {
                let bytes = level(&[wall], Some([a, b]));
                let map = SegmentMap::from_bytes(&bytes).unwrap();
                for (bar, v) in bars.iter().flat_map(|bar| velocities().map(move |v| (bar, v))) {
                    let start = moved(bar, (-5 * v.0, -5 * v.1));
                    if map.touches(&start) {
                        continue;
                    }
                    let out = mover.move_and_slide(&map, &start, at((v.0 * STEPS, v.1 * STEPS))).unwrap();
                    let used = out.hits.first().map_or(STEPS, |hit| (i64::from(hit.toi.raw()) * STEPS) >> 30);
                    let free = (1..=used).all(|k| !map.overlaps(&moved(&start, (v.0 * k, v.1 * k))));
                    assert!(free, "{start:?} by {v:?} is in the solid {a:?} {b:?} beside {wall:?} before step {used}");
                    stopped += u32::from(!out.hits.is_empty());
                }
            }
        }
    }
    assert!(stopped > 100_000, "{stopped}");
}
