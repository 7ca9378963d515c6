//! Finds the repository's `memory.x` for the linker, which serves all boards.

fn main() {
    let root = concat!(env!("CARGO_MANIFEST_DIR"), "/../../../..");
    println!("cargo:rustc-link-search={root}");
    println!("cargo:rerun-if-changed={root}/memory.x");
    println!("cargo:rerun-if-env-changed=PRECISION_INPUTS");
}
