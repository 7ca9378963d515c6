//! Chains that carry only from above, even around convex corners.

use tilesat::{Aabb, Axis, Body, Circle, Fx, Moved, Mover, Path, PathKind, SegmentMap, Vec2};

fn raw(x: i64, y: i64) -> Vec2 {
    Vec2::from_raw(x as i32, y as i32)
}

fn build(points: &[Vec2], cell: i32, then: impl FnOnce(&SegmentMap<'_>)) {
    let paths = [Path::new(PathKind::OneWay, points)];
    let cell = Fx::from_bits(cell);
    let mut bytes = vec![0; SegmentMap::measure(&paths, cell).unwrap().bytes()];
    SegmentMap::build_into(&paths, cell, &mut bytes).unwrap();
    then(&SegmentMap::from_bytes(&bytes).unwrap());
}

fn square(x: i64, y: i64, half: i64) -> Aabb {
    Aabb::new(raw(x - half, y - half), raw(x + half, y + half)).unwrap()
}

fn disc(x: i64, y: i64, r: i64) -> Circle {
    Circle::new(raw(x, y), Fx::from_bits(r as i32)).unwrap()
}

/// A bend of two thousandths, hit head-on and one and two raw beside it.
#[test]
fn a_kink_is_no_hole() {
    build(&[raw(-100_000, 100), raw(0, 0), raw(100_000, 100)], 4096, |map| {
        let mover = Mover::platformer(Axis::NEG_Y);
        for x in [-500, -2, -1, 0, 1, 2, 500] {
            let fall = raw(0, 8000);
            let moved = mover.move_and_slide(map, &square(x, -5000, 1000), fall).unwrap();
            assert!(moved.floor && moved.body.max().raw().1 <= 100, "box at {x}: {moved:?}");
            let moved = mover.move_and_slide(map, &disc(x, -5000, 1000), fall).unwrap();
            assert!(moved.floor && moved.position().raw().1 <= -900, "circle at {x}: {moved:?}");
            // It passes from below, and from the side below it.
            for d in [raw(0, -8000), raw(3000, -9000)] {
                assert!(mover.move_and_slide(map, &square(x, 3000, 1000), d).unwrap().hits.is_empty());
                assert!(mover.move_and_slide(map, &disc(x, 3000, 1000), d).unwrap().hits.is_empty());
            }
        }
    });
}

fn walk<B: Body>(map: &SegmentMap<'_>, mut body: B, speed: i64, gravity: i64, height: impl Fn(&B) -> i64) {
    let mut fall = 0;
    for frame in 0..40_000 {
        let Moved { body: next, floor, velocity, .. } =
            Mover::platformer(Axis::NEG_Y).move_and_slide(map, &body, raw(speed, fall + gravity)).unwrap();
        body = next;
        fall = if floor { 0 } else { i64::from(velocity.raw().1) };
        let x = i64::from(body.position().raw().0);
        if x > 300 << 16 {
            return;
        }
        assert!(height(&body) <= 50 << 16, "fell in frame {frame} at {}", x >> 16);
    }
    panic!("did not get over it");
}

/// A box and a ball walk over a bridge like a parabola, 320 units wide and 40 high, of few and many
/// pieces.
#[test]
fn over_a_bridge() {
    for pieces in [4i64, 9, 32, 128] {
        let points: Vec<Vec2> = (0..=pieces)
            .map(|k| {
                let x = (320 << 16) * k / pieces;
                let u = x - (160 << 16);
                raw(x, (u / 160 * (u / 160) / (1 << 16)) * 40)
            })
            .collect();
        build(&points, 32 << 16, |map| {
            for (speed, gravity) in [(2 << 16, 1 << 14), (1 << 15, 1 << 14), (2 << 16, 1 << 12)] {
                walk(map, square(20 << 16, 0, 6 << 16), speed, gravity, |b| i64::from(b.max().raw().1));
                walk(map, disc(20 << 16, 0, 6 << 16), speed, gravity, |b| i64::from(b.centre().raw().1));
            }
        });
    }
}
