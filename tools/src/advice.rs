//! Options in messages, as lines of `tilesat.toml`: a build script has no command line.

/// The options that are lists in the file.
const LISTS: [&str; 10] = [
    "solid-layer",
    "one-way-layer",
    "ignore-layer",
    "no-guess",
    "ignore-level",
    "solid",
    "one-way",
    "empty",
    "flag",
    "objects",
];
/// Those with one value.
const VALUES: [&str; 3] = ["layer", "scale", "weld"];

/// The message with lines of the file instead of options: `--flag Ice` is `flag = ["Ice"] in
/// tilesat.toml`.
pub(crate) fn in_file(message: &str) -> String {
    let (mut text, mut rest) = (String::new(), message);
    while let Some((before, after)) = rest.split_once("--") {
        let list = LISTS.iter().find(|name| begins(after, name));
        let Some(name) = list.or_else(|| VALUES.iter().find(|name| begins(after, name))) else {
            text.push_str(before);
            text.push_str("--");
            rest = after;
            continue;
        };
        match before.strip_suffix("add ") {
            Some(start) => text.extend([start, "write "]),
            None => text.push_str(before),
        }
        let (value, after) = value(&after[name.len()..]);
        let line = match value {
            Some(value) if list.is_some() => format!("{name} = [{value:?}] in tilesat.toml"),
            // A value that is a word of the sentence is none.
            Some(value) if value.starts_with(|c: char| c.is_ascii_digit()) => {
                format!("{name} = {value:?} in tilesat.toml")
            }
            Some(value) => format!("{name} in tilesat.toml {value}"),
            None => format!("{name} in tilesat.toml"),
        };
        text.push_str(&line);
        rest = after;
    }
    text + rest
}

fn begins(text: &str, name: &str) -> bool {
    text.strip_prefix(name).is_some_and(|rest| !rest.starts_with(|c: char| c.is_ascii_alphanumeric() || c == '-'))
}

/// The value after an option, and the rest of the message. A value without quotes ends with its
/// part of the sentence.
fn value(text: &str) -> (Option<&str>, &str) {
    let Some(inner) = text.strip_prefix(' ') else { return (None, text) };
    if let Some((value, rest)) = inner.strip_prefix('\'').and_then(|quoted| quoted.split_once('\'')) {
        return (Some(value), rest);
    }
    let ends = [", ", "; ", " or ", " makes ", ")"];
    let end = ends.iter().filter_map(|end| inner.find(end)).min().unwrap_or(inner.len());
    match &inner[..end] {
        "" => (None, text),
        value => (Some(value), &inner[end..]),
    }
}

#[cfg(test)]
mod tests {
    use super::in_file;

    #[test]
    fn lines_instead_of_options() {
        for (option, line) in [
            ("if so, add --flag Sollid", r#"if so, write flag = ["Sollid"] in tilesat.toml"#),
            ("--objects 'My L' confirms it", r#"objects = ["My L"] in tilesat.toml confirms it"#),
            ("--scale makes it smaller", "scale in tilesat.toml makes it smaller"),
            ("--scale 1/2 makes it fit", r#"scale = "1/2" in tilesat.toml makes it fit"#),
            (
                "add --solid A:2, --flag A:2 or --empty A:2",
                r#"write solid = ["A:2"] in tilesat.toml, flag = ["A:2"] in tilesat.toml or empty = ["A:2"] in tilesat.toml"#,
            ),
            ("use larger cells (--cell) -- or not", "use larger cells (--cell) -- or not"),
        ] {
            assert_eq!(in_file(option), line);
        }
    }
}
