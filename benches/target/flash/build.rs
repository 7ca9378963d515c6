//! Finds this folder's `link.x` for the linker: bare programs, without the start-up code that a
//! firmware has.

fn main() {
    println!("cargo:rustc-link-search={}", env!("CARGO_MANIFEST_DIR"));
    println!("cargo:rerun-if-changed=link.x");
}
