//! Without optimisation, some parts need more flash than the micro:bit has. The emulated board has
//! twice as much (.ci/qemu.sh).

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    let is = |name: &str, value: &str| std::env::var(name).is_ok_and(|found| found == value);
    if is("CARGO_CFG_TARGET_OS", "none") && is("OPT_LEVEL", "0") {
        println!("cargo:rustc-link-arg-bins=--defsym=_wide_flash=1");
    }
}
