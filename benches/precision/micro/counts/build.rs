//! Tells the linker that boxes need a whole board, because they are built beside their final
//! position, and maps of 10 000 segments: see `memory.x`.
//!
//! The core with an FPU has `large` scenes, which the smallest board cannot hold.

fn main() {
    println!("cargo:rustc-link-arg-bin=broad=--defsym=_whole_board=1");
    println!("cargo:rustc-link-arg-bin=chains=--defsym=_whole_board=1");
    println!("cargo:rustc-check-cfg=cfg(large)");
    if std::env::var("TARGET").is_ok_and(|target| target.starts_with("thumbv7em")) {
        println!("cargo:rustc-cfg=large");
    }
    println!("cargo:rerun-if-changed=build.rs");
    println!("cargo:rerun-if-env-changed=PRECISION_INPUTS");
}
