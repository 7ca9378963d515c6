//! Reads files of limited size, and records them.

use std::fs::{self, File};
use std::io::Read;
use std::path::{Path, PathBuf};

/// A map of 4096 x 4096 tiles fits, as a list of numbers of five digits.
const MAX_BYTES: u64 = 112 << 20;
/// The limit for all files of a level together.
const MAX_TOTAL: u64 = 160 << 20;

/// The files of a level.
#[derive(Debug, Default)]
pub(crate) struct Files {
    /// No output may overwrite one of them.
    pub(crate) read: Vec<PathBuf>,
    total: u64,
}

impl Files {
    /// All bytes of a file, or the reason that it cannot be read. Refuses anything but regular
    /// files: a pipe could block its reader.
    pub(crate) fn bytes(&mut self, path: &Path) -> Result<Vec<u8>, String> {
        let cannot = |e: std::io::Error| format!("cannot read: {e}");
        if !fs::metadata(path).map_err(cannot)?.is_file() {
            return Err("cannot read: it is not a file".to_owned());
        }
        let most = MAX_BYTES.min(MAX_TOTAL.saturating_sub(self.total));
        let mut bytes = Vec::new();
        let file = File::open(path).map_err(cannot)?;
        if file.metadata().map_err(cannot)?.len() > most {
            return Err(self.too_large());
        }
        file.take(most + 1).read_to_end(&mut bytes).map_err(cannot)?;
        if bytes.len() as u64 > most {
            return Err(self.too_large());
        }
        self.total += bytes.len() as u64;
        self.read.push(path.to_owned());
        Ok(bytes)
    }

    fn too_large(&self) -> String {
        if self.total == 0 {
            format!("larger than {} MiB", MAX_BYTES >> 20)
        } else {
            format!("the files of the level are larger than {} MiB together", MAX_TOTAL >> 20)
        }
    }
}
