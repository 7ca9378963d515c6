//! Times that stray: the machine was busy with something else.

use crate::record::Row;

/// How far the ns per instruction of one class may be from those of the same answer in the other
/// classes. Mispredicted branches explain less.
const FAR: f64 = 3.0;

/// Removes the times that stray from the median of the same answer's times.
pub fn remove(rows: &mut [Row]) {
    let pace = |r: &Row| Some(r.get("ns")? / r.get("host")?);
    let strays: Vec<bool> = rows
        .iter()
        .map(|row| {
            let same =
                |r: &&Row| (r.workload(), r.backend(), r.asked()) == (row.workload(), row.backend(), row.asked());
            let mut paces: Vec<f64> = rows.iter().filter(same).filter_map(pace).collect();
            paces.sort_by(f64::total_cmp);
            let Some((own, &middle)) = pace(row).zip(paces.get(paces.len() / 2)) else { return false };
            own > middle * FAR || own * FAR < middle
        })
        .collect();
    for (row, _) in rows.iter_mut().zip(strays).filter(|(_, strays)| *strays) {
        row.remove("ns");
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_time_far_from_those_of_other_classes_goes() {
        let mut rows = [("a", 30.0), ("b", 40.0), ("c", 400.0)].map(|(class, ns)| {
            let mut row = Row::new("w", class, "tilesat", "ray");
            row.set("host", 100.0).set("ns", ns);
            row
        });
        remove(&mut rows);
        assert_eq!(rows.map(|r| r.get("ns")), [Some(30.0), Some(40.0), None]);
    }
}
