//! What a level is made of changes no bit (L4). The same blocks and slopes come as tiles, as
//! polygons, as tiles joined with solids, and as two maps of tiles. Boxes, circles and capsules
//! slide and walk in each. So what is shown of tiles holds in all of them (L1 to L8).

use super::walk_worlds::{Frame, step};
use tilesat::motion::Support;
use tilesat::{Aabb, Axis, Circle, Fx, Joined, Mover, PathKind, SegmentMap, Solids, Walker, World};
use tilesat_judge::Random;
use tilesat_judge::drawing::Drawing;
use tilesat_judge::rooms::body::{Body, vec2};
use tilesat_judge::rooms::room::Room;
use tilesat_judge::rooms::{P, PX};
use tilesat_judge::shapes::level::{Level, shape};
use tilesat_judge::shapes::region::Region;
use tilesat_judge::solids::solid;

const WIDE: i64 = 7;

/// Full cells, halves and slopes in a ring of full cells, without arcs, which polygons have not.
fn level(r: &mut Random) -> Level {
    let cell = [24 * PX, 16 * PX, 8 * PX, 2 * 54_321][r.below(4) as usize];
    let (dense, full) = ([20, 40, 60][r.below(3) as usize], r.one_in(2));
    let tile = |k: i64| {
        let ring = !(WIDE..WIDE * (WIDE - 1)).contains(&k) || k % WIDE == 0 || k % WIDE == WIDE - 1;
        let id = r.within(2, 25);
        let id = if id < 10 { id } else { id + 8 };
        if ring {
            1
        } else if r.below(100) >= dense {
            0
        } else if full {
            1
        } else {
            id as u8
        }
    };
    let tiles = (0..WIDE * WIDE).map(tile).collect();
    Level { tiles, width: WIDE, height: WIDE, cell, x: 0, y: 0, outside: tilesat::Outside::Empty }
}

/// Each tile as a polygon.
fn polygons(level: &Level) -> Drawing {
    let half = level.cell / 2;
    let tiles = level.tiles.iter().enumerate().filter_map(|(k, id)| {
        let (x, y) = (k as i64 % WIDE * level.cell, k as i64 / WIDE * level.cell);
        let Some(Region::Polygon(points)) = shape(*id).0 else { return None };
        Some((PathKind::Solid, points.iter().map(|p| (x + half * p.0 as i64, y + half * p.1 as i64)).collect()))
    });
    Drawing::of(level.cell, tiles.collect())
}

/// All of an answer but the names of what was hit.
type Bits = (Body, P, Option<P>, [bool; 3], usize);

const PLAYER: Mover = Mover::platformer(Axis::NEG_Y);

fn bits<W: World>(world: &W, walker: Option<&Walker>, body: Body, v: P) -> Bits {
    let Some(walker) = walker else {
        let out = body.step(&PLAYER, world, v).unwrap();
        return (out.body, out.v, Some(out.remaining), [out.floor, out.wall, out.ceiling], out.hits.len());
    };
    // What it stands on has another name in each level.
    let floor = supported(world, body);
    let Frame { body, v, floor, .. } = step(walker, world, body, v, floor).unwrap();
    (body, v, floor.map(|floor| (floor.axis.x.into(), floor.axis.y.into())), [false; 3], 0)
}

fn supported<W: World>(world: &W, body: Body) -> Option<Support> {
    let (lo, hi) = body.bounds();
    let supported = match body {
        Body::Rect(..) => PLAYER.supported(world, &Aabb::new(vec2(lo), vec2(hi)).unwrap()),
        Body::Disc(c, r) => PLAYER.supported(world, &Circle::new(vec2(c), Fx::from_bits(r as i32)).unwrap()),
        Body::Pill(p, core, r) => PLAYER.supported(world, &Body::capsule(p, core, r)),
    };
    supported.unwrap()
}

#[test]
fn what_a_level_is_made_of_changes_no_bit() {
    let mut r = Random::new(17);
    let (mut frames, mut hits, mut other) = (0, 0, [const { Vec::new() }; 3]);
    for _ in 0..tilesat_judge::cases(400) {
        let level = level(&mut r);
        let cell = level.cell;
        let room = Room::new(&Level { outside: tilesat::Outside::Solid, ..level.clone() });
        let bytes = polygons(&level).bytes();
        // Full cells are tiles of one map, tiles of another, or solids.
        let (mut first, mut second, mut rest, mut list) = (level.clone(), level.clone(), level.clone(), Vec::new());
        for (k, id) in level.tiles.iter().enumerate() {
            if r.one_in(2) {
                first.tiles[k] = 0;
            } else {
                second.tiles[k] = 0;
            }
            let (x, y) = (k as i64 % WIDE * cell, k as i64 / WIDE * cell);
            if *id == 1 && r.one_in(2) {
                rest.tiles[k] = 0;
                list.push(solid((x, y), (x + cell, y + cell), k as u16));
            }
        }
        let solids = Solids::new(&list);
        let (tiles, segments) = (level.all(), SegmentMap::from_bytes(&bytes).unwrap());
        let (first, second, rest) = (first.all(), second.all(), rest.all());
        let (cut, among) = (Joined::new(&first, &second), Joined::new(&rest, &solids));
        let walker = Walker::new(PLAYER).with_snap(Fx::from_bits(cell as i32 / 4)).unwrap();
        let walker = walker.with_step(Fx::from_bits(cell as i32 / 3)).unwrap();
        for n in 0..8 {
            let half = [cell / 2, cell / 4, cell / 8, cell * 3 / 16, cell / 3][r.below(5) as usize];
            let at = (r.within(cell, 6 * cell), r.within(cell, 6 * cell));
            let mut body = match r.below(3) {
                0 => Body::Disc(at, half),
                1 => Body::Rect((at.0 - half, at.1 - half), (2 * half, 2 * half)),
                _ => Body::Pill(at, if r.one_in(2) { (half, 0) } else { (0, -half) }, half),
            };
            if room.overlaps(body, (0, 0), 0) {
                continue;
            }
            let walker = (n % 2 == 0).then_some(&walker);
            let mut v = (r.around(cell), r.around(cell));
            for frame in 0..12 {
                v.1 += cell / 30;
                if walker.is_some() {
                    v.0 = if frame % 4 == 0 { r.around(cell / 4) } else { v.0 };
                }
                let one = bits(&tiles, walker, body, v);
                let asked =
                    [bits(&segments, walker, body, v), bits(&cut, walker, body, v), bits(&among, walker, body, v)];
                frames += 1;
                hits += u32::from(one.1 != v);
                for (two, other) in asked.into_iter().zip(&mut other) {
                    if two != one {
                        other.push((level.tiles.clone(), cell, body, v, one, two));
                    }
                }
                (body, v) = (one.0, one.1);
            }
        }
    }
    assert!(hits > frames / 4, "{hits} of {frames}");
    let counts = other.each_ref().map(Vec::len);
    let firsts = other.each_ref().map(|o| o.first());
    assert_eq!(counts, [0; 3], "polygons, two maps, solids, of {frames} frames, such as {firsts:?}");
}
