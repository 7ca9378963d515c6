//! The arguments that all subcommands share.

use std::ffi::OsString;

use lexopt::{Arg, Parser};

use crate::fail::{Fail, Result};
use crate::model::decimal::Decimal;

/// The next argument.
pub(crate) fn next(parser: &mut Parser) -> Result<Option<Arg<'_>>> {
    parser.next().map_err(|e| Fail::new(e.to_string()))
}

/// The error about an option that the subcommand does not have.
pub(crate) fn unknown(arg: &Arg<'_>) -> Fail {
    let shown = match arg {
        Arg::Short(letter) => format!("-{letter}"),
        Arg::Long(name) => format!("--{name}"),
        Arg::Value(value) => value.to_string_lossy().into_owned(),
    };
    Fail::new(format!("unknown argument {shown} (see --help)"))
}

/// The value after an option. Text that looks like an option is not a value: the user forgot it.
pub(crate) fn value(parser: &mut Parser, name: &str) -> Result<OsString> {
    any_value(parser, name, |v| !v.is_empty())
}

fn any_value(parser: &mut Parser, name: &str, fits: impl Fn(&OsString) -> bool) -> Result<OsString> {
    let is_option = |v: &OsString| matches!(v.as_encoded_bytes(), [b'-', next, ..] if !next.is_ascii_digit());
    let given = parser.value().ok().filter(|v| !is_option(v) && fits(v));
    given.ok_or_else(|| Fail::new(format!("{name} needs a value")))
}

fn utf8(value: OsString, name: &str) -> Result<String> {
    value.into_string().map_err(|_| Fail::new(format!("{name} needs UTF-8 text")))
}

/// Fills an empty slot.
pub(crate) fn once<T>(slot: &mut Option<T>, name: &str, value: T) -> Result<()> {
    match slot.replace(value) {
        None => Ok(()),
        Some(_) => Err(Fail::new(format!("{name} is given twice"))),
    }
}

/// A text value.
pub(crate) fn text(parser: &mut Parser, name: &str) -> Result<String> {
    utf8(value(parser, name)?, name)
}

/// The name of a layer, which may be empty.
pub(crate) fn layer(parser: &mut Parser, name: &str) -> Result<String> {
    utf8(any_value(parser, name, |_| true)?, name)
}

/// A path that is not an option's value.
pub(crate) fn path(value: OsString) -> Result<std::path::PathBuf> {
    if value.is_empty() {
        return Err(Fail::new("an empty argument where a level was expected"));
    }
    Ok(value.into())
}

/// A whole number.
pub(crate) fn number(parser: &mut Parser, name: &str) -> Result<u32> {
    let value = value(parser, name)?;
    let shown = value.to_string_lossy();
    shown.parse().map_err(|_| Fail::new(format!("{name} needs a whole number from 0 to {}, got {shown}", u32::MAX)))
}

/// Converts `10x14` to raw units.
pub(crate) fn sides(parser: &mut Parser, name: &str) -> Result<(i32, i32)> {
    let text = text(parser, name)?;
    let (width, height) =
        text.split_once('x').ok_or_else(|| Fail::new(format!("{name} needs WIDTHxHEIGHT, such as 10x14")))?;
    Ok((raw(width, name)?, raw(height, name)?))
}

/// Converts pixels to raw units.
pub(crate) fn length(parser: &mut Parser, name: &str) -> Result<i32> {
    raw(&value(parser, name)?.to_string_lossy(), name)
}

/// Raw units, above 0 and inside the domain.
fn raw(shown: &str, name: &str) -> Result<i32> {
    let raw = Decimal::parse(shown.as_bytes()).map(Decimal::raw).filter(|raw| (1..1 << 29).contains(raw));
    let raw = raw.and_then(|raw| i32::try_from(raw).ok());
    raw.ok_or_else(|| Fail::new(format!("{name} needs pixels above 0 and below 8192, got {shown}")))
}
