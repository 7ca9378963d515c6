//! Rows of a circle on a floor, with friction and without.

use core::mem::MaybeUninit;
use tilesat::{Axis, Circle, MoveError, Moved, Mover, Ratio, Surface, TileKind, TileKinds, TileMap, Vec2};
use tilesat_counts::inputs::{Random, UNIT, circle, vec};
use tilesat_counts::measure::{Query, Table, load};

const RUBBER: Surface = Surface::new(Ratio::HALF, Ratio::HALF);

static KINDS: TileKinds = TileKinds::EMPTY.with(1, TileKind::FULL);
/// A floor under four empty rows.
static TILES: [u8; 20 * 5] = {
    let mut tiles = [0; 20 * 5];
    let mut x = 0;
    while x < 20 {
        tiles[80 + x] = 1;
        x += 1;
    }
    tiles
};

/// The same step without and with friction.
pub fn rows(table: &mut Table) {
    type Step = Query<(Circle, Vec2), TileMap<'static>, Result<Moved<Circle>, MoveError>>;
    let Ok(map) = TileMap::new(&TILES, 20, 5, &KINDS) else {
        table.wrong += 1;
        return;
    };
    let smooth: Step =
        |body, map| MaybeUninit::new(Mover::platformer(Axis::NEG_Y).move_and_slide(map, &body.0, body.1));
    let rough: Step = |body, map| {
        let mover = Mover::platformer(Axis::NEG_Y).with_surface(RUBBER);
        MaybeUninit::new(mover.move_and_slide(map, &body.0, body.1))
    };
    let loads = |_: &(Circle, Vec2), _: &TileMap<'static>| -> Step { load::<_, _, _, 5, 0> };
    let floor = move |r: &mut Random| {
        let body = circle((r.raw(40, 240), 58 * UNIT), 6 * UNIT)?;
        Some(((body, vec((UNIT * 337 / 100, UNIT / 4))), map))
    };
    let ok = |moved: &Result<Moved<Circle>, MoveError>| moved.as_ref().is_ok_and(|m| m.floor);
    table.row("circle slides on a floor, no friction", None, smooth, loads, floor, ok);
    table.row("circle slides on a floor, friction", None, rough, loads, floor, ok);
}
