//! Boxes whose corner is on a point where two tiles meet corner to corner, with an open wedge
//! between them.

use tilesat::{Aabb, AllShapes, Axis, Fx, Grid, Mover, TileKind, TileKinds, TileMap, TileShape, Vec2};

const KINDS: TileKinds = TileKinds::EMPTY
    .with(1, TileKind::of(TileShape::SlopeTopLeft))
    .with(2, TileKind::of(TileShape::SlopeTopRight))
    .with(3, TileKind::of(TileShape::SlopeBottomRight))
    .with(4, TileKind::of(TileShape::MildHighTopRight));

/// The way of a box of 10 x 10 whose upper right corner is in the middle of four tiles.
fn way(tiles: [u8; 4], motion: Vec2) -> Vec2 {
    way_in(&KINDS, tiles, motion).unwrap()
}

/// The same among other kinds of tiles. `None` if the box is in the solid.
fn way_in(kinds: &TileKinds, tiles: [u8; 4], motion: Vec2) -> Option<Vec2> {
    let grid = Grid::new(2, 2, Fx::from_num(16), Vec2::ZERO).unwrap();
    let map = TileMap::<AllShapes>::of(&tiles, grid, kinds).unwrap();
    let body = Aabb::new(Vec2::from_ints(6, 16), Vec2::from_ints(16, 26)).unwrap();
    let moved = Mover::platformer(Axis::NEG_Y).move_and_slide(&map, &body, motion).ok()?;
    Some(moved.body.min() - body.min())
}

/// One solid hides a side of the corner of the other. The box can move only along the other side,
/// and nothing is in its way there.
#[test]
fn slides_past_a_pinch() {
    // Up along the left side of the upper tile; the slope of the lower one hides the tip's
    // underside.
    assert_eq!(way([0, 1, 0, 2], Vec2::from_ints(1, -2)), Vec2::from_ints(0, -2));
    // To the right along the underside; the slope left of the tip hides its left side.
    assert_eq!(way([4, 3, 0, 0], Vec2::from_ints(2, -1)), Vec2::from_ints(2, 0));
    assert_eq!(way([2, 3, 0, 0], Vec2::from_ints(2, -1)), Vec2::from_ints(2, 0));
}

/// The part of those motions along that side is free.
#[test]
fn goes_along_the_open_side() {
    assert_eq!(way([0, 1, 0, 2], Vec2::from_ints(0, -2)), Vec2::from_ints(0, -2));
    assert_eq!(way([4, 3, 0, 0], Vec2::from_ints(2, 0)), Vec2::from_ints(2, 0));
    assert_eq!(way([2, 3, 0, 0], Vec2::from_ints(2, 0)), Vec2::from_ints(2, 0));
}

/// All shapes in the three cells around the corner of the box, motions of every slope of the
/// shapes. If one component alone is free, the box does not stand still.
#[test]
fn never_stands_where_one_way_is_open() {
    const MOTIONS: [(i16, i16); 3] = [(1, 1), (1, 2), (2, 1)];
    let way = |kinds: &TileKinds, x: i16, y: i16| way_in(kinds, [1, 2, 0, 3], Vec2::from_ints(x, y));
    let mut stands = 0u32;
    for a in TileShape::ALL {
        for b in TileShape::ALL {
            for c in TileShape::ALL {
                let kinds =
                    &TileKinds::EMPTY.with(1, TileKind::of(a)).with(2, TileKind::of(b)).with(3, TileKind::of(c));
                for (x, y) in MOTIONS.into_iter().flat_map(|(x, y)| [(x, -y), (x, y), (-x, -y)]) {
                    if way(kinds, x, y) == Some(Vec2::ZERO) {
                        stands += 1;
                        let open = way(kinds, x, 0) == Some(Vec2::from_ints(x, 0))
                            || way(kinds, 0, y) == Some(Vec2::from_ints(0, y));
                        assert!(!open, "{a:?}, {b:?}, {c:?} by ({x}, {y})");
                    }
                }
            }
        }
    }
    assert!(stands > 10_000, "{stands}");
}
