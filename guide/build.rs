//! Prepares the chapters. Rustdoc copies no files, so each picture becomes a part of its page. On a
//! repository's page the link shows the file. The test that draws the first game needs its program.

use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::{env, fs, io};

fn main() -> io::Result<()> {
    let folder = |name| env::var_os(name).map(PathBuf::from).ok_or(io::ErrorKind::NotFound);
    let (guide, out) = (folder("CARGO_MANIFEST_DIR")?, folder("OUT_DIR")?);
    println!("cargo:rerun-if-changed={}", guide.display());
    for entry in fs::read_dir(&guide)? {
        let path = entry?.path();
        let Some(name) = path.file_name().filter(|_| path.extension().is_some_and(|end| end == "md")) else { continue };
        let page = fs::read_to_string(&path)?;
        fs::write(out.join(name), with_pictures(&guide, &page))?;
        if name == "first_platformer.md" {
            let program = page.split("```").nth(1).and_then(|block| block.strip_prefix("rust\n"));
            fs::write(out.join("first_platformer.rs"), program.ok_or(io::ErrorKind::InvalidData)?)?;
        }
    }
    Ok(())
}

/// The page with addresses that hold the pictures. A missing picture keeps its link: its test draws
/// it.
fn with_pictures(guide: &Path, page: &str) -> String {
    let mut parts = page.split("](pictures/");
    let mut all = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let (name, rest) = part.split_once(')').unwrap_or((part, ""));
        let link = match fs::read(guide.join("pictures").join(name)) {
            Ok(picture) => address(&picture),
            Err(_) => format!("pictures/{name}"),
        };
        let _ = write!(all, "]({link}){rest}");
    }
    all
}

fn address(picture: &[u8]) -> String {
    let mut text = "data:image/svg+xml,".to_owned();
    for &byte in picture {
        if byte.is_ascii_alphanumeric() || b"-._~,/:=;".contains(&byte) {
            text.push(byte.into());
        } else {
            let _ = write!(text, "%{byte:02X}");
        }
    }
    text
}
