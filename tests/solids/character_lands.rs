//! Landings that end at once.

use tilesat::{Aabb, Character, Feel, Fx, Input, TileKind, TileKinds, TileMap, Vec2, fx};

static EDGES: TileKinds = TileKinds::EMPTY.with(b'#', TileKind::FULL).with(b'=', TileKind::ONE_WAY_UP);

/// A hero falls onto the last bit of a platform, and slides off its end in the same frame. It has
/// landed all the same: a press shortly before still makes it jump. Mirrored alike.
#[test]
fn a_hero_that_lands_on_the_last_bit_of_a_platform_has_landed() {
    let rows = ["....................", "....................", "........####........", "........====........"];
    let (mut slid, mut stood) = (0, 0);
    for (row, side) in [(2, 1), (2, -1), (3, 1), (3, -1)] {
        let text = [rows[0], rows[0], rows[row], rows[0], rows[0]].join("\n");
        let level = TileMap::from_ascii(&text, &EDGES).unwrap(); // the platform is from x = 128 to 192
        for (speed, off) in [fx!(1), fx!(1.5), fx!(2), fx!(3)].into_iter().flat_map(|v| (0..400).map(move |o| (v, o))) {
            let x = fx!(160) + side * (fx!(32) - fx!(16) + Fx::from_bits(off * 6_007));
            let body = Aabb::from_centre(Vec2::new(x, fx!(12)), Vec2::from_ints(5, 7)).unwrap();
            let fall = |press: Option<u32>| {
                let mut hero = Character::new(body, level.bounds(), Feel::DEFAULT);
                hero.velocity.x = side * speed;
                let mut met = None;
                for frame in 0..40 {
                    let fell = hero.velocity.y;
                    let jump = press.is_some_and(|press| frame >= press);
                    let step = hero.step(&level, Input { run: side * speed, jump, drop: false }).unwrap();
                    if step.jumped {
                        return (met, true);
                    }
                    if fell > fx!(1) && hero.velocity.y <= 0 && met.is_none() {
                        assert!(step.landed, "{side} {speed} {off}");
                        met = Some((frame, hero.on_floor()));
                    }
                }
                (met, false)
            };
            let Some((frame, stands)) = fall(None).0 else { continue };
            *(if stands { &mut stood } else { &mut slid }) += 1;
            for early in [0, 2, 4] {
                assert!(fall(Some(frame - early)).1, "{side} {speed} {off}: the press {early} frames before is lost");
            }
        }
    }
    assert!(slid > 30 && stood > 300, "{slid} {stood}");
}
