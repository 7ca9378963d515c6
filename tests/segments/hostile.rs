//! Bytes that pass the checks but are no level that anyone has built. No query panics or runs for
//! ever.

use tilesat::SegmentMap;
use tilesat_judge::segments::build;
use tilesat_judge::segments::hostile::{ask, checksum, twisted};
use tilesat_judge::{Random, cases};

#[test]
fn levels_that_nobody_built_are_answered() {
    let mut random = Random::new(45);
    let (mut accepted, mut total) = (0u64, 0u64);
    while total < cases(1_500) {
        let mut scene = build::scene(&mut random);
        scene.cell = scene.cell.max(1022);
        scene.grid = None;
        total += 1;
        let Some(data) = twisted(&mut random, scene.bytes()) else { continue };
        let map = SegmentMap::from_bytes(&data).unwrap();
        accepted += 1;
        ask(&scene, &map, &mut random);
    }
    println!("{accepted} of {total} accepted");
    assert!(accepted > total / 3);
}

/// Single changes with a corrected checksum: refused, or all queries work.
#[test]
fn damaged_bytes_are_refused_or_answered() {
    let mut random = Random::new(46);
    let (mut accepted, mut total) = (0u64, 0u64);
    while total < cases(20_000) {
        let scene = build::scene(&mut random);
        let data = scene.bytes();
        for _ in 0..20 {
            let mut bytes = data.clone();
            for _ in 0..random.within(1, 3) {
                let at = random.below(bytes.len() as i64) as usize;
                bytes[at] = if random.one_in(2) { bytes[at] ^ (1 << random.below(8)) } else { random.next() as u8 };
            }
            checksum(&mut bytes);
            total += 1;
            if let Ok(map) = SegmentMap::from_bytes(&bytes) {
                accepted += 1;
                ask(&scene, &map, &mut random);
            }
        }
    }
    println!("{accepted} of {total} accepted");
}
