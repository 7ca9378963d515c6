//! Conformance vectors: files of inputs and exact answers. The exact judges write them, and this
//! reads them back. `tests/conformance/README.md` has the columns.
//!
//! ```text
//! cargo test --test properties conformance                     the files are what the judges make, and the library answers every row
//! TILESAT_WRITE=1 cargo test --test properties conformance     writes them again
//! ```

mod ask;
mod ask_levels;
mod casts;
mod convex;
mod levels;
mod pairs;
mod portable;
mod rays;
mod slides;
mod table;

use std::path::Path;
use table::Table;

fn folder() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/conformance"))
}

/// A file of this folder, unchanged.
fn stored(name: &str) -> Table {
    let path = folder().join(name);
    let text = std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    Table::parse(&text)
}

#[test]
fn files_are_what_the_judges_make() {
    let write = std::env::var_os("TILESAT_WRITE").is_some();
    let (levels, tile_rays, bodies) = levels::make();
    let all = [
        ("pairs.csv", pairs::make()),
        ("closest.csv", pairs::closest()),
        ("casts.csv", casts::make()),
        ("rays.csv", rays::make()),
        ("convex_pairs.csv", convex::at_rest()),
        ("convex_casts.csv", convex::moving()),
        ("levels.csv", levels),
        ("tile_rays.csv", tile_rays),
        ("tile_bodies.csv", bodies),
        ("slides.csv", slides::make()),
    ];
    let mut size = 0;
    for (name, table) in &all {
        let text = table.text();
        size += text.len();
        println!("{name}: {} rows, {} bytes", table.rows.len(), text.len());
        if write {
            std::fs::write(folder().join(name), &text).unwrap();
        }
        let there = std::fs::read_to_string(folder().join(name)).unwrap_or_default();
        assert!(there == text, "{name} is not what is made; TILESAT_WRITE=1 writes it anew");
    }
    assert!(size < 1_500_000, "{size} bytes");
}
