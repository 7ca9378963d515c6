//! defmt's frames go to standard error and do not mix with plain lines.

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
    // SAFETY: one thread and no interrupt handler that logs; defmt never nests these calls.
    unsafe { &mut *encoder }
}

// SAFETY: acquire and release need no lock where nothing can come between them.
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
