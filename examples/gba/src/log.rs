//! Writes text and the exit status to the emulator's debug log. A console has no such registers, so
//! nothing happens there.

use core::fmt::{self, Write};
use core::panic::PanicInfo;

use crate::register::{write8, write16};

const BUFFER: u32 = 0x04ff_f600;
const SEND: u32 = 0x04ff_f700;
const ENABLE: u32 = 0x04ff_f780;
/// The buffer holds this many bytes and a zero.
const LINE: u32 = 255;

/// One line. It is sent when it goes out of scope.
#[derive(Debug)]
pub struct Line {
    length: u32,
}

impl Line {
    #[must_use]
    pub fn new() -> Self {
        write16(ENABLE, 0xc0de);
        Self { length: 0 }
    }
}

impl Default for Line {
    fn default() -> Self {
        Self::new()
    }
}

impl Write for Line {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        for byte in text.bytes() {
            if self.length == LINE {
                return Err(fmt::Error);
            }
            write8(BUFFER + self.length, byte);
            self.length += 1;
        }
        Ok(())
    }
}

impl Drop for Line {
    fn drop(&mut self) {
        write8(BUFFER + self.length, 0);
        // Level 3 is "info".
        write16(SEND, 0x100 | 3);
    }
}

/// Prints a line of at most 255 bytes.
#[macro_export]
macro_rules! println {
    ($($part:tt)*) => {{
        use core::fmt::Write;
        let _ = write!($crate::log::Line::new(), $($part)*);
    }};
}

/// Tells the front end to stop with this status, or with 102 if the stack reached the data. Does
/// not return.
pub fn exit(status: i32) -> ! {
    let (used, all) = crate::stack::used();
    if used < all {
        println!("EXIT {status}");
    } else {
        println!("the stack reached the data");
        println!("EXIT 102");
    }
    #[expect(clippy::empty_loop, reason = "a console has nowhere to return to")]
    loop {}
}

#[panic_handler]
fn panic(info: &PanicInfo<'_>) -> ! {
    println!("{info}");
    exit(101)
}
