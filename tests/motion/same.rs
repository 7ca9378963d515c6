//! A level of blocks is the same level as `Blocks` and as `AllShapes`: motion gives the same bits
//! for every body, speed and response. Radii below three raw units are excluded: normals that short
//! belong to slopes, which blocks do not have.

use std::fmt::Debug;
use tilesat_judge::Random;

use tilesat::motion::Body;
use tilesat::{
    Aabb, AllShapes, Axis, Blocks, Circle, Fx, Grid, Mover, Outside, Response, TileKind, TileKinds, TileMap, TileShape,
    Vec2,
};

const SIDE: usize = 32;
const CELL: i64 = 16 << 16;

static KINDS: TileKinds =
    TileKinds::EMPTY.with(1, TileKind::of(TileShape::Full)).with(2, TileKind::of(TileShape::OneWayUp));

fn raw(x: i64, y: i64) -> Vec2 {
    let bits = |n: i64| Fx::from_bits(i32::try_from(n).unwrap());
    Vec2::new(bits(x), bits(y))
}

struct Level<'t> {
    blocks: TileMap<'t, Blocks>,
    shapes: TileMap<'t, AllShapes>,
}

impl<'t> Level<'t> {
    fn of(tiles: &'t [u8], outside: Outside) -> Self {
        let grid = Grid::new(SIDE as u16, SIDE as u16, Fx::from_num(16), Vec2::ZERO).unwrap();
        Self {
            blocks: TileMap::of(tiles, grid, &KINDS).unwrap().with_outside(outside),
            shapes: TileMap::of(tiles, grid, &KINDS).unwrap().with_outside(outside),
        }
    }

    /// The number of frames with a hit.
    fn play<B: Body + PartialEq + Debug>(&self, random: &mut Random, mover: &Mover, mut body: B) -> u32 {
        let (mut velocity, mut hits) = (Vec2::ZERO, 0);
        let gravity = random.magnitude(1 << 16);
        for frame in 0..100 {
            if frame % 25 == 0 {
                // Up to two tiles per frame. Sometimes as fast as the domain allows.
                let fastest = if random.one_in(8) { 200 * CELL } else { 2 * CELL };
                velocity = raw(random.around(fastest), random.around(fastest));
            }
            velocity += raw(0, gravity);
            let (one, other) = (
                mover.move_and_slide(&self.blocks, &body, velocity),
                mover.move_and_slide(&self.shapes, &body, velocity),
            );
            let (Ok(one), Ok(other)) = (&one, &other) else {
                assert_eq!(one.map(|_| ()), other.map(|_| ()), "{body:?} by {velocity:?}");
                break;
            };
            let told =
                |moved: &tilesat::Moved<B>| (moved.velocity, moved.remaining, moved.floor, moved.wall, moved.ceiling);
            assert_eq!((&one.body, told(one)), (&other.body, told(other)), "{body:?} by {velocity:?}");
            assert_eq!(one.hits, other.hits, "{body:?} by {velocity:?}");
            hits += u32::from(!one.hits.is_empty());
            (body, velocity) = (one.body, one.velocity);
        }
        hits
    }
}

#[test]
fn blocks_are_blocks_among_all_shapes() {
    let cases = tilesat_judge::cases(100);
    let (mut random, mut hits) = (Random::new(4), [0; 2]);
    for _ in 0..cases {
        let mut tiles = [0; SIDE * SIDE];
        tiles.fill_with(|| if random.one_in(4) { random.within(1, 2) as u8 } else { 0 });
        let level = Level::of(&tiles, if random.one_in(2) { Outside::Solid } else { Outside::Empty });
        for n in 0..20 {
            let response = [Response::Slide, Response::Slide, Response::Bounce, Response::DropThrough][n % 4];
            let mover = Mover::platformer(Axis::NEG_Y).with_response(response);
            let (x, y) = (random.within(CELL, 31 * CELL), random.within(CELL, 31 * CELL));
            let (w, h) = (random.magnitude(CELL), random.magnitude(CELL));
            if random.one_in(2) {
                let w = w.max(3);
                hits[0] += level.play(&mut random, &mover, Circle::new(raw(x, y), Fx::from_bits(w as i32)).unwrap());
            } else {
                hits[1] += level.play(&mut random, &mover, Aabb::new(raw(x, y), raw(x + w, y + h)).unwrap());
            }
        }
    }
    println!("{hits:?} frames of circles and boxes that hit something");
    assert!(hits.iter().all(|&n| n > 50 * cases), "{hits:?}");
}
