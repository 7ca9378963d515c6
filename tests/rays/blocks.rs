//! Rays through named scenes, and cases of other engines' tests about a ray against a box.

use tilesat::{Axis, Cell, Fx, Inside, Outside, Quantity, RangeError, RayHit, TileKind, TileKinds, TileMap, Toi, Vec2};

static KINDS: TileKinds = TileKinds::EMPTY
    .with(b'#', TileKind::FULL)
    .with(b'-', TileKind::ONE_WAY_UP)
    .with(b'!', TileKind::FULL.with_flags(8));

fn map(text: &str) -> TileMap<'_> {
    TileMap::from_ascii(text, &KINDS).unwrap()
}

fn raw(x: i32, y: i32) -> Vec2 {
    Vec2::from_raw(x, y)
}

fn ints(x: i16, y: i16) -> Vec2 {
    Vec2::from_ints(x, y)
}

fn between(map: &TileMap, from: Vec2, to: Vec2) -> Option<RayHit> {
    map.cast_ray(from, to - from, Inside::Ignore).unwrap()
}

/// The box `[-1, 1]^2` of box2d's `AABBRayCastTest`, in units, as one tile.
fn unit_box() -> TileMap<'static> {
    map("#").with_cell(Fx::lit("2")).unwrap().with_origin(ints(-1, -1)).unwrap()
}

#[test]
fn ray_against_one_box() {
    let map = unit_box();
    let third = Toi::from_raw((1 << 30) / 3).unwrap();
    for (from, to, axis, point) in [
        (ints(-3, 0), ints(3, 0), Axis::NEG_X, ints(-1, 0)),
        (ints(3, 0), ints(-3, 0), Axis::X, ints(1, 0)),
        (ints(0, -3), ints(0, 3), Axis::NEG_Y, ints(0, -1)),
        (ints(0, 3), ints(0, -3), Axis::Y, ints(0, 1)),
    ] {
        let hit = between(&map, from, to).unwrap();
        assert_eq!((hit.toi, hit.axis, hit.point, hit.inside), (third, axis, point, false));
    }
    assert_eq!(between(&map, ints(-3, 2), ints(3, 2)), None);
    assert_eq!(between(&map, ints(2, -3), ints(2, 3)), None);
    assert_eq!(between(&map, ints(0, 0), ints(3, 0)), None);
    let corner = between(&map, ints(-2, -2), ints(2, 2)).unwrap();
    assert_eq!((corner.toi, corner.axis, corner.point), (Toi::from_raw(1 << 28).unwrap(), Axis::NEG_X, ints(-1, -1)));
    assert_eq!(between(&map, raw(-3 << 16, 3 << 15), raw(3 << 16, 3 << 15)), None);
    // Exactly along a side: closed.
    let along = between(&map, ints(-2, 1), ints(2, 1)).unwrap();
    assert_eq!((along.toi, along.axis, along.point), (Toi::from_raw(1 << 28).unwrap(), Axis::NEG_X, ints(-1, 1)));
    assert_eq!(between(&map, ints(-5, 0), ints(-2, 0)), None);
    assert_eq!(between(&map, ints(-2, 0), ints(-2, 0)), None);
    assert_eq!(between(&map, ints(-2, 0), ints(-1, 0)).unwrap().toi, Toi::ONE);
    let offset = map.with_origin(ints(99, -51)).unwrap();
    assert_eq!(between(&offset, ints(97, -50), ints(103, -50)).unwrap().toi, third);
}

/// impact-rs: the answer of 4/3 motions, for which its own test expects 1.33332. Here as 2/3 of
/// twice the motion, exactly floored.
#[test]
fn ray_against_a_far_box() {
    // 6 x 8 units from (5, 6): tiles of 2 units.
    let map = map("###\n###\n###\n###").with_cell(Fx::lit("2")).unwrap().with_origin(ints(5, 6)).unwrap();
    let hit = map.cast_ray(ints(1, 2), ints(6, 8), Inside::Ignore).unwrap().unwrap();
    assert_eq!((hit.toi.raw(), hit.axis, hit.point.x), ((2 << 30) / 3, Axis::NEG_X, Fx::lit("5")));
    assert_eq!(hit.point.y, Fx::from_bits((2 << 16) + (16 << 16) / 3));
}

/// parry's segment and triangle cases, as far as a box has them: on the surface, just outside,
/// pointing away, including the ends.
#[test]
fn ray_at_a_wall() {
    // A wall of x in [0, 2], y in [-10, 10].
    let map = map("#\n#\n#\n#\n#\n#\n#\n#\n#\n#").with_cell(Fx::lit("2")).unwrap().with_origin(ints(0, -10)).unwrap();
    let right = |x, y| map.cast_ray(ints(x, y), ints(20, 0), Inside::Ignore).unwrap();
    assert_eq!(right(-1, 0).unwrap().point, ints(0, 0));
    assert_eq!(right(3, 0), None);
    assert_eq!(right(2, 0), None); // leaving
    assert_eq!(right(0, 3).unwrap().toi, Toi::ZERO);
    assert_eq!((right(0, 11), right(0, -11)), (None, None));
    assert_eq!(right(-10, 10).unwrap().point, ints(0, 10)); // its end
    assert_eq!(right(1, 0), None);
    let inside = map.cast_ray(ints(1, 0), ints(20, 0), Inside::Hit).unwrap().unwrap();
    assert_eq!((inside.toi, inside.axis, inside.inside), (Toi::ZERO, Axis::NEG_X, true));
    // Parallel, beside it and along its side; and from its top downward.
    assert_eq!(between(&map, ints(-1, -20), ints(-1, 20)), None);
    assert_eq!(between(&map, ints(0, -20), ints(0, 20)).unwrap().point, ints(0, -10));
    assert_eq!(between(&map, ints(0, -10), ints(0, 20)), None);
    assert_eq!(between(&map, ints(1, -10), ints(1, 20)).unwrap().toi, Toi::ZERO);
}

/// Torture scene 15: along the line between two rows, with solid above, below, on both sides, on
/// none.
#[test]
fn along_a_grid_line() {
    for (text, place) in [
        ("......#...\n..........\n..........", Some(6)),
        ("..........\n......#...\n..........", Some(6)),
        ("......#...\n......#...\n..........", Some(6)),
        ("..........\n..........\n......#...", None),
        ("....#.....\n......#...\n..........", Some(4)),
    ] {
        let level = map(text);
        let hit = between(&level, ints(0, 16), ints(160, 16));
        assert_eq!(hit.map(|h| (h.point, h.axis)), place.map(|c| (ints(c * 16, 16), Axis::NEG_X)));
        let back = between(&level, ints(160, 16), ints(0, 16));
        let last = place.map(|_| (ints(112, 16), Axis::X));
        assert_eq!(back.map(|h| (h.point, h.axis)), last);
        // Transposed: the same along a line between two columns.
        let rows: Vec<&[u8]> = text.split('\n').map(str::as_bytes).collect();
        let turned: Vec<String> = (0..10).map(|x| rows.iter().map(|r| r[x] as char).collect()).collect();
        let turned = turned.join("\n");
        let hit = between(&map(&turned), ints(16, 0), ints(16, 160));
        assert_eq!(hit.map(|h| (h.point, h.axis)), place.map(|c| (ints(16, c * 16), Axis::NEG_Y)));
    }
}

/// Torture scene 16: through a grid corner.
#[test]
fn through_a_grid_corner() {
    let cast = |text| between(&map(text), ints(0, 0), ints(64, 64));
    let at = |hit: Option<RayHit>| hit.map(|h| (h.point, h.axis, h.cell));
    assert_eq!(at(cast(".#..\n#...\n....\n....")), Some((ints(16, 16), Axis::NEG_X, Cell::new(1, 0))));
    assert_eq!(at(cast(".#..\n....\n....\n....")), Some((ints(16, 16), Axis::NEG_X, Cell::new(1, 0))));
    assert_eq!(at(cast("....\n#...\n....\n....")), Some((ints(16, 16), Axis::NEG_Y, Cell::new(0, 1))));
    assert_eq!(at(cast("....\n.#..\n....\n....")), Some((ints(16, 16), Axis::NEG_X, Cell::new(1, 1))));
    assert_eq!(at(cast("....\n....\n....\n....")), None);
    // None on the way: four cells on the diagonal, and three corners of two lines each. The wall
    // beyond counts the work.
    let end = cast("....\n....\n....\n...#").unwrap();
    assert_eq!((end.point, end.cells), (ints(48, 48), 7));
    // From the other side, and the other diagonal.
    assert_eq!(at(between(&map(".#\n#."), ints(32, 32), ints(0, 0))), Some((ints(16, 16), Axis::X, Cell::new(0, 1))));
    assert_eq!(at(between(&map("#.\n.#"), ints(32, 0), ints(0, 32))), Some((ints(16, 16), Axis::X, Cell::new(0, 0))));
}

/// Torture scene 17: starts on a cell's border, in four directions, at negative coordinates.
#[test]
fn starts_on_a_border() {
    // Cells of one unit; the tile at (-2, -1) is solid, so its sides are x = -2 and -1, y = -1 and
    // 0.
    let map = map("...\n.#.\n...").with_cell(Fx::lit("1")).unwrap().with_origin(ints(-3, -2)).unwrap();
    let cast = |x: i32, y: i32, dx, dy| {
        let hit = map.cast_ray(raw(x, y), ints(dx, dy), Inside::Ignore).unwrap();
        hit.map(|h| (h.toi.raw(), h.axis, h.cell))
    };
    let one = 1 << 16;
    let cell = Cell::new(1, 1);
    let mid = -one / 2;
    assert_eq!(cast(-2 * one, mid, 1, 0), Some((0, Axis::NEG_X, cell)));
    assert_eq!(cast(-2 * one, mid, -1, 0), None);
    assert_eq!(cast(-one, mid, -1, 0), Some((0, Axis::X, cell)));
    assert_eq!(cast(-one, mid, 1, 0), None);
    assert_eq!(cast(-3 * one / 2, -one, 0, 1), Some((0, Axis::NEG_Y, cell)));
    assert_eq!(cast(-3 * one / 2, -one, 0, -1), None);
    assert_eq!(cast(-3 * one / 2, 0, 0, -1), Some((0, Axis::Y, cell)));
    assert_eq!(cast(-3 * one / 2, 0, 0, 1), None);
    // One raw outside the border: -1 raw lies in cell -1, not in cell 0.
    assert_eq!(map.cell_at(raw(-1, -1)), Cell::new(2, 1));
    assert_eq!(map.cell_at(raw(0, 0)), Cell::new(3, 2));
    assert_eq!(cast(-2 * one - 1, mid, 1, 0), Some((1 << 14, Axis::NEG_X, cell)));
    assert_eq!(cast(-one + 1, mid, -1, 0), Some((1 << 14, Axis::X, cell)));
    assert_eq!(cast(-2 * one + 1, mid, 1, 0), None); // inside
    // At the corner of the tile: into it, along its sides, away.
    assert_eq!(cast(-2 * one, -one, 1, 1), Some((0, Axis::NEG_X, cell)));
    assert_eq!(cast(-2 * one, -one, 1, 0), None);
    assert_eq!(cast(-2 * one, -one, 0, 1), None);
    assert_eq!(cast(-2 * one, -one, -1, 1), None);
}

/// Torture scene 18: rays of no length.
#[test]
fn no_length() {
    let map = map("..\n.#");
    let cast = |p, inside| map.cast_ray(p, Vec2::ZERO, inside).unwrap();
    for p in [ints(8, 8), ints(16, 16), ints(16, 24), ints(-100, 0)] {
        assert_eq!((cast(p, Inside::Ignore), cast(p, Inside::Hit)), (None, None));
    }
    assert_eq!(cast(ints(24, 24), Inside::Ignore), None);
    let hit = cast(ints(24, 24), Inside::Hit).unwrap();
    assert_eq!(
        (hit.toi, hit.point, hit.axis, hit.cell, hit.inside),
        (Toi::ZERO, ints(24, 24), Axis::X, Cell::new(1, 1), true)
    );
}

/// Torture scene 20: exactly to the surface, and one raw short of it.
#[test]
fn exactly_to_the_surface() {
    let map = map("....\n..#.\n....");
    for (from, to) in [
        (ints(3, 20), ints(32, 20)),
        (ints(60, 30), ints(48, 30)),
        (ints(40, 0), ints(40, 16)),
        (ints(33, 48), ints(33, 32)),
    ] {
        let hit = between(&map, from, to).unwrap();
        assert_eq!((hit.toi, hit.point), (Toi::ONE, to));
        let d = to - from;
        let short = |v: Fx| Fx::from_bits(v.to_bits() - v.to_bits().signum());
        assert_eq!(map.cast_ray(from, Vec2::new(short(d.x), short(d.y)), Inside::Ignore).unwrap(), None);
    }
    // The corner as the last point.
    assert_eq!(between(&map, ints(16, 0), ints(32, 16)).unwrap().toi, Toi::ONE);
    assert_eq!(map.cast_ray(ints(16, 0), raw((16 << 16) - 1, 16 << 16), Inside::Ignore).unwrap(), None);
}

/// Torture scene 21: a ray at the joint of two tiles of a wall has one hit, on the wall.
#[test]
fn at_the_joint_of_two_tiles() {
    let map = map("..#\n..#\n..#");
    for (from, to) in [(ints(0, 16), ints(40, 16)), (ints(16, 0), ints(48, 32)), (ints(0, 48), ints(48, 0))] {
        let hit = between(&map, from, to).unwrap();
        assert_eq!((hit.point.x, hit.axis), (Fx::lit("32"), Axis::NEG_X));
    }
}

/// Torture scene 35: rays pass one-way edges from both sides.
#[test]
fn one_way_edges_are_passed() {
    let map = map("...\n---\n...\n###");
    let down = between(&map, ints(8, 8), ints(8, 60)).unwrap();
    assert_eq!((down.point, down.cell), (ints(8, 48), Cell::new(0, 3)));
    assert_eq!(between(&map, ints(8, 40), ints(8, 0)), None);
}

#[test]
fn from_inside_to_the_next_wall() {
    let map = map("##.!");
    let cast = |inside| map.cast_ray(ints(4, 8), ints(60, 0), inside).unwrap();
    let hit = cast(Inside::Ignore).unwrap();
    assert_eq!((hit.point, hit.flags, hit.inside, hit.cells), (ints(48, 8), 8, false, 4));
    assert!(cast(Inside::Hit).unwrap().inside);
    // The line between two full tiles is inside, the end of that line is not.
    assert!(map.cast_ray(ints(16, 8), ints(4, 0), Inside::Hit).unwrap().unwrap().inside);
    assert_eq!(map.cast_ray(ints(16, 0), ints(4, 0), Inside::Hit).unwrap(), None);
    assert_eq!(
        map.cast_ray(ints(16, 0), ints(4, 9), Inside::Hit).unwrap().map(|h| (h.axis, h.inside)),
        Some((Axis::NEG_Y, false))
    );
}

#[test]
fn the_three_outsides() {
    let text = "...\n..#\n...";
    let from = ints(8, 24);
    let cast = |outside, to: Vec2| map(text).with_outside(outside).cast_ray(from, to, Inside::Ignore).unwrap();
    assert_eq!(cast(Outside::Empty, ints(-8000, 5000)), None);
    let wall = cast(Outside::Solid, ints(-8000, 5000)).unwrap();
    assert_eq!((wall.point, wall.axis, wall.cell), (ints(0, 29), Axis::X, Cell::new(-1, 1)));
    assert_eq!(cast(Outside::Edge, ints(-8000, 5000)), None);
    // A solid tile on the border is a band without end.
    let map = map(text).with_outside(Outside::Edge);
    let hit = map.cast_ray(ints(5000, -1000), ints(100, 2000), Inside::Ignore).unwrap().unwrap();
    assert_eq!((hit.point.y, hit.axis, hit.cell), (Fx::lit("16"), Axis::NEG_Y, Cell::new(2, 1)));
    assert!(hit.cells <= 10);
}

#[test]
fn the_work_is_bounded_by_the_map_not_the_distance() {
    let map = map("...\n...\n..#").with_cell(Fx::from_bits(256)).unwrap();
    let far = (1 << 29) - 1;
    let hit = map.cast_ray(raw(-far, -far), raw(far + 600, far + 520), Inside::Ignore).unwrap().unwrap();
    assert_eq!(hit.cell, Cell::new(2, 2));
    assert!(hit.cells <= 10);
}

#[test]
fn what_is_out_of_the_domain_is_refused() {
    let map = map("#");
    let cast = |o, d| map.cast_ray(o, d, Inside::Ignore).unwrap_err();
    let error = |what, value| RangeError { what, value };
    let end = 1 << 29;
    assert_eq!(cast(raw(end, 0), Vec2::ZERO), error(Quantity::X, end));
    assert_eq!(cast(raw(0, -end), Vec2::ZERO), error(Quantity::Y, -end));
    assert_eq!(cast(raw(1, 0), raw(end - 1, 0)), error(Quantity::EndX, end));
    assert_eq!(cast(raw(0, -1), raw(0, 1 - end)), error(Quantity::EndY, -end));
    for d in [i32::MIN, i32::MAX] {
        assert_eq!(cast(raw(end - 1, 0), raw(d, 0)), error(Quantity::EndX, d.saturating_add(end - 1)));
        assert_eq!(cast(raw(1 - end, 0), raw(0, d)), error(Quantity::EndY, d));
    }
    assert!(map.cast_ray(raw(1 - end, 1 - end), raw(2 * end - 2, 2 * end - 2), Inside::Ignore).is_ok());
}
