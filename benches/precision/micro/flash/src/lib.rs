//! Each query as a function under its row's name. Linked with one of them as the entry, what is left is what it pulls in.

#![no_std]

#[allow(dead_code, reason = "inputs are made only where they are counted")]
#[path = "../../queries.rs"]
mod queries;

use queries::*;

macro_rules! function {
    ($workload:literal, $backend:literal, $asked:literal, $a:ty, $b:ty, $out:ty, |$p:ident| $ask:expr, |$o:ident| $hit:expr) => {
        const _: () = {
            // SAFETY: the names have bars in them, and are no one else's.
            #[unsafe(export_name = concat!($workload, "|", $backend, "|", $asked))]
            extern "C" fn query($p: &($a, $b), out: &mut core::mem::MaybeUninit<$out>) {
                out.write($ask);
            }
        };
    };
}

each_query!(function);

#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {}
}
