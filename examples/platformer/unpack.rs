//! Unpacks the data of a tile layer, and no more of it than a layer of its size can hold.

use std::io::{Error, ErrorKind, Read, Result};

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use flate2::bufread::{GzDecoder, ZlibDecoder};

#[derive(Clone, Copy, PartialEq)]
pub enum Packing {
    None,
    Zlib,
    Gzip,
    Zstd,
}

/// Memory that a zstd stream may ask for: 2^24 bytes, what the largest layer that is read unpacks to.
const ZSTD_WINDOW: u32 = 24;

/// The bytes in base64 again, without the compression; `None` where there are more than `most`.
pub fn unpack(text: &[u8], packing: Packing, most: u64) -> Result<Option<String>> {
    let packed = STANDARD.decode(text.trim_ascii()).map_err(|e| Error::new(ErrorKind::InvalidData, e))?;
    let reader: Box<dyn Read> = match packing {
        Packing::None => Box::new(&packed[..]),
        Packing::Zlib => Box::new(ZlibDecoder::new(&packed[..])),
        Packing::Gzip => Box::new(GzDecoder::new(&packed[..])),
        Packing::Zstd => {
            let mut decoder = zstd::Decoder::with_buffer(&packed[..])?;
            decoder.window_log_max(ZSTD_WINDOW)?;
            Box::new(decoder)
        }
    };
    let mut bytes = Vec::new();
    reader.take(most.saturating_add(1)).read_to_end(&mut bytes)?;
    Ok((bytes.len() as u64 <= most).then(|| STANDARD.encode(bytes)))
}
