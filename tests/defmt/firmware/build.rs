//! Finds the repository's `memory.x` for the linker, and asks for the layout of defmt's strings.

fn main() {
    let root = concat!(env!("CARGO_MANIFEST_DIR"), "/../../..");
    println!("cargo:rustc-link-arg-bins=-L{root}");
    println!("cargo:rustc-link-arg-bins=-Tdefmt.x");
    println!("cargo:rerun-if-changed={root}/memory.x");
}
