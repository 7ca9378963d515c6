//! Polygons of slight bends: what fits goes through (L1, L3).
//!
//! The faces of such a floor are nearly one, and a wide body is near many of them.

use tilesat::{Aabb, Axis, Body, Capsule, Circle, ConvexPolygon, Fx, Mover, Path, PathKind, SegmentMap, Vec2};
use tilesat_judge::{Random, cases};

const UNIT: i64 = 1 << 16;

fn at(x: i64, y: i64) -> Vec2 {
    Vec2::from_raw(x as i32, y as i32)
}

/// A floor around y = 0 whose points are `step` apart and up to `high` raw higher or lower.
fn floor(r: &mut Random, step: i64, high: i64) -> Vec<u8> {
    let width = 64 * step;
    let bends = (0..=64).map(|k| at(k * step + r.below(step / 2), r.around(high)));
    let ends = [at(width + 40 * UNIT, 0), at(width + 40 * UNIT, 30 * UNIT), at(-40 * UNIT, 30 * UNIT)];
    let points: Vec<Vec2> = [at(-40 * UNIT, 0)].into_iter().chain(bends).chain(ends).collect();
    let mut bytes = vec![0; 1 << 16];
    let used = SegmentMap::build_into(&[Path::new(PathKind::Solid, &points)], Fx::from_num(16), &mut bytes).unwrap();
    bytes.truncate(used);
    bytes
}

/// Whether a body that is driven along the floor moves in each frame, to its end.
fn goes_along(map: &SegmentMap, body: impl Body, (speed, gravity): (i64, i64), width: i64) -> bool {
    let (mut body, mut fall, mover) = (body, 0, Mover::platformer(Axis::NEG_Y));
    for _ in 0..2 * (width + 40 * UNIT) / speed.abs() {
        let was = body.position();
        let moved = mover.move_and_slide(map, &body, at(speed, fall + gravity)).unwrap();
        (body, fall) = (moved.body, i64::from(moved.velocity.raw().1));
        let by = i64::from(body.position().raw().0 - was.raw().0) * speed.signum();
        if by <= 0 {
            println!("stops at {was:?} by {speed} and {gravity}");
            return false;
        }
        let x = i64::from(body.position().raw().0);
        if (speed > 0 && x > width + 8 * UNIT) || (speed < 0 && x < -8 * UNIT) {
            return true;
        }
    }
    panic!("{:?} did not come to the end by {speed} and {gravity}", body.position());
}

/// How many of some bodies go along floors of a step, and how many there are.
fn runs(step: i64, count: u32) -> (u32, u32) {
    let (mut r, mut goes) = (Random::new(29), 0);
    for n in 0..count {
        let high = r.within(1, 6);
        let bytes = floor(&mut r, step, high);
        let (map, width) = (SegmentMap::from_bytes(&bytes).unwrap(), 64 * step);
        let (size, speed) =
            (UNIT / 2 + r.below(3 * step.max(UNIT)), r.within(2_000, UNIT) * if r.one_in(2) { 1 } else { -1 });
        let run = (speed, [0, 500, 16_384][r.below(3) as usize]);
        let x = if speed > 0 { -12 * UNIT } else { width + 12 * UNIT };
        goes += u32::from(match n % 4 {
            0 | 1 => goes_along(&map, Aabb::new(at(x, -size - 8), at(x + size, -8)).unwrap(), run, width),
            2 => goes_along(&map, Circle::new(at(x, -size - 8), Fx::from_bits(size as i32)).unwrap(), run, width),
            _ => {
                let (a, b) = (at(x, -size - 8), at(x + size, -size - 8));
                goes_along(&map, Capsule::new(a, b, Fx::from_bits(size as i32)).unwrap(), run, width)
            }
        });
    }
    (goes, count)
}

#[test]
fn slight_bends_stop_nothing() {
    // On the shortest ones a body is near more than nine faces at once.
    for (step, count) in [(UNIT / 8, 400), (UNIT / 2, 130), (UNIT, 130), (2 * UNIT, 130)] {
        let (goes, all) = runs(step, cases(count));
        assert_eq!(goes, all);
    }
}

/// A box at the end of a floor touches the side below it, too, and goes past both.
#[test]
fn the_side_below_the_end_of_a_floor_stops_nothing() {
    for (points, lo, size, speed) in [
        // The end of the floor is below the middle of the box.
        ([at(53_812, 0), at(172_111, 47), at(262_144, -35)], (-88_375, -156_045), (312_090, 156_045), (20_440, 500)),
        // The box is beside the end, and slides down the side.
        ([at(0, 0), at(133_606, -198), at(262_144, 0)], (-52_542, -26_248), (52_541, 26_270), (33_666, 16_384)),
    ] {
        let rest = [at(262_144, 14_155_776), at(-262_144, 14_155_776)];
        let points: Vec<Vec2> = points.into_iter().chain(rest).collect();
        let mut bytes = vec![0; 1 << 16];
        let used =
            SegmentMap::build_into(&[Path::new(PathKind::Solid, &points)], Fx::from_num(16), &mut bytes).unwrap();
        let map = SegmentMap::from_bytes(&bytes[..used]).unwrap();
        let body = Aabb::from_size(at(lo.0, lo.1), at(size.0, size.1)).unwrap();
        let moved = Mover::platformer(Axis::NEG_Y).move_and_slide(&map, &body, at(speed.0, speed.1)).unwrap();
        let by = (moved.body.position() - body.position()).raw();
        assert!(by.0.max(by.1) > 15_000, "{by:?}");
    }
}

/// A body slides down a slope, away from a wall, or past a one-way face that it has half passed.
/// The top of the wall and the one-way face are beside it, and level.
fn slides_down(beside: &Path, body: impl Body, name: &str) {
    let unit = |x: i64, y: i64| at(x * UNIT, y * UNIT);
    let slope = [unit(50, 200), unit(100, 150), unit(100, 200)];
    let mut bytes = vec![0; 1 << 12];
    let paths = [Path::new(PathKind::Solid, &slope), *beside];
    let used = SegmentMap::build_into(&paths, Fx::from_num(50), &mut bytes).unwrap();
    let map = SegmentMap::from_bytes(&bytes[..used]).unwrap();
    let (mover, start) = (Mover::platformer(Axis::NEG_Y), body.position());
    let (mut body, mut velocity) = (body, Vec2::ZERO);
    for _ in 0..40 {
        let moved = mover.move_and_slide(&map, &body, velocity + at(0, UNIT / 4)).unwrap();
        (body, velocity) = (moved.body, moved.velocity);
    }
    assert!(start.x - body.position().x > 20, "{name} stops at {:?}", body.position());
}

#[test]
fn a_level_face_beside_a_body_binds_no_slope() {
    let unit = |x: i64, y: i64| at(x * UNIT, y * UNIT);
    let wall = [unit(100, 100), unit(140, 100), unit(140, 200), unit(100, 200)];
    let (wall, ledge) = (Path::new(PathKind::Solid, &wall), [unit(60, 100), unit(140, 100)]);
    let ledge = Path::new(PathKind::OneWay, &ledge);
    for (place, beside) in [("at a wall", &wall), ("in a one-way face", &ledge)] {
        let corners = [unit(80, 60), unit(100, 60), unit(100, 140), unit(80, 140)];
        slides_down(beside, Aabb::new(corners[0], corners[2]).unwrap(), &format!("a box {place}"));
        slides_down(beside, ConvexPolygon::<4>::new(&corners).unwrap(), &format!("a polygon {place}"));
        let radius = Fx::from_num(10);
        let capsule = Capsule::new(unit(90, 70), unit(90, 130), radius).unwrap();
        slides_down(beside, capsule, &format!("a capsule {place}"));
        slides_down(beside, Circle::new(unit(90, 100), radius).unwrap(), &format!("a disc {place}"));
    }
}
