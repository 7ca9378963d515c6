//! Words, scalars and vectors: products, roots, quotients, unit vectors.

use tilesat::num::{
    div_sqrt, imul, imul_split, isqrt64, isqrt64_ceil, less128, mul_div, mul_div_wide, mul64, recip, rsqrt, sqr64,
    umul, umul_split, usqr, usqr_split,
};
use tilesat::{Axis, Fx, Ratio, Toi, Vec2};

use super::VECTORS;
use super::family::Run;
use super::random::{Direction, Random};

/// The top bit set, as `recip` and `rsqrt` want at least one of two.
const TOP: u32 = 1 << 31;

/// A word of any number of bits. Often few, or a power of two within one.
fn word(r: &mut Random) -> u32 {
    let word = r.word() >> (r.word() >> 27);
    if r.once_in(4) { (1u32 << word.checked_ilog2().unwrap_or(0)).wrapping_add_signed(r.small(1)) } else { word }
}

/// A wide number. Often a square, or one off.
fn wide(r: &mut Random) -> u64 {
    match r.below(4) {
        0 => {
            let root = u64::from(word(r));
            (root * root).wrapping_add_signed(i64::from(r.small(1)))
        }
        1 => (1u64 << (r.word() >> 26)).wrapping_add_signed(i64::from(r.small(1))),
        _ => r.wide(),
    }
}

/// A direction: of few bits, of many, along an axis, with an exact length.
fn axis(r: &mut Random) -> Axis {
    match r.below(4) {
        0 => Axis::new(r.small(9), r.small(9)),
        1 => Axis::new(r.signed(30), r.signed(30)),
        2 => {
            let (d, k) = (Direction::any(r), r.small(9999));
            Axis::new(d.x * k, d.y * k)
        }
        _ => {
            let (x, y) = (r.below(30), r.below(30));
            Axis::new(r.signed(x), r.signed(y))
        }
    }
}

fn words(run: &mut Run<'_>) {
    let queries = ["products", "wide_products", "recip", "rsqrt", "isqrt64", "mul_div", "mul_div_wide", "div_sqrt"];
    run.family(
        "words",
        VECTORS,
        queries,
        |_, r, [products, wide_products, reciprocal, inverse, root, ratio, wide_ratio, by_root]| {
            let (a, b, d) = (word(r), word(r), word(r));
            products.add([umul(a, b), umul_split(a, b), usqr(a), usqr_split(a)]);
            products.add([imul(a as i32, b as i32), imul_split(a as i32, b as i32)]);
            let (m, n) = (wide(r), wide(r) >> 1);
            let (product, square) = (mul64(m, n), sqr64(m));
            wide_products.add([product, square]);
            wide_products.add(less128(product, square));
            reciprocal.add(recip(d | TOP));
            inverse.add(rsqrt(a | TOP >> (b & 1)));
            root.add([isqrt64(m), isqrt64_ceil(m)]);
            ratio.add(mul_div(a, b, d));
            wide_ratio.add(mul_div_wide(m, a, n));
            by_root.add(div_sqrt(m, n));
        },
    );
}

fn vectors(run: &mut Run<'_>) {
    let queries = ["unit", "scaled", "axis_products", "length", "vec_products", "sums"];
    run.family("vectors", VECTORS, queries, |_, r, [unit, scaled, axis_products, length, vec_products, sums]| {
        let (a, b) = (axis(r), axis(r));
        let v = if r.once_in(8) { Vec2::from_raw(r.word() as i32, r.word() as i32) } else { Vec2::from_raw(b.y, a.x) };
        let by = r.below(31);
        let by = Fx::from_bits(r.signed(by));
        unit.add(a.unit());
        scaled.add(a.unit().scaled(by));
        axis_products.add([a.dot(b), a.perp_dot(b), a.dot_vec(Vec2::from_raw(b.x, b.y))]);
        axis_products.add(a.length_squared());
        axis_products.add([a.perp(), a.reversed(), -a]);
        length.add(v.length());
        let w = Vec2::from_raw(b.x, b.y);
        vec_products.add([w.dot(Vec2::from_raw(a.x, a.y)), w.perp_dot(Vec2::from_raw(a.x, a.y))]);
        vec_products.add(v.length_squared());
        sums.add([v + w, v - w, -v, v.min(w), v.max(w), v.saturating_add(w)]);
    });
}

fn angles(run: &mut Run<'_>) {
    run.family("angles", VECTORS, ["directions", "turned"], |_, r, [directions, turned]| {
        let bits = r.word() as i32;
        directions.add([Axis::from_turns(Fx::from_bits(bits)), Axis::from_turns(Fx::from_bits(bits >> 15))]);
        directions.add([bits, bits >> 3].map(|bits| Axis::from_radians(f32::from_bits(bits as u32))));
        turned.add(axis(r).unit().rotate(Vec2::from_raw(r.word() as i32, bits)));
    });
}

fn fractions(run: &mut Run<'_>) {
    run.family("fractions", VECTORS, ["ratio", "ratio_of", "toi"], |_, r, [ratio, of, toi]| {
        let (num, den) = (word(r), word(r));
        let found = [Ratio::new(num, den), Ratio::percent(num as u8), Ratio::from_raw(num >> 1)];
        ratio.add(found);
        ratio.add(found.map(|ratio| ratio.map(Ratio::complement)));
        let length = Fx::from_bits(r.signed(31));
        of.add(found.map(|ratio| ratio.map(|ratio| ratio.of(length))));
        let time = Toi::from_raw(num >> 1).unwrap_or(Toi::ONE);
        toi.add(time.to_fx());
        toi.add(time.of(Vec2::from_raw(r.signed(29), r.signed(16))));
    });
}

pub(crate) fn run(run: &mut Run<'_>) {
    words(run);
    vectors(run);
    angles(run);
    fractions(run);
}
