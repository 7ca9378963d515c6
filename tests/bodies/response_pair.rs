//! Two bodies that meet: they separate, momentum stays, and energy does not grow. Exact, in 128
//! bits.

use tilesat::motion::response::{exchange, separate};
use tilesat::prelude::*;
use tilesat::{Aabb, Axis, Circle, Contact, Fx, Ratio, Surface, Vec2, motion::Masses};
use tilesat_judge::plain::{P, dot, raw, vec2};
use tilesat_judge::{Random, cases};

fn sub(a: P, b: P) -> P {
    (a.0 - b.0, a.1 - b.1)
}

fn shares() -> [Ratio; 6] {
    let third = Ratio::new(1, 3).unwrap();
    [Ratio::ZERO, third, Ratio::HALF, third.complement(), Ratio::from_raw(1).unwrap(), Ratio::ONE]
}

/// A shape that a test can move and mirror.
trait Shape: Copy + core::fmt::Debug {
    fn at(self, by: Vec2) -> Self;
    fn mirrored(self) -> Self;
}

impl Shape for Circle {
    fn at(self, by: Vec2) -> Self {
        self.translated(by).unwrap()
    }
    fn mirrored(self) -> Self {
        let c = raw(self.centre());
        Circle::new(vec2((-c.0, c.1)), self.radius()).unwrap()
    }
}

impl Shape for Aabb {
    fn at(self, by: Vec2) -> Self {
        self.translated(by).unwrap()
    }
    fn mirrored(self) -> Self {
        let (lo, hi) = (raw(self.min()), raw(self.max()));
        Aabb::new(vec2((-hi.0, lo.1)), vec2((-lo.0, hi.1))).unwrap()
    }
}

/// Separates the two by every share, in both orders and mirrored. Returns whether they overlapped.
fn parted<A: Shape + Contacts<B> + Overlaps<B>, B: Shape + Contacts<A>>(a: A, b: B) -> bool {
    let Some(contact) = a.contact(&b) else { return false };
    let other: Contact = b.contact(&a).unwrap();
    for share in shares() {
        let (by_a, by_b) = separate(&contact, share);
        assert!(!a.at(by_a).overlaps(&b.at(by_b)), "{a:?} {b:?} by {share:?}: {by_a:?} {by_b:?}");
        let (p, q, push) = (raw(by_a), raw(by_b), raw(contact.push_out()));
        for (sum, push) in [(p.0 - q.0, push.0), (p.1 - q.1, push.1)] {
            assert!(sum == push || sum == push + push.signum(), "{a:?} {b:?} by {share:?}: {sum} for {push}");
        }
        assert!(share != Ratio::ONE || by_b == Vec2::ZERO);
        assert!(share != Ratio::ZERO || by_a == Vec2::ZERO);
        if contact.is_degenerate() {
            continue;
        }
        assert_eq!(separate(&other, share.complement()), (by_b, by_a), "{a:?} {b:?} by {share:?}: the other order");
        let mirrored = separate(&a.mirrored().contact(&b.mirrored()).unwrap(), share);
        let expected = (vec2((-p.0, p.1)), vec2((-q.0, q.1)));
        assert_eq!(mirrored, expected, "{a:?} {b:?} by {share:?}: mirrored");
    }
    true
}

fn disc(c: P, r: i64) -> Circle {
    Circle::new(vec2(c), Fx::from_bits(r as i32)).unwrap()
}

fn rect(c: P, size: P) -> Aabb {
    Aabb::new(vec2(c), vec2((c.0 + size.0, c.1 + size.1))).unwrap()
}

#[test]
fn small_shapes_part() {
    let mut met = 0_u32;
    for x in -9..=9 {
        for y in -9..=9 {
            for size in 1..=5 {
                met += u32::from(parted(disc((0, 0), 4), disc((x, y), size)));
                met += u32::from(parted(disc((0, 0), size), rect((x, y), (3, 5))));
                met += u32::from(parted(rect((x, y), (3, 5)), disc((0, 0), size)));
                met += u32::from(parted(rect((-2, -3), (5, size)), rect((x, y), (size, 4))));
            }
        }
    }
    assert!(met > 1_500, "{met}");
}

#[test]
fn shapes_of_all_sizes_part() {
    let mut r = Random::new(5);
    let mut met = 0_u64;
    let wanted = cases(30_000);
    while met < wanted {
        let most = 1 << r.within(2, 26);
        let at = (r.around((1 << 28) - 1), r.around((1 << 28) - 1));
        let beside = (at.0 + r.around(most), at.1 + r.around(most));
        let (p, q) = (r.within(1, most), r.within(1, most));
        met += u64::from(match r.below(3) {
            0 => parted(disc(at, p), disc(beside, q)),
            1 => parted(disc(at, p), rect(beside, (q, p))),
            _ => parted(rect(at, (p, q)), rect(beside, (q, p))),
        });
    }
}

/// Masses for the test. Zero is a body that does not move.
fn masses() -> [(Masses, P); 7] {
    let of = |a: u8, b: u8| (Masses::new(a, b).unwrap(), (i64::from(a), i64::from(b)));
    [of(1, 1), of(1, 2), of(3, 1), of(6, 4), of(255, 254), (Masses::B_FIXED, (1, 0)), (Masses::A_FIXED, (0, 1))]
}

/// All promises about one exchange. Returns whether it changed anything.
fn check(a: P, b: P, n: P, (masses, (ma, mb)): (Masses, P), surface: &Surface) -> bool {
    let normal = Axis::new(n.0 as i32, n.1 as i32);
    let (new_a, new_b) = exchange(vec2(a), vec2(b), normal, masses, surface).unwrap();
    let tell = || format!("{a:?} {b:?} at {n:?}, {masses:?} {surface:?}: {new_a:?} {new_b:?}");
    // `i32::MIN` has no opposite.
    if normal.x.min(normal.y) > i32::MIN {
        let swapped = exchange(vec2(b), vec2(a), normal.reversed(), masses.swapped(), surface).unwrap();
        assert_eq!(swapped, (new_b, new_a), "{}", tell());
        let flip = |p: P| vec2((-p.0, p.1));
        let mirrored = exchange(flip(a), flip(b), Axis::new(-normal.x, normal.y), masses, surface).unwrap();
        assert_eq!(mirrored, (flip(raw(new_a)), flip(raw(new_b))), "{}", tell());
    }
    let (new_a, new_b) = (raw(new_a), raw(new_b));
    let approach = dot(sub(a, b), n);
    if approach <= 0 {
        assert_eq!((new_a, new_b), (a, b), "{}", tell());
        return false;
    }
    let (w, after) = (sub(a, b), sub(new_a, new_b));
    if ma != 0 && mb != 0 {
        for (old, new) in [((a.0, b.0), (new_a.0, new_b.0)), ((a.1, b.1), (new_a.1, new_b.1))] {
            assert_eq!(ma * old.0 + mb * old.1, ma * new.0 + mb * new.1, "momentum: {}", tell());
        }
        let energy = |a: P, b: P| i128::from(ma) * dot(a, a) + i128::from(mb) * dot(b, b);
        assert!(energy(new_a, new_b) <= energy(a, b), "energy: {}", tell());
    } else {
        assert!(if ma == 0 { new_a == a } else { new_b == b }, "moved: {}", tell());
    }
    assert!(dot(after, after) <= dot(w, w), "relative speed: {}", tell());
    let step = if ma == 0 || mb == 0 { 1 } else { (ma + mb) / gcd(ma, mb) };
    if dot(after, n) > 0 {
        // Too slow for a step: |w.n| <= 2 step |n|.
        assert_eq!((new_a, new_b), (a, b), "{}", tell());
        assert!(approach.pow(2) <= i128::from(2 * step).pow(2) * dot(n, n), "{}", tell());
        return false;
    }
    true
}

fn gcd(a: i64, b: i64) -> i64 {
    if b == 0 { a } else { gcd(b, a % b) }
}

fn surfaces() -> [Surface; 5] {
    let ratio = |percent| Ratio::percent(percent).unwrap();
    [
        Surface::SLICK,
        Surface::ELASTIC,
        Surface::new(ratio(50), ratio(0)),
        Surface::new(ratio(30), ratio(40)),
        Surface::new(ratio(100), ratio(100)),
    ]
}

#[test]
fn every_small_meeting() {
    let span = |n: i64| (-n..=n).flat_map(move |x| (-n..=n).map(move |y| (x, y)));
    for w in span(6) {
        for n in span(3).filter(|n| *n != (0, 0)) {
            for masses in masses() {
                for surface in surfaces() {
                    for b in [(0, 0), (-3, 2)] {
                        check((w.0 + b.0, w.1 + b.1), b, n, masses, &surface);
                    }
                }
            }
        }
    }
}

#[test]
fn meetings_of_all_speeds() {
    let mut r = Random::new(6);
    let (mut met, mut left) = (0_u64, 0_u64);
    for case in 0..cases(60_000) {
        let fastest = 1 << r.within(1, 28);
        let any = |r: &mut Random, most: i64| (r.around(most - 1), r.around(most - 1));
        let (a, b) = (any(&mut r, fastest), any(&mut r, fastest));
        let n = any(&mut r, 1 << (case % 30 + 1));
        if n == (0, 0) {
            continue;
        }
        let (masses, surface) = (masses()[r.below(7) as usize], surfaces()[r.below(5) as usize]);
        if check(a, b, n, masses, &surface) {
            met += 1;
        } else if dot(sub(a, b), n) > 0 {
            left += 1;
        }
    }
    println!("{met} met, {left} were too slow");
    assert!(met > 10 * left);
}

/// Normals without an opposite act as the directions that they are.
#[test]
fn meetings_at_the_longest_normals() {
    const MIN: i64 = i32::MIN as i64;
    let mut r = Random::new(7);
    for n in [(0, MIN), (MIN, 0), (MIN, MIN), (MIN, MIN / 2), (-3, MIN), (MIN, 7)] {
        let mut met = 0;
        for _ in 0..2_000 {
            let any = |r: &mut Random| (r.around(1 << 20), r.around(1 << 20));
            let (a, b) = (any(&mut r), any(&mut r));
            let (masses, surface) = (masses()[r.below(7) as usize], surfaces()[r.below(5) as usize]);
            met += u32::from(check(a, b, n, masses, &surface));
        }
        assert!(met > 500, "{met}");
    }
}

/// A row of equal balls: the speed that enters on one side leaves on the other.
#[test]
fn newtons_cradle() {
    let mut v = [Vec2::from_ints(5, 0), Vec2::ZERO, Vec2::ZERO, Vec2::ZERO];
    for i in 0..3 {
        (v[i], v[i + 1]) = exchange(v[i], v[i + 1], Axis::X, Masses::EQUAL, &Surface::ELASTIC).unwrap();
    }
    assert_eq!(v, [Vec2::ZERO, Vec2::ZERO, Vec2::ZERO, Vec2::from_ints(5, 0)]);
}
