//! The microcontrollers' part: their inputs, their output, and its tables.

mod file;
mod frames;
mod inputs;
mod table;

use crate::record::Row;
pub use inputs::write;
pub use table::page;

/// The rows of a microcontroller's output: keys, then the means of all, of hits and of misses.
///
/// # Errors
/// The line that is not a row.
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
            let (key, values) = fields.split_at(fields.len().saturating_sub(columns.len()));
            let mut row = match *key {
                // Bytes belong to a function. The tables repeat them for each class of the
                // function.
                [workload, backend, asked] if sizes => Row::new(workload, "", backend, asked),
                [workload, class, backend, asked] => Row::new(workload, class, backend, asked),
                _ => return Err(wrong()),
            };
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
        let boxes = &counts("flash_m4f", "move: level|box|b|move|90").unwrap()[0];
        assert_eq!((boxes.class(), boxes.get("flash_m4f")), ("box", Some(90.0)));
        assert!(counts("m0", "circle-circle|near|b|overlaps|12.5").is_err());
        assert!(counts("m0", "circle-circle|b|overlaps|12.5|13.0|").is_err());
        assert!(counts("flash_m0", "b|overlaps|90").is_err());
    }
}
