//! The command line.

pub struct Options {
    pub frames: u64,
    pub starts: usize,
    pub threads: usize,
    /// Parts of the names of the scenes and columns to run. Empty: all.
    pub scenes: Vec<String>,
    pub columns: Vec<String>,
}

const USAGE: &str = "\
usage: cargo run --profile unlinked -p tilesat-stability [--features rapier] -- [OPTION]...
  --frames N    frames of each run (bounces of the elastic rooms); default 100000
  --full        1000000 frames
  --starts N    at most N starts per scene; default all (16)
  --scene TEXT  only scenes whose name contains this (repeatable)
  --column TEXT only engines whose name contains this (repeatable)
  --threads N   default 2
  --list        the names";

/// The options, or the message to print instead.
pub fn parse(mut words: impl Iterator<Item = String>) -> Result<Option<Options>, String> {
    let mut options =
        Options { frames: 100_000, starts: usize::MAX, threads: 2, scenes: Vec::new(), columns: Vec::new() };
    while let Some(word) = words.next() {
        let mut value = || words.next().ok_or_else(|| format!("{word} needs a value\n{USAGE}"));
        let count =
            |text: String| text.parse::<u64>().ok().filter(|&n| n > 0).ok_or(format!("{text}: not a number above 0"));
        match word.as_str() {
            "--frames" => options.frames = count(value()?)?,
            "--full" => options.frames = 1_000_000,
            "--starts" => options.starts = count(value()?)? as usize,
            "--threads" => options.threads = count(value()?)? as usize,
            "--scene" => options.scenes.push(value()?),
            "--column" => options.columns.push(value()?),
            "--list" => return Ok(None),
            _ => return Err(USAGE.into()),
        }
    }
    Ok(Some(options))
}

/// Whether a name is among the chosen ones.
pub fn chosen(name: &str, parts: &[String]) -> bool {
    parts.is_empty() || parts.iter().any(|part| name.contains(part.as_str()))
}
