//! The frame of a program that holds one query and everything that it links, and of a program that
//! holds everything.
//!
//! On a computer the programs only compile: their `main` does nothing.

#![no_std]

pub mod bodies;
pub mod hero;

use tilesat::Aabb;
use tilesat::broad::BroadPhase;

/// Bodies come, all move, and one goes. Returns a number that identifies all pairs.
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

/// A program whose entry runs `$query` on operands that the compiler cannot know. It stores the
/// whole answer.
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

/// A whole game: its state in a static, so that the linker reports its size, and an endless loop of
/// frames.
///
/// `$begin` turns the state into the game in it. A frame reads its inputs by [`port`].
#[macro_export]
macro_rules! game {
    ($State:ty = $empty:expr, $level:ident = $load:expr, |$state:ident| $begin:expr, |$game:ident| $frame:expr) => {
        #[cfg_attr(target_os = "none", unsafe(no_mangle))]
        #[cfg_attr(not(target_os = "none"), expect(dead_code))]
        extern "C" fn _start() -> ! {
            static mut STATE: $State = $empty;
            // SAFETY: never run. One call, and nothing else names it.
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

/// The state that a game makes at its start. It has no value before, and no image in flash.
pub struct Later<S>(core::mem::MaybeUninit<S>);

impl<S> Later<S> {
    /// Before the start.
    pub const NONE: Self = Self(core::mem::MaybeUninit::uninit());

    /// The state. Without one the program ends here.
    #[inline(always)]
    #[expect(clippy::empty_loop, reason = "it has nobody to tell")]
    pub fn begin(&mut self, state: Option<S>) -> &mut S {
        match state {
            Some(state) => self.0.write(state),
            None => loop {},
        }
    }
}

/// An input of a pad or a sensor.
#[inline(always)]
pub fn port() -> u32 {
    // SAFETY: never run; a register of some chip.
    unsafe { (0x4000_0000 as *const u32).read_volatile() }
}

/// A program that holds all these functions, each with arguments that the compiler cannot know. So
/// it links everything that they may run.
///
/// Its panics all end in a function that the compiler cannot inline. So the check misses none.
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

/// Links these expressions. Each is the body of a function whose callers the compiler cannot know,
/// with its whole answer.
///
/// The function's symbol names the expression and its types. The table of stack bounds uses it.
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
