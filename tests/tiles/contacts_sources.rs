//! The same solid from different sources gives the same contacts and nearest points, bit for bit: a
//! tile and a polygon, a map and its two halves.

use tilesat::{
    Aabb, Circle, Fx, Joined, Outside, Path, PathKind, SegmentMap, Vec2,
    world::{Near, OneWay, WorldContact},
};
use tilesat_judge::shapes::build::{LIMIT, body, in_domain, mosaic};
use tilesat_judge::shapes::judge::{Body, Judge};
use tilesat_judge::shapes::level::{Level, shape};
use tilesat_judge::shapes::region::Region;
use tilesat_judge::{Random, cases};

fn vec2((x, y): (i64, i64)) -> Vec2 {
    Vec2::from_raw(x as i32, y as i32)
}

/// A contact without the name of its source.
fn told(found: &[WorldContact]) -> Vec<String> {
    let tell = |c: &WorldContact| {
        format!("{:?} {:?} {:?} {:?} {}", c.axis(), c.depth(), c.push_out(), c.point(), c.is_degenerate())
    };
    found.iter().map(tell).collect()
}

fn told_near(near: Option<Near>) -> String {
    format!("{:?}", near.map(|n| (n.point, n.distance, n.axis, n.inside)))
}

/// All contacts of a body with any level.
macro_rules! contacts {
    ($level:expr, $body:expr) => {{
        let mut out = heapless::Vec::<WorldContact, 64>::new();
        match $body {
            Body::Circle { c, r } => {
                let b = Circle::new(vec2(c), Fx::from_bits(r as i32)).unwrap();
                $level.contacts(&b, OneWay::Ignore, &mut out)
            }
            Body::Box { lo, hi } => $level.contacts(&Aabb::new(vec2(lo), vec2(hi)).unwrap(), OneWay::Ignore, &mut out),
        }
        .unwrap();
        told(&out)
    }};
}

fn place(body: Body) -> (i64, i64) {
    match body {
        Body::Box { lo, .. } => lo,
        Body::Circle { c, .. } => c,
    }
}

#[test]
fn a_polygon_is_as_the_tile_of_its_shape() {
    let mut random = Random::new(51);
    let (mut done, mut some) = (0u64, 0u64);
    while done < cases(30_000) {
        let id = loop {
            let id = random.within(1, 33) as u8;
            if !(10..18).contains(&id) {
                break id;
            }
        };
        let level = Level { width: 1, height: 1, outside: Outside::Empty, tiles: vec![id], ..mosaic(&mut random) };
        let Some(Region::Polygon(points)) = shape(id).0 else { panic!("{id}") };
        let half = level.cell / 2;
        let at = |v: i128, from: i64| (i128::from(from) + v * i128::from(half)) as i64;
        let points: Vec<Vec2> = points.iter().map(|p| vec2((at(p.0, level.x), at(p.1, level.y)))).collect();
        let mut bytes = heapless::Vec::<u8, 4096>::new();
        let paths = [Path::new(PathKind::Solid, &points)];
        let cell = Fx::from_bits((level.cell as i32).min(1 << 24));
        // The grid of a segment map has to fit the domain; tiles at its end leave no room.
        let Ok(segments) = SegmentMap::build_vec(&paths, cell, &mut bytes) else { continue };
        for _ in 0..20 {
            let body = body(&mut random, &level);
            if !in_domain(body) {
                continue;
            }
            let tile = level.all();
            let found = contacts!(tile, body);
            assert_eq!(found, contacts!(segments, body), "{body:?} {level:?}");
            let (p, within) = (vec2(place(body)), Fx::from_bits(LIMIT as i32));
            let near = tile.closest_point(p, within, OneWay::Ignore).unwrap();
            let other = segments.closest_point(p, within, OneWay::Ignore).unwrap();
            assert_eq!(told_near(near), told_near(other), "{p:?} {level:?}");
            some += u64::from(!found.is_empty());
            done += 1;
        }
    }
    assert!(some > done / 8, "{some} of {done}");
}

#[test]
fn two_halves_of_a_map_are_as_near_as_the_map() {
    let mut random = Random::new(52);
    let (mut done, mut some) = (0u64, 0u64);
    while done < cases(20_000) {
        let level = Level { outside: Outside::Empty, ..mosaic(&mut random) };
        if level.width < 2 {
            continue;
        }
        let judge = Judge::new(&level);
        let cut = random.within(1, level.width - 1);
        let part = |from: i64, to: i64| {
            let tiles = (0..level.height).flat_map(|row| (from..to).map(move |column| (row, column)));
            let tiles = tiles.map(|(row, column)| level.tiles[(row * level.width + column) as usize]).collect();
            Level { width: to - from, x: level.x + from * level.cell, tiles, ..level.clone() }
        };
        let (left, right) = (part(0, cut), part(cut, level.width));
        let (left, right) = (left.all(), right.all());
        let pair = Joined::new(&left, &right);
        for _ in 0..20 {
            let body = body(&mut random, &level);
            let p = place(body);
            // A point on the seam is in the inside of the map, but of neither half.
            if !in_domain(body) || judge.is_inside(p) {
                continue;
            }
            let within = Fx::from_bits(random.magnitude(8 * level.cell).min(LIMIT) as i32);
            let near = level.all().closest_point(vec2(p), within, OneWay::Ignore).unwrap();
            let other = pair.closest_point(vec2(p), within, OneWay::Ignore).unwrap();
            assert_eq!(near.map(|n| n.distance), other.map(|n| n.distance), "{p:?} cut {cut} {level:?}");
            // Whichever is first.
            let swapped = Joined::new(&right, &left);
            let same = swapped.closest_point(vec2(p), within, OneWay::Ignore).unwrap();
            assert_eq!(told_near(other), told_near(same), "{p:?} cut {cut} {level:?}");
            if let Body::Circle { r, .. } = body {
                // From outside, a circle has contacts with both if it has with one.
                let found = contacts!(pair, body);
                assert_eq!(found.is_empty(), contacts!(level.all(), body).is_empty(), "{r} {body:?} {level:?}");
            }
            some += u64::from(near.is_some());
            done += 1;
        }
    }
    assert!(some > done / 8, "{some} of {done}");
}

#[test]
fn a_wall_pushes_to_the_side_of_the_middle() {
    let wall = [Vec2::from_ints(0, -50), Vec2::from_ints(0, 50)];
    let mut bytes = heapless::Vec::<u8, 4096>::new();
    let paths = [Path::new(PathKind::Wall, &wall).with_flags(3)];
    let map = SegmentMap::build_vec(&paths, Fx::from_num(16), &mut bytes).unwrap();
    for (x, sign) in [(-3, -1), (3, 1)] {
        let ball = Circle::new(Vec2::from_ints(x, 4), Fx::from_num(5)).unwrap();
        let mut out = heapless::Vec::<WorldContact, 4>::new();
        map.contacts(&ball, OneWay::Ignore, &mut out).unwrap();
        let [contact] = out[..] else { panic!("{out:?}") };
        assert_eq!((contact.axis().x, contact.depth().to_num::<i32>()), (sign, 2));
        assert_eq!(contact.feature().flags, 3);
        let near = map.closest_point(ball.centre(), Fx::from_num(5), OneWay::Ignore).unwrap().unwrap();
        assert_eq!((near.point, near.axis.x, near.inside), (Vec2::from_ints(0, 4), sign, false));
    }
}
