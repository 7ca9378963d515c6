//! Tells the linker where to find the layout of the console's memory.

use std::env;

fn main() {
    println!("cargo::rerun-if-changed=link.x");
    println!("cargo::rerun-if-changed=hot");
    let here = env::var("CARGO_MANIFEST_DIR").unwrap_or_default();
    let thumb = env::var("TARGET").unwrap_or_default().starts_with("thumb");
    println!("cargo::rustc-link-search={here}");
    println!("cargo::rustc-link-search={here}/hot/{}", if thumb { "thumb" } else { "arm" });
}
