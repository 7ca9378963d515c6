//! All numbers, vectors and masks.
#![cfg_attr(target_os = "none", no_std, no_main)]
use tilesat::fixed::types::I16F16;
use tilesat::num::{
    div_sqrt, imul, imul_split, isqrt64, isqrt64_ceil, less128, mul_div, mul_div_wide, mul64, recip, rsqrt, sqr64,
    umul, umul_split, usqr, usqr_split,
};
use tilesat::{Axis, Filter, Fx, LayerMask, Ratio, Toi, UnitVec2, Vec2};
use tilesat_flash::keep;

fn words() {
    keep! {
        |d: u32| recip(d);
        |a: u32, b: u32, d: u32| mul_div(a, b, d);
        |a: u64, k: u32, n: u64| mul_div_wide(a, k, n);
        |s: u64, n: u64| div_sqrt(s, n);
        |h: u32| rsqrt(h);
        |n: u64| isqrt64(n);
        |n: u64| isqrt64_ceil(n);
        |a: u32, b: u32| umul(a, b);
        |a: u32| usqr(a);
        |a: i32, b: i32| imul(a, b);
        |a: u32, b: u32| umul_split(a, b);
        |a: i32, b: i32| imul_split(a, b);
        |a: u32| usqr_split(a);
        |a: u64, b: u64| mul64(a, b);
        |a: u64| sqr64(a);
        |a: (u64, u64), b: (u64, u64)| less128(a, b);
    }
}

fn scalars() {
    keep! {
        |num: u32, den: u32| Ratio::new(num, den);
        |hundredths: u8| Ratio::percent(hundredths);
        |raw: u32| Ratio::from_raw(raw);
        |r: Ratio| r.raw();
        |r: Ratio| r.complement();
        |r: Ratio, length: I16F16| r.of(length);
        |raw: u32| Toi::from_raw(raw);
        |t: Toi| t.raw();
        |t: Toi| t.to_fx();
        |t: Toi| t.to_f32();
        |t: Toi, motion: Vec2| t.of(motion);
    }
}

fn vectors() {
    keep! {
        |x: Fx, y: Fx| Vec2::new(x, y);
        |x: i32, y: i32| Vec2::from_raw(x, y);
        |x: i16, y: i16| Vec2::from_ints(x, y);
        |v: Vec2| v.raw();
        |a: Vec2, b: Vec2| a.dot(b);
        |a: Vec2, b: Vec2| a.perp_dot(b);
        |v: Vec2| v.length_squared();
        |v: Vec2| v.length();
        |a: Vec2, b: Vec2| a.min(b);
        |a: Vec2, b: Vec2| a.max(b);
        |v: Vec2, lo: Vec2, hi: Vec2| v.clamp(lo, hi);
        |v: Vec2| (v.abs(), v.signum(), v.perp());
        |a: Vec2, b: Vec2| a.distance(b);
        |a: Vec2, b: Vec2, part: Ratio| a.lerp(b, part);
        |v: Vec2| v.unit();
        |v: Vec2| Axis::from(v);
        |a: Vec2, b: Vec2| a.saturating_add(b);
        |a: Vec2, b: Vec2| a + b;
        |a: Vec2, b: Vec2| a - b;
        |a: &mut Vec2, b: Vec2| *a += b;
        |a: &mut Vec2, b: Vec2| *a -= b;
        |v: Vec2| -v;
        |v: Vec2, by: Fx| v * by;
        |v: Vec2, by: Fx| v / by;
        |v: Vec2, by: i32| v * by;
        |v: Vec2, by: i32| v / by;
        |v: &mut Vec2, by: Fx| *v *= by;
        |v: &mut Vec2, by: Fx| *v /= by;
        |v: &mut Vec2, by: i32| *v *= by;
        |v: &mut Vec2, by: i32| *v /= by;
        |v: Vec2, by: Fx| v.saturating_mul(by);
        |v: Vec2, by: Fx| v.saturating_div(by);
        |a: Vec2, b: Vec2| a.saturating_sub(b);
        |a: Vec2, b: Vec2| a.checked_add(b);
        |a: Vec2, b: Vec2| a.checked_sub(b);
        |v: Vec2, by: Fx| v.checked_mul(by);
        |v: Vec2, by: Fx| v.checked_div(by);
        |x: f32, y: f32| Vec2::from_f32(x, y);
        |v: Vec2| v.to_f32();
        |v: Vec2| v.to_ints();
        |v: (i16, i16)| Vec2::from(v);
        |v: (i32, i32)| Vec2::try_from(v);
        |v: (Fx, Fx)| Vec2::from(v);
        |v: [Fx; 2]| Vec2::from(v);
        |v: Vec2| <[Fx; 2]>::from(v);
        |x: i32, y: i32| Axis::new(x, y);
        |a: Axis, b: Axis| a.dot(b);
        |a: Axis, b: Axis| a.perp_dot(b);
        |a: Axis, v: Vec2| a.dot_vec(v);
        |a: Axis| a.perp();
        |a: Axis| a.reversed();
        |a: Axis| -a;
        |a: Axis| a.is_zero();
        |a: Axis| a.unit();
        |turns: Fx| Axis::from_turns(turns);
        |angle: f32| Axis::from_radians(angle);
        |a: Axis| a.length_squared();
        |u: UnitVec2| (u.x(), u.y(), u.raw());
        |u: UnitVec2, length: Fx| u.scaled(length);
        |u: UnitVec2, v: Vec2| u.rotate(v);
        |u: UnitVec2| u.to_f32();
    }
}

fn masks() {
    keep! {
        |index: u8| LayerMask::layer(index);
        |a: LayerMask, b: LayerMask| (a.intersects(b), a.with(b), a | b, a & b, !a);
        |a: LayerMask, b: LayerMask| Filter::new(a, b);
        |f: Filter, group: i16| f.with_group(group);
        |f: Filter, on: bool| f.with_still(on).with_sensor(on);
        |f: Filter| (f.still(), f.sensor());
        |_any: u8| Filter::default();
    }
}

tilesat_flash::everything!(words, scalars, vectors, masks);
