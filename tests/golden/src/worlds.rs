//! Every query of each kind of level.

use tilesat::Vec2;
use tilesat::world::{Joined, Placed, Solid, Solids};

use super::VECTORS;
use super::family::Run;
use super::hash::Hash;
use super::levels::{SIZE, SOLID, blocks, segments, shapes, slopes, solids};
use super::world::{SURFACE, VERBS, Vector, WORK, ask, ask_surface};

// The first four of the eight kinds of levels have a fifth of the vectors each, the others a tenth.

/// The three groups of hashes of a level with a surface.
fn split(hashes: &mut [Hash; 10]) -> Option<(&mut [Hash; 7], &mut [Hash; 2], &mut Hash)> {
    let (verbs, rest) = hashes.split_first_chunk_mut()?;
    let (surface, work) = rest.split_first_chunk_mut()?;
    Some((verbs, surface, work.first_mut()?))
}

const ALL: [&str; 10] = {
    let ([a, b, c, d, e, f, g], [h, i]) = (VERBS, SURFACE);
    [a, b, c, d, e, f, g, h, i, WORK]
};

macro_rules! tiled {
    ($run:expr, $name:literal, $map:expr) => {
        $run.family($name, VECTORS / 5, ALL, |number, r, hashes| {
            let Some((map, (verbs, surface, work))) = $map(number).zip(split(hashes)) else { return };
            let vector = Vector::draw(number, r, map.origin(), SIZE);
            ask(&map, &vector, verbs, work);
            ask_surface(&map, &vector, surface, work);
        });
    };
}

pub(crate) fn run_blocks(run: &mut Run<'_>) {
    tiled!(run, "blocks", blocks);
}

pub(crate) fn run_slopes(run: &mut Run<'_>) {
    tiled!(run, "slopes", slopes);
}

pub(crate) fn run_shapes(run: &mut Run<'_>) {
    tiled!(run, "shapes", shapes);
}

pub(crate) fn run_segments(run: &mut Run<'_>) {
    run.family("segments", VECTORS / 5, ALL, |number, r, hashes| {
        let Some((verbs, surface, work)) = split(hashes) else { return };
        let vector = Vector::draw(number, r, Vec2::ZERO, SIZE);
        ask(segments(), &vector, verbs, work);
        ask_surface(segments(), &vector, surface, work);
    });
}

pub(crate) fn run_joined(run: &mut Run<'_>) {
    run.family("joined", VECTORS / 10, ALL, |number, r, hashes| {
        // Both at one position: everything overlaps everything.
        let near = number % (6 * 4);
        let Some((map, (verbs, surface, work))) = shapes(near).zip(split(hashes)) else { return };
        let vector = Vector::draw(number, r, Vec2::ZERO, SIZE);
        let level = Joined::new(&map, segments());
        ask(&level, &vector, verbs, work);
        ask_surface(&level, &vector, surface, work);
    });
}

pub(crate) fn run_moving(run: &mut Run<'_>) {
    let of = |verbs: [&'static str; 7]| {
        let [a, b, c, d, e, f, g] = verbs;
        [a, b, c, d, e, f, g, WORK]
    };
    run.family("placed", VECTORS / 10, of(VERBS), |number, r, hashes| {
        let Some((verbs, [work])) = hashes.split_first_chunk_mut() else { return };
        let by = Vec2::from_raw(r.signed(27), r.signed(27));
        let Ok(level) = Placed::new(segments(), by) else { return };
        let vector = Vector::draw(number, r, by, SIZE);
        ask(&level, &vector, verbs, work);
    });
    let mut list = [SOLID; 4];
    run.family("solids", VECTORS / 10, of(VERBS), |number, r, hashes| {
        let Some((verbs, [work])) = hashes.split_first_chunk_mut() else { return };
        if number.is_multiple_of(8) {
            list = solids(r, Vec2::ZERO);
        } else {
            Solid::move_all(&mut list);
        }
        let vector = Vector::draw(number, r, Vec2::ZERO, SIZE);
        ask(&Solids::new(&list), &vector, verbs, work);
    });
    run.family("doors", VECTORS / 10, ALL, |number, r, hashes| {
        let near = number % (6 * 4);
        let Some((map, (verbs, surface, work))) = blocks(near).zip(split(hashes)) else { return };
        if number.is_multiple_of(8) {
            list = solids(r, Vec2::ZERO);
        }
        let solids = Solids::new(&list);
        let level = Joined::new(&map, &solids);
        let vector = Vector::draw(number, r, Vec2::ZERO, SIZE);
        ask(&level, &vector, verbs, work);
        ask_surface(&level, &vector, surface, work);
    });
}

pub(crate) fn run_tiles(run: &mut Run<'_>) {
    run.family(
        "tiles",
        VECTORS,
        ["flags_touched", "flags_swept", "tiles_in", "cell_at"],
        |number, r, [touched, swept, inside, cell]| {
            let Some(map) = shapes(number) else { return };
            let v = Vector::draw(number, r, map.origin(), SIZE);
            let p = v.ball.centre();
            if v.round {
                touched.add(map.flags_touched(&v.ball));
                swept.add(map.flags_swept(&v.ball, v.motion));
            } else {
                touched.add(map.flags_touched(&v.block));
                swept.add(map.flags_swept(&v.block, v.motion));
            }
            touched.add(map.flags_touched(&p));
            swept.add(map.flags_swept(&p, v.motion));
            for tile in map.tiles_in(&v.block).take(16) {
                inside.add(tile);
            }
            cell.add(map.cell_at(p));
            cell.add(map.tile(map.cell_at(p)));
        },
    );
}
