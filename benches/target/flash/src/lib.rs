//! The frame of a program that holds one query and everything it pulls in.

#![no_std]

/// A program whose entry runs `$query` on operands that the compiler knows nothing of, and stores the whole answer.
#[macro_export]
macro_rules! program {
    (|$a:ident: $A:ty, $b:ident: $B:ty| $query:expr) => {
        #[unsafe(no_mangle)]
        extern "C" fn _start() -> ! {
            const OPERANDS: *const (*const $A, *const $B) = 0x2000_0000 as *const _;
            // SAFETY: never run. The volatile read hides the operands from the compiler.
            let ($a, $b): (&$A, &$B) = unsafe {
                let (a, b) = OPERANDS.read_volatile();
                (&*a, &*b)
            };
            core::hint::black_box(&$query);
            loop {}
        }

        #[panic_handler]
        fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
            loop {}
        }
    };
}
