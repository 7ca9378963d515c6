//! Moves of oriented boxes, polygons and slanted capsules in other views of a level, and of the
//! same body in other words: the same bits.
//!
//! Exempt are full ties, as for other bodies (see `symmetry`).

use tilesat::world::World;
use tilesat::{Axis, Body, Mover, Outside, Response, Vec2};
use tilesat_judge::convex::ask;
use tilesat_judge::convex::bodies::{any, figure, raw, seen};
use tilesat_judge::convex::shape::{MOST, Shape};
use tilesat_judge::rooms::body::vec2;
use tilesat_judge::rooms::view::View;
use tilesat_judge::rooms::{P, PX, len2, mosaic};
use tilesat_judge::shapes::level::Level;
use tilesat_judge::{Random, cases};

const RESPONSES: [Response; 4] = [Response::Slide, Response::Slide, Response::Bounce, Response::Touch];

/// The way, the velocity, what remains, floor, wall and ceiling, and the hits.
type Bits = (P, P, P, [bool; 3], Vec<(u32, P, bool)>);

fn bits<W: World, B: Body>(mover: &Mover, world: &W, body: &B, v: P) -> (Bits, B) {
    let moved = mover.move_and_slide(world, body, vec2(v)).unwrap();
    let (from, to) = (raw(body.position()), raw(moved.body.position()));
    let hits = moved.hits.iter().map(|h| (h.toi.raw(), (h.axis.x.into(), h.axis.y.into()), h.one_way));
    let kinds = [moved.floor, moved.wall, moved.ceiling];
    let way = (to.0 - from.0, to.1 - from.1);
    ((way, raw(moved.velocity), raw(moved.remaining), kinds, hits.collect()), moved.body)
}

fn turned(view: View, bits: &Bits) -> Bits {
    let d = |p: P| view.direction(p);
    let hits = bits.4.iter().map(|h| (h.0, d(h.1), h.2)).collect();
    (d(bits.0), d(bits.1), d(bits.2), bits.3, hits)
}

/// Whether two outcomes differ at two hits of one moment that are images of each other.
fn is_tie(a: &Bits, b: &Bits, view: View) -> bool {
    let Some((a, b)) = a.4.iter().zip(&b.4).find(|(a, b)| a != b) else { return false };
    let images = match view {
        View::Transpose => [(a.1.1, a.1.0), (-a.1.1, -a.1.0)],
        View::MirrorX | View::MirrorY => [(-a.1.0, a.1.1), (a.1.0, -a.1.1)],
        View::Moved(_) => return false,
    };
    a.0 == b.0 && images.contains(&b.1)
}

#[derive(Debug, Default)]
struct Tally {
    frames: u64,
    hits: u64,
    ties: u64,
    words: u64,
}

/// The same oriented box or polygon as other types, and with its corners in another order.
fn in_other_words(mover: &Mover, world: &impl World, shape: &Shape, v: P, wanted: &Bits, r: &mut Random) -> bool {
    let check = |seen: Bits| assert_eq!(seen, *wanted, "{shape:?} by {v:?}");
    let (mut corners, radius) = match *shape {
        Shape::Turned { centre, half, direction, radius } => {
            check(bits(mover, world, &ask::turned(centre, half, direction, radius), v).0);
            (shape.vertices(), radius)
        }
        Shape::Polygon { radius, .. } => (shape.vertices(), radius),
        _ => return false,
    };
    // A box of a raw unit may have lost its area to rounding.
    if tilesat_judge::convex::shape::hull(&corners).len() < corners.len() {
        return false;
    }
    let n = corners.len();
    corners.rotate_left(r.below(n as i64) as usize);
    if r.one_in(2) {
        corners.reverse();
    }
    check(bits(mover, world, &ask::polygon(&corners, radius), v).0);
    let hull = tilesat::ConvexPolygon::<MOST>::hull(&corners.iter().map(|p| vec2(*p)).collect::<Vec<_>>()).unwrap();
    check(bits(mover, world, &hull.with_radius(tilesat::Fx::from_bits(radius as i32)).unwrap(), v).0);
    true
}

fn play(r: &mut Random, tally: &mut Tally) {
    let (dense, one_way) = (r.within(4, 40), if r.one_in(2) { 0 } else { 10 });
    let mut level = mosaic(r, (12, 9), 16 * PX, dense, one_way);
    (level.x, level.y) = (r.around(500 * PX), r.around(500 * PX));
    let map = level.all();
    let far = (r.around(6000 * PX), r.around(6000 * PX));
    let views = [View::MirrorX, View::MirrorY, View::Transpose, View::Moved(far)];
    let others = views.map(|view| view.level(&level));
    for _ in 0..6 {
        let at = (level.x + r.within(8 * PX, 184 * PX), level.y + r.within(8 * PX, 136 * PX));
        let Some(mut shape) = figure(r, at, 12 * PX) else { continue };
        if map.overlaps(&any(&shape)) {
            continue;
        }
        let mut v = (0, 0);
        for _ in 0..20 {
            if v == (0, 0) || r.one_in(8) {
                v = (r.sign() * r.magnitude(40 * PX), r.sign() * r.magnitude(40 * PX));
            }
            v.1 += 1 << 14;
            let response = RESPONSES[r.below(4) as usize];
            let mover = |up: P| Mover::platformer(Axis::new(up.0 as i32, up.1 as i32)).with_response(response);
            let (out, _) = bits(&mover((0, -1)), &map, &any(&shape), v);
            for (view, level) in views.into_iter().zip(&others) {
                let body = any(&seen(view, &shape));
                let (other, _) = bits(&mover(view.direction((0, -1))), &level.all(), &body, view.direction(v));
                let wanted = turned(view, &out);
                if is_tie(&wanted, &other, view) {
                    tally.ties += 1;
                    continue;
                }
                let rows: Vec<_> = level.tiles.chunks(level.width as usize).collect();
                assert_eq!(other, wanted, "{view:?}: {shape:?} by {v:?} {response:?} {rows:?}");
            }
            tally.words += u64::from(in_other_words(&mover((0, -1)), &map, &shape, v, &out, r));
            tally.frames += 1;
            tally.hits += u64::from(!out.4.is_empty());
            (shape, v) = (shape.moved(out.0), out.1);
        }
    }
}

#[test]
fn every_view_of_random_levels() {
    let (mut r, mut tally) = (Random::new(61), Tally::default());
    for _ in 0..cases(400) {
        play(&mut r, &mut tally);
    }
    println!("{tally:?}");
    assert!(tally.hits > tally.frames / 8 && tally.words > tally.frames / 4, "{tally:?}");
    assert!(tally.ties * 100 <= tally.frames, "{tally:?}");
}

/// Four tiles around the origin, by row, with a polygon there and its velocity.
type Scene<'a> = ([u8; 4], &'a [P], P);

/// The outcome, which is the same in every view.
fn in_all_views(&(tiles, corners, v): &Scene<'_>) -> Bits {
    let (x, outside) = (-16 * PX, Outside::Empty);
    let level = Level { width: 2, height: 2, cell: 16 * PX, x, y: x, outside, tiles: tiles.to_vec() };
    let shape = Shape::polygon(corners, 0);
    let out = bits(&Mover::new(), &level.all(), &any(&shape), v).0;
    for view in [View::MirrorX, View::MirrorY, View::Transpose, View::Moved((-12_345, 6_789))] {
        let (level, body) = (view.level(&level), any(&seen(view, &shape)));
        let other = bits(&Mover::new(), &level.all(), &body, view.direction(v)).0;
        assert_eq!(other, turned(view, &out), "{view:?}: {tiles:?} {corners:?} by {v:?}");
    }
    out
}

/// Scenes in which a body stopped though a way led on, each for another reason.
#[test]
fn what_leads_past_the_end_of_an_arc_is_a_way() {
    let scenes: [Scene<'_>; 6] = [
        // A corner behind the pipe: the solid between ends in a cusp.
        ([0, 0, 0, 17], &[(-12, -13), (0, -1), (-2, 1), (-14, -11)], (1, 1_762_045)),
        // A corner leaves the pipe past its end, before it reaches the surface.
        ([0, 0, 0, 15], &[(-18_909, -3_871), (2, 1), (-17_072, 33_972), (-26_868, 8_673)], (1, -356_294)),
        // The end of a one-way face is no corner.
        ([0, 0, 0, 34], &[(-1, -4), (2, -4), (0, 0)], (0, 256_112)),
        // A flat side lands on a convex arc's end by its own end.
        ([0, 10, 0, 0], &[(-1, 0), (0, 0), (1, 1), (1, 2)], (0, -2_260_058)),
        // Five corners at a pipe fill the list of ways.
        ([0, 14, 10, 25], &[(3, -4), (4, -2), (2, 0), (1, 0), (1, -1)], (-9_451, 145_842)),
        // The second corner at the pipe stops a chord that goes farther than the velocity does.
        ([15, 29, 1, 1], &[(-251, -309), (-176, -295), (0, 0), (-284, -3), (-375, -54)], (2_294_073, -671_176)),
    ];
    for scene in &scenes {
        let out = in_all_views(scene);
        assert!(len2(out.0) > len2((PX / 2, 0)), "{scene:?}: {out:?}");
    }
}

/// A corner of the body meets the tip between two tiles, which belongs to one of them. The body
/// does not come into that one.
#[test]
fn the_corner_of_a_tile_beside_the_way_is_no_other_hit() {
    let corners = [(-3332, 6), (-3331, 9), (-3331, 10), (-3335, 10), (-3335, 8)];
    let corners = corners.map(|(x, y)| (x - 8_568, y + 208_045));
    let out = in_all_views(&([10, 17, 14, 31], &corners, (16_351, -397_072)));
    assert_eq!(out.4.last().map(|hit| hit.1), Some((-2, 1)), "{out:?}");
}

/// A place far away, up to the ends of the domain, changes nothing.
#[test]
fn translation_to_the_ends_of_the_domain() {
    let mut r = Random::new(62);
    let level = mosaic(&mut r, (12, 9), 16 * PX, 20, 10);
    let map = level.all();
    let far = (1 << 29) - 12 * 16 * PX - 60 * PX;
    let mut hits = 0;
    for _ in 0..cases(2000) {
        let at = (r.within(8 * PX, 184 * PX), r.within(8 * PX, 136 * PX));
        let Some(shape) = figure(&mut r, at, 12 * PX).filter(|s| !map.overlaps(&any(s))) else { continue };
        let v = (r.sign() * r.magnitude(30 * PX), r.sign() * r.magnitude(30 * PX));
        let mover = Mover::platformer(Axis::NEG_Y);
        let (out, _) = bits(&mover, &map, &any(&shape), v);
        hits += u64::from(!out.4.is_empty());
        for by in [(far, far), (-far, far), (far, -far), (-far, -far), (1, -1)] {
            let view = View::Moved(by);
            let (other, body) = bits(&mover, &view.level(&level).all(), &any(&seen(view, &shape)), v);
            assert_eq!(other, out, "{by:?}: {shape:?} by {v:?}");
            assert_ne!(body.aabb().size(), Vec2::ZERO);
        }
    }
    assert!(hits > 50, "{hits}");
}
