//! Each query as a function under its row's name. Linked with one of them as the entry, the program
//! holds only that function and its callees.
//!
//! One library has queries, one movers, one broad phases. A function with many callers in a library
//! is not inlined. On a computer the crate is empty.

#![cfg_attr(target_os = "none", no_std)]
#![cfg(target_os = "none")]

macro_rules! named {
    ($name:expr, |$p:ident: $in:ty, $out:ident: $answer:ty| $ask:expr) => {
        const _: () = {
            // SAFETY: the names contain bars, and nothing else uses them.
            #[unsafe(export_name = $name)]
            extern "C" fn query($p: &$in, $out: &mut $answer) {
                $ask;
            }
        };
    };
}

#[cfg(feature = "broad")]
mod broad;
#[cfg(feature = "moves")]
mod moves;
#[cfg(feature = "queries")]
mod queries;

#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {}
}
