//! Finds a `memory.x` for the linker: the repository's serves all boards. Boxes are built beside where they are held: they get a whole board.
//!
//! The core with an FPU has `large` scenes, which the smallest board cannot hold.

fn main() {
    let root = concat!(env!("CARGO_MANIFEST_DIR"), "/../../../..");
    let whole_board = concat!(env!("CARGO_MANIFEST_DIR"), "/../../../target/counts/mps2");
    for (bin, folder) in [("pairs", root), ("rays", root), ("casts", root), ("moves", root), ("broad", whole_board)] {
        println!("cargo:rustc-link-arg-bin={bin}=-L{folder}");
        println!("cargo:rerun-if-changed={folder}/memory.x");
    }
    println!("cargo:rustc-check-cfg=cfg(large)");
    if std::env::var("TARGET").is_ok_and(|target| target.starts_with("thumbv7em")) {
        println!("cargo:rustc-cfg=large");
    }
    println!("cargo:rerun-if-env-changed=PRECISION_INPUTS");
}
