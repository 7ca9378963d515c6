//! Elastic balls under gravity: the energy stays constant, within the error of one bounce.

#![allow(clippy::cast_precision_loss, reason = "tests stop at the first surprise")]

use tilesat::{
    AllShapes, Circle, Fx, Mover, Response, Surface, TileKind, TileKinds, TileMap, TileShape, Vec2, World,
    motion::Energy,
};
use tilesat_judge::Random;

static KINDS: TileKinds = TileKinds::EMPTY
    .with(b'#', TileKind::FULL)
    .with(b'/', TileKind::of(TileShape::SlopeBottomRight))
    .with(b'\\', TileKind::of(TileShape::SlopeBottomLeft));

const BOX: &str = "\
##########
#        #
#        #
#        #
#        #
#        #
#        #
#        #
#        #
##########
";

const VALLEY: &str = "\
##########
#        #
#        #
#        #
#        #
#\\      /#
##\\    /##
###\\  /###
####\\/####
##########
";

/// `|v|^2 + g.v - 2 g.x` over the bottom of the room, in 128 bits.
fn energy(ball: &Circle, v: Vec2, gravity: i32) -> i128 {
    let ((x, y), (_, height)) = (v.raw(), ball.centre().raw());
    let [x, y, g, h] = [x, y, gravity, height - 144 * 65_536].map(i128::from);
    x * x + y * y + g * y - 2 * g * h
}

/// Least and greatest energy of a run, relative to the first.
fn run(map: &TileMap<'_, AllShapes>, r: &mut Random, gravity: i32, kept: bool, frames: u32) -> (f64, f64) {
    let at = Vec2::from_raw(r.within(40, 120) as i32 * 65_536, r.within(30, 70) as i32 * 65_536);
    let mut ball = Circle::new(at, Fx::from_num(6)).unwrap();
    let mut v = Vec2::from_raw(r.around(200_000) as i32, r.around(200_000) as i32);
    let g = Vec2::from_raw(0, gravity);
    let (all, first) = (Energy::of(at, v, g), energy(&ball, v, gravity));
    let (mut least, mut most) = (first, first);
    for _ in 0..frames {
        let speed = all.speed(ball.centre(), v, g).changed(v, v + g);
        let surface = if kept { Surface::ELASTIC.with_speed(speed) } else { Surface::ELASTIC };
        let mover = Mover::new().with_response(Response::Bounce).with_surface(surface);
        let moved = mover.move_and_slide(map, &ball, v + g).unwrap();
        if moved.hits.is_empty() {
            let flown = energy(&moved.body, moved.velocity, gravity);
            assert_eq!(flown, energy(&ball, v, gravity), "free flight keeps it to the bit");
        }
        (ball, v) = (moved.body, moved.velocity);
        (least, most) = (least.min(energy(&ball, v, gravity)), most.max(energy(&ball, v, gravity)));
    }
    assert!(!map.overlaps_circle(&ball));
    (least as f64 / first as f64, most as f64 / first as f64)
}

#[test]
fn energy_stays() {
    let frames = tilesat_judge::frames(100_000);
    let mut r = Random::new(1);
    for level in [BOX, VALLEY] {
        let map: TileMap<'_, AllShapes> = TileMap::of_ascii(level, &KINDS).unwrap();
        for gravity in [4_096, 16_384] {
            for _ in 0..4 {
                let (least, most) = run(&map, &mut r, gravity, true, frames);
                println!("{gravity}: {least:.3}..{most:.3}");
                assert!(least > 0.9 && most < 1.1, "{least}..{most}");
            }
        }
    }
}

/// Its purpose: without it the same valley multiplies the energy.
#[test]
fn a_valley_without_it() {
    let map: TileMap<'_, AllShapes> = TileMap::of_ascii(VALLEY, &KINDS).unwrap();
    let mut r = Random::new(1);
    let most = (0..4).map(|_| run(&map, &mut r, 16_384, false, 100_000).1).fold(0.0, f64::max);
    assert!(most > 2.0, "{most}");
}
