//! What a motion is handed of a level's surface, against all of the surface: the first hit is the
//! same.

use super::std::vec::Vec;
use super::{Entry, Kernel, Raw, Vec2, vec2};
use crate::num::Fx;
use crate::shape::{Aabb, Circle};
use crate::world::{AllShapes, Feature, Grid, Outside, ShapeSet, Slopes, TileKind, TileKinds, TileMap, TileShape};
use crate::world::{MotionPiece, World};
use tilesat_judge::Random;

const SIDE: i32 = 6;
/// Odd halves, no power of two.
const CELL: i32 = 1002;

fn hull(body: &Aabb, d: Raw, margin: i32) -> Aabb {
    let (lo, hi) = (body.lo(), body.hi());
    Aabb::from_raw_unchecked(
        Raw { x: lo.x + d.x.min(0) - margin, y: lo.y + d.y.min(0) - margin },
        Raw { x: hi.x + d.x.max(0) + margin, y: hi.y + d.y.max(0) + margin },
    )
}

fn first<B: Kernel>(body: &B, d: Raw, features: impl Iterator<Item = Feature>) -> Option<Entry> {
    features.filter_map(|f| body.sweep(d, &f)).reduce(|a, b| if b.before_askew(&a, d) { b } else { a })
}

fn agree<S: ShapeSet, B: Kernel>(map: &TileMap<'_, S>, body: &B, d: Raw, hits: &mut u32) {
    if d.is_zero() || body.overlaps_world(map) {
        return;
    }
    let bounds = body.bounds();
    let whole = hull(&bounds, d, 1);
    let way = MotionPiece { piece: &whole, cells: None, before: None, whole, d, joints: body.meets_joints() };
    let (found, wanted) = (first(body, d, map.features_ahead(&way)), first(body, d, World::features(map, &whole)));
    *hits += u32::from(wanted.is_some());
    match (found, wanted) {
        (None, None) => {}
        (Some(a), Some(b)) if a.same_as(&b) => {}
        other => panic!("{other:?}: {bounds:?} by {d:?}"),
    }
}

fn kinds<S: ShapeSet>() -> TileKinds {
    (0..38).fold(TileKinds::EMPTY, |kinds, id: u8| {
        let shape = TileShape::ALL[usize::from(id)];
        if S::SHAPES >> id & 1 == 0 { kinds } else { kinds.with(id, TileKind::of(shape)) }
    })
}

fn levels<S: ShapeSet>(random: &mut Random, mut test: impl FnMut(&TileMap<'_, S>, &mut Random)) {
    let kinds = kinds::<S>();
    for outside in [Outside::Empty, Outside::Solid, Outside::Edge].into_iter().cycle().take(60) {
        let tiles: Vec<u8> =
            (0..SIDE * SIDE).map(|_| if random.below(2) == 0 { 0 } else { random.below(38) as u8 }).collect();
        let grid = Grid::new(SIDE as u16, SIDE as u16, Fx::from_bits(CELL), Vec2::ZERO).expect("a grid");
        test(&TileMap::of(&tiles, grid, &kinds).expect("a level").with_outside(outside), random);
    }
}

/// On half cells, so that sides, corners and middles are touched, or anywhere.
fn place(random: &mut Random, from: i32, to: i32) -> i32 {
    let at = from + random.below(i64::from(to - from)) as i32;
    if random.below(2) == 0 { at / (CELL / 2) * (CELL / 2) } else { at }
}

#[test]
fn the_first_hit_is_among_what_lies_ahead() {
    let (mut random, mut hits) = (Random::new(11), 0);
    levels::<AllShapes>(&mut random, |map, r| {
        for _ in 0..300 {
            let (x, y) = (place(r, -CELL, 7 * CELL), place(r, -CELL, 7 * CELL));
            let body = Circle::from_raw_unchecked(Raw { x, y }, place(r, 0, CELL));
            agree(map, &body, Raw { x: place(r, -2 * CELL, 2 * CELL), y: place(r, -2 * CELL, 2 * CELL) }, &mut hits);
        }
    });
    levels::<Slopes>(&mut random, |map, r| {
        for _ in 0..300 {
            let (x, y) = (place(r, -CELL, 7 * CELL), place(r, -CELL, 7 * CELL));
            let max = vec2((i64::from(x + place(r, 1, CELL)), i64::from(y + place(r, 1, CELL))));
            let body = Aabb::new(Vec2::from_raw(x, y), max).expect("a box");
            agree(map, &body, Raw { x: place(r, -2 * CELL, 2 * CELL), y: place(r, -2 * CELL, 2 * CELL) }, &mut hits);
        }
    });
    assert!(hits > 3000, "{hits}");
}
