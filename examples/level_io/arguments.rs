//! What the command lines of the level tools share.

use std::ffi::{OsStr, OsString};

use super::decimal::Decimal;
use super::fail::{Fail, Result};

/// The value after an option.
pub fn value(name: &str, next: Option<OsString>) -> Result<OsString> {
    let given = next.filter(|v| !v.as_encoded_bytes().starts_with(b"-") && !v.is_empty());
    given.ok_or_else(|| Fail::new(format!("{name} needs a value")))
}

pub fn once<T>(slot: &mut Option<T>, name: &str, value: T) -> Result<()> {
    match slot.replace(value) {
        None => Ok(()),
        Some(_) => Err(Fail::new(format!("{name} is given twice"))),
    }
}

pub fn text(value: &OsStr, name: &str) -> Result<String> {
    let text = value.to_str().ok_or_else(|| Fail::new(format!("{name} needs UTF-8 text")))?;
    Ok(text.to_owned())
}

/// `10x14` in raw.
pub fn sides(value: &OsStr, name: &str) -> Result<(i32, i32)> {
    let text = text(value, name)?;
    let (width, height) =
        text.split_once('x').ok_or_else(|| Fail::new(format!("{name} needs WIDTHxHEIGHT, such as 10x14")))?;
    Ok((length(OsStr::new(width), name)?, length(OsStr::new(height), name)?))
}

/// Raw, above 0 and inside the domain.
pub fn length(value: &OsStr, name: &str) -> Result<i32> {
    let shown = value.to_string_lossy();
    let raw = Decimal::parse(shown.as_bytes()).map(Decimal::raw).filter(|raw| (1..1 << 29).contains(raw));
    let raw = raw.and_then(|raw| i32::try_from(raw).ok());
    raw.ok_or_else(|| Fail::new(format!("{name} needs pixels above 0 and below 8192, got {shown}")))
}
