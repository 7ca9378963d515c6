//! The numbers of a tile layer, in all forms that Tiled writes.

use super::raw::Data;
use super::unpack::{Packing, unpack};

/// The limit for all layers of a map together: 4096 x 4096.
pub(super) const MAX_CELLS: u64 = 1 << 24;

/// How a user chooses another encoding or compression. Saving alone keeps them.
const FORMAT: &str = "in Tiled, under Map > Map Properties, set Tile Layer Format to CSV, and save the map";

/// The number of tiles, and their form.
pub(super) struct Form<'a> {
    pub(super) width: u32,
    pub(super) height: u32,
    pub(super) encoding: Option<&'a str>,
    pub(super) compression: Option<&'a str>,
}

impl Form<'_> {
    fn cells(&self) -> u64 {
        u64::from(self.width) * u64::from(self.height)
    }
}

/// As many numbers as there are cells.
pub(super) fn gids(data: Data, form: &Form<'_>) -> Result<Vec<u32>, String> {
    let cells = form.cells();
    let gids = match data {
        Data::List(gids) => gids,
        Data::Text(text) => match form.encoding {
            Some("csv") => numbers(&text, form)?,
            // In old versions, JSON has no encoding for text in base64 without compression.
            Some("base64") | None => bytes(&text, form)?,
            Some(other) => return Err(format!("encoding '{other}' is unknown; there are csv and base64: {FORMAT}")),
        },
    };
    match (gids.len() as u64).cmp(&cells) {
        std::cmp::Ordering::Equal => Ok(gids),
        std::cmp::Ordering::Less => {
            let (count, width, height) = (gids.len(), form.width, form.height);
            Err(format!("{count} tiles, but {width}x{height} cells need {cells}: save the map again in Tiled"))
        }
        std::cmp::Ordering::Greater => Err(too_long(form)),
    }
}

fn too_long(form: &Form<'_>) -> String {
    format!("it has more tiles than its {}x{} cells: save the map again in Tiled", form.width, form.height)
}

fn packing(name: Option<&str>) -> Result<Packing, String> {
    match name {
        None | Some("") => Ok(Packing::None),
        Some("zlib" | "gzip") => Ok(Packing::Deflate),
        Some("zstd") => Ok(Packing::Zstd),
        Some(other) => {
            Err(format!("compression '{other}' is unknown; there are zlib, gzip and zstd, also none: {FORMAT}"))
        }
    }
}

fn numbers(text: &str, form: &Form<'_>) -> Result<Vec<u32>, String> {
    let mut gids = Vec::new();
    let text = text.trim().trim_end_matches(',');
    if text.is_empty() {
        return Ok(gids);
    }
    for number in text.split(',') {
        if gids.len() as u64 == form.cells() {
            return Err(too_long(form));
        }
        let number = number.trim();
        gids.push(number.parse().map_err(|_| {
            let width = form.width.max(1) as usize;
            let missing =
                if number.contains(char::is_whitespace) { "a comma is missing" } else { "save the map again in Tiled" };
            format!("'{number}' is not a tile, in column {}, row {}: {missing}", gids.len() % width, gids.len() / width)
        })?);
    }
    Ok(gids)
}

fn bytes(text: &str, form: &Form<'_>) -> Result<Vec<u32>, String> {
    let (packing, most) = (packing(form.compression)?, form.cells().saturating_mul(4));
    let bytes = unpack(text.as_bytes(), packing, most).map_err(|why| {
        let named =
            form.compression.filter(|name| !name.is_empty()).map_or(String::new(), |name| format!(" and {name}"));
        format!("cannot unpack what is called base64{named}: {why}: the file is damaged: take a copy that Tiled opens")
    })?;
    let bytes = bytes.ok_or_else(|| too_long(form))?;
    if bytes.len() % 4 != 0 {
        return Err("its bytes end within a tile: save the map again in Tiled".to_owned());
    }
    Ok(bytes.chunks_exact(4).map(|word| word.iter().rev().fold(0, |all, &byte| all << 8 | u32::from(byte))).collect())
}
