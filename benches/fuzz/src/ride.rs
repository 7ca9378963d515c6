//! Bodies on, before and between moving solids. The solids carry, push and squash them, and the
//! bodies move after each tick. The judges of the tests check all of it.

use tilesat::prelude::*;
use tilesat::world::ShapeSet;
use tilesat::{AllShapes, Blocks, Fx, Joined, Side, Solid, Solids, TileKinds, TileMap, World};
use tilesat_judge::Random;
use tilesat_judge::solids::judge::{Block, Judged};
use tilesat_judge::solids::ticks::{
    ALL, CELL, FOLLOW, MOVER, SIDE, Scene, Seen, balls, boxes, grid, solids, steer, tiles,
};
use tilesat_judge::solids::twins::{BLOCKS, KINDS, mirrored_level};
use tilesat_judge::solids::{raw, rect, show};

/// Most ticks per scene.
const TICKS: i64 = 12;

pub(crate) fn ride(data: &[u8]) {
    let mut r = Random::steered(data);
    if r.one_in(4) {
        return carried(&mut r);
    }
    if r.one_in(2) {
        let tiles = tiles(&mut r, 1);
        let full = (0..SIDE * SIDE).filter(|&i| tiles[i as usize] == 1).map(|i| (i % SIDE * CELL, i / SIDE * CELL));
        let cells = full.map(|lo| Block { lo, hi: (lo.0 + CELL, lo.1 + CELL) }).collect();
        play::<Blocks>(&mut r, &tiles, &BLOCKS, Some(cells));
    } else {
        let tiles = tiles(&mut r, 37);
        play::<AllShapes>(&mut r, &tiles, &KINDS, None);
    }
}

/// A level, its mirror image and a shifted copy.
fn play<S: ShapeSet>(r: &mut Random, tiles: &[u8], kinds: &TileKinds, cells: Option<Vec<Block>>)
where
    for<'m> TileMap<'m, S>: World,
    for<'m, 's> Joined<'s, TileMap<'m, S>, Solids<'s>>: Overlaps<tilesat::Aabb> + Overlaps<tilesat::Circle>,
{
    let by = (r.around(900_000), r.around(900_000));
    let turned = mirrored_level(tiles, SIDE as usize);
    let map = |tiles, at| TileMap::<S>::of(tiles, grid(at), kinds).expect("the table has all ids");
    let (level, mirror, moved) = (map(tiles, (0, 0)), map(&turned, (-ALL, 0)), map(tiles, by));
    let scene = Scene { level: &level, mirror: &mirror, moved: &moved, by, cells };
    let (ticks, mut seen) = (r.within(1, TICKS) as u32, Seen::default());
    if r.one_in(2) { scene.play(boxes, ticks, r, &mut seen) } else { scene.play(balls, ticks, r, &mut seen) }
}

/// The carry of a body on a named solid: its motion and its belt. Nothing if its side is farther
/// than a contact away.
fn carried(r: &mut Random) {
    let mut list = solids(r);
    steer(&mut list, r);
    let on = list[r.below(list.len() as i64) as usize];
    let (top, above) = (Block::of(&on.shape()), r.around(3));
    let (left, width, height) = (top.lo.0 + r.around(2), r.within(1, CELL), r.within(1, CELL));
    let body = rect((left, top.lo.1 - above - height), (left + width, top.lo.1 - above));
    let level = TileMap::on_grid(&[0; (SIDE * SIDE) as usize], grid((0, 0)), &BLOCKS).expect("an empty level");
    let ridden = MOVER.ride(&level, &list, &body, Fx::from_bits(FOLLOW as i32)).expect("inside the domain");
    let block = body.block();
    let carries = |s: &Solid| {
        let (b, (_, sinks)) = (Block::of(&s.shape()), raw(s.motion()));
        let has_top = s.one_way().is_none_or(|side| side == Side::Up);
        has_top && sinks <= FOLLOW && block.hi.1 == b.lo.1 && block.lo.0 < b.hi.0 && b.lo.0 < block.hi.0
    };
    let case = || format!("{}\n{block:?}\n{ridden:?}", show(&list));
    match ridden.floor {
        None => assert!(!list.iter().any(carries), "carried by nothing: {}", case()),
        Some(key) => {
            let goes = |s: &Solid| raw(s.motion() + s.conveyor()) == raw(ridden.carry);
            assert!(list.iter().any(|s| s.key() == key && carries(s) && goes(s)), "carried wrongly: {}", case());
        }
    }
}
