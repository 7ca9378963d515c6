//! The core: a shared library with the interface of libretro.

use std::error::Error;
use std::ffi::{CString, c_void};
use std::path::Path;

use libloading::Library;

use crate::host;

/// The argument of `retro_load_game`. Cores that accept only a file name do not work here.
#[repr(C)]
struct Game {
    path: *const std::ffi::c_char,
    data: *const c_void,
    size: usize,
    meta: *const std::ffi::c_char,
}

pub struct Core {
    run: unsafe extern "C" fn(),
    _library: Library,
}

impl Core {
    /// Starts the core with a cartridge.
    pub fn load(path: &Path, rom: &[u8]) -> Result<Self, Box<dyn Error>> {
        // SAFETY: the names and types are those of libretro's interface, version 1, in the order
        // that it requires. The game's data outlives the call, and the core copies what it keeps.
        unsafe {
            let library = Library::new(path).map_err(|error| format!("{}: {error}", path.display()))?;
            let set: [(&[u8], *const c_void); 6] = [
                (b"retro_set_environment", host::environment as *const c_void),
                (b"retro_set_video_refresh", host::video as *const c_void),
                (b"retro_set_audio_sample", host::sample as *const c_void),
                (b"retro_set_audio_sample_batch", host::samples as *const c_void),
                (b"retro_set_input_poll", host::poll as *const c_void),
                (b"retro_set_input_state", host::key as *const c_void),
            ];
            for (name, callback) in set {
                library.get::<unsafe extern "C" fn(*const c_void)>(name)?(callback);
            }
            library.get::<unsafe extern "C" fn()>(b"retro_init")?();
            let name = CString::new("tilesat.gba")?;
            let game = Game { path: name.as_ptr(), data: rom.as_ptr().cast(), size: rom.len(), meta: std::ptr::null() };
            if !library.get::<unsafe extern "C" fn(*const Game) -> bool>(b"retro_load_game")?(&raw const game) {
                return Err("the core refuses the cartridge".into());
            }
            let run = *library.get::<unsafe extern "C" fn()>(b"retro_run")?;
            Ok(Self { run, _library: library })
        }
    }

    /// Runs one frame with these keys down. Returns the program's exit status once it has ended.
    pub fn frame(&self, keys: u16) -> Option<u8> {
        host::press(keys);
        // SAFETY: a game is loaded, and the library is still loaded.
        unsafe { (self.run)() };
        host::status()
    }
}
