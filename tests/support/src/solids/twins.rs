//! The same scene elsewhere, or seen in a mirror.

use super::judge::Block;
use super::{P, raw, solid, vec2};
use tilesat::{Side, Solid, TileKind, TileKinds, TileShape, Vec2};

/// All shapes by their numbers, and one-way edges.
pub static KINDS: TileKinds = {
    use TileShape as S;
    const SHAPES: [TileShape; 38] = [
        S::Empty,
        S::Full,
        S::HalfTop,
        S::HalfRight,
        S::HalfBottom,
        S::HalfLeft,
        S::SlopeTopLeft,
        S::SlopeTopRight,
        S::SlopeBottomRight,
        S::SlopeBottomLeft,
        S::ConvexTopLeft,
        S::ConvexTopRight,
        S::ConvexBottomRight,
        S::ConvexBottomLeft,
        S::ConcaveTopLeft,
        S::ConcaveTopRight,
        S::ConcaveBottomRight,
        S::ConcaveBottomLeft,
        S::MildLowTopLeft,
        S::MildLowTopRight,
        S::MildLowBottomRight,
        S::MildLowBottomLeft,
        S::MildHighTopLeft,
        S::MildHighTopRight,
        S::MildHighBottomRight,
        S::MildHighBottomLeft,
        S::SteepLowTopLeft,
        S::SteepLowTopRight,
        S::SteepLowBottomRight,
        S::SteepLowBottomLeft,
        S::SteepHighTopLeft,
        S::SteepHighTopRight,
        S::SteepHighBottomRight,
        S::SteepHighBottomLeft,
        S::OneWayUp,
        S::OneWayRight,
        S::OneWayDown,
        S::OneWayLeft,
    ];
    let (mut kinds, mut i) = (TileKinds::EMPTY, 0);
    while i < 38 {
        kinds = kinds.with(i as u8, TileKind::of(SHAPES[i]));
        i += 1;
    }
    kinds
};

/// Only blocks: the same ids.
pub static BLOCKS: TileKinds = TileKinds::EMPTY.with(1, TileKind::FULL);

fn mirrored_id(id: u8) -> u8 {
    match id {
        3 | 35 => id + 2,
        5 | 37 => id - 2,
        6..=33 => ((id - 6) ^ 1) + 6,
        _ => id,
    }
}

pub fn mirrored_level(tiles: &[u8], width: usize) -> Vec<u8> {
    tiles.chunks(width).flat_map(|row| row.iter().rev().map(|&id| mirrored_id(id))).collect()
}

pub fn mirrored(s: &Solid) -> Solid {
    let b = Block::of(&s.shape());
    let new = solid((-b.lo.0, b.lo.1), (-b.hi.0, b.hi.1), s.key());
    let new = match s.one_way() {
        Some(Side::Left) => new.with_one_way(Side::Right),
        Some(Side::Right) => new.with_one_way(Side::Left),
        Some(side) => new.with_one_way(side),
        None => new,
    };
    let flip = |v: Vec2| vec2((-raw(v).0, raw(v).1));
    new.with_motion(flip(s.motion())).unwrap().with_conveyor(flip(s.conveyor())).unwrap()
}

pub fn translated(s: &Solid, by: P) -> Solid {
    let b = Block::of(&s.shape()).moved(by);
    let new = solid(b.lo, b.hi, s.key());
    let new = s.one_way().map_or(new, |side| new.with_one_way(side));
    new.with_motion(s.motion()).unwrap().with_conveyor(s.conveyor()).unwrap()
}
