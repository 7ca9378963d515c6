//! Results do not depend on the order in which a level was written: torture scenes 21 and 47, P19.

use tilesat::{
    Aabb, Inside, Joined, Mover, PathKind, Response, SegmentMap, Solid, Solids, TileKind, TileKinds, TileMap, Toi,
};
use tilesat_judge::drawing::{Drawing, VIEWS, at, direction, disc, mover, place, rect};
use tilesat_judge::rooms::body::{Body, vec2};
use tilesat_judge::rooms::{P, PX};

const CELL: i64 = 16 * PX;
const RESPONSES: [Response; 4] = [Response::Slide, Response::Touch, Response::DropThrough, Response::Bounce];

/// All orders of six.
fn orders() -> Vec<[usize; 6]> {
    fn go(k: usize, order: &mut [usize; 6], out: &mut Vec<[usize; 6]>) {
        if k == 6 {
            out.push(*order);
        }
        for i in k..6 {
            order.swap(k, i);
            go(k + 1, order, out);
            order.swap(k, i);
        }
    }
    let mut out = Vec::new();
    go(0, &mut [0, 1, 2, 3, 4, 5], &mut out);
    assert_eq!(out.len(), 720);
    out
}

/// Bodies and motions into the corners, the seams and the ties of both scenes.
fn motions() -> Vec<(Body, P)> {
    let bodies = [disc(0, 92, 8), rect(-8, 84, 16, 16), disc(40, 60, 8), rect(32, 52, 16, 16), disc(70, 92, 8)];
    let ways = [at(40, 40), at(-40, 40), at(3, 1), at(200, 9), at(-200, 50), at(0, 60), at(31, -60)];
    bodies.iter().flat_map(|b| ways.map(|v| (*b, v))).collect()
}

/// Position, velocity, rest, and for each hit the moment and the direction. Names of cells and
/// features may differ.
type Bits = (Body, P, P, Vec<(u32, P, bool)>);

fn play<W: tilesat::World>(world: &W, body: Body, v: P, response: Response) -> Bits {
    let out = body.step(&mover(&[]).with_response(response), world, v).unwrap();
    let hits = out.hits.iter().map(|h| (h.toi.raw(), (h.axis.x.into(), h.axis.y.into()), h.one_way)).collect();
    (out.body, out.v, out.remaining, hits)
}

/// Six paths: boxes in one floor, a wall that stands on their seam, a slope, a chain, a polygon
/// over two of them.
#[test]
fn scene_47_six_paths_in_every_order() {
    let paths = [
        Drawing::block(at(-100, 100), at(0, 130)),
        Drawing::block(at(0, 100), at(90, 120)),
        Drawing::block(at(90, 40), at(120, 130)),
        (PathKind::Wall, vec![at(-60, 100), at(-60, 20), at(-20, 0)]),
        (PathKind::OneWay, vec![at(20, 80), at(50, 80), at(90, 70)]),
        (PathKind::Solid, vec![at(60, 100), at(90, 80), at(90, 110), at(50, 110)]),
    ];
    let mut first: Option<Vec<Bits>> = None;
    for order in orders() {
        let drawing = Drawing::of(CELL, order.iter().map(|&k| paths[k].clone()).collect());
        let bytes = drawing.bytes();
        let map = SegmentMap::from_bytes(&bytes).unwrap();
        let free = |b: &Body| b.step(&mover(&[]), &map, (0, 1)).is_ok();
        let all: Vec<Bits> = motions()
            .iter()
            .filter(|(b, _)| free(b))
            .flat_map(|(b, v)| RESPONSES.map(|r| play(&map, *b, *v, r)))
            .collect();
        let hits: usize = all.iter().map(|b| b.3.len()).sum();
        assert!(hits > 60, "{hits}");
        assert_eq!(*first.get_or_insert_with(|| all.clone()), all, "{order:?}");
    }
}

/// Six solids in every order, with the keys attached to the boxes, alone and joined with tiles in
/// either order.
#[test]
fn scene_47_six_solids_in_every_order() {
    static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);
    let solid = |a: (i64, i64), b: (i64, i64), key| {
        Solid::new(Aabb::new(vec2(at(a.0, a.1)), vec2(at(b.0, b.1))).unwrap(), key).unwrap()
    };
    let list = [
        solid((-100, 100), (0, 130), 9),
        solid((0, 100), (90, 120), 1),
        solid((90, 40), (120, 130), 4),
        solid((-70, 20), (-60, 100), 7),
        solid((20, 80), (50, 84), 2).with_one_way(tilesat::Side::Up),
        solid((60, 90), (95, 110), 3),
    ];
    let level =
        TileMap::from_ascii("        \n        \n        \n        \n        \n        \n   #    ", &KINDS).unwrap();
    let mut first: Option<Vec<Bits>> = None;
    for order in orders() {
        let list = order.map(|k| list[k]);
        let solids = Solids::new(&list);
        let (one, other) = (Joined::new(&level, &solids), Joined::new(&solids, &level));
        let all: Vec<Bits> = motions()
            .iter()
            .filter(|(b, _)| b.step(&mover(&[]), &one, (0, 1)).is_ok())
            .flat_map(|(b, v)| RESPONSES.map(|r| (*b, *v, r)))
            .flat_map(|(b, v, r)| {
                let here = play(&one, b, v, r);
                assert_eq!(play(&other, b, v, r), here, "{order:?}");
                [here, play(&solids, b, v, r)]
            })
            .collect();
        assert_eq!(*first.get_or_insert_with(|| all.clone()), all, "{order:?}");
    }
}

/// A ray through the common end of two segments: one hit, there. Its normal does not depend on
/// which was written first or is longer.
#[test]
fn scene_21_ray_through_a_shared_end() {
    let end = at(16, 40);
    let joins = [
        ([at(0, 56), end], [end, at(32, 56)]),    // a peak
        ([at(0, 24), end], [end, at(32, 24)]),    // a valley
        ([at(0, 40), end], [end, at(32, 24)]),    // flat, then up
        ([at(0, 40), end], [end, at(32, 56)]),    // flat, then down
        ([at(0, 40), end], [end, at(48, 40)]),    // in a line
        ([at(10, 100), end], [end, at(22, 100)]), // a needle
        ([at(10, 0), end], [end, at(22, 0)]),     // a crevice
    ];
    for (a, b) in joins {
        let mut seen = None;
        for paths in [
            vec![(PathKind::Wall, a.to_vec()), (PathKind::Wall, b.to_vec())],
            vec![(PathKind::Wall, b.to_vec()), (PathKind::Wall, a.to_vec())],
            vec![(PathKind::Wall, vec![a[1], a[0]]), (PathKind::Wall, vec![b[1], b[0]])],
            vec![(PathKind::Wall, vec![a[0], end, b[1]])],
            vec![(PathKind::Wall, vec![b[1], end, a[0]])],
        ] {
            let drawing = Drawing::of(CELL, paths);
            for views in VIEWS {
                let bytes = drawing.seen(views).bytes();
                let map = SegmentMap::from_bytes(&bytes).unwrap();
                let point = |p: P| vec2(place(views, Body::Disc(p, 0)).position());
                let ray = |from: P, d: P| map.cast_ray(point(from), vec2(direction(views, d)), Inside::Hit).unwrap();
                let hit = ray(at(16, 0), at(0, 64)).unwrap_or_else(|| panic!("{drawing:?} {views:?}"));
                assert_eq!(
                    (hit.point, hit.toi),
                    (point(end), Toi::from_raw(40 << 24).unwrap()),
                    "{drawing:?} {views:?}"
                );
                assert!(hit.axis.dot(tilesat::Axis::new(0, 1)) != 0 || hit.axis.x != 0);
                // The normal opposes the ray.
                let d = direction(views, (0, 1));
                assert!(i64::from(hit.axis.x) * d.0 + i64::from(hit.axis.y) * d.1 < 0, "{hit:?}");
                if views.is_empty() {
                    assert_eq!(*seen.get_or_insert(hit.axis), hit.axis, "{drawing:?}");
                }
                // A raw unit to either side, it meets one of the two, exactly at that one's height
                // there.
                for dx in [-1, 1] {
                    let side = ray((16 * PX + dx, 0), at(0, 200));
                    assert!(side.is_some(), "lost beside the end: {drawing:?} {views:?} {dx}");
                }
                // Through the end along the other diagonal.
                let across = ray(at(-24, 0), at(80, 80)).unwrap_or_else(|| panic!("{drawing:?} {views:?}"));
                assert!(across.toi <= Toi::from_raw(1 << 29).unwrap());
            }
        }
    }
}

/// P19: a mover alone equals a mover with others before it. Nothing is kept between calls.
#[test]
fn p19_calls_leave_nothing_behind() {
    let drawing = Drawing::of(CELL, vec![Drawing::block(at(-100, 100), at(100, 130))]);
    let bytes = drawing.bytes();
    let map = SegmentMap::from_bytes(&bytes).unwrap();
    let alone: Vec<Bits> = motions().iter().map(|(b, v)| play(&map, *b, *v, Response::Slide)).collect();
    let reversed: Vec<Bits> = motions().iter().rev().map(|(b, v)| play(&map, *b, *v, Response::Slide)).collect();
    assert!(alone.iter().eq(reversed.iter().rev()) && Mover::ITERATIONS == 4);
}
