//! The microcontrollers' part: the inputs that they get, and what they print.

mod inputs;

use crate::record::Row;
pub use inputs::write;

/// The rows of what a microcontroller printed: keys, then the means of all, of hits and of misses.
///
/// # Errors
/// The line that is not one.
pub fn counts(core: &str, printed: &str) -> Result<Vec<Row>, String> {
    let columns: &[&str] = match core {
        "m0" => &["m0", "m0_hit", "m0_miss"],
        "m4f" => &["m4f", "m4f_hit", "m4f_miss"],
        "flash_m0" => &["flash_m0"],
        "flash_m4f" => &["flash_m4f"],
        _ => return Err(format!("no core is called {core}")),
    };
    let sizes = columns.len() == 1;
    printed
        .lines()
        .map(|line| {
            let wrong = || format!("not a count: {line}");
            let fields: Vec<&str> = line.split('|').collect();
            // Bytes are those of a function: they are noted at each class by who shows them.
            let (key, values) = fields.split_at_checked(if sizes { 3 } else { 4 }).ok_or_else(wrong)?;
            let mut row = match *key {
                [workload, backend, asked] => Row::new(workload, "", backend, asked),
                [workload, class, backend, asked] => Row::new(workload, class, backend, asked),
                _ => return Err(wrong()),
            };
            if values.len() != columns.len() {
                return Err(wrong());
            }
            for (column, value) in columns.iter().zip(values).filter(|(_, v)| !v.is_empty()) {
                row.set(column, value.parse().map_err(|_| wrong())?);
            }
            Ok(row)
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::counts;

    #[test]
    fn counts_are_read() {
        let rows = counts("m0", "circle-circle|near|b|overlaps|12.5|13.0|\n").unwrap();
        assert_eq!((rows[0].get("m0"), rows[0].get("m0_hit"), rows[0].get("m0_miss")), (Some(12.5), Some(13.0), None));
        assert_eq!(counts("flash_m0", "circle-circle|b|overlaps|90").unwrap()[0].get("flash_m0"), Some(90.0));
        assert!(counts("m0", "circle-circle|near|b|overlaps|12.5").is_err());
    }
}
