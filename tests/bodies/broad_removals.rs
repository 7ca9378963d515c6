//! Broad phases: removals during enumerations, and the border of a grid.

use tilesat::broad::{Border, BroadPhase, BruteForce, LooseGrid, Pair, PairCursor, SortSweep, SpatialHash};
use tilesat::{Aabb, Fx, Vec2};
use tilesat_judge::broad::near::Near;

fn bx(x: i16, y: i16, w: i16, h: i16) -> Aabb {
    Aabb::new(Vec2::from_ints(x, y), Vec2::from_ints(x + w, y + h)).unwrap()
}
fn raw(x: i32, y: i32, w: i32, h: i32) -> Aabb {
    Aabb::new(Vec2::from_raw(x, y), Vec2::from_raw(x + w, y + h)).unwrap()
}

/// NIL read as the number of a cell is a point beyond the grid. A large body that becomes small
/// there must be refused, too.
#[test]
fn refuse_refuses_what_was_large() {
    // 4 columns, 2047 * 8 rows of 1/4 unit; place(65535) is column 3, row 16383.
    let cell = Fx::from_bits(1 << 14);
    let mut near =
        Box::new(LooseGrid::<2047, 4, (), true>::new(Vec2::ZERO, cell, 4).unwrap().with_border(Border::Refuse));
    let h = near.insert(&bx(0, 0, 1, 1), ()).unwrap();
    let to = raw(3 << 14, 16383 << 14, 100, 100);
    assert!(near.move_to(h, &to).is_err());
    assert!(near.move_each(|_, _| to).is_err());
}

/// Removal at every point of every enumeration, with budget 1. The rest is complete, without
/// repeats.
fn removals(name: &str, mut near: Near<()>, boxes: &[Aabb]) {
    let handles: Vec<_> = boxes.iter().map(|b| near.insert(b, ()).unwrap()).collect();
    let n = handles.len();
    for first in 0..n {
        for second in 0..n {
            for third in [n, (second + 1) % n] {
                for when in 0..40 {
                    let mut near = near.clone();
                    let mut cursor = PairCursor::new();
                    let mut out = heapless::Vec::<Pair, 256>::new();
                    let mut k = 0;
                    let mut pre = 0;
                    loop {
                        if k == when {
                            pre = out.len();
                            let _ = near.remove(handles[first]);
                            let _ = near.remove(handles[second]);
                            if third < n {
                                let _ = near.remove(handles[third]);
                            }
                            near.pairs(|_| {});
                            let all: Vec<_> = handles.iter().copied().filter(|h| near.contains(*h)).collect();
                            near.pairs_of(&all, |_| {}).unwrap();
                        }
                        k += 1;
                        assert!(k < 5000);
                        if near.pairs_from(&mut cursor, 1, &mut out).is_ok() {
                            break;
                        }
                    }
                    if k <= when {
                        break;
                    }
                    let gone = |h| h == handles[first] || h == handles[second] || (third < n && h == handles[third]);
                    let _ = pre;
                    for (i, p) in out.iter().enumerate() {
                        assert!(!out[..i].contains(p), "{name}: double");
                        assert!(i < pre || !(gone(p.a) || gone(p.b)), "{name}: a dead one");
                    }
                    for i in 0..n {
                        for j in i + 1..n {
                            let (a, b) = (handles[i], handles[j]);
                            if gone(a) || gone(b) {
                                continue;
                            }
                            let (p, q) = (boxes[i], boxes[j]);
                            let t = p.min().x <= q.max().x
                                && q.min().x <= p.max().x
                                && p.min().y <= q.max().y
                                && q.min().y <= p.max().y;
                            assert_eq!(
                                t,
                                out.contains(&Pair { a, b }),
                                "{name}: {i} {j} when {when} removed {first} {second} {third}"
                            );
                        }
                    }
                }
            }
        }
    }
}

#[test]
fn removals_everywhere() {
    let boxes = [
        bx(0, 0, 8, 8),
        bx(8, 0, 8, 8),
        bx(0, 8, 8, 8),
        bx(8, 8, 8, 8),
        bx(4, 4, 0, 0),
        bx(16, 16, 0, 8),
        bx(16, 8, 8, 0),
        bx(-8, 16, 8, 8),
    ];
    let large = [
        bx(0, 0, 80, 8),
        bx(8, 0, 8, 8),
        bx(0, 8, 8, 80),
        bx(8, 8, 8, 8),
        bx(4, 4, 0, 0),
        bx(16, 16, 0, 8),
        bx(-16, 8, 80, 80),
        bx(-8, 16, 8, 8),
    ];
    let c = Fx::from_num(8);
    for b in [&boxes, &large] {
        removals("brute", Near::new(BruteForce::<8>::new()), b);
        removals("sweep", Near::new(SortSweep::<8>::new()), b);
        removals("grid L", Near::new(LooseGrid::<1, 8, (), true>::new(Vec2::from_ints(4, 4), c, 4).unwrap()), b);
        removals("hash L", Near::new(SpatialHash::<64, 8, (), true>::new(c).unwrap()), b);
    }
    removals("grid", Near::new(LooseGrid::<1, 8>::new(Vec2::ZERO, c, 8).unwrap()), &boxes);
    removals("hash", Near::new(SpatialHash::<64, 8>::new(c).unwrap()), &boxes);
}
