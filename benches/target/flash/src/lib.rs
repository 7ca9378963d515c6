//! The frame of a program that holds one query and everything it pulls in, and of one that holds
//! all there is.
//!
//! On a computer the programs are only checked: their `main` does nothing.

#![no_std]

pub mod hero;

use tilesat::Aabb;
use tilesat::broad::BroadPhase;

/// Bodies come, all move, one goes: a number that tells all pairs.
#[inline(always)]
pub fn frame<B: BroadPhase<Tag = ()>>(mut near: B, boxes: &[Aabb], moved: &[Aabb]) -> usize {
    for bounds in boxes {
        let _ = core::hint::black_box(near.insert(bounds, ()));
    }
    let _ = core::hint::black_box(near.move_each(|body, bounds| *moved.get(body.slot()).unwrap_or(bounds)));
    let (mut sum, mut last) = (0, None);
    near.pairs(|pair| {
        sum += pair.a.slot() ^ pair.b.slot() << 8;
        last = Some(pair.b);
    });
    let _ = core::hint::black_box(last.map(|body| near.remove(body)));
    sum
}

/// A program whose entry runs `$query` on operands that the compiler knows nothing of, and stores
/// the whole answer.
#[macro_export]
macro_rules! program {
    (|$a:ident: $A:ty, $b:ident: $B:ty| $query:expr) => {
        #[cfg_attr(target_os = "none", unsafe(no_mangle))]
        #[cfg_attr(not(target_os = "none"), expect(dead_code))]
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

        #[cfg(not(target_os = "none"))]
        fn main() {}

        #[cfg(target_os = "none")]
        #[panic_handler]
        fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
            loop {}
        }
    };
}

/// A whole game: its state in a static, so that the linker tells how large it is, and a frame
/// without end.
///
/// `$begin` makes of the state the game in it; what a frame needs of the outside it reads by
/// [`port`].
#[macro_export]
macro_rules! game {
    ($State:ty = $empty:expr, $level:ident = $load:expr, |$state:ident| $begin:expr, |$game:ident| $frame:expr) => {
        #[cfg_attr(target_os = "none", unsafe(no_mangle))]
        #[cfg_attr(not(target_os = "none"), expect(dead_code))]
        extern "C" fn _start() -> ! {
            static mut STATE: $State = $empty;
            // SAFETY: never run; this is called once and nothing else names it.
            let $state: &mut $State = unsafe { &mut *(&raw mut STATE) };
            if let Ok($level) = $load {
                let $game = $begin;
                loop {
                    core::hint::black_box(&$frame);
                    core::hint::black_box(&*$game);
                }
            }
            loop {}
        }

        #[cfg(not(target_os = "none"))]
        fn main() {}

        #[cfg(target_os = "none")]
        #[panic_handler]
        fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
            loop {}
        }
    };
}

/// A state that a game makes when it starts: until then it has no value, and no image in flash.
pub struct Later<S>(core::mem::MaybeUninit<S>);

impl<S> Later<S> {
    /// Not yet.
    pub const NONE: Self = Self(core::mem::MaybeUninit::uninit());

    /// The state; without one the program ends here.
    #[inline(always)]
    #[expect(clippy::empty_loop, reason = "it has nobody to tell")]
    pub fn begin(&mut self, state: Option<S>) -> &mut S {
        match state {
            Some(state) => self.0.write(state),
            None => loop {},
        }
    }
}

/// What a pad or a sensor says.
#[inline(always)]
pub fn port() -> u32 {
    // SAFETY: never run; a register of some chip.
    unsafe { (0x4000_0000 as *const u32).read_volatile() }
}

/// A program that holds all these functions, each with arguments that the compiler knows nothing
/// of: what they link, they may run.
///
/// Its panics all end in a function that cannot be inlined away, so that none is missed.
#[macro_export]
macro_rules! everything {
    ($($part:path),+ $(,)?) => {
        #[cfg_attr(target_os = "none", unsafe(no_mangle))]
        #[cfg_attr(not(target_os = "none"), expect(dead_code))]
        extern "C" fn _start() -> ! {
            $($part();)+
            loop {}
        }

        #[cfg(target_os = "none")]
        #[unsafe(no_mangle)]
        #[inline(never)]
        extern "C" fn the_panic() -> ! {
            loop {
                core::hint::black_box(());
            }
        }

        #[cfg(not(target_os = "none"))]
        fn main() {}

        #[cfg(target_os = "none")]
        #[panic_handler]
        fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
            the_panic()
        }
    };
}

/// Links these expressions, each as the body of a function that the compiler cannot know the
/// callers of, with its whole answer.
///
/// The function's symbol says which expression it is, and for which types: the table of stack
/// bounds is made by it.
#[macro_export]
macro_rules! keep {
    ($(|$($x:ident: $t:ty),*| $answer:expr;)+) => {
        $({
            #[unsafe(export_name = concat!("kept ", stringify!($answer), " <- ", stringify!($($x: $t),*)))]
            fn kept($($x: $t),*) {
                let _ = core::hint::black_box(&$answer);
            }
            core::hint::black_box(kept as *const ());
        })+
    };
}
