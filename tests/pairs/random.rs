//! The generator of the judge's scenes: a seed is a stream, and bytes are the choices that they
//! encode.

use tilesat_judge::Random;

fn choices(r: &mut Random) -> [i64; 6] {
    [r.below(1), r.below(256), r.around(3), r.around(3), r.within(5, 1000), r.sign()]
}

#[test]
fn bytes_are_choices_low_bytes_first() {
    // On a separate thread: it steers everything that follows on this one.
    let steered = std::thread::spawn(|| {
        let mut r = Random::steered(&[200, 1, 2, 0x34, 0x02, 1]);
        let made = choices(&mut r);
        assert!(!Random::is_left());
        (made, Random::new(7).next(), Random::steered(&[200]).next())
    });
    let (made, beyond, again) = steered.join().expect("the thread ends");
    assert_eq!(made, [0, 200, -1, 1, 5 + 0x234, -1]);
    assert_ne!(beyond, Random::new(7).next());
    assert_eq!(again & 0xff, 200);
}

#[test]
fn a_seed_is_a_stream() {
    let (mut one, mut other) = (Random::new(3), Random::new(3));
    assert!(!Random::is_left());
    assert_eq!([choices(&mut one), choices(&mut one)], [choices(&mut other), choices(&mut other)]);
    assert_eq!(Random::new(0).next(), 0xe220_a839_7b1d_cdaf);
}
