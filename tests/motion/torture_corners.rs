//! Corners of polygons and walls, numbered as the torture scenes. Each in eight views, far from the
//! origin, and with its paths in either order.

use tilesat::shape::{AnyShape, Compound};
use tilesat::{
    Aabb, Axis, ConvexPolygon, Fx, Mover, OrientedBox, PathKind, Response, TileKind, TileKinds, TileMap, Vec2, fx,
};
use tilesat_judge::drawing::{Drawing, VIEWS, at, axes, disc, parts, rect};
use tilesat_judge::rooms::PX;
use tilesat_judge::rooms::body::Body;

const CELL: i64 = 16 * PX;

fn same(m: Mover) -> Mover {
    m
}

fn touch(m: Mover) -> Mover {
    m.with_response(Response::Touch)
}

/// Floor y = 100 and wall x = 100: two walls in one chain, two chains, two boxes that touch, two
/// that overlap.
fn rooms() -> Vec<Drawing> {
    let (a, b, c) = (at(0, 100), at(100, 100), at(100, 0));
    vec![
        Drawing::new(CELL, &[(PathKind::Wall, &[a, b, c])]),
        Drawing::new(CELL, &[(PathKind::Wall, &[a, b]), (PathKind::Wall, &[c, b])]),
        Drawing::of(CELL, vec![Drawing::block(a, at(100, 140)), Drawing::block(c, at(140, 140))]),
        Drawing::of(CELL, vec![Drawing::block(a, at(140, 140)), Drawing::block(c, at(140, 140))]),
        Drawing::new(CELL, &[(PathKind::Solid, &[a, b, c, at(140, 0), at(140, 140), at(0, 140)])]),
    ]
}

#[test]
fn scenes_4_and_5_into_an_inside_corner() {
    for room in rooms() {
        for (body, end) in [(rect(72, 72, 16, 16), rect(84, 84, 16, 16)), (disc(80, 80, 8), disc(92, 92, 8))] {
            let out = room.step(body, at(40, 40), same);
            assert_eq!((out.body, out.v, out.hits.len()), (end, (0, 0), 2), "{body:?} in {room:?}");
            // Floor and wall at one moment and equally opposed: x first.
            assert_eq!(axes(&out), [(-1, 0), (0, -1)]);
            assert_eq!(out.hits.first().unwrap().toi.raw(), parts(3, 10));
            assert!(out.floor && out.wall && !out.ceiling);
            for v in [at(40, 39), at(39, 40), at(4000, 4000), at(13, 12)] {
                let near = if matches!(body, Body::Rect(..)) { rect(83, 83, 16, 16) } else { disc(91, 91, 8) };
                let out = room.step(near, v, same);
                assert_eq!((out.body, out.v), (end, (0, 0)), "{near:?} by {v:?} in {room:?}");
            }
            // It stays in the corner, whatever pushes, and leaves it freely.
            assert_eq!(room.step(end, at(7, 9), same).body, end);
            let out = room.step(end, at(-3, -2), same);
            assert_eq!((out.body, out.hits.len()), (end.moved(at(-3, -2)), 0));
        }
    }
}

/// Box [20,40] x [3,30]: a square-cornered sum would be hit at 0.375.
#[test]
fn scene_6_outside_corner_is_round() {
    let block = Drawing::of(CELL, vec![Drawing::block(at(20, 3), at(40, 30))]);
    let out = block.step(disc(0, 0, 5), at(40, 0), touch);
    let hit = out.hits.first().unwrap();
    assert!(hit.index % 2 == 1, "a vertex");
    // A lower bound, less than a raw unit of way early.
    assert!(hit.toi.raw() <= parts(4, 10) && parts(4, 10) - hit.toi.raw() <= 1 << 30 >> 21, "{hit:?}");
    let Body::Disc(c, _) = out.body else { panic!() };
    assert!((16 * PX - 2..=16 * PX).contains(&c.0) && c.1 == 0, "{c:?}");
    // (-4, -3) to within a raw unit or two of the radius.
    let (x, y) = (i64::from(hit.axis.x), i64::from(hit.axis.y));
    assert!(x < 0 && y < 0 && (3 * x - 4 * y).abs() <= 16 * PX, "{hit:?}");
    // The box of the same size meets the face.
    let out = block.step(rect(-5, -5, 10, 10), at(40, 0), touch);
    assert_eq!((axes(&out), out.hits.first().unwrap().toi.raw()), (vec![(-1, 0)], parts(375, 1000)));
}

/// The centre passes (15.5, 15.5), 6.36 from the corner (20, 20).
#[test]
fn scene_7_outside_corner_miss() {
    let block = Drawing::of(CELL, vec![Drawing::block(at(20, 20), at(60, 60))]);
    let body = Body::Disc((11 * PX / 2, 51 * PX / 2), 5 * PX);
    for change in [same, touch, |m: Mover| m.with_response(Response::Bounce)] {
        let out = block.step(body, at(20, -20), change);
        assert_eq!((out.body, out.hits.len()), (body.moved(at(20, -20)), 0));
    }
    // With a radius of 6.36396 (6 + 23853/65536) it passes, one raw unit more is a hit: 4.5^2 +
    // 4.5^2 = 40.5.
    let limit = (81i64 * PX * PX / 2).isqrt();
    for (r, hits) in [(limit, 0), (limit + 1, 1)] {
        let Body::Disc(c, _) = body else { panic!() };
        assert_eq!(block.step(Body::Disc(c, r), at(20, -20), touch).hits.len(), hits, "{r}");
    }
}

/// A peak at (16, 40), of a polygon, of walls, of a chain that faces up.
#[test]
fn scene_9_vertex_head_on() {
    let points = [at(0, 56), at(16, 40), at(32, 56)];
    let apart = [(PathKind::Wall, &points[..2]), (PathKind::Wall, &points[1..])];
    let peaks = [
        Drawing::new(CELL, &[(PathKind::Solid, &points)]),
        Drawing::new(CELL, &[(PathKind::Wall, &points)]),
        Drawing::new(CELL, &[(PathKind::OneWay, &points)]),
        Drawing::new(CELL, &apart),
    ];
    for peak in peaks {
        let out = peak.step(disc(16, 0, 8), at(0, 64), touch);
        let hit = out.hits.first().unwrap();
        assert_eq!(axes(&out), [(0, -1)], "{peak:?}");
        assert!(hit.toi.raw() <= 1 << 29 && (1 << 29) - hit.toi.raw() <= 512, "{hit:?}");
        let end = out.body.position();
        assert!(end.0 == 16 * PX && (0..=1).contains(&(32 * PX - end.1)), "{end:?}");
        // It stays on it, and a bounce is exact.
        let out = peak.step(disc(16, 0, 8), at(0, 64), same);
        assert_eq!((out.body.position().0, out.v), (16 * PX, (0, 0)));
        let out = peak.step(disc(16, 0, 8), at(0, 64), |m| m.with_response(Response::Bounce));
        assert_eq!((out.body.position().0, out.v), (16 * PX, at(0, -64)));
        // A box lands on it with its middle, and with all but a raw unit beside.
        for x in [8 * PX, PX + 1, 16 * PX - 1] {
            let out = peak.step(Body::Rect((x, 0), at(16, 16)), at(0, 64), same);
            assert_eq!((out.body.position(), out.v), ((x, 24 * PX), (0, 0)), "{peak:?}");
            assert_eq!((axes(&out), out.hits.first().unwrap().toi.raw()), (vec![(0, -1)], parts(24, 64)));
        }
    }
}

/// bump's perfect corner: (10,10,2,2) by (-9,-9) at (0,0,8,8). The tie goes to x in every view.
#[test]
fn scene_10_box_corner_onto_a_corner() {
    let block = [Drawing::block(at(0, 0), at(8, 8))];
    let loop_ = [at(0, 0), at(8, 0), at(8, 8), at(0, 8), at(0, 0)];
    for level in [Drawing::of(CELL, block.to_vec()), Drawing::new(CELL, &[(PathKind::Wall, &loop_)])] {
        let out = level.step_in(&VIEWS[..4], rect(10, 10, 2, 2), at(-9, -9), same);
        assert_eq!((axes(&out), out.body.position()), (vec![(1, 0)], at(8, 1)));
        assert_eq!(out.hits.first().unwrap().toi.raw(), parts(2, 9));
        // A raw unit more on one axis decides, and every view agrees.
        let x = level.step(rect(10, 10, 2, 2), (-9 * PX - 1, -9 * PX), same);
        let y = level.step(rect(10, 10, 2, 2), (-9 * PX, -9 * PX - 1), same);
        assert_eq!((axes(&x), axes(&y)), (vec![(0, 1)], vec![(1, 0)]));
        assert_eq!(x.body.position().0, y.body.position().1);
    }
}

/// bump's nasty corner: (0,16,16,16) by (-1,-1) beside (16,0,16,16); they share the corner (16,16).
#[test]
fn scene_11_shared_corner_is_no_hit() {
    let block = Drawing::of(CELL, vec![Drawing::block(at(16, 0), at(32, 16))]);
    for body in [rect(0, 16, 16, 16), disc(8, 24, 8)] {
        for v in [at(-1, -1), at(0, -1), at(1, 0), at(-1, 0), at(0, 1), at(1, 1)] {
            let out = block.step(body, v, same);
            assert_eq!((out.body, out.hits.len()), (body.moved(v), 0), "{body:?} by {v:?}");
        }
    }
    assert_eq!(block.step(rect(0, 16, 16, 16), (1, -2), same).hits.len(), 1);
}

/// A gap of 16 between two walls 64 thick, and bodies of exactly that width.
#[test]
fn scene_30_through_a_gap_of_ones_own_width() {
    let banks = vec![Drawing::block(at(0, 0), at(96, 64)), Drawing::block(at(112, 0), at(208, 64))];
    for gap in [Drawing::of(CELL, banks.clone()), Drawing::of(24 * PX, banks)] {
        for body in [rect(96, -40, 16, 16), disc(104, -32, 8)] {
            for speed in [1, 7, 40, 140, 4000] {
                let out = gap.step(body, at(0, speed), same);
                assert_eq!((out.body, out.hits.len()), (body.moved(at(0, speed)), 0));
            }
            let inside = body.moved(at(0, 60));
            for v in [at(3, 20), at(-3, 20), at(9, -20)] {
                let out = gap.step(inside, v, same);
                assert_eq!((out.body, out.v), (inside.moved((0, v.1)), (0, v.1)), "{inside:?} by {v:?}");
            }
        }
        // A diagonal that is aligned at the mouth enters. A raw unit to either side, it stops on
        // the top: the box exactly there.
        for (dx, enters) in [(-1, false), (0, true), (1, false)] {
            let body = Body::Rect((66 * PX + dx, -46 * PX), at(16, 16));
            // Aligned, it comes to a corner with its own: a tie between x and y.
            let out = gap.step_in(if enters { &VIEWS[..4] } else { &VIEWS }, body, at(90, 90), same);
            let (end, hit) = (out.body.position(), out.hits.first().unwrap());
            assert_eq!((end.1, hit.axis.y != 0), (if enters { 44 * PX } else { -16 * PX }, !enters), "{dx}: {out:?}");
            assert!(!enters || end.0 == 96 * PX);
            let body = Body::Disc((104 * PX + dx, -32 * PX), 8 * PX);
            let out = gap.step(body, at(0, 140), same);
            assert_eq!(out.hits.is_empty(), enters, "{dx}: {out:?}");
        }
    }
}

/// Whatever type a box has, it meets the corner of a block on the side that opposes the motion
/// more. The flags name the side that took the velocity.
#[test]
fn boxes_of_all_types_meet_a_corner_alike() {
    static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
    let level = TileMap::from_ascii("#", &KINDS).unwrap();
    let mover = Mover::platformer(Axis::NEG_Y);
    let mut met = 0;
    for (x, y) in (1..=12).flat_map(|x| (1..=12).map(move |y| (x, y))) {
        for (sx, sy) in [(1, 1), (1, -1), (-1, 1), (-1, -1)] {
            let v = Vec2::from_ints(2 * x * sx, 2 * y * sy);
            // Its front corner comes to that of the block in the middle of the motion.
            let corner = Vec2::from_ints(if sx > 0 { 0 } else { 16 }, if sy > 0 { 0 } else { 16 });
            let front = corner - v / fx!(2);
            let back = front - Vec2::from_ints(7 * sx, 5 * sy);
            let body = Aabb::new(front.min(back), front.max(back)).unwrap();
            macro_rules! moved {
                ($body:expr) => {{
                    let moved = mover.move_and_slide(&level, &$body, v).unwrap();
                    (moved.body.aabb(), moved.velocity, [moved.floor, moved.wall, moved.ceiling])
                }};
            }
            let due = moved!(body);
            let (lo, hi) = (body.min(), body.max());
            let corners = [lo, Vec2::new(hi.x, lo.y), hi, Vec2::new(lo.x, hi.y)];
            assert_eq!(moved!(ConvexPolygon::<4>::new(&corners).unwrap()), due, "{v}");
            assert_eq!(moved!(OrientedBox::new(body.centre(), body.size() / fx!(2), Axis::X).unwrap()), due, "{v}");
            assert_eq!(moved!(Compound::<Aabb, 2>::new(&[body]).unwrap()), due, "{v}");
            assert_eq!(moved!(AnyShape::<4>::from(body)), due, "{v}");
            let kept = if y > x { Vec2::new(v.x, Fx::ZERO) } else { Vec2::new(Fx::ZERO, v.y) };
            assert_eq!((due.1, due.2[1]), (kept, y <= x), "{v}");
            met += 1;
        }
    }
    assert_eq!(met, 12 * 12 * 4);
}
