//! Overlap and touch of a map, in all of its forms, against the judge.

use crate::shapes::judge::{Body, Judge};
use crate::shapes::level::Level;
use tilesat::world::{ShapeSet, Store};
use tilesat::{Aabb, Circle, Fx, TileMap, Vec2};

pub fn vec2((x, y): (i64, i64)) -> Vec2 {
    Vec2::from_raw(x as i32, y as i32)
}

/// Both answers of a map.
pub fn answers<S: ShapeSet, T: Store>(map: &TileMap<'_, S, T>, body: Body) -> (bool, bool) {
    match body {
        Body::Box { lo, hi } => {
            let b = Aabb::new(vec2(lo), vec2(hi)).unwrap();
            (map.overlaps(&b), map.touches(&b))
        }
        Body::Circle { c, r } => {
            let b = Circle::new(vec2(c), Fx::from_bits(r as i32)).unwrap();
            (map.overlaps(&b), map.touches(&b))
        }
    }
}

/// Counts of hits, so that a test cannot pass without any.
#[derive(Default, Debug)]
pub struct Met {
    pub bodies: u64,
    pub blocks: u64,
    pub overlaps: u64,
    pub touches: u64,
}

impl Met {
    pub fn check(&mut self, level: &Level, judge: &Judge, body: Body) {
        let expected = (judge.overlaps(body), judge.touches(body));
        assert_eq!(answers(&level.all(), body), expected, "(overlaps, touches) {body:?}\n{level:?}");
        let mut words = vec![0; level.all().occupancy_words()];
        level.all().fill_occupancy(&mut words).unwrap();
        let skipping = level.all().with_occupancy(&words).unwrap();
        assert_eq!(answers(&skipping, body), expected, "with occupancy: {body:?}\n{level:?}");
        if let Some(blocks) = level.blocks() {
            assert_eq!(answers(&blocks, body), expected, "blocks: {body:?}\n{level:?}");
            self.blocks += 1;
        }
        self.bodies += 1;
        self.overlaps += u64::from(expected.0);
        self.touches += u64::from(expected.1 && !expected.0);
    }
}
