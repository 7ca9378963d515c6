//! Finds a `memory.x` for the linker and tells the firmware which core it is built for.

fn main() {
    let own = env!("CARGO_MANIFEST_DIR");
    // The repository's serves all boards. Thousands of bodies do not fit the smallest of them.
    for (bin, folder) in [
        ("tilesat-counts", format!("{own}/../../..")),
        ("solids", format!("{own}/../../..")),
        ("scene", format!("{own}/../../..")),
        ("broad", format!("{own}/mps2")),
    ] {
        println!("cargo:rustc-link-arg-bin={bin}=-L{folder}");
        println!("cargo:rerun-if-changed={folder}/memory.x");
    }
    let target = std::env::var("TARGET").unwrap_or_default();
    let core = if target.starts_with("thumbv6m") { "M0" } else { "M3" };
    println!("cargo:rustc-env=CORE={core}");
}
