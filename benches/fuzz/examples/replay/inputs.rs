//! The committed inputs: one file per target, one input per line.

use std::fs;
use std::path::Path;

/// An input, and its file and line.
pub struct Input {
    pub bytes: Vec<u8>,
    pub place: String,
}

/// The inputs of a target in a folder of such files. Empty if it has no file.
///
/// # Panics
///
/// If a line is neither `-` nor pairs of hexadecimal digits, followed by a name.
pub fn inputs(folder: &Path, target: &str) -> Vec<Input> {
    let path = folder.join(target).with_extension("hex");
    let text = fs::read_to_string(&path).unwrap_or_default();
    let read = |(i, line): (usize, &str)| {
        let place = format!("{}:{}", path.display(), i + 1);
        let bytes = bytes(line.split(' ').next().unwrap_or_default());
        Input { bytes: bytes.unwrap_or_else(|| panic!("{place}: not an input in hexadecimal digits")), place }
    };
    text.lines().enumerate().map(read).collect()
}

fn bytes(word: &str) -> Option<Vec<u8>> {
    match word {
        "" => None,
        "-" => Some(Vec::new()),
        _ => word.as_bytes().chunks(2).map(byte).collect(),
    }
}

fn byte(pair: &[u8]) -> Option<u8> {
    let digit = |at: usize| (*pair.get(at)? as char).to_digit(16);
    Some((digit(0)? << 4 | digit(1)?) as u8)
}
