//! Queries: pairs, casts and rays.

use core::mem::MaybeUninit;
use tilesat_precision_queries::*;

macro_rules! function {
    ($workload:literal, $backend:literal, $asked:literal, $in:ty, $out:ty, |$p:ident| $ask:expr, |$o:ident| $hit:expr) => {
        named! { concat!($workload, "|", $backend, "|", $asked), |$p: $in, out: MaybeUninit<$out>| out.write($ask) }
    };
}

macro_rules! ray {
    ($workload:literal, $backend:literal, $map:ty, $start:ty, $out:ty, |$r:ident| $ask:expr, |$o:ident| $hit:expr) => {
        function! { $workload, $backend, "ray", Ray<'_, $map, $start>, $out, |$r| $ask, |$o| $hit }
    };
}

each_pair!(function);
each_cast!(function);
each_ray!(ray);
