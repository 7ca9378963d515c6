//! Each query as a function under its row's name. Linked with one of them as the entry, what is left is what it pulls in.

#![no_std]

use tilesat_precision_queries::*;

macro_rules! function {
    ($workload:literal, $backend:literal, $asked:literal, $in:ty, $out:ty, |$p:ident| $ask:expr, |$o:ident| $hit:expr) => {
        const _: () = {
            // SAFETY: the names have bars in them, and are no one else's.
            #[unsafe(export_name = concat!($workload, "|", $backend, "|", $asked))]
            extern "C" fn query($p: &$in, out: &mut core::mem::MaybeUninit<$out>) {
                out.write($ask);
            }
        };
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

#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {}
}
