//! Rays through named scenes, with slopes, halves and arcs.

use tilesat::{
    AllShapes, Axis, Cell, Fx, Inside, Outside, RayHit, TileKind, TileKinds, TileMap, TileShape, Toi, Vec2,
    world::RayRules,
};

/// `/` and `\` are solid below, `(` and `)` are quarter pipes on a floor, `d` is a quarter disc
/// around its lower left corner, `_` the lower half.
static KINDS: TileKinds = TileKinds::EMPTY
    .with(b'#', TileKind::FULL)
    .with(b'/', TileKind::of(TileShape::SlopeBottomRight))
    .with(b'\\', TileKind::of(TileShape::SlopeBottomLeft))
    .with(b'(', TileKind::of(TileShape::ConcaveBottomLeft))
    .with(b')', TileKind::of(TileShape::ConcaveBottomRight))
    .with(b'd', TileKind::of(TileShape::ConvexBottomLeft))
    .with(b'b', TileKind::of(TileShape::ConvexBottomRight))
    .with(b'_', TileKind::of(TileShape::HalfBottom))
    .with(b'^', TileKind::of(TileShape::OneWayUp))
    .with(b'>', TileKind::of(TileShape::OneWayRight))
    .with(b'<', TileKind::of(TileShape::OneWayLeft))
    .with(b'v', TileKind::of(TileShape::OneWayDown));

fn map(text: &'static str) -> TileMap<'static, AllShapes> {
    TileMap::from_ascii(text, &TileKinds::EMPTY).unwrap().with_kinds(&KINDS).unwrap()
}

fn ints(x: i16, y: i16) -> Vec2 {
    Vec2::from_ints(x, y)
}

fn between(map: &TileMap<'_, AllShapes>, from: Vec2, to: Vec2) -> Option<RayHit> {
    map.cast_ray(from, to - from, Inside::Ignore).unwrap()
}

fn at(hit: Option<RayHit>) -> Option<(Vec2, Axis)> {
    hit.map(|h| (h.point, h.axis))
}

/// Torture scene 15: along lines of the grid, on which slopes, halves and pipes end.
#[test]
fn along_a_grid_line() {
    // A slope that starts on the line is met where it rises above it, from both sides of the line.
    assert_eq!(at(between(&map("..../\n....."), ints(0, 16), ints(80, 16))), Some((ints(64, 16), Axis::new(-1, -1))));
    assert_eq!(at(between(&map("..../\n#####"), ints(0, 16), ints(80, 16))), Some((ints(64, 16), Axis::new(-1, -1))));
    // From the other side, the ray meets its upright side at its end.
    assert_eq!(at(between(&map("..../\n....."), ints(100, 16), ints(0, 16))), Some((ints(80, 16), Axis::X)));
    // A pipe rises from the line as a tangent. Over a floor, the ray goes between two solids there.
    let pipe = Some((ints(64, 16), Axis::NEG_Y));
    assert_eq!(at(between(&map("....)\n#####"), ints(0, 16), ints(80, 16))), pipe);
    assert_eq!(at(between(&map("....)\n....."), ints(0, 16), ints(80, 16))), pipe);
    // A disc's end is on the line: a tangent to it misses, and a ray meets its foot.
    assert_eq!(at(between(&map("d.\n.."), ints(16, 0), ints(16, 12))), None);
    assert_eq!(at(between(&map("d.\n.."), ints(16, 30), ints(16, 0))), Some((ints(16, 16), Axis::Y)));
    assert_eq!(at(between(&map("d.\n.."), ints(30, 0), ints(-8, 0))), None);
    // Along the middle of cells: it slides along the top of halves, and meets the corner at its
    // start.
    assert_eq!(at(between(&map(".___"), ints(0, 8), ints(64, 8))), Some((ints(16, 8), Axis::NEG_X)));
    assert_eq!(at(between(&map("____"), ints(0, 8), ints(64, 8))), None);
    assert_eq!(at(between(&map("__#_"), ints(0, 8), ints(64, 8))), Some((ints(32, 8), Axis::NEG_X)));
}

/// Torture scene 16: a corner between two solids that touch there lets nothing through.
#[test]
fn through_a_corner() {
    for text in
        ["./..\n\\...\n....\n....", ".b..\nd...\n....\n....", ".#..\n\\...\n....\n....", "./..\n#...\n....\n...."]
    {
        let hit = between(&map(text), ints(0, 0), ints(64, 64)).unwrap_or_else(|| panic!("{text}"));
        assert_eq!(hit.point, ints(16, 16), "{text}");
    }
    // Two pipes touch with their ends. Between a slope and a disc there is a gap of one point.
    let cast = |text, from, to| at(between(&map(text), from, to));
    assert_eq!(cast(".)..\n....", ints(0, 0), ints(32, 32)), Some((ints(16, 16), Axis::NEG_Y)));
    assert_eq!(cast("..\n(.", ints(32, 16), ints(0, 48)), Some((ints(16, 32), Axis::NEG_Y)));
    // None on the way.
    assert_eq!(cast("\\...\n....\n..\\.\n....", ints(16, 0), ints(64, 48)), None);
}

/// Torture scene 17: starts on a slope and on an arc, at negative coordinates.
#[test]
fn starts_on_the_surface() {
    // Tiles of 10 units; the slope runs from (-10, 0) to (0, -10), the disc is around (0, 0) with
    // radius 10.
    let level = map("/d").with_cell(Fx::lit("10")).unwrap().with_origin(ints(-10, -10)).unwrap();
    let cast = |x, y, dx, dy| {
        let hit = level.cast_ray(ints(x, y), ints(dx, dy), Inside::Hit).unwrap();
        hit.map(|h| (h.toi.raw(), h.axis, h.cell, h.inside))
    };
    let (slope, disc) = (Some((0, Axis::new(-1, -1), Cell::new(0, 0), false)), Cell::new(1, 0));
    assert_eq!(cast(-5, -5, 3, 0), slope);
    assert_eq!(cast(-5, -5, 0, 3), slope);
    assert_eq!(cast(-5, -5, 3, -2), slope);
    assert_eq!(cast(-5, -5, 3, -3), None);
    assert_eq!(cast(-5, -5, -3, 2), None);
    let raw = |v: i32| v << 16;
    let inward = Axis::new(raw(6), raw(-8));
    assert_eq!(cast(6, -8, -1, 0), Some((0, inward, disc, false)));
    assert_eq!(cast(6, -8, 0, 1), Some((0, inward, disc, false)));
    assert_eq!(cast(6, -8, -4, -3), None); // along the tangent
    assert_eq!(cast(6, -8, 4, 3), None);
    assert_eq!(cast(6, -8, 0, -5), None);
    // In the quarter pipe the tangent goes into the solid.
    let pipe = map("(").with_cell(Fx::lit("10")).unwrap();
    let cast = |dx, dy| pipe.cast_ray(ints(2, 6), ints(dx, dy), Inside::Hit).unwrap().map(|h| (h.toi.raw(), h.axis));
    let normal = Axis::new(raw(8), raw(-6));
    assert_eq!(cast(3, 4), Some((0, normal)));
    assert_eq!(cast(-3, -4), Some((0, normal)));
    assert_eq!(cast(-1, 0), Some((0, normal)));
    assert_eq!(cast(4, -3), None);
    // Across the pipe's disc to its other end.
    assert_eq!(at(pipe.cast_ray(ints(0, 0), ints(10, 10), Inside::Hit).unwrap()), Some((ints(10, 10), Axis::NEG_Y)));
}

/// Torture scene 18: rays of no length.
#[test]
fn no_length() {
    let level = map("/d)");
    let cast = |p, inside| level.cast_ray(p, Vec2::ZERO, inside).unwrap().map(|h| h.inside);
    // On a slope, at its end, on the side between two tiles, at the end of a disc, on the end of a
    // pipe.
    for p in [ints(8, 8), ints(0, 16), ints(16, 16), ints(32, 16), ints(48, 0), ints(40, 2)] {
        assert_eq!((cast(p, Inside::Ignore), cast(p, Inside::Hit)), (None, None), "{p:?}");
    }
    for p in [ints(12, 8), ints(20, 8), ints(16, 8), ints(47, 15)] {
        assert_eq!((cast(p, Inside::Ignore), cast(p, Inside::Hit)), (None, Some(true)), "{p:?}");
    }
}

/// Torture scene 20: exactly to a slope or arc, and one raw short of it.
#[test]
fn exactly_to_the_surface() {
    let level = map("/d(").with_cell(Fx::lit("10")).unwrap();
    for (from, to) in [
        (ints(0, 0), ints(4, 6)),   // a slope
        (ints(3, 1), ints(3, 7)),   // straight down on it
        (ints(18, 0), ints(16, 2)), // a disc, at 6, 8
        (ints(16, -5), ints(16, 2)),
        (ints(30, 0), ints(22, 6)), // a pipe from its centre
        (ints(22, 0), ints(22, 6)),
    ] {
        let hit = between(&level, from, to).unwrap();
        if level.kind(hit.cell).shape == TileShape::SlopeBottomRight {
            assert_eq!((hit.point, hit.toi), (to, Toi::ONE));
        } else {
            // Round: from the free side.
            let ((x, y), (u, v)) = (hit.point.raw(), to.raw());
            assert!((x - u).abs() <= 2 && (y - v).abs() <= 2, "{hit:?}");
        }
        let d = to - from;
        let short = |v: Fx| Fx::from_bits(v.to_bits() - v.to_bits().signum());
        assert_eq!(level.cast_ray(from, Vec2::new(short(d.x), short(d.y)), Inside::Ignore).unwrap(), None);
    }
}

/// Torture scene 21: joints of two pieces give one hit, whatever the pieces are.
#[test]
fn at_joints() {
    // Slope to slope, convex ridge, concave valley, slope to flat, pipe to floor.
    for (text, from, to, point, axis) in [
        (".../\n../#", ints(40, 8), ints(56, 24), ints(48, 16), Axis::new(-1, -1)),
        ("/\\", ints(16, -16), ints(16, 8), ints(16, 0), Axis::new(1, -1)),
        ("\\/", ints(16, 0), ints(16, 32), ints(16, 16), Axis::new(1, -1)),
        ("./#", ints(32, -16), ints(32, 16), ints(32, 0), Axis::new(-1, -1)),
        ("..)\n###", ints(32, 0), ints(32, 20), ints(32, 16), Axis::NEG_Y),
    ] {
        let level = map(text);
        let hits: Vec<_> = level.cast_ray_all(from, to - from, Inside::Ignore).unwrap().collect();
        let first = hits.first().unwrap_or_else(|| panic!("{text}"));
        assert_eq!((first.point, first.axis), (point, axis), "{text}");
        assert_eq!(hits.len(), 1, "{text}: {hits:?}");
    }
}

/// Torture scene 35: a ray passes one-way edges, or meets them from their side.
#[test]
fn one_way_edges() {
    for (text, down) in [("...\n.^.\n...", true), ("...\n.v.\n...", false)] {
        let level = map(text);
        let cast = |from: Vec2, to: Vec2, one_way| {
            level.cast_ray(from, to - from, RayRules { inside: Inside::Ignore, one_way }).unwrap()
        };
        let (top, bottom) = (ints(24, 0), ints(24, 48));
        let (from, to) = if down { (top, bottom) } else { (bottom, top) };
        assert_eq!((cast(top, bottom, false), cast(bottom, top, false)), (None, None));
        assert_eq!(cast(to, from, true), None);
        let hit = cast(from, to, true).unwrap();
        let (line, axis) = if down { (16, Axis::NEG_Y) } else { (32, Axis::Y) };
        assert_eq!((hit.point, hit.axis, hit.one_way, hit.cell), (ints(24, line), axis, true, Cell::new(1, 1)));
        // From on the edge, and along it.
        let on = ints(24, line);
        assert!(cast(on, to, true).unwrap().one_way);
        assert_eq!((cast(on, from, true), cast(ints(0, line), ints(48, line), true)), (None, None));
        assert!(level.line_of_sight(from, to).unwrap());
    }
    let level = map("><");
    let right = RayRules { inside: Inside::Ignore, one_way: true };
    let hits =
        |from: Vec2, to: Vec2| level.cast_ray_all(from, to - from, right).unwrap().map(|h| h.point).collect::<Vec<_>>();
    assert_eq!(hits(ints(-8, 8), ints(40, 8)), [ints(16, 8)]);
    assert_eq!(hits(ints(40, 8), ints(-8, 8)), [ints(16, 8)]);
}

/// Through everything: in at one side of each solid. Out at the other is no hit.
#[test]
fn all_hits_in_order() {
    let level = map("/d.(_#");
    let hits = level.cast_ray_all(ints(-8, 12), ints(120, 0), Inside::Ignore).unwrap();
    let found: Vec<_> = hits.map(|h| (h.cell.x, h.index)).collect();
    assert_eq!(found, [(0, 8), (3, 3), (4, 3)]);
    let from_inside = level.cast_ray_all(ints(20, 8), ints(100, 0), Inside::Hit).unwrap();
    let found: Vec<_> = from_inside.map(|h| (h.cell.x, h.inside)).collect();
    // Along the top of the half, whose corner it meets.
    assert_eq!(found, [(1, true), (3, false), (4, false), (5, false)]);
}

/// Half an edge continues beyond the map as half a band. A closed room has walls.
#[test]
fn outside() {
    let level = map("_").with_outside(Outside::Edge);
    let down = |x| at(between(&level, ints(x, -100), ints(x, 100))).unwrap();
    assert_eq!(
        (down(-5000), down(8), down(5000)),
        ((ints(-5000, 8), Axis::NEG_Y), (ints(8, 8), Axis::NEG_Y), (ints(5000, 8), Axis::NEG_Y))
    );
    assert_eq!(at(between(&level, ints(-5000, 8), ints(5000, 8))), None);
    let room = map(".").with_outside(Outside::Solid);
    assert_eq!(at(between(&room, ints(8, 8), ints(100, 100))), Some((ints(16, 16), Axis::NEG_X)));
    assert!(room.line_of_sight(ints(1, 1), ints(15, 15)).unwrap());
    assert!(!room.line_of_sight(ints(1, 1), ints(16, 15)).unwrap());
    assert!(!room.line_of_sight(ints(20, 1), ints(21, 1)).unwrap()); // in the wall
}

/// A disc that touches a floor or another disc closes the way along the tangent: behind the point
/// is solid.
#[test]
fn into_the_gap_between_an_arc_and_what_it_touches() {
    static IDS: TileKinds = TileKinds::EMPTY
        .with(1, TileKind::FULL)
        .with(10, TileKind::of(TileShape::ConvexTopLeft))
        .with(13, TileKind::of(TileShape::ConvexBottomLeft));
    let grid = |width, height| tilesat::Grid::new(width, height, Fx::from_bits(256), Vec2::ZERO).unwrap();
    let raw = Vec2::from_raw;
    for (tiles, width) in [(&[1, 10, 1, 13][..], 2), (&[1, 10, 1, 1], 2), (&[1, 10, 0, 1, 1, 1], 3)] {
        let map = TileMap::<AllShapes>::of(tiles, grid(width, 2), &IDS).unwrap();
        let hit = map.cast_ray(raw(512, 256), raw(-400, 0), Inside::Hit).unwrap().unwrap();
        assert_eq!((hit.point, hit.axis, hit.cell.x, hit.inside), (raw(256, 256), Axis::X, 0, false));
        assert_eq!(hit.toi.raw(), (256u64 << 30).div_euclid(400) as u32);
        assert!(!map.line_of_sight(raw(512, 256), raw(112, 256)).unwrap());
        // Exactly to the point is a hit, one raw less is not.
        assert!(map.cast_ray(raw(512, 256), raw(-256, 0), Inside::Hit).unwrap().is_some());
        assert!(map.cast_ray(raw(512, 256), raw(-255, 0), Inside::Hit).unwrap().is_none());
        // Out of it, it is free.
        assert!(map.cast_ray(raw(256, 256), raw(256, 0), Inside::Hit).unwrap().is_none());
    }
    // Turned: along a column.
    let map = TileMap::<AllShapes>::of(&[1, 1, 10, 1], grid(2, 2), &IDS).unwrap();
    let hit = map.cast_ray(raw(256, 512), raw(0, -300), Inside::Ignore).unwrap().unwrap();
    assert_eq!((hit.point, hit.axis), (raw(256, 256), Axis::Y));
}
