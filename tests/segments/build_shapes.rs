//! Segment maps by hand: junctions, holes, walls, loops and one-way chains. The compiler and the
//! program build the same bytes.

use tilesat::PathKind::{self, Hole, OneWay, Solid, Wall};
use tilesat::{Fx, Path, SegmentMap, SegmentMapError, Vec2, segment_map};
use tilesat_judge::paths::level::{Level, NONE, Point, SOLID, Shape, bytes, level, placed, shape};

const U: i64 = 100;

/// On cells of 256 raw, with a lattice of 100.
fn built(shapes: &[Shape]) -> Level {
    level(&placed(shapes, U, (0, 0)), 256)
}

/// The segments as lattice points, each with its joints and the start of the next one.
fn ends(level: &Level) -> Vec<(Point, Point)> {
    let lattice = |(x, y): Point| (x / U, y / U);
    level.segs.iter().map(|s| (lattice(s.a), lattice(s.b()))).collect()
}

/// `[start_joined, end_joined]` of each.
fn joined(level: &Level) -> Vec<[bool; 2]> {
    level.segs.iter().map(|s| [s.start_joined, s.end_joined]).collect()
}

fn nexts(level: &Level) -> Vec<Option<u16>> {
    level.segs.iter().map(|s| if s.next == NONE { None } else { Some(s.next) }).collect()
}

const SQUARE: [Point; 4] = [(0, 0), (4, 0), (4, 4), (0, 4)];

fn reversed(points: &[Point]) -> Vec<Point> {
    points.iter().rev().copied().collect()
}

fn sorted<T: Ord>(mut list: Vec<T>) -> Vec<T> {
    list.sort_unstable();
    list
}

#[test]
fn either_winding_is_the_same_solid() {
    for kind in [Solid, Hole] {
        let outer = shape(Solid, &[(-4, -4), (8, -4), (8, 8), (-4, 8)]);
        let (one, other) = (shape(kind, &SQUARE), shape(kind, &reversed(&SQUARE)));
        let (one, other) = (built(&[outer.clone(), one]), built(&[outer, other]));
        assert_eq!(sorted(ends(&one)), sorted(ends(&other)));
        assert_eq!((&one.winding, sorted(joined(&one))), (&other.winding, sorted(joined(&other))));
        // A solid's corners are vertices, a hole's are concave.
        let vertices = one.segs[4..].iter().filter(|s| s.next != NONE).count();
        assert_eq!(vertices, if kind == Solid { 4 } else { 0 });
    }
}

#[test]
fn what_is_shared_is_gone() {
    // A whole edge, a part of one, and two parts of one.
    let right = shape(Solid, &[(4, 0), (8, 0), (8, 4), (4, 4)]);
    let level = built(&[shape(Solid, &SQUARE), right]);
    assert_eq!(
        ends(&level),
        [((0, 0), (4, 0)), ((4, 4), (0, 4)), ((0, 4), (0, 0)), ((4, 0), (8, 0)), ((8, 0), (8, 4)), ((8, 4), (4, 4))]
    );
    assert_eq!(joined(&level), [[false, true], [true, false], [false; 2], [true, false], [false; 2], [false, true]]);

    let step = shape(Solid, &[(4, 1), (6, 1), (6, 2), (4, 2)]);
    let other = shape(Solid, &[(4, 3), (4, 4), (5, 4)]);
    let level = built(&[shape(Solid, &SQUARE), step, other]);
    let first: Vec<_> = ends(&level).into_iter().take(5).collect();
    assert_eq!(first, [((0, 0), (4, 0)), ((4, 0), (4, 1)), ((4, 2), (4, 3)), ((4, 4), (0, 4)), ((0, 4), (0, 0))]);
    assert_eq!(nexts(&level)[..5], [Some(1), None, None, Some(4), Some(0)]);
    // Below the step's side the wall continues to a concave corner.
    assert_eq!(joined(&level)[1..3], [[false, true], [true, true]]);

    // The same hole removes everything. Twice the same solid is there twice.
    let level = built(&[shape(Solid, &SQUARE), shape(Hole, &SQUARE)]);
    assert!(level.segs.is_empty() && level.winding.iter().all(|&w| w == 0));
    let level = built(&[shape(Solid, &SQUARE), shape(Solid, &reversed(&SQUARE))]);
    assert_eq!((level.segs.len(), level.winding[0]), (8, 2));
    // A spike without area, of one polygon.
    let level = built(&[shape(Solid, &[(0, 0), (4, 0), (4, 2), (7, 2), (4, 2), (4, 4)])]);
    assert_eq!(level.segs.len(), 4);
}

#[test]
fn a_wall_on_a_floor_is_a_junction() {
    //      |            The wall ends on the middle of the floor's top: no vertices there, and one
    //   ===+=== floor   at its free end, around which each face leads to the other.
    let floor = [(0, 0), (0, 2), (8, 2), (8, 0)];
    let wall = [(4, 2), (4, 5)];
    let level = built(&[shape(Solid, &floor), shape(Wall, &wall)]);
    let (up, down) = (level.segs[4], level.segs[5]);
    assert_eq!((up.dir, up.start_joined, up.next), ((0, 1), true, 5));
    assert_eq!((down.dir, down.start_joined, down.next), ((0, -1), false, NONE));
    let top = level.segs[..4].iter().find(|s| s.dir == (-1, 0) && s.a.1 == 2 * U).unwrap();
    assert_eq!((top.len, top.start_joined, top.end_joined), (8 * U, false, false));
    // From below it ends in the solid. A wall from the corner leaves only the vertex around which
    // it is reached.
    let level = built(&[shape(Solid, &floor), shape(Wall, &[(8, 2), (8, 5)])]);
    let side = level.segs[..4].iter().position(|s| s.dir == (0, 1)).unwrap();
    assert_eq!((level.segs[side].next, level.segs[side].end_joined), (NONE, true));
    assert_eq!((level.segs[5].dir, level.segs[5].next), ((0, -1), NONE));
}

#[test]
fn a_corner_on_an_edge_is_a_junction() {
    // A diamond stands with a corner on the floor: two wedges of less than half a turn, no vertex.
    // Its other corners are vertices.
    let floor = shape(Solid, &[(0, 0), (8, 0), (8, 2), (0, 2)]);
    let diamond = shape(Solid, &[(4, 2), (6, 4), (4, 6), (2, 4)]);
    let level = built(&[floor, diamond]);
    assert_eq!(nexts(&level), [Some(1), Some(2), Some(3), Some(0), Some(5), Some(6), Some(7), None]);
    assert_eq!(joined(&level)[4], [true, false]);
    // Two squares that touch at a corner: a quarter turn lies between them, twice.
    let level = built(&[shape(Solid, &SQUARE), shape(Solid, &[(4, 4), (8, 4), (8, 8), (4, 8)])]);
    assert_eq!(level.segs.iter().filter(|s| s.next == NONE).count(), 2);
    assert_eq!(level.segs.iter().filter(|s| s.start_joined).count(), 2);
}

#[test]
fn walls_and_loops() {
    // A chain with a bend: both faces end in cusps, the bend is a vertex of one side.
    let level = built(&[shape(Wall, &[(0, 0), (4, 0), (6, 3)])]);
    assert_eq!(ends(&level), [((0, 0), (4, 0)), ((4, 0), (0, 0)), ((4, 0), (6, 3)), ((6, 3), (4, 0))]);
    assert_eq!(nexts(&level), [Some(2), Some(0), Some(3), None]);
    assert!(level.winding.iter().all(|&w| w == 0));
    // A loop is hollow: convex from outside, joined inside.
    let level = built(&[shape(Wall, &[(0, 0), (4, 0), (4, 4), (0, 0)])]);
    assert_eq!(nexts(&level), [Some(2), None, Some(4), None, Some(0), None]);
    assert!(level.winding.iter().all(|&w| w == 0));
    // Doubled back over itself, and over a polygon's edge: nothing cancels.
    assert_eq!(built(&[shape(Wall, &[(0, 0), (4, 0), (2, 0)])]).segs.len(), 4);
    assert_eq!(built(&[shape(Solid, &SQUARE), shape(Wall, &[(0, 0), (2, 0)])]).segs.len(), 6);
}

#[test]
fn one_way_chains() {
    // It continues over a peak, but not at its ends. The peak is its vertex.
    let level = built(&[shape(OneWay, &[(6, 2), (4, 3), (2, 2), (0, 2)])]);
    assert_eq!(nexts(&level), [Some(1), None, None]);
    assert_eq!(joined(&level), [[false, true], [true, true], [true, false]]);
    // Beside a solid at the same height it continues. The solid keeps its vertex, because bodies
    // come through from the other side.
    let level = built(&[shape(Solid, &SQUARE), shape(OneWay, &[(7, 4), (4, 4)])]);
    assert_eq!(level.segs.iter().filter(|s| s.kind == SOLID && s.next == NONE).count(), 0);
    assert_eq!(joined(&level)[4], [false, true]);
    // From the solid's vertical side, too; around its corner it does not.
    let level = built(&[shape(Solid, &SQUARE), shape(OneWay, &[(4, 1), (7, 1)]), shape(OneWay, &[(8, 1), (4, 4)])]);
    assert_eq!(joined(&level)[4..], [[true, false], [false, false]]);
    // In both directions at once it is two chains, each with its own ends.
    let level = built(&[shape(OneWay, &[(0, 0), (4, 0)]), shape(OneWay, &[(4, 0), (0, 0)])]);
    assert_eq!(joined(&level), [[false, false], [false, false]]);
    // A loop has no ends.
    let level = built(&[shape(OneWay, &[(0, 0), (4, 0), (4, 4), (0, 0)])]);
    assert_eq!(joined(&level), [[true, true]; 3]);
}

#[test]
fn flags_are_those_of_the_path() {
    let flagged = |kind, points: &[Point], flags| Shape { flags, ..shape(kind, points) };
    let level = built(&[
        flagged(Solid, &SQUARE, 1),
        flagged(Wall, &[(5, 0), (6, 0)], 255),
        flagged(OneWay, &[(5, 3), (6, 3)], 8),
    ]);
    let flags: Vec<u8> = level.segs.iter().map(|s| s.flags).collect();
    assert_eq!(flags, [1, 1, 1, 1, 255, 255, 8]);
}

const OUTER: [Vec2; 5] = [
    Vec2::from_ints(0, 0),
    Vec2::from_ints(90, 0),
    Vec2::from_ints(90, 50),
    Vec2::from_ints(40, 77),
    Vec2::from_ints(0, 50),
];
const INNER: [Vec2; 4] =
    [Vec2::from_ints(10, 10), Vec2::from_ints(30, 10), Vec2::from_ints(30, 30), Vec2::from_ints(10, 30)];
const LINE: [Vec2; 3] = [Vec2::from_ints(90, 20), Vec2::from_ints(120, 20), Vec2::from_ints(130, 35)];
const PATHS: [Path<'static>; 4] = [
    Path::new(PathKind::Solid, &OUTER),
    Path::new(PathKind::Hole, &INNER).with_flags(2),
    Path::new(PathKind::Wall, &LINE),
    Path::new(PathKind::OneWay, &INNER),
];

segment_map!(
    /// One line.
    #[allow(long_running_const_eval)]
    pub(crate) static LEVEL: PATHS, Fx::lit("17.5")
);

const BYTES: usize = match SegmentMap::measure(&PATHS, Fx::lit("17.5")) {
    Ok(size) => size.bytes(),
    Err(_) => 0,
};
static DATA: [u8; BYTES] = {
    let mut out = [0xff; BYTES];
    match SegmentMap::build_into(&PATHS, Fx::lit("17.5"), &mut out) {
        Ok(BYTES) => out,
        _ => panic!("bad level"),
    }
};
/// Read by the compiler.
static MAP: Result<SegmentMap<'static>, SegmentMapError> = SegmentMap::from_bytes(&DATA);

#[test]
fn the_compiler_builds_the_same_bytes() {
    let raw = |points: &[Vec2]| -> Vec<Point> {
        points.iter().map(|p| (i64::from(p.raw().0), i64::from(p.raw().1))).collect()
    };
    let shapes: Vec<Shape> =
        PATHS.iter().map(|p| Shape { kind: p.kind, points: raw(p.points), flags: p.flags }).collect();
    let found = bytes(&shapes, 35 << 15).unwrap();
    assert_eq!(found, DATA);
    // A view's Debug shows its tables.
    let view = format!("{:?}", SegmentMap::from_bytes(&found).unwrap());
    assert_eq!(format!("{:?}", MAP.unwrap()), view);
    assert_eq!(format!("{LEVEL:?}"), view);
    // At any alignment.
    let mut shifted = vec![0];
    shifted.extend(&found);
    assert_eq!(format!("{:?}", SegmentMap::from_bytes(&shifted[1..]).unwrap()), view);
}

/// Clippy would build the level once more, which takes ten seconds. A short one has the same code.
const TEETH: usize = if cfg!(clippy) { 22 } else { 2000 };
const SAW: [Vec2; TEETH] = {
    let (mut points, mut i) = ([Vec2::ZERO; TEETH], 0);
    while i < TEETH as i16 - 2 {
        points[i as usize] = Vec2::from_ints(3 * i - 3000, 7 * i % 13 + i % 5);
        i += 1;
    }
    points[TEETH - 2] = Vec2::from_ints(2991, 60);
    points[TEETH - 1] = Vec2::from_ints(-3000, 60);
    points
};

/// Without leave to take long: the compiler refuses what takes longer.
#[test]
fn the_compiler_builds_two_thousand_segments() {
    segment_map!(static LEVEL: [Path::new(Solid, &SAW)], Fx::const_from_int(32));
    let mut room = vec![0; 100_000];
    let used = SegmentMap::build_into(&[Path::new(Solid, &SAW)], Fx::from_num(32), &mut room).unwrap();
    assert_eq!(LEVEL.count(), 2000);
    assert_eq!(format!("{LEVEL:?}"), format!("{:?}", SegmentMap::from_bytes(&room[..used]).unwrap()));
}
