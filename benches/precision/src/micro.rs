//! The microcontrollers' part: the inputs that they get, and what they print.

use crate::oracle::figure::{Figure, PAIRS};
use crate::oracle::measure::Measure;
use crate::pairs::{classes::Class, name};
use crate::record::Row;

/// As many as fit beside the code in 256 KiB of flash.
const CLASSES: [Class; 5] = [Class::Hits(50), Class::Boxes, Class::Near, Class::Far, Class::Domain];
const PAIRS_A_CLASS: usize = 64;

/// A number, and so many bytes of a name.
fn text(out: &mut Vec<u8>, text: &str) {
    out.extend((text.len() as i32).to_le_bytes());
    out.extend(text.as_bytes());
}

fn words(figure: &Figure) -> [i32; 4] {
    let four = match *figure {
        Figure::Circle { centre, radius } => [centre.0, centre.1, radius, 0],
        Figure::Aabb { min, max } => [min.0, min.1, max.0, max.1],
        Figure::Segment { a, b } => [a.0, a.1, b.0, b.1],
    };
    four.map(|v| v as i32)
}

/// Of each workload and class its names, the number of pairs, and of each pair eight words and whether it overlaps.
pub fn inputs() -> Vec<u8> {
    let mut out = Vec::new();
    for kinds in PAIRS {
        for class in CLASSES {
            let pairs = class.pairs(kinds, PAIRS_A_CLASS);
            text(&mut out, name(kinds));
            text(&mut out, class.name());
            out.extend((pairs.len() as i32).to_le_bytes());
            for (a, b) in &pairs {
                let overlap = i32::from(Measure::new(a, b).overlaps());
                for word in words(a).into_iter().chain(words(b)).chain([overlap]) {
                    out.extend(word.to_le_bytes());
                }
            }
        }
    }
    out
}

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
