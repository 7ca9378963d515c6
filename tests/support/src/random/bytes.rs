//! The bytes that steer a thread.

use std::cell::{Cell, RefCell};

struct Stream {
    bytes: Vec<u8>,
    at: usize,
    /// The state of what follows the last byte.
    rest: u64,
}

thread_local! {
    static STEERED: Cell<bool> = const { Cell::new(false) };
    static STREAM: RefCell<Stream> = const { RefCell::new(Stream { bytes: Vec::new(), at: 0, rest: 0 }) };
}

pub(super) fn steer() -> bool {
    STEERED.get()
}

pub(super) fn start(bytes: &[u8]) {
    // FNV-1a.
    let rest = bytes.iter().fold(0xcbf2_9ce4_8422_2325_u64, |h, b| (h ^ u64::from(*b)).wrapping_mul(0x0100_0000_01b3));
    STREAM.with_borrow_mut(|stream| *stream = Stream { bytes: bytes.to_vec(), at: 0, rest });
    STEERED.set(true);
}

pub(super) fn is_left() -> bool {
    STREAM.with_borrow(|stream| stream.at < stream.bytes.len())
}

pub(super) fn take(count: usize) -> u64 {
    STREAM.with_borrow_mut(|stream| {
        (0..count).fold(0, |word, i| {
            let byte = stream.bytes.get(stream.at).copied().unwrap_or_else(|| {
                stream.rest = stream.rest.wrapping_mul(0x5851_f42d_4c95_7f2d).wrapping_add(0x1405_7b7e_f767_814f);
                (stream.rest >> 56) as u8
            });
            stream.at += 1;
            word | u64::from(byte) << (8 * i)
        })
    })
}

pub(super) fn below(n: i64) -> i64 {
    match n {
        ..=1 => 0,
        2..=0x100 => take(1) as i64 % n,
        0x101..=0x1_0000 => take(2) as i64 % n,
        0x1_0001..=0x1_0000_0000 => take(4) as i64 % n,
        _ => (take(8) % n as u64) as i64,
    }
}
