//! The surface of all shapes against polygons whose half edges cancel: every pair, every corner,
//! random mosaics, every outside.

use std::collections::{BTreeMap, BTreeSet};
use tilesat::AllShapes;
use tilesat_judge::surface::mosaic::{Mosaic, OUTSIDES};
use tilesat_judge::surface::outline::construct;
use tilesat_judge::surface::piece::{Kind, Piece};
use tilesat_judge::surface::polygon::{Point, solid};
use tilesat_judge::{Random, cases};

fn check(mosaic: &Mosaic) {
    let got = mosaic.features::<AllShapes>();
    let set: BTreeSet<_> = got.iter().copied().collect();
    assert_eq!(set.len(), got.len(), "twice: {mosaic:?}");
    let expected = construct(mosaic);
    assert!(
        set == expected,
        "{mosaic:?}\nmissing {:#?}\ntoo many {:#?}",
        expected.difference(&set).collect::<Vec<_>>(),
        set.difference(&expected).collect::<Vec<_>>()
    );
}

fn ids() -> Vec<u8> {
    (0..38).collect()
}

/// The vertices of a mosaic in halves of a cell.
fn vertices(width: i64, height: i64, tiles: &[u8]) -> BTreeSet<(Point, Point, Point)> {
    let mosaic = Mosaic { cell: 256, origin: (0, 0), ..Mosaic::new(width, height, tiles.to_vec()) };
    let features = mosaic.features::<AllShapes>();
    let vertex = |p: &Piece| match p.kind {
        Kind::Vertex { p, e_in, e_out } => Some(((p.0 / 128, p.1 / 128), e_in, e_out)),
        _ => None,
    };
    features.iter().filter_map(vertex).collect()
}

/// Small levels whose corners can be counted by hand.
#[test]
fn joints_written_down() {
    let (right, down, left, up) = ((1, 0), (0, 1), (-1, 0), (0, -1));
    // A hill of two mild slopes on a floor: a corner at each end of the slope, none between the two
    // and none where it leaves the floor's side.
    let hill = [((0, 2), up, (2, -1)), ((4, 0), (2, -1), down), ((4, 4), down, left), ((0, 4), left, up)];
    assert_eq!(vertices(2, 2, &[20, 24, 1, 1]), hill.into());
    // A floor that bends up into a quarter pipe: smooth below, no angle at all on top.
    let pipe = [((0, 2), up, right), ((4, 0), up, down), ((4, 4), down, left), ((0, 4), left, up)];
    assert_eq!(vertices(2, 2, &[0, 16, 1, 1]), pipe.into());
    // Two quarter discs side by side: smooth on top.
    let arch = [((4, 2), down, left), ((0, 2), left, up)];
    assert_eq!(vertices(2, 1, &[12, 13]), arch.into());
    // A quarter disc below a ceiling that is its tangent. The gap between them has no angle, but it
    // is a gap. Otherwise its corner would be a flat joint.
    let ceiling = [((0, 0), up, right), ((4, 0), right, down), ((4, 2), down, left), ((0, 2), left, up)];
    let disc = [((2, 2), up, right), ((4, 4), down, left), ((2, 4), left, up)];
    assert_eq!(vertices(2, 2, &[1, 1, 0, 13]), ceiling.into_iter().chain(disc).collect());
    // Two tiles that meet in a point: a corner each.
    let first = [((0, 0), up, right), ((2, 0), right, down), ((2, 2), down, left), ((0, 2), left, up)];
    let second = [((2, 2), up, right), ((4, 2), right, down), ((4, 4), down, left), ((2, 4), left, up)];
    assert_eq!(vertices(2, 2, &[1, 0, 0, 1]), first.into_iter().chain(second).collect());
}

#[test]
fn every_pair_of_neighbours() {
    for a in ids() {
        for b in ids() {
            check(&Mosaic::new(2, 1, vec![a, b]));
            check(&Mosaic::new(1, 2, vec![a, b]));
            check(&Mosaic::new(2, 2, vec![a, 0, 0, b]));
            check(&Mosaic::new(2, 2, vec![0, a, b, 0]));
        }
    }
}

/// One shape for each different border around a corner.
fn kinds_of_corner(corner: (i64, i64)) -> Vec<u8> {
    let mut kinds = BTreeMap::new();
    for id in 0..34u8 {
        let edges = solid(id);
        let ends: Vec<_> = edges.iter().filter(|e| e.a == corner || e.b == corner).collect();
        let key: BTreeSet<_> = ends.iter().map(|e| (e.a == corner, e.out(), e.arrival(), e.arc.is_some())).collect();
        kinds.entry(key).or_insert(id);
    }
    kinds.into_values().collect()
}

#[test]
fn every_corner_of_four_tiles() {
    let [a, b, c, d] = [(2, 2), (0, 2), (2, 0), (0, 0)].map(kinds_of_corner);
    assert_eq!([&a, &b, &c, &d].map(Vec::len), [12; 4]);
    for &a in &a {
        for &b in &b {
            for &c in &c {
                for &d in &d {
                    check(&Mosaic::new(2, 2, vec![a, b, c, d]));
                }
            }
        }
    }
}

#[test]
fn random_mosaics() {
    let mut random = Random::new(31);
    for i in 0..cases(8_000) {
        // All shapes, or a few of them, so that many joints occur.
        let few: Vec<u8> = (0..random.within(2, 5)).map(|_| random.below(38) as u8).collect();
        let ids = if random.one_in(2) { ids() } else { few };
        let (width, height) = if i % 4 == 0 { (5, 5) } else { (3, 3) };
        check(&Mosaic::random(&mut random, width, height, &ids));
    }
}

#[test]
fn what_is_outside() {
    let mut random = Random::new(32);
    for outside in OUTSIDES {
        for id in ids() {
            check(&Mosaic { outside, ..Mosaic::new(1, 1, vec![id]) });
        }
        for _ in 0..cases(9_000) / 3 {
            let (width, height) = (random.within(1, 4), random.within(1, 4));
            check(&Mosaic { outside, ..Mosaic::random(&mut random, width, height, &ids()) });
        }
    }
}
