//! Passes the core to the firmware, and tells the linker which programs need a whole board: see
//! `memory.x`.

fn main() {
    let target = std::env::var("TARGET").unwrap_or_default();
    let core = match target.split('-').next() {
        Some("thumbv6m") => "M0",
        Some("thumbv7m") => "M3",
        Some("thumbv7em") => "M4F",
        Some("thumbv8m.main") => "M33",
        Some("riscv32imc") => "RV32",
        // The counts do not cover this core, so the crate is empty there.
        _ => return,
    };
    println!("cargo:rustc-env=CORE={core}");
    if core != "RV32" {
        println!("cargo:rustc-link-arg-bin=crowds=--defsym=_whole_board=1");
        // Its scene takes most of 16 KB, and a step of it more stack than the rest.
        println!("cargo:rustc-link-arg-bin=bodies=--defsym=_wide_ram=1");
        println!("cargo:rustc-link-arg-bin=memory=--defsym=_wide_ram=1");
    }
    println!("cargo:rerun-if-changed=build.rs");
}
