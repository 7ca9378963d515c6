//! Files in JSON.

use serde::Deserialize;

/// Whether a file contains JSON. Everything else is XML.
pub(in crate::read) fn is_json(bytes: &[u8]) -> bool {
    bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes).trim_ascii_start().starts_with(b"{")
}

/// Its members, by name.
pub(in crate::read) fn parse<'a, T: Deserialize<'a>>(bytes: &'a [u8]) -> Result<T, String> {
    serde_json::from_slice(bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes)).map_err(|e| e.to_string())
}

/// The names of its members, not of those within them. Damaged text has the names up to the damage.
pub(in crate::read) fn keys(bytes: &[u8]) -> Vec<&[u8]> {
    let (mut keys, mut depth, mut last) = (Vec::new(), 0usize, None);
    let mut rest = bytes.iter().enumerate();
    while let Some((at, byte)) = rest.next() {
        match byte {
            b'{' | b'[' => depth += 1,
            b'}' | b']' => depth = depth.saturating_sub(1),
            b'"' => {
                let mut escaped = false;
                let end = rest.find(|(_, byte)| match byte {
                    b'\\' => {
                        escaped = !escaped;
                        false
                    }
                    b'"' if !escaped => true,
                    _ => {
                        escaped = false;
                        false
                    }
                });
                let text = end.map(|(end, _)| &bytes[at + 1..end]);
                last = text.filter(|_| depth == 1);
            }
            b':' => keys.extend(last.take()),
            _ => {}
        }
    }
    keys
}
