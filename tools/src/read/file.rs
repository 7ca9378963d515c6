//! Files of a bearable size.

use std::fs::File;
use std::io::{Error, ErrorKind, Read, Result};
use std::path::Path;

const MAX_BYTES: u64 = 64 << 20;

/// All bytes of a file; [`ErrorKind::InvalidData`] where there are too many.
pub(crate) fn bytes(path: &Path) -> Result<Vec<u8>> {
    let mut bytes = Vec::new();
    File::open(path)?.take(MAX_BYTES + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > MAX_BYTES {
        return Err(Error::new(ErrorKind::InvalidData, format!("larger than {} MiB", MAX_BYTES >> 20)));
    }
    Ok(bytes)
}

/// What an error of [`bytes`] is to the user.
pub(crate) fn why(error: &Error) -> String {
    if error.kind() == ErrorKind::InvalidData { error.to_string() } else { format!("cannot read: {error}") }
}
