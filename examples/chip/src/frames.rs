//! Sends defmt's frames to standard error, so that they do not mix with plain lines.

use semihosting::io::{Write, stderr};

static mut ENCODER: defmt::Encoder = defmt::Encoder::new();

#[defmt::global_logger]
struct Logger;

fn put(bytes: &[u8]) {
    if let Ok(mut out) = stderr() {
        let _ = out.write_all(bytes);
    }
}

fn encoder() -> &'static mut defmt::Encoder {
    let encoder = &raw mut ENCODER;
    // SAFETY: there is one thread and no interrupt handler that logs, and defmt never nests these
    // calls.
    unsafe { &mut *encoder }
}

// SAFETY: acquire and release need no lock if nothing can interrupt them.
unsafe impl defmt::Logger for Logger {
    fn acquire() {
        encoder().start_frame(put);
    }
    unsafe fn flush() {}
    unsafe fn release() {
        encoder().end_frame(put);
    }
    unsafe fn write(bytes: &[u8]) {
        encoder().write(bytes, put);
    }
}
