//! Finds this folder's `link.x` for the linker. The programs are bare, without the start-up code of
//! a firmware.

fn main() {
    println!("cargo:rustc-link-search={}", env!("CARGO_MANIFEST_DIR"));
    println!("cargo:rerun-if-changed=link.x");
}
