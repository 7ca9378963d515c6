//! Pairs of boxes that overlap: all against all, and sorted along x.

use crate::Scalar;
use crate::pair::aabb_aabb;
use crate::shape::Aabb;

pub fn brute<S: Scalar>(boxes: &[Aabb<S>], mut each: impl FnMut(u32, u32)) {
    for (i, a) in boxes.iter().enumerate() {
        for (j, b) in boxes.iter().enumerate().skip(i + 1) {
            if aabb_aabb(a, b) {
                each(i as u32, j as u32);
            }
        }
    }
}

/// By insertion into a kept order: little changes from frame to frame.
pub fn sweep<S: Scalar>(order: &mut [u32], boxes: &[Aabb<S>], mut each: impl FnMut(u32, u32)) {
    for i in 1..order.len() {
        let (body, mut at) = (order[i], i);
        let x = boxes[body as usize].lo.x;
        while at > 0 && boxes[order[at - 1] as usize].lo.x > x {
            order[at] = order[at - 1];
            at -= 1;
        }
        order[at] = body;
    }
    for (i, &first) in order.iter().enumerate() {
        let a = &boxes[first as usize];
        for &second in &order[i + 1..] {
            let b = &boxes[second as usize];
            if b.lo.x >= a.hi.x {
                break;
            }
            if aabb_aabb(a, b) {
                each(first, second);
            }
        }
    }
}
