//! Walkers at the edge of the domain and in the solid.

use tilesat::{
    Aabb, Axis, Cell, Fx, Mover, TileKind, TileKinds, TileMap, Vec2, Walker,
    motion::{StartInside, Support},
};

static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
const UP: Mover = Mover::platformer(Axis::NEG_Y);

fn v(x: i16, y: i16) -> Vec2 {
    Vec2::from_ints(x, y)
}

fn boxed(x: i16, y: i16, w: i16, h: i16) -> Aabb {
    Aabb::new(v(x, y), v(x + w, y + h)).unwrap()
}

fn map(rows: &str, x: i16, y: i16) -> TileMap<'_> {
    TileMap::from_ascii(rows, &KINDS).unwrap().with_origin(v(x, y)).unwrap()
}

/// A step whose way up leaves the domain does not lead through the ceiling. The walker climbs it
/// with the available room.
#[test]
fn a_step_up_to_the_edge() {
    let closed = map("........\n########\n#......#\n#...#..#\n########", 0, -8180);
    let open = map("........\n........\n.......#\n....#..#\n########", 0, -8180);
    for step in [20, 60, 61, 62, 200, 4000] {
        let walker = Walker::new(UP).with_step(Fx::from_num(step)).unwrap();
        for map in [&closed, &open] {
            let mut at = walker.walk(map, &boxed(40, -8130, 8, 14), v(0, 1), None).unwrap();
            let mut climbed = false;
            for _ in 0..20 {
                at = walker.walk(map, &at.moved.body, v(2, 1), at.floor).unwrap();
                let y = at.moved.body.min().y;
                assert!((-8146..=-8130).contains(&y.to_num::<i32>()), "{step}: {:?}", at.moved);
                climbed |= at.on_floor() && y == -8146;
            }
            assert!(climbed, "{step}: {:?}", at.moved);
        }
    }
}

/// A snap longer than the way to the edge finds the same floor as a shorter one.
#[test]
fn a_snap_to_the_edge() {
    for y in [8100, 8143] {
        let map = map("        \n        \n########", 0, y);
        for snap in [0, 1, 10, 20, 50, 80, 100, 4000] {
            let walker = Walker::new(UP).with_snap(Fx::from_num(snap)).unwrap();
            let landed = walker.walk(&map, &boxed(20, y + 18, 8, 14), v(0, 1), None).unwrap();
            assert!(landed.on_floor(), "{y} {snap}");
            let above = walker.walk(&map, &boxed(20, y + 17, 8, 14), v(0, 0), landed.floor).unwrap();
            assert_eq!((above.on_floor(), above.snapped), (snap > 0, Fx::from_num(i32::from(snap > 0))), "{y} {snap}");
        }
    }
}

/// A body that starts in the solid and ignores it returns into it if a step fails, and continues.
/// The debug build checks each position.
#[test]
fn steps_out_of_the_solid() {
    let map = map("......\n..#...\n.##...\n######", 0, 0);
    let floor = Support { axis: Axis::NEG_Y, cell: Cell::default(), index: 0, flags: 0, one_way: false, source: 0 };
    for (step, snap) in [(0, 0), (9, 20), (18, 0), (40, 40)] {
        let walker = Walker::new(UP.with_inside(StartInside::Ignore));
        let walker = walker.with_step(Fx::from_num(step)).unwrap().with_snap(Fx::from_num(snap)).unwrap();
        for x in -24..64 {
            for y in [10, 14, 29, 30, 33, 44] {
                for (width, height) in [(20, 4), (8, 14)] {
                    for speed in [-20, 3, 20] {
                        let body = boxed(x, y, width, height);
                        let walked = walker.walk(&map, &body, v(speed, 0), Some(floor)).unwrap();
                        let after = map.overlaps(&walked.moved.body);
                        assert!(!after || map.overlaps(&body), "{body:?} {:?}", walked.moved);
                    }
                }
            }
        }
    }
}
