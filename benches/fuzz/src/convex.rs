//! Capsules, oriented boxes and polygons: pairs, moves and turns.

use tilesat::motion::{Moved, turn};
use tilesat::{Axis, Mover};
use tilesat_judge::Random;
use tilesat_judge::convex::ask;
use tilesat_judge::convex::bodies::{Any, any, figure, raw, seen, way};
use tilesat_judge::convex::generate::{CLASSES, Class, Pairs};
use tilesat_judge::convex::shape::{Shape, pairs as kinds};
use tilesat_judge::convex::verify::{Pair, about_point, cast};
use tilesat_judge::motion::body::RESPONSES;
use tilesat_judge::oracle::int256::Int256;
use tilesat_judge::rooms::body::vec2;
use tilesat_judge::rooms::view::View;
use tilesat_judge::rooms::{P, PX, len2, mosaic};
use tilesat_judge::shapes::level::Level;

/// Frames per body: one per byte, up to this number.
const FRAMES: u32 = 6;

/// Every verb of a pair, in both orders, and a cast through its position.
pub(crate) fn pairs(data: &[u8]) {
    let mut r = Random::steered(data);
    let all: Vec<_> = kinds().collect();
    let kind = all[r.below(all.len() as i64) as usize];
    let class = CLASSES[r.below(6) as usize];
    let mut pairs = Pairs::new(kind, class, 0);
    let (a, b) = pairs.next();
    let pair = Pair::new(&a, &b);
    pair.all();
    let vertices = b.vertices();
    about_point(&a, vertices[r.below(vertices.len() as i64) as usize]);
    let most = if class == Class::Domain { (1 << 28) - 1 } else { 64 << 16 };
    let d = (r.sign() * r.magnitude(most), r.sign() * r.magnitude(most));
    let start = a.moved((-d.0 / 2, -d.1 / 2));
    if start.in_domain() && start.moved(d).in_domain() {
        cast::<Int256>(&start, &b, d, 4);
    }
}

/// A level of all shapes anywhere, and a body in it that overlaps nothing.
fn scene(r: &mut Random) -> Option<(Level, Shape)> {
    let (cell, dense) = (if r.one_in(2) { 16 * PX } else { 2 * (128 + r.magnitude(4096)) }, r.within(0, 60));
    let one_way = r.within(0, 20);
    let size = (r.within(1, 8), r.within(1, 6));
    let mut level = mosaic(r, size, cell, dense, one_way);
    let far = (1 << 28) - 9 * cell;
    (level.x, level.y) = (r.sign() * r.magnitude(far), r.sign() * r.magnitude(far));
    for _ in 0..8 {
        let at = (level.x + r.within(0, size.0 * cell), level.y + r.within(0, size.1 * cell));
        let free = figure(r, at, cell).filter(|shape| !level.all().overlaps(&any(shape)));
        if let Some(shape) = free {
            return Some((level, shape));
        }
    }
    None
}

fn hits(moved: &Moved<Any>) -> Vec<(u32, P)> {
    moved.hits.iter().map(|h| (h.toi.raw(), (h.axis.x.into(), h.axis.y.into()))).collect()
}

/// Never inside and never faster. The same twice, shifted, and in a mirror except at full ties.
pub(crate) fn moves(data: &[u8]) {
    let mut r = Random::steered(data);
    let Some((level, mut shape)) = scene(&mut r) else { return };
    let map = level.all();
    let by = (-level.x + r.around(1 << 20), -level.y + r.around(1 << 20));
    let views = [View::MirrorX, View::Moved(by)];
    let others = views.map(|view| view.level(&level));
    let mover = Mover::platformer(Axis::NEG_Y).with_response(RESPONSES[r.below(4) as usize]);
    let mut v = (0, 0);
    for frame in 0..FRAMES {
        if frame > 0 && !Random::is_left() {
            break;
        }
        if r.one_in(3) || len2(v) < 1 << 12 {
            v = (r.sign() * r.magnitude(4 * level.cell), r.sign() * r.magnitude(4 * level.cell));
        }
        let body = any(&shape);
        let moved = mover.move_and_slide(&map, &body, vec2(v)).expect("free and inside the domain");
        let case = || format!("{level:?} {shape:?} by {v:?}: {moved:?}");
        assert_eq!(mover.move_and_slide(&map, &body, vec2(v)), Ok(moved), "twice: {}", case());
        assert!(!map.overlaps(&moved.body), "inside: {}", case());
        let velocity = raw(moved.velocity);
        assert!(len2(velocity) <= len2(v), "faster: {}", case());
        let d = way(&body, &moved.body);
        for (view, level) in views.into_iter().zip(&others) {
            let there = any(&seen(view, &shape));
            let twin = mover.move_and_slide(&level.all(), &there, vec2(view.direction(v))).expect("the same");
            let (seen, wanted) = (hits(&twin), hits(&moved));
            let wanted: Vec<_> = wanted.into_iter().map(|(t, n)| (t, view.direction(n))).collect();
            let differs = seen.iter().zip(&wanted).find(|(a, b)| a != b);
            if differs.is_some_and(|(a, b)| view == View::MirrorX && a.0 == b.0 && a.1 == (-b.1.0, b.1.1)) {
                continue;
            }
            let (e, w) = (way(&there, &twin.body), raw(twin.velocity));
            assert_eq!((e, w), (view.direction(d), view.direction(velocity)), "{view:?}: {twin:?} {}", case());
            assert_eq!(seen, wanted, "{view:?}: {}", case());
        }
        (shape, v) = (shape.moved(d), velocity);
    }
}

/// A turn gives the new orientation where that is free. Elsewhere it is the same shape, pushed out
/// on its side of what is between, or a refusal.
pub(crate) fn turns(data: &[u8]) {
    let mut r = Random::steered(data);
    let Some((level, shape)) = scene(&mut r) else { return };
    let map = level.all();
    let Shape::Turned { centre, half, radius, .. } = shape else { return };
    let mut body = ask::turned(centre, half, (1, 0), radius);
    for frame in 0..FRAMES {
        if frame > 0 && !Random::is_left() {
            break;
        }
        let direction = (r.around(1 << 20), r.around(1 << 20) | 1);
        let turned = ask::turned(raw(body.centre()), half, direction, radius);
        let case = || format!("{level:?} {body:?} to {turned:?}");
        let end = turn(&map, &body, &turned);
        assert_eq!(turn(&map, &body, &turned), end, "twice: {}", case());
        let Ok(end) = end else {
            assert!(map.overlaps(&body) || map.overlaps(&turned), "refused: {}", case());
            if map.overlaps(&body) {
                return;
            }
            continue;
        };
        assert!(!map.overlaps(&body) && !map.overlaps(&end), "inside {end:?}: {}", case());
        assert_eq!((end.along(), end.across(), end.radius()), (turned.along(), turned.across(), turned.radius()));
        assert!(map.overlaps(&turned) || end == turned, "pushed without need {end:?}: {}", case());
        let apart = end.centre() - body.centre();
        let point = tilesat::Circle::new(body.centre(), tilesat::Fx::ZERO).expect("inside the domain");
        let between = map.cast_shape(&point, apart, tilesat::Inside::Hit);
        assert!(between.is_ok_and(|hit| hit.is_none()), "through something {end:?}: {}", case());
        body = end;
    }
}
