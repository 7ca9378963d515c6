//! Finds a `memory.x` for the linker and tells the firmware which core it is built for.

fn main() {
    let own = env!("CARGO_MANIFEST_DIR");
    let target = std::env::var("TARGET").unwrap_or_default();
    // The repository's serves all boards, and names RISC-V's in `.cargo`. Thousands of bodies do not fit the smallest of them.
    let shared = format!("{own}/../../..");
    let large = if target.starts_with("riscv") { shared.clone() } else { format!("{own}/mps2") };
    for (bin, folder) in [("pairs", &shared), ("levels", &shared), ("bodies", &shared), ("crowds", &large)] {
        println!("cargo:rustc-link-arg-bin={bin}=-L{folder}");
        println!("cargo:rerun-if-changed={folder}/memory.x");
    }
    let core = match target.split('-').next() {
        Some("thumbv6m") => "M0",
        Some("thumbv7m") => "M3",
        Some("thumbv7em") => "M4F",
        Some("thumbv8m.main") => "M33",
        Some("riscv32imc") => "RV32",
        _ => panic!("no core is known for {target}"),
    };
    println!("cargo:rustc-env=CORE={core}");
}
