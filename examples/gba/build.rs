//! Tells the linker where to find the layout of the console's memory.

use std::env;

fn main() {
    println!("cargo::rerun-if-changed=link.x");
    println!("cargo::rustc-link-search={}", env::var("CARGO_MANIFEST_DIR").unwrap_or_default());
}
