//! Rays through mosaics of every shape against an exact judge: the same pieces, at the same
//! moments, in the same order.

use tilesat_judge::rays::cast::Scene;
use tilesat_judge::rays::check::check;
use tilesat_judge::rays::generate::ray;
use tilesat_judge::rays::level::Level;
use tilesat_judge::{Random, cases};

#[test]
fn rays_equal_the_judge() {
    let mut random = Random::new(34);
    let (mut done, mut hits) = (0u64, 0);
    while done < cases(20_000) {
        let level = Level::random(&mut random);
        let (scene, map) = (Scene::new(&level), level.map());
        for _ in 0..40 {
            let (o, d) = ray(&mut random, &level, &scene);
            hits += check(&level, &scene, &map, o, d, &mut random);
            done += 1;
        }
    }
    assert!(hits as u64 > done / 2, "{hits} hits of {done} rays");
    println!("{done} rays, {hits} hits");
}
