//! Bytes of segment maps that nobody has built, and every query on accepted ones.

use crate::Random;
use crate::segments::{Body, Scene};
use tilesat::{
    Aabb, Axis, Circle, Fx, Inside, Joined, Mover, SegmentMap, SegmentMapError, TileKind, TileKinds, TileMap, Vec2,
    world::{OneWay, RayRules},
};

pub static KINDS: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL);

pub fn checksum(data: &mut [u8]) {
    data[28..32].fill(0);
    let hash = data.iter().fold(0x811c_9dc5u32, |h, &b| (h ^ u32::from(b)).wrapping_mul(0x0100_0193));
    data[28..32].copy_from_slice(&hash.to_le_bytes());
}

/// Sets the segments' kinds, joints and flags to anything valid, so that polygons do not close.
/// Then sets the winding numbers to match.
pub fn twisted(random: &mut Random, mut data: Vec<u8>) -> Option<Vec<u8>> {
    let count = usize::from(u16::from_le_bytes([data[6], data[7]]));
    for i in 0..count {
        let at = 32 + 24 * i;
        let kind = random.below(4).min(2) as u8;
        // Joined at both ends, and no vertex.
        data[at + 20..at + 22].fill(0xff);
        data[at + 22] = kind | if kind == 2 { (random.below(4) << 2) as u8 } else { 12 };
        data[at + 23] = random.next() as u8;
    }
    let (w, h) =
        (usize::from(u16::from_le_bytes([data[20], data[21]])), usize::from(u16::from_le_bytes([data[22], data[23]])));
    let winding = data.len() - w * h;
    data[winding..].fill(0);
    for _ in 0..64 * w * h {
        checksum(&mut data);
        match SegmentMap::from_bytes(&data) {
            Ok(_) => return Some(data),
            Err(SegmentMapError::Winding(cell)) => {
                // 0, 1, -1, 2, -2 ...
                let byte = &mut data[winding + cell.y as usize * w + cell.x as usize];
                let v = *byte as i8;
                *byte = (if v > 0 { -v } else { 1 - v }) as u8;
            }
            Err(_) => return None,
        }
    }
    None
}

pub fn ask(scene: &Scene, map: &SegmentMap<'_>, random: &mut Random) {
    let tiles = TileMap::from_ascii("##\n##", &KINDS)
        .unwrap()
        .with_origin(scene.vec2((0, 0)))
        .unwrap_or_else(|_| TileMap::from_ascii("##\n##", &KINDS).unwrap());
    let pair = Joined::new(&tiles, map);
    let mut out = tilesat::heapless::Vec::<_, 8>::new();
    for _ in 0..10 {
        let v = Vec2::from_raw(random.around(1 << 12) as i32, random.around(1 << 12) as i32);
        let p = scene.vec2(scene.point(random));
        let _ = map.closest_point(p, Fx::from_bits(1 << 12), OneWay::Include).unwrap();
        match scene.body(random) {
            Body::Box { lo, hi } => {
                let b = Aabb::new(scene.vec2(lo), scene.vec2(hi)).unwrap();
                let _ = (map.overlaps(&b), map.touches(&b), map.flags_touched(&b), pair.touches(&b));
                assert!(map.features(&b).count() <= 2 * usize::from(map.count()));
                let _ = pair.features(&b).count();
                let _ = map.contacts(&b, OneWay::Include, &mut out);
                let _ = Mover::platformer(Axis::NEG_Y).move_and_slide(&pair, &b, v);
            }
            Body::Circle { c, r } => {
                let b = Circle::new(scene.vec2(c), Fx::from_bits(r as i32)).unwrap();
                let _ = (map.overlaps(&b), map.touches(&b), map.flags_touched(&b), pair.overlaps(&b));
                let _ = pair.contacts(&b, OneWay::Include, &mut out);
                let _ = Mover::new().move_and_slide(map, &b, v);
            }
        }
        let rules = RayRules { inside: Inside::Hit, one_way: true };
        let q = scene.vec2(scene.point(random));
        // At most one hit per face, and the start.
        let hits = map.cast_ray_all(p, q - p, rules).unwrap().count();
        assert!(hits <= 1 + usize::from(map.count()));
        let _ = pair.cast_ray_all(p, q - p, rules).unwrap().count();
        let _ = map.line_of_sight(p, q).unwrap();
    }
}
