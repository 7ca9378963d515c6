//! Unpacks the data of a tile layer, up to the size of the layer.

use std::io::{Error, ErrorKind, Read, Result};

use base64::alphabet;
use base64::engine::DecodePaddingMode;
use base64::engine::general_purpose::{GeneralPurpose, GeneralPurposeConfig};
use base64::{DecodeError, Engine};
use flate2::bufread::{GzDecoder, ZlibDecoder};
use ruzstd::decoding::StreamingDecoder;

#[derive(Clone, Copy, PartialEq)]
pub(super) enum Packing {
    None,
    /// Zlib or gzip.
    Deflate,
    Zstd,
}

/// Some programs leave the signs `=` at the end out.
const BASE64: GeneralPurpose = GeneralPurpose::new(
    &alphabet::STANDARD,
    GeneralPurposeConfig::new().with_decode_padding_mode(DecodePaddingMode::Indifferent),
);
/// The first bytes of a gzip stream.
const GZIP: &[u8] = b"\x1f\x8b";

/// Memory that a zstd stream may need: the size of the largest layer.
const ZSTD_WINDOW: u64 = 1 << 26;

/// The bytes in base64. `None` if there are more than `most`.
pub(super) fn unpack(text: &[u8], packing: Packing, most: u64) -> Result<Option<Vec<u8>>> {
    // Some programs wrap the text.
    let text: Vec<u8> = text.iter().copied().filter(|byte| !byte.is_ascii_whitespace()).collect();
    let packed = BASE64.decode(text).map_err(|why| match why {
        DecodeError::InvalidByte(at, byte) => {
            invalid(format!("'{}' at {at} is no sign of base64", byte.escape_ascii()))
        }
        _ => invalid("base64 ends within a byte"),
    })?;
    let limit = most.saturating_add(1);
    let mut bytes = Vec::new();
    match packing {
        Packing::None => packed.as_slice().take(limit).read_to_end(&mut bytes)?,
        // Tiled unpacks both, whichever name they have.
        Packing::Deflate if packed.starts_with(GZIP) => {
            GzDecoder::new(&packed[..]).take(limit).read_to_end(&mut bytes)?
        }
        Packing::Deflate => ZlibDecoder::new(&packed[..]).take(limit).read_to_end(&mut bytes)?,
        Packing::Zstd => zstd(&packed, limit, &mut bytes)?,
    };
    Ok((bytes.len() as u64 <= most).then_some(bytes))
}

/// Frame after frame, because a stream can hold several. Returns the number of bytes, or the limit.
fn zstd(mut packed: &[u8], limit: u64, bytes: &mut Vec<u8>) -> Result<usize> {
    while !packed.is_empty() && (bytes.len() as u64) < limit {
        let mut frame = StreamingDecoder::new_with_max_window_size(&mut packed, ZSTD_WINDOW).map_err(invalid)?;
        let room = limit - bytes.len() as u64;
        frame.by_ref().take(room).read_to_end(bytes)?;
        let decoder = frame.into_frame_decoder();
        // The decoder reads the checksum, but does not compare it.
        let (told, found) = (decoder.get_checksum_from_data(), decoder.get_calculated_checksum());
        if decoder.is_finished() && told.is_some() && told != found {
            return Err(invalid("the checksum of the zstd data is wrong"));
        }
    }
    Ok(bytes.len())
}

fn invalid(why: impl Into<Box<dyn std::error::Error + Send + Sync>>) -> Error {
    Error::new(ErrorKind::InvalidData, why)
}
