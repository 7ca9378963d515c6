//! Occupancy changes no answer.

use tilesat::{
    Aabb, AllShapes, Circle, Fx, Grid, Outside, TileKind, TileKinds, TileMap, TileMapError, TileShape, Vec2,
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

#[test]
fn wrong_bits_are_refused() {
    let tiles: Vec<u8> = (0..70 * 3).map(|i| u8::from(i % 7 == 0)).collect();
    let map = map(&tiles, 70, 3);
    assert_eq!(map.occupancy_words(), 9);
    let mut words = [0; 9];
    assert_eq!(map.fill_occupancy(&mut words[..8]), Err(TileMapError::Occupancy { row: 2 }));
    assert_eq!(words, [0; 9]);
    map.fill_occupancy(&mut words).unwrap();
    assert_eq!(map.with_occupancy(&words[..5]).unwrap_err(), TileMapError::Occupancy { row: 1 });
    for bit in 0..9 * 32 {
        let mut wrong = words;
        wrong[bit / 32] ^= 1 << (bit % 32);
        assert_eq!(map.with_occupancy(&wrong).unwrap_err(), TileMapError::Occupancy { row: (bit / 96) as u16 });
    }
    // Other rows than the bits are of.
    let narrow =
        TileMap::<AllShapes>::of(&tiles, Grid::new(10, 3, Fx::from_bits(256), Vec2::ZERO).unwrap(), &KINDS).unwrap();
    let mut few = [0; 3];
    narrow.fill_occupancy(&mut few).unwrap();
    let region = Aabb::new(Vec2::ZERO, Vec2::from_raw(2560, 768)).unwrap();
    let strided = narrow.with_stride(70).unwrap();
    let other = narrow.with_occupancy(&few).unwrap().with_stride(70).unwrap();
    assert!(other.features(&region).eq(strided.features(&region)));
}
