//! `levels.csv`, `tile_rays.csv` and `tile_bodies.csv`: levels of all 34 shapes and one-way edges,
//! with rays and bodies.

use super::table::{Table, bit, list, maybe, pair};
use tilesat::Outside;
use tilesat_judge::Random;
use tilesat_judge::Random as Own;
use tilesat_judge::rays::cast::Scene;
use tilesat_judge::rays::generate::ray;
use tilesat_judge::rays::level::Level;
use tilesat_judge::shapes::judge::{Body, Judge};
use tilesat_judge::shapes::level as solid;

const LEVELS: u64 = 60;
const RAYS: u64 = 30;
const BODIES: u64 = 24;

/// One character per shape, by its number.
pub(crate) const DIGITS: &[u8; 38] = b"0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZab";

fn tiles(level: &Level) -> String {
    let rows = level.tiles.chunks(level.width as usize);
    let text = |row: &[u8]| row.iter().map(|id| char::from(DIGITS[usize::from(id % 64)])).collect::<String>();
    rows.map(text).collect::<Vec<_>>().join("/")
}

fn outside(level: &Level) -> &'static str {
    match level.outside {
        Outside::Empty => "empty",
        Outside::Solid => "solid",
        Outside::Edge => "edge",
    }
}

pub(crate) fn make() -> (Table, Table, Table) {
    let mut levels = Table::new("level,cell,origin,outside,tiles");
    let mut rays = Table::new("id,level,from,motion,one_way,inside,hit,toi30,normal,cell");
    let mut bodies = Table::new("id,level,body,overlaps,touches");
    for number in 0..LEVELS {
        let level = Level::random(&mut Random::new(0x1e7e1 + number));
        levels.push(&[
            number.to_string(),
            level.cell.to_string(),
            pair(level.origin),
            outside(&level).into(),
            tiles(&level),
        ]);
        let (scene, mut r) = (Scene::new(&level), Random::new(0x7a75 + number));
        let arcs = level.tiles.iter().any(|id| (10..18).contains(&(id % 64)));
        let mut made = 0;
        while made < RAYS {
            let ((o, d), one_way) = (ray(&mut r, &level, &scene), r.one_in(3));
            // Along a grid line there can be a gap between an arc and the solid that it touches.
            // The ray enters there without a piece in its way.
            let on_line = (d.0 == 0 && (o.0 - level.origin.0) % level.cell == 0)
                || (d.1 == 0 && (o.1 - level.origin.1) % level.cell == 0);
            if arcs && on_line {
                continue;
            }
            made += 1;
            let inside = scene.inside(o);
            let hits = if inside { Vec::new() } else { scene.cast(o, d, one_way) };
            let first = hits.first();
            let toi = first.map(|group| group[0].moment.floor_of(1 << 30));
            let normal = first.and_then(|group| group[0].normal);
            // Only if no other piece is equally good.
            let cell = first
                .filter(|group| group.iter().all(|h| h.piece.owner == group[0].piece.owner))
                .map(|group| group[0].piece.owner);
            rays.push(&[
                rays.rows.len().to_string(),
                number.to_string(),
                pair(o),
                pair(d),
                bit(one_way),
                bit(inside),
                bit(first.is_some()),
                maybe(toi),
                normal.map_or_else(String::new, |n| list(&[n])),
                maybe(cell.filter(|c| (0..level.width).contains(&c.0) && (0..level.height).contains(&c.1)).map(pair)),
            ]);
        }
        crowd(number, &level, &mut bodies);
    }
    (levels, rays, bodies)
}

/// Bodies on the lattice of quarter cells and beside it; without size, flat, and larger than a
/// cell.
fn crowd(number: u64, level: &Level, table: &mut Table) {
    let plain = solid::Level {
        width: level.width,
        height: level.height,
        cell: level.cell,
        x: level.origin.0,
        y: level.origin.1,
        outside: level.outside,
        tiles: level.tiles.iter().map(|id| id % 64).collect(),
    };
    let (judge, mut r) = (Judge::new(&plain), Own::new(0xb0d1 + number));
    let mut made = 0;
    while made < BODIES {
        let at = |r: &mut Own, origin: i64, count: i64| {
            let off = if r.one_in(2) { 0 } else { r.around(2) };
            origin + r.within(-2, 4 * count + 2) * level.cell / 4 + off
        };
        let (x, y) = (at(&mut r, level.origin.0, level.width), at(&mut r, level.origin.1, level.height));
        let size = |r: &mut Own| match r.below(4) {
            0 => 0,
            1 => level.cell / 4 * r.within(1, 6),
            2 => r.within(1, 3),
            _ => r.within(1, level.cell),
        };
        let (w, h) = (size(&mut r), size(&mut r));
        let limit = 1 << 29;
        if x.abs() + w.max(h) >= limit || y.abs() + w.max(h) >= limit {
            continue;
        }
        let (body, text) = if r.one_in(2) {
            (Body::Circle { c: (x, y), r: w }, format!("C {x} {y} {w}"))
        } else {
            (Body::Box { lo: (x, y), hi: (x + w, y + h) }, format!("B {x} {y} {} {}", x + w, y + h))
        };
        let id = table.rows.len().to_string();
        table.push(&[id, number.to_string(), text, bit(judge.overlaps(body)), bit(judge.touches(body))]);
        made += 1;
    }
}
