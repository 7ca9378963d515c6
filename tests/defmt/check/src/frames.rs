//! The frames as text.

use defmt_decoder::{DecodeError, Table};
use std::error::Error;

/// One frame.
pub(crate) struct Line {
    /// The path of the type, without its parameters.
    pub(crate) path: String,
    pub(crate) value: String,
}

/// All frames in order.
pub(crate) fn decode(elf: &[u8], frames: &[u8]) -> Result<Vec<Line>, Box<dyn Error>> {
    let table = Table::parse(elf)?.ok_or("the program has no table of defmt's strings")?;
    let mut decoder = table.new_stream_decoder();
    decoder.received(frames);
    let mut lines = Vec::new();
    loop {
        match decoder.decode() {
            Ok(frame) => lines.push(line(&frame.display_message().to_string())?),
            Err(DecodeError::UnexpectedEof) => return Ok(lines),
            Err(DecodeError::Malformed) => {
                let text = String::from_utf8_lossy(frames);
                return Err(format!("a frame after the {}th is broken; as text: {text}", lines.len()).into());
            }
        }
    }
}

fn line(message: &str) -> Result<Line, String> {
    let (name, value) = message.split_once(" = ").ok_or_else(|| format!("no type in {message}"))?;
    let path = name.split('<').next().unwrap_or(name);
    Ok(Line { path: path.to_owned(), value: value.to_owned() })
}
