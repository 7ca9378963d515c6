//! Text in the encodings that editors and programs write.

/// The characters of windows-1252 from 0x80 on, up to 0x9f. The others are those of Latin-1. A byte
/// without a character keeps its number.
const HIGH: [char; 32] = [
    '\u{20ac}', '\u{81}', '\u{201a}', '\u{192}', '\u{201e}', '\u{2026}', '\u{2020}', '\u{2021}', '\u{2c6}', '\u{2030}',
    '\u{160}', '\u{2039}', '\u{152}', '\u{8d}', '\u{17d}', '\u{8f}', '\u{90}', '\u{2018}', '\u{2019}', '\u{201c}',
    '\u{201d}', '\u{2022}', '\u{2013}', '\u{2014}', '\u{2dc}', '\u{2122}', '\u{161}', '\u{203a}', '\u{153}', '\u{9d}',
    '\u{17e}', '\u{178}',
];

/// The bytes of a file in UTF-8. Converts UTF-16, and XML that names a western encoding of one
/// byte. All other bytes stay as they are.
pub(super) fn utf8(bytes: Vec<u8>) -> Result<Vec<u8>, String> {
    if bytes.starts_with(b"\xff\xfe\0\0") || bytes.starts_with(b"\0\0\xfe\xff") {
        return Err("text in UTF-32: save it as UTF-8".to_owned());
    }
    // XML and JSON begin with a sign of ASCII, which shows the order without a mark.
    match bytes[..] {
        [b'<' | b'{', 0, ..] => return utf16(&bytes, u16::from_le_bytes),
        [0, b'<' | b'{', ..] => return utf16(&bytes, u16::from_be_bytes),
        _ => {}
    }
    if let Some(pairs) = bytes.strip_prefix(b"\xff\xfe") {
        return utf16(pairs, u16::from_le_bytes);
    }
    if let Some(pairs) = bytes.strip_prefix(b"\xfe\xff") {
        return utf16(pairs, u16::from_be_bytes);
    }
    // Many a file names another encoding than it has.
    if is_western(&bytes) && std::str::from_utf8(&bytes).is_err() {
        return Ok(bytes.iter().map(|&byte| western(byte)).collect::<String>().into_bytes());
    }
    Ok(bytes)
}

/// The bytes of a text behind its byte order mark, which UTF-8 may have.
pub(super) fn unmarked(bytes: &[u8]) -> &[u8] {
    bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes)
}

fn utf16(bytes: &[u8], unit: fn([u8; 2]) -> u16) -> Result<Vec<u8>, String> {
    let damaged = || "damaged text in UTF-16: save it as UTF-8".to_owned();
    let pairs = bytes.chunks_exact(2);
    if !pairs.remainder().is_empty() {
        return Err(damaged());
    }
    let units = pairs.map(|pair| unit([pair[0], pair[1]]));
    let text: String = char::decode_utf16(units).collect::<Result<_, _>>().map_err(|_| damaged())?;
    Ok(text.into_bytes())
}

fn western(byte: u8) -> char {
    match byte {
        0x80..=0x9f => HIGH[usize::from(byte - 0x80)],
        _ => char::from(byte),
    }
}

/// Whether a declaration of XML names Latin-1 or windows-1252.
fn is_western(bytes: &[u8]) -> bool {
    let Some(rest) = bytes.strip_prefix(b"<?xml") else { return false };
    let end = rest.iter().position(|&byte| byte == b'>').unwrap_or(rest.len());
    let declared = String::from_utf8_lossy(&rest[..end]).to_ascii_lowercase();
    let Some((_, name)) = declared.split_once("encoding") else { return false };
    let name = name.trim_start().trim_start_matches('=').trim_start().trim_start_matches(['"', '\'']);
    ["iso-8859-1", "iso8859-1", "latin1", "latin-1", "windows-1252", "cp1252"]
        .iter()
        .any(|known| name.strip_prefix(known).is_some_and(|rest| rest.starts_with(['"', '\''])))
}
