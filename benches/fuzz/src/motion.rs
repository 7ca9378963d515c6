//! Bodies that move through levels. They are never inside by the exact test and never gain speed. A
//! second run gives the same result, and a mirrored run the mirrored result.

use tilesat::{Axis, Mover, Outside, Response, SegmentMap};
use tilesat_judge::Random;
use tilesat_judge::motion::body::{Body, RESPONSES};
use tilesat_judge::motion::level::Level;
use tilesat_judge::motion::scene::{any_velocity, blocks as random_blocks, placed};
use tilesat_judge::motion::{P, judge, len2};
use tilesat_judge::rooms::body::Body as Shaped;
use tilesat_judge::rooms::frames as mosaics;
use tilesat_judge::rooms::room::Room;
use tilesat_judge::rooms::view::View;
use tilesat_judge::rooms::{PX, mosaic};
use tilesat_judge::segments::build;
use tilesat_judge::segments::frames as polygons;

/// Frames per body: one per byte, up to this number.
const FRAMES: u32 = 8;

/// Sides of cells, in units and in raw.
fn cell(r: &mut Random) -> i64 {
    match r.below(4) {
        0 => 16 * PX,
        1 => 24 * PX,
        2 => 8 * PX,
        _ => 2 * (128 + r.magnitude(4096)),
    }
}

/// A velocity in proportion to a level's cells, or of any size.
fn velocity(r: &mut Random, cell: i64) -> P {
    let most = (1 << 28) - 1;
    // Crosses at most some hundred cells, because the judge looks into each of them.
    if cell >= 8 * PX && r.one_in(2) {
        return any_velocity(r, 60);
    }
    let speed = |r: &mut Random| (r.sign() * r.magnitude(4 * cell)).clamp(-most, most);
    (speed(r), speed(r))
}

fn size(r: &mut Random, cell: i64) -> i64 {
    match r.below(4) {
        0 => cell,
        1 => 2 + r.magnitude(cell),
        2 => 2 + r.magnitude(3 * cell),
        _ => cell - 2 + r.below(5),
    }
}

/// Blocks and one-way tiles. The exact judge checks the first hit, the positions and the remaining
/// velocity.
pub(crate) fn blocks(data: &[u8]) {
    let mut r = Random::steered(data);
    let cell = cell(&mut r);
    let (width, height) = (r.within(1, 12), r.within(1, 9));
    let (solid, one_way) = (r.within(0, 60), r.within(0, 20));
    let mut level = random_blocks(&mut r, (width, height), cell, solid, one_way);
    level.outside = [Outside::Solid, Outside::Empty, Outside::Edge][r.below(3) as usize];
    let end = (1 << 28) - width.max(height) * cell;
    level.origin = (r.magnitude(end) * r.sign(), r.magnitude(end) * r.sign());
    let body = if r.one_in(2) {
        Body::rect((0, 0), (size(&mut r, cell), size(&mut r, cell)))
    } else {
        Body::disc((0, 0), (size(&mut r, cell) / 2).max(1))
    };
    let Some(mut body) = placed(&mut r, &level, body) else { return };
    let response = RESPONSES[r.below(4) as usize];
    let mover = Mover::platformer(Axis::NEG_Y);
    let mut v = velocity(&mut r, cell);
    for frame in 0..FRAMES {
        if frame > 0 && !Random::is_left() {
            break;
        }
        if r.one_in(3) || len2(v) < 1 << 12 || v.0.abs().max(v.1.abs()) >= 1 << 28 {
            v = velocity(&mut r, cell);
        }
        let (lo, hi) = body.bounds();
        // The mover refuses to leave the domain. Other tests check that.
        if [lo.0, lo.1, hi.0, hi.1].iter().any(|at| at.abs() + v.0.abs().max(v.1.abs()) >= 1 << 29) {
            return;
        }
        let out = judge::check(&level, mover, response, &body, v);
        again(&level, &body, v, response, &out);
        mirrored(&level, &body, v, response, &out);
        (body, v) = (out.body, out.v);
    }
}

fn again(level: &Level, body: &Body, v: P, response: Response, out: &tilesat_judge::motion::body::Outcome) {
    let mover = Mover::platformer(Axis::NEG_Y).with_response(response);
    assert_eq!(body.step(&mover, &level.map(), v).as_ref(), Ok(out), "twice: {level:?} {body:?} by {v:?}");
}

/// The mirror twin, with x reversed. One exception: a circle that meets two corners at once from
/// exactly the middle. There the axes decide.
fn mirrored(level: &Level, body: &Body, v: P, response: Response, out: &tilesat_judge::motion::body::Outcome) {
    let w = level.width;
    let tiles = (0..w * level.height).map(|k| level.tile(w - 1 - k % w, k / w)).collect();
    let origin = (-level.origin.0 - w * level.cell, level.origin.1);
    let twin = Level { tiles, origin, ..level.clone() };
    let mover = Mover::platformer(Axis::NEG_Y).with_response(response);
    let flip = |p: P| (-p.0, p.1);
    let seen = body.mapped(flip).step(&mover, &twin.map(), flip(v)).expect("a mirrored motion is taken as well");
    let axes: Vec<P> = seen.axes().into_iter().map(flip).collect();
    let tie = axes.iter().zip(out.axes()).find(|(a, b)| **a != *b).is_some_and(|(a, b)| *a == flip(b));
    let bits = |o: &tilesat_judge::motion::body::Outcome, b: Body, v: P, left: P| {
        (b, v, left, o.times(), o.floor, o.wall, o.ceiling, o.flags)
    };
    let (one, other) = (
        bits(out, out.body, out.v, out.remaining),
        bits(&seen, seen.body.mapped(flip), flip(seen.v), flip(seen.remaining)),
    );
    assert!(tie || one == other, "mirrored: {level:?} {body:?} by {v:?} {response:?}\n{one:?}\n{other:?}");
}

/// Tiles of all shapes.
pub(crate) fn shapes(data: &[u8]) {
    let mut r = Random::steered(data);
    let cell = match r.below(3) {
        0 => 16 * PX,
        1 => 24 * PX,
        _ => 2 * 7 * 64 * r.within(2, 900),
    };
    let (dense, one_way) = (r.within(5, 70), r.within(0, 10));
    let level = mosaic(&mut r, (8, 6), cell, dense, one_way);
    let room = Room::new(&level);
    let kind = mosaics::any_body(&mut r, cell);
    // Half of the boxes are on the lattice of half cells, where corners end exactly on corners.
    // Circles meet two slopes at once there.
    let is_box = matches!(kind, Shaped::Rect(..));
    let coordinate = |r: &mut Random, cells: i64| {
        let at = r.below(cells * cell);
        if at & 1 == 0 || !is_box { at } else { at - at % (cell / 2) }
    };
    let place = (0..40).find_map(|_| {
        let there = kind.at((coordinate(&mut r, 8), coordinate(&mut r, 6)));
        (!room.overlaps(there, (0, 0), 0)).then_some(there)
    });
    let Some(mut body) = place else { return };
    let response = mosaics::RESPONSES[r.below(4) as usize];
    let fastest = (60 * cell / (16 * PX)).max(1);
    let mut v = mosaics::any_velocity(&mut r, fastest);
    let mut tally = mosaics::Tally::default();
    for frame in 0..FRAMES {
        if frame > 0 && !Random::is_left() {
            break;
        }
        if r.one_in(3) || v.0.abs().max(v.1.abs()) > fastest * PX {
            v = mosaics::any_velocity(&mut r, fastest);
        }
        let scene = mosaics::Scene { level: &level, room: &room, body, v, response };
        let by = (r.around(1000 * PX), r.around(1000 * PX));
        let view = [View::MirrorX, View::MirrorY, View::Transpose, View::Moved(by)][r.below(4) as usize];
        let mover = mosaics::mover((0, -1), response);
        let first = body.step(&mover, &level.all(), v).expect("inside the domain");
        // With x and y exchanged, a tie of roundings goes the other way. Each further bounce
        // amplifies that raw unit.
        let again = response == Response::Bounce && first.hits.len() > 1;
        let view = if view == View::Transpose && again { View::MirrorX } else { view };
        let out = mosaics::frame(&mut r, &scene, &[view], &mut tally);
        assert_eq!(first, out, "{}", mosaics::describe(&scene, "twice"));
        (body, v) = (out.body, out.v);
    }
}

/// Polygons, walls and chains.
pub(crate) fn segments(data: &[u8]) {
    let mut r = Random::steered(data);
    let scene = build::scene(&mut r);
    if !polygons::is_proper(&scene) {
        return;
    }
    let bytes = scene.bytes();
    let map = SegmentMap::from_bytes(&bytes).expect("what was built is taken");
    let blocking = scene.blocking();
    if blocking.is_empty() {
        return;
    }
    let free = |b: &tilesat_judge::segments::Body| b.has_area() && !scene.overlaps(&blocking, *b);
    let Some(mut body) = (0..30).map(|_| scene.body(&mut r)).find(free) else { return };
    let (lo, hi) = scene.bounds();
    let size = (hi.0 - lo.0).max(hi.1 - lo.1) as i64;
    let response = [Response::Slide, Response::Bounce, Response::DropThrough][r.below(3) as usize];
    let mover = Mover::platformer(Axis::NEG_Y).with_response(response);
    let mut tally = polygons::Tally::default();
    let mut v = (0, 0);
    for frame in 0..FRAMES {
        if frame > 0 && !Random::is_left() {
            break;
        }
        if frame == 0 || r.one_in(3) {
            let p = polygons::place(body);
            let any = |r: &mut Random| i128::from(r.sign() * r.magnitude(size));
            let end = blocking[r.below(blocking.len() as i64) as usize].a;
            let far = i128::from(r.below(4));
            v = (far * (end.0 - p.0) + any(&mut r) / 4, far * (end.1 - p.1) + any(&mut r) / 4);
        }
        // Sixteenths of the way are points of the lattice.
        v = (v.0 / 16 * 16, v.1 / 16 * 16);
        let Ok(out) = polygons::step(&scene, &map, &mover, body, v) else { return };
        let case = || format!("{scene:?} {body:?} by {v:?} {response:?}");
        assert!(!scene.overlaps(&blocking, out.body), "ends inside: {}", case());
        assert!(polygons::len2(out.v) <= polygons::len2(v), "is faster: {}", case());
        let twice = polygons::step(&scene, &map, &mover, body, v).expect("taken before");
        let bits = |s: &polygons::Step| (polygons::place(s.body), s.v, s.solid, s.free, s.toi);
        assert_eq!(bits(&twice), bits(&out), "twice: {}", case());
        polygons::judge_way(&scene, &blocking, &map, body, v, &mut tally);
        (body, v) = (out.body, out.v);
        let p = polygons::place(body);
        if (p.0 - lo.0).abs().max((p.1 - lo.1).abs()) > 4 * i128::from(size) {
            return;
        }
    }
}
