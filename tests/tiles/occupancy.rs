//! Occupancy changes no answer.

use tilesat::world::Store;
use tilesat::{
    Aabb, AllShapes, Blocks, Circle, Fx, Grid, Inside, Outside, RayHit, TileKind, TileKinds, TileMap, TileMapError,
    TileShape, Vec2,
};
use tilesat_judge::Random;

static KINDS: TileKinds = {
    let (mut kinds, mut id) = (TileKinds::EMPTY, 0u8);
    while id < 38 {
        kinds = kinds.with(id, TileKind::of(TileShape::ALL[id as usize]));
        id += 1;
    }
    kinds
};

static BLOCKS: TileKinds = TileKinds::EMPTY.with(1, TileKind::FULL);

fn map(tiles: &[u8], width: u16, height: u16) -> TileMap<'_, AllShapes> {
    let grid = Grid::new(width, height, Fx::from_bits(256), Vec2::from_raw(-512, 300)).unwrap();
    TileMap::of(tiles, grid, &KINDS).unwrap()
}

/// Maps of one to three words a row, mostly empty; regions in them, across their border and beyond.
#[test]
fn same_features_and_overlaps() {
    let mut r = Random::new(1);
    let mut found = 0;
    for _ in 0..300 {
        let (width, height) = (r.within(1, 80), r.within(1, 6));
        let full = r.within(1, 60);
        let tiles: Vec<u8> =
            (0..width * height).map(|_| if r.below(100) < full { r.below(38) as u8 } else { 0 }).collect();
        let outside = [Outside::Empty, Outside::Solid, Outside::Edge][r.below(3) as usize];
        let bare = map(&tiles, width as u16, height as u16).with_outside(outside);
        let mut words = vec![0; bare.occupancy_words()];
        bare.fill_occupancy(&mut words).unwrap();
        let quick = bare.with_occupancy(&words).unwrap();
        for _ in 0..60 {
            let at =
                |r: &mut Random| (-512 - 600 + r.below(256 * (width + 5)), 300 - 600 + r.below(256 * (height + 5)));
            let ((x, y), w, h) = (at(&mut r), r.below(256 * 40), r.below(256 * 3));
            let lo = Vec2::from_raw(x as i32, y as i32);
            let region = Aabb::new(lo, Vec2::from_raw((x + w) as i32, (y + h) as i32)).unwrap();
            let features: Vec<_> = bare.features(&region).collect();
            found += features.len();
            assert_eq!(quick.features(&region).collect::<Vec<_>>(), features);
            assert_eq!(quick.overlaps(&region), bare.overlaps(&region));
            assert_eq!(quick.touches(&region), bare.touches(&region));
            let ball = Circle::new(lo, Fx::from_bits(r.below(600) as i32)).unwrap();
            assert_eq!(quick.overlaps(&ball), bare.overlaps(&ball));
            assert_eq!(quick.touches(&ball), bare.touches(&ball));
        }
    }
    assert!(found > 100_000, "{found} features are too few");
}

/// Maps of some areas per side, most of them empty. Rays along the lattice, through corners of
/// cells and of areas, along lines, and any others.
#[test]
fn same_rays() {
    let (mut r, mut hits) = (Random::new(2), 0);
    for round in 0..240 {
        let (width, height) = (r.within(1, 130), r.within(1, 90));
        let cell = [256, 300, 1 << 16, 86_018][round % 4];
        let one_in = [40, 400, 4000][r.below(3) as usize];
        let any = round % 8 < 4;
        let mut id = || {
            if r.below(one_in) > 0 {
                0
            } else if any {
                r.below(38) as u8
            } else {
                1
            }
        };
        let tiles: Vec<u8> = (0..width * height).map(|_| id()).collect();
        let grid = Grid::new(width as u16, height as u16, Fx::from_bits(cell), Vec2::from_raw(-512, 300)).unwrap();
        let outside = [Outside::Empty, Outside::Solid, Outside::Edge][r.below(3) as usize];
        let shaped = TileMap::<AllShapes>::of(&tiles, grid, &KINDS).unwrap().with_outside(outside);
        let mut words = vec![0; shaped.occupancy_words()];
        shaped.fill_occupancy(&mut words).unwrap();
        let quick = shaped.with_occupancy(&words).unwrap();
        let blocks = TileMap::<Blocks>::of(&tiles, grid, &BLOCKS).unwrap().with_outside(outside);
        let mut block_words = vec![0; blocks.occupancy_words()];
        blocks.fill_occupancy(&mut block_words).unwrap();
        let quick_blocks = blocks.with_occupancy(&block_words).unwrap();
        for n in 0..60 {
            let half = i64::from(cell) / 2;
            let mut point = || {
                let (x, y) = (r.within(-2, 2 * width + 2) * half, r.within(-2, 2 * height + 2) * half);
                let (x, y) = if n % 3 > 0 { (x, y) } else { (x + r.below(half), y + r.below(half)) };
                Vec2::from_raw((x - 512) as i32, (y + 300) as i32)
            };
            let (from, mut to) = (point(), point());
            if n % 5 == 0 {
                // Diagonal: from the lattice it meets only corners.
                to = Vec2::from_raw(to.x.to_bits(), from.y.to_bits() + to.x.to_bits() - from.x.to_bits());
            } else if n % 7 == 0 {
                to.y = from.y;
            }
            let (d, inside) = (to - from, if n % 2 == 0 { Inside::Hit } else { Inside::Ignore });
            let hit = blocks.cast_ray(from, d, inside);
            hits += usize::from(hit.as_ref().is_ok_and(Option::is_some));
            assert_eq!(quick_blocks.cast_ray(from, d, inside), hit);
            assert_eq!(quick.cast_ray(from, d, inside), shaped.cast_ray(from, d, inside));
            assert_eq!(all_of(&quick, from, d, inside), all_of(&shaped, from, d, inside));
        }
    }
    assert!(hits > 1000, "{hits} hits are too few");
}

fn all_of<T: Store>(map: &TileMap<'_, AllShapes, T>, from: Vec2, d: Vec2, inside: Inside) -> Option<Vec<RayHit>> {
    map.cast_ray_all(from, d, inside).ok().map(Iterator::collect)
}

#[test]
fn wrong_bits_are_refused() {
    let tiles: Vec<u8> = (0..70 * 3).map(|i| u8::from(i % 7 == 0)).collect();
    let map = map(&tiles, 70, 3);
    assert_eq!(map.occupancy_words(), 10);
    let mut words = [0; 10];
    assert_eq!(map.fill_occupancy(&mut words[..8]), Err(TileMapError::Occupancy { row: 2 }));
    assert_eq!(map.fill_occupancy(&mut words[..9]), Err(TileMapError::Occupancy { row: 0 }));
    assert_eq!(words, [0; 10]);
    map.fill_occupancy(&mut words).unwrap();
    assert_eq!(map.with_occupancy(&words[..5]).unwrap_err(), TileMapError::Occupancy { row: 1 });
    for bit in 0..10 * 32 {
        let mut wrong = words;
        wrong[bit / 32] ^= 1 << (bit % 32);
        let row = if bit < 9 * 32 { bit / 96 } else { 0 };
        assert_eq!(map.with_occupancy(&wrong).unwrap_err(), TileMapError::Occupancy { row: row as u16 });
    }
    // The bits belong to other rows.
    let narrow =
        TileMap::<AllShapes>::of(&tiles, Grid::new(10, 3, Fx::from_bits(256), Vec2::ZERO).unwrap(), &KINDS).unwrap();
    let mut few = [0; 4];
    narrow.fill_occupancy(&mut few).unwrap();
    let region = Aabb::new(Vec2::ZERO, Vec2::from_raw(2560, 768)).unwrap();
    let strided = narrow.with_stride(70).unwrap();
    let other = narrow.with_occupancy(&few).unwrap().with_stride(70).unwrap();
    assert!(other.features(&region).eq(strided.features(&region)));
}
