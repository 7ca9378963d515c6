//! Tells the linker which programs need a whole board: see `memory.x`. Boxes are built beside their
//! final position, maps have 10 000 segments, and moves link all movers.
//!
//! The core with an FPU has `large` scenes, which the smallest board cannot hold.

fn main() {
    println!("cargo:rustc-link-arg-bin=broad=--defsym=_whole_board=1");
    println!("cargo:rustc-link-arg-bin=chains=--defsym=_whole_board=1");
    println!("cargo:rustc-link-arg-bin=moves=--defsym=_whole_board=1");
    println!("cargo:rustc-check-cfg=cfg(large)");
    if std::env::var("TARGET").is_ok_and(|target| target.starts_with("thumbv7em")) {
        println!("cargo:rustc-cfg=large");
    }
    println!("cargo:rerun-if-changed=build.rs");
    println!("cargo:rerun-if-env-changed=PRECISION_INPUTS");
}
