//! Writes files together: all of them or none, and never over an input.

use std::fs;
use std::path::{Path, PathBuf};

use crate::fail::{Fail, Result};

/// Files to write.
#[derive(Debug, Default)]
pub struct Outputs {
    files: Vec<(PathBuf, Vec<u8>)>,
}

impl Outputs {
    /// Checks before the work whether a file can be written.
    ///
    /// # Errors
    ///
    /// As [`write`](Self::write), as far as it can tell beforehand.
    pub fn check(path: &Path, inputs: &[PathBuf]) -> Result<()> {
        not_read(path, &place(path)?, inputs)
    }

    /// Adds a file.
    pub fn add(&mut self, path: PathBuf, bytes: Vec<u8>) {
        self.files.push((path, bytes));
    }

    /// Writes all files beside their paths first, then moves them there. Returns the paths.
    ///
    /// # Errors
    ///
    /// If a file cannot be written, is not a regular file, is written twice, or is one of the
    /// inputs. Then nothing has changed.
    pub fn write(&self, inputs: &[PathBuf]) -> Result<Vec<PathBuf>> {
        let places = self.files.iter().map(|(path, _)| place(path)).collect::<Result<Vec<_>>>()?;
        for (i, place) in places.iter().enumerate() {
            if places[..i].contains(place) {
                return Err(Fail::new(format!(
                    "cannot write {}: it would be written twice",
                    self.files[i].0.display()
                )));
            }
            not_read(&self.files[i].0, place, inputs)?;
        }
        let mut moves = Moves::default();
        for ((path, bytes), place) in self.files.iter().zip(&places) {
            moves.prepare(place, bytes).map_err(|e| cannot(path, &e))?;
        }
        moves.finish().map_err(|(at, e)| cannot(&self.files[at].0, &e))?;
        Ok(self.files.iter().map(|(path, _)| path.clone()).collect())
    }
}

fn not_read(path: &Path, place: &Path, inputs: &[PathBuf]) -> Result<()> {
    if inputs.iter().any(|input| is_same(input, place)) {
        return Err(Fail::new(format!("cannot write {}: it is an input of the level", path.display())));
    }
    Ok(())
}

fn cannot(path: &Path, error: &std::io::Error) -> Fail {
    Fail::new(format!("cannot write {}: {error}", path.display()))
}

/// The most links from one to the next, as of Linux.
const MAX_LINKS: usize = 40;

/// The real path of a file. A link stays a link, also one to a file that does not exist yet.
fn place(path: &Path) -> Result<PathBuf> {
    let mut real = path.to_owned();
    for _ in 0..MAX_LINKS {
        match fs::metadata(&real) {
            Ok(known) if known.is_file() => return fs::canonicalize(&real).map_err(|e| cannot(path, &e)),
            Ok(_) => return Err(Fail::new(format!("cannot write {}: it exists and is not a file", path.display()))),
            Err(_) => {}
        }
        let name = real
            .file_name()
            .ok_or_else(|| Fail::new(format!("cannot write {}: it has no file name", path.display())))?;
        let folder = real.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
        let beside = fs::canonicalize(folder).map_err(|e| cannot(path, &e))?;
        match fs::read_link(&real) {
            Ok(target) => real = beside.join(target),
            Err(_) => return Ok(beside.join(name)),
        }
    }
    Err(Fail::new(format!("cannot write {}: it is a link that leads nowhere; remove it", path.display())))
}

/// Whether two paths lead to one file, even under different names.
fn is_same(input: &Path, output: &Path) -> bool {
    #[cfg(unix)]
    {
        use std::os::unix::fs::MetadataExt;
        if let (Ok(a), Ok(b)) = (fs::metadata(input), fs::metadata(output)) {
            return (a.dev(), a.ino()) == (b.dev(), b.ino());
        }
    }
    fs::canonicalize(input).is_ok_and(|input| input == output)
}

/// Files beside their paths.
#[derive(Default)]
struct Moves {
    /// The new file, its path, and the previous file, moved aside.
    files: Vec<(PathBuf, PathBuf, PathBuf)>,
}

impl Moves {
    fn prepare(&mut self, place: &Path, bytes: &[u8]) -> std::io::Result<()> {
        let name = place.file_name().unwrap_or_default().to_string_lossy();
        let beside = |what: &str| place.with_file_name(format!(".{name}.{}.{what}", std::process::id()));
        let (new, old) = (beside("new"), beside("old"));
        self.files.push((new.clone(), place.to_owned(), old));
        fs::write(&new, bytes)?;
        // A file that others may not read stays so.
        match fs::metadata(place) {
            Ok(before) => fs::set_permissions(&new, before.permissions()),
            Err(_) => Ok(()),
        }
    }

    /// Moves all files to their paths, or restores all.
    fn finish(self) -> std::result::Result<(), (usize, std::io::Error)> {
        for (i, (new, place, old)) in self.files.iter().enumerate() {
            let aside = if place.exists() { fs::rename(place, old) } else { Ok(()) };
            if let Err(e) = aside.and_then(|()| fs::rename(new, place)) {
                for (_, place, old) in self.files[..=i].iter().rev() {
                    if old.exists() {
                        // A second failure leaves nothing better to do.
                        let _ = fs::rename(old, place);
                    } else if *place != self.files[i].1 {
                        let _ = fs::remove_file(place);
                    }
                }
                return Err((i, e));
            }
        }
        Ok(())
    }
}

impl Drop for Moves {
    /// Removes a file that is still beside its path.
    fn drop(&mut self) {
        for (new, _, old) in &self.files {
            let _ = fs::remove_file(new);
            let _ = fs::remove_file(old);
        }
    }
}
