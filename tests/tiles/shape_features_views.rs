//! Other views of the surface of all shapes: turned, mirrored, in regions, one byte later, as
//! blocks, as slopes.

use std::collections::BTreeSet;
use tilesat::world::ShapeSet;
use tilesat::{Aabb, AllShapes, Blocks, Cell, Outside, Slopes, TileKind, TileMap, Vec2, world::Bytes};
use tilesat_judge::surface::mosaic::{KINDS, Mosaic, OUTSIDES};
use tilesat_judge::surface::outline::construct;
use tilesat_judge::surface::piece::{Kind, Piece};
use tilesat_judge::surface::polygon::Point;
use tilesat_judge::surface::turn::{TURNS, Turn};
use tilesat_judge::{Random, cases};

const BLOCKS: [u8; 6] = [0, 1, 34, 35, 36, 37];

fn anything(random: &mut Random, ids: &[u8]) -> Mosaic {
    let (width, height) = (random.within(1, 4), random.within(1, 4));
    let outside = OUTSIDES[random.below(3) as usize];
    Mosaic { outside, ..Mosaic::random(random, width, height, ids) }
}

fn turned<S: ShapeSet>(mosaic: &Mosaic, turn: Turn) {
    let same = Turn { mirror: false, quarters: 0 };
    let expected: BTreeSet<_> = mosaic.features::<S>().iter().map(|p| turn.piece(p)).collect();
    let got: BTreeSet<_> = turn.mosaic(mosaic).features::<S>().iter().map(|p| same.piece(p)).collect();
    assert_eq!(got, expected, "{mosaic:?} {turn:?}");
}

/// With blocks, this holds one-way edges in four directions to those that block from above.
#[test]
fn turned_and_mirrored_levels_have_turned_and_mirrored_features() {
    let mut random = Random::new(33);
    let all: Vec<u8> = (0..38).collect();
    for _ in 0..cases(18_000) / 6 {
        let turn = TURNS[random.below(7) as usize];
        turned::<AllShapes>(&anything(&mut random, &all), turn);
        turned::<Blocks>(&anything(&mut random, &BLOCKS), turn);
    }
}

#[test]
fn a_region_gives_exactly_the_boxes_that_meet_it() {
    let mut random = Random::new(34);
    let all: Vec<u8> = (0..38).collect();
    for _ in 0..cases(40_000) / 40 {
        let mosaic = anything(&mut random, &all);
        in_regions::<AllShapes>(&mut random, &mosaic);
        let mosaic = anything(&mut random, &BLOCKS);
        in_regions::<Blocks>(&mut random, &mosaic);
    }
}

fn in_regions<S: ShapeSet>(random: &mut Random, mosaic: &Mosaic) {
    let (map, all) = (mosaic.map::<S>(), mosaic.features::<S>());
    for _ in 0..20 {
        let mut coordinate = |from: i64, count: i64| {
            let v = from + random.within(-2, 2 * count + 2) * mosaic.cell / 2 + random.within(-1, 1) * random.below(3);
            v.clamp(1 - (1 << 29), (1 << 29) - 1)
        };
        let (x, y) = (coordinate(mosaic.origin.0, mosaic.width), coordinate(mosaic.origin.1, mosaic.height));
        let (z, w) = (coordinate(mosaic.origin.0, mosaic.width), coordinate(mosaic.origin.1, mosaic.height));
        let (lo, hi) = ((x.min(z), y.min(w)), (x.max(z), y.max(w)));
        let corner = |p: Point| Vec2::from_raw(p.0 as i32, p.1 as i32);
        let region = Aabb::new(corner(lo), corner(hi)).unwrap();
        let got: Vec<_> = map.features(&region).map(|f| Piece::of(&f)).collect();
        let meets = |p: &&Piece| {
            let (a, b) = p.bounds();
            a.0.min(b.0) <= hi.0 && a.0.max(b.0) >= lo.0 && a.1.min(b.1) <= hi.1 && a.1.max(b.1) >= lo.1
        };
        let expected: Vec<_> = all.iter().filter(meets).copied().collect();
        assert_eq!(got, expected, "{mosaic:?} {region:?}");
    }
}

#[test]
fn one_byte_changes_its_tile_and_its_neighbours() {
    let mut random = Random::new(35);
    let all: Vec<u8> = (0..38).collect();
    for _ in 0..cases(20_000) / 8 {
        let before = Mosaic::random(&mut random, 6, 6, &all);
        let mut after = before.clone();
        let (x, y) = (random.below(6), random.below(6));
        after.tiles[(6 * y + x) as usize] = random.below(38) as u8;
        let far = |p: &&Piece| (p.cell.0 - x).abs() > 1 || (p.cell.1 - y).abs() > 1;
        let (old, new) = (before.features::<AllShapes>(), after.features::<AllShapes>());
        assert!(old.iter().filter(far).eq(new.iter().filter(far)), "{before:?} {after:?}");
        assert_eq!(new.into_iter().collect::<BTreeSet<_>>(), construct(&after));
    }
}

#[test]
fn a_level_of_blocks_is_the_same_in_every_set() {
    let mut random = Random::new(36);
    for _ in 0..cases(20_000) / 4 {
        let mosaic = anything(&mut random, &BLOCKS);
        let (blocks, all) = (mosaic.features::<Blocks>(), mosaic.features::<AllShapes>());
        if mosaic.outside == Outside::Edge {
            // Border blocks reach to the end of the domain, shaped tiles have bands beyond them:
            // the faces are cut elsewhere.
            assert_eq!(whole(&blocks), whole(&all), "{mosaic:?}");
        } else {
            assert_eq!(blocks, all, "{mosaic:?}");
        }
    }
}

/// Without owners, and with faces that continue each other joined. A piece of no length joins the
/// face that it continues.
fn whole(pieces: &[Piece]) -> BTreeSet<(bool, Kind)> {
    let mut out: BTreeSet<_> = pieces.iter().map(|p| (p.one_way, p.kind)).collect();
    out.retain(|(_, kind)| !matches!(kind, Kind::Face { a, b, .. } if a == b));
    loop {
        let faces = out.iter().filter_map(|&(one_way, kind)| match kind {
            Kind::Face { a, b, dir, joined } => Some((one_way, a, b, dir, joined)),
            _ => None,
        });
        let faces: Vec<_> = faces.collect();
        let pair = faces.iter().find_map(|x| {
            let follows = |y: &&(bool, Point, Point, Point, [bool; 2])| x.0 == y.0 && x.2 == y.1 && x.3 == y.3;
            faces.iter().find(follows).map(|y| (*x, *y))
        });
        let Some(((one_way, a, b, dir, first), (_, c, d, _, second))) = pair else { return out };
        assert!(first[1] && second[0]);
        out.remove(&(one_way, Kind::Face { a, b, dir, joined: first }));
        out.remove(&(one_way, Kind::Face { a: c, b: d, dir, joined: second }));
        out.insert((one_way, Kind::Face { a, b: d, dir, joined: [first[0], second[1]] }));
    }
}

#[test]
fn a_level_of_slopes_is_the_same_without_arcs_in_the_set() {
    let mut random = Random::new(37);
    let straight: Vec<u8> = (0..38).filter(|id| !(10..18).contains(id)).collect();
    for _ in 0..cases(20_000) / 4 {
        let mosaic = anything(&mut random, &straight);
        assert_eq!(mosaic.features::<Slopes>(), mosaic.features::<AllShapes>(), "{mosaic:?}");
    }
}

/// A kind also describes the repeated border, with the flags of the border tile.
#[test]
fn kinds_beyond_the_border() {
    let mosaic = Mosaic { outside: Outside::Edge, ..Mosaic::new(2, 2, vec![8, 3, 34, 17]) };
    let map: TileMap<'_, AllShapes, Bytes> = mosaic.map();
    for cell in mosaic.cells() {
        let (x, y) = (cell.0 as i16, cell.1 as i16);
        let flags = KINDS.get(mosaic.tiles[(2 * y.clamp(0, 1) + x.clamp(0, 1)) as usize]).flags;
        let shape = KINDS.get(mosaic.id(cell)).shape;
        assert_eq!(map.kind(Cell::new(x, y)), TileKind { shape, flags }, "{cell:?}");
    }
}
