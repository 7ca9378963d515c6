//! Flags on a straight way: exact, against the distances of sets in 128 bits, and against positions
//! along the way.

use tilesat::motion::Body;
use tilesat::world::{Probe, Trail};
use tilesat::{
    Aabb, Blocks, Cell, Circle, Fx, Grid, Mover, Response, Solid, Solids, TileKind, TileKinds, TileMap, Vec2,
};
use tilesat_judge::Random;

static KINDS: TileKinds = TileKinds::EMPTY.with(1, TileKind::EMPTY.with_flags(1)).with(2, TileKind::FULL.with_flags(2));

fn raw(x: i64, y: i64) -> Vec2 {
    Vec2::from_raw(x as i32, y as i32)
}

/// Whether a segment from `p` by `d` comes within `r` of the box `lo..hi`: the minimum over the
/// convex way, by its three kinds of positions.
fn comes_near(p: (i128, i128), d: (i128, i128), r: i128, lo: (i128, i128), hi: (i128, i128)) -> bool {
    let square = |v: (i128, i128)| v.0 * v.0 + v.1 * v.1;
    let to_box = |q: (i128, i128)| (q.0 - q.0.clamp(lo.0, hi.0), q.1 - q.1.clamp(lo.1, hi.1));
    if square(to_box(p)) <= r * r || square(to_box((p.0 + d.0, p.1 + d.1))) <= r * r {
        return true;
    }
    let corners = [(lo.0, lo.1), (hi.0, lo.1), (hi.0, hi.1), (lo.0, hi.1)];
    // A corner whose foot is on the way.
    if d == (0, 0) {
        return false;
    }
    let near = corners.iter().any(|c| {
        let m = (c.0 - p.0, c.1 - p.1);
        let (dot, cross) = (m.0 * d.0 + m.1 * d.1, m.0 * d.1 - m.1 * d.0);
        dot >= 0 && dot <= square(d) && cross * cross <= r * r * square(d)
    });
    // The way crosses a side.
    let side = |a: (i128, i128), b: (i128, i128), q: (i128, i128)| {
        ((b.0 - a.0) * (q.1 - a.1) - (b.1 - a.1) * (q.0 - a.0)).signum()
    };
    let q = (p.0 + d.0, p.1 + d.1);
    near || (0..4).any(|k| {
        let (a, b) = (corners[k], corners[(k + 1) % 4]);
        let (pa, pb, qa, qb) = (side(a, b, p), side(p, q, b), side(a, b, q), side(p, q, a));
        // On one line, a corner or an end has already decided.
        pa * qa <= 0 && pb * qb <= 0 && (pa, pb, qa, qb) != (0, 0, 0, 0)
    })
}

/// Small lattice: cells of 256 raw, bodies and ways of multiples of odd parts, so that all touches
/// occur, also with one raw unit more and less.
#[test]
fn exact_on_a_lattice() {
    let mut r = Random::new(7);
    let (mut touched, mut missed) = (0u32, 0u32);
    let part = |r: &mut Random, most: i64| r.within(-most, most) * 64 + if r.one_in(3) { r.within(-1, 1) } else { 0 };
    for _ in 0..60_000 {
        let mut tiles = [0u8; 36];
        let (cx, cy) = (r.within(1, 4), r.within(1, 4));
        tiles[(cy * 6 + cx) as usize] = 1 + r.below(2) as u8;
        let map = TileMap::on_grid(&tiles, Grid::new(6, 6, Fx::from_bits(256), raw(0, 0)).unwrap(), &KINDS).unwrap();
        let p = (768 + part(&mut r, 14), 768 + part(&mut r, 14));
        let d = (part(&mut r, 20), part(&mut r, 20));
        let (lo, hi) = ((cx * 256, cy * 256), (cx * 256 + 256, cy * 256 + 256));
        let wide = |v: (i64, i64)| (i128::from(v.0), i128::from(v.1));
        let size = (r.within(0, 6) * 64, r.within(0, 6) * 64);
        let body = Aabb::new(raw(p.0, p.1), raw(p.0 + size.0, p.1 + size.1)).unwrap();
        let due = comes_near(wide(p), wide(d), 0, wide((lo.0 - size.0, lo.1 - size.1)), wide(hi));
        let flags = map.flags_swept(&body, raw(d.0, d.1)).unwrap();
        assert_eq!(flags != 0, due, "{body:?} by {d:?} at {lo:?}");
        let disc = Circle::new(raw(p.0, p.1), Fx::from_bits(size.0 as i32)).unwrap();
        let due = comes_near(wide(p), wide(d), size.0.into(), wide(lo), wide(hi));
        assert_eq!(map.flags_swept(&disc, raw(d.0, d.1)).unwrap() != 0, due, "{disc:?} by {d:?} at {lo:?}");
        let due = comes_near(wide(p), wide(d), 0, wide(lo), wide(hi));
        assert_eq!(map.flags_swept(&raw(p.0, p.1), raw(d.0, d.1)).unwrap() != 0, due, "{p:?} by {d:?} at {lo:?}");
        // No way is a single position.
        assert_eq!(map.flags_swept(&disc, Vec2::ZERO).unwrap(), map.flags_touched(&disc));
        assert_eq!(map.flags_swept(&body, Vec2::ZERO).unwrap(), map.flags_touched(&body));
        if flags == 0 { missed += 1 } else { touched += 1 }
    }
    assert!(touched > 10_000 && missed > 10_000, "{touched} {missed}");
}

/// All of the 36 tiles, and of solids of their boxes, near the way are reported, each once, and in
/// order.
#[test]
fn every_tile_and_solid_on_the_way() {
    fn cells<B: Probe>(map: &TileMap<'_>, body: &B, d: Vec2) -> Vec<(i64, i64)> {
        map.tiles_swept(body, d).unwrap().map(|tile| (tile.cell.x.into(), tile.cell.y.into())).collect()
    }
    let mut r = Random::new(8);
    let tiles: Vec<_> = (0..36).map(|_| r.below(3) as u8).collect();
    let map = TileMap::on_grid(&tiles, Grid::new(6, 6, Fx::from_bits(256), raw(0, 0)).unwrap(), &KINDS).unwrap();
    let places: Vec<(i64, i64)> = (0..36).map(|k| (k % 6, k / 6)).collect();
    let box_of = |&(x, y): &(i64, i64)| Aabb::new(raw(x * 256, y * 256), raw(x * 256 + 256, y * 256 + 256)).unwrap();
    let list: Vec<_> = (0..).zip(&places).map(|(key, at)| Solid::new(box_of(at), key).unwrap()).collect();
    let part = |r: &mut Random, most: i64| r.within(-most, most) * 64 + if r.one_in(3) { r.within(-1, 1) } else { 0 };
    let (mut most, mut none) = (0, 0);
    for _ in 0..20_000 {
        let p = (768 + part(&mut r, 20), 768 + part(&mut r, 20));
        let (d, size) = ((part(&mut r, 24), part(&mut r, 24)), (r.within(0, 6) * 64, r.within(0, 6) * 64));
        let wide = |v: (i64, i64)| (i128::from(v.0), i128::from(v.1));
        let due = |r: i64, size: (i64, i64)| -> Vec<_> {
            let near = |c: &&(i64, i64)| {
                let (lo, hi) = ((c.0 * 256 - size.0, c.1 * 256 - size.1), (c.0 * 256 + 256, c.1 * 256 + 256));
                comes_near(wide(p), wide(d), r.into(), wide(lo), wide(hi))
            };
            places.iter().filter(near).copied().collect()
        };
        let body = Aabb::new(raw(p.0, p.1), raw(p.0 + size.0, p.1 + size.1)).unwrap();
        let disc = Circle::new(raw(p.0, p.1), Fx::from_bits(size.0 as i32)).unwrap();
        let (boxes, discs) = (due(0, size), due(size.0, (0, 0)));
        assert_eq!(cells(&map, &body, raw(d.0, d.1)), boxes, "{body:?} by {d:?}");
        assert_eq!(cells(&map, &disc, raw(d.0, d.1)), discs, "{disc:?} by {d:?}");
        assert_eq!(cells(&map, &raw(p.0, p.1), raw(d.0, d.1)), due(0, (0, 0)), "{p:?} by {d:?}");
        let keys = |cells: &[(i64, i64)]| -> Vec<u16> { cells.iter().map(|c| (c.1 * 6 + c.0) as u16).collect() };
        let solids = Solids::new(&list);
        assert_eq!(solids.swept(&body, raw(d.0, d.1)).unwrap().map(Solid::key).collect::<Vec<_>>(), keys(&boxes));
        assert_eq!(solids.swept(&disc, raw(d.0, d.1)).unwrap().map(Solid::key).collect::<Vec<_>>(), keys(&discs));
        (most, none) = (most.max(boxes.len()), none + u32::from(boxes.is_empty()));
    }
    assert!(most > 20 && none > 1000, "{most} {none}");
}

/// On a way of several parts: those that one of the parts comes near, each once, whether it stops
/// the body or is passed.
#[test]
fn every_tile_and_solid_on_a_trail() {
    fn told<B: Body + Probe>(map: &TileMap<'_>, body: &B, d: Vec2) -> Option<(Trail, Vec<Cell>)> {
        static GHOSTS: TileKinds = KINDS.with(2, TileKind::EMPTY.with_flags(2));
        static WALLS: TileKinds = GHOSTS.with(3, TileKind::FULL);
        let (mut trail, seen) = (Trail::default(), map.with_kinds::<Blocks>(&WALLS).unwrap());
        let _ = Mover::new().with_response(Response::Bounce).move_along(&seen, body, d, &mut trail).ok()?;
        Some((trail, map.tiles_on(body, &trail).unwrap().map(|tile| tile.cell).collect()))
    }
    let mut r = Random::new(9);
    let places: Vec<(i64, i64)> = (0..64).map(|k| (k % 8, k / 8)).collect();
    let box_of = |&(x, y): &(i64, i64)| Aabb::new(raw(x * 256, y * 256), raw(x * 256 + 256, y * 256 + 256)).unwrap();
    let list: Vec<_> = (0..).zip(&places).map(|(key, at)| Solid::new(box_of(at), key).unwrap()).collect();
    let mut parts = [0; 5];
    for _ in 0..20_000 {
        let tiles: Vec<_> = (0..64).map(|_| [0, 1, 2, 2, 3][r.below(5) as usize]).collect();
        let map = TileMap::on_grid(&tiles, Grid::new(8, 8, Fx::from_bits(256), raw(0, 0)).unwrap(), &KINDS).unwrap();
        let (p, d) = ((r.within(0, 2048), r.within(0, 2048)), (r.around(3000), r.around(3000)));
        let size = (r.within(1, 300), r.within(1, 300));
        let body = Aabb::new(raw(p.0, p.1), raw(p.0 + size.0, p.1 + size.1)).unwrap();
        let disc = Circle::new(raw(p.0, p.1), Fx::from_bits(size.0 as i32)).unwrap();
        let wide = |v: (i64, i64)| (i128::from(v.0), i128::from(v.1));
        let due = |trail: &Trail, r: i64, size: (i64, i64)| -> Vec<(i64, i64)> {
            let legs: Vec<_> = trail.parts().map(|(from, by)| (from.raw(), by.raw())).collect();
            let legs = if legs.is_empty() { vec![((0, 0), (0, 0))] } else { legs };
            let near = |c: &&(i64, i64)| {
                let (lo, hi) = ((c.0 * 256 - size.0, c.1 * 256 - size.1), (c.0 * 256 + 256, c.1 * 256 + 256));
                legs.iter().any(|&((x, y), (dx, dy))| {
                    let (from, by) = ((p.0 + i64::from(x), p.1 + i64::from(y)), (dx.into(), dy.into()));
                    comes_near(wide(from), wide(by), r.into(), wide(lo), wide(hi))
                })
            };
            places.iter().filter(near).copied().collect()
        };
        let mut check =
            |told: Option<(Trail, Vec<Cell>)>, r: i64, size: (i64, i64), solids: &dyn Fn(&Trail) -> Vec<u16>| {
                let Some((trail, cells)) = told else { return };
                let due = due(&trail, r, size);
                let cells: Vec<(i64, i64)> = cells.iter().map(|cell| (cell.x.into(), cell.y.into())).collect();
                assert_eq!(cells, due, "{p:?} {size:?} by {d:?}, {trail:?}");
                assert_eq!(solids(&trail), due.iter().map(|c| (c.1 * 8 + c.0) as u16).collect::<Vec<_>>());
                parts[trail.parts().count()] += 1;
            };
        let solids = Solids::new(&list);
        let keys = |trail: &Trail| solids.on(&body, trail).unwrap().map(Solid::key).collect();
        check(told(&map, &body, raw(d.0, d.1)), 0, size, &keys);
        let keys = |trail: &Trail| solids.on(&disc, trail).unwrap().map(Solid::key).collect();
        check(told(&map, &disc, raw(d.0, d.1)), size.0, (0, 0), &keys);
    }
    assert!(parts[1..].iter().all(|&n| n > 100), "{parts:?}");
}

#[test]
fn out_of_range_is_refused() {
    let map = TileMap::on_grid(&[1], Grid::new(1, 1, Fx::ONE, Vec2::ZERO).unwrap(), &KINDS).unwrap();
    let body = Circle::new(Vec2::from_ints(8000, 0), Fx::ONE).unwrap();
    assert!(map.flags_swept(&body, Vec2::from_ints(200, 0)).is_err());
    assert!(map.flags_swept(&body, Vec2::from_ints(0, 4096)).is_err());
    assert_eq!(map.flags_swept(&body, Vec2::from_ints(-4095, 0)), Ok(0));
    assert!(map.tiles_swept(&body, Vec2::from_ints(200, 0)).is_err());
    assert!(Solids::new(&[]).swept(&body, Vec2::from_ints(0, 4096)).is_err());
}
