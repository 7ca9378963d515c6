//! Finds the repository's `memory.x` for the linker and tells the firmware which core it is built for.

fn main() {
    let root = concat!(env!("CARGO_MANIFEST_DIR"), "/../../..");
    println!("cargo:rustc-link-search={root}");
    println!("cargo:rerun-if-changed={root}/memory.x");
    let target = std::env::var("TARGET").unwrap_or_default();
    let core = if target.starts_with("thumbv6m") { "M0" } else { "M3" };
    println!("cargo:rustc-env=CORE={core}");
}
