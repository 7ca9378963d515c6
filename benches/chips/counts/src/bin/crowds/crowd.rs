//! A crowd in a walled world: bodies of 6 to 24 units, at most 2 units per frame fast, that turn
//! round at the walls.

use tilesat::{Aabb, Vec2};
use tilesat_counts::inputs::{Random, UNIT};

/// Sizes of the world.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum World {
    /// 1024 x 768, whatever their number.
    Fixed,
    /// Large enough to give each body 64 x 64.
    Density,
    /// All in 256 x 256.
    Cluster,
}

impl World {
    pub const ALL: [Self; 3] = [Self::Fixed, Self::Density, Self::Cluster];

    pub fn name(self) -> &'static str {
        match self {
            Self::Fixed => "fixed",
            Self::Density => "density",
            Self::Cluster => "cluster",
        }
    }

    /// Width and height for a number of bodies, which is a power of two.
    pub fn size(self, bodies: usize) -> (i32, i32) {
        let log = bodies.ilog2();
        match self {
            Self::Fixed => (1024, 768),
            Self::Density => (64 << log.div_ceil(2), 64 << (log / 2)),
            Self::Cluster => (256, 256),
        }
    }
}

/// N bodies.
pub struct Crowd<const N: usize> {
    /// The boxes of the present frame.
    pub boxes: [Aabb; N],
    ways: [Vec2; N],
    size: Vec2,
}

impl<const N: usize> Crowd<N> {
    pub fn new(world: World, blank: Aabb) -> Self {
        let mut r = Random::new(1);
        let (width, height) = world.size(N);
        let mut crowd =
            Self { boxes: [blank; N], ways: [Vec2::ZERO; N], size: Vec2::from_ints(width as i16, height as i16) };
        for (place, way) in crowd.boxes.iter_mut().zip(&mut crowd.ways) {
            let (w, h) = (r.raw(6, 24), r.raw(6, 24));
            let (x, y) = (r.whole(0, width * UNIT - w), r.whole(0, height * UNIT - h));
            *place = Aabb::new(Vec2::from_raw(x, y), Vec2::from_raw(x + w, y + h)).unwrap_or(blank);
            *way = Vec2::from_raw(r.raw(-2, 2), r.raw(-2, 2));
        }
        crowd
    }

    /// Makes the next frame. This is the game's part and is not measured.
    #[inline(never)]
    pub fn step(&mut self) {
        for (place, way) in self.boxes.iter_mut().zip(&mut self.ways) {
            let (min, max) = (place.min(), place.max());
            if min.x + way.x < 0 || max.x + way.x > self.size.x {
                way.x = -way.x;
            }
            if min.y + way.y < 0 || max.y + way.y > self.size.y {
                way.y = -way.y;
            }
            *place = place.translated(*way).unwrap_or(*place);
        }
    }
}
