//! Reads files of limited size, and records them.

use std::fs::{self, File};
use std::io::Read;
use std::path::{Component, Path, PathBuf};

use super::text;

/// A map of 4096 x 4096 tiles fits, as a list of numbers of five digits.
const MAX_BYTES: u64 = 112 << 20;
/// The limit for all files of a level together.
const MAX_TOTAL: u64 = 160 << 20;

/// The files of a level.
#[derive(Debug, Default)]
pub(crate) struct Files {
    /// No output may overwrite one of them.
    pub(crate) read: Vec<PathBuf>,
    /// Names that are not quite those of files.
    pub(crate) notes: Vec<String>,
    /// The names of all levels, also of those that are skipped.
    pub(crate) levels: Vec<String>,
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
        if bytes.starts_with(b"version https://git-lfs") {
            return Err("a pointer of Git LFS, not the file: run `git lfs pull`".to_owned());
        }
        self.total += bytes.len() as u64;
        self.read.push(path.to_owned());
        Ok(bytes)
    }

    /// The same of a text, in UTF-8.
    pub(crate) fn utf8(&mut self, path: &Path) -> Result<Vec<u8>, String> {
        text::utf8(self.bytes(path)?)
    }

    /// The same of a file that another one names. If it is gone, the reason says what to do.
    pub(crate) fn utf8_or(&mut self, path: &Path, gone: &str) -> Result<Vec<u8>, String> {
        self.utf8(path).map_err(|why| if path.exists() { why } else { format!("{why}: {gone}") })
    }

    /// The path of a file that another file in this folder names. Some systems write `\\` between
    /// folders, and do not distinguish case. A file is taken for it if it is the only one.
    pub(crate) fn named(&mut self, folder: &Path, name: &str) -> PathBuf {
        let exact = folder.join(name);
        if exact.exists() {
            return exact;
        }
        let slashes = name.replace('\\', "/");
        let Some(found) = alike(folder, Path::new(&slashes)) else { return exact };
        let note = format!("the file '{name}' is read from {}", found.display());
        if found != folder.join(&slashes) && !self.notes.contains(&note) {
            self.notes.push(note);
        }
        found
    }

    fn too_large(&self) -> String {
        if self.total == 0 {
            format!("larger than {} MiB", MAX_BYTES >> 20)
        } else {
            format!("the files of the level are larger than {} MiB together", MAX_TOTAL >> 20)
        }
    }
}

/// The only file whose name is this one, in any case.
fn alike(folder: &Path, name: &Path) -> Option<PathBuf> {
    let mut path = folder.to_owned();
    for part in name.components() {
        let next = path.join(part);
        if next.exists() || !matches!(part, Component::Normal(_)) {
            path = next;
            continue;
        }
        let wanted = part.as_os_str().to_str()?.to_lowercase();
        let folder = if path.as_os_str().is_empty() { Path::new(".") } else { &path };
        let names = fs::read_dir(folder).ok()?.filter_map(|entry| entry.ok()?.file_name().into_string().ok());
        let mut like = names.filter(|known| known.to_lowercase() == wanted);
        let only = like.next()?;
        if like.next().is_some() {
            return None;
        }
        path.push(only);
    }
    Some(path)
}
