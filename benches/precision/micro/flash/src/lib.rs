//! Each query as a function under its row's name. Linked with one of them as the entry, what is left is what it pulls in.

#![no_std]

use core::mem::MaybeUninit;
use tilesat_precision_queries::*;

macro_rules! named {
    ($name:expr, |$p:ident: $in:ty, $out:ident: $answer:ty| $ask:expr) => {
        const _: () = {
            // SAFETY: the names have bars in them, and are no one else's.
            #[unsafe(export_name = $name)]
            extern "C" fn query($p: &$in, $out: &mut $answer) {
                $ask;
            }
        };
    };
}

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

macro_rules! mover {
    ($workload:literal, $kind:literal, $backend:literal, $level:ty, $body:ty, $motion:ty, |$s:ident| $ask:expr) => {
        named! { concat!($workload, "|", $kind, "|", $backend, "|move"),
        |$s: Step<'_, $level, $body, $motion>, out: MaybeUninit<$body>| out.write($ask) }
    };
}

macro_rules! phase {
    ($workload:literal, $backend:literal, $asked:literal, $n:literal, $phase:ty) => {
        named! { concat!($workload, "|", $backend, "|", $asked),
        |boxes: [<$phase as Phase<$n>>::Box; $n], scene: Scene<$phase, $n>| scene.frame(boxes) }
    };
}

each_pair!(function);
each_cast!(function);
each_ray!(ray);
each_move!(mover);
// How many boxes there are is a number in the code.
each_broad!(phase 64, 8, 64);

#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {}
}
