//! Memory-mapped registers and video memory.
//!
//! The addresses are constants of this crate. They are in parts of the console's map that always
//! respond and that Rust does not use. So a volatile access is sound.

#[inline(always)]
pub(crate) fn read16(address: u32) -> u16 {
    // SAFETY: see above. Every caller aligns it to a halfword.
    unsafe { (address as *const u16).read_volatile() }
}

#[inline(always)]
pub(crate) fn write16(address: u32, value: u16) {
    // SAFETY: see above. Every caller aligns it to a halfword.
    unsafe { (address as *mut u16).write_volatile(value) }
}

#[inline(always)]
pub(crate) fn write8(address: u32, value: u8) {
    // SAFETY: see above.
    unsafe { (address as *mut u8).write_volatile(value) }
}

#[inline(always)]
pub(crate) fn read32(address: u32) -> u32 {
    // SAFETY: see above. Every caller aligns it to a word.
    unsafe { (address as *const u32).read_volatile() }
}

#[inline(always)]
pub(crate) fn write32(address: u32, value: u32) {
    // SAFETY: see above. Every caller aligns it to a word.
    unsafe { (address as *mut u32).write_volatile(value) }
}
