//! Rays against segment maps: every hit in order, against each piece of the boundary separately.

use tilesat::{Inside, SegmentMap, world::RayRules};
use tilesat_judge::segments::rays::{check, faces};
use tilesat_judge::segments::{build, sub};
use tilesat_judge::{Random, cases};

#[test]
fn rays_meet_the_pieces_in_order() {
    let mut random = Random::new(43);
    let (mut done, mut hits) = (0u64, 0usize);
    let limit = (1i128 << 29) - 1;
    while done < cases(100_000) {
        let scene = build::scene(&mut random);
        let bytes = scene.bytes();
        let map = SegmentMap::from_bytes(&bytes).unwrap();
        let faces = faces(&scene);
        for _ in 0..40 {
            let o = scene.point(&mut random);
            let mut e = scene.point(&mut random);
            match random.below(8) {
                0 => e.0 = o.0,
                1 => e.1 = o.1,
                2 => e = o,
                3 => {
                    // To the end of the domain.
                    let end = |random: &mut Random, at: i128| i128::from(random.around(limit as i64)) - at;
                    e = (end(&mut random, scene.origin.0), end(&mut random, scene.origin.1));
                }
                _ => {}
            }
            let (o, e) = if random.one_in(2) { (o, e) } else { (e, o) };
            let rules = RayRules {
                inside: if random.one_in(2) { Inside::Hit } else { Inside::Ignore },
                one_way: random.one_in(2),
            };
            hits += check(&scene, &map, &faces, o, sub(e, o), rules);
            done += 1;
        }
    }
    println!("{done} rays, {hits} hits");
    assert!(hits as u64 > done / 2);
}
