//! The greatest use of the stack so far. It lies above the data, and start-up fills it with zeroes.

unsafe extern "C" {
    static __bss_end: u32;
    static __stack_top: u32;
}

/// The most bytes used so far, and the bytes available.
#[must_use]
pub fn used() -> (usize, usize) {
    let (mut at, top) = (&raw const __bss_end, &raw const __stack_top);
    let all = top as usize - at as usize;
    // SAFETY: aligned words of fast RAM from the end of the data to the top of the stack, which
    // holds this function's frame.
    while unsafe { at.read_volatile() } == 0 {
        at = at.wrapping_add(1);
    }
    (top as usize - at as usize, all)
}
