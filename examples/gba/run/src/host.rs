//! The callbacks of the core. The interface has no user data, so the state is global.

use std::ffi::{CStr, c_char, c_uint, c_void};
use std::sync::Mutex;

/// A picture, three bytes per pixel.
#[derive(Clone, Debug)]
pub struct Screen {
    pub width: usize,
    pub height: usize,
    pub rgb: Vec<u8>,
}

struct Host {
    keys: u16,
    format: c_uint,
    screen: Screen,
    status: Option<u8>,
}

static HOST: Mutex<Host> =
    Mutex::new(Host { keys: 0, format: 0, screen: Screen { width: 0, height: 0, rgb: Vec::new() }, status: None });

/// A panic must not cross into the core. The state is valid in any case.
fn host() -> std::sync::MutexGuard<'static, Host> {
    HOST.lock().unwrap_or_else(std::sync::PoisonError::into_inner)
}

pub fn press(keys: u16) {
    host().keys = keys;
}

pub fn status() -> Option<u8> {
    host().status
}

pub fn screen() -> Screen {
    host().screen.clone()
}

const SYSTEM_DIRECTORY: c_uint = 9;
const SET_PIXEL_FORMAT: c_uint = 10;
const LOG_INTERFACE: c_uint = 27;
const SAVE_DIRECTORY: c_uint = 31;

pub unsafe extern "C" fn environment(command: c_uint, data: *mut c_void) -> bool {
    // SAFETY: the command determines the type behind the core's pointer.
    unsafe {
        match command & 0xffff {
            LOG_INTERFACE => *data.cast::<*const c_void>() = log as *const c_void,
            SET_PIXEL_FORMAT => host().format = *data.cast(),
            // Nothing is saved. The core looks for files in a folder without any.
            SYSTEM_DIRECTORY | SAVE_DIRECTORY => *data.cast::<*const c_char>() = c"/nonexistent".as_ptr(),
            _ => return false,
        }
    }
    true
}

/// The program's lines come as the format "%s: %s\n" with a category and the text. All other lines
/// are the core's own and are skipped.
///
/// The prototype is variadic. On x86-64 and 64-bit Arm under Linux, the first two variadic pointers
/// are in these registers.
unsafe extern "C" fn log(_level: c_uint, format: *const c_char, category: *const c_char, text: *const c_char) {
    // SAFETY: strings of the core, valid during the call. The last two are valid if the format says
    // so.
    let (category, text) = unsafe {
        if CStr::from_ptr(format).to_bytes() != b"%s: %s\n" {
            return;
        }
        (CStr::from_ptr(category), CStr::from_ptr(text))
    };
    if category.to_bytes() != b"GBA Debug" {
        return;
    }
    let text = text.to_string_lossy();
    match text.trim_end().strip_prefix("EXIT ") {
        Some(status) => host().status = Some(status.parse().unwrap_or(u8::MAX)),
        None => println!("{}", text.trim_end()),
    }
}

pub unsafe extern "C" fn video(data: *const c_void, width: c_uint, height: c_uint, pitch: usize) {
    // A frame equal to the last one.
    if data.is_null() {
        return;
    }
    let (width, height) = (width as usize, height as usize);
    let mut host = host();
    let format = host.format;
    let mut rgb = Vec::with_capacity(width * height * 3);
    for y in 0..height {
        for x in 0..width {
            // SAFETY: the core's picture has `height` rows, `pitch` bytes apart, of `width` pixels
            // in the format that it has set.
            rgb.extend(unsafe {
                let row = data.cast::<u8>().add(y * pitch);
                match format {
                    1 => from_8888(row.cast::<u32>().add(x).read_unaligned()),
                    2 => from_565(row.cast::<u16>().add(x).read_unaligned()),
                    _ => from_1555(row.cast::<u16>().add(x).read_unaligned()),
                }
            });
        }
    }
    host.screen = Screen { width, height, rgb };
}

fn from_8888(pixel: u32) -> [u8; 3] {
    let [blue, green, red, _] = pixel.to_le_bytes();
    [red, green, blue]
}

fn from_565(pixel: u16) -> [u8; 3] {
    [widen(pixel >> 11, 31), widen(pixel >> 5 & 63, 63), widen(pixel & 31, 31)]
}

fn from_1555(pixel: u16) -> [u8; 3] {
    [widen(pixel >> 10 & 31, 31), widen(pixel >> 5 & 31, 31), widen(pixel & 31, 31)]
}

fn widen(value: u16, most: u16) -> u8 {
    (value * 255 / most) as u8
}

pub unsafe extern "C" fn key(_port: c_uint, _device: c_uint, _index: c_uint, id: c_uint) -> i16 {
    i16::from(id < 16 && host().keys >> id & 1 != 0)
}

pub unsafe extern "C" fn poll() {}

pub unsafe extern "C" fn sample(_left: i16, _right: i16) {}

pub unsafe extern "C" fn samples(_data: *const i16, frames: usize) -> usize {
    frames
}
