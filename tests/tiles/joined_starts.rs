//! Rays of joined levels that start on the borders and on the seams of their solids, against one
//! map of the union.

use tilesat::world::RayRules;
use tilesat::{AllShapes, Axis, Fx, Grid, Inside, Joined, RayHit, TileKind, TileKinds, TileMap, TileShape, Toi, Vec2};
use tilesat_judge::{Random, cases};

/// The kinds are the shapes, by their numbers.
static KINDS: TileKinds = {
    let (mut kinds, mut i) = (TileKinds::EMPTY, 0);
    while i < TileShape::ALL.len() {
        kinds = kinds.with(i as u8, TileKind::of(TileShape::ALL[i]));
        i += 1;
    }
    kinds
};

/// The kinds with an arc.
const ARCS: std::ops::Range<u8> = TileShape::ConvexTopLeft as u8..TileShape::MildLowTopLeft as u8;

/// The side of a cell, in units.
const SIDE: i16 = 8;

fn map(tiles: &[u8], width: u16) -> TileMap<'_, AllShapes> {
    let grid = Grid::new(width, tiles.len() as u16 / width, Fx::from_num(SIDE), Vec2::ZERO).unwrap();
    TileMap::<AllShapes>::of(tiles, grid, &KINDS).unwrap()
}

/// The time, the point and the normal of a hit, and whether it starts inside. Pieces with one
/// normal that are met at the same moment are equal.
type Seen = (Toi, Vec2, Axis, bool);

fn seen(hit: RayHit) -> Seen {
    (hit.toi, hit.point, hit.axis, hit.inside)
}

/// The points with `step` units between them, one step around the map included.
fn lattice(width: i16, height: i16, step: i16) -> impl Iterator<Item = Vec2> + Clone {
    let along = move |cells: i16| (-step..=cells * SIDE + step).step_by(step as usize);
    along(height).flat_map(move |y| along(width).map(move |x| Vec2::from_ints(x, y)))
}

/// All rays of the half-cell lattice, through all hits, for all ways to split four cells of blocks
/// between two levels or to cover them twice.
#[test]
fn blocks_of_four_cells_from_anywhere() {
    let full = TileShape::Full as u8;
    let tiles = |bits: u32| -> [u8; 4] { core::array::from_fn(|i| if bits >> i & 1 == 1 { full } else { 0 }) };
    let points = lattice(2, 2, SIDE / 2);
    let (mut rays, mut hits) = (0, 0);
    for (first, second) in (0..256).map(|bits| (bits & 15, bits >> 4)) {
        let (a, b, union) = (tiles(first), tiles(second), tiles(first | second));
        let (a, b, union) = (map(&a, 2), map(&b, 2), map(&union, 2));
        let pair = Joined::new(&a, &b);
        for (o, e) in points.clone().flat_map(|o| points.clone().map(move |e| (o, e))) {
            for inside in [Inside::Hit, Inside::Ignore] {
                let got = pair.cast_ray_all(o, e - o, inside).unwrap().map(seen);
                let expected = union.cast_ray_all(o, e - o, inside).unwrap().map(seen);
                hits += expected.clone().count();
                assert!(got.eq(expected), "{first:b} and {second:b}: {o} to {e}, {inside:?}");
                rays += 1;
            }
        }
    }
    assert_eq!(rays, 256 * 49 * 49 * 2);
    println!("{rays} rays, {hits} hits");
}

/// The first hit of rays from lattice points, in random levels of six cells of all shapes that are
/// split between three levels.
///
/// Beside another level arcs and faces that end where an arc ends stay whole, so a ray may stop
/// early there, or with another normal. Along the line of a gap that closes to nothing it may pass.
#[test]
fn all_shapes_of_six_cells() {
    let mut random = Random::new(61);
    let points: Vec<Vec2> = lattice(3, 2, SIDE / 4).collect();
    let (mut rays, mut starts, mut inside, mut unlike) = (0u64, 0u64, 0u64, 0u64);
    while rays < cases(300_000) {
        let cells: [u8; 6] = core::array::from_fn(|_| if random.below(3) == 0 { 1 } else { random.below(38) as u8 });
        let mut parts = [[0; 6]; 3];
        for (i, &tile) in cells.iter().enumerate() {
            parts[random.below(3) as usize][i] = tile;
        }
        let ([a, b, c], union) = (parts.each_ref().map(|part| map(part, 3)), map(&cells, 3));
        let pair = Joined::new(&a, &b);
        let level = Joined::new(&pair, &c);
        let round = cells.iter().any(|&tile| ARCS.contains(&tile));
        for &o in &points {
            let e = points[random.below(points.len() as i64) as usize];
            let rules = RayRules { inside: Inside::Hit, one_way: random.below(2) == 1 };
            let got = level.cast_ray(o, e - o, rules).unwrap().map(seen);
            let expected = union.cast_ray(o, e - o, rules).unwrap().map(seen);
            let scene = || format!("{parts:?}: {o} to {e}, {rules:?}: {got:?}, {expected:?}");
            if round && got != expected {
                let end = |hit: Option<Seen>| hit.map_or(Toi::ONE, |hit| hit.0);
                assert!(end(got) <= end(expected) || o.x == e.x || o.y == e.y, "{}", scene());
                unlike += 1;
            } else {
                assert_eq!(got, expected, "{}", scene());
            }
            starts += u64::from(expected.is_some_and(|hit| hit.0 == Toi::ZERO && !hit.3));
            inside += u64::from(expected.is_some_and(|hit| hit.3));
            rays += 1;
        }
    }
    println!("{rays} rays, {starts} hits at the start, {inside} inside, {unlike} unlike beside arcs");
    assert!(starts > rays / 20 && inside > rays / 20 && unlike < rays / 1000);
}
